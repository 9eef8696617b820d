// Method      contains(p): each cell has a reference point whose location is known. From there to any point of the cell
//             only the cell's own edges can be crossed, so parity decides.
//             contains(a, b): no edge may be crossed. Where the segment touches edges (vertices on it, its ends on
//             edges, parts that run along edges), the edges through that point divide its neighbourhood into sectors,
//             and the directions towards a and b must lie in free ones. Between such points the segment cannot change
//             sides.
#include "geometry/edge_index.hpp"

#include <algorithm>
#include <cmath>

#include "base/sorting.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Edge = EdgeIndex::Edge;

/// Does the direction from v towards `to` lead into closed free space, judged by the edges through v alone? Each edge
/// gives one or two rays from v. Free space lies counter-clockwise of an outgoing edge and clockwise of an incoming
/// one, so the first ray met when turning clockwise from `to` decides.
class Sector {
 public:
  Sector(const Point& v, const Point& to) : v_(v), to_(to) {}
  void add(const Edge& e) {
    if (e.a != v_) add_ray(e.a, Direction::incoming);
    if (e.b != v_) add_ray(e.b, Direction::outgoing);
  }
  bool free() const { return along_edge_ || !any_ || first_ == Direction::outgoing; }

 private:
  enum class Direction { incoming, outgoing };

  void add_ray(const Point& w, Direction direction) {
    const int turn = orientation(v_, to_, w);
    if (turn == 0 && !on_segment(v_, to_, w)) {
      along_edge_ = true;  // collinear and v not between the two: the same direction
      return;
    }
    const int half = turn < 0 ? 0 : turn > 0 ? 2 : 1;  // clockwise of `to` by less than, more than or just 180 degrees
    const int order = !any_ || half < half_ ? -1 : half > half_ ? 1 : orientation(v_, w_, w);
    // Of two edges on the same ray the outgoing one comes first.
    const bool comes_first =
        !any_ || half < half_ || (half == half_ && (order > 0 || (order == 0 && direction == Direction::outgoing)));
    if (!comes_first) return;
    any_ = true;
    half_ = half;
    w_ = w;
    first_ = direction;
  }

  Point v_, to_, w_{0, 0};
  int half_ = 0;
  bool any_ = false, along_edge_ = false;
  Direction first_ = Direction::incoming;
};

/// Where ab meets the edge, which it does; rounded.
Point meeting_point(const Point& a, const Point& b, const Edge& e) {
  const Point d = b - a, f = e.b - e.a;
  const double across = cross(d, f);
  if (across == 0) return on_segment(e.a, a, b) ? e.a : on_segment(e.b, a, b) ? e.b : a;
  return lerp(a, b, std::clamp(cross(e.a - a, f) / across, 0.0, 1.0));
}

/// Replaces `best` if the new pair of points is nearer, or as near on a lower edge.
void offer(EdgeIndex::Nearest& best, const Point& from, const Point& point, std::size_t edge) {
  constexpr double kRounding = 1 + 1e-14;
  const double d2 = (from - point).squaredNorm();
  if (d2 > kRounding * best.distance * best.distance) return;  // most are farther: no square root
  const double d = std::sqrt(d2);
  if (d < best.distance || (d == best.distance && edge < best.edge)) best = {d, point, from, edge};
}

/// A lower bound of the distance of two segments: that of their bounding boxes.
double box_gap(const Point& a, const Point& b, const Edge& e) {
  const Point low = a.cwiseMin(b), high = a.cwiseMax(b), elow = e.a.cwiseMin(e.b), ehigh = e.a.cwiseMax(e.b);
  const double x = std::max({0.0, elow.x() - high.x(), low.x() - ehigh.x()});
  const double y = std::max({0.0, elow.y() - high.y(), low.y() - ehigh.y()});
  return std::max(x, y);
}

}  // namespace

EdgeIndex::EdgeIndex(const Region& region) {
  edges_.reserve(vertex_count(region));
  for_each_edge(region, [&](const Point& a, const Point& b) {
    if (a != b) edges_.push_back({a, b});
  });
  grid_ = UniformGrid(edges_.size(), [&](std::size_t i) { return std::array{edges_[i].a, edges_[i].b}; });
  choose_references();
}

