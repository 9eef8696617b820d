#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/polygon/driven_lines.hpp"
#include "algorithms/polygon/field_blocks.hpp"
#include "algorithms/polygon/halves.hpp"
#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/ring_boxes.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Problem shape(const Ring& outer, const Point& start, const Robot& robot = disc(0.2, 0.4)) {
  Region region = box_region({0, 0}, {1, 1});
  region.polygons[0].outer = outer;
  return Problem(Map{"shape", region, "", ""}, robot, start);
}

Ring ring_of(const BoustrophedonCell& cell) {
  Ring ring(cell.lower.begin(), cell.lower.end());
  ring.insert(ring.end(), cell.upper.rbegin(), cell.upper.rend());
  return ring;
}

TEST(Field, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed))
      for (const Settings& settings :
           {Settings{}, Settings{{"headland", std::int64_t{2}}, {"headland_order", std::string("first")}},
            Settings{{"variant", std::string("published")}}}) {
        SCOPED_TRACE(p.map().source);
        const Path path = plan("field", p, settings);
        expect_valid(p, path);
        EXPECT_LE(uncovered_share(p, path, 700), 2e-3);
      }
}

TEST(FieldPredictive, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed)) {
      SCOPED_TRACE(p.map().source);
      const Path path = plan("field-predictive", p);
      expect_valid(p, path);
      EXPECT_LE(uncovered_share(p, path, 700), 2e-3);
      const Path driven = plan("field-predictive", p, {{"repair", false}});
      expect_valid(p, driven);
      EXPECT_LE(uncovered_share(p, driven, 700), 0.25);  // where corridors are narrow
    }
}

// One block, its lanes along the longer side, however the rectangle is turned.
TEST(Field, ARectangleIsOneBlockAlongItsLongerSide) {
  for (const double degrees : {0.0, 30.0, 90.0, 117.0}) {
    const Region region = transformed(box_region({0, 0}, {14, 7}), degrees * kPi / 180, {0, 0});
    const Problem p(Map{"shape", region, "", ""}, disc(0.2, 0.4), rotated(Point(3, 3), degrees * kPi / 180));
    EXPECT_EQ(plan_recorded("field", p).figures.at("blocks"), 1) << degrees;
    Context context(1);
    const Region field = transformed(box_region({0.6, 0.6}, {13.4, 6.4}), degrees * kPi / 180, {0, 0});
    const std::vector<FieldBlock> blocks = field_blocks(p, p.configuration_space(), field, {}, context);
    ASSERT_EQ(blocks.size(), 1u) << degrees;
    EXPECT_NEAR(std::abs(std::remainder(blocks[0].degrees - degrees, 180.0)), 0, 1e-6);
    EXPECT_NEAR(blocks[0].area, 12.8 * 5.8, 1e-6);
    std::size_t lanes = 0;
    for (const Strip& s : blocks[0].strips) lanes += s.lanes.size();
    EXPECT_EQ(lanes, 15u);  // 5.8 m in strips of at most 0.4 m
  }
}

// A kink of less than 20 degrees does not part a block.
TEST(Field, TrapezoidsAreMergedWhereTheirEndsRunOn) {
  const auto count = [](double kink) {
    Region region = box_region({0, 0}, {10, 4});
    region.polygons[0].outer = {{0, 0}, {5, 0}, {10, 0}, {10, 4}, {5, 4 + kink}, {0, 4}};
    return merged_trapezoids(region, 0.4).size();
  };
  EXPECT_EQ(count(0), 1u);
  EXPECT_EQ(count(0.3), 1u);  // 6.9 degrees at the kink
  EXPECT_EQ(count(1.2), 2u);  // 27 degrees
}

// Lanes of a section of the field are cut at the walls about it: those elsewhere change nothing.
TEST(Field, WallsElsewhereDoNotMatter) {
  for (const auto seed : seeds(4)) {
    const Problem p(generate("clutter", {{"width", 16.0}, {"height", 7.0}}, seed), Robot{});
    const double w = p.robot().tool_width;
    const Region section = intersect(lane_region(p, w, 0.02 * w), box_region({4, 0}, {9, 7}));
    const RingBoxes walls(p.configuration_space());
    const Region near = walls.near(Box{{4 - w, -w}, {9 + w, 7 + w}});
    ASSERT_LT(vertex_count(near), vertex_count(p.configuration_space())) << seed;
    Context context(1);
    const auto blocks = [&](const Region& space) { return field_blocks(p, space, section, {}, context); };
    const std::vector<FieldBlock> all = blocks(p.configuration_space()), some = blocks(near);
    ASSERT_EQ(all.size(), some.size()) << seed;
    for (std::size_t i = 0; i < all.size(); ++i) {
      ASSERT_EQ(all[i].strips.size(), some[i].strips.size()) << seed;
      for (std::size_t k = 0; k < all[i].strips.size(); ++k)
        EXPECT_EQ(all[i].strips[k].lanes.size(), some[i].strips[k].lanes.size()) << seed;
    }
  }
}

