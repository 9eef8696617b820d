#include "algorithms/improve/improve.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "algorithms/improve/annealing.hpp"
#include "algorithms/improve/completion.hpp"
#include "algorithms/improve/detours.hpp"
#include "algorithms/improve/moves.hpp"
#include "algorithms/improve/wall_following.hpp"
#include "algorithms/improve/witnesses.hpp"
#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Point random_point(const Box& box, Rng& rng) {
  const double x = rng.between(box.low.x(), box.high.x()), y = rng.between(box.low.y(), box.high.y());
  return {x, y};
}

Polyline random_line(std::size_t n, const Box& box, Rng& rng) {
  Polyline line;
  for (std::size_t k = 0; k < n; ++k) line.push_back(random_point(box, rng));
  return line;
}

double length_of(const VertexPath& path) { return length(path.points()); }

// The area that is left against a count of sampled points by their distance from the path.
TEST(Witnesses, CountWhatIsFartherThanTheRadius) {
  const Region hall = box_region({0, 0}, {6, 4});
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Box around{{-1, -1}, {7, 5}};
    Polyline line = random_line(2 + rng.below(6), around, rng);
    if (rng.chance(0.5)) line[1] = line[0];                                  // a disc
    if (rng.chance(0.5)) line.back() = line[line.size() - 2] + Point(1, 0);  // runs along no row, but along a wall
    const double radius = rng.between(0.1, 0.8), cell = 0.02;
    Witnesses witnesses(hall, cell, radius);
    Witnesses::Capsule capsule;
    for (std::size_t i = 1; i < line.size(); ++i) {
      witnesses.capsule(line[i], line[i - 1], capsule);
      witnesses.add(capsule);
    }
    long uncovered = 0, all = 0;
    for (double x = cell / 2; x < 6; x += cell)
      for (double y = cell / 2; y < 4; y += cell) {
        double nearest = 1e9;
        for (std::size_t i = 1; i < line.size(); ++i)
          nearest = std::min(nearest, distance_to_segment({x, y}, line[i - 1], line[i]));
        ++all;
        uncovered += nearest > radius;
      }
    EXPECT_NEAR(static_cast<double>(witnesses.points()), static_cast<double>(all), 2e-3 * static_cast<double>(all));
    EXPECT_NEAR(static_cast<double>(witnesses.uncovered()), static_cast<double>(uncovered),
                2e-3 * static_cast<double>(all));
  }
}

TEST(Witnesses, UncoveredPointsAreThoseFarFromThePath) {
  const Region hall = box_region({1, 2}, {7, 6});
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Polyline line = random_line(5, {{1, 2}, {7, 6}}, rng);
    const double radius = 0.8, cell = 0.05;
    Witnesses witnesses(hall, cell, radius);
    Witnesses::Capsule capsule;
    for (std::size_t i = 1; i < line.size(); ++i) {
      witnesses.capsule(line[i - 1], line[i], capsule);
      witnesses.add(capsule);
    }
    const auto far = [&](const Point& p) {
      double nearest = 1e9;
      for (std::size_t i = 1; i < line.size(); ++i)
        nearest = std::min(nearest, distance_to_segment(p, line[i - 1], line[i]));
      return nearest;
    };
    const std::vector<Point> all = witnesses.uncovered_points(1000000);
    for (const Point& p : all) {
      EXPECT_GT(far(p), radius - 1e-4);
      EXPECT_TRUE(contains(hall, p));
    }
    for (int k = 0; k < 200; ++k) {
      const Point p = random_point({{1.5, 2.5}, {6.5, 5.5}}, rng);
      if (far(p) < radius + 10 * cell) continue;
      const auto away = [&](const Point& q) { return distance(p, q); };
      EXPECT_LT(away(*std::ranges::min_element(all, {}, away)), 9 * cell);
    }
    EXPECT_LE(witnesses.uncovered_points(7).size(), 7);
  }
  Witnesses covered(box_region({0, 0}, {1, 1}), 0.05, 1);
  Witnesses::Capsule capsule;
  covered.capsule({0, 0}, {1, 1}, capsule);
  covered.add(capsule);
  EXPECT_TRUE(covered.uncovered_points(10).empty());
}

