#include "algorithms/lanes/outline.hpp"
#include "algorithms/polygon/island_cuts.hpp"
#include "algorithms/polygon/link_crossings.hpp"
#include "algorithms/polygon/smooth_curve.hpp"
#include "algorithms/polygon/wave_tree.hpp"
#include "base/random.hpp"
#include "coverage_oracle.hpp"
#include "geometry/coarse_arcs.hpp"
#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr int kSamples = 700;

WaveTree tree_of(const Region& region) {
  std::vector<WaveTree> trees = wave_trees(medial_axis(region, 0.01));
  EXPECT_EQ(trees.size(), 1u);
  trees[0].root_at_centre();
  return std::move(trees[0]);
}

// By hand, for a rectangle of a x b: from the middle along half the ridge and to a vertex.
TEST(WaveTree, HeightsAndLapsOfRectangles) {
  WaveTree tree = tree_of(box_region({0, 0}, {10, 4}));
  EXPECT_NEAR(tree.height(), 3 + 4 / std::sqrt(2), 1e-6);
  const std::size_t leaves = tree.arrivals(kRootAlone).size();
  EXPECT_EQ(tree.spiral(12, kRootAlone, {0, 0}).laps.size(), 12 * leaves);
  const WaveSpiral spiral = tree_of(box_region({0, 0}, {20, 3})).spiral(4, 1.5 * 1.5, {0, 0});
  EXPECT_NEAR(length(spiral.spine), 17 - 2 * (2.25 - 3 / std::sqrt(2)), 1e-6);  // the ridge but for its lower ends
  EXPECT_NEAR(length(spiral.boundary), 46, 1e-5);
}

// The same leaf is passed every lap, a lap's distance apart; the boundary goes on where the laps end.
TEST(WaveTree, LapsNeedNotBeWhole) {
  WaveTree tree = tree_of(box_region({0, 0}, {10, 10}));
  const std::size_t n = tree.arrivals(kRootAlone).size();
  const double laps = 2.5, each = tree.height() / laps;
  const WaveSpiral spiral = tree.spiral(laps, kRootAlone, {0, 0});
  ASSERT_EQ(spiral.laps.size(), static_cast<std::size_t>(std::ceil(laps * static_cast<double>(n))));
  for (std::size_t i = n; i < spiral.laps.size(); ++i)
    EXPECT_LE(distance(spiral.laps[i], spiral.laps[i - n]), each * (1 + 1e-9));
  EXPECT_EQ(spiral.boundary.front(), spiral.boundary.back());
  EXPECT_LE(distance(spiral.laps[spiral.laps.size() - n], spiral.boundary.front()), each * (1 + 1e-9));
  // Halfway to the boundary: a square half as large.
  EXPECT_NEAR(length(tree.closed_laps(2, kRootAlone, {0, 0}).laps), 20, 1e-6);
}

TEST(WaveTree, ReachesAllLeavesAtTimeOne) {
  for (const auto seed : seeds(10)) {
    const Region region = generate("polygon", {{"width", 9.0}, {"height", 8.0}}, seed).free;
    for (const double start : {0.8, 2.0, 1e300}) {
      WaveTree tree = tree_of(region);
      for (const double t : tree.arrivals(start)) EXPECT_NEAR(t, 1, 1e-9);
    }
  }
}

// The length of what would be built; where there are thousands of leaves, by samples.
TEST(WaveTree, MeasuresAreThoseOfTheSpiral) {
  const Region small = generate("polygon", {{"width", 9.0}, {"height", 8.0}}, 3).free;
  const Region large = bridged(generate("clutter", {{"width", 80.0}, {"height", 80.0}}, 1).free, 1e-3);
  for (const Region* region : {&small, &large}) {
    WaveTree tree = tree_of(*region);
    const bool sampled = tree.arrivals(kRootAlone).size() > 32768;
    EXPECT_EQ(sampled, region == &large);
    const double high = 1.2 * tree.greatest_clearance(), laps = 3.4;
    const WaveSpiral spiral = tree.spiral(laps, high, {4, 4});
    const WaveTree::Measures found = tree.spiral_measures(laps, high, {4, 4});
    EXPECT_NEAR(found.spine, length(spiral.spine), 1e-9 * found.spine);
    EXPECT_NEAR(found.laps, length(spiral.laps), (sampled ? 0.04 : 1e-3) * found.laps);
    EXPECT_NEAR(found.boundary, length(spiral.boundary), 1e-9 * found.boundary);
    EXPECT_NEAR(found.area, area(*region), 1e-3 * found.area);
    const double closed = length(tree.closed_laps(laps, high, {4, 4}).laps);
    EXPECT_NEAR(tree.closed_measures(laps, high, {4, 4}).laps, closed, 0.04 * closed + 2 * tree.height());
  }
}

