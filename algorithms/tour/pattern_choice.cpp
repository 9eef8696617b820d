#include "algorithms/tour/pattern_choice.hpp"

#include <limits>

namespace oxturn {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// The patterns of one element, with the cheapest path to the end of each.
struct Layer {
  Layer(const TourProblem& problem, ElementId e) : first(problem.first_pattern(e)), best(problem.pattern_count(e)) {}
  explicit Layer(PatternId only) : first(only), best{{0.0, kNoPattern}} {}

  struct Step {
    double cost = kNone;
    PatternId before = kNoPattern;
  };
  PatternId first;
  std::vector<Step> best;

  /// The cheapest step to p, without p's own cost.
  Step step_to(const TourProblem& problem, PatternId p) const {
    Step least;
    for (PatternId q = first; q < first + best.size(); ++q)
      if (const double cost = best[q - first].cost + problem.connection(q, p); cost < least.cost) least = {cost, q};
    return least;
  }
};

}  // namespace

double best_patterns_between(const TourProblem& problem, PatternId from, std::span<const ElementId> run, PatternId to,
                             std::vector<PatternId>& chosen) {
  std::vector<Layer> layers{Layer(from)};
  layers.reserve(run.size() + 1);
  for (const ElementId e : run) {
    Layer next(problem, e);
    for (PatternId p = next.first; p < next.first + next.best.size(); ++p) {
      next.best[p - next.first] = layers.back().step_to(problem, p);
      next.best[p - next.first].cost += problem.inner(p);
    }
    layers.push_back(std::move(next));
  }
  const Layer::Step last = layers.back().step_to(problem, to);
  chosen.assign(run.size(), kNoPattern);
  PatternId p = last.before;
  for (std::size_t i = run.size(); i-- > 0;) {
    chosen[i] = p;
    p = layers[i + 1].best[p - layers[i + 1].first].before;
  }
  return last.cost;
}

Tour best_patterns(const TourProblem& problem, const Tour& tour) {
  if (tour.size() < 2) return tour;
  Tour best = tour;
  double least = problem.cost(tour);
  std::vector<ElementId> run;
  for (std::size_t i = 1; i < tour.size(); ++i) run.push_back(static_cast<ElementId>(tour[i].element));
  std::vector<PatternId> chosen;
  const auto root = static_cast<ElementId>(tour.front().element);
  for (PatternId p = problem.first_pattern(root); p < problem.end_pattern(root); ++p) {
    if (problem.has_direction() && p != problem.pattern_of(tour.front())) continue;
    const double cost = problem.inner(p) + best_patterns_between(problem, p, run, p, chosen);
    if (cost >= least) continue;
    least = cost;
    best.front() = problem.stop_of(p);
    for (std::size_t i = 1; i < tour.size(); ++i) best[i] = problem.stop_of(chosen[i - 1]);
  }
  return best;
}

}  // namespace oxturn
