// Tours: by how much they are above the Held-Karp bound, and how processor time grows.
//
//   oxturn_micro --benchmark_filter=Tour        the table: over_bound is in per cent, on three kinds of problems
//   scripts/tours                               makes docs/tours.md of it
#include <benchmark/benchmark.h>

#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/held_karp_bound.hpp"
#include "algorithms/tour/lkh.hpp"
#include "algorithms/tour/solve_tour.hpp"
#include "algorithms/tour/tour_start.hpp"
#include "tests/support/dubins.hpp"

namespace oxturn {
namespace {

enum Kind { plane, dubins, matrix };

std::vector<Point> random_points(std::size_t n, Rng& rng) {
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = rng.unit();
    points.push_back({x, rng.unit()});
  }
  return points;
}

/// Directed poses; the turning radius is the mean distance of neighbours.
MatrixCost random_curves(std::size_t n, Rng& rng) {
  const double radius = 1 / std::sqrt(static_cast<double>(n));
  std::vector<DirectedPoint> poses;
  for (const Point& p : random_points(n, rng)) poses.push_back({p, rng.between(0.0, 6.2831853)});
  return tabulate(
      FunctionCost([&](PatternId a, PatternId b) { return dubins_length(poses[a], poses[b], radius); }, false), n);
}

MatrixCost random_matrix(std::size_t n, Rng& rng) {
  std::vector<double> costs(n * n);
  for (double& c : costs) c = rng.unit();
  return {n, std::move(costs)};
}

/// A random problem, and the bound of its tours.
struct Instance {
  Instance(Kind kind, std::size_t n) {
    Rng rng(1);
    if (kind == plane) {
      cost = std::make_unique<StraightCost>(random_points(n, rng));
      problem = std::make_unique<TourProblem>(*cost, n);
    } else {
      cost = std::make_unique<MatrixCost>(kind == dubins ? random_curves(n, rng) : random_matrix(n, rng));
      problem =
          std::make_unique<TourProblem>(*cost, std::vector<std::size_t>(n, 1), std::vector<PatternId>(n, kNoPattern));
    }
    Context context(1);
    bound = held_karp_bound(*problem, problem->cost(solve_tour(*problem, context, {.kicks = 10 * n})));
  }
  std::unique_ptr<ConnectionCost> cost;
  std::unique_ptr<TourProblem> problem;
  double bound = 0;
};

/// Made once: the bound takes longer than most tours.
const Instance& instance(const benchmark::State& state) {
  static std::map<std::pair<std::int64_t, std::int64_t>, Instance> all;
  const std::pair key(state.range(0), state.range(1));
  return all.try_emplace(key, static_cast<Kind>(key.first), static_cast<std::size_t>(key.second)).first->second;
}

template <class Solve>
void table_row(benchmark::State& state, Solve solve) {
  const Instance& i = instance(state);
  double cost = 0;
  for (auto _ : state) cost = i.problem->cost(solve(*i.problem));
  state.counters["over_bound"] = 100 * (cost / i.bound - 1);
}

void BM_TourNearestNeighbour(benchmark::State& state) { table_row(state, nearest_neighbour_tour); }
void BM_TourBranchAndBound(benchmark::State& state) {
  table_row(state, [](const TourProblem& p) { return branch_and_bound_tour(p, 100000).tour; });
}
void BM_TourDescent(benchmark::State& state) {
  table_row(state, [](const TourProblem& p) {
    Context context(1);
    return solve_tour(p, context, {.kicks = 0});
  });
}
void BM_TourDefault(benchmark::State& state) {
  table_row(state, [](const TourProblem& p) {
    Context context(1);
    return solve_tour(p, context);
  });
}
void BM_TourTwoSeconds(benchmark::State& state) {
  table_row(state, [](const TourProblem& p) {
    Context context(1, 2);
    return solve_tour(p, context, {.until_deadline = true});
  });
}
void BM_TourLkh(benchmark::State& state) {
  const auto program = find_lkh();
  if (!program) return state.SkipWithError("LKH is not on the PATH");
  table_row(state, [&](const TourProblem& p) {
    Context context(1, 60);
    return lkh_tour(p, *program, context);
  });
}

void rows(benchmark::internal::Benchmark* b) {
  b->Args({plane, 1000})->Args({dubins, 1000})->Args({matrix, 1000})->Unit(benchmark::kMillisecond)->Iterations(1);
  b->ArgNames({"kind", "n"});
}
BENCHMARK(BM_TourNearestNeighbour)->Apply(rows)->Args({plane, 10000});
BENCHMARK(BM_TourBranchAndBound)->Apply(rows);
BENCHMARK(BM_TourDescent)->Apply(rows)->Args({plane, 10000});
BENCHMARK(BM_TourDefault)->Apply(rows)->Args({plane, 10000});
BENCHMARK(BM_TourTwoSeconds)->Apply(rows)->Args({plane, 10000});
BENCHMARK(BM_TourLkh)->Apply(rows);

// Growth: construction and one descent without kicks.
void BM_TourGrowth(benchmark::State& state) {
  Rng rng(1);
  const auto n = static_cast<std::size_t>(state.range(0));
  const StraightCost cost(random_points(n, rng));
  const TourProblem problem(cost, n);
  for (auto _ : state) {
    Context context(1);
    benchmark::DoNotOptimize(solve_tour(problem, context, {.kicks = 0}));
  }
  state.SetComplexityN(state.range(0));
}
BENCHMARK(BM_TourGrowth)->RangeMultiplier(4)->Range(1 << 9, 1 << 17)->Unit(benchmark::kMillisecond)->Complexity();

}  // namespace
}  // namespace oxturn
