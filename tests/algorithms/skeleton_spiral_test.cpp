#include "algorithms/polygon/skeleton_spiral.hpp"

#include "algorithms/polygon/moving_rings.hpp"
#include "coverage_oracle.hpp"
#include "geometry/convex_hull.hpp"
#include "geometry/overlay/offset.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr int kSamples = 700;

double to_boundary(const Region& region, const Point& p) {
  double least = 1e300;
  for_each_edge(region, [&](const Point& a, const Point& b) { least = std::min(least, distance_to_segment(p, a, b)); });
  return least;
}

// By hand: 5 arcs, the inner nodes 2 m from the boundary.
TEST(StraightSkeleton, OfARectangle) {
  const StraightSkeleton skeleton = straight_skeleton(box_region({0, 0}, {10, 4}).polygons[0]);
  EXPECT_EQ(skeleton.nodes.size(), 6u);
  EXPECT_EQ(skeleton.arcs.size(), 5u);
  for (const StraightSkeleton::Node& n : skeleton.nodes) EXPECT_NEAR(n.time, n.time > 0 ? 2 : 0, 1e-12);
}

// Of a convex polygon it is the medial axis: the time of a node is its distance from the boundary.
TEST(StraightSkeleton, OfConvexPolygonsIsTheMedialAxis) {
  for (const auto seed : seeds(10)) {
    Rng rng(seed);
    std::vector<Point> points;
    for (int k = 0; k < 12; ++k) points.push_back({rng.between(0, 9), rng.between(0, 7)});
    const Region region{{{convex_hull(points), {}}}};
    for (const StraightSkeleton::Node& n : straight_skeleton(region.polygons[0]).nodes)
      EXPECT_NEAR(n.time, to_boundary(region, n.at), 1e-6) << seed;
  }
}

// The merge tree of the insets says the same as the insets themselves.
TEST(MovingRings, KnowWhenTheySplit) {
  for (const auto seed : seeds(10)) {
    const Region region = generate("polygon", {{"width", 9.0}, {"height", 8.0}}, seed).free;
    const MovingRings rings(straight_skeleton(region.polygons[0]));
    std::vector<MovingRing> now = rings.begin();
    for (double t = 0; !now.empty(); t += 0.05) {
      std::vector<MovingRing> next;
      for (const MovingRing& ring : now) {
        for (const double later : {0.01, 0.05, 0.3, 2.0})
          ASSERT_EQ(rings.single(ring, t, t + later), rings.advance(ring, t + later).size() == 1) << seed << ", " << t;
        for (MovingRing& child : rings.advance(ring, t + 0.05)) next.push_back(std::move(child));
      }
      now = std::move(next);
    }
  }
}

// Insets keep their distance, and rings of later times come from those of earlier ones, none twice.
TEST(MovingRings, AreInsets) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    const Region region = generate("polygon", {{"width", 9.0}, {"height", 8.0}}, seed).free;
    const MovingRings rings(straight_skeleton(region.polygons[0]));
    std::vector<MovingRing> now = rings.begin();
    ASSERT_EQ(now.size(), 1u);
    EXPECT_NEAR(length(rings.closed(now[0], 0)), perimeter(region), 1e-9);
    double last_area = area(region);
    for (double t = 0.1; !now.empty() && t < 9; t += 0.1) {
      std::vector<MovingRing> next;
      for (const MovingRing& ring : now)
        for (MovingRing& later : rings.advance(ring, t)) next.push_back(std::move(later));
      double sum = 0;
      for (const MovingRing& ring : next) {
        Polyline lap = rings.closed(ring, t);
        for (const Point& p : lap) ASSERT_GE(to_boundary(region, p), t - 1e-9);
        lap.pop_back();
        sum += signed_area(lap);
      }
      EXPECT_LT(sum, last_area);
      last_area = sum;
      now = std::move(next);
    }
    EXPECT_TRUE(now.empty());
  }
}