// A lane, and something beside it that no small change of the lane comes to cover.
TEST(Annealing, CoversWhatIsFarFromThePath) {
  const Region hall = box_region({0, 0}, {10, 8});
  const EdgeIndex walls(hall);
  const Region target = unite({box_region({2, 1.6}, {8, 2.4}), box_region({5, 3.4}, {5.1, 3.5})});
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Context context(seed);
    const Polyline lane{{1.5, 2}, {4, 2}, {6, 2}, {8.5, 2}};
    Witnesses witnesses(target, 0.02, 0.5);
    Witnesses::Capsule capsule;
    for (std::size_t i = 1; i < lane.size(); ++i) {
      witnesses.capsule(lane[i - 1], lane[i], capsule);
      witnesses.add(capsule);
    }
    ASSERT_GT(witnesses.uncovered(), 0);
    Annealing annealing(walls, VertexPath(lane, {0}, 1), witnesses, 1,
                        {.uncovered = 1e-4, .price = 1e3, .floating = false});
    annealing.run({.moves = 1000, .hot = 1e-3, .cold = 1e-3}, rng, context);
    EXPECT_LT(annealing.uncovered(), 1e-3);
  }
}

TEST(Witnesses, AnExchangeAndItsReverseCancel) {
  const Region hall = box_region({0, 0}, {6, 4});
  Witnesses witnesses(hall, 0.05, 0.3);
  const Box box{{0, 0}, {6, 4}};
  Rng rng(1);
  int possible = 0;
  for (int k = 0; k < 200; ++k) {
    std::array<Witnesses::Capsule, 3> removed, added;
    for (auto* set : {&removed, &added})
      for (auto& capsule : *set) {
        const Point a = random_point(box, rng);
        witnesses.capsule(a, a + Point(rng.between(-1, 1), rng.between(-1, 1)), capsule);
      }
    for (const auto& capsule : removed) witnesses.add(capsule);
    const long before = witnesses.uncovered(), most = static_cast<long>(rng.between(-500.0, 500.0));
    const bool may = witnesses.may_change(removed, added, most);
    possible += may;
    EXPECT_TRUE(witnesses.may_change(removed, added, witnesses.points()));
    EXPECT_FALSE(witnesses.may_change(removed, added, -before - 1));
    const long change = witnesses.exchange(removed, added);
    EXPECT_EQ(witnesses.uncovered(), before + change);
    EXPECT_TRUE(may || change > most);
    EXPECT_EQ(witnesses.exchange(added, removed), -change);
    witnesses.exchange(removed, {});
  }
  EXPECT_GT(possible, 20);
  EXPECT_LT(possible, 180);
  EXPECT_EQ(witnesses.uncovered(), witnesses.points());
}

// A lap round a pillar, some vertices left out and all of them off the wall, becomes the pillar's boundary again.
TEST(WallFollowing, ALapNearAWallRunsAlongIt) {
  Polyline pillar;
  for (int k = 0; k < 100; ++k) {
    const double angle = 2 * std::numbers::pi * k / 100;
    pillar.push_back(Point(5, 4) + Point(std::cos(angle), std::sin(angle)));
  }
  const EdgeIndex walls(subtract(box_region({0, 0}, {10, 8}), Region{{Polygon{pillar, {}}}}));
  for (const auto seed : seeds(50)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Polyline lap;
    for (std::size_t i = 0; i < pillar.size(); i += 1 + rng.below(3))
      lap.push_back(pillar[i] + rng.between(1e-5, 2e-3) * (pillar[i] - Point(5, 4)));
    const Polyline snapped = WallFollowing(walls).snapped(lap, 0.02);
    EXPECT_EQ(snapped.front(), lap.front());
    for (std::size_t i = 1; i < snapped.size(); ++i) EXPECT_TRUE(walls.contains(snapped[i - 1], snapped[i])) << i;
    for (std::size_t k = 0; k + 3 < pillar.size(); ++k) {
      double off = 1;
      for (std::size_t i = 1; i < snapped.size(); ++i)
        off = std::min(off, distance_to_segment(pillar[k], snapped[i - 1], snapped[i]));
      EXPECT_LT(off, 1e-7) << k;  // vertices of Booleans are rounded
    }
  }
}

// The feet of points beside a wall in any direction, rounded, lie on either side of it.
TEST(WallFollowing, RoundingLeavesNoVertexOffAWall) {
  for (const auto seed : seeds(50)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const EdgeIndex walls(transformed(box_region({0, 0}, {10, 8}), rng.between(0.0, 1.5), Point(1, 2)));
    const EdgeIndex::Edge& wall = walls.edges()[rng.below(walls.edges().size())];
    const Point in = perpendicular(wall.b - wall.a).normalized();
    Polyline line;
    for (double at = 0.1; at < 0.9; at += 0.05) line.push_back(lerp(wall.a, wall.b, at) + rng.between(1e-3, 0.01) * in);
    const Polyline snapped = WallFollowing(walls).snapped(line, 0.02);
    for (std::size_t i = 1; i + 1 < snapped.size(); ++i) EXPECT_LT(walls.nearest(snapped[i])->distance, 1e-7) << i;
    for (std::size_t i = 1; i < snapped.size(); ++i) EXPECT_TRUE(walls.contains(snapped[i - 1], snapped[i])) << i;
  }
}

