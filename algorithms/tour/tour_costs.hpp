/// The ports of a tour's elements and the path lengths between them.
///
///   TourCosts costs(start, elements, connector);
///   double d = costs.exact(costs.start(), costs.entry(stop), limit);      // infinity: longer than the limit
///
/// A port is the entry of a pattern; the exit of a pattern is the entry of its reverse. The start is the last port.
/// Path lengths are remembered: an unknown one costs a shortest-path search.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "algorithms/tour/tour_elements.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

class TourCosts {
 public:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  /// Keeps references to `elements` and `connector`.
  TourCosts(const Point& start, const std::vector<TourElement>& elements, const Connector& connector)
      : elements_(elements), connector_(connector), start_(start) {
    for (std::size_t i = 0; i < elements.size(); ++i) {
      first_.push_back(ports_.size());
      for (const Pattern& p : elements[i]) {
        ports_.push_back(p.entry);
        owner_.push_back(i);
      }
    }
  }

  const std::vector<TourElement>& elements() const { return elements_; }
  /// Positions of all ports but the start.
  const std::vector<Point>& ports() const { return ports_; }
  std::size_t start() const { return ports_.size(); }
  const Point& at(std::size_t port) const { return port == start() ? start_ : ports_[port]; }
  std::size_t port(std::size_t element, std::size_t pattern) const { return first_[element] + pattern; }
  std::size_t element_of(std::size_t port) const { return owner_[port]; }
  TourStop stop_at(std::size_t port) const { return {owner_[port], port - first_[owner_[port]]}; }
  std::size_t entry(const TourStop& s) const { return port(s.element, s.pattern); }
  std::size_t exit(const TourStop& s) const { return port(s.element, elements_[s.element][s.pattern].reverse); }
  double pattern_cost(const TourStop& s) const { return elements_[s.element][s.pattern].cost; }
  /// The same element, driven backwards.
  TourStop reversed(const TourStop& s) const { return {s.element, elements_[s.element][s.pattern].reverse}; }

  /// Straight distance, a lower bound of exact().
  double bound(std::size_t a, std::size_t b) const { return distance(at(a), at(b)); }
  /// The straight segment is free, so it is the path.
  bool in_sight(std::size_t a, std::size_t b) const { return connector_.straight(at(a), at(b)); }
  /// Path length, or kFar if it is longer than `longest`: limits keep searches for hopeless moves short.
  double exact(std::size_t a, std::size_t b, double longest = kFar) const {
    if (a == b) return 0;
    const auto [low, high] = std::minmax(a, b);
    Known& known = known_of(a, b);
    if (known.length < kFar) return known.length <= longest ? known.length : kFar;
    if (longest <= known.none_up_to || longest < bound(a, b)) return kFar;
    ++searches_;
    const double d = searched(low, high, longest);
    if (d < kFar)
      known.length = d;
    else if (longest < kFar)
      known.none_up_to = longest;
    return d;
  }
  /// exact(a, b) is this from now on.
  void remember(std::size_t a, std::size_t b, double length) const { known_of(a, b).length = length; }
  /// As exact(), but neither looked up nor remembered.
  double searched(std::size_t a, std::size_t b, double longest) const {
    return connector_.length(at(a), at(b), longest);
  }
  /// The path itself. Throws if there is none.
  Polyline path(std::size_t a, std::size_t b) const { return connector_.path(at(a), at(b)); }
  /// From a port to any point.
  double length(std::size_t a, const Point& b) const { return connector_.length(at(a), b); }
  /// How often exact() had to search.
  std::size_t searches() const { return searches_; }

 private:
  /// What is known of the path between two ports.
  struct Known {
    double length = kFar;
    double none_up_to = -kFar;  // the path is longer than this
  };
  Known& known_of(std::size_t a, std::size_t b) const {
    const auto [low, high] = std::minmax(a, b);
    return known_[static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high)];
  }

  const std::vector<TourElement>& elements_;
  const Connector& connector_;
  Point start_;
  std::vector<Point> ports_;
  std::vector<std::size_t> first_;                          // port of each element
  std::vector<std::size_t> owner_;                          // element of each port
  mutable std::unordered_map<std::uint64_t, Known> known_;  // looked up, never listed
  mutable std::size_t searches_ = 0;
};

}  // namespace oxturn
