#include "algorithms/tethered/berg_sight.hpp"

#include "geometry/predicates.hpp"

namespace oxturn {

BergSight::BergSight(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers,
                     double tolerance)
    : walls_(walls), tolerance_(tolerance) {
  for_each_ring(free, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) corners_.push_back({ring[i], ring[(i + n - 1) % n], ring[(i + 1) % n]});
  });
  for (const Polyline& barrier : barriers) {
    Polyline line = barrier;
    line.front() = add_barrier_end(barrier.front(), barrier[1]);
    line.back() = add_barrier_end(barrier.back(), barrier[barrier.size() - 2]);
    for (std::size_t i = 1; i < line.size(); ++i) barriers_.push_back({line[i - 1], line[i]});
  }
}

/// Two corners, one on each side of the barrier from here to `other`.
void BergSight::split_corner(std::size_t k, const Point& other) {
  Corner second = corners_[k];
  corners_[k].next = second.previous = other;
  corners_[k].at_barrier = second.at_barrier = true;
  corners_.push_back(second);
}

/// Splits the corner where the barrier ends, or makes two corners on the wall there. Returns the barrier's end for
/// tests of sight.
Point BergSight::add_barrier_end(const Point& at, const Point& other) {
  for (std::size_t k = 0; k < corners_.size(); ++k)
    if (corners_[k].at == at && in_wedge(corners_[k], other)) {
      barrier_ends_.push_back({at, other, corners_[k].previous, corners_[k].next});
      split_corner(k, other);
      return at;
    }
  const auto wall = walls_.nearest(at);
  if (!wall) return at;
  const EdgeIndex::Edge& edge = walls_.edges()[wall->edge];
  corners_.push_back({at, edge.a, edge.b, false});
  split_corner(corners_.size() - 1, other);
  return at + 2 * tolerance_ * (at - other).normalized();
}

/// Is p in the free wedge at the corner? The wedge is closed, but the corner itself is not in it.
bool BergSight::in_wedge(const Corner& c, const Point& p) {
  if (p == c.at) return false;
  const bool left_of_next = orientation(c.at, c.next, p) >= 0,
             right_of_previous = orientation(c.at, c.previous, p) <= 0;
  const int turn = orientation(c.at, c.next, c.previous);
  const bool reflex = turn < 0 || (turn == 0 && (c.next - c.at).dot(c.previous - c.at) > 0);  // over 180 degrees
  return reflex ? left_of_next || right_of_previous : left_of_next && right_of_previous;
}

bool BergSight::sees(const Point& eye, const Point& p) const {
  if (!walls_.contains(eye, p)) return false;
  for (const Barrier& b : barriers_)
    if (crossing(eye, p, b.from, b.to) == Crossing::proper) return false;
  for (const BarrierEnd& end : barrier_ends_) {
    if (end.at == eye || end.at == p || !on_segment(end.at, eye, p)) continue;
    // The line of sight touches this corner: its wall and the barrier must lie on the same side of the line.
    const int previous = orientation(eye, p, end.previous), next = orientation(eye, p, end.next);
    const int wall = previous != 0 ? previous : next != 0 ? next : (end.next - end.at).dot(p - eye) > 0 ? -1 : 1;
    if (orientation(eye, p, end.other) * wall < 0) return false;
  }
  return true;
}

}  // namespace oxturn
