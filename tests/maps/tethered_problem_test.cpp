// Configuration space and target of a tethered robot.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/point_grid.hpp"
#include "maps/generators.hpp"
#include "maps/problem.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

Robot tethered(double length, double radius = 0.2, double tool_width = 0.4) {
  Robot robot;
  robot.radius = radius;
  robot.tool_width = tool_width;
  robot.tether = Tether{length};
  return robot;
}
Map hall() { return {"hall", box_region({0, 0}, {10, 10}), "test", "test"}; }
Map hall_with_pillar() {
  return {"pillar", subtract(box_region({0, 0}, {10, 10}), box_region({4, 4}, {6, 6})), "test", "test"};
}
Polyline sampled_along(const Polyline& line, double step) {
  Polyline points{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const int n = static_cast<int>(std::ceil(distance(line[i - 1], line[i]) / step));
    for (int k = 1; k <= n; ++k) points.push_back(lerp(line[i - 1], line[i], double(k) / n));
  }
  return points;
}
template <class F>
std::string complaint(F f) {
  try {
    f();
  } catch (const std::invalid_argument& e) { return e.what(); }
  return "no complaint";
}

// On maps 9 and 13 two paths to a corner are equally long but for 1e-11 m; the curve behind it is all but a ray.
TEST(TetheredProblem, TheCutStaysOnTheMap) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Map map = generate("clutter", {{"width", 18.0}, {"height", 14.0}}, seed);
    Robot robot;
    robot.radius = 0.1;
    robot.tool_width = 0.8;
    const Problem untethered(map, robot);
    const GeodesicField field(map.free, untethered.start(), {}, untethered.tolerance(), untethered.start());
    Box box = bounding_box(map.free);
    box.grow(1e-9);
    for (const Polyline& piece : field.cut_locus(0.01))
      for (const Point& p : piece) ASSERT_TRUE(box.contains(p)) << seed << " " << p.transpose();
  }
}

/// Those of the cut's ends that are neither on a wall nor at another piece's end.
std::vector<Point> loose_ends(const std::vector<Polyline>& cut, const EdgeIndex& walls, double close) {
  std::vector<Point> ends;  // 2 k and 2 k + 1 are those of piece k
  for (const Polyline& piece : cut) ends.insert(ends.end(), {piece.front(), piece.back()});
  const PointGrid grid(ends);
  std::vector<Point> loose;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    bool joined = walls.nearest(ends[k], close).has_value();
    grid.visit(ends[k], [&](std::size_t other, double away) {
      joined = joined || (away < close && other / 2 != k / 2);
      return !joined && away < close;
    });
    if (!joined) loose.push_back(ends[k]);
  }
  return loose;
}

// A curve that is lost where it only just reaches into a triangle, over one of its edges and back, leaves two loose
// ends. That is rare: one piece of 25,000.
TEST(TetheredProblem, TheCutHasNoLooseEnds) {
  std::size_t pieces = 0;
  for (const char* kind : {"speckle", "clutter", "rooms", "cave"})
    for (std::uint64_t seed = 1; seed <= (kind == std::string("speckle") ? 30 : 3); ++seed) {
      const Map map = generate(kind, {{"width", 40.0}, {"height", 40.0}}, seed);
      const std::vector<Polyline> cut = GeodesicField(map.free, default_start(map, Robot{}), {}, 1e-9).cut_locus(1e-5);
      pieces += cut.size();
      for (const Point& end : loose_ends(cut, EdgeIndex(map.free), 3e-4))
        ADD_FAILURE() << kind << ' ' << seed << ' ' << end.transpose();
    }
  EXPECT_GT(pieces, 100000U);
}

