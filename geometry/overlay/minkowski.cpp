// Method      As in offset.cpp, with a polygon in place of the disc. Every ring is followed with each edge shifted by
//             the vertex of the reflected body that is farthest to its left; at reflex vertices of the region the curve
//             follows the reflected body's boundary about the vertex, at the others it makes a detour over the vertex
//             itself. The winding number of all these curves together is that of the region minus the number of
//             parallelograms (edge x vertex of the body) and fans (vertex of the region x part of the body's boundary)
//             that contain the point. So "above zero" is the exact answer, whatever overlaps.
//             Parallelograms and fans are all that has to be subtracted: grow the body at a free point p from a point
//             until it first touches a wall. Either one of its vertices touches an edge, and p lies in the edge's
//             parallelogram, or its boundary touches a vertex of the region, and p lies in that vertex's fan.
// Source      McMains and Chen, "Polygon offsetting by computing winding numbers", 2005; convolution curves: Guibas,
//             Ramshaw and Stolfi, "A kinetic framework for computational geometry", 1983.
// Decisions   1. An edge parallel to a side of the body is shifted by that vertex of the side which comes first in the
//                sense of the walk. The rest of the side belongs to the fan at the edge's end, or, where the region is
//                not reflex there, to the next edge's parallelogram.
//             2. Concave chains need no special care, unlike in offset.cpp: most of their edges are shifted by the same
//                vertex, so their parallelograms lie side by side and do not cross.
#include "geometry/overlay/minkowski.hpp"

#include <algorithm>
#include <cmath>

#include "base/throw_invalid.hpp"
#include "geometry/overlay/arrangement.hpp"

namespace oxturn {
namespace {

/// The reflected body on the lattice. Its vertices are clockwise, the order in which the walk passes them at a reflex
/// vertex.
class ReflectedBody {
 public:
  /// The body is made larger by `growth` quanta (smaller, if negative).
  ReflectedBody(const Ring& body, double quantum, double growth) {
    double inner_radius = 1e300;
    for_each_edge(body, [&](const Point& a, const Point& b) {
      inner_radius = std::min(inner_radius, oxturn::cross(a, Point(b - a)) / (b - a).norm());
    });
    if (!(inner_radius > 0))
      throw_invalid("body of a Minkowski difference does not contain the origin in its interior");
    const double scale = std::max(0.0, 1 + growth * quantum / inner_radius) / quantum;
    for (auto p = body.rbegin(); p != body.rend(); ++p) {
      const LatticePoint s{static_cast<std::int32_t>(std::lround(-p->x() * scale)),
                           static_cast<std::int32_t>(std::lround(-p->y() * scale))};
      if (vertices_.empty() || vertices_.back() != s) vertices_.push_back(s);
    }
    while (vertices_.size() > 1 && vertices_.back() == vertices_.front()) vertices_.pop_back();
  }

  /// The vertex farthest to the left of direction d; of two, the first in the sense of the walk.
  std::size_t farthest_left(const LatticePoint& d) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < vertices_.size(); ++i) {
      const std::int64_t gain = cross(d, vertices_[i]) - cross(d, vertices_[best]);
      if (gain > 0 || (gain == 0 && dot(d, vertices_[i]) < dot(d, vertices_[best]))) best = i;
    }
    return best;
  }
  /// The whole boundary about a point, clockwise.
  std::vector<LatticePoint> about(const LatticePoint& centre) const {
    std::vector<LatticePoint> ring;
    for (const LatticePoint& s : vertices_) ring.push_back(centre + s);
    return ring;
  }
  const LatticePoint& vertex(std::size_t i) const { return vertices_[i]; }
  std::size_t next(std::size_t i) const { return i + 1 == vertices_.size() ? 0 : i + 1; }

 private:
  std::vector<LatticePoint> vertices_;
};

/// The convolution curve of a ring of at least two points.
std::vector<LatticePoint> convolution(const std::vector<LatticePoint>& ring, const ReflectedBody& body) {
  std::vector<LatticePoint> out;
  const std::size_t n = ring.size();
  std::vector<LatticePoint> along(n);
  std::vector<std::size_t> shift(n);  // by edge: the body's vertex
  for (std::size_t i = 0; i < n; ++i) {
    along[i] = ring[i + 1 == n ? 0 : i + 1] - ring[i];
    shift[i] = body.farthest_left(along[i]);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t last = i == 0 ? n - 1 : i - 1;
    out.push_back(ring[i] + body.vertex(shift[last]));
    if (cross(along[last], along[i]) > 0) {
      if (shift[last] != shift[i]) out.push_back(ring[i]);
    } else {  // reflex; where the ring runs straight back on itself, half the body's boundary
      for (std::size_t k = shift[last]; k != shift[i]; k = body.next(k)) out.push_back(ring[i] + body.vertex(k));
    }
    out.push_back(ring[i] + body.vertex(shift[i]));
  }
  return out;
}

}  // namespace

Region erode(const Region& region, const Ring& body, Bound bound) {
  Box box = finite_box(region);
  const Box body_box = bounding_box(body);
  for (const Point& p : body)
    if (!finite(p)) throw_invalid("body of a Minkowski difference has a coordinate that is not finite");
  if (body.empty()) throw_invalid("body of a Minkowski difference has no vertices");
  if (box.empty()) return region;
  box.grow(1.5 * std::max(body_box.high.cwiseAbs().maxCoeff(), body_box.low.cwiseAbs().maxCoeff()));
  const Lattice lattice(box);
  const ReflectedBody grown(body, lattice.quantum(), bound == Bound::inside ? kOffsetSlack : -kOffsetSlack);

  std::vector<OverlayEdge> edges;
  for_each_snapped_ring(region, lattice, [&](const std::vector<LatticePoint>& ring, RingKind kind) {
    if (ring.size() > 1)
      add_ring(edges, convolution(ring, grown), {1, 0});
    else if (kind == RingKind::hole)  // smaller than the lattice resolves: no free space, but still a wall
      add_ring(edges, grown.about(ring[0]), {1, 0});
  });
  return to_region(boundary_of(std::move(edges), inside_first), lattice);
}

}  // namespace oxturn
