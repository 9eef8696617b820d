// Scoring: near-linear in the path's segments.
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

Polyline spiral(std::size_t n, double side) {
  Polyline line;
  double angle = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const double radius = 0.05 + angle * 0.9 * kTool / (2 * kPi);
    line.push_back(Point(side / 2, side / 2) + rotated({radius, 0}, angle));
    angle += std::sqrt(0.008 * kTool / radius);  // chords that keep w / 1000
  }
  return line;
}

Polyline random_line(std::size_t n, double side) {
  Rng rng(5);
  Polyline line{{side / 2, side / 2}};
  for (std::size_t k = 0; k < n; ++k) {
    Point p = line.back() + Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)) * kTool;
    line.push_back(p.cwiseMax(Point(0.3, 0.3)).cwiseMin(Point(side - 0.3, side - 0.3)));
  }
  return line;
}

void run(benchmark::State& state, const Polyline& line, double side) {
  const Region target = floor_with_pillars(side);
  const Path path{{Leg{true, line}}};
  for (auto _ : state) benchmark::DoNotOptimize(swept_area(target, 1e-6, kTool, path));
  state.SetComplexityN(state.range(0));
}

void BM_SweepLanes(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  run(state, lanes(n), (std::sqrt(static_cast<double>(n)) + 1) * kTool);
}
BENCHMARK(BM_SweepLanes)->Arg(1000)->Arg(10000)->Arg(100000)->Complexity()->Unit(benchmark::kMillisecond);

void BM_SweepSpiral(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  run(state, spiral(n, 0), 2 * spiral(n, 0).back().norm() + 1);
}
BENCHMARK(BM_SweepSpiral)->Arg(1000)->Arg(10000)->Arg(100000)->Complexity()->Unit(benchmark::kMillisecond);

void BM_SweepRandom(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const double side = std::sqrt(static_cast<double>(n)) * kTool;
  run(state, random_line(n, side), side);
}
BENCHMARK(BM_SweepRandom)->Arg(1000)->Arg(10000)->Arg(100000)->Complexity()->Unit(benchmark::kMillisecond);

/// All of it: validity, clearance, every metric; also walls that the path runs through, which is the dear case.
void BM_Score(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const double side = (std::sqrt(static_cast<double>(n)) + 1) * kTool;
  const Polyline line = lanes(n);
  Robot robot;
  robot.tool_width = kTool;
  robot.radius = kTool / 2;
  const Problem problem(Map{"floor", floor_with_pillars(side), "test", "test"}, robot, line.front());
  const Path path{{Leg{true, line}}};
  for (auto _ : state) benchmark::DoNotOptimize(score(problem, path));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_Score)->Arg(1000)->Arg(10000)->Arg(100000)->Complexity()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace oxturn
