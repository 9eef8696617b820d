#include "algorithms/tour/open_tour.hpp"

#include <algorithm>

#include "algorithms/tour/point_grid.hpp"

namespace oxturn {
namespace {

constexpr double kFar = TourCosts::kFar;
constexpr std::size_t kCandidates = 24;  // by straight distance, for the nearest by path

/// The nearest port found so far.
struct Best {
  std::size_t port = 0;
  double length = kFar;
};

/// The elements that are not yet in the tour.
class Remaining {
 public:
  explicit Remaining(const TourCosts& costs) : costs_(costs), grid_(costs.ports()) {}

  bool empty() const { return grid_.remaining() == 0; }
  void remove(std::size_t element) {
    for (std::size_t q = 0; q < costs_.elements()[element].size(); ++q) grid_.remove(costs_.port(element, q));
  }

  /// The nearest port by path. Searches are limited to a length that doubles: a port that is near on the map but far by
  /// path (behind a wall) costs no more than a search of the neighbourhood.
  std::size_t nearest(std::size_t from) const {
    const auto [first, farthest] = candidates(from);
    const double straight = costs_.bound(from, first);
    for (double limit = std::max(1.5 * straight, farthest / 8); limit < kFar; limit *= 2) {
      if (const auto found = nearest_within(from, limit)) return *found;
      if (limit == 0) limit = 1e-6;
      if (limit > 1e12 * (1 + straight)) break;  // no port can be reached
    }
    return first;
  }

 private:
  struct Candidates {
    std::size_t first;
    double farthest;
  };
  /// By straight distance.
  Candidates candidates(std::size_t from) const {
    Candidates found{costs_.start(), 0};
    std::size_t count = 0;
    visit(from, [&](std::size_t port, double straight) {
      if (count == 0) found.first = port;
      found.farthest = straight;
      return ++count < kCandidates;
    });
    return found;
  }
  std::optional<std::size_t> nearest_within(std::size_t from, double limit) const {
    Best best{0, limit};
    bool found = false;
    std::size_t count = 0;
    visit(from, [&](std::size_t port, double straight) {
      if (straight >= best.length || count++ >= kCandidates) return false;
      const double length = costs_.searched(from, port, best.length);
      if (length < best.length) {
        best = {port, length};
        found = true;
      }
      return true;
    });
    return found ? std::optional(best.port) : std::nullopt;
  }
  template <class F>
  void visit(std::size_t from, F f) const {
    grid_.visit(costs_.at(from), f);
  }

  const TourCosts& costs_;
  PointGrid grid_;
};

/// The nearest by path of the unvisited neighbours' ports; the nearest by straight distance if none can be reached.
/// nullopt if there is none.
std::optional<std::size_t> nearest_neighbour(const TourCosts& costs, std::size_t at,
                                             const std::vector<std::size_t>& neighbours,
                                             const std::vector<bool>& visited) {
  std::vector<std::pair<double, std::size_t>> offers;
  for (const std::size_t n : neighbours)
    if (!visited[n])
      for (std::size_t q = 0; q < costs.elements()[n].size(); ++q)
        offers.push_back({costs.bound(at, costs.port(n, q)), costs.port(n, q)});
  if (offers.empty()) return std::nullopt;
  std::sort(offers.begin(), offers.end());
  return nearest_by_path(offers, [&](std::size_t port, double longest) { return costs.searched(at, port, longest); })
      .value_or(offers.front().second);
}

}  // namespace

std::vector<TourStop> nearest_tour(const TourCosts& costs, Context& context) {
  std::vector<TourStop> tour;
  Remaining remaining(costs);
  std::size_t at = costs.start();
  while (!remaining.empty() && !context.cancelled()) {
    tour.push_back(costs.stop_at(remaining.nearest(at)));
    remaining.remove(tour.back().element);
    at = costs.exit(tour.back());
  }
  return tour;
}

std::vector<TourStop> depth_first_tour(const TourCosts& costs, const std::vector<std::vector<std::size_t>>& neighbours,
                                       Context& context) {
  std::vector<TourStop> tour;
  Remaining remaining(costs);
  std::vector<bool> visited(costs.elements().size(), false);
  std::vector<std::size_t> stack;
  std::size_t at = costs.start();
  while (!remaining.empty() && !context.cancelled()) {
    std::optional<std::size_t> port;
    while (!stack.empty() && !port) {
      port = nearest_neighbour(costs, at, neighbours[stack.back()], visited);
      if (!port) stack.pop_back();
    }
    tour.push_back(costs.stop_at(port ? *port : remaining.nearest(at)));
    visited[tour.back().element] = true;
    remaining.remove(tour.back().element);
    stack.push_back(tour.back().element);
    at = costs.exit(tour.back());
  }
  return tour;
}

void choose_patterns(const TourCosts& costs, std::vector<TourStop>& tour) {
  if (tour.empty()) return;
  std::vector<std::vector<std::size_t>> best_before(tour.size());  // [stop][pattern]: pattern of the stop before
  std::vector<double> reached{0.0};  // cost up to the end of each pattern of the last stop
  std::vector<std::size_t> exits{costs.start()};
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const std::size_t e = tour[i].element, patterns = costs.elements()[e].size();
    std::vector<double> next(patterns, kFar);
    best_before[i].assign(patterns, 0);
    for (std::size_t q = 0; q < patterns; ++q) {
      const std::size_t port = costs.port(e, q);
      const double own = costs.pattern_cost({e, q});
      for (std::size_t k = 0; k < exits.size(); ++k) {
        if (reached[k] + costs.bound(exits[k], port) + own >= next[q]) continue;
        const double d = reached[k] + costs.exact(exits[k], port, next[q] - reached[k] - own) + own;
        if (d < next[q]) {
          next[q] = d;
          best_before[i][q] = k;
        }
      }
    }
    exits.clear();
    for (std::size_t q = 0; q < patterns; ++q) exits.push_back(costs.exit({e, q}));
    reached = next;
  }
  auto q = static_cast<std::size_t>(std::min_element(reached.begin(), reached.end()) - reached.begin());
  for (std::size_t i = tour.size(); i-- > 0;) {
    tour[i].pattern = q;
    q = best_before[i][q];
  }
}

}  // namespace oxturn
