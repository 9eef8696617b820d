#include "geometry/mesh/shortest_bridges.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "geometry/overlay/lattice.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kRunEdges = 16;  // of a run, at most, and
constexpr double kRunSize = 4;         // cells of the grid that it extends over

/// A straight line between two edges, the lower one first.
struct Link {
  double length = kInfinity;
  std::size_t edge = 0, other = 0;
  Point from{0, 0}, to{0, 0};
};

/// A lower bound of the distance between two boxes, rounding included.
double gap(const Box& a, const Box& b) { return (b.low - a.high).cwiseMax(a.low - b.high).maxCoeff() * (1 - 1e-9); }

/// Of one polygon. Edges are numbered ring by ring.
class SpanningTree {
 public:
  explicit SpanningTree(const Polygon& polygon) {
    add_ring(polygon.outer);
    for (const Ring& hole : polygon.holes) add_ring(hole);
    grid_ = UniformGrid(edges_.size(), [&](std::size_t e) { return edges_[e]; });
    for (const Edge& e : edges_) boxes_.push_back(box_of(e));
    make_runs();
  }

  std::vector<Link> links() {
    std::vector<Link> tree;
    DisjointSets sets(rings_);
    while (tree.size() + 1 < rings_) {
      number_components(sets);
      std::vector<Link> nearest(components_);
      for (Run& run : runs_)
        if (component_[run.ring] != largest_) look_near(run, nearest[component_[run.ring]]);
      for (const Link& link : nearest)
        if (link.length < kInfinity && sets.unite(ring_[link.edge], ring_[link.other])) tree.push_back(link);
    }
    return tree;
  }

 private:
  using Edge = std::array<Point, 2>;
  /// Consecutive edges of a ring. Nothing of another component is nearer than `reached`.
  struct Run {
    std::size_t ring, first, end;
    Box box;
    double reached = 0;
  };

  static Box box_of(const Edge& e) { return {e[0].cwiseMin(e[1]), e[0].cwiseMax(e[1])}; }

  void add_ring(const Ring& ring) {
    for_each_edge(ring, [&](const Point& a, const Point& b) {
      edges_.push_back({a, b});
      ring_.push_back(rings_);
    });
    ++rings_;
  }

  void make_runs() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (!runs_.empty() && runs_.back().ring == ring_[e] && e - runs_.back().first < kRunEdges) {
        Box both = runs_.back().box;
        both.add(boxes_[e]);
        if (both.size().maxCoeff() < kRunSize * grid_.cell()) {
          runs_.back().box = both;
          runs_.back().end = e + 1;
          continue;
        }
      }
      runs_.push_back({ring_[e], e, e + 1, boxes_[e]});
    }
  }

  /// Components in the order of their first rings; the largest has the most runs.
  void number_components(DisjointSets& sets) {
    std::vector<std::size_t> number(rings_, rings_), size;
    component_.resize(rings_);
    for (std::size_t r = 0; r < rings_; ++r) {
      std::size_t& n = number[sets.find(r)];
      if (n == rings_) n = size.size(), size.push_back(0);
      component_[r] = n;
    }
    for (const Run& run : runs_) ++size[component_[run.ring]];
    components_ = size.size();
    largest_ = static_cast<std::size_t>(std::ranges::max_element(size) - size.begin());
  }

  /// Whatever is nearer to a run than the best that its component has found becomes the best.
  void look_near(Run& run, Link& best) const {
    const double whole = (grid_.high() - grid_.low()).norm();
    for (double reach = std::max(run.reached, grid_.cell()); run.reached < best.length; reach *= 2) {
      look_within(run, std::min(reach, best.length), best);
      run.reached = std::min(reach, best.length);
      if (reach > whole) return;
    }
  }

  void look_within(const Run& run, double reach, Link& best) const {
    const auto try_cell = [&](std::size_t cell) {
      for (const std::uint32_t other : grid_.items(cell))
        if (component_[ring_[other]] != component_[run.ring] && gap(run.box, boxes_[other]) <= best.length)
          for (std::size_t e = run.first; e < run.end; ++e) offer(e, other, best);
      return false;
    };
    const Point &low = run.box.low, &high = run.box.high;
    if (run.end == run.first + 1)
      grid_.visit(edges_[run.first], reach, try_cell);
    else
      grid_.visit(std::array{low, Point(high.x(), low.y()), high, Point(low.x(), high.y())}, reach, try_cell);
  }

  void offer(std::size_t edge, std::size_t other, Link& best) const {
    if (gap(boxes_[edge], boxes_[other]) > best.length) return;
    if (other < edge) std::swap(edge, other);
    const auto& [a, b] = edges_[edge];
    const auto& [c, d] = edges_[other];
    const auto try_line = [&](const Point& p, const Point& q) {
      const double far = distance(p, q);
      if (far < best.length || (far == best.length && std::tie(edge, other) < std::tie(best.edge, best.other)))
        best = {far, edge, other, p, q};
    };
    try_line(a, nearest_on_segment(a, c, d));
    try_line(b, nearest_on_segment(b, c, d));
    try_line(nearest_on_segment(c, a, b), c);
    try_line(nearest_on_segment(d, a, b), d);
  }

  std::vector<Edge> edges_;
  std::vector<Box> boxes_;         // of edges
  std::vector<std::size_t> ring_;  // of an edge
  std::size_t rings_ = 0;
  UniformGrid grid_;
  std::vector<Run> runs_;
  std::vector<std::size_t> component_;  // of a ring
  std::size_t components_ = 0, largest_ = 0;
};

}  // namespace

std::vector<Polyline> shortest_bridges(const Region& region) {
  if (finite_box(region).empty()) return {};
  std::vector<Link> links;
  for (const Polygon& polygon : region.polygons)
    if (!polygon.holes.empty())
      for (const Link& link : SpanningTree(polygon).links()) links.push_back(link);
  std::ranges::stable_sort(links, {}, &Link::length);
  std::vector<Polyline> lines;
  for (const Link& link : links) lines.push_back({link.from, link.to});
  return lines;
}

}  // namespace oxturn