/// Calls try_edge for the edges in square rings of cells about p, until the rest is farther than `best`.
template <class TryEdge>
void EdgeIndex::try_rings(const Point& p, const Nearest& best, TryEdge try_edge) const {
  // The rings are centred at q, the point of the grid's box nearest to p. For z in the box
  // |p - z|^2 >= |p - q|^2 + |q - z|^2.
  const Point q = p.cwiseMax(grid_.low()).cwiseMin(grid_.high());
  const double off2 = (p - q).squaredNorm();
  const int ci = grid_.column(q.x()), cj = grid_.row(q.y());
  const int most = std::max({ci, cj, grid_.columns() - 1 - ci, grid_.rows() - 1 - cj});
  const Point in_cell = (q - grid_.low()) / grid_.cell() - Point(ci, cj);
  const double margin = std::clamp(std::min(in_cell.minCoeff(), 1 - in_cell.maxCoeff()), 0.0, 1.0) - 1e-7;
  for (int r = 0; r <= most; ++r) {
    const double gap = r == 0 ? 0 : (r - 1 + margin) * grid_.cell();
    if (std::sqrt(off2 + (gap > 0 ? gap * gap : 0)) > best.distance) return;
    const int bottom = std::max(0, cj - r), top = std::min(grid_.rows() - 1, cj + r);
    const int left = ci - r, right = ci + r, last = grid_.columns() - 1;
    for (int j = bottom; j <= top; ++j) {
      const auto try_cells = [&](int from, int to) {
        for (const std::uint32_t e : grid_.items(from, to, j)) try_edge(e);
      };
      if (j == cj - r || j == cj + r) {
        try_cells(std::max(0, left), std::min(last, right));
      } else {
        if (left >= 0) try_cells(left, left);
        if (right <= last) try_cells(right, right);
      }
    }
  }
}

std::optional<EdgeIndex::Nearest> EdgeIndex::nearest(const Point& p, double within) const {
  if (grid_.empty() || !finite(p)) return std::nullopt;
  Nearest best;
  best.distance = within;
  best.edge = edges_.size();
  try_rings(p, best, [&](std::uint32_t e) { offer(best, p, nearest_on_segment(p, edges_[e].a, edges_[e].b), e); });
  if (best.edge == edges_.size() || !(best.distance < within)) return std::nullopt;
  return best;
}

std::optional<EdgeIndex::Nearest> EdgeIndex::nearest(const Point& a, const Point& b, double within) const {
  if (a == b) return nearest(a, within);
  if (grid_.empty() || !finite(a) || !finite(b)) return std::nullopt;
  Nearest best;
  best.distance = within;
  best.edge = edges_.size();
  const auto try_edge = [&](std::uint32_t index) {
    const Edge& e = edges_[index];
    if (box_gap(a, b, e) > best.distance) return;
    if (orientation(a, b, e.a) * orientation(a, b, e.b) <= 0 && crossing(a, b, e.a, e.b) != Crossing::none) {
      const Point point = meeting_point(a, b, e);
      if (best.distance > 0 || index < best.edge) best = {0, point, point, index};
      return;
    }
    offer(best, a, nearest_on_segment(a, e.a, e.b), index);
    offer(best, b, nearest_on_segment(b, e.a, e.b), index);
    offer(best, nearest_on_segment(e.a, a, b), e.a, index);
    offer(best, nearest_on_segment(e.b, a, b), e.b, index);
  };
  // Bands about the segment that double in width, so that the last one dominates the cost.
  const double whole = (grid_.high() - grid_.low()).norm() + distance_to_segment(grid_.low(), a, b);
  for (double band = std::min(within, grid_.cell() / 2);; band = std::min({within, whole, 2 * band})) {
    grid_.visit(std::array{a, b}, band, [&](std::size_t c) {
      for (const std::uint32_t e : grid_.items(c)) try_edge(e);
      return best.distance == 0;
    });
    if (best.distance <= band || band >= within || band >= whole) break;
  }
  if (best.edge == edges_.size() || !(best.distance < within)) return std::nullopt;
  return best;
}

/// Candidates differ in both coordinates; multiples of the golden ratio spread their heights over the cell.
Point EdgeIndex::reference_point(std::size_t cell) const {
  const int columns = grid_.columns(), k = references_[cell].candidate;
  const auto i = static_cast<double>(cell % static_cast<std::size_t>(columns));
  const auto j = static_cast<double>(cell / static_cast<std::size_t>(columns));
  const double up = k == 0 ? 0.5 : std::fmod(0.5 + 0.6180339887498949 * k, 1.0);
  return grid_.low() + grid_.cell() * Point(i + (k + 0.5) / kCandidates, j + up);
}