// Random paths near walls stay inside and keep their ends.
TEST(WallFollowing, PathsStayInside) {
  const Region room =
      subtract(box_region({0, 0}, {10, 8}), unite({box_region({3, 2}, {5, 5}), box_region({7, 1}, {7.3, 6})}));
  const EdgeIndex walls(room);
  int changed = 0;
  for (const auto seed : seeds(300)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Polyline line;
    while (line.size() < 30) {
      const Point p = line.empty() ? Point(1, 1) : line.back() + random_point({{-1, -1}, {1, 1}}, rng);
      const auto near = walls.nearest(p);
      const Point at = near->point + rng.between(0.0, 0.3) * (p - near->point);
      if (walls.contains(at) && (line.empty() || walls.contains(line.back(), at))) line.push_back(at);
    }
    const Polyline snapped = WallFollowing(walls).snapped(line, 0.3);
    EXPECT_EQ(snapped.front(), line.front());
    EXPECT_EQ(snapped.back(), line.back());
    for (std::size_t i = 1; i < snapped.size(); ++i) EXPECT_TRUE(walls.contains(snapped[i - 1], snapped[i])) << i;
    changed += snapped != line;
  }
  EXPECT_GT(changed, 100);
}

TEST(WallFollowing, FarFromWallsNothingChanges) {
  const EdgeIndex walls(box_region({0, 0}, {10, 8}));
  Rng rng(1);
  const Polyline line = random_line(200, {{1, 1}, {9, 7}}, rng);
  EXPECT_EQ(WallFollowing(walls).snapped(line, 0.5), line);
}

/// A room whose configuration space is 10 x 8 m from the origin on; the tool reaches as far as the robot.
Problem wide_room() {
  Robot robot;
  robot.radius = 0.5;
  robot.tool_width = 1;
  return Problem({"room", box_region({-0.5, -0.5}, {10.5, 8.5}), "test", ""}, robot, Point(1, 4));
}

Polyline detoured(const Problem& problem, const Polyline& path, const std::vector<ToCover>& pieces, double enough) {
  return with_detours(path, pieces, enough, 0, 0.5, Connector(problem), problem.walls()).path;
}

