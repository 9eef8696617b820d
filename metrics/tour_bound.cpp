#include "metrics/tour_bound.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "metrics/disc_area.hpp"

namespace oxturn {
namespace {

// In tool widths, or their squares: the target is scaled.
constexpr double kRadius = 0.5;
constexpr double kMostArea = 60;
constexpr double kSpacing = 0.25;                                      // of candidates on the boundary
constexpr std::array kApart{0.9, 1.1, 1.3, 1.5, 1.75, 2.0, 2.3, 2.7};  // least distances of witnesses that are tried
constexpr std::size_t kMostWitnesses = 120;
constexpr int kSteps = 400;         // of the ascent
constexpr double kFirstStep = 0.1;  // changes of a weight by a unit of degree
constexpr double kShrink = 0.985;   // of the steps
constexpr double kRounding = 1e-9;
constexpr double kLess = 1e-5;  // by which the start may be off, and rounding

struct Witness {
  Point at;
  double reach;  // a path comes so near
};

/// The distance from p within which there is more than `uncovered` of the target, and the tool's radius.
double reach_of(const Region& target, const Point& p, double uncovered) {
  double low = 0, high = 1;
  const auto enough = [&](double radius) {
    DiscArea inside(p, radius);
    for_each_edge(target, [&](const Point& a, const Point& b) { inside.add(a, b); });
    return inside.area() > uncovered * (1 + kRounding) + kRounding;
  };
  while (!enough(high)) {
    if (high > 1e3) return std::numeric_limits<double>::infinity();
    high *= 2;
  }
  for (int k = 0; k < 20; ++k) (enough((low + high) / 2) ? high : low) = (low + high) / 2;
  return kRadius + high;
}

std::vector<Witness> candidates(const Region& target, double uncovered) {
  std::vector<Witness> found;
  for_each_edge(target, [&](const Point& a, const Point& b) {
    const int steps = static_cast<int>(std::ceil(distance(a, b) / kSpacing));
    for (int k = 0; k < steps; ++k) {
      const Point p = lerp(a, b, static_cast<double>(k) / steps);
      found.push_back({p, reach_of(target, p, uncovered)});
    }
  });
  return found;
}

/// One after the other the candidate farthest from the start and those chosen, as long as it is so far away.
std::vector<Witness> chosen(const std::vector<Witness>& all, const Point& start, double apart) {
  std::vector<double> away;
  away.reserve(all.size());
  for (const Witness& c : all) away.push_back(distance(c.at, start));
  std::vector<Witness> result;
  while (!all.empty() && result.size() < kMostWitnesses) {
    const auto k = static_cast<std::size_t>(std::ranges::max_element(away) - away.begin());
    if (away[k] < apart) break;
    result.push_back(all[k]);
    for (std::size_t i = 0; i < all.size(); ++i) away[i] = std::min(away[i], distance(all[i].at, all[k].at));
  }
  return result;
}

/// Hamiltonian paths from node 0.
class Paths {
 public:
  explicit Paths(const std::vector<Witness>& nodes) : n_(nodes.size()), cost_(n_ * n_, 0), weight_(n_, 0) {
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j)
        cost_[i * n_ + j] = std::max(0.0, distance(nodes[i].at, nodes[j].at) - nodes[i].reach - nodes[j].reach);
  }

  double bound() {
    double best = 0, step = kFirstStep;
    for (int k = 0; k < kSteps; ++k, step *= kShrink) {
      const double tree = cheapest_tree();
      // Degrees of a path: 2, but 1 of node 0 and of its end, at worst the node with the least weight.
      double sum = weight_[0];
      std::size_t end = 1;
      for (std::size_t i = 1; i < n_; ++i) {
        sum += 2 * weight_[i];
        if (weight_[i] < weight_[end]) end = i;
      }
      best = std::max(best, tree - sum + weight_[end]);
      for (std::size_t i = 0; i < n_; ++i) weight_[i] += step * (degree_[i] - (i == 0 || i == end ? 1 : 2));
    }
    return best;
  }

 private:
  /// Prim's algorithm with the weights; sets the degrees.
  double cheapest_tree() {
    std::vector<double> least(n_, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> from(n_, 0);
    std::vector<bool> in(n_, false);
    degree_.assign(n_, 0);
    double sum = 0;
    std::size_t at = 0;
    for (std::size_t k = 1; k < n_; ++k) {
      in[at] = true;
      std::size_t next = n_;
      for (std::size_t j = 0; j < n_; ++j) {
        if (in[j]) continue;
        const double cost = cost_[at * n_ + j] + weight_[at] + weight_[j];
        if (cost < least[j]) least[j] = cost, from[j] = at;
        if (next == n_ || least[j] < least[next]) next = j;
      }
      sum += least[next];
      ++degree_[next];
      ++degree_[from[next]];
      at = next;
    }
    return sum;
  }

  std::size_t n_;
  std::vector<double> cost_, weight_;
  std::vector<int> degree_;
};

}  // namespace

double tour_bound(const Region& target, double width, double uncovered_m2, const Point& start) {
  if (!(area(target) < kMostArea * width * width)) return 0;
  Region scaled = target;
  for_each_ring(scaled, [&](Ring& ring) {
    for (Point& p : ring) p /= width;
  });
  const std::vector<Witness> all = candidates(scaled, std::max(0.0, uncovered_m2) / (width * width));
  double best = 0;
  for (const double apart : kApart) {
    std::vector<Witness> nodes = chosen(all, start / width, apart);
    nodes.insert(nodes.begin(), {start / width, 0});
    if (nodes.size() > 1) best = std::max(best, Paths(nodes).bound());
  }
  return std::max(0.0, best - kLess) * width;
}

}  // namespace oxturn