/// Pairs of segments that cross, each end farther than `least` from the other segment.
int crossings_deeper_than(double depth, const Polyline& line) {
  int count = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point &a = line[i - 1], &b = line[i];
    const Box box{a.cwiseMin(b), a.cwiseMax(b)};
    for (std::size_t j = i + 2; j < line.size(); ++j) {
      const Point &c = line[j - 1], &d = line[j];
      if (!box.overlaps({c.cwiseMin(d), c.cwiseMax(d)})) continue;
      const bool cross_over =
          cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0;
      const double least = std::min({distance_to_segment(a, c, d), distance_to_segment(b, c, d),
                                     distance_to_segment(c, a, b), distance_to_segment(d, a, b)});
      count += cross_over && least > depth ? 1 : 0;
    }
  }
  return count;
}

// Rounded turns move the path by a 40th of the tool's width at most: laps nearer to each other than that may cross.
TEST(SmoothSpiral, DoesNotCrossItself) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    const Problem p(generate("polygon", {{"width", 9.0}, {"height", 8.0}}, seed), Robot{});
    const Path path = plan("smooth-spiral", p, {{"repair", false}, {"start", std::string("centre")}});
    Polyline all;
    for (const Leg& leg : path.legs)
      if (leg.tool) all.insert(all.end(), leg.points.begin(), leg.points.end());
    EXPECT_EQ(crossings_deeper_than(p.robot().tool_width / 40, all), 0);
  }
}

TEST(SmoothSpiral, CoversWithoutRepair) {
  for (const auto seed : seeds(3))
    for (const char* family : {"polygon", "clutter", "field"})
      for (const char* start : {"nested", "spine", "centre", "start"}) {
        SCOPED_TRACE(fmt::format("{} {} {}", family, seed, start));
        const Problem p(generate(family, {{"width", 9.0}, {"height", 8.0}}, seed), Robot{});
        const Path path = plan("smooth-spiral", p, {{"repair", false}, {"start", std::string(start)}});
        expect_valid(p, path);
        EXPECT_LE(uncovered_share(p, path, kSamples), 2e-3);
        std::size_t work = 0;
        for (const Leg& leg : path.legs) work += leg.tool ? 1 : 0;
        EXPECT_EQ(work, 1u);
      }
}

TEST(SmoothSpiral, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed))
      for (const char* direction : {"out", "in"}) {
        SCOPED_TRACE(p.map().source);
        const Path path = plan("smooth-spiral", p, {{"direction", std::string(direction)}});
        expect_valid(p, path);
        EXPECT_LE(uncovered_share(p, path, kSamples), 2e-3);
      }
}

// The other laps follow a boundary with fewer vertices.
TEST(SmoothSpiral, TheLastLapFollowsAllOfTheBoundary) {
  const Problem p(generate("clutter", {{"width", 54.0}, {"height", 54.0}}, 2), disc(0.2, 0.4));
  const Path path = plan("smooth-spiral", p, {{"repair", false}});
  const Region space = straightened_space(p);
  EXPECT_GT(vertex_count(space), 8192u);
  EXPECT_LT(vertex_count(with_coarser_arcs(space, 0.02 * 0.4)), 0.9 * static_cast<double>(vertex_count(space)));
  std::vector<Point> corners;
  for_each_ring(space, [&](const Ring& ring) { corners.insert(corners.end(), ring.begin(), ring.end()); });
  for (std::size_t c = 0; c < corners.size(); c += 397) {
    double off = 1e300;
    for (const Leg& leg : path.legs)
      for (std::size_t k = 1; k < leg.points.size(); ++k)
        off = std::min(off, distance_to_segment(corners[c], leg.points[k - 1], leg.points[k]));
    EXPECT_LT(off, 0.2 / 100) << to_text(corners[c]);  // vertices nearer to each other than that are dropped
  }
  const Score s = score(p, path);
  EXPECT_EQ(s.flaw, "");
  EXPECT_GT(*s.value("coverage_lower"), 0.9999);
}

// Needles, where one branch of the axis is many times as long as the others, and other convex shapes of few laps.
TEST(SmoothSpiral, LapsDoNotBunchOnConvexShapes) {
  Rng rng(4);
  for (int i = 0; i < 20; ++i) {
    const double a = rng.between(3.0, 12.0), b = a / rng.between(1.0, 6.0) + 1;
    const Region shape{{{{{0, 0}, {a, rng.between(0.0, 0.2)}, {rng.between(0.0, a), b}}, {}}}};
    SCOPED_TRACE(to_text(shape.polygons[0].outer[2]));
    const Problem p(Map{"needle", shape, "", ""}, Robot{});
    const Score s = score(p, plan("smooth-spiral", p));
    EXPECT_EQ(s.flaw, "");
    EXPECT_LT(*s.value("overlap"), 1.25);
    EXPECT_GT(*s.value("coverage"), 0.999);
  }
}

