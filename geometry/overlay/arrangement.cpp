#include "geometry/overlay/arrangement.hpp"

#include "base/disjoint_sets.hpp"
#include "geometry/overlay/edge_below.hpp"
#include "geometry/overlay/half_edges.hpp"
#include "geometry/overlay/resolve.hpp"

namespace oxturn {
namespace {

/// Computes the winding numbers to the left of each edge a -> b: component by component, or, where millions of edges do
/// not fit in the processor's cache, from left to right, as they are stored. To follow them wherever they lead takes
/// twice as long then.
class WindingNumbers {
 public:
  explicit WindingNumbers(const std::vector<OverlayEdge>& edges)
      : edges_(edges),
        fans_(edges.size(), Ends{edges}),
        below_(edges.size(), Ends{edges}),
        left_(edges.size()),
        reached_(fans_.vertices(), 0) {}

  std::vector<Windings> run() {
    edges_.size() <= kInCache ? run_by_components() : run_from_left();
    return std::move(left_);
  }

 private:
  static constexpr std::size_t kInCache = std::size_t{1} << 15;  // edges
  struct Ends {
    const std::vector<OverlayEdge>& edges;
    std::pair<LatticePoint, LatticePoint> operator()(std::uint32_t e) const { return {edges[e].a, edges[e].b}; }
  };

  /// In the order of their first vertices: what lies below such a vertex is known by then.
  void run_by_components() {
    passed_ = static_cast<std::uint32_t>(fans_.vertices());
    for (std::uint32_t root = 0; root < passed_; ++root) {
      if (reached_[root] != 0) continue;
      begin_at(root);
      follow_open();
    }
  }
  void run_from_left() {
    const std::vector<std::uint32_t> roots = first_vertices();
    std::vector<std::uint32_t> waiting;  // what lies below them is not known yet
    auto root = roots.begin();
    for (passed_ = 0; passed_ < fans_.vertices(); ++passed_) {
      if (root != roots.end() && *root == passed_ && !begin_at(*root++)) waiting.push_back(passed_);
      if (reached_[passed_] == 0) reach_from_left(passed_);
      follow_open();
    }
    for (const std::uint32_t r : waiting) {
      begin_at(r);
      follow_open();
    }
  }

  /// Of each connected component, ascending.
  std::vector<std::uint32_t> first_vertices() const {
    DisjointSets components(fans_.vertices());
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      components.unite(fans_.tail(HalfEdge::forward(e)), fans_.tail(HalfEdge::backward(e)));
    std::vector<bool> met(fans_.vertices());
    std::vector<std::uint32_t> first;
    for (std::uint32_t v = 0; v < fans_.vertices(); ++v) {
      const std::size_t component = components.find(v);
      if (!met[component]) first.push_back(v);
      met[component] = true;
    }
    return first;
  }
  /// A component, at its first vertex. False, if what lies below is not known yet.
  bool begin_at(std::uint32_t root) {
    const std::uint32_t e = below_.below(edges_[fans_.at(root).front().edge()].a);
    if (e != EdgeBelow::kNone && reached_[fans_.tail(HalfEdge::forward(e))] == 0 &&
        reached_[fans_.tail(HalfEdge::backward(e))] == 0)
      return false;
    walk_around(root, first_from_below(root), e == EdgeBelow::kNone ? Windings{} : left_[e]);
    return true;
  }
  /// From an edge that ends there and is known, if there is one. Otherwise what the vertex is connected with follows.
  void reach_from_left(std::uint32_t vertex) {
    const auto fan = fans_.at(vertex);
    for (std::size_t k = 0; k < fan.size(); ++k)
      if (!fan[k].is_forward() && reached_[fans_.head(fan[k])] != 0) return walk_around(vertex, k, right_of(fan[k]));
  }
  /// Back to vertices that have been passed.
  void follow_open() {
    while (!open_.empty()) {
      const HalfEdge h = open_.back();
      open_.pop_back();
      if (reached_[fans_.tail(h)] == 0) walk_around(fans_.tail(h), fans_.position(h), right_of(h));
    }
  }
  /// The position of the half-edge just counter-clockwise of straight down at a component's first vertex: all lead to
  /// the right or straight up.
  std::size_t first_from_below(std::uint32_t root) const {
    const auto fan = fans_.at(root);
    if (fan.size() != 2) return 0;
    const OverlayEdge &e = edges_[fan[0].edge()], &f = edges_[fan[1].edge()];
    return twice_area(e.a, e.b, f.b) < 0 ? 1 : 0;
  }
  /// All about a vertex; `before` are the winding numbers just clockwise of the half-edge at `position`.
  void walk_around(std::uint32_t vertex, std::size_t position, Windings before) {
    reached_[vertex] = 1;
    const auto fan = fans_.at(vertex);
    std::int32_t first = before.first, second = before.second;  // two numbers stay in registers
    for (std::size_t k = 0, i = position; k < fan.size(); ++k, i = i + 1 == fan.size() ? 0 : i + 1) {
      const HalfEdge h = fan[i];
      const OverlayEdge& e = edges_[h.edge()];
      if (h.is_forward()) first += e.weight.first, second += e.weight.second;
      left_[h.edge()] = {first, second};
      if (!h.is_forward()) first -= e.weight.first, second -= e.weight.second;
      if (fans_.head(h) < passed_ && reached_[fans_.head(h)] == 0) open_.push_back(h.twin());
    }
  }
  Windings right_of(HalfEdge h) const {
    const Windings left_of_edge = left_[h.edge()];
    return h.is_forward() ? left_of_edge - edges_[h.edge()].weight : left_of_edge;
  }

