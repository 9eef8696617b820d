#include "algorithms/tour/open_tour.hpp"

#include <algorithm>

#include "algorithms/transit/nearest_component.hpp"
#include "geometry/point_grid.hpp"

namespace oxturn {
namespace {

constexpr double kFar = TourCosts::kFar;
constexpr double kFarApart = 4;  // times the distance between the ports of a stop
/// How far the others of these ports are from the first, straight.
double spread(const TourCosts& costs, const std::vector<std::size_t>& ports) {
  double most = 0;
  for (const std::size_t port : ports) most = std::max(most, costs.bound(ports.front(), port));
  return most;
}

/// Path lengths from the exits of a stop to the entries of the next. Where the two are far apart only one path is
/// searched, and all others are taken to share its bends: between its first and its last one it hardly matters at
/// which end of an element the robot is.
class Jump {
 public:
  Jump(const TourCosts& costs, const std::vector<std::size_t>& exits, const std::vector<std::size_t>& entries)
      : costs_(costs), exits_(exits), entries_(entries) {
    const double near = kFarApart * (spread(costs, exits) + spread(costs, entries));
    if (costs.exact(exits[0], entries[0], near) < kFar) return;
    const Polyline path = costs.path(exits[0], entries[0]);
    if (path.size() < 3) return;
    shared_ = oxturn::length(path) - distance(path[0], path[1]) - distance(path[path.size() - 2], path.back());
    for (const std::size_t port : exits) to_first_.push_back(costs.length(port, path[1]));
    for (const std::size_t port : entries) from_last_.push_back(costs.length(port, path[path.size() - 2]));
  }
  /// From exit k to entry q; kFar if it is longer than `longest`.
  double length(std::size_t k, std::size_t q, double longest) const {
    if (to_first_.empty()) return costs_.exact(exits_[k], entries_[q], longest);
    const double d = to_first_[k] + shared_ + from_last_[q];
    return d <= longest ? d : kFar;
  }

 private:
  const TourCosts& costs_;
  const std::vector<std::size_t>&exits_, &entries_;
  double shared_ = 0;                         // between the first bend and the last
  std::vector<double> to_first_, from_last_;  // by exit, by entry; empty: near
};

/// The elements that are not yet in the tour.
class Remaining {
 public:
  Remaining(const TourCosts& costs, const Problem& problem) : costs_(costs), grid_(costs.ports()), wave_(problem) {
    for (std::size_t port = 0; port < costs.ports().size(); ++port)
      wave_.add(costs.at(port), static_cast<int>(costs.element_of(port)), port);
  }

  bool empty() const { return grid_.remaining() == 0; }
  void remove(std::size_t element) {
    for (std::size_t q = 0; q < costs_.elements()[element].size(); ++q) grid_.remove(costs_.port(element, q));
    wave_.remove(static_cast<int>(element));
  }

  /// The nearest port by path: the nearest by straight distance if it is in sight, else what a wave through free space
  /// meets. Behind a wall hundreds may be nearer by straight distance; the wave costs only what is near by path.
  std::size_t nearest(std::size_t from) {
    std::size_t first = costs_.start();
    grid_.visit(costs_.at(from), [&](std::size_t port, double) {
      first = port;
      return false;
    });
    if (costs_.in_sight(from, first)) return first;
    const auto found = wave_.from(costs_.at(from));
    if (!found) return first;  // nothing can be reached: the path to it says so
    costs_.remember(from, found->id, oxturn::length(found->path));
    return found->id;
  }

 private:
  const TourCosts& costs_;
  PointGrid grid_;
  NearestComponent wave_;
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

std::vector<TourStop> nearest_tour(const TourCosts& costs, const Problem& problem, Context& context) {
  std::vector<TourStop> tour;
  Remaining remaining(costs, problem);
  std::size_t at = costs.start();
  while (!remaining.empty() && !context.cancelled()) {
    tour.push_back(costs.stop_at(remaining.nearest(at)));
    remaining.remove(tour.back().element);
    at = costs.exit(tour.back());
  }
  return tour;
}

std::vector<TourStop> depth_first_tour(const TourCosts& costs, const Problem& problem,
                                       const std::vector<std::vector<std::size_t>>& neighbours, Context& context) {
  std::vector<TourStop> tour;
  Remaining remaining(costs, problem);
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
    std::vector<std::size_t> entries;
    for (std::size_t q = 0; q < patterns; ++q) entries.push_back(costs.port(e, q));
    const Jump jump(costs, exits, entries);
    best_before[i].assign(patterns, 0);
    for (std::size_t q = 0; q < patterns; ++q) {
      const double own = costs.pattern_cost({e, q});
      for (std::size_t k = 0; k < exits.size(); ++k) {
        if (reached[k] + costs.bound(exits[k], entries[q]) + own >= next[q]) continue;
        const double d = reached[k] + jump.length(k, q, next[q] - reached[k] - own) + own;
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
