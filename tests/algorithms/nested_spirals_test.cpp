#include "algorithms/polygon/nested_spirals.hpp"

#include <gtest/gtest.h>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/polygon/island_cuts.hpp"
#include "base/random.hpp"
#include "coverage_oracle.hpp"
#include "geometry/edge_index.hpp"
#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 1e-4;

std::vector<WaveTree> trees_of(const Region& region) {
  std::vector<WaveTree> trees = wave_trees(medial_axis(region, kChord));
  for (WaveTree& tree : trees) tree.root_at_centre();
  return trees;
}

/// Two rooms of 6 x 6 and a corridor of 6 x 1 between them.
Region dumbbell() {
  return {
      {{{{0, 0}, {6, 0}, {6, 2.5}, {12, 2.5}, {12, 0}, {18, 0}, {18, 6}, {12, 6}, {12, 3.5}, {6, 3.5}, {6, 6}, {0, 6}},
        {}}}};
}

/// Without holes; of all kinds.
Region random_region(std::uint64_t seed) {
  static const std::vector<const char*> families{"polygon", "clutter", "cave", "rooms", "speckle"};
  const char* family = families[seed % families.size()];
  Settings sizes{{"width", 9.0 + static_cast<double>(seed % 7)}, {"height", 8.0 + static_cast<double>(seed % 7)}};
  if (family == std::string("rooms")) sizes["rooms"] = 3;
  const Problem p(generate(family, sizes, seed), disc(0.1 + 0.02 * static_cast<double>(seed % 4), 0.4));
  return bridged(straightened_space(p), 1e-4);
}

Polyline whole_curve(const WaveSpiral& s) {
  Polyline curve = s.spine;
  curve.insert(curve.end(), s.laps.begin(), s.laps.end());
  curve.insert(curve.end(), s.boundary.begin(), s.boundary.end());
  return curve;
}

double area_of(const Polyline& closed) { return std::abs(signed_area({closed.begin(), closed.end() - 1})); }

TEST(WideParts, AreTheRoomsOfADumbbell) {
  WaveTree tree = trees_of(dumbbell()).at(0);
  tree.start_at(1);
  const std::vector<WidePart> parts = tree.wide_parts(1);
  std::size_t wide = 0;  // the root may be a part of its own, in the corridor
  for (const WidePart& part : parts) {
    if (part.tree.greatest_clearance() == 0) continue;
    EXPECT_NEAR(part.tree.greatest_clearance(), 2, 0.01);
    ++wide;
  }
  EXPECT_EQ(wide, 2u);
}

// What the first lap encloses is in one of the parts, whose boundaries are the first lap.
TEST(WideParts, AreAllThatTheFirstLapEncloses) {
  std::size_t parts = 0;
  for (const auto seed : seeds(60)) {
    for (WaveTree& tree : trees_of(random_region(seed)))
      for (const double share : {0.1, 0.3, 0.6, 0.95}) {
        SCOPED_TRACE(testing::Message() << "seed " << seed << ", share " << share);
        const double height = share * tree.greatest_clearance();
        tree.start_at(height);
        const Polyline lap = tree.first_lap();
        double inside = 0;
        for (WidePart& part : tree.wide_parts(height)) {
          part.tree.start_at(kRootAlone);
          const Polyline boundary = part.tree.laps_at(0, 1, true, false).boundary;
          ASSERT_EQ(boundary.size(), part.leaf.size() + 1);
          inside += area_of(boundary);
          for (std::size_t k = 0; k < part.leaf.size(); ++k)
            if (part.leaf[k] != WidePart::kGate) { EXPECT_EQ(boundary[k], lap[part.leaf[k]]); }
          ++parts;
        }
        EXPECT_NEAR(inside, std::abs(signed_area({lap.begin(), lap.end()})), 1e-7);
      }
  }
  EXPECT_GT(parts, 500u);
}

TEST(WideParts, MeasuresAreThoseOfTheLaps) {
  for (const auto seed : seeds(20))
    for (WaveTree& tree : trees_of(random_region(seed))) {
      SCOPED_TRACE(seed);
      const double height = 0.5 * tree.greatest_clearance();
      const auto [of, inside] = tree.nested_measures(3, height);
      tree.start_at(height);
      Polyline lap = tree.first_lap();
      lap.push_back(lap.front());
      const WaveSpiral laps = tree.laps_at(0, 3, true, false);
      EXPECT_NEAR(of.spine, length(lap), 1e-9 * of.spine);
      EXPECT_NEAR(of.laps, length(laps.laps), 0.02 * of.laps + 3 * height);
      EXPECT_NEAR(of.boundary, length(laps.boundary), 1e-9 * of.boundary);
      EXPECT_NEAR(inside, area_of(lap), 0.1 * of.area);
    }
}

