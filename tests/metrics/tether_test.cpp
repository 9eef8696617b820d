// The tether's metrics by hand, and what must not change them.
#include "metrics/tether.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"
#include "tethered.hpp"

namespace oxturn {
namespace {

TetherRun run(const Problem& p, const Polyline& walk) {
  return tether_run(p, work(walk), p.map_edges(), p.tolerance()).value();
}
std::size_t crossings(const Problem& p, const Polyline& walk) { return run(p, walk).crossings.size(); }
double mean_angle(const TetherRun& r) { return r.angle_sum / r.path_m; }

TEST(Tether, StraightOutAndBack) {
  const Problem p = leashed(pillar_room(), {1, 1});
  const TetherRun out = run(p, {{1, 1}, {9, 1}});
  EXPECT_EQ(out.longest_m, 8);
  EXPECT_EQ(out.longest_at, Point(9, 1));
  EXPECT_EQ(out.bends_max, 0u);
  EXPECT_EQ(out.angle_min, 0);
  EXPECT_EQ(out.angle_sum, 0);
  EXPECT_EQ(out.end_m, out.geodesic_m);
  const TetherRun back = run(p, {{1, 1}, {9, 1}, {3, 1}});
  EXPECT_EQ(back.longest_m, 8);
  EXPECT_EQ(back.longest_at, Point(9, 1));
  EXPECT_NEAR(back.angle_sum, 6 * kPi, 1e-12);
  EXPECT_EQ(back.sharp_m, 6);
  EXPECT_EQ(back.path_m, 14);
  EXPECT_EQ(back.end_m, 2);
  EXPECT_TRUE(back.crossings.empty()) << "driving back along the tether is no crossing";
}

// Past the anchor at a distance: the integral of atan2(h, s) by Simpson's rule, the share by trigonometry.
TEST(Tether, AngleAlongALineThatPassesTheAnchor) {
  Robot robot;
  robot.tether = Tether{100, 0, 2};
  const Problem p(Map{"m", pillar_room(), "test", "test"}, robot, Point(0, 1), Point(3, 2.5));
  const TetherRun r = run(p, {{0, 1}, {10, 1}});
  const int n = 20000;
  double sum = 0;
  for (int k = 0; k <= n; ++k) {
    const double s = -3 + 10.0 * k / n;
    sum += std::atan2(1.5, s) * (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * 10.0 / n / 3;
  }
  EXPECT_NEAR(r.angle_sum, sum, 1e-9);
  EXPECT_NEAR(r.angle_min, std::atan2(1.5, 7.0), 1e-12);
  EXPECT_NEAR(r.sharp_m, 3 + 1.5 / std::tan(2), 1e-12);
  EXPECT_NEAR(r.longest_m, std::hypot(1.5, 7), 1e-12);
}

// Backwards along any walk: each angle becomes pi less it.
TEST(Tether, ReverseTurnsTheHeadingRound) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region free = pillars(rng, 4);
    Robot robot;
    robot.radius = 0.1;
    robot.tether = Tether{1000, 0, 2};
    const Problem p(Map{"m", free, "test", "test"}, robot), mirrored = [&] {
      Robot other = robot;
      other.tether->sharp_angle = kPi - 2;
      return Problem(p.map(), other, p.start());
    }();
    const Polyline walk = free_walk(p, rng, 30, 3);
    const auto run_in = [&](const Problem& problem, Gear gear) {
      return tether_run(problem, Path{{Leg{true, walk, gear}}}, problem.map_edges(), problem.tolerance()).value();
    };
    const TetherRun forward = run_in(mirrored, Gear::forward), reverse = run_in(p, Gear::reverse);
    EXPECT_EQ(reverse.longest_m, forward.longest_m);
    EXPECT_EQ(reverse.crossings.size(), forward.crossings.size());
    EXPECT_NEAR(reverse.angle_sum, kPi * forward.path_m - forward.angle_sum, 1e-9 * forward.path_m);
    EXPECT_NEAR(reverse.sharp_m, forward.path_m - forward.sharp_m, 1e-9 * forward.path_m);
  }
}

TEST(Tether, ACrossingOfTheAnchorWithinRoundingIsNone) {
  const Problem p = leashed(pillar_room(), {3, 3});
  // Round the pillar and past the anchor.
  const auto past = [](double off) {
    return Polyline{{3, 3}, {7, 3}, {7, 7}, {3.5, 7}, {3 + off, 3.5}, {3 + off, 2.5}};
  };
  for (const double off : {1e-9, 1e-12, 0.0, -1e-9, -0.5}) EXPECT_EQ(crossings(p, past(off)), 0u) << off;
  for (const double off : {1e-3, 0.5}) EXPECT_EQ(crossings(p, past(off)), 1u) << off;
}

TEST(Tether, LimitOfPiIsNeverSharp) {
  Robot robot;
  robot.tether = Tether{100, 0, kPi};
  const Problem p(Map{"m", pillar_room(), "test", "test"}, robot, Point(1, 1));
  EXPECT_EQ(run(p, {{1, 1}, {9, 1}, {3, 1}}).sharp_m, 0);
}

// Once round the pillar at a metre: three bends; where it comes home it ends in a loop.
TEST(Tether, OnceRoundAPillar) {
  const Problem p = leashed(pillar_room(), {3, 3});
  const TetherRun r = run(p, {{3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 3}});
  EXPECT_EQ(r.bends_max, 3u);
  EXPECT_NEAR(r.longest_m, 2 * std::sqrt(10) + 4, 1e-12);
  EXPECT_EQ(r.longest_m, r.end_m);
  EXPECT_EQ(r.geodesic_m, 0);
  EXPECT_TRUE(r.crossings.empty()) << "home at the anchor there is nothing to cross";
  const TetherRun home = run(p, {{3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 3}, {3, 7}, {7, 7}, {7, 3}, {3, 3}});
  EXPECT_EQ(home.end_m, 0);
  EXPECT_EQ(home.longest_m, r.longest_m);
  EXPECT_TRUE(home.crossings.empty());
}

// An arc about a pillar: the tether winds about its corners as the robot goes round.
TEST(Tether, CircleAboutAHexagon) {
  Region room = box_region({-5, -5}, {5, 5});
  Ring hexagon;
  for (int k = 6; k-- > 0;) hexagon.push_back(rotated({1, 0}, k * kPi / 3));
  room.polygons[0].holes.push_back(hexagon);
  const Problem p = leashed(room, {0, -3});
  Polyline walk = arc({0, 0}, 3, -kPi / 2, 3 * kPi / 2 - 0.4, 300);
  walk[0] = {0, -3};
  const TetherRun r = run(p, walk);
  // From (0, -3) to the corner (1, 0), along the sides to the corner that the robot's tangent touches.
  const double angle = 3 * kPi / 2 - 0.4;
  const Point robot = rotated({3, 0}, angle);
  double best = 1e9;
  std::size_t bends = 0;
  for (int sides = 2; sides < 6; ++sides) {
    const Point last = rotated({1, 0}, sides * kPi / 3);
    const double length = distance({0, -3}, {1, 0}) + sides + distance(last, robot);
    if (!EdgeIndex(room).contains(last, robot) || length > best) continue;
    best = length;
    bends = static_cast<std::size_t>(sides) + 1;
  }
  EXPECT_NEAR(r.end_m, best, 1e-9);
  EXPECT_EQ(r.bends_max, bends);
}

Polyline laps(int n) {
  Polyline walk{{1, 5}, {3, 5}};
  for (int k = 0; k < n; ++k) append(walk, {{3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 5}});
  return walk;
}

// Each lap crosses the tether's first segment, (1, 5) to (4, 4), at x = 3; so does each lap back.
TEST(Tether, LapsCrossOnceEach) {
  const Problem p = leashed(pillar_room(), {1, 5});
  EXPECT_EQ(crossings(p, laps(0)), 0u);
  for (int n : {1, 2, 3}) {
    Polyline walk = laps(n);
    walk.push_back({3, 3});
    const TetherRun r = run(p, walk);
    ASSERT_EQ(r.crossings.size(), static_cast<std::size_t>(n));
    EXPECT_NEAR(r.crossings[0].at.x(), 3, 1e-12);
    EXPECT_NEAR(r.crossings[0].at.y(), 5 - 2.0 / 3, 1e-12);
    EXPECT_NEAR(r.crossings[0].path_m, 2 + 2 + 4 + 4 + 4 + 2 + 2.0 / 3, 1e-12);
    EXPECT_EQ(r.bends_max, static_cast<std::size_t>(4 * n));
    Polyline there_and_back = walk;
    there_and_back.insert(there_and_back.end(), walk.rbegin() + 1, walk.rend());
    const TetherRun back = run(p, there_and_back);
    EXPECT_EQ(back.crossings.size(), 2 * static_cast<std::size_t>(n));
    EXPECT_EQ(back.end_m, 0);
    EXPECT_EQ(back.bends_max, r.bends_max);
  }
}

// The tether lies along y = 4 from the anchor (0, 4) to the corner (6, 4); the robot comes from above.
TEST(Tether, TouchingIsNoCrossing) {
  const Problem p = leashed(pillar_room(), {0, 4});
  const auto after = [&](const Polyline& more) {
    Polyline walk{{0, 4}, {0, 3}, {7, 3}, {7, 7}, {2, 7}};
    append(walk, more);
    return crossings(p, walk);
  };
  EXPECT_EQ(after({{2, 1}}), 1u);
  EXPECT_EQ(after({{2, 4}, {2, 1}}), 1u) << "a vertex on it";
  EXPECT_EQ(after({{2, 4}, {1, 7}}), 0u) << "there and away again";
  EXPECT_EQ(after({{2, 4}}), 0u) << "only there";
  EXPECT_EQ(after({{2, 4}, {3, 4}, {3, 1}}), 1u) << "along it";
  EXPECT_EQ(after({{2, 4}, {3, 4}, {1, 4}, {1, 3}}), 1u) << "along it to and fro";
  EXPECT_EQ(after({{2, 4}, {3, 4}, {3, 7}}), 0u) << "along it and away again";
  EXPECT_EQ(after({{2, 4}, {1, 4}, {0, 4}, {0, 1}}), 0u) << "past its end, along it";
  EXPECT_EQ(after({{0, 7}, {0, 1}}), 0u) << "over the anchor";
  EXPECT_EQ(after({{2, 4}, {2, 3}, {2, 4}, {2, 7}}), 2u);
  EXPECT_EQ(after({{2, 1}, {2, 7}, {2, 1}}), 3u);
}

// A point robot goes down the pillar's wall and over the corner (4, 4), about which the tether bends.
TEST(Tether, OverABend) {
  const Problem p = leashed(pillar_room(), {1, 5}, {}, 1000, 0);
  const auto after = [&](const Polyline& more) {
    Polyline walk{{1, 5}, {3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 5.5}, {4, 5}};
    append(walk, more);
    return crossings(p, walk);
  };
  EXPECT_EQ(after({{4, 3}}), 1u);
  EXPECT_EQ(after({{4, 4}, {4, 3}}), 1u);
  EXPECT_EQ(after({{4, 4}, {3.5, 5}}), 0u);
  EXPECT_EQ(after({{4, 4}, {4, 5}}), 0u);
  EXPECT_EQ(after({{4, 4}, {1.75, 4.75}, {1, 6}}), 0u) << "from the bend along the tether, and up again";
  EXPECT_EQ(after({{4, 4}, {1.75, 4.75}, {1, 4}}), 1u) << "and down";
}

// Two rounds about two pillars: both layers of the tether between them are crossed at one point.
TEST(Tether, LayersCountOnce) {
  Region r = box_region({0, 0}, {14, 10});
  r.polygons[0].holes.push_back({{3, 4}, {3, 6}, {5, 6}, {5, 4}});
  r.polygons[0].holes.push_back({{9, 4}, {9, 6}, {11, 6}, {11, 4}});
  const Problem p = leashed(r, {7, 1});
  Polyline walk{{7, 1}};
  for (int k = 0; k < 2; ++k) append(walk, {{12, 2}, {12, 8}, {2, 8}, {2, 2}});
  append(walk, {{7, 2}, {12, 2}, {12, 8}, {7, 8}});
  const std::size_t before = crossings(p, walk);
  walk.push_back({7, 5});  // over the upper layers, y = 6
  EXPECT_EQ(crossings(p, walk), before + 1);
  walk.push_back({7, 2});  // and the lower ones, y = 4
  EXPECT_EQ(crossings(p, walk), before + 2);
}

TEST(Tether, AnchorAwayFromTheStartBeginsAsTheGeodesic) {
  const Problem p = leashed(pillar_room(), {7, 5}, Point(0, 4.5));
  const TetherRun r = run(p, {{7, 5}, {7, 5}});
  const double below = distance({0, 4.5}, {4, 4}) + 2 + std::sqrt(2);
  EXPECT_NEAR(r.longest_m, below, 1e-12);
  EXPECT_EQ(r.bends_max, 2u);
  EXPECT_EQ(r.path_m, 0);
  // Round the other walk it winds off.
  EXPECT_NEAR(run(p, {{7, 5}, {7, 3}, {2, 3}}).end_m, distance({0, 4.5}, {2, 3}), 1e-12);
}

TEST(Tether, ColumnsAreEmptyWithoutOne) {
  const Score s = score(problem_in(pillar_room(), {1, 1}), work({{1, 1}, {9, 1}}));
  std::size_t columns = 0;
  for (std::size_t i = 0; i < s.values.size(); ++i)
    if (s.values[i].name.starts_with("tether_")) {
      ++columns;
      EXPECT_FALSE(s.values[i].value) << s.values[i].name;
    }
  EXPECT_EQ(columns, 8u);
}

TEST(Tether, Columns) {
  const Problem p = leashed(pillar_room(), {1, 5}, {}, 40);
  Polyline walk = laps(1);
  walk.push_back({3, 3});
  const Score s = score(p, work(walk));
  EXPECT_EQ(s.flaw, "");
  EXPECT_EQ(s.value("tether_limit_m"), 40);
  EXPECT_NEAR(*s.value("tether_max_m"), std::sqrt(10) + 6 + std::sqrt(10), 1e-12);
  EXPECT_EQ(s.value("tether_bends_max"), 4);
  EXPECT_EQ(s.value("tether_angle_min_rad"), 0);
  EXPECT_EQ(s.value("tether_crossings"), 1);
  EXPECT_EQ(s.value("tether_entangled"), 1);
  const TetherRun r = run(p, walk);
  EXPECT_EQ(s.value("tether_angle_mean_rad"), mean_angle(r));
  EXPECT_EQ(s.value("tether_sharp_fraction"), r.sharp_m / r.path_m);
  walk.pop_back();
  append(walk, {{3, 7}, {7, 7}, {7, 3}, {3, 3}});
  EXPECT_EQ(score(p, work(walk)).value("tether_entangled"), 0);
  const Score still = score(p, work({{1, 5}, {1, 5}}));
  EXPECT_EQ(still.value("tether_max_m"), 0);
  EXPECT_FALSE(still.value("tether_angle_min_rad") || still.value("tether_angle_mean_rad"));
}

TEST(Tether, NoStringFollowsThroughWallsOrJumps) {
  const Problem p = leashed(pillar_room(), {1, 5});
  for (const Path& path : {work({{1, 5}, {9, 5}}), work({{1, 5}, {-3, 5}}), work({{2, 5}, {1, 5}}),
                           Path{{Leg{true, {{1, 5}, {2, 5}}}, Leg{true, {{2, 6}, {2, 7}}}}}}) {
    const Score s = score(p, path);
    EXPECT_NE(s.flaw, "");
    EXPECT_EQ(s.value("tether_limit_m"), 1000);
    EXPECT_FALSE(s.value("tether_max_m") || s.value("tether_crossings") || s.value("tether_entangled"));
  }
  // Too near a wall for the robot, but a tether follows: measured.
  EXPECT_NEAR(*score(p, work({{1, 5}, {3.9, 5}})).value("tether_max_m"), 2.9, 1e-12);
}

TEST(Tether, OverTheLimitIsAFlaw) {
  const Path path = work({{3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 3.5}, {3, 4}});
  const double most = std::sqrt(10) + 4 + std::hypot(1, 2.5);
  const std::string flaw = "pulls its tether to 9.85486 m at (3, 3.5), 0.355 m over its limit 9.5 m";
  const Problem p = leashed(pillar_room(), {3, 3}, {}, 9.5);
  EXPECT_EQ(score(p, path).flaw, flaw);
  EXPECT_EQ(find_flaw(p, path), flaw);
  ScoreOptions measured_only;
  measured_only.tether_counts = false;
  EXPECT_EQ(find_flaw(p, path, measured_only), "");
  const Score s = score(p, path, measured_only);
  EXPECT_EQ(s.flaw, "");
  EXPECT_NEAR(*s.value("tether_max_m"), most, 1e-12);
  EXPECT_EQ(find_flaw(leashed(pillar_room(), {3, 3}, {}, most - 3e-7), path), "") << "rounding is no sin";
  EXPECT_NE(find_flaw(leashed(pillar_room(), {3, 3}, {}, most - 6e-7), path), "");
  // Walls come first.
  EXPECT_THAT(find_flaw(p, work({{3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 3.5}, {5, 3.5}, {5, 5}})),
              testing::StartsWith("leaves configuration space"));
}

// Maps and walks: the same figures wherever the map lies, however it is turned, however finely the path is cut.
TEST(Tether, Invariances) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region map = pillars(rng, 6);
    const Point start(0.5, 0.5);
    const Problem p = leashed(map, start);
    const Polyline walk = free_walk(p, rng, 60, 4);
    const TetherRun base = run(p, walk);
    const auto expect_same = [&](const TetherRun& r) {
      EXPECT_NEAR(r.longest_m, base.longest_m, 1e-9);
      EXPECT_EQ(r.bends_max, base.bends_max);
      EXPECT_NEAR(r.angle_sum, base.angle_sum, 1e-8);
      EXPECT_NEAR(r.angle_min, base.angle_min, 1e-7);
      EXPECT_NEAR(r.sharp_m, base.sharp_m, 1e-8);
      EXPECT_NEAR(r.end_m, base.end_m, 1e-9);
      EXPECT_NEAR(r.geodesic_m, base.geodesic_m, 1e-9);
      EXPECT_EQ(r.crossings.size(), base.crossings.size());
    };
    Polyline fine;
    for (std::size_t i = 1; i < walk.size(); ++i)
      for (int k = 0; k < 7; ++k) fine.push_back(lerp(walk[i - 1], walk[i], k / 7.0));
    fine.push_back(walk.back());
    expect_same(run(p, fine));