// The largest distance is found without asking for that of every vertex: here all are asked, and all of the cut.
TEST(TetheredProblem, FarthestIsThatOfAllVerticesAndOfTheCut) {
  for (const char* kind : {"clutter", "speckle", "rooms", "cave"})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      const Map map = generate(kind, {{"width", 16.0}, {"height", 14.0}}, seed);
      Robot robot;  // along the cut, distances are taken every w / 20
      robot.tether = Tether{0, 1.1};
      const Problem p(map, robot);
      const GeodesicField& field = p.tether()->geodesics();
      double most = 0;
      const auto ask = [&](const Point& q) {
        if (const double d = field.distance(q); std::isfinite(d)) most = std::max(most, d);
      };
      for_each_ring(p.tether()->robot_space(), [&](const Ring& ring) { std::ranges::for_each(ring, ask); });
      const EdgeIndex walls(p.tether()->robot_space());
      for (const Polyline& curve : field.cut_locus(1e-3))
        for (const Point& q : sampled_along(curve, 2e-3))
          if (walls.contains(q)) ask(q);
      EXPECT_NEAR(p.tether()->farthest(), most, robot.tool_width / 40 + 1e-3) << kind << ' ' << seed;
    }
}

TEST(TetheredProblem, ReachesADiscInTheOpen) {
  const Problem p(hall(), tethered(3), Point(5, 5));
  EXPECT_NEAR(area(p.configuration_space()), kPi * 9, 0.01);
  EXPECT_LE(area(p.configuration_space()), kPi * 9);
  EXPECT_NEAR(area(p.target()), kPi * 3.2 * 3.2, 0.02);
  EXPECT_GE(area(p.target()) + p.target_excess(), kPi * 3.2 * 3.2);
  EXPECT_NEAR(area(p.tether()->robot_space()), 9.6 * 9.6, 1e-3);
  EXPECT_TRUE(p.limited());
}

TEST(TetheredProblem, ALongTetherLimitsNothing) {
  const Problem p(hall(), tethered(20), Point(5, 5));
  EXPECT_EQ(&p.tether()->robot_space(), &p.configuration_space());
  EXPECT_FALSE(p.limited());
  EXPECT_EQ(area(Problem(hall(), Robot{}, Point(5, 5)).configuration_space()), area(p.configuration_space()));
}

TEST(TetheredProblem, ReachIsAMultipleOfTheFarthestDistance) {
  Robot robot = tethered(0);
  robot.tether = Tether{0, 0.5};
  const Problem p(hall(), robot, Point(5, 5));
  EXPECT_NEAR(p.robot().tether->length, 0.5 * std::hypot(4.8, 4.8), 1e-3);
  EXPECT_EQ(p.robot().tether->reach, 0);
}

// Behind the pillar the tether goes round a corner: distances by hand.
TEST(TetheredProblem, GoesRoundCorners) {
  const Problem p(hall_with_pillar(), tethered(5), Point(5, 2));
  const double to_corner = std::hypot(1, 2) + 2;  // (5, 2) - (6, 4) - (6, 6)
  EXPECT_NEAR(p.tether()->geodesics().distance({6, 6}), to_corner, 1e-12);
  const double left = 5 - to_corner;
  EXPECT_TRUE(contains(p.configuration_space(), Point(6 - 0.6 * left, 6 + 0.7 * left)));
  EXPECT_FALSE(contains(p.configuration_space(), Point(6 - 0.75 * left, 6 + 0.75 * left)));
}

// A thin tether would fit through a gap that the robot cannot pass, but the gap counts as closed.
TEST(TetheredProblem, GapsNarrowerThanTheRobotAreClosed) {
  const Map map{"gap",
                subtract(box_region({0, 0}, {10, 10}),
                         unite({box_region({4.9, 0}, {5.1, 4.9}), box_region({4.9, 5.1}, {5.1, 9})})),
                "test", "test"};
  const Problem p(map, tethered(30), Point(4, 5));
  const double round = distance({4, 5}, {4.9, 9}) + 0.2 + distance({5.1, 9}, {6, 5});
  EXPECT_NEAR(p.tether()->geodesics().distance({6, 5}), round, 1e-7);
  // A smaller robot passes.
  const Problem small(map, tethered(30, 0.05, 0.1), Point(4, 5));
  EXPECT_NEAR(small.tether()->geodesics().distance({6, 5}), 2, 1e-7);
}