double distance_to_line(const Point& p, const Polyline& line) {
  double least = distance(p, line.front());
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

// Two squares beside a straight path: the one that takes the shorter detour for its area comes first, and where either
// is enough, only that.
TEST(Detours, CoverAsMuchAsIsAskedForOnTheShortestLength) {
  const Problem problem = wide_room();
  const Polyline path{{1, 4}, {9, 4}};
  const auto square = [](double x, double y) {
    const Polygon piece = box_region({x, y}, {x + 0.1, y + 0.1}).polygons.front();
    return ToCover{piece, {piece}};
  };
  const std::vector<ToCover> pieces{square(3, 4.75), square(6, 4.55)};
  const double reach = 0.5;
  const auto detour = [&](double high) { return 2 * (high - 4 - std::sqrt(reach * reach - 0.05 * 0.05)); };
  EXPECT_NEAR(length(detoured(problem, path, pieces, 0.005)), 8 + detour(4.65), 1e-6);
  EXPECT_NEAR(length(detoured(problem, path, pieces, 1)), 8 + detour(4.65) + detour(4.85), 1e-6);
  EXPECT_EQ(detoured(problem, path, pieces, 0), path);
}

// The best one for its length is not worth it where another one is needed all the same, and enough.
TEST(Detours, TheLastOneMayStandForThoseBeforeIt) {
  const Problem problem = wide_room();
  const Polyline path{{1, 4}, {9, 4}};
  const auto piece = [](double x, double size) {
    const Polygon square = box_region({x, 4.5}, {x + size, 4.5 + size}).polygons.front();
    return ToCover{square, {square}};
  };
  const Polyline with_large = detoured(problem, path, {piece(6, 0.3)}, 0.08);
  EXPECT_EQ(detoured(problem, path, {piece(3, 0.01), piece(6, 0.3)}, 0.08), with_large);
  EXPECT_GT(length(detoured(problem, path, {piece(3, 0.01), piece(6, 0.3)}, 0.09005)), length(with_large));
}

// No single position covers what lies along a wall.
TEST(Detours, AStrokeCoversAPieceAlongAWall) {
  const Problem problem = wide_room();
  const Polyline path{{1, 0.6}, {9, 0.6}};
  const Polygon piece = box_region({3, -0.5}, {3.4, -0.1}).polygons.front();
  const Polyline with_stroke = detoured(problem, path, {{piece, {piece}}}, 1);
  EXPECT_LT(length(with_stroke), 8 + 0.6 + 0.4 + std::hypot(0.6, 0.4) + 1e-6);
  EXPECT_GT(length(with_stroke), 8 + 2 * std::hypot(0.6, 0.2) + 0.4 - 1e-4);
  for (const Point& p : piece.outer) EXPECT_LT(distance_to_line(p, with_stroke), 0.5 + 1e-5);
  for (std::size_t i = 1; i < with_stroke.size(); ++i)
    EXPECT_TRUE(problem.walls().contains(with_stroke[i - 1], with_stroke[i])) << i;
}

// A ring's part round a pillar, as a lap that lacks a quarter leaves it: the stroke follows the pillar.
TEST(Detours, AStrokeFollowsARoundWall) {
  Polyline pillar;
  for (int k = 0; k < 60; ++k) {
    const double angle = 2 * std::numbers::pi * k / 60;
    pillar.push_back(Point(5, 4) + 0.5 * Point(std::cos(angle), std::sin(angle)));
  }
  Robot robot;
  robot.radius = 0.5;
  robot.tool_width = 1;
  const Region free = subtract(box_region({0, 0}, {10, 8}), Region{{Polygon{pillar, {}}}});
  const Problem problem({"pillar", free, "test", ""}, robot, Point(6.2, 4));
  const auto round = [](double radius, double angle) {
    return Point(Point(5, 4) + radius * Point(std::cos(angle), std::sin(angle)));
  };
  Polygon piece;
  for (int k = 0; k <= 20; ++k) piece.outer.push_back(round(0.6, k * std::numbers::pi / 40));
  for (int k = 20; k >= 0; --k) piece.outer.push_back(round(0.51, k * std::numbers::pi / 40));
  const Polyline path{{6.2, 4}, {6.2, 3}};
  const Polyline with_stroke = detoured(problem, path, {{piece, {piece}}}, 1);
  for (const Point& p : piece.outer) EXPECT_LT(distance_to_line(p, with_stroke), 0.5 + 1e-3);
  EXPECT_LT(length(with_stroke), 1 + 2 * (0.2 + std::numbers::pi / 2));
  for (std::size_t i = 1; i < with_stroke.size(); ++i)
    EXPECT_TRUE(problem.walls().contains(with_stroke[i - 1], with_stroke[i])) << i;
}

// Against the path's own length and turns; fixed vertices and the edge between two of them stay.
TEST(Moves, ChangeThePathAsTheySay) {
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Polyline start = random_line(4 + rng.below(60), Box{{0, 0}, {3, 3}}, rng);
    std::vector<std::size_t> fixed{0};
    if (rng.chance(0.5)) fixed.push_back(start.size() - 1);
    if (start.size() > 9) fixed.insert(fixed.end(), {5, 6});
    VertexPath path(start, fixed, 0.4);
    const EdgeIndex walls(box_region({0, 0}, {3, 3}));
    Moves moves({.width = 0.4, .cut_short = rng.chance(0.5)}, walls);
    moves.focus({{1, 1}, {2, 2}});
    moves.uncovered({{1.5, 1.5}, {0.05, 2.9}});
    for (int k = 0; k < 300 && path.size() > 1; ++k) {
      const auto change = moves.propose(path, rng);
      if (!change) continue;
      const double before = length_of(path), turns = turning(path.points()), turning_change = change->turning(path);
      change->apply(path);
      ASSERT_NEAR(length_of(path), before + change->added.length() - change->removed.length(), 1e-9);
      ASSERT_NEAR(turning(path.points()), turns + turning_change, 1e-9);
      ASSERT_EQ(path[0], start[0]);
      const Polyline now = path.points();
      for (const std::size_t f : fixed) ASSERT_NE(std::ranges::find(now, start[f]), now.end());
      if (fixed.size() > 1 && fixed[1] + 1 == start.size()) { ASSERT_EQ(now.back(), start.back()); }
      if (start.size() > 9) {  // an edge between two of them stays
        const auto at = std::ranges::find(now, start[5]);
        ASSERT_TRUE((at + 1 != now.end() && at[1] == start[6]) || at[-1] == start[6]);
      }
      for (std::size_t i = 0; i < path.size(); i += 7) ASSERT_TRUE(path.near(path[i], rng).has_value());
    }
  }
}

