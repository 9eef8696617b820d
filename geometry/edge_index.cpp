#include "geometry/edge_index.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Edge = EdgeIndex::Edge;

/// Is the way from v towards `to` in the closed free space, judged by the edges through v alone? Rays leave v along
/// these edges; free space lies counter-clockwise of an outgoing edge and clockwise of an incoming one, so the
/// first ray met when turning clockwise from `to` decides.
class Sector {
 public:
  Sector(const Point& v, const Point& to) : v_(v), to_(to) {}
  void add(const Edge& e) {
    if (e.a != v_) add(e.a, false);
    if (e.b != v_) add(e.b, true);
  }
  bool free() const { return along_wall_ || !any_ || outgoing_; }

 private:
  void add(const Point& w, bool outgoing) {
    const int turn = orientation(v_, to_, w);
    const int half = turn < 0 ? 0 : turn > 0 ? 2 : 1;
    if (turn == 0 && !on_segment(v_, to_, w)) {
      along_wall_ = true;  // collinear and v not between: the same direction
      return;
    }
    const int order = !any_ || half < half_ ? -1 : half > half_ ? 1 : orientation(v_, w_, w);
    // Nearer if w_ lies clockwise of w; of two walls on the same ray the outgoing one is seen first.
    const bool nearer = !any_ || half < half_ || (half == half_ && (order > 0 || (order == 0 && outgoing)));
    if (!nearer) return;
    any_ = true;
    half_ = half;
    w_ = w;
    outgoing_ = outgoing;
  }

  Point v_, to_, w_{0, 0};
  int half_ = 0;
  bool any_ = false, outgoing_ = false, along_wall_ = false;
};

struct Touch {
  Point place;
  std::uint32_t edge;
  bool operator<(const Touch& o) const { return place != o.place ? before(place, o.place) : edge < o.edge; }
  bool operator==(const Touch& o) const { return place == o.place && edge == o.edge; }
};

Point meeting_point(const Point& a, const Point& b, const Edge& e) {
  const Point d = b - a, f = e.b - e.a;
  const double across = cross(d, f);
  if (across == 0) return on_segment(e.a, a, b) ? e.a : on_segment(e.b, a, b) ? e.b : a;
  return lerp(a, b, std::clamp(cross(e.a - a, f) / across, 0.0, 1.0));
}

void offer(EdgeIndex::Nearest& best, const Point& from, const Point& place, std::size_t edge) {
  const double d = distance(from, place);
  if (d < best.distance || (d == best.distance && edge < best.edge)) best = {d, place, from, edge};
}

/// Distance between the boxes of two segments: a cheap lower bound.
double box_gap(const Point& a, const Point& b, const Edge& e) {
  const Point low = a.cwiseMin(b), high = a.cwiseMax(b), elow = e.a.cwiseMin(e.b), ehigh = e.a.cwiseMax(e.b);
  const double x = std::max({0.0, elow.x() - high.x(), low.x() - ehigh.x()});
  const double y = std::max({0.0, elow.y() - high.y(), low.y() - ehigh.y()});
  return std::max(x, y);
}

}  // namespace

EdgeIndex::EdgeIndex(const Region& region) {
  Box box;
  double total = 0;
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = ring[i + 1 < ring.size() ? i + 1 : 0];
      box.add(a);
      if (a == b) continue;
      edges_.push_back({a, b});
      total += distance(a, b);
    }
  });
  grid_ = UniformGrid(box, edges_.size(), total);
  grid_.fill(edges_.size(), [&](std::size_t i, auto enter) {
    const Point ends[2] = {edges_[i].a, edges_[i].b};
    grid_.visit(ends, 2, 0, enter);
  });
  look_about();
}

std::optional<EdgeIndex::Nearest> EdgeIndex::nearest(const Point& p, double within) const {
  if (grid_.empty() || !finite(p)) return std::nullopt;
  Nearest best;
  best.distance = within;
  best.edge = edges_.size();
  // Rings of cells about q, the point of the box nearest to p. For z in the box |p - z|^2 >= |p - q|^2 + |q - z|^2.
  const Point q = p.cwiseMax(grid_.low()).cwiseMin(grid_.high());
  const double off2 = (p - q).squaredNorm();
  const int ci = grid_.column(q.x()), cj = grid_.row(q.y());
  const int most = std::max({ci, cj, grid_.columns() - 1 - ci, grid_.rows() - 1 - cj});
  const Point in_cell = (q - grid_.low()) / grid_.cell() - Point(ci, cj);
  const double margin = std::clamp(std::min(in_cell.minCoeff(), 1 - in_cell.maxCoeff()), 0.0, 1.0) - 1e-7;
  for (int r = 0; r <= most; ++r) {
    const double gap = r == 0 ? 0 : (r - 1 + margin) * grid_.cell();
    if (std::sqrt(off2 + (gap > 0 ? gap * gap : 0)) > best.distance) break;
    const int bottom = std::max(0, cj - r), top = std::min(grid_.rows() - 1, cj + r);
    for (int j = bottom; j <= top; ++j) {
      const bool whole = j == cj - r || j == cj + r;
      const int step = whole || r == 0 ? 1 : 2 * r;
      for (int i = ci - r; i <= ci + r; i += step) {
        if (i < 0 || i >= grid_.columns()) continue;
        const std::size_t c = grid_.index(i, j);
        for (const std::uint32_t e : grid_.items(c)) {
          offer(best, p, nearest_on_segment(p, edges_[e].a, edges_[e].b), e);
        }
      }
    }
  }
  if (best.edge == edges_.size() || !(best.distance < within)) return std::nullopt;
  return best;
}

