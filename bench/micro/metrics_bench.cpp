// Scoring: near-linear in the path's points, for smooth curves, many legs and repeated paths alike.
#include <benchmark/benchmark.h>

#include "base/random.hpp"
#include "metrics/score.hpp"

namespace oxturn {
namespace {

constexpr double kTool = 0.4;

/// A square floor with a lattice of square pillars, one for every 20 x 20 tool widths.
Region floor_with_pillars(double side) {
  Region r = box_region({0, 0}, {side, side});
  for (double y = 10 * kTool; y + 12 * kTool < side; y += 20 * kTool)
    for (double x = 10 * kTool; x + 12 * kTool < side; x += 20 * kTool)
      r.polygons[0].holes.push_back({{x, y}, {x, y + kTool}, {x + kTool, y + kTool}, {x + kTool, y}});
  return r;
}

/// n steps of a tool width each: lanes with a sideways kink at every step, so that nothing merges.
Polyline lanes(std::size_t n) {
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(n)));
  Polyline line;
  for (std::size_t j = 0; j < side; ++j)
    for (std::size_t i = 0; i < side; ++i) {
      const std::size_t k = j % 2 ? side - 1 - i : i;
      line.push_back(
          {(static_cast<double>(k) + 0.75) * kTool, (static_cast<double>(j) + 0.75 + (i % 2 ? 0.02 : 0.0)) * kTool});
    }
  return line;
}

double lanes_side(std::size_t n) { return (std::sqrt(static_cast<double>(n)) + 1) * kTool; }
/// Of the square for curves of n points: 15 m for 10^5.
double curve_side(std::size_t n) { return 15 * std::sqrt(static_cast<double>(n) / 1e5); }

/// n points on a spiral of laps 0.9 tool widths apart that fills the square's inscribed circle.
Polyline spiral(std::size_t n, double side) {
  const double radius = side / 2 - 0.3, laps = radius / (0.9 * kTool);
  Polyline line;
  for (std::size_t k = 0; k < n; ++k) {
    const double t = std::sqrt((static_cast<double>(k) + 0.5) / static_cast<double>(n));
    line.push_back(Point(side / 2, side / 2) + rotated({radius * t, 0}, 2 * kPi * laps * t));
  }
  return line;
}

/// Crosses itself about a * b times.
Polyline lissajous(std::size_t n, double side) {
  const double a = std::round(2 * side), b = a + 6;
  Polyline line;
  for (std::size_t k = 0; k < n; ++k) {
    const double t = 2 * kPi * static_cast<double>(k) / static_cast<double>(n);
    line.push_back(Point(side / 2, side / 2) + (side / 2 - 0.3) * Point(std::sin(a * t), std::sin(b * t + 0.3)));
  }
  return line;
}

/// A spiral there and back 20 times.
Polyline there_and_back(std::size_t n, double side) {
  const Polyline once = spiral(n / 40, side);
  Polyline line;
  for (int k = 0; k < 20; ++k) {
    line.insert(line.end(), once.begin(), once.end());
    line.insert(line.end(), once.rbegin(), once.rend());
  }
  return line;
}

Polyline random_line(std::size_t n, double side) {
  Rng rng(5);
  Polyline line{{side / 2 + 3 * kTool, side / 2}};  // between pillars
  for (std::size_t k = 0; k < n; ++k) {
    const Point p = line.back() + Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)) * kTool;
    line.push_back(p.cwiseMax(Point(0.3, 0.3)).cwiseMin(Point(side - 0.3, side - 0.3)));
  }
  return line;
}

/// n points within two tool widths: a robot that trembles.
Polyline trembling(std::size_t n, const Point& at) {
  Rng rng(7);
  Polyline line;
  for (std::size_t k = 0; k < n; ++k)
    line.push_back(at + kTool * Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)));
  return line;
}

/// n steps of up to a tenth of a tool width, in a square of eight tool widths.
Polyline walk_in_room(std::size_t n, const Point& at) {
  Rng rng(7);
  const Point reach = Point(4, 4) * kTool;
  Polyline line{at};
  for (std::size_t k = 0; k < n; ++k) {
    const Point p = line.back() + 0.1 * kTool * Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0));
    line.push_back(p.cwiseMax(at - reach).cwiseMin(at + reach));
  }
  return line;
}