/// Does the edge cross the segment pq? Neither p nor q may lie on the edge. A vertex exactly on the segment counts once
/// for its two edges if the boundary crosses there, and twice or never if it does not.
bool EdgeIndex::separates(const Point& p, const Point& q, std::uint32_t edge) const {
  const Edge& e = edges_[edge];
  if (std::min(e.a.y(), e.b.y()) > std::max(p.y(), q.y()) || std::max(e.a.y(), e.b.y()) < std::min(p.y(), q.y()) ||
      std::min(e.a.x(), e.b.x()) > std::max(p.x(), q.x()) || std::max(e.a.x(), e.b.x()) < std::min(p.x(), q.x()))
    return false;
  if ((orientation(p, q, e.a) > 0) == (orientation(p, q, e.b) > 0)) return false;
  return orientation(e.a, e.b, p) * orientation(e.a, e.b, q) < 0;
}

/// Row by row, from a point outside to the right: the parity of the edges between two neighbouring cells' reference
/// points.
void EdgeIndex::choose_references() {
  references_.assign(static_cast<std::size_t>(grid_.columns()) * static_cast<std::size_t>(grid_.rows()), {});
  const auto on_edge = [&](std::size_t c) {
    const Point p = reference_point(c);
    const auto items = grid_.items(c);
    return std::ranges::any_of(items, [&](std::uint32_t e) { return on_segment(p, edges_[e].a, edges_[e].b); });
  };
  for (int j = 0; j < grid_.rows(); ++j) {
    Point last = grid_.low() + grid_.cell() * Point(-1, j + 0.5);  // outside
    bool inside = false;
    for (int i = 0; i < grid_.columns(); ++i) {
      const std::size_t c = grid_.index(i, j);
      for (int k = 1; on_edge(c); ++k) {
        if (k == kCandidates) throw_invalid("a region's edges lie too close together to tell inside from outside");
        references_[c].candidate = static_cast<std::uint8_t>(k) & 0x7f;
      }
      const Point here = reference_point(c);
      const auto items = grid_.items(c);
      for (const std::uint32_t e : items) inside ^= separates(last, here, e);
      if (i > 0)
        for (const std::uint32_t e : grid_.items(c - 1))
          if (!std::ranges::binary_search(items, e)) inside ^= separates(last, here, e);
      references_[c].inside = inside;
      last = here;
    }
  }
}

bool EdgeIndex::on_boundary(const Point& p) const {
  if (grid_.empty() || !Box{grid_.low(), grid_.high()}.contains(p)) return false;
  const auto items = grid_.items(grid_.index(grid_.column(p.x()), grid_.row(p.y())));
  return std::ranges::any_of(items, [&](std::uint32_t e) { return on_segment(p, edges_[e].a, edges_[e].b); });
}

bool EdgeIndex::contains(const Point& p) const {
  if (grid_.empty() || !Box{grid_.low(), grid_.high()}.contains(p)) return false;
  const std::size_t c = grid_.index(grid_.column(p.x()), grid_.row(p.y()));
  bool inside = references_[c].inside;
  const Point from = reference_point(c);
  for (const std::uint32_t e : grid_.items(c)) {
    if (on_segment(p, edges_[e].a, edges_[e].b)) return true;
    inside ^= separates(from, p, e);
  }
  return inside;
}

bool EdgeIndex::contains(const Point& a, const Point& b) const {
  if (a == b) return contains(a);
  if (grid_.empty() || !finite(a) || !finite(b)) return false;
  std::optional<Contacts> found = contacts(a, b);
  if (!found) return false;
  std::vector<Touch>& touches = found->touches;
  if (touches.empty()) return contains(a);
  if (touches.front().point != a && touches.back().point != a && !contains(a)) return false;
  add_vertices_passed(*found);
  return free_at_touches(touches, a, b);
}

