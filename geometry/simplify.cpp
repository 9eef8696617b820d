// Method      Vertices are removed in the order of the error that this makes. Removing a convex vertex (seen from free
//             space) cuts a triangle off free space; a reflex vertex would add one, so it goes only once it is exactly
//             collinear. A vertex stays if its triangle contains any other vertex, so rings never touch or cross.
// Complexity  O(n log n) for usual data, plus for each new edge the removed vertices that it replaces.
#include <algorithm>
#include <queue>

#include "geometry/predicates.hpp"
#include "geometry/raster.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

class Simplifier {
 public:
  Simplifier(const Region& region, double tolerance, const Box& within) : tolerance_(tolerance), within_(within) {
    vertices_.reserve(vertex_count(region));
    for_each_ring(region, [&](const Ring& ring) {
      const auto first = static_cast<Id>(vertices_.size()), n = static_cast<Id>(ring.size());
      for (Id k = 0; k < n; ++k)
        vertices_.push_back({ring[k], first + (k + n - 1) % n, first + (k + 1) % n, static_cast<Id>(rings_.size())});
      rings_.push_back({first, n, n});
    });
    replaced_.resize(vertices_.size());
    for (Id v = 0; v < vertices_.size(); ++v)
      if (within_.contains(vertices_[v].at)) obstacles_.push_back(v);
    grid_ = UniformGrid(obstacles_.size(), [&](std::size_t k) { return std::array{vertices_[obstacles_[k]].at}; });
  }

  void run() {
    for (Id v = 0; v < vertices_.size(); ++v) consider(v);
    while (!queue_.empty()) {
      const Candidate c = queue_.top();
      queue_.pop();
      const Vertex& v = vertices_[c.vertex];
      if (v.removed || v.version != c.version) continue;
      if (rings_[v.ring].left > 3 && empty_triangle(c.vertex)) remove(c.vertex);
    }
  }

  /// `region` with what is left of its rings.
  Region result(Region region) const {
    std::size_t number = 0;
    for_each_ring(region, [&](Ring& ring) {
      const RingOfVertices& r = rings_[number++];
      ring.clear();
      Id first = r.first;
      while (first < r.first + r.size && vertices_[first].removed) ++first;
      Id v = first;
      do {
        ring.push_back(vertices_[v].at);
        v = vertices_[v].next;
      } while (v != first);
    });
    return region;
  }

 private:
  using Id = std::uint32_t;  // of a vertex, in input order
  struct Vertex {
    Point at;
    Id previous, next, ring;
    std::uint32_t version = 0;  // counts the changes of its neighbours
    bool removed = false;
  };
  struct RingOfVertices {
    Id first, size, left;
  };
  struct Candidate {
    double error;
    Id vertex;
    std::uint32_t version;
    bool operator<(const Candidate& o) const {  // the queue's top has the least error, then the lowest number
      return error != o.error ? error > o.error : vertex > o.vertex;
    }
  };

  /// Queues the vertex if it may be removed as far as its error tells.
  void consider(Id id) {
    Vertex& v = vertices_[id];
    ++v.version;
    const Point &u = vertices_[v.previous].at, &w = vertices_[v.next].at;
    const int turn = orientation(u, v.at, w);
    if (turn < 0 || (turn > 0 && !(within_.contains(u) && within_.contains(v.at) && within_.contains(w)))) return;
    double error = distance_to_segment(v.at, u, w);
    for (const Id edge : {v.previous, id})
      for (const Id r : replaced_[edge]) error = std::max(error, distance_to_segment(vertices_[r].at, u, w));
    if (turn == 0 || error <= tolerance_) queue_.push({turn == 0 ? 0 : error, id, v.version});
  }

  /// Is there no other vertex in the closed triangle of the vertex and its neighbours? Always true for a collinear one:
  /// where another ring touches the edge, it touches as before.
  bool empty_triangle(Id id) const {
    const Id before = vertices_[id].previous, after = vertices_[id].next;
    const std::array corner{vertices_[before].at, vertices_[id].at, vertices_[after].at};
    if (orientation(corner[0], corner[1], corner[2]) == 0) return true;
    const auto inside = [&](Id p) {
      if (vertices_[p].removed || p == before || p == id || p == after) return false;
      const Point& at = vertices_[p].at;
      return orientation(corner[0], corner[1], at) >= 0 && orientation(corner[1], corner[2], at) >= 0 &&
             orientation(corner[2], corner[0], at) >= 0;
    };
    return !grid_.visit_items(corner, 0, [&](std::uint32_t k) { return inside(obstacles_[k]); });
  }

  void remove(Id id) {
    Vertex& v = vertices_[id];
    const Id before = v.previous, after = v.next;
    std::vector<Id>& replaced = replaced_[before];
    replaced.push_back(id);
    replaced.insert(replaced.end(), replaced_[id].begin(), replaced_[id].end());
    replaced_[id] = {};
    v.removed = true;
    vertices_[before].next = after;
    vertices_[after].previous = before;
    --rings_[v.ring].left;
    consider(before);
    consider(after);
  }

  double tolerance_;
  Box within_;
  std::vector<Vertex> vertices_;
  std::vector<RingOfVertices> rings_;
  std::vector<std::vector<Id>> replaced_;  // by vertex: the removed ones that the edge from there on replaces
  std::priority_queue<Candidate> queue_;
  std::vector<Id> obstacles_;  // the vertices that a triangle may contain
  UniformGrid grid_;           // of obstacles_
};

}  // namespace

Region simplify_inward(const Region& region, double tolerance) {
  return simplify_inward(region, tolerance, bounding_box(region));
}

Region simplify_inward(const Region& region, double tolerance, const Box& within) {
  Simplifier simplifier(region, tolerance, within);
  simplifier.run();
  return simplifier.result(region);
}

}  // namespace oxturn