Path one_leg(const Polyline& line) { return {{Leg{true, line}}}; }

/// A leg for each segment.
Path many_legs(const Polyline& line) {
  Path path;
  for (std::size_t k = 1; k < line.size(); ++k) path.legs.push_back(Leg{true, {line[k - 1], line[k]}});
  return path;
}

/// All of it: validity, clearance, every metric. Paths may run through pillars.
void run(benchmark::State& state, const Path& path, const Region& free) {
  Robot robot;
  robot.tool_width = kTool;
  robot.radius = 0.05;
  const Problem problem(Map{"floor", free, "test", "test"}, robot, path.legs.front().points.front());
  benchmark::DoNotOptimize(problem.target_excess());  // computed at the first call
  benchmark::DoNotOptimize(&problem.map_edges());
  for (auto _ : state) benchmark::DoNotOptimize(score(problem, path));
  state.SetComplexityN(state.range(0));
}

std::size_t points(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

void BM_ScoreSpiral(benchmark::State& state) {
  const double side = curve_side(points(state));
  run(state, one_leg(spiral(points(state), side)), floor_with_pillars(side));
}
void BM_ScoreLissajous(benchmark::State& state) {
  const double side = curve_side(points(state));
  run(state, one_leg(lissajous(points(state), side)), floor_with_pillars(side));
}
void BM_ScoreThereAndBack(benchmark::State& state) {
  const double side = curve_side(points(state));
  run(state, one_leg(there_and_back(points(state), side)), floor_with_pillars(side));
}
void BM_ScoreLegsOfOneSegment(benchmark::State& state) {
  run(state, many_legs(lanes(points(state))), floor_with_pillars(lanes_side(points(state))));
}
void BM_ScoreLanes(benchmark::State& state) {
  run(state, one_leg(lanes(points(state))), floor_with_pillars(lanes_side(points(state))));
}
void BM_ScoreRandom(benchmark::State& state) {
  const double side = std::sqrt(static_cast<double>(points(state))) * kTool;
  run(state, one_leg(random_line(points(state), side)), floor_with_pillars(side));
}
void BM_ScoreTrembling(benchmark::State& state) {
  run(state, one_leg(trembling(points(state), {3, 3})), floor_with_pillars(6));
}
void BM_ScoreWalkInRoom(benchmark::State& state) {
  run(state, one_leg(walk_in_room(points(state), {3, 3})), floor_with_pillars(6));
}
/// Lanes over cells, a tenth of whose corners have a speck.
void BM_ScoreSpeckles(benchmark::State& state) {
  const auto cells = static_cast<std::size_t>(std::sqrt(static_cast<double>(state.range(0))));
  Region free = box_region({0, 0}, Point(1, 1) * static_cast<double>(cells) * kTool);
  Rng rng(1);
  Polyline line;
  for (std::size_t j = 0; j < cells; ++j)
    for (std::size_t i = 0; i < cells; ++i) {
      const double x = static_cast<double>(j % 2 ? cells - 1 - i : i), y = static_cast<double>(j);
      line.push_back(kTool * Point(x + 0.5, y + 0.5 + (i % 2 ? 0.02 : 0.0)));
      if (i == 0 || j == 0 || !rng.chance(0.1)) continue;
      const Point at = kTool * Point(static_cast<double>(i), y);
      free.polygons[0].holes.push_back(
          {at + Point(-0.03, -0.03), at + Point(-0.03, 0.03), at + Point(0.03, 0.03), at + Point(0.03, -0.03)});
    }
  run(state, one_leg(line), free);
}

void up_to_a_million(benchmark::internal::Benchmark* b) {
  b->Arg(10000)->Arg(100000)->Arg(1000000)->Complexity()->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime();
}
BENCHMARK(BM_ScoreSpiral)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreLissajous)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreThereAndBack)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreLegsOfOneSegment)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreLanes)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreRandom)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreTrembling)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreWalkInRoom)->Apply(up_to_a_million);
BENCHMARK(BM_ScoreSpeckles)->Apply(up_to_a_million);

}  // namespace
}  // namespace oxturn