// No vertex of a loop around an obstacle can leave by itself; all of them can, where the ends are near each other.
TEST(Moves, LoopsAroundObstaclesAreLeftOut) {
  const EdgeIndex walls(box_region({0, 0}, {3, 3}));
  Polyline line{{0.2, 1}};
  for (int k = 0; k <= 12; ++k) {
    const double angle = -kPi / 2 + 2 * kPi * k / 12;
    line.emplace_back(1.5 + 0.4 * std::cos(angle), 1.4 + 0.4 * std::sin(angle));
  }
  line.emplace_back(2.8, 1);
  for (const bool cut_short : {false, true}) {
    const Moves moves({.width = 0.4, .cut_short = cut_short}, walls);
    for (const std::size_t fixed : {std::size_t{0}, std::size_t{7}}) {  // the start, or a vertex of the loop besides
      const VertexPath path(line, {0, fixed}, 0.4);
      Rng rng(1);
      int left_out = 0;
      double least = length(line);
      for (int k = 0; k < 5000; ++k) {
        const auto change = moves.propose(path, rng);
        if (!change || change->kind != Change::Kind::replace || change->point_count > 0) continue;
        left_out += change->last > change->first + 1;
        least = std::min(least, length(line) + change->added.length() - change->removed.length());
      }
      EXPECT_EQ(left_out > 0, cut_short) << fixed;
      EXPECT_EQ(least < 1.01 * distance(line.front(), line.back()), cut_short && fixed == 0) << fixed;
    }
  }
}

// Vertices cost nothing there: thousands would gather where moves are needed.
TEST(Moves, ShortEdgesGetNoMoreVertices) {
  const EdgeIndex walls(box_region({0, 0}, {3, 3}));
  const Moves moves({.width = 0.4}, walls);
  for (const auto& [spacing, any] : {std::pair(0.006, false), std::pair(0.02, true)}) {
    Polyline line;
    for (int k = 0; k < 100; ++k) line.emplace_back(1 + k * spacing, 1.5);
    const VertexPath path(line, {0}, 0.4);
    Rng rng(1);
    int more = 0;
    for (int k = 0; k < 2000; ++k)
      if (const auto change = moves.propose(path, rng); change && change->kind == Change::Kind::replace)
        more += change->first + change->point_count > change->last;
    EXPECT_EQ(more > 0, any) << spacing;
  }
}

// In windows, most vertices beside their sides are fixed: of single draws, two of three would find no move.
TEST(Moves, AreDrawnAgainWhereThereAreNone) {
  const EdgeIndex walls(box_region({0, 0}, {3, 3}));
  const Moves moves({.width = 0.4}, walls);
  Polyline line;
  std::vector<std::size_t> fixed;
  for (std::size_t k = 0; k < 100; ++k) {
    line.emplace_back(1 + 0.01 * static_cast<double>(k), 1.5 + 0.02 * static_cast<double>(k % 2));
    if (k < 60) fixed.push_back(k);
  }
  const VertexPath path(line, fixed, 0.4);
  Rng rng(1);
  int none = 0;
  for (int k = 0; k < 2000; ++k) none += moves.propose(path, rng) ? 0 : 1;
  EXPECT_LT(none, 700);
}

struct Sample {
  Problem problem;
  std::string name;
};

std::vector<Sample> samples(int each) {
  std::vector<Sample> all;
  for (const char* kind : {"polygon", "rooms", "clutter", "cave", "maze", "comb"})
    for (const auto seed : seeds(each)) {
      Rng rng(mix(seed, kind));
      const double radius = rng.between(0.15, 0.25), width = 2 * radius * rng.between(0.5, 2.5);
      Settings size{{"width", rng.between(7.0, 9.0)}, {"height", rng.between(6.0, 8.0)}};
      if (kind == std::string("polygon")) size["corners"] = std::int64_t{14};
      if (kind == std::string("comb")) size["aisles"] = std::int64_t{4};
      all.push_back(
          {Problem(generate(kind, size, seed), disc(radius, width)), fmt::format("{} {} tool {}", kind, seed, width)});
    }
  return all;
}