std::optional<EdgeIndex::Nearest> EdgeIndex::nearest(const Point& a, const Point& b, double within) const {
  if (a == b) return nearest(a, within);
  if (grid_.empty() || !finite(a) || !finite(b)) return std::nullopt;
  Nearest best;
  best.distance = within;
  best.edge = edges_.size();
  const Point ends[2] = {a, b};
  const auto try_edge = [&](std::uint32_t index) {
    const Edge& e = edges_[index];
    if (box_gap(a, b, e) > best.distance) return;
    if (orientation(a, b, e.a) * orientation(a, b, e.b) <= 0 && crossing(a, b, e.a, e.b) != Crossing::none) {
      const Point place = meeting_point(a, b, e);
      if (best.distance > 0 || index < best.edge) best = {0, place, place, index};
      return;
    }
    offer(best, a, nearest_on_segment(a, e.a, e.b), index);
    offer(best, b, nearest_on_segment(b, e.a, e.b), index);
    offer(best, nearest_on_segment(e.a, a, b), e.a, index);
    offer(best, nearest_on_segment(e.b, a, b), e.b, index);
  };
  // Growing bands about the segment; each at least doubles, so the last one pays for all.
  const double whole = (grid_.high() - grid_.low()).norm() + distance_to_segment(grid_.low(), a, b);
  for (double band = std::min(within, grid_.cell() / 2);; band = std::min({within, whole, 2 * band})) {
    grid_.visit(ends, 2, band, [&](std::size_t c) {
      for (const std::uint32_t e : grid_.items(c)) try_edge(e);
      return best.distance == 0;
    });
    if (best.distance <= band || band >= within || band >= whole) break;
  }
  if (best.edge == edges_.size() || !(best.distance < within)) return std::nullopt;
  return best;
}

// Each cell has a look-out, a place on no edge of which is known whether it is inside; from there to any point of the
// cell only the cell's own edges can be crossed.
constexpr std::uint8_t kLookOutInside = 0x80;

Point EdgeIndex::look_out(std::size_t cell) const {
  const int columns = grid_.columns(), k = look_out_[cell] & ~kLookOutInside;
  const auto i = static_cast<double>(cell % static_cast<std::size_t>(columns));
  const auto j = static_cast<double>(cell / static_cast<std::size_t>(columns));
  const double up = k == 0 ? 0.5 : std::fmod(0.5 + 0.6180339887498949 * k, 1.0);  // spread over the cell
  return grid_.low() + grid_.cell() * Point(i + (k + 0.5) / kLookOutInside, j + up);
}

/// Neither end may lie on the edge. What is crossed exactly at a corner counts once for its two edges, or not at all.
bool EdgeIndex::crossed(const Point& from, const Point& to, std::uint32_t edge) const {
  const Edge& e = edges_[edge];
  if ((orientation(from, to, e.a) > 0) == (orientation(from, to, e.b) > 0)) return false;
  return orientation(e.a, e.b, from) * orientation(e.a, e.b, to) < 0;
}

void EdgeIndex::look_about() {
  look_out_.assign(static_cast<std::size_t>(grid_.columns()) * static_cast<std::size_t>(grid_.rows()), 0);
  const auto on_edge = [&](std::size_t c) {
    const Point p = look_out(c);
    return std::any_of(grid_.items(c).begin(), grid_.items(c).end(),
                       [&](std::uint32_t e) { return on_segment(p, edges_[e].a, edges_[e].b); });
  };
  std::vector<std::uint32_t> near;
  for (int j = 0; j < grid_.rows(); ++j) {
    Point last = grid_.low() + grid_.cell() * Point(-1, j + 0.5);  // outside
    bool inside = false;
    for (int i = 0; i < grid_.columns(); ++i) {
      const std::size_t c = grid_.index(i, j);
      while (on_edge(c)) {
        if (++look_out_[c] == kLookOutInside)
          throw std::invalid_argument("a region's edges lie too close together to tell inside from outside");
      }
      const Point here = look_out(c);
      near.assign(grid_.items(c).begin(), grid_.items(c).end());
      if (i > 0) near.insert(near.end(), grid_.items(c - 1).begin(), grid_.items(c - 1).end());
      std::sort(near.begin(), near.end());
      near.erase(std::unique(near.begin(), near.end()), near.end());
      for (const std::uint32_t e : near) inside ^= crossed(last, here, e);
      if (inside) look_out_[c] |= kLookOutInside;
      last = here;
    }
  }
}