// The guarantee: no point is farther than half a step from the curve.
TEST(NestedSpirals, PassEveryPointWithinHalfAStep) {
  Rng rng(7);
  for (const auto seed : seeds(100)) {
    const Region region = random_region(seed);
    const double step = rng.between(0.15, 1.5);
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", step " << step);
    std::vector<Polyline> curves;
    std::vector<WaveTree> trees = trees_of(region);
    for (WaveTree& tree : trees) {
      const Point near(rng.between(0.0, 9.0), rng.between(0.0, 9.0));
      curves.push_back(whole_curve(nested_spirals(tree, {step / 0.95, step}, near)));
    }
    std::vector<std::pair<Point, Point>> segments;
    for (const Polyline& curve : curves)
      for (std::size_t k = 1; k < curve.size(); ++k) segments.emplace_back(curve[k - 1], curve[k]);
    const EdgeIndex edges(region);
    const Box box = bounding_box(region);
    for (int i = 0; i < 300; ++i) {
      const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      if (!edges.contains(p)) continue;
      double near = 1e300;
      for (const auto& [a, b] : segments) near = std::min(near, distance_to_segment(p, a, b));
      EXPECT_LE(near, step / 2 * (1 + 1e-6) + kChord) << to_text(p);
    }
  }
}

// One leaf after the other, from lap to lap: the curve never jumps out of the region.
TEST(NestedSpirals, StayInside) {
  for (const auto seed : seeds(30)) {
    const Region region = random_region(seed);
    const EdgeIndex edges(region);
    for (WaveTree& tree : trees_of(region)) {
      SCOPED_TRACE(seed);
      const Polyline curve = whole_curve(nested_spirals(tree, {0.4, 0.38}, {0, 0}));
      for (std::size_t k = 1; k < curve.size(); ++k) {
        const Point middle = (curve[k - 1] + curve[k]) / 2;
        EXPECT_TRUE(edges.contains(middle) || edges.nearest(middle)->distance < 1e-3) << to_text(middle);
      }
    }
  }
}

// A corridor between rooms needs two laps; one spiral drives as many there as the rooms need.
TEST(NestedSpirals, NarrowPartsHaveFewLaps) {
  const LapWidths widths{0.2, 0.19};
  const auto metres = [](const WaveSpiral& s) { return length(s.spine) + length(s.laps) + length(s.boundary); };
  const auto in_corridor = [](const WaveSpiral& s) {
    double sum = 0;
    for (const Polyline* line : {&s.spine, &s.laps, &s.boundary})
      for (std::size_t k = 1; k < line->size(); ++k) {
        const Point &a = (*line)[k - 1], &b = (*line)[k];
        sum += std::max(0.0, std::min(12.0, std::max(a.x(), b.x())) - std::max(6.0, std::min(a.x(), b.x())));
      }
    return sum / 6;
  };
  WaveTree tree = trees_of(dumbbell()).at(0), same = trees_of(dumbbell()).at(0);
  const WaveSpiral nested = nested_spirals(tree, widths, {0, 0}), one = spiral_from_spine(same, widths, {0, 0});
  EXPECT_LT(metres(nested), 0.8 * metres(one));
  EXPECT_LE(in_corridor(nested), 10.5);  // 1 m wide: 6 lanes 0.19 m apart, and the link to the other room
  EXPECT_GT(in_corridor(one), 20);
}

// By hand: a needle 20 m long, at its end narrower than the tool over 4 m, which the boundary's lap covers.
TEST(NestedSpirals, DoNotGoIntoNarrowDeadEnds) {
  const Region needle{{{{{0, 0}, {20, 1}, {0, 2}}, {}}}};
  WaveTree tree = trees_of(needle).at(0);
  const WaveSpiral s = nested_spirals(tree, {0.421, 0.4}, {0, 0});
  double farthest = 0;
  for (const Polyline* line : {&s.spine, &s.laps})
    for (const Point& p : *line)
      if (p != s.boundary.front()) farthest = std::max(farthest, p.x());
  const double end = 20 - 0.2 / std::sin(std::atan(1.0 / 20));  // clearance 0.2
  EXPECT_LT(farthest, end + 1e-6);
  EXPECT_GT(farthest, end - 0.5);
}

// The default, against one spiral, over all kinds of maps: never much longer, and shorter by a quarter altogether.
TEST(NestedSpirals, AreShorterThanOneSpiral) {
  double nested_s = 0, one_s = 0;
  for (const auto seed : seeds(4))
    for (const char* family : {"polygon", "clutter", "field", "cave", "rooms", "maze"}) {
      SCOPED_TRACE(testing::Message() << family << " " << seed);
      const Problem p(generate(family, {{"width", 18.0}, {"height", 16.0}}, seed), disc(0.15, 0.3));
      const Score nested = score(p, plan("smooth-spiral", p)),
                  one = score(p, plan("smooth-spiral", p, {{"start", std::string("spine")}}));
      EXPECT_EQ(nested.flaw, "");
      EXPECT_GT(*nested.value("coverage_lower"), 0.999);
      EXPECT_LT(*nested.value("mission_s"), 1.1 * *one.value("mission_s"));
      nested_s += *nested.value("mission_s"), one_s += *one.value("mission_s");
    }
  EXPECT_LT(nested_s, 0.75 * one_s);
}

}  // namespace
}  // namespace oxturn
