#include "algorithms/drawing/outline_last.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

constexpr double kNear = 0.05;    // tool widths: laps may be straighter than the boundary
constexpr double kWhole = 0.95;   // share of the boundary that the lap follows
constexpr double kLongest = 1.6;  // of the boundary's length: a closed part that is longer has more in it than the lap
constexpr double kReach = 3;      // tool widths: longest connection to the lap

/// The first and the last of a line's points between which it is closed and follows the boundary.
using Lap = std::pair<std::size_t, std::size_t>;

/// The shortest such part. Points at which the line passes itself are compared in pairs of neighbours in driving order.
std::optional<Lap> find_lap(const Polyline& line, const Ring& outer, double width) {
  const EdgeIndex boundary(Region{{{outer, {}}}});
  const double all = perimeter(Region{{{outer, {}}}});
  std::vector<double> along{0}, followed{0};
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double d = distance(line[k - 1], line[k]);
    const bool near = boundary.nearest(line[k - 1], kNear * width) && boundary.nearest(line[k], kNear * width) &&
                      boundary.nearest(lerp(line[k - 1], line[k], 0.5), kNear * width);
    along.push_back(along.back() + d);
    followed.push_back(followed.back() + (near ? d : 0));
  }
  if (followed.back() < kWhole * all) return std::nullopt;
  std::vector<std::size_t> order(line.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto key = [&](std::size_t k) { return std::tuple(line[k].x(), line[k].y(), k); };
  std::ranges::sort(order, {}, key);
  std::optional<Lap> lap;
  double least = kLongest * all;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::size_t a = order[k - 1], b = order[k];
    if (line[a] != line[b] || followed[b] - followed[a] < kWhole * all || !(along[b] - along[a] < least)) continue;
    least = along[b] - along[a];
    lap = Lap(a, b);
  }
  return lap;
}

/// The closed line from its point nearest to p, if that is within reach; without the connection.
std::optional<Polyline> lap_from(const Polyline& closed, const Point& p, double reach,
                                 const std::function<bool(const Point&, const Point&)>& free) {
  double least = reach;
  std::optional<std::pair<std::size_t, Point>> nearest;  // on the segment that ends there
  for (std::size_t k = 1; k < closed.size(); ++k) {
    const Point q = nearest_on_segment(p, closed[k - 1], closed[k]);
    if (const double d = distance(p, q); d < least && free(p, q)) least = d, nearest = {k, q};
  }
  if (!nearest) return std::nullopt;
  const auto& [k, q] = *nearest;
  Polyline lap{q};
  const auto add = [&](const Point& next) {
    if (next != lap.back()) lap.push_back(next);
  };
  const auto at = closed.begin() + static_cast<std::ptrdiff_t>(k);
  std::for_each(at, closed.end(), add);
  std::for_each(closed.begin() + 1, at, add);
  add(q);
  return lap;
}

}  // namespace

std::vector<Leg> outline_last(std::vector<Leg> legs, const Ring& outer, double width,
                              const std::function<bool(const Point&, const Point&)>& free) {
  for (std::size_t l = 0; l < legs.size(); ++l) {
    const auto lap = legs[l].tool ? find_lap(legs[l].points, outer, width) : std::nullopt;
    if (!lap) continue;
    std::vector<Leg> changed = legs;
    Polyline& line = changed[l].points;
    const auto at = [&](std::size_t k) { return line.begin() + static_cast<std::ptrdiff_t>(k); };
    const Polyline closed(at(lap->first), at(lap->second + 1));
    line.erase(at(lap->first), at(lap->second));
    if (line.size() < 2 || !changed.front().tool || !changed.back().tool) return legs;
    Polyline &first = changed.front().points, &last = changed.back().points;
    auto before = lap_from(closed, first.front(), kReach * width, free);
    const auto after = lap_from(closed, last.back(), kReach * width, free);
    if (after && (!before || distance(last.back(), after->front()) <= distance(first.front(), before->front()))) {
      last.insert(last.end(), after->begin(), after->end());
    } else if (before) {
      first.insert(first.begin(), before->begin(), before->end());
    } else {
      return legs;
    }
    return changed;
  }
  return legs;
}

}  // namespace oxturn
