#include "algorithms/lanes/stops.hpp"

#include <gtest/gtest.h>

#include "algorithms/improve/detours.hpp"
#include "algorithms/lanes/boundary_arcs.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/connector.hpp"
#include "base/random.hpp"
#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

const Region kHall = box_region({-20, -20}, {20, 20});

Path along(const Polyline& points, bool tool = true) {
  PathBuilder path(points.front());
  path.drive(points, tool);
  return path.take();
}
Region swept(const Path& path, double reach, Bound bound) {
  std::vector<Polyline> lines;
  for (const Leg& leg : path.legs) lines.push_back(leg.points);
  return swath(lines, reach, 1e-6, bound);
}
/// A regular polygon.
Polygon speck(const Point& at, double size) {
  Polygon polygon;
  for (int k = 0; k < 8; ++k) polygon.outer.push_back(at + rotated({size, 0}, k * kPi / 4));
  return polygon;
}
bool covered(const Path& path, double reach, const Polygon& piece) {
  return subtract({{piece}}, swept(path, reach, Bound::outside)).empty();
}

// A path that passes the centre of a piece with its tool off covers nothing there.
TEST(Stops, SwitchTheToolOnWhereThePathPassesThePiece) {
  const EdgeIndex walls(kHall);
  for (const double off : {0.0, 1e-12, 1e-7, 1e-4})
    for (const Polyline& line :
         {Polyline{{-5, off}, {5, off}}, Polyline{{0, off}, {5, off}}, Polyline{{-5, 0}, {0, off}}}) {
      const Path path = along(line, false);
      std::vector<Polygon> pieces{speck({0, 0}, 0.5)};
      const Polygon piece = pieces.front();
      const Path longer = with_stops(path, line.front(), pieces, 1, walls);
      ASSERT_TRUE(pieces.empty());
      Path on = longer;
      std::erase_if(on.legs, [](const Leg& leg) { return !leg.tool || length(leg.points) < 1e-3; });
      EXPECT_TRUE(covered(on, 1 + 1e-3, piece)) << off;
      EXPECT_LT(longer.length(), path.length() + 0.05);
    }
}

// The lemma on which it rests: angles from 10 to 170 degrees, pieces outside of the turn at any distance.
TEST(Stops, CutOffTurnsWithoutLoss) {
  const EdgeIndex walls(kHall);
  Rng rng(3);
  int cut_off = 0;
  for (int n = 0; n < 400; ++n) {
    const double angle = rng.between(kPi / 18, 17 * kPi / 18), turned = rng.between(0.0, 2 * kPi);
    const auto at = [&](double distance, double from_bisector) {
      return rotated({distance, 0}, turned + from_bisector);
    };
    const Path path = along({at(rng.between(0.2, 6.0), angle / 2), {0, 0}, at(rng.between(0.2, 6.0), -angle / 2)});
    const Point centre = at(rng.between(1.05, 1.9), kPi + rng.between(-angle / 2, angle / 2));
    std::vector<Polygon> pieces{speck(centre, rng.between(0.01, 0.3))};
    const Polygon piece = pieces.front();
    const Path longer = with_stops(path, path.legs[0].points[0], pieces, 1, walls);
    ASSERT_TRUE(pieces.empty());
    EXPECT_TRUE(covered(longer, 1 + 1e-6, piece));
    const Region lost = subtract(swept(path, 1, Bound::inside), swept(longer, 1, Bound::outside));
    EXPECT_LT(area(lost), 1e-7) << "angle " << angle * 180 / kPi;
    const double there_and_back = 2 * (distance(centre, {0, 0}) - 1 + 0.3);
    EXPECT_LT(longer.length(), path.length() + there_and_back);
    cut_off += longer.legs[0].points[1] != Point(0, 0) && longer.legs[0].points.size() == 5;
  }
  EXPECT_GT(cut_off, 300);
}

// Beside a straight run the robot goes there and back, no farther than it has to.
TEST(Stops, BesideALane) {
  const EdgeIndex walls(kHall);
  std::vector<Polygon> pieces{speck({0, 1.4}, 0.1)};
  const Path path = with_stops(along({{-5, 0}, {5, 0}}), {-5, 0}, pieces, 1, walls);
  EXPECT_TRUE(pieces.empty());
  EXPECT_NEAR(path.length(), 10 + 2 * 0.5, 1e-6);
}

// Two pieces outside of the same turn, and one beside the segment that would be cut off.
TEST(Stops, KeepApart) {
  const EdgeIndex walls(kHall);
  const std::vector<Polygon> all{speck({-0.9, -0.9}, 0.1), speck({-1.3, -0.3}, 0.1), speck({0.3, -1.25}, 0.1)};
  std::vector<Polygon> pieces = all;
  const Path before = along({{0, 5}, {0, 0}, {5, 0}}), path = with_stops(before, {0, 5}, pieces, 1, walls);
  EXPECT_TRUE(pieces.empty());
  for (const Polygon& piece : all) EXPECT_TRUE(covered(path, 1 + 1e-6, piece));
  EXPECT_LT(area(subtract(swept(before, 1, Bound::inside), swept(path, 1, Bound::outside))), 1e-7);
}

