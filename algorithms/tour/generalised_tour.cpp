#include "algorithms/tour/generalised_tour.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/solve_tour.hpp"

namespace oxturn {
namespace {

constexpr PatternId kDepotPatterns = 2;
constexpr std::uint64_t kKicks = 5000;      // of the first tour
constexpr std::uint64_t kMoreKicks = 1000;  // of each later one
constexpr int kMostRounds = 40;

/// Straight distances between elements until they are refined, then lengths of paths. Patterns 0 and 1 are the depot's:
/// from the start, and to it for tours driven backwards. Its other side is free.
class PathCost final : public ConnectionCost {
 public:
  explicit PathCost(const TourCosts& costs) : costs_(costs) {
    const Point& start = costs.at(costs.start());
    ends_ = {{start, start}, {start, start}};
    for (const TourElement& element : costs.elements())
      for (const Pattern& p : element) ends_.push_back({p.entry, p.exit});
  }
  double operator()(PatternId from, PatternId to) const override {
    if (from == 1 || to == 0) return 0;
    const std::size_t a = from == 0 ? costs_.start() : exit(from);
    const std::size_t b = to == 1 ? costs_.start() : to - kDepotPatterns;
    return all_exact_ || exact_.contains(key(a, b)) ? costs_.exact(a, b) : costs_.bound(a, b);
  }
  bool symmetric(const std::vector<PatternId>&) const override { return true; }
  const std::vector<Ends>* ends() const override { return &ends_; }

  void refine_all() { all_exact_ = true; }
  /// Refines all between the elements of two consecutive ports, if the path is longer than straight.
  bool refine(std::size_t a, std::size_t b) {
    if (costs_.exact(a, b) <= costs_.bound(a, b) * kNotLonger) return false;
    return exact_.insert(key(a, b)).second;
  }

 private:
  static constexpr double kNotLonger = 1 + 1e-9;

  std::size_t exit(PatternId p) const { return costs_.exit(costs_.stop_at(p - kDepotPatterns)); }
  std::uint64_t element(std::size_t port) const {
    return port == costs_.start() ? costs_.elements().size() : costs_.element_of(port);
  }
  std::uint64_t key(std::size_t a, std::size_t b) const {
    const std::uint64_t x = element(a), y = element(b);
    return std::min(x, y) << 32 | std::max(x, y);
  }

  const TourCosts& costs_;
  std::vector<Ends> ends_;
  bool all_exact_ = false;
  std::unordered_set<std::uint64_t> exact_;  // pairs of elements; looked up, never listed
};

/// The elements with a depot before them.
TourProblem with_depot(const TourCosts& costs, const PathCost& connections) {
  std::vector<std::size_t> counts{kDepotPatterns};
  std::vector<PatternId> reverse{1, 0};
  std::vector<double> inner(kDepotPatterns, 0.0);
  for (const TourElement& element : costs.elements()) {
    const auto first = static_cast<PatternId>(inner.size());
    for (const Pattern& p : element) {
      reverse.push_back(first + static_cast<PatternId>(p.reverse));
      inner.push_back(p.cost);
    }
    counts.push_back(element.size());
  }
  return {connections, counts, std::move(reverse), std::move(inner)};
}

std::vector<TourStop> stops_of(const Tour& tour) {
  std::vector<TourStop> stops;
  for (const TourStop& stop : tour)
    if (stop.element > 0) stops.push_back({stop.element - 1, stop.pattern});
  return stops;
}

/// Whether some connection of the tour is longer than was assumed.
bool refine(PathCost& connections, const TourCosts& costs, const std::vector<TourStop>& stops) {
  bool refined = false;
  std::size_t at = costs.start();
  for (const TourStop& stop : stops) {
    if (connections.refine(at, costs.entry(stop))) refined = true;
    at = costs.exit(stop);
  }
  return refined;
}

}  // namespace

std::vector<TourStop> generalised_tour(const TourCosts& costs, Context& context) {
  if (costs.elements().empty()) return {};
  PathCost connections(costs);
  const TourProblem problem = with_depot(costs, connections);
  if (exact_tour_is_cheap(problem)) connections.refine_all();
  Tour tour = solve_tour(problem, context, {.kicks = kKicks});
  std::vector<TourStop> best = stops_of(tour);
  double least = cost_of(costs, best);
  for (int round = 0; round < kMostRounds && !context.cancelled(); ++round) {
    if (exact_tour_is_cheap(problem) || !refine(connections, costs, stops_of(tour))) break;
    tour = improved_tour(problem, tour, context, {.kicks = kMoreKicks});
    std::vector<TourStop> stops = stops_of(tour);
    if (const double cost = cost_of(costs, stops); cost < least) {
      least = cost;
      best = std::move(stops);
    }
  }
  return best;
}

double cost_of(const TourCosts& costs, const std::vector<TourStop>& tour) {
  double sum = 0;
  std::size_t at = costs.start();
  for (const TourStop& stop : tour) {
    sum += costs.exact(at, costs.entry(stop)) + costs.pattern_cost(stop);
    at = costs.exit(stop);
  }
  return sum;
}

}  // namespace oxturn
