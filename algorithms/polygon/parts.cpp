#include "algorithms/polygon/parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "algorithms/lanes/lane_direction.hpp"
#include "base/disjoint_sets.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/mesh/partition.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostConvex = 150;  // vertices: the optimal partition takes cubic time
constexpr double kTouching = 1e-6;        // tool widths: edges nearer than this lie on one another

constexpr double kClearlyLess = 1 - 1e-9;  // so that rounding decides nothing

double ring_length(const Ring& ring) {
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) sum += distance(ring[i], ring[(i + 1) % ring.size()]);
  return sum;
}

bool is_sliver(const Part& part, double width) {
  double boundary = 0;
  for (const Ring& r : part.rings) boundary += ring_length(r);
  return part.area < width * width / 4 || part.area < width / 4 * boundary / 2;
}

/// Which parts share boundary. Partitions may meet in T-junctions, so edges are compared by the length over which they
/// lie on one another.
class PartNeighbours {
 public:
  explicit PartNeighbours(const std::vector<Part>& parts) : parts_(parts), index_(as_region(parts)) {
    // EdgeIndex may drop or reverse edges: owners are looked up by both ends, which are copied unchanged.
    for (std::size_t p = 0; p < parts.size(); ++p)
      for (const Ring& ring : parts[p].rings)
        for (std::size_t i = 0; i < ring.size(); ++i) owners_[key(ring[i], ring[(i + 1) % ring.size()])].push_back(p);
  }

  /// The part that shares the most boundary with `part`; nullopt if none does.
  std::optional<std::size_t> closest(std::size_t part, double near) const {
    std::map<std::size_t, double> shared;  // metres, by part
    for (const Ring& ring : parts_[part].rings)
      for (std::size_t i = 0; i < ring.size(); ++i)
        add_shared(part, ring[i], ring[(i + 1) % ring.size()], near, shared);
    std::optional<std::size_t> best;
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
  /// Adds the lengths over which edges of other parts lie on ab.
  void add_shared(std::size_t part, const Point& a, const Point& b, double near,
                  std::map<std::size_t, double>& shared) const {
    const double len = distance(a, b);
    if (len <= 0) return;
    const Point u = (b - a) / len;
    Box box{a.cwiseMin(b), a.cwiseMax(b)};
    box.grow(near);
    index_.for_each_near(box, [&](std::size_t e) {
      const EdgeIndex::Edge& edge = index_.edges()[e];
      const Point c = edge.a - a, d = edge.b - a;
      if (std::abs(cross(u, c)) > near || std::abs(cross(u, d)) > near) return;
      const double from = std::max(0.0, std::min(u.dot(c), u.dot(d))), to = std::min(len, std::max(u.dot(c), u.dot(d)));
      if (to - from <= 0) return;
      for (const std::size_t other : owners_.at(key(edge.a, edge.b)))
        if (other != part) shared[other] += to - from;
    });
  }

  const std::vector<Part>& parts_;
  EdgeIndex index_;
  std::map<Key, std::vector<std::size_t>> owners_;
};

std::vector<Ring> trapezoids_along(double degrees, const Region& region) {
  const LaneFrame frame(degrees);
  std::vector<Ring> rings = trapezoid_partition(frame.to_frame(region));
  for (Ring& ring : rings)
    for (Point& p : ring) p = frame.to_world(p);
  return rings;
}

std::vector<Ring> rings_of(const Region& region, Partition partition, double degrees) {
  const std::size_t vertices = vertex_count(region);
  switch (partition) {
    case Partition::monotone:
      return monotone_partition(region);
    case Partition::trapezoid:
      return trapezoids_along(degrees, region);
    case Partition::convex:
      if (vertices > kMostConvex)
        throw std::invalid_argument(
            fmt::format("planner 'zigzag': partition 'convex' takes up to {} vertices, the area to fill has {}; use "
                        "partition 'approximate'",
                        kMostConvex, vertices));
      return convex_partition_optimal(region);
    case Partition::automatic:
      if (vertices > kMostConvex) break;
      try {
        return convex_partition_optimal(region);
      } catch (const std::runtime_error&) {  // CGAL fails on some regions, see partition.hpp
        break;
      }
    case Partition::approximate:
    case Partition::none:
      break;
  }
  return convex_partition_approximate(region);
}

}  // namespace

Region as_region(const std::vector<Part>& parts) {
  Region all;
  for (const Part& p : parts)
    for (const Ring& r : p.rings) all.polygons.push_back({r, {}});
  return all;
}

std::vector<Part> cut_into_parts(const Region& region, Partition partition, double degrees) {
  std::vector<Part> parts;
  if (partition == Partition::none) {
    Part& all = parts.emplace_back();
    for_each_ring(region, [&](const Ring& r) { all.rings.push_back(r); });
    all.area = area(region);
    return parts;
  }
  for (Ring& ring : rings_of(region, partition, degrees)) {
    const double a = signed_area(ring);
    parts.push_back({{std::move(ring)}, std::abs(a)});
  }
  return parts;
}

std::vector<Part> with_slivers_merged(std::vector<Part> parts, double width) {
  std::vector<std::size_t> slivers;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (is_sliver(parts[i], width)) slivers.push_back(i);
  if (slivers.empty()) return parts;
  DisjointSets groups(parts.size());
  const PartNeighbours neighbours(parts);
  for (const std::size_t i : slivers)
    if (const auto other = neighbours.closest(i, kTouching * width)) groups.unite(i, *other);
  std::vector<Part> merged;
  std::vector<std::size_t> position(parts.size(), parts.size());  // in `merged`, by representative
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::size_t& at = position[groups.find(i)];
    if (at == parts.size()) {
      at = merged.size();
      merged.emplace_back();
    }
    merged[at].area += parts[i].area;
    for (Ring& ring : parts[i].rings) merged[at].rings.push_back(std::move(ring));
  }
  return merged;
}

std::vector<Part> without_slivers(std::vector<Part> parts, double width) {
  std::erase_if(parts, [&](const Part& part) { return is_sliver(part, width); });
  return parts;
}

Box box_in(const LaneFrame& frame, const Part& part) {
  Box box;
  for (const Ring& r : part.rings)
    for (const Point& p : r) box.add(frame.to_frame(p));
  return box;
}

double least_sum_of_widths(const Region& region, const std::vector<Part>& parts) {
  double best = std::numeric_limits<double>::infinity(), direction = 0;
  for (const double d : lane_directions(region)) {
    const LaneFrame frame(d);
    double sum = 0;
    for (const Part& p : parts) sum += box_in(frame, p).size().x();
    if (sum < best * kClearlyLess) {
      best = sum;
      direction = d;
    }
  }
  return direction;
}

}  // namespace oxturn