// The anchor is in or beside a gap that the robot cannot pass: the tether leaves it on the side of the start only.
TEST(TetheredProblem, AnAnchorAtAClosedGapServesTheSideOfTheStart) {
  const Region free =
      subtract(subtract(box_region({0, 0}, {10, 8}), box_region({0, 3.9}, {4, 4.1})), box_region({4.3, 3.9}, {9, 4.1}));
  const Map map{"gap", free, "test", "test"};
  const double round = 4.7 + 0.2 + std::hypot(9 - 4.15, 0.9);  // from (4.3, 3.9) below the wall to (4.15, 5)
  for (const Point& anchor : {Point(4.3, 3.8999), Point(4.3, 3.9), Point(4.3, 3.9001), Point(4.3, 4), Point(4.3, 4.1),
                              Point(4.3, 4.1001), Point(4.3001, 3.9), Point(4.3001, 4.1), Point(4.1, 3.95)}) {
    SCOPED_TRACE(fmt::format("anchor ({}, {})", anchor.x(), anchor.y()));
    for (const double y : {3.0, 5.0}) {
      const Problem problem(map, tethered(20), Point(4.15, y), anchor);
      const double here = problem.tether()->geodesics().distance({4.15, y});
      EXPECT_LE(here, 1.2);
      const double there = problem.tether()->geodesics().distance({4.15, 8 - y});
      EXPECT_NEAR(there, round, 0.4);
      EXPECT_FALSE(problem.limited());
    }
  }
}

Region rotated_box(const Point& centre, const Point& half, double angle) {
  Ring ring;
  for (const Point& corner : {Point(-1, -1), Point(1, -1), Point(1, 1), Point(-1, 1)})
    ring.push_back(centre + rotated(corner.cwiseProduct(half), angle));
  return {{{ring, {}}}};
}

/// Two to four boxes in a room, with gaps between them.
std::vector<Region> boxes_with_gaps(Rng& rng) {
  Point at(rng.between(2.5, 4.0), rng.between(2.5, 5.5));
  std::vector<Region> boxes;
  for (std::size_t n = 2 + rng.below(3); n > 0 && at.x() < 8; --n) {
    const Point half(rng.between(0.3, 1.0), rng.between(0.02, 0.4));
    boxes.push_back(rotated_box(at, half, rng.between(-0.4, 0.4)));
    at += Point(2 * half.x() + rng.between(0.02, 0.35), rng.between(-0.3, 0.3));
  }
  return boxes;
}

/// A vertex of a box, a point of its boundary near a vertex, or a point near that.
Point anchor_at(const Ring& ring, Rng& rng) {
  const std::size_t k = rng.below(ring.size());
  const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
  const double kind = rng.unit();
  if (kind < 0.4) return a;
  const Point on_wall = lerp(a, b, rng.unit());
  return kind < 0.7 ? on_wall
                    : Point(on_wall + rng.between(0.0, 0.2) * rotated(Point(1, 0), rng.between(0.0, 2 * kPi)));
}

// Boxes anywhere, and an anchor on one of their vertices or edges, or in a gap between them: moved by 0.1 mm it changes
// distances by as little, and what the tether reaches, too.
TEST(TetheredProblem, AnAnchorMovedALittleChangesLittle) {
  std::size_t compared = 0, at_gaps = 0;
  for (const auto seed : seeds(200)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    Region free = box_region({0, 0}, {10, 8});
    const std::vector<Region> boxes = boxes_with_gaps(rng);
    for (const Region& box : boxes) free = subtract(free, box);
    const EdgeIndex walls(free);
    Point anchor = anchor_at(boxes[rng.below(boxes.size())].polygons[0].outer, rng);
    if (const auto wall = walls.nearest(anchor, 1e-6)) anchor = wall->point;  // rounded
    const Map map{"gaps", free, "", ""};
    const Point start = default_start(map, tethered(30));
    const auto problem_at = [&](const Point& p) { return Problem(map, tethered(100), start, p); };
    if (!walls.contains(anchor)) continue;
    const Problem here = problem_at(anchor);
    at_gaps += !here.tether()->closed_gaps().empty() && walls.nearest(anchor, 0.3);
    for (int tries = 0; tries < 4; ++tries) {
      const Point moved = anchor + 1e-4 * rotated(Point(1, 0), rng.between(0.0, 2 * kPi));
      if (!walls.contains(moved)) continue;
      ++compared;
      const Problem there = problem_at(moved);
      for (const Point& p : {start, Point(0.5, 0.5), Point(9.5, 0.5), Point(9.5, 7.5), Point(0.5, 7.5)})
        EXPECT_NEAR(here.tether()->geodesics().distance(p), there.tether()->geodesics().distance(p), 1.01e-4);
      if (tries > 0) continue;
      const double length = here.tether()->geodesics().distance(start) + 1;
      const Problem near(map, tethered(length), start, anchor), beside(map, tethered(length), start, moved);
      EXPECT_NEAR(area(near.target()), area(beside.target()), 5e-3);
    }
  }
  EXPECT_GT(compared, 300u);
  EXPECT_GT(at_gaps, 60u);
}

