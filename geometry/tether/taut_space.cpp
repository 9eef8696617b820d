#include "geometry/tether/taut_space.hpp"

#include <algorithm>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr double kShortest = 2 * TautSpace::kNear;  // metres: edges between corners

/// A wall at a corner, seen from there. Free space is to the left of every ring, so the obstacle lies counter-clockwise
/// of an incoming wall and clockwise of an outgoing one.
struct Wall {
  Point at, to;
  bool incoming;
};

bool lower_half(const Point& at, const Point& to) { return to.y() < at.y() || (to.y() == at.y() && to.x() < at.x()); }

/// By point; at one point counter-clockwise.
bool wall_order(const Wall& a, const Wall& b) {
  if (a.at != b.at) return before(a.at, b.at);
  const bool a_low = lower_half(a.at, a.to), b_low = lower_half(b.at, b.to);
  if (a_low != b_low) return b_low;
  const int turn = orientation(a.at, a.to, b.to);
  return turn != 0 ? turn > 0 : a.incoming && !b.incoming;
}

/// A point strictly between the rays at -> from and at -> to, which turn left by less than 180 degrees. It decides on
/// which side of the tether a wedge lies: the wedge's walls may be collinear with the tether up to rounding.
Point between(const Point& at, const Point& from, const Point& to) {
  const Point u = from - at, v = to - at;
  const double reach = std::min(u.norm(), v.norm());
  for (const Point& p : {Point(at + (u.normalized() + v.normalized()) * (reach / 2)), lerp(from, to, 0.5)})
    if (orientation(at, from, p) > 0 && orientation(at, p, to) > 0) return p;
  return from;  // so narrow a wedge that there is no such double
}

/// A ring as a doubly linked list.
struct LinkedRing {
  explicit LinkedRing(const Ring& r) : ring(r), size(r.size()) {
    for (std::size_t i = 0; i < size; ++i) {
      after.push_back(i + 1 < size ? i + 1 : 0);
      before.push_back(i > 0 ? i - 1 : size - 1);
    }
  }
  bool is_corner(std::size_t i) const { return orientation(ring[before[i]], ring[i], ring[after[i]]) < 0; }
  void drop(std::size_t i) {
    after[before[i]] = after[i];
    before[after[i]] = before[i];
    --size;
  }

  const Ring& ring;
  std::size_t size;
  std::vector<std::size_t> after, before;
};

/// The ring without corners of obstacles nearer than kShortest to the next vertex. Obstacles only shrink, so no
/// path is on another side of one than before. Obstacles smaller than that vanish.
Ring without_short_edges(const Ring& ring) {
  LinkedRing list(ring);
  std::size_t i = 0;
  for (std::size_t left = ring.size(); left > 0 && list.size > 2; --left) {
    const std::size_t next = list.after[i];
    const bool repeated = ring[i] == ring[next];
    if (!repeated && distance(ring[i], ring[next]) >= kShortest) {
      i = next;
    } else if (const bool at_next = repeated || list.is_corner(next); at_next || list.is_corner(i)) {
      list.drop(at_next ? next : i);
      i = list.before[list.before[i]];  // what the vertex before is may have changed
      left += 3;
    } else {
      i = next;
    }
  }
  Ring kept;
  for (std::size_t k = 0; list.size > 2 && k < list.size; ++k, i = list.after[i]) kept.push_back(ring[i]);
  return kept;
}

std::vector<Wall> walls_of(const Region& free) {
  std::vector<Wall> walls;
  for_each_ring(free, [&](const Ring& ring) {
    for_each_edge(without_short_edges(ring), [&](const Point& a, const Point& b) {
      walls.push_back({a, b, false});
      walls.push_back({b, a, true});
    });
  });
  std::sort(walls.begin(), walls.end(), wall_order);
  return walls;
}

}  // namespace

TautSpace::TautSpace(const Region& free) {
  const std::vector<Wall> walls = walls_of(free);
  for (std::size_t first = 0; first < walls.size();) {
    std::size_t end = first;
    while (end < walls.size() && walls[end].at == walls[first].at) ++end;
    for (std::size_t i = first; i < end; ++i) {
      const Wall &wall = walls[i], &next = walls[i + 1 < end ? i + 1 : first];
      if (wall.incoming && !next.incoming && orientation(wall.at, wall.to, next.to) > 0)
        corners_.push_back({wall.at, between(wall.at, wall.to, next.to)});
    }
    first = end;
  }
  grid_ = UniformGrid(corners_.size(), [&](std::size_t i) { return std::array{corners_[i].at}; });
}

}  // namespace oxturn