  const std::vector<OverlayEdge>& edges_;
  VertexFans fans_;
  FewEdgesBelow<Ends> below_;
  std::vector<Windings> left_;
  std::vector<std::uint8_t> reached_;  // by vertex
  std::uint32_t passed_ = 0;           // so many vertices: the others are reached when it is their turn
  std::vector<HalfEdge> open_;         // their edges are known, the vertices they leave are not
};

}  // namespace

void add_ring(std::vector<OverlayEdge>& edges, const std::vector<LatticePoint>& ring, Windings weight) {
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
    directed(ring[j], ring[i], weight, [&](const OverlayEdge& e) { edges.push_back(e); });
}

void add_region(std::vector<OverlayEdge>& edges, const Region& region, const Lattice& lattice, Windings weight) {
  for_each_snapped_ring(region, lattice,
                        [&](const std::vector<LatticePoint>& ring, RingKind) { add_ring(edges, ring, weight); });
}

void add_boundary(std::vector<OverlayEdge>& edges, const std::vector<BoundaryEdge>& boundary, Windings weight) {
  for (const BoundaryEdge& b : boundary)
    directed(b.from, b.to, weight, [&](const OverlayEdge& e) { edges.push_back(e); });
}

namespace {

std::vector<BoundaryEdge> boundary_where(const std::vector<OverlayEdge>& edges, const std::vector<Windings>& left,
                                         Inside inside) {
  std::vector<BoundaryEdge> out;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const OverlayEdge& e = edges[i];
    const bool inside_left = inside(left[i]);
    if (inside_left == inside(left[i] - e.weight)) continue;
    out.push_back(inside_left ? BoundaryEdge{e.a, e.b} : BoundaryEdge{e.b, e.a});
  }
  return out;
}

}  // namespace

std::vector<BoundaryEdge> boundary_of(std::vector<OverlayEdge> edges, Inside inside) {
  resolve(edges);
  return boundary_where(edges, WindingNumbers(edges).run(), inside);
}

std::array<std::vector<BoundaryEdge>, 2> boundaries_of(std::vector<OverlayEdge> edges, std::array<Inside, 2> inside) {
  resolve(edges);
  const std::vector<Windings> left = WindingNumbers(edges).run();
  return {boundary_where(edges, left, inside[0]), boundary_where(edges, left, inside[1])};
}

}  // namespace oxturn