TEST(Shortest, CoversAsMuchAsItIsAskedForAndIsNeverLongerThanItsStart) {
  for (const Sample& sample : samples(2)) {
    SCOPED_TRACE(sample.name);
    const double start = plan("boustrophedon", sample.problem).length();
    for (const double coverage : {1.0, 0.97}) {
      const Path path = plan("shortest", sample.problem, {{"coverage", coverage}, {"moves", 10000}});
      expect_valid(sample.problem, path);
      EXPECT_LE(path.length(), 1.01 * start);  // seams are left there, but not here
      const Score s = score(sample.problem, path);
      EXPECT_GE(*s.value("coverage"), coverage - 2e-3);
      EXPECT_LE(*s.value("bound_m"), path.length());
    }
  }
}

// The first path offered is the first start with its detours, each later one is shorter, the last one is the result,
// and no start with its detours is shorter than that.
TEST(Improved, OnlyShorterPathsFollowTheStart) {
  int better = 0;
  for (const Sample& sample : samples(1))
    for (const double coverage : {1.0, 0.9}) {
      std::vector<PathToImprove> starts;
      std::vector<double> completed;
      const Completion completion(sample.problem, coverage);
      for (const char* planner : {"stc", "boustrophedon"}) {
        starts.push_back({plan(planner, sample.problem)});
        const Polyline points = vertices_of(starts.back().path, sample.problem.start());
        Context context;
        completed.push_back(length(completion.completed(points, completion.uncovered(points), context)));
      }
      SCOPED_TRACE(fmt::format("{} coverage {}", sample.name, coverage));
      std::vector<double> offered;
      Context::Sinks sinks;
      sinks.publish = [&](const Path& path) { offered.push_back(path.length()); };
      Context context(1, 1e9, sinks);
      const Path path = improved(sample.problem, starts, {.coverage = coverage, .moves = 3000}, context);
      ASSERT_FALSE(offered.empty());
      EXPECT_NEAR(offered.front(), completed.front(), 1e-9 * completed.front());
      for (std::size_t k = 1; k < offered.size(); ++k) EXPECT_LT(offered[k], offered[k - 1]) << k;
      EXPECT_EQ(offered.back(), path.length());
      for (const double start : completed) EXPECT_LE(path.length(), start * (1 + 1e-12));
      better += path.length() < 0.99 * std::ranges::min(completed);
    }
  EXPECT_GT(better, 3);
}

// Turns cost time: the path that takes the least is not the shortest one.
TEST(Shortest, ItsObjectiveMayBeTime) {
  double short_m = 0, short_s = 0, quick_m = 0, quick_s = 0;
  for (const auto seed : seeds(3)) {
    const Problem room(generate("polygon", {{"width", 5.0}, {"height", 4.0}, {"corners", std::int64_t{10}}}, seed),
                       disc(0.2, 0.4));
    const auto with = [&](const char* objective) {
      return plan("shortest", room, {{"coverage", 0.97}, {"moves", 40000}, {"objective", std::string(objective)}});
    };
    const Path short_path = with("length"), quick_path = with("time");
    expect_valid(room, quick_path);
    const Score by_length = score(room, short_path), by_time = score(room, quick_path);
    EXPECT_GE(*by_time.value("coverage"), 0.97);
    short_m += short_path.length();
    quick_m += quick_path.length();
    short_s += *by_length.value("mission_s");
    quick_s += *by_time.value("mission_s");
  }
  EXPECT_LT(quick_s, 0.98 * short_s);
  EXPECT_GT(quick_m, short_m);
}

// Detours to the last corners are many small turns, which cost less time than their angles say.
TEST(Shortest, ItsObjectiveMayBeTimeWhereAllIsCovered) {
  double start_s = 0, short_s = 0, quick_s = 0;
  for (const std::uint64_t seed : {100, 101}) {
    const Problem maze(generate("maze", {{"width", 8.0}, {"height", 7.0}}, seed), disc(0.2, 0.4));
    const auto seconds = [&](const Path& path) { return *score(maze, path).value("mission_s"); };
    const auto with = [&](const char* objective) {
      return plan("shortest", maze, {{"moves", 60000}, {"objective", std::string(objective)}});
    };
    const double start = seconds(plan("boustrophedon", maze)), quick = seconds(with("time"));
    EXPECT_LE(quick, start) << seed;
    start_s += start;
    quick_s += quick;
    short_s += seconds(with("length"));
  }
  EXPECT_LT(quick_s, 0.97 * start_s);
  EXPECT_LT(quick_s, short_s);
}

