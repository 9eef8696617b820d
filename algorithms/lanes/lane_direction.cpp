#include "algorithms/lanes/lane_direction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "algorithms/lanes/lanes.hpp"
#include "base/math.hpp"
#include "geometry/convex_hull.hpp"

namespace oxturn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostFrequent = 6;  // directions of the boundary that become candidates
constexpr double kDistinct = 0.05;        // degrees: nearer directions count as one
constexpr double kTurnCost = 2;           // lane widths, for each lane
constexpr double kBreakCost = 4;          // lane widths, for each run of consecutive lanes
constexpr double kClearlyLess = 1 - 1e-9;

/// Reduced to [0, 180).
double half_turn(double degrees) {
  const double d = std::fmod(degrees, 180.0);
  const double positive = d < 0 ? d + 180 : d;
  return positive >= 180 ? 0 : positive;
}

/// Estimated cost of covering `region` by lanes in this direction, metres.
double cost(const Region& region, double degrees, double width) {
  const LaneFrame frame(degrees);
  std::vector<Segment> edges = edges_of(region);
  double low = kInfinity, high = -low;
  for (Segment& e : edges) {
    e = {frame.to_frame(e.a), frame.to_frame(e.b)};
    low = std::min(low, e.a.x());
    high = std::max(high, e.a.x());
  }
  const Projection lanes = project(edges, slabs_over(low, high, width));
  std::vector<int> right(lanes.intervals.size(), 0), left(right);  // neighbours of each lane
  for (const auto& [a, b] : lanes.links) {
    ++right[a];
    ++left[b];
  }
  double continued = 0;  // lanes driven directly after their only neighbour
  for (const auto& [a, b] : lanes.links)
    if (right[a] == 1 && left[b] == 1) ++continued;
  double total = 0;
  for (const LaneInterval& s : lanes.intervals) total += s.high - s.low;
  const double count = static_cast<double>(lanes.intervals.size());
  return total + kTurnCost * width * count + kBreakCost * width * (count - continued);
}

/// The directions with the most boundary length, the longest first: means over bins of one degree.
std::vector<double> frequent_directions(const Region& region) {
  constexpr std::size_t kBins = 180;  // centred on whole degrees
  std::array<double, kBins> weight{}, moment{};
  for (const Segment& e : edges_of(region)) {
    const double len = distance(e.a, e.b);
    if (len <= 0) continue;
    const double d = direction_of(e.b - e.a);
    const auto bin = static_cast<std::size_t>(std::floor(d + 0.5)) % kBins;
    double offset = d - static_cast<double>(bin);
    if (offset > 90) offset -= 180;
    weight[bin] += len;
    moment[bin] += len * offset;
  }
  std::array<std::size_t, kBins> order{};
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return weight[a] > weight[b]; });
  std::vector<double> directions;
  for (std::size_t i = 0; i < kMostFrequent && weight[order[i]] > 0; ++i) {
    const double d = static_cast<double>(order[i]) + moment[order[i]] / weight[order[i]];
    // Multiples of 90 degrees stay exact: rounding of atan2 must not tilt an upright map.
    directions.push_back(std::abs(std::remainder(d, 90.0)) < 1e-9 ? std::round(d / 90) * 90 : d);
  }
  return directions;
}

}  // namespace

double direction_of(const Point& d) { return half_turn(math::atan2(d.y(), d.x()) * 180 / kPi); }

/// Of the edge whose farthest vertex is nearest, by rotating callipers.
double narrowest_direction(const Ring& hull) {
  double best = kInfinity, direction = 0;
  std::size_t far = 1;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point edge = hull[(i + 1) % hull.size()] - hull[i];
    const auto height = [&](std::size_t k) { return cross(edge, hull[k % hull.size()] - hull[i]); };
    far = std::max(far, i + 1);
    while (far < i + hull.size() && height(far + 1) > height(far)) ++far;
    const double width = height(far) / edge.norm();
    if (width < best) {
      best = width;
      direction = direction_of(edge);
    }
  }
  return direction;
}

std::vector<double> lane_directions(const Region& region) {
  std::vector<double> candidates;
  const auto add = [&](double d) {
    d = half_turn(d);
    for (const double c : candidates)
      if (std::abs(std::remainder(c - d, 180.0)) < kDistinct) return;
    candidates.push_back(d);
  };
  for (const double d : frequent_directions(region)) {
    add(d);
    add(d + 90);
  }
  add(0);
  add(90);
  std::vector<Point> points;
  for_each_ring(region, [&](const Ring& ring) { points.insert(points.end(), ring.begin(), ring.end()); });
  const Ring hull = convex_hull(std::move(points));
  if (hull.size() >= 3) add(narrowest_direction(hull));
  return candidates;
}

double best_lane_direction(const Region& region, double width) {
  double best = kInfinity, direction = 0;
  for (const double d : lane_directions(region)) {
    const double c = cost(region, d, width);
    if (c < best * kClearlyLess) {
      best = c;
      direction = d;
    }
  }
  return direction;
}

}  // namespace oxturn
