#include "algorithms/tethered/berg_sight.hpp"

#include <algorithm>
#include <array>

#include "geometry/predicates.hpp"

namespace oxturn {

BergSight::BergSight(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers,
                     double tolerance)
    : walls_(walls), tolerance_(tolerance) {
  for_each_ring(free, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) add_corner({ring[i], ring[(i + n - 1) % n], ring[(i + 1) % n]});
  });
  for (const auto& [at, here] : corners_at_)
    if (here.size() > 1) separate_wedges(here);
  contact_grid_ = UniformGrid(contacts_.size(), [&](std::size_t i) { return std::array{contacts_[i].front().at}; });
  for (const Polyline& barrier : barriers) {
    Polyline line = barrier;
    line.front() = add_barrier_end(barrier.front(), barrier[1]);
    line.back() = add_barrier_end(barrier.back(), barrier[barrier.size() - 2]);
    for (std::size_t i = 1; i < line.size(); ++i) barriers_.push_back({line[i - 1], line[i]});
  }
  barrier_grid_ = UniformGrid(barriers_.size(), [&](std::size_t i) {
    return std::array{barriers_[i].from, barriers_[i].to};
  });
  end_grid_ = UniformGrid(barrier_ends_.size(), [&](std::size_t i) { return std::array{barrier_ends_[i].at}; });
}

void BergSight::add_corner(const Corner& corner) {
  corners_at_[corner.at].push_back(static_cast<std::uint32_t>(corners_.size()));
  corners_.push_back(corner);
}

/// Where walls touch in a point, rings may go on from one obstacle to the other. Each corner gets the two edges between
/// which its wedge is free.
void BergSight::separate_wedges(const std::vector<std::uint32_t>& corners) {
  std::vector<Corner> before_pairing;
  for (const std::uint32_t k : corners) before_pairing.push_back(corners_[k]);
  for (const std::uint32_t k : corners) {
    Corner& corner = corners_[k];
    for (const Corner& c : before_pairing)
      if (met_before(corner.at, corner.next, c.previous, corner.previous)) corner.previous = c.previous;
    corner.shares_point = true;
  }
  std::vector<Corner>& contact = contacts_.emplace_back();
  for (const std::uint32_t k : corners) contact.push_back(corners_[k]);
}

/// Turning counter-clockwise about `at`, beginning at `from`, is a met before b?
bool BergSight::met_before(const Point& at, const Point& from, const Point& a, const Point& b) {
  const auto half = [&](const Point& p) {  // 0: on the ray itself, 1: to its left or straight back, 2: to its right
    const int turn = orientation(at, from, p);
    if (turn != 0) return turn > 0 ? 1 : 2;
    return (from - at).dot(p - at) > 0 ? 0 : 1;
  };
  if (half(a) != half(b)) return half(a) < half(b);
  return orientation(at, a, b) > 0;
}

std::vector<std::vector<std::uint32_t>> BergSight::corners_at_points(const Mesh& mesh) const {
  const std::size_t points = mesh.points().size();
  std::vector<std::vector<std::uint32_t>> lists(points + 1);
  std::vector<bool> listed(corners_.size(), false);
  std::map<Point, std::size_t, decltype(&before)> number(&before);
  for (std::size_t i = 0; i < points; ++i) {
    number[mesh.points()[i]] = i;
    const auto here = corners_at_.find(mesh.points()[i]);
    if (here == corners_at_.end()) continue;
    lists[i] = here->second;
    for (const std::uint32_t k : here->second) listed[k] = true;
  }
  for (const auto& [end, begin] : ends_in_walls_) {
    const auto i = number.find(end);
    const auto& more = corners_at_.at(begin);
    if (i != number.end()) lists[i->second].insert(lists[i->second].end(), more.begin(), more.end());
  }
  for (std::uint32_t k = 0; k < corners_.size(); ++k)
    if (!listed[k]) lists.back().push_back(k);
  return lists;
}

/// Two corners, one on each side of the barrier from here to `other`.
void BergSight::split_corner(std::size_t k, const Point& other) {
  Corner second = corners_[k];
  corners_[k].next = second.previous = other;
  corners_[k].shares_point = second.shares_point = true;
  add_corner(second);
}

/// Splits the corner where the barrier ends, or makes two corners on the wall there. Returns the barrier's end for
/// tests of sight.
Point BergSight::add_barrier_end(const Point& at, const Point& other) {
  if (const auto here = corners_at_.find(at); here != corners_at_.end())
    for (const std::uint32_t k : here->second)
      if (in_wedge(corners_[k], other)) {
        barrier_ends_.push_back({at, other, corners_[k].previous, corners_[k].next});
        split_corner(k, other);
        return at;
      }
  const auto wall = walls_.nearest(at);
  if (!wall) return at;
  const EdgeIndex::Edge& edge = walls_.edges()[wall->edge];
  ends_in_walls_.push_back({at, edge.a});
  add_corner({at, edge.a, edge.b, false});
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
  const std::array line{eye, p};
  const bool crossed = barrier_grid_.visit_items(line, 0, [&](std::uint32_t i) {
    return crossing(eye, p, barriers_[i].from, barriers_[i].to) == Crossing::proper;
  });
  if (crossed) return false;
  const bool between_obstacles =
      contact_grid_.visit_items(line, 0, [&](std::uint32_t i) { return blocked_between(contacts_[i], eye, p); });
  if (between_obstacles) return false;
  return !end_grid_.visit_items(line, 0, [&](std::uint32_t i) { return blocked_at(barrier_ends_[i], eye, p); });
}

/// Does the line of sight pass from one free wedge into another, through the point where obstacles touch?
bool BergSight::blocked_between(const std::vector<Corner>& contact, const Point& eye, const Point& p) {
  const Point& at = contact.front().at;
  if (at == eye || at == p || !on_segment(at, eye, p)) return false;
  return std::ranges::none_of(contact, [&](const Corner& c) { return in_wedge(c, eye) && in_wedge(c, p); });
}

/// Does the line of sight touch this corner, its wall and the barrier on different sides of the line?
bool BergSight::blocked_at(const BarrierEnd& end, const Point& eye, const Point& p) {
  if (end.at == eye || end.at == p || !on_segment(end.at, eye, p)) return false;
  const int previous = orientation(eye, p, end.previous), next = orientation(eye, p, end.next);
  const int wall = previous != 0 ? previous : next != 0 ? next : (end.next - end.at).dot(p - eye) > 0 ? -1 : 1;
  return orientation(eye, p, end.other) * wall < 0;
}

}  // namespace oxturn