// The weight leads from one objective to the other: its ends are these, bit by bit.
TEST(Shortest, ItsObjectiveMayBeAWeightedSum) {
  const Problem room(generate("polygon", {{"width", 5.0}, {"height", 4.0}, {"corners", std::int64_t{10}}}, 1),
                     disc(0.2, 0.4));
  const auto with = [&](const char* objective, double weight) {
    return plan("shortest", room,
                {{"coverage", 0.97}, {"moves", 20000}, {"objective", std::string(objective)}, {"time_weight", weight}});
  };
  EXPECT_EQ(bytes(with("weighted", 0)), bytes(with("length", 0.7)));
  EXPECT_EQ(bytes(with("weighted", 1)), bytes(with("time", 0.7)));
  const Path half = with("weighted", 0.5), brief = with("length", 0.5);
  expect_valid(room, half);
  const auto turns = [&](const Path& path) { return turning(vertices_of(path, room.start())); };
  EXPECT_LT(turns(half), 0.9 * turns(brief));
  const double half_turn = 0.5 * room.robot().speed / room.robot().turn_rate;
  EXPECT_LT(half.length() + half_turn * turns(half), brief.length() + half_turn * turns(brief));
}

TEST(Polished, IsNeverLongerThanThePlannersPath) {
  for (const char* inner : {"stc", "contour", "random-walk"})
    for (const Sample& sample : samples(1)) {
      SCOPED_TRACE(sample.name + " " + inner);
      const double start = plan("completed", sample.problem, {{"planner", std::string(inner)}}).length();
      const Path path = plan("polished", sample.problem, {{"planner", std::string(inner)}, {"moves", 5000}});
      expect_valid(sample.problem, path);
      EXPECT_LE(path.length(), 1.01 * start);  // seams are left there, but not here
      EXPECT_GE(*score(sample.problem, path).value("coverage"), 0.998);
    }
}

// Hot annealing takes lanes that fit their field apart, and few moves do not bring them together again.
TEST(Polished, ShortensLanesThatFitTheirField) {
  double polished = 0, lanes = 0;
  for (const std::uint64_t seed : {21, 22, 23, 24, 25, 26}) {
    SCOPED_TRACE(seed);
    const Problem field(generate("field", {{"width", 24.0}, {"height", 16.0}, {"ponds", std::int64_t{5}}}, seed),
                        disc(0.2, 0.4));
    const Path path = plan("polished", field, {{"coverage", 0.9999}, {"moves", 40000}});
    expect_valid(field, path);
    const double before = plan("boustrophedon", field).length();
    EXPECT_LT(path.length(), before);
    polished += path.length();
    lanes += before;
  }
  EXPECT_LT(polished, 0.998 * lanes);
}

// Where lanes can move as long as some area is uncovered, and small pieces are seen from the beginning: with the price
// of full coverage all along, or a raster that misses these pieces, the ratio is 1.13.
TEST(Shortest, NearlyFullCoverageOfFieldsTakesLittleMore) {
  double sum = 0;
  for (const std::uint64_t seed : {1, 2, 3, 4}) {
    SCOPED_TRACE(seed);
    const Problem field(generate("field", {{"width", 60.0}, {"height", 42.0}, {"ponds", std::int64_t{4}}}, seed),
                        disc(1, 3));
    const Path path = plan("shortest", field, {{"coverage", 0.9999}, {"moves", 100000}});
    expect_valid(field, path);
    const Score s = score(field, path);
    EXPECT_GE(*s.value("coverage"), 0.9999 - 2e-5);
    sum += *s.value("length_ratio");
  }
  EXPECT_LT(sum / 4, 1.122);
}

TEST(Shortest, IsTheSameForAnyNumberOfThreads) {
  for (const Sample& sample : samples(1)) {
    SCOPED_TRACE(sample.name);
    const auto with = [&](int threads) {
      return bytes(plan("shortest", sample.problem, {{"moves", 3000}, {"threads", threads}}));
    };
    const std::string one = with(1);
    EXPECT_EQ(one, with(1));
    EXPECT_EQ(one, with(3));
  }
}

TEST(Shortest, ComesHomeIfAsked) {
  for (const Sample& sample : samples(1)) {
    SCOPED_TRACE(sample.name);
    const Path path = plan("shortest", sample.problem, {{"moves", 3000}, {"return_home", true}});
    expect_valid(sample.problem, path);
    EXPECT_EQ(path.legs.back().points.back(), sample.problem.start());
    EXPECT_GE(*score(sample.problem, path).value("coverage"), 0.998);
  }
}

