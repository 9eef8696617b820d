#include "geometry/mesh/triangulation_input.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>

#include "base/sorting.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

using Id = std::int32_t;  // of a point
using Segment = TriangulationInput::Segment;

std::size_t at(Id i) { return static_cast<std::size_t>(i); }
Segment segment(Id a, Id b) { return std::minmax(a, b); }

/// Finds points by their coordinates; of equal ones the first.
class PointNumbers {
 public:
  explicit PointNumbers(const std::vector<Point>& points) {
    numbered_.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) numbered_.push_back({points[i], static_cast<Id>(i)});
    const Box box = bounding_box(points);
    const double per_metre = std::min(0x1p53 / box.size().x(), 1e300);
    const auto key = [&](const Numbered& n) {
      return static_cast<std::uint64_t>((n.at.x() - box.low.x()) * per_metre);
    };
    spread_sort(numbered_, key, std::less<>());
  }
  static constexpr Id kUnknown = -1;
  Id find(const Point& p) const {
    const auto k = std::lower_bound(numbered_.begin(), numbered_.end(), Numbered{p, 0});
    return k != numbered_.end() && k->at == p ? k->id : kUnknown;
  }
  /// For each point the first equal one.
  std::vector<Id> first_of_each() const {
    std::vector<Id> first(numbered_.size());
    for (std::size_t k = 0; k < numbered_.size(); ++k) {
      const bool repeated = k > 0 && numbered_[k].at == numbered_[k - 1].at;
      first[at(numbered_[k].id)] = repeated ? first[at(numbered_[k - 1].id)] : numbered_[k].id;
    }
    return first;
  }

 private:
  struct Numbered {
    Point at;
    Id id;
    bool operator<(const Numbered& o) const { return at != o.at ? before(at, o.at) : id < o.id; }
  };
  std::vector<Numbered> numbered_;
};

/// Numbers different points in the order of their first occurrence and appends them to `points`; returns the number of
/// each point of `all`.
std::vector<Id> number_points(const std::vector<Point>& all, std::vector<Point>& points) {
  std::vector<Id> id = PointNumbers(all).first_of_each();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::size_t first = at(id[i]);
    if (first == i) points.push_back(all[i]);
    id[i] = first == i ? static_cast<Id>(points.size()) - 1 : id[first];
  }
  return id;
}

/// Sorted.
void keep_those_of_odd_number(std::vector<Segment>& edges) {
  if (!std::is_sorted(edges.begin(), edges.end())) std::sort(edges.begin(), edges.end());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    while (end < edges.size() && edges[end] == edges[i]) ++end;
    if ((end - i) % 2 == 1) edges[kept++] = edges[i];
    i = end;
  }
  edges.resize(kept);
}

TriangulationInput triangulation_input(const Region& region) {
  std::vector<Point> all;
  for_each_ring(region, [&](const Ring& ring) { all.insert(all.end(), ring.begin(), ring.end()); });
  for (const Point& p : all)
    if (!finite(p)) throw_invalid("region has a vertex that is not finite; repair it before meshing");
  TriangulationInput out;
  const std::vector<Id> id = number_points(all, out.points);
  std::size_t first = 0;
  for_each_ring(region, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    const auto add = [&](std::size_t i, std::size_t j) {
      if (id[first + i] != id[first + j]) out.edges.push_back(segment(id[first + i], id[first + j]));
    };
    for (std::size_t i = 0; i + 1 < n; ++i) {
      add(i, i + 1);
      if (i == 0) add(0, n - 1);  // in sorted order, unless points are repeated
    }
    first += n;
  });
  keep_those_of_odd_number(out.edges);
  return out;
}

/// The barriers' points that are no vertices of the region, sorted, each once.
std::vector<Point> new_points(const std::vector<Polyline>& barriers, const PointNumbers& vertices) {
  std::vector<Point> fresh;
  for (const Polyline& line : barriers)
    for (const Point& p : line) {
      if (!finite(p)) throw_invalid("a barrier has a point that is not finite");
      if (vertices.find(p) == PointNumbers::kUnknown) fresh.push_back(p);
    }
  sort_unique(fresh, before);
  return fresh;
}

/// A point by which an edge is to be split.
struct Split {
  std::size_t edge;
  double along;  // metres from the edge's first end
  Id point;
  auto operator<=>(const Split&) const = default;
};

/// The points from number `first` on that lie on an edge, up to rounding. Others are ends or bends in the open.
std::vector<Split> find_splits(const Region& region, const TriangulationInput& outline, std::size_t first,
                               const PointNumbers& vertices) {
  const EdgeIndex index(region);
  const Box box = bounding_box(outline.points);
  const double near = 1e-9 * (box.size().norm() + 1e-3 * std::max(box.low.norm(), box.high.norm()));
  std::vector<Split> splits;
  for (std::size_t i = first; i < outline.points.size(); ++i) {
    const Point& p = outline.points[i];
    const auto hit = index.nearest(p, near);
    if (!hit) continue;
    const EdgeIndex::Edge& e = index.edges()[hit->edge];
    const Segment ends = segment(vertices.find(e.a), vertices.find(e.b));
    const auto edge = std::lower_bound(outline.edges.begin(), outline.edges.end(), ends);
    if (edge == outline.edges.end() || *edge != ends) continue;
    const Point& from = outline.points[at(ends.first)];
    splits.push_back({static_cast<std::size_t>(edge - outline.edges.begin()), distance(from, p), static_cast<Id>(i)});
  }
  std::sort(splits.begin(), splits.end());
  return splits;
}

void split_edges(std::vector<Segment>& edges, const std::vector<Split>& splits) {
  for (std::size_t i = 0; i < splits.size();) {
    const std::size_t edge = splits[i].edge;
    const auto [first, last] = edges[edge];
    Id from = splits[i].point;
    edges[edge] = {first, from};
    for (++i; i < splits.size() && splits[i].edge == edge; ++i) {
      edges.emplace_back(from, splits[i].point);
      from = splits[i].point;
    }
    edges.emplace_back(from, last);
  }
}

void add_barriers(const Region& region, const std::vector<Polyline>& barriers, TriangulationInput& out) {
  const PointNumbers vertices(out.points);
  const std::size_t first_new = out.points.size();
  const std::vector<Point> fresh = new_points(barriers, vertices);
  out.points.insert(out.points.end(), fresh.begin(), fresh.end());
  const PointNumbers all(out.points);
  for (const Polyline& line : barriers)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Id a = all.find(line[i - 1]), b = all.find(line[i]);
      if (a != b) out.barriers.push_back(segment(a, b));
    }
  sort_unique(out.barriers);
  if (!fresh.empty()) split_edges(out.edges, find_splits(region, out, first_new, vertices));
}

}  // namespace

TriangulationInput triangulation_input(const Region& region, const std::vector<Polyline>& barriers) {
  TriangulationInput out = triangulation_input(region);
  if (!barriers.empty() && out.edges.size() >= 3) add_barriers(region, barriers, out);
  return out;
}

}  // namespace oxturn
