#include "algorithms/polygon/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <stdexcept>

#include "geometry/edge_index.hpp"
#include "geometry/mesh/partition.hpp"

namespace oxturn {
namespace {
constexpr std::size_t kMostConvex = 150;

double ring_length(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += distance(ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}

// For every sliver the part with which it shares most boundary (itself if none): stretches of edges that lie on
// one another, since partitions may meet in T-junctions.
class Neighbours {
 public:
  explicit Neighbours(const std::vector<Part>& parts) : index_(as_region(parts)) {
    // EdgeIndex may skip or turn edges: owners are found by both ends, which are copied unchanged.
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (const Ring& ring : parts[p].rings)
        for (std::size_t i = 0; i < ring.size(); ++i) owners_[key(ring[i], ring[(i + 1) % ring.size()])].push_back(p);
  }
  std::size_t best(const std::vector<Part>& parts, std::size_t self, double near) const {
    std::map<std::size_t, double> shared;
    for (const Ring& ring : parts[self].rings)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& a = ring[i];
        const Point& b = ring[(i + 1) % ring.size()];
        const double len = distance(a, b);
        if (len <= 0) continue;
        const Point u = (b - a) / len;
        Box box;
        box.add(a);
        box.add(b);
        box.grow(near);
        index_.for_each_near(box, [&](std::size_t e) {
          const EdgeIndex::Edge& edge = index_.edges()[e];
          const Point c = edge.a - a, d = edge.b - a;
          if (std::abs(cross(u, c)) > near || std::abs(cross(u, d)) > near) return;
          const double from = std::max(0.0, std::min(u.dot(c), u.dot(d))),
                       to = std::min(len, std::max(u.dot(c), u.dot(d)));
          if (to - from <= 0) return;
          for (const std::size_t other : owners_.at(key(edge.a, edge.b)))
            if (other != self) shared[other] += to - from;
        });
      }
    std::size_t best = self;
    double most = 0;
    for (const auto& [other, length] : shared)
      if (length > most) {
        most = length;
        best = other;
      }
    return best;
  }

 private:
  using Key = std::array<double, 4>;
  static Key key(const Point& a, const Point& b) {
    return before(a, b) ? Key{a.x(), a.y(), b.x(), b.y()} : Key{b.x(), b.y(), a.x(), a.y()};
  }
  static Region as_region(const std::vector<Part>& parts) {
    Region all;
    for (const Part& p : parts)
      for (const Ring& r : p.rings) all.polygons.push_back({r, {}});
    return all;
  }
  EdgeIndex index_;
  std::map<Key, std::vector<std::size_t>> owners_;
};

}  // namespace

std::vector<Part> cut_into_parts(const Region& region, const std::string& partition) {
  if (partition == "none") {
    Part all;
    for_each_ring(region, [&](const Ring& r) { all.rings.push_back(r); });
    all.area = area(region);
    return {all};
  }
  const std::size_t corners = vertex_count(region);
  if (partition == "convex" && corners > kMostConvex)
    throw std::invalid_argument(
        fmt::format("planner 'zigzag': partition 'convex' takes up to {} corners, the area to fill "
                    "has {}; use partition 'approximate'",
                    kMostConvex, corners));
  std::vector<Ring> rings;
  if (partition == "monotone") {
    rings = monotone_partition(region);
  } else if (partition == "trapezoid") {
    rings = trapezoid_partition(region);
  } else if (partition == "convex") {
    rings = convex_partition_optimal(region);
  } else if (partition == "auto" && corners <= kMostConvex) {
    try {
      rings = convex_partition_optimal(region);
    } catch (const std::runtime_error&) {  // CGAL finds none now and then (partition.hpp): what auto is for
      rings = convex_partition_approximate(region);
    }
  } else {
    rings = convex_partition_approximate(region);
  }
  std::vector<Part> parts;
  for (Ring& ring : rings) {
    const double a = signed_area(ring);
    parts.push_back({{std::move(ring)}, std::abs(a)});
  }
  return parts;
}

std::vector<Part> without_slivers(std::vector<Part> parts, double width, bool merge) {
  std::vector<bool> sliver(parts.size(), false);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    double boundary = 0;
    for (const Ring& r : parts[i].rings) boundary += ring_length(r);
    sliver[i] = parts[i].area < width * width / 4 || parts[i].area < width / 4 * boundary / 2;
  }
  if (std::find(sliver.begin(), sliver.end(), true) == sliver.end()) return parts;
  std::vector<Part> kept;
  if (!merge) {
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (!sliver[i]) kept.push_back(std::move(parts[i]));
    return kept;
  }
  std::vector<std::size_t> root(parts.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  const Neighbours neighbours(parts);
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (sliver[i]) {
      const std::size_t a = find(i), b = find(neighbours.best(parts, i, 1e-6 * width));
      if (a != b) root[a] = b;
    }
  std::vector<std::size_t> place(parts.size(), parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t r = find(i);
    if (place[r] == parts.size()) {
      place[r] = kept.size();
      kept.emplace_back();
    }
    Part& into = kept[place[r]];
    into.area += parts[i].area;
    for (Ring& ring : parts[i].rings) into.rings.push_back(std::move(ring));
  }
  return kept;
}

}  // namespace oxturn