TEST(Stops, NotThroughWalls) {
  const EdgeIndex walls(subtract(kHall, box_region({-10, 0.2}, {10, 0.3})));
  std::vector<Polygon> pieces{speck({0, 1.2}, 0.1)};
  const Path path = with_stops(along({{-5, 0}, {5, 0}}), {-5, 0}, pieces, 1, walls);
  EXPECT_EQ(pieces.size(), 1u);
  EXPECT_EQ(path.length(), 10);
}

// Detours that reach the coverage asked for cut off turns, too; those that would meet there do not.
TEST(Stops, DetoursCutOffTurns) {
  const Problem p(Map{"hall", kHall, "", ""}, disc(1, 2), Point(0, 5));
  const Polyline path{{0, 5}, {0, 0}, {5, 0}};
  const auto with = [&](const std::vector<Polygon>& pieces) {
    std::vector<ToCover> all;
    for (const Polygon& piece : pieces) all.push_back({piece, {piece}});
    return with_detours(path, all, 1e9, 1e9, 1, Connector(p), p.walls()).path;
  };
  const Polygon beyond = speck({-0.9, -0.9}, 0.1), beside = speck({-1.3, -0.3}, 0.1);
  const Polyline one = with({beyond}), two = with({beyond, beside});
  EXPECT_EQ(one.size(), 5u);
  EXPECT_LT(length(one), length(path) + 1.6 * (distance({-0.9, -0.9}, {0, 0}) - 0.9));
  for (const auto& [line, piece] : {std::pair(one, beyond), std::pair(two, beyond), std::pair(two, beside)})
    EXPECT_TRUE(covered(along(line), 1 + 1e-6, piece));
  for (const Polyline& line : {one, two})
    EXPECT_LT(area(subtract(swept(along(path), 1, Bound::inside), swept(along(line), 1, Bound::outside))), 1e-7);
}

// At a right angle, laps a tool width apart leave a piece that takes 0.33 widths: 0.41 there and back along the
// bisector, 0.9 to its centre.
TEST(Stops, CornersOfLapsTakeAThirdOfAWidth) {
  const Problem p(Map{"square", box_region({0, 0}, {8, 8}), "", ""}, disc(0.2, 0.4), Point(0.2, 0.2));
  const Path laps = plan("contour", p, {{"repair", false}}), whole = plan("contour", p);
  const double corners = 4 * 9;  // of ten laps
  EXPECT_LT(whole.length(), laps.length() + (corners * 0.36 + 2) * 0.4);
  EXPECT_LE(uncovered_share(p, whole, 700), 1e-4);
}

// A cusp at a wall and a seam of a thousandth of a millimetre, as rounding leaves it: thinner on average than what
// counts as covered.
TEST(Repair, CoversThePieceInASeam) {
  const Problem p(Map{"hall", box_region({0, 0}, {12, 2}), "", ""}, disc(0.2, 0.4), Point(1, 1));
  const Region left{
      {Polygon{{{0.2, 0}, {11.8, 0}, {11.8, 1e-6}, {11.28, 1e-6}, {11.14, 0.06}, {11, 1e-6}, {0.2, 1e-6}}, {}}}};
  ASSERT_LT(2 * area(left) / perimeter(left), 0.4 / 250);
  Context context(1);
  const Path path = repaired(p, along({{1, 1}, {11, 1}}), left, Connector(p), context);
  const Region cusp = intersect(left, box_region({11, 0}, {11.28, 0.1}));
  EXPECT_LT(area(subtract(cusp, swept(path, 0.2, Bound::outside))), 1e-6);
}

// Three sides of a square: once around is shorter than there and back.
TEST(BoundaryArcs, GoAroundWhereArcsTakeHalfTheRing) {
  const EdgeIndex boundary(box_region({0, 0}, {4, 4}));
  BoundaryArcs arcs(boundary);
  for (double s = 0; s <= 4; s += 0.5) {
    arcs.add({s, 0});
    arcs.add({4, s});
    arcs.add({s, 4});
  }
  const std::vector<Ring> rings = arcs.take(1);
  ASSERT_EQ(rings.size(), 1u);
  EXPECT_EQ(perimeter({{Polygon{rings[0], {}}}}), 16);
  for (double s = 0; s <= 4; s += 0.5) arcs.add({s, 0});
  EXPECT_EQ(perimeter({{Polygon{arcs.take(1).at(0), {}}}}), 8);
}

}  // namespace
}  // namespace oxturn