    const auto moved_run = [&](auto move, bool mirrored) {
      Region there = map;
      for (Polygon& polygon : there.polygons) {
        const auto change = [&](Ring& ring) {
          for (Point& q : ring) q = move(q);
          if (mirrored) std::reverse(ring.begin(), ring.end());
        };
        change(polygon.outer);
        for (Ring& hole : polygon.holes) change(hole);
      }
      Polyline path;
      for (const Point& q : walk) path.push_back(move(q));
      expect_same(run(leashed(there, move(start)), path));
    };
    moved_run([](const Point& q) { return Point(q.x() + 1024, q.y() - 512); }, false);
    moved_run([](const Point& q) { return perpendicular(q); }, false);
    moved_run([](const Point& q) { return Point(-q.x(), q.y()); }, true);
    moved_run([](const Point& q) { return rotated(q, 0.7); }, false);
  }
}

// A point robot that drives along walls, through corners and over bends of its own tether: what counts as a crossing
// does not depend on how the map is turned, although ties are broken by a shift in a fixed direction.
TEST(Tether, CrossingsAtBendsDoNotDependOnTheDirection) {
  std::size_t crossings = 0;
  for (const auto seed : seeds(150)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Region map = box_region({0, 0}, {12, 12});  // square pillars with corners on integers
    for (double y = 2; y < 11; y += 3)
      for (double x = 2; x < 11; x += 3)
        if (rng.chance(0.7)) map.polygons[0].holes.push_back({{x, y}, {x, y + 1}, {x + 1, y + 1}, {x + 1, y}});
    const auto lattice_point = [&] { return Point(rng.between(0, 12), rng.between(0, 12)); };
    const Problem p = leashed(map, {0, 0}, {}, 1000, 0);
    Polyline walk{p.start()};
    while (walk.size() < 40)
      if (const Point to = lattice_point(); contains(map, to) || p.walls().on_boundary(to)) {
        const auto part = p.transit().path(walk.back(), to);
        walk.insert(walk.end(), part->begin() + 1, part->end());
      }
    const std::size_t expected = run(p, walk).crossings.size();
    crossings += expected;
    const std::vector<std::function<Point(const Point&)>> moves{
        [](const Point& q) { return perpendicular(q); }, [](const Point& q) { return Point(-q); },
        [](const Point& q) { return Point(-perpendicular(q)); }};
    for (const auto& move : moves) {
      Region there = map;
      for_each_ring(there, [&](Ring& ring) {
        for (Point& q : ring) q = move(q);
      });
      Polyline path;
      for (const Point& q : walk) path.push_back(move(q));
      EXPECT_EQ(run(leashed(there, move(p.start()), {}, 1000, 0), path).crossings.size(), expected);
    }
  }
  EXPECT_GT(crossings, 100u);
}