// From the middle to the boundary, so the last lap is driven at the end, or at the beginning.
TEST(SmoothSpiral, EndsOrBeginsWithTheBoundary) {
  const Problem p(Map{"room", box_region({0, 0}, {7, 5}), "", ""}, Robot{}, Point(2, 2));
  const double off = p.robot().radius * 1.001;
  const auto on_boundary = [&](const Point& q) {
    return q.x() <= off || q.y() <= off || q.x() >= 7 - off || q.y() >= 5 - off;
  };
  EXPECT_TRUE(on_boundary(plan("smooth-spiral", p).legs.back().points.back()));
  const Path in = plan("smooth-spiral", p, {{"direction", std::string("in")}});
  EXPECT_FALSE(on_boundary(in.legs.back().points.back()));
}

TEST(SmoothCurve, StaysWithinItsTolerances) {
  const Problem p(Map{"room", box_region({-9, -9}, {9, 9}), "", ""}, Robot{}, Point(0, 0));
  const Connector connector(p);
  Polyline wave;
  for (int k = 0; k <= 2000; ++k) wave.push_back({k * 0.006 - 6, std::sin(k * 0.02)});
  const Polyline fewer = with_fewer_vertices(wave, 0.01, connector);
  EXPECT_LT(fewer.size(), 150u);
  for (const Point& q : wave) {
    double far = 1e300;
    for (std::size_t i = 1; i < fewer.size(); ++i) far = std::min(far, distance_to_segment(q, fewer[i - 1], fewer[i]));
    ASSERT_LE(far, 0.0101);
  }
  // A right angle rounded within 0.1 m: radius 0.1 / (sqrt 2 - 1).
  const Polyline arc = rounded_corners({{0, 0}, {4, 0}, {4, 4}}, {.off = 0.1, .chord = 1e-4}, connector);
  const double r = 0.1 / (std::sqrt(2) - 1);
  EXPECT_NEAR(length(arc), 8 - 2 * r + kPi / 2 * r, 1e-3);
  EXPECT_EQ(arc.size(), 13u);  // 11 turns of at most 0.15 rad, and both ends
  EXPECT_EQ(without_collinear_vertices({{0, 0}, {1, 0}, {2, 0}, {2, 1}}), (Polyline{{0, 0}, {2, 0}, {2, 1}}));
}

TEST(SmoothCurve, HasNoMoreVerticesThanSmoothnessAsksFor) {
  const Problem p(Map{"room", box_region({-9, -9}, {9, 9}), "", ""}, Robot{}, Point(0, 0));
  const Connector connector(p);
  for (const double turn : {0.01, 0.1, 0.149, 0.2, 0.31, 0.8, 1.5, 2.5, 3.0}) {
    for (const double off : {1e-3, 0.01, 0.1}) {
      SCOPED_TRACE(testing::Message() << "turn " << turn << ", off " << off);
      const double chord = off / 20;
      const Polyline corner{{-2, 0}, {0, 0}, rotated({2, 0}, turn)};
      const Polyline round = rounded_corners(corner, {.off = off, .chord = chord}, connector);
      if (turn < 0.15) {
        EXPECT_EQ(round, corner);
        continue;
      }
      double sum = 0, most = 0, least = 4;
      for (std::size_t i = 1; i + 1 < round.size(); ++i) {
        const Point u = round[i] - round[i - 1], v = round[i + 1] - round[i];
        const double angle = std::atan2(cross(u, v), u.dot(v));
        sum += angle, most = std::max(most, angle), least = std::min(least, angle);
      }
      EXPECT_NEAR(sum, turn, 1e-9);
      EXPECT_LE(most, 0.3 + 1e-9);
      EXPECT_NEAR(least, most, 1e-9);
      double away = 4;
      for (std::size_t i = 1; i < round.size(); ++i)
        away = std::min(away, distance_to_segment({0, 0}, round[i - 1], round[i]));
      EXPECT_LE(away, off * (1 + 1e-9));
      // Where chords turn by more than 0.15 rad, the arc bulges beyond them by its radius times 1 - cos(half of that).
      const double radius = distance(round[1], round[2]) / (2 * std::sin(most / 2));
      if (round.size() > 3 && most > 0.15) { EXPECT_LE(radius * (1 - std::cos(most / 2)), chord * 1.01); }
      EXPECT_GE(most, std::min(turn, 0.15) / 2 - 1e-9);
    }
  }
}

}  // namespace
}  // namespace oxturn
