#include "algorithms/improve/windows.hpp"

#include <gtest/gtest.h>

#include "algorithms/improve/completion.hpp"
#include "algorithms/improve/moves.hpp"
#include "algorithms/improve/window_parts.hpp"
#include "algorithms/improve/witnesses.hpp"
#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Point random_point(const Box& box, Rng& rng) {
  const double x = rng.between(box.low.x(), box.high.x()), y = rng.between(box.low.y(), box.high.y());
  return {x, y};
}

/// Random edges that are free.
Polyline free_line(std::size_t n, const Box& box, const EdgeIndex& walls, Rng& rng) {
  Polyline line{{1, 1}};
  while (line.size() < n) {
    const Point p = random_point(box, rng);
    if (walls.contains(line.back(), p)) line.push_back(p);
  }
  return line;
}

void change_at_random(VertexPath& path, const EdgeIndex& walls, Rng& rng) {
  const Moves moves({.width = 2}, walls);
  for (int k = 0; k < 200; ++k) {
    const auto change = moves.propose(path, rng);
    if (!change) continue;
    if (std::ranges::all_of(change->added, [&](const Edge& e) { return walls.contains(e.a, e.b); }))
      change->apply(path);
  }
}

// Parts put back unchanged are the path; changed, they make one path with the same ends, whose edges are free, and
// which is as it was outside. No part of it is lost: the lengths of what has been changed add up.
TEST(WindowParts, JoinThePathAgain) {
  const EdgeIndex walls(subtract(box_region({0, 0}, {20, 20}), box_region({8, 7}, {11, 12})));
  std::size_t visited = 0, kept = 0;
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Polyline line = free_line(80, {{0, 0}, {20, 20}}, walls, rng);
    const Point centre = Witnesses::turned(Point(10, 10) + random_point({{-3, -3}, {3, 3}}, rng));
    std::vector<Box> windows;
    for (const Point& at : {Point(-4, -4), Point(4, -4), Point(-4, 4), Point(4, 4)})
      windows.emplace_back(centre + at - Point(2.5, 2.5), centre + at + Point(2.5, 2.5));
    if (seed % 3 == 0) windows.resize(1);
    const bool fixed_end = seed % 2 == 0;
    const WindowParts parts(line, windows, walls, 0.4, fixed_end);
    std::vector<std::optional<VertexPath>> changed(windows.size());
    for (std::size_t k = 0; k < windows.size(); ++k)
      if (parts.visited(k)) changed[k] = parts.part(k);
    const Joined same = parts.joined(changed);
    EXPECT_EQ(same.path, line);
    std::vector<double> longer(windows.size());
    for (std::size_t k = 0; k < windows.size(); ++k) {
      if (!changed[k]) continue;
      const double before = changed[k]->length();
      change_at_random(*changed[k], walls, rng);
      longer[k] = changed[k]->length() - before;
      ++visited;
    }
    const Joined all = parts.joined(changed);
    double expected = length(line);
    for (std::size_t k = 0; k < windows.size(); ++k)
      if (all.kept[k] != 0) {
        EXPECT_TRUE(changed[k]);
        expected += longer[k];
        ++kept;
      }
    if (changed[0]) { EXPECT_TRUE(all.kept[0]); }
    EXPECT_NEAR(length(all.path), expected, 1e-6);
    EXPECT_EQ(all.path.front(), line.front());
    if (fixed_end) { EXPECT_EQ(all.path.back(), line.back()); }
    for (std::size_t i = 1; i < all.path.size(); ++i) ASSERT_TRUE(walls.contains(all.path[i - 1], all.path[i])) << i;
    for (const Point& p : line) {  // of vertices outside, none is lost and none comes twice
      const Point t = Witnesses::turned(p);
      if (std::ranges::any_of(windows, [&](const Box& w) { return w.contains(t); })) continue;
      ASSERT_EQ(std::ranges::count(all.path, p), std::ranges::count(line, p));
    }
  }
  EXPECT_GT(visited, 150u);
  EXPECT_GT(kept, visited / 2);
  EXPECT_LT(kept, visited);  // some contradict each other
}