TEST(TetherTolerance, ReachesTheTether) {
  const ScoreOptions millimetre{.tolerance = 1e-3};
  const Problem p = leashed(pillar_room(), {1, 1}, Point{0, 1}, 8);
  // A start and a joint that are half a millimetre off.
  const Path path{{Leg{true, {{1.0005, 1}, {9, 1}}}, Leg{true, {{9, 1.0005}, {9, 5}}}}};
  const double longest = distance({0, 1}, {9, 5});  // below the pillar
  EXPECT_FALSE(score(p, path).value("tether_max_m").has_value());
  EXPECT_NEAR(score(p, path, millimetre).value("tether_max_m").value(), longest, 1e-9);
  EXPECT_THAT(find_flaw(p, path, millimetre), testing::HasSubstr("over its limit 8 m"));
  for (const double over : {-0.5e-3, 0.99e-3})
    EXPECT_EQ(find_flaw(leashed(pillar_room(), {1, 1}, Point{0, 1}, longest - over), path, millimetre), "") << over;
  EXPECT_NE(find_flaw(leashed(pillar_room(), {1, 1}, Point{0, 1}, longest - 1.01e-3), path, millimetre), "");
}

// Of a robot with a radius, and of a point robot, whose rounded walks run through corners of the pillars.
TEST(TetherTolerance, RoundedWalksHaveTheTethersOfTheOriginals) {
  for (const double radius : {0.2, 0.0}) {
    for (const auto seed : seeds(25)) {
      SCOPED_TRACE(fmt::format("radius {}, seed {}", radius, seed));
      Rng rng(seed);
      const Problem p = leashed(pillars(rng, 5), {0.5, 0.5}, {}, 1000, radius);
      Polyline walk{p.start()}, rough;
      for (const Point& to : free_walk(p, rng, 25, 6)) {  // through the corners, as a taut path goes
        const auto part = p.transit().path(walk.back(), to);
        walk.insert(walk.end(), part->begin() + 1, part->end());
        const auto corner = p.transit().path(to, p.start());
        walk.insert(walk.end(), corner->begin() + 1, corner->end());
      }
      for (const Point& at : walk) rough.push_back((at * 1000).array().round() / 1000);
      const Score exact = score(p, work(walk)), near = score(p, work(rough), {.tolerance = 1e-3});
      ASSERT_EQ(exact.flaw, "");
      ASSERT_EQ(near.flaw, "");
      EXPECT_NEAR(near.value("tether_max_m").value(), exact.value("tether_max_m").value(), 1e-3);
      EXPECT_EQ(near.value("tether_entangled"), exact.value("tether_entangled"));
    }
  }
}

}  // namespace
}  // namespace oxturn
