#include "algorithms/lanes/lane_direction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algorithms/lanes/lanes.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

double half_turn(double degrees) {  // into [0, 180)
  const double d = std::fmod(degrees, 180.0);
  const double positive = d < 0 ? d + 180 : d;
  return positive >= 180 ? 0 : positive;
}

double direction_of(const Point& d) { return half_turn(std::atan2(d.y(), d.x()) * 180 / kPi); }

Ring hull(std::vector<Point> points) {  // Andrew's monotone chain
  std::sort(points.begin(), points.end(), [](const Point& a, const Point& b) { return before(a, b); });
  Ring chain;
  for (int side = 0; side < 2; ++side) {
    const std::size_t base = chain.size();
    for (const Point& p : points) {
      while (chain.size() >= base + 2 && orientation(chain[chain.size() - 2], chain.back(), p) <= 0) chain.pop_back();
      chain.push_back(p);
    }
    chain.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return chain;
}

// Lanes along the hull edge whose opposite corner is nearest: the narrowest extent across.
double narrowest(const Ring& h) {
  double best = std::numeric_limits<double>::infinity(), direction = 0;
  std::size_t far = 1;
  for (std::size_t i = 0; i < h.size(); ++i) {
    const Point edge = h[(i + 1) % h.size()] - h[i];
    const auto height = [&](std::size_t k) { return cross(edge, h[k % h.size()] - h[i]); };
    far = std::max(far, i + 1);
    while (far < i + h.size() && height(far + 1) > height(far)) ++far;
    const double width = height(far) / edge.norm();
    if (width < best) {
      best = width;
      direction = direction_of(edge);
    }
  }
  return direction;
}

double cost(const Region& region, double degrees, double width) {
  const Frame frame(degrees);
  std::vector<Segment> edges = edges_of(region);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (Segment& e : edges) {
    e = {frame.to(e.a), frame.to(e.b)};
    low = std::min(low, e.a.x());
    high = std::max(high, e.a.x());
  }
  const Projection lanes = project(edges, slabs_over(low, high, width));
  std::vector<int> left(lanes.stretches.size(), 0), right(left);
  for (const auto& [a, b] : lanes.links) {
    ++right[a];
    ++left[b];
  }
  double joined = 0;
  for (const auto& [a, b] : lanes.links)
    if (right[a] == 1 && left[b] == 1) ++joined;
  double sum = 0;
  for (const Stretch& s : lanes.stretches) sum += s.high - s.low;
  const double count = static_cast<double>(lanes.stretches.size());
  return sum + 2 * width * count + 4 * width * (count - joined);
}

}  // namespace

std::vector<double> lane_directions(const Region& region) {
  constexpr int kBins = 180;
  std::array<double, kBins> weight{}, moment{};
  std::vector<Point> points;
  for (const Segment& e : edges_of(region)) {
    points.push_back(e.a);
    const double len = distance(e.a, e.b);
    if (len <= 0) continue;
    const double d = direction_of(e.b - e.a);
    const int bin = static_cast<int>(std::floor(d + 0.5)) % kBins;  // centred on whole degrees
    double offset = d - bin;
    if (offset > 90) offset -= 180;
    weight[static_cast<std::size_t>(bin)] += len;
    moment[static_cast<std::size_t>(bin)] += len * offset;
  }
  std::array<int, kBins> order{};
  for (int i = 0; i < kBins; ++i) order[static_cast<std::size_t>(i)] = i;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return weight[static_cast<std::size_t>(a)] > weight[static_cast<std::size_t>(b)];
  });
  std::vector<double> candidates;
  const auto add = [&](double d) {
    d = half_turn(d);
    for (const double c : candidates)
      if (std::abs(std::remainder(c - d, 180.0)) < 0.05) return;
    candidates.push_back(d);
  };
  for (std::size_t i = 0; i < 6; ++i) {
    const auto bin = static_cast<std::size_t>(order[i]);
    if (weight[bin] <= 0) break;
    double d = order[i] + moment[bin] / weight[bin];
    // Whole quarter turns stay exact: rounding of atan2 must not tilt an upright map.
    if (std::abs(std::remainder(d, 90.0)) < 1e-9) d = std::round(d / 90) * 90;
    add(d);
    add(d + 90);
  }
  add(0);
  add(90);
  const Ring outline = hull(points);
  if (outline.size() >= 3) add(narrowest(outline));
  return candidates;
}

double best_lane_direction(const Region& region, double width) {
  double best = std::numeric_limits<double>::infinity(), direction = 0;
  for (const double d : lane_directions(region)) {
    const double c = cost(region, d, width);
    if (c < best * (1 - 1e-9)) {
      best = c;
      direction = d;
    }
  }
  return direction;
}

}  // namespace oxturn