TEST(Field, BlocksDivideTheField) {
  for (const auto seed : seeds(6)) {
    const Problem p(generate("clutter", {{"width", 9.0}, {"height", 7.0}}, seed), Robot{});
    const Region field = lane_region(p, 0.4, 0.008);
    for (const BlockValue value : {BlockValue::area_rate, BlockValue::rate}) {
      Context context(1);
      double sum = 0;
      Region all;
      for (const FieldBlock& b : field_blocks(p, p.configuration_space(), field, {value, 4}, context)) {
        sum += b.area;
        if (!b.ring.empty()) all.polygons.push_back({b.ring, {}});
      }
      EXPECT_NEAR(sum, area(field), 1e-3 * area(field)) << seed;
      double alone = 0;
      for (const Polygon& block : all.polygons) alone += area(block);
      EXPECT_NEAR(area(unite({all})), alone, 1e-6 * alone) << seed;  // none overlap
    }
  }
}

TEST(Field, MergedTrapezoidsMakeUpTheRegion) {
  for (const auto seed : seeds(5)) {
    const Region free = generate("clutter", {{"width", 9.0}, {"height", 7.0}}, seed).free;
    double sum = 0;
    for (const BoustrophedonCell& cell : merged_trapezoids(free, 0.4)) sum += signed_area(ring_of(cell));
    EXPECT_NEAR(sum, area(free), 1e-9 * area(free)) << seed;
  }
}

// Convex fields take no more than lanes in the worst fixed direction would.
TEST(Field, IsNotLongerThanTheWorstFixedHeading) {
  for (const Ring& ring : {Ring{{0, 0}, {12, 0}, {9, 8}, {1, 6}}, Ring{{0, 0}, {14, 2}, {4, 9}},
                           Ring{{0, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 11}, {0, 11}}}) {
    const Problem p = shape(ring, {3, 2});
    double worst = 0;
    for (const double angle : {0.0, 30.0, 60.0, 90.0, 120.0, 150.0})
      worst = std::max(
          worst, plan("zigzag", p, {{"sweep", std::string("given")}, {"angle", angle}, {"headland", std::int64_t{1}}})
                     .length());
    EXPECT_LE(plan("field", p).length(), worst * 1.02);
  }
}

TEST(FieldPredictive, ARectangleIsDrivenWithoutRepairs) {
  const Problem p(Map{"shape", box_region({0, 0}, {12.4, 8.4}), "", ""}, disc(0.2, 0.4), Point(0.3, 0.3));
  const Path path = plan("field-predictive", p, {{"repair", false}});
  // Half the tool's width more at one lane is all that may be missing, and the corners.
  EXPECT_LE(uncovered_share(p, path, 2000), 0.06);
  EXPECT_LE(path.length(), 1.15 * area(p.target()) / 0.4);
}

// What the last lane leaves along the wall takes an arc
// there and back, and no lane beside that.
TEST(FieldPredictive, WithLongStretchesFirstLanesRunAlongTheLongerSide) {
  for (const auto& [width, height] : {std::pair(20.0, 5.0), std::pair(5.0, 20.0), std::pair(30.0, 7.5)}) {
    const Problem p(Map{"shape", box_region({0, 0}, {width, height}), "", ""}, disc(0.2, 0.4));
    const auto lanes = static_cast<std::size_t>(std::ceil(std::min(width, height) / 0.4));
    std::size_t points = 0;
    for (const Leg& leg : plan("field-predictive", p, {{"ties", std::string("longest")}, {"repair", false}}).legs)
      points += leg.points.size();
    EXPECT_LE(points, 2 * lanes + 10);
    const Path whole = plan("field-predictive", p, {{"ties", std::string("longest")}});
    EXPECT_EQ(uncovered_share(p, whole, 1000), 0);
    EXPECT_LE(whole.length(), 1.25 * width * height / 0.4);
  }
}

// Lanes along a slanted wall: each begins where a cut ended, beside the wall but for rounding, which must not add up.
TEST(FieldPredictive, RotatedRectanglesAreDrivenAlongTheirWalls) {
  const Settings size{{"width", 106.629}, {"height", 47.833}, {"robot", 0.211}, {"rotation", 64.0}};
  const Point start(8.73747456073761, -13.417912364006042);
  const Problem p(generate("rectangle", size, 587465), disc(0.211, 0.626), start);
  expect_valid(p, plan("field-predictive", p, {{"repair", false}}));
}