// A round is driven twice through both windows. Either may connect its visits crosswise, but not both: from the start
// that leads along the second round backwards, and then to the end.
TEST(WindowParts, TheSecondOfTwoThatMakeALoopIsRefused) {
  const EdgeIndex walls(box_region({-20, -20}, {20, 20}));
  const Polyline turned{{-9, 1}, {-5, 1}, {0, 1},  {5, 1}, {9, 1}, {9, 9},
                        {-9, 9}, {-9, 2}, {-5, 2}, {0, 2}, {5, 2}, {9, 2}};
  const Point x = Witnesses::turned({1, 0}), y = Witnesses::turned({0, 1});
  Polyline line;  // which turned becomes that
  for (const Point& p : turned) line.emplace_back(p.x() * x.x() + p.y() * x.y(), p.x() * y.x() + p.y() * y.y());
  const WindowParts parts(line, {{{-6, 0}, {-4, 3}}, {{4, 0}, {6, 3}}}, walls, 0.4, true);
  const auto crosswise = [&](std::size_t k) {
    VertexPath part = parts.part(k);
    std::vector<std::size_t> movable;
    for (std::size_t i = 0; i < part.size(); ++i)
      if (!part.fixed(i)) movable.push_back(i);
    EXPECT_EQ(movable.size(), 2u);
    part.reverse(movable.front() + 1, movable.back());
    return part;
  };
  const auto kept = [&](bool first, bool second) {
    std::vector<std::optional<VertexPath>> changed(2);
    if (first) changed[0] = crosswise(0);
    if (second) changed[1] = crosswise(1);
    return parts.joined(changed).kept;
  };
  EXPECT_EQ(kept(true, false), (std::vector<std::uint8_t>{1, 0}));
  EXPECT_EQ(kept(false, true), (std::vector<std::uint8_t>{0, 1}));
  EXPECT_EQ(kept(true, true), (std::vector<std::uint8_t>{1, 0}));
}

// A long corridor has many windows; lanes across it are nearer to each other than they need to be. What is uncovered is
// counted by witnesses and measured exactly.
TEST(Windows, APathGetsShorterInAllOfThem) {
  const Problem problem({"corridor", box_region({0, 0}, {34, 0.9}), "test", "test"}, disc(0.1, 0.2));
  const double width = 0.2, whole = area(problem.target());
  const Completion completion(problem, 0.99);
  Polyline start;
  for (int k = 0; k < 280; ++k) {
    const double x = 0.11 + 0.12 * k;
    start.emplace_back(x, k % 2 == 0 ? 0.11 : 0.79);
    start.emplace_back(x, k % 2 == 0 ? 0.79 : 0.11);
  }
  for (const bool fixed_end : {false, true}) {
    Rng rng(1);
    Context context(1);
    const Annealed now = annealed(problem, completion.target(), start,
                                  {.cell = width / 20,
                                   .radius = width / 2,
                                   .uncovered = 0.01 * whole,
                                   .price = 5 / width,
                                   .fixed_end = fixed_end},
                                  {150000, 0.01 * width, 0.0005 * width}, {}, 1, rng, context);
    EXPECT_LT(length(now.points), 0.96 * length(start));
    EXPECT_EQ(now.points.front(), start.front());
    if (fixed_end) { EXPECT_EQ(now.points.back(), start.back()); }
    for (std::size_t i = 1; i < now.points.size(); ++i)
      ASSERT_TRUE(problem.walls().contains(now.points[i - 1], now.points[i])) << i;
    EXPECT_NEAR(now.uncovered, area(completion.uncovered(now.points)), 2e-3 * whole);
  }
}

// So wide that its windows make several batches; rooms connect them in many orders.
TEST(Windows, AreTheSameForAnyNumberOfThreads) {
  const Problem problem(generate("rooms", {{"width", 40.0}, {"height", 12.0}, {"rooms", std::int64_t{16}}}, 5),
                        disc(0.1, 0.2));
  const double width = 0.2;
  const Completion completion(problem, 0.99);
  const Polyline start = vertices_of(plan("boustrophedon", problem), problem.start());
  const auto with = [&](int threads) {
    Rng rng(7);
    Context context(1);
    return annealed(
        problem, completion.target(), start,
        {.cell = width / 10, .radius = width / 2, .uncovered = 0.01 * area(problem.target()), .price = 5 / width},
        {100000, 0.05 * width, 0.01 * width}, {}, threads, rng, context);
  };
  const Annealed one = with(1);
  EXPECT_LT(length(one.points), length(start));
  for (const int threads : {2, 3, 8}) {
    const Annealed now = with(threads);
    EXPECT_EQ(now.points, one.points) << threads;
    EXPECT_EQ(now.uncovered, one.uncovered) << threads;
    EXPECT_EQ(now.price, one.price) << threads;
  }
}

}  // namespace
}  // namespace oxturn