TEST(TetheredProblem, SpaceIsWhereTheGeodesicIsShortEnough) {
  for (const auto seed : seeds(6))
    for (const char* name : {"rooms", "clutter", "cave", "maze"})
      for (const double reach : {0.4, 0.8}) {
        SCOPED_TRACE(std::string(name) + std::to_string(seed));
        Robot robot = tethered(0);
        robot.tether = Tether{0, reach};
        const double size = std::string(name) == "rooms" ? 12 : 8;
        const Problem p(oxturn::generate(name, {{"width", size}, {"height", size}}, seed), robot);
        const double limit = p.robot().tether->length;
        const Box box = bounding_box(p.tether()->robot_space());
        Rng rng(seed);
        for (int n = 0; n < 200;) {
          const Point q(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
          if (!contains(p.tether()->robot_space(), q)) continue;
          ++n;
          const double d = p.tether()->geodesics().distance(q);
          if (contains(p.configuration_space(), q)) {
            EXPECT_LE(d, limit + p.tolerance());
          } else if (d < limit - 1e-3) {
            // Within the tether's reach, but every path to it leads beyond the reach.
            EXPECT_FALSE(p.transit().path(p.start(), q));
          }
        }
      }
}

TEST(TetheredProblem, AnchorInAWallSocketStartsNextToIt) {
  const Problem p(hall(), tethered(4), {}, Point(0, 5));
  EXPECT_NEAR(p.start().x(), 0.2, 0.02);
  EXPECT_NEAR(p.start().y(), 5, 0.02);
  EXPECT_EQ(p.anchor(), Point(0, 5));
  const Problem corner(hall(), tethered(4), {}, Point(10, 10));
  EXPECT_NEAR(distance(corner.start(), {9.8, 9.8}), 0, 0.05);
}

TEST(TetheredProblem, BadTethersAreOneSentence) {
  EXPECT_THAT(complaint([] { Problem(hall(), tethered(1), Point(5, 5), Point(2, 5)); }),
              testing::AllOf(HasSubstr("too short for the start (5, 5)"), HasSubstr("3 m from the anchor (2, 5)")));
  EXPECT_THAT(complaint([] { Problem(hall_with_pillar(), tethered(9), Point(1, 1), Point(5, 5)); }),
              HasSubstr("anchor (5, 5) is inside a wall of 'pillar'"));
  const Map two{"two", unite({box_region({0, 0}, {4, 4}), box_region({6, 0}, {10, 4})}), "test", "test"};
  EXPECT_THAT(complaint([&] { Problem(two, tethered(30), Point(1, 1), Point(8, 2)); }),
              HasSubstr("anchor (8, 2) is out of reach"));
  EXPECT_THAT(complaint([] { Problem(hall(), tethered(0), Point(5, 5)); }), HasSubstr("tether has no length"));
  EXPECT_THAT(complaint([] { Problem(hall(), tethered(std::nan("")), Point(5, 5)); }),
              HasSubstr("'tether_length' of robot 'disc' is nan"));
  Robot both = tethered(3);
  both.tether->reach = 2;
  EXPECT_THAT(complaint([&] { Problem(hall(), both, Point(5, 5)); }), HasSubstr("expected one of the two"));
  EXPECT_THAT(complaint([] { Problem(hall(), tethered(3), Point(5, 5), Point(std::nan(""), 1)); }),
              HasSubstr("anchor (nan, 1) is not finite"));
  EXPECT_EQ(Problem(hall(), Robot{}).tether(), nullptr);
}

}  // namespace
}  // namespace oxturn