// Large enough to be driven in blocks: nothing is left at their seams, and nothing is driven twice because of them.
TEST(FieldPredictive, BlocksLeaveNothingBetweenThem) {
  const Problem p(generate("clutter", {{"width", 30.0}, {"height", 24.0}}, 1), disc(0.2, 0.4));
  const Path blocks = plan("field-predictive", p), whole = plan("field-predictive", p, {{"blocks", false}});
  EXPECT_NE(blocks.length(), whole.length());
  expect_valid(p, blocks);
  EXPECT_EQ(uncovered_share(p, blocks, 1000), 0);
  EXPECT_LT(blocks.length(), 1.08 * whole.length());
}

// However large: blocks are for regions of many vertices.
TEST(FieldPredictive, ALargeRectangleIsOneBlock) {
  const Problem p(Map{"shape", box_region({0, 0}, {240, 180}), "", ""}, disc(0.2, 0.4), Point(0.3, 0.3));
  const Path blocks = plan("field-predictive", p), whole = plan("field-predictive", p, {{"blocks", false}});
  EXPECT_EQ(blocks.length(), whole.length());
  std::size_t points = 0;
  for (const Leg& leg : blocks.legs) points += leg.points.size();
  EXPECT_LT(points, 4000u);
}

// What is behind a wall is not near: rooms are finished one after the other.
TEST(FieldPredictive, StaysInARoomUntilItIsDone) {
  double by_path = 0, straight = 0;
  for (int seed = 1; seed <= 8; ++seed) {
    const Problem p(generate("rooms", {{"width", 14.0}, {"height", 14.0}, {"rooms", std::int64_t{10}}}, seed),
                    disc(0.2, 0.4));
    const Path path = plan("field-predictive", p);
    expect_valid(p, path);
    by_path += path.length();
    straight += plan("field-predictive", p, {{"links", std::string("straight")}}).length();
  }
  EXPECT_LT(by_path, 0.9 * straight);
}

TEST(FieldPlanners, ShiftedMapsTakeAboutTheSameLength) {
  const Map map = generate("field", {{"width", 16.0}, {"height", 11.0}}, 3);
  for (const char* name : {"field", "field-predictive"}) {
    const Problem base(map, Robot{});
    const double length = plan(name, base).length();
    const Point s = base.start(), shift(300, -200);
    const Problem moved(Map{"moved", transformed(map.free, 0, shift), "", ""}, Robot{}, s + shift);
    EXPECT_NEAR(plan(name, moved).length() / length, 1, 0.05) << name;
  }
}

TEST(FieldPlanners, ACancelledRunReturnsAValidBeginning) {
  const Problem p(generate("clutter", {{"width", 8.0}, {"height", 8.0}}, 5), Robot{});
  for (const char* name : {"field", "field-predictive"}) {
    Context context(1);
    context.cancel();
    EXPECT_LT(built_in_planner(name)->plan(p, context).length(), plan(name, p).length()) << name;
  }
}

// The parts are disjoint and are the region; holes far from all cuts are in the part that they lie in.
TEST(Halves, AreTheRegion) {
  for (const auto seed : seeds(4))
    for (const char* generator : {"clutter", "rooms", "speckle"}) {
      SCOPED_TRACE(std::string(generator) + std::to_string(seed));
      const Region region = generate(generator, {{"width", 15.0}, {"height", 12.0}}, seed).free;
      const auto small = [](const Region& r) { return vertex_count(r) <= 60; };
      const std::vector<Region> parts = halved_until(region, small);
      EXPECT_GT(parts.size(), 1u);
      double sum = 0;
      for (const Region& part : parts) {
        EXPECT_TRUE(small(part));
        sum += area(part);
        EXPECT_LT(area(subtract(part, region)), 1e-5);
      }
      EXPECT_NEAR(sum, area(region), 1e-4);
      EXPECT_LT(area(subtract(region, parts)), 1e-4);
    }
}

TEST(DrivenLines, NearABoxAreThoseWhoseBoxesOverlap) {
  Rng rng(1);
  DrivenLines driven(3);
  std::vector<Polyline> all;
  for (int k = 0; k < 300; ++k) {
    Polyline line{{rng.between(-40.0, 40.0), rng.between(-40.0, 40.0)}};
    for (int i = 0; i < 3; ++i) line.push_back(line.back() + Point(rng.between(-5.0, 5.0), rng.between(-5.0, 5.0)));
    driven.add(line);
    all.push_back(line);
    const Point low(rng.between(-40.0, 40.0), rng.between(-40.0, 40.0));
    const Box box{low, low + Point(rng.between(0.0, 20.0), rng.between(0.0, 20.0))};
    std::vector<Polyline> expected;
    for (const Polyline& one : all)
      if (bounding_box(one).overlaps(box)) expected.push_back(one);
    ASSERT_EQ(driven.near(box), expected);
  }
}

}  // namespace
}  // namespace oxturn
