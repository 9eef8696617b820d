// Curves between random poses up to 20 radii apart; one iteration is one curve.
#include <benchmark/benchmark.h>

#include <vector>

#include "algorithms/smoothing/connection.hpp"
#include "algorithms/smoothing/corners.hpp"
#include "base/random.hpp"

namespace oxturn {
namespace {

struct Poses {
  Pose from, to;
};

const std::vector<Poses>& random_poses() {
  static const std::vector<Poses> all = [] {
    Rng rng(1);
    std::vector<Poses> poses(1024);
    for (Poses& p : poses)
      p = {{{0, 0}, rng.between(-kPi, kPi)}, {{rng.between(0.0, 20.0), 0}, rng.between(-kPi, kPi)}};
    return poses;
  }();
  return all;
}

template <class Function>
void for_poses(benchmark::State& state, const Function& f) {
  const std::vector<Poses>& poses = random_poses();
  std::size_t i = 0;
  for (auto _ : state) {
    const Poses& p = poses[i++ % poses.size()];
    benchmark::DoNotOptimize(f(p.from, p.to));
  }
}

void BM_CurveDubins(benchmark::State& state) {
  for_poses(state, [](const Pose& a, const Pose& b) { return dubins_curve(a, b, 1); });
}
void BM_CurveReedsShepp(benchmark::State& state) {
  for_poses(state, [](const Pose& a, const Pose& b) { return reeds_shepp_curve(a, b, 1); });
}
void BM_CurveSpiro(benchmark::State& state) {
  for_poses(state, [](const Pose& a, const Pose& b) {
    return spiro_curve(a, b, spiro_control_points(a, b, 2, SpiroRule::improved), 2);
  });
}
void BM_CurveQuintic(benchmark::State& state) {
  for_poses(state, [](const Pose& a, const Pose& b) { return quintic_connection(a, b, 1); });
}
void BM_CurveContinuousDubins(benchmark::State& state) {
  const TurnShape shape(1);
  for_poses(state, [&](const Pose& a, const Pose& b) { return continuous_dubins_words(a, b, shape); });
}
void BM_CurveConnection(benchmark::State& state) {
  for_poses(state, [](const Pose& a, const Pose& b) { return smooth_connection(a, b, {.radius = 1}); });
}
void BM_CurveSampled(benchmark::State& state) {
  const SmoothCurve curve = smooth_connection({{0, 0}, 1}, {{8, 0}, 2}, {.radius = 1}).curve;
  for (auto _ : state) benchmark::DoNotOptimize(sampled(curve, 1e-3));
}
BENCHMARK(BM_CurveDubins);
BENCHMARK(BM_CurveReedsShepp);
BENCHMARK(BM_CurveSpiro);
BENCHMARK(BM_CurveQuintic);
BENCHMARK(BM_CurveContinuousDubins);
BENCHMARK(BM_CurveConnection);
BENCHMARK(BM_CurveSampled);

/// A zigzag of n right-angled corners, half of them rounded inside.
void BM_RoundedCorners(benchmark::State& state) {
  Polyline line{{0, 0}};
  std::vector<std::size_t> corners;
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    line.push_back(line.back() + (i % 2 == 0 ? Point(i % 4 == 0 ? 5 : 1.5, 0) : Point(0, 5)));
    if (i > 0) corners.push_back(line.size() - 2);
  }
  for (auto _ : state) benchmark::DoNotOptimize(rounded_corners(line, corners, {.radius = 1, .largest_deviation = 1}));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_RoundedCorners)->RangeMultiplier(8)->Range(64, 1 << 15)->Complexity();

}  // namespace
}  // namespace oxturn