TEST(Shortest, EndsSoonWhenCancelledWithWhatItHas) {
  const Problem problem = samples(1).front().problem;
  int published = 0;
  Context::Sinks sinks;
  Context* running = nullptr;
  sinks.publish = [&](const Path& path) {
    expect_valid(problem, path);
    if (++published == 2) running->cancel();
  };
  Context later(1, 1e9, sinks);
  running = &later;
  expect_valid(problem, built_in_planner("shortest", {{"moves", 100000000}})->plan(problem, later));
  EXPECT_EQ(published, 2);
}

// Cancelled before the beginning, or given no time at all: the first start, which is quickly found, as it is.
TEST(Shortest, IsItsFirstStartWhereThereIsNoTime) {
  for (const Sample& sample : samples(1)) {
    SCOPED_TRACE(sample.name);
    Context cancelled, late(1, 0);
    cancelled.cancel();
    for (Context* context : {&cancelled, &late}) {
      const Path path = built_in_planner("shortest", {{"moves", 100000000}})->plan(sample.problem, *context);
      expect_valid(sample.problem, path);
      EXPECT_NEAR(path.length(), plan("boustrophedon", sample.problem).length(), 1e-9);
    }
  }
}

// Of a planner that has nothing so far it returns nothing, and no more is begun.
TEST(Polished, IsThePlannersPathWhereThereIsNoTime) {
  for (const Sample& sample : samples(1)) {
    SCOPED_TRACE(sample.name);
    for (const char* inner : {"stc", "boustrophedon"}) {
      Context own, context;
      own.cancel();
      context.cancel();
      const Path path = built_in_planner("polished", {{"planner", std::string(inner)}, {"moves", 100000000}})
                            ->plan(sample.problem, context);
      EXPECT_EQ(path.length(), built_in_planner(inner)->plan(sample.problem, own).length());
      if (!path.legs.empty()) expect_valid(sample.problem, path);
    }
  }
}

// What is asked for is covered, by the completion's own exact measure and by the metric, however little is annealed.
TEST(Shortest, ReachesTheShareAskedFor) {
  for (const Sample& sample : samples(1))
    for (const double coverage : {0.9, 0.99, 0.999}) {
      SCOPED_TRACE(fmt::format("{} coverage {}", sample.name, coverage));
      const Path path = plan("shortest", sample.problem, {{"coverage", coverage}, {"moves", 2000}});
      expect_valid(sample.problem, path);
      const Completion completion(sample.problem, coverage);
      const double left = area(completion.uncovered(vertices_of(path, sample.problem.start())));
      EXPECT_LE(left, (1 - coverage) * area(sample.problem.target()));
      const Score s = score(sample.problem, path);
      EXPECT_GE(*s.value("coverage"), coverage);
      EXPECT_LE(*s.value("bound_m"), path.length());
    }
}

TEST(Shortest, TheTetherIsKeptWithinLeashed) {
  Robot robot = disc(0.2, 0.4);
  robot.tether = Tether{0, 1.2};
  for (const auto seed : seeds(2)) {
    SCOPED_TRACE(seed);
    const Problem problem(generate("clutter", {{"width", 6.0}, {"height", 5.0}}, seed), robot);
    const Path path = plan("leashed", problem, {{"planner", std::string("shortest")}, {"moves", 5000}});
    const Score s = score(problem, path);
    EXPECT_EQ(s.flaw, "");
    EXPECT_GE(*s.value("coverage"), 0.99);
  }
}

TEST(Shortest, TightSpaces) {
  for (const Region& room : {box_region({0, 0}, {0.41, 0.41}), box_region({0, 0}, {6, 0.402}),
                             box_region({0, 0}, {0.5, 3}), box_region({100, 100}, {101, 101})})
    for (const double coverage : {1.0, 0.9, 0.5}) {
      const Problem problem({"room", room, "test", "test"}, disc(0.2, 0.4));
      const Path path = plan("shortest", problem, {{"coverage", coverage}, {"moves", 2000}});
      expect_valid(problem, path);
      const Score s = score(problem, path);
      EXPECT_GE(*s.value("coverage"), coverage - 5e-3);  // seams, in rooms of one tool
      if (const auto bound = s.value("bound_m")) { EXPECT_LE(*bound, path.length()); }
    }
}

}  // namespace
}  // namespace oxturn