bool EdgeIndex::contains(const Point& p) const {
  if (grid_.empty() || !(p.x() >= grid_.low().x() && p.x() <= grid_.high().x() && p.y() >= grid_.low().y() &&
                         p.y() <= grid_.high().y())) {
    return false;
  }
  const std::size_t c = grid_.index(grid_.column(p.x()), grid_.row(p.y()));
  bool inside = (look_out_[c] & kLookOutInside) != 0;
  const Point from = look_out(c);
  for (const std::uint32_t e : grid_.items(c)) {
    if (on_segment(p, edges_[e].a, edges_[e].b)) return true;
    inside ^= crossed(from, p, e);
  }
  return inside;
}

bool EdgeIndex::contains(const Point& a, const Point& b) const {
  if (a == b) return contains(a);
  if (grid_.empty() || !finite(a) || !finite(b)) return false;
  // No edge may be crossed. Where the segment touches edges (corners on it, its ends on edges, stretches along
  // walls) the sectors at these places say whether it stays inside; between them it cannot change sides.
  std::vector<Touch> touches;
  std::vector<std::uint32_t> along;
  const Point ends[2] = {a, b};
  // An edge crossed exactly where another ring's corner lies on it is only touched: that corner, if any.
  const auto corner_on = [&](const Edge& e) -> const Point* {
    const Point p = meeting_point(a, b, e);
    const std::size_t c = grid_.index(grid_.column(p.x()), grid_.row(p.y()));
    for (const std::uint32_t i : grid_.items(c)) {
      for (const Point* w : {&edges_[i].a, &edges_[i].b}) {
        if (on_segment(*w, e.a, e.b) && on_segment(*w, a, b)) return w;
      }
    }
    return nullptr;
  };
  const Point least = a.cwiseMin(b), most = a.cwiseMax(b);
  const bool blocked = grid_.visit(ends, 2, 0, [&](std::size_t c) {
    for (const std::uint32_t i : grid_.items(c)) {
      const Edge& e = edges_[i];
      if (std::max(e.a.x(), e.b.x()) < least.x() || std::min(e.a.x(), e.b.x()) > most.x() ||
          std::max(e.a.y(), e.b.y()) < least.y() || std::min(e.a.y(), e.b.y()) > most.y())
        continue;
      const int sa = orientation(a, b, e.a), sb = orientation(a, b, e.b);
      if (sa * sb > 0) continue;
      const int ta = orientation(e.a, e.b, a), tb = orientation(e.a, e.b, b);
      if (ta * tb > 0) continue;
      if (sa * sb < 0 && ta * tb < 0) {
        const Point* corner = corner_on(e);
        if (corner == nullptr) return true;
        touches.push_back({*corner, i});
        continue;
      }
      if (sa == 0 && on_segment(e.a, a, b)) touches.push_back({e.a, i});
      if (sb == 0 && on_segment(e.b, a, b)) touches.push_back({e.b, i});
      if (ta == 0 && on_segment(a, e.a, e.b)) touches.push_back({a, i});
      if (tb == 0 && on_segment(b, e.a, e.b)) touches.push_back({b, i});
      if (sa == 0 && sb == 0) along.push_back(i);
    }
    return false;
  });
  if (blocked) return false;
  std::sort(touches.begin(), touches.end());
  touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  if (touches.empty() || (touches.front().place != a && touches.back().place != a)) {
    if (!contains(a)) return false;
  }
  if (touches.empty()) return true;
  // Edges that run along the segment also pass through other edges' corners on them.
  std::sort(along.begin(), along.end());
  along.erase(std::unique(along.begin(), along.end()), along.end());
  const std::size_t own = touches.size();
  for (const std::uint32_t i : along) {
    const Point low = before(edges_[i].a, edges_[i].b) ? edges_[i].a : edges_[i].b;
    const Point high = low == edges_[i].a ? edges_[i].b : edges_[i].a;
    const auto end = touches.begin() + static_cast<std::ptrdiff_t>(own);
    auto at =
        std::lower_bound(touches.begin(), end, low, [](const Touch& t, const Point& p) { return before(t.place, p); });
    std::vector<Point> passed;
    for (; at != end && !before(high, at->place); ++at) {
      if (passed.empty() || passed.back() != at->place) passed.push_back(at->place);
    }
    for (const Point& p : passed) touches.push_back({p, i});
  }
  if (touches.size() > own) {
    std::sort(touches.begin(), touches.end());
    touches.erase(std::unique(touches.begin(), touches.end()), touches.end());
  }
  for (std::size_t i = 0; i < touches.size();) {
    const Point& v = touches[i].place;
    std::size_t end = i;
    while (end < touches.size() && touches[end].place == v) ++end;
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
    for (int i = i0; i <= i1; ++i) {
      const std::size_t c = grid_.index(i, j);
      out.insert(out.end(), grid_.items(c).begin(), grid_.items(c).end());
    }
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
}

}  // namespace oxturn
