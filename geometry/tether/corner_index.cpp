#include "geometry/tether/corner_index.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

/// One wall at a corner, seen from there. The obstacle lies counter-clockwise of a wall that comes in (free space is at
/// the left of every ring), clockwise of one that goes out.
struct Wall {
  Point at, to;
  bool in;
};

bool lower_half(const Point& at, const Point& to) { return to.y() < at.y() || (to.y() == at.y() && to.x() < at.x()); }

/// By place; at one place counter-clockwise.
bool around(const Wall& a, const Wall& b) {
  if (a.at != b.at) return before(a.at, b.at);
  const bool low = lower_half(a.at, a.to), other = lower_half(b.at, b.to);
  if (low != other) return other;
  const int turn = orientation(a.at, a.to, b.to);
  return turn != 0 ? turn > 0 : a.in && !b.in;
}

/// A point strictly between the rays at -> from and at -> to, which turn left by less than 180 degrees. The test on which
/// side of a string a wedge lies asks for this point, because its walls may be in line with the string but for rounding.
Point between(const Point& at, const Point& from, const Point& to) {
  const Point u = from - at, v = to - at;
  const double reach = std::min(u.norm(), v.norm());
  for (const Point& p : {Point(at + (u.normalized() + v.normalized()) * (reach / 2)), lerp(from, to, 0.5)}) {
    if (orientation(at, from, p) > 0 && orientation(at, p, to) > 0) return p;
  }
  return from;  // a wedge with no double in its middle
}

}  // namespace

CornerIndex::CornerIndex(const Region& free) {
  std::vector<Wall> walls;
  for_each_ring(free, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (a == b) continue;
      walls.push_back({a, b, false});
      walls.push_back({b, a, true});
    }
  });
  std::sort(walls.begin(), walls.end(), around);
  Box box;
  for (std::size_t first = 0; first < walls.size();) {
    std::size_t end = first;
    while (end < walls.size() && walls[end].at == walls[first].at) ++end;
    for (std::size_t i = first; i < end; ++i) {
      const Wall &wall = walls[i], &next = walls[i + 1 < end ? i + 1 : first];
      if (!wall.in || next.in || orientation(wall.at, wall.to, next.to) <= 0) continue;
      corners_.push_back({wall.at, between(wall.at, wall.to, next.to)});
      box.add(wall.at);
    }
    first = end;
  }
  grid_ = UniformGrid(box, corners_.size(), 0);
  grid_.fill(corners_.size(), [&](std::size_t i, auto enter) { grid_.visit(&corners_[i].at, 1, 0, enter); });
}

}  // namespace oxturn