/// All touches of ab, sorted; nullopt if it crosses an edge.
std::optional<EdgeIndex::Contacts> EdgeIndex::contacts(const Point& a, const Point& b) const {
  Contacts found;
  const Point least = a.cwiseMin(b), most = a.cwiseMax(b);
  const auto crosses = [&](std::uint32_t index) {
    const Edge& e = edges_[index];
    if (std::max(e.a.x(), e.b.x()) < least.x() || std::min(e.a.x(), e.b.x()) > most.x() ||
        std::max(e.a.y(), e.b.y()) < least.y() || std::min(e.a.y(), e.b.y()) > most.y())
      return false;
    const int sa = orientation(a, b, e.a), sb = orientation(a, b, e.b);
    if (sa * sb > 0) return false;
    const int ta = orientation(e.a, e.b, a), tb = orientation(e.a, e.b, b);
    if (ta * tb > 0) return false;
    if (sa * sb < 0 && ta * tb < 0) {
      const Point* vertex = vertex_on(e, a, b);
      if (vertex != nullptr) found.touches.push_back({*vertex, index});
      return vertex == nullptr;
    }
    if (sa == 0 && on_segment(e.a, a, b)) found.touches.push_back({e.a, index});
    if (sb == 0 && on_segment(e.b, a, b)) found.touches.push_back({e.b, index});
    if (ta == 0 && on_segment(a, e.a, e.b)) found.touches.push_back({a, index});
    if (tb == 0 && on_segment(b, e.a, e.b)) found.touches.push_back({b, index});
    if (sa == 0 && sb == 0) found.along.push_back(index);
    return false;
  };
  if (grid_.visit_items(std::array{a, b}, 0, crosses)) return std::nullopt;
  sort_unique(found.touches);
  sort_unique(found.along);
  return found;
}

/// A vertex of another ring that lies exactly on both segments: then the edge is touched there, not crossed. Otherwise
/// nullptr.
const Point* EdgeIndex::vertex_on(const Edge& edge, const Point& a, const Point& b) const {
  const Point p = meeting_point(a, b, edge);
  for (const std::uint32_t i : grid_.items(grid_.index(grid_.column(p.x()), grid_.row(p.y()))))
    for (const Point* w : {&edges_[i].a, &edges_[i].b})
      if (on_segment(*w, edge.a, edge.b) && on_segment(*w, a, b)) return w;
  return nullptr;
}

/// Edges along the segment also pass through the vertices of other edges on them.
void EdgeIndex::add_vertices_passed(Contacts& contacts) const {
  std::vector<Touch>& touches = contacts.touches;
  const std::size_t own = touches.size();
  for (const std::uint32_t i : contacts.along) {
    const Point low = before(edges_[i].a, edges_[i].b) ? edges_[i].a : edges_[i].b;
    const Point high = low == edges_[i].a ? edges_[i].b : edges_[i].a;
    const auto end = touches.begin() + static_cast<std::ptrdiff_t>(own);
    auto at =
        std::lower_bound(touches.begin(), end, low, [](const Touch& t, const Point& p) { return before(t.point, p); });
    std::vector<Point> passed;
    for (; at != end && !before(high, at->point); ++at)
      if (passed.empty() || passed.back() != at->point) passed.push_back(at->point);
    for (const Point& p : passed) touches.push_back({p, i});
  }
  if (touches.size() > own) sort_unique(touches);
}

bool EdgeIndex::free_at_touches(const std::vector<Touch>& touches, const Point& a, const Point& b) const {
  for (std::size_t i = 0; i < touches.size();) {
    const Point& v = touches[i].point;
    std::size_t end = i;
    while (end < touches.size() && touches[end].point == v) ++end;
    for (const Point& to : {a, b}) {
      if (to == v) continue;
      Sector sector(v, to);
      for (std::size_t k = i; k < end; ++k) sector.add(edges_[touches[k].edge]);
      if (!sector.free()) return false;
    }
    i = end;
  }
  return true;
}

void EdgeIndex::collect(const Box& box, std::vector<std::uint32_t>& out) const {
  if (grid_.empty() || box.empty() || !box.overlaps({grid_.low(), grid_.high()})) return;
  const int i0 = grid_.column(box.low.x()), i1 = grid_.column(box.high.x());
  const int j0 = grid_.row(box.low.y()), j1 = grid_.row(box.high.y());
  for (int j = j0; j <= j1; ++j) {
    const auto items = grid_.items(i0, i1, j);
    out.insert(out.end(), items.begin(), items.end());
  }
  sort_unique(out);
}

}  // namespace oxturn
