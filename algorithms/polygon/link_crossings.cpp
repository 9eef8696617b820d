#include "algorithms/polygon/link_crossings.hpp"

#include <algorithm>
#include <utility>

#include "geometry/predicates.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

using Link = std::pair<Point, Point>;
using IndexPair = std::pair<std::uint32_t, std::uint32_t>;

/// Pairs of indices of crossing segments, the lower index first. Sorted, unique.
std::vector<IndexPair> crossing_pairs(const std::vector<Link>& segments) {
  const UniformGrid grid(segments.size(), [&](std::size_t i) {
    return std::array{segments[i].first, segments[i].second};
  });
  if (grid.empty()) return {};
  std::vector<IndexPair> pairs;
  for (int row = 0; row < grid.rows(); ++row)
    for (int column = 0; column < grid.columns(); ++column) {
      const auto items = grid.items(grid.index(column, row));
      for (auto i = items.begin(); i != items.end(); ++i)
        for (auto j = i + 1; j != items.end(); ++j) {
          const auto& [a, b] = segments[*i];
          const auto& [p, q] = segments[*j];
          if (crossing(a, b, p, q) == Crossing::proper) pairs.emplace_back(std::min(*i, *j), std::max(*i, *j));
        }
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

LinkCrossings count_crossings(const std::vector<Polyline>& links, const std::vector<Polyline>& transits) {
  std::vector<Link> segments;
  const auto add = [&](const std::vector<Polyline>& lines) {
    for (const Polyline& line : lines)
      for (std::size_t i = 1; i < line.size(); ++i) segments.emplace_back(line[i - 1], line[i]);
  };
  add(links);
  const std::size_t of_links = segments.size();
  add(transits);
  LinkCrossings count;
  for (const auto& [i, j] : crossing_pairs(segments)) ++(j < of_links ? count.links : count.transits);
  return count;
}

}  // namespace oxturn