// By hand: the boundary and the first lap are closed, each further lap is as long as
// the mean of the squares before and after it, and the last one is closed again.
TEST(SkeletonSpiral, LapsOfASquare) {
  const Problem p(Map{"square", box_region({0, 0}, {12.4, 12.4}), "", ""}, disc(0.2, 0.4), Point(0.3, 0.3));
  double laps = 4 * 12, side = 12 - 2 * 0.4;
  for (laps += 4 * side; side > 0.8; side -= 0.8) laps += 4 * (side - 0.4);
  laps += 4 * side;
  for (const char* growth : {"length", "vertex"}) {
    const Path path = plan("skeleton-spiral", p, {{"growth", std::string(growth)}, {"repair", false}});
    EXPECT_NEAR(path.length(true), laps, 0.03 * laps) << growth;
  }
}

// Laps leave no strips between them, which repair would have to drive: only corners and the ridge.
TEST(SkeletonSpiral, LapsOfConvexPolygonsLeaveNoStrips) {
  const std::vector<Ring> shapes{{{0, 0}, {12, 0}, {12, 12}, {0, 12}},
                                 {{0, 0}, {20, 0}, {5, 14}},
                                 {{0, 0}, {9, -3}, {16, 2}, {15, 9}, {7, 13}, {1, 8}}};
  for (const Ring& shape : shapes) {
    const Problem p(Map{"convex", Region{{{shape, {}}}}, "", ""}, disc(0.2, 0.4), Point(7, 4));
    const double laps = plan("skeleton-spiral", p, {{"repair", false}}).length(true);
    EXPECT_LT(plan("skeleton-spiral", p, {}).length(true), 1.12 * laps) << shape.size() << " corners";
  }
}

// A hole of 24 corners that turn by 15 degrees: one vertex of the inset each, not two with a chord between them.
TEST(SkeletonSpiral, GentleCornersOfObstaclesTakeOneVertex) {
  Region region = box_region({0, 0}, {12, 12});
  Ring hole;
  for (int k = 0; k < 24; ++k) hole.push_back(Point(6, 6) + rotated(Point(2, 0), -k * kPi / 12 + 0.1));
  region.polygons[0].holes.push_back(hole);
  const Problem p(Map{"wheel", region, "", ""}, disc(0.2, 0.4), Point(0.5, 0.5));
  std::size_t arcs = 0;
  Context::Sinks sinks;
  sinks.trace = [&](const Trace& trace) { arcs += trace.name == "skeleton" ? trace.lines.size() : 0; };
  Context context(1, 1e9, std::move(sinks));
  const Path path = built_in_planner("skeleton-spiral")->plan(p, context);
  EXPECT_GT(arcs, 2 * 24u);
  EXPECT_LT(arcs, 3 * 24u);
  EXPECT_EQ(uncovered_share(p, path, 2000), 0);
}

TEST(SkeletonSpiral, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed))
      for (const char* growth : {"length", "vertex"}) {
        SCOPED_TRACE(p.map().source + " " + growth);
        const Path path = plan("skeleton-spiral", p, {{"growth", std::string(growth)}});
        expect_valid(p, path);
        EXPECT_LE(uncovered_share(p, path, kSamples), 2e-3);
      }
}

// Among like squares many events have the same time. Vertices moved apart by far less than the tool drive as much; none
// is moved where walls would cross.
TEST(SkeletonSpiral, StirredVerticesMoveLapsByAsLittle) {
  Region region = box_region({0, 0}, {12, 9});
  for (int k = 0; k < 12; ++k) {
    Ring hole =
        box_region({3.0 * (k % 4) + 1, 3.0 * (k / 4) + 1}, {3.0 * (k % 4) + 2, 3.0 * (k / 4) + 2}).polygons[0].outer;
    std::ranges::reverse(hole);
    region.polygons[0].holes.push_back(hole);
  }
  const Problem problem(Map{"squares", region, "", ""}, disc(0.1, 0.2), Point(0.5, 0.5));
  const Connector connector(problem);
  const Region inset = erode(region, 0.3, 0.02, Bound::inside);
  const auto metres = [&](double stirred) {
    Context context(1);
    double sum = 0;
    for (const Strip& strip :
         spiral_strips(inset, {.spacing = 0.2, .bridge = 2e-4, .stirred = stirred}, problem, connector, context))
      for (const LaneEnds& lane : strip.lanes) sum += length(lane.curve);
    return sum;
  };
  const double exact = metres(0);
  EXPECT_GT(exact, 100);
  EXPECT_NEAR(metres(2e-6), exact, 0.02 * exact);
  EXPECT_EQ(metres(4), exact);  // edges would cross: vertices stay
}

}  // namespace
}  // namespace oxturn
