#include "algorithms/grid/wall_follower.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr std::size_t kDetour = 4;  // steps on the lattice for one stretch of wall
constexpr double kWorth = 0.05;     // cells that a wall is away from the lane beside it

Cell cell_of(const Point& at) {
  return {static_cast<int>(std::floor(at.x() + 0.5)), static_cast<int>(std::floor(at.y() + 0.5))};
}
int apart(const Cell& a, const Cell& b) { return std::max(std::abs(a.i - b.i), std::abs(a.j - b.j)); }

}  // namespace

WallFollower::WallFollower(const Problem& problem, const CellRobot& robot) : problem_(problem), robot_(robot) {
  for_each_ring(problem.configuration_space(), [&](const Ring& ring) { add_ring(ring); });
}

bool WallFollower::partial(const Cell& c) const {
  const CellRobot::Lattice lattice = robot_.lattice();
  return !lattice.graph.free(c.i + lattice.column, c.j + lattice.row);
}

bool WallFollower::passable(const Cell& c, Direction d) const {
  const CellRobot::Lattice lattice = robot_.lattice();
  return lattice.graph.passable(c.i + lattice.column, c.j + lattice.row, d);
}

// Free space lies to the left of the ring's edges: along it the wall is on the right.
void WallFollower::add_ring(const Ring& ring) {
  const CellRobot::Lattice lattice = robot_.lattice();
  const Point first(lattice.column, lattice.row);
  const auto ring_begin = static_cast<std::uint32_t>(stretches_.size());
  bool going_on = false;  // the last piece was in a partial cell, stretches_.back()
  const auto add = [&](const Point& a, const Point& b, const Cell& cell) {
    // In a free cell a wall is worth it unless the lane through the centre runs along it anyway.
    const Point along = b - a, out = robot_.centre(cell) - a;
    const double away = std::abs(along.x() * out.y() - along.y() * out.x()) / along.norm();
    if (!partial(cell) && !(away > kWorth * robot_.side())) {
      going_on = false;
      return;
    }
    if (!going_on || stretches_.back().cell != cell) {
      const auto index = static_cast<std::uint32_t>(stretches_.size());
      const auto begin = static_cast<std::uint32_t>(points_.size());
      Stretch stretch{begin, begin, cell};
      if (going_on) {
        stretch.previous = index - 1;
        stretches_.back().next = index;
      }
      stretch.next_in_cell = first_in(cell);
      first_[cell] = index + 1;
      stretches_.push_back(stretch);
      points_.push_back(a);
    }
    points_.push_back(b);
    stretches_.back().end = static_cast<std::uint32_t>(points_.size());
    going_on = true;
  };
  std::vector<double> cuts;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    const Point u = lattice.graph.coordinates(a) - first, v = lattice.graph.coordinates(b) - first;
    cuts = {0, 1};
    for (const int axis : {0, 1}) {
      const double low = std::min(u[axis], v[axis]), high = std::max(u[axis], v[axis]);
      for (double line = std::floor(low + 0.5) + 0.5; line < high; line += 1)
        if (line > low) cuts.push_back((line - u[axis]) / (v[axis] - u[axis]));
    }
    std::sort(cuts.begin(), cuts.end());
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      if (cuts[c + 1] <= cuts[c] || a == b) continue;
      const double middle = (cuts[c] + cuts[c + 1]) / 2;
      add(cuts[c] == 0 ? a : lerp(a, b, cuts[c]), cuts[c + 1] == 1 ? b : lerp(a, b, cuts[c + 1]),
          cell_of(u + middle * (v - u)));
    }
  }
  // The ring closes.
  if (ring_begin < stretches_.size() && going_on && points_[stretches_[ring_begin].begin] == ring.front()) {
    const auto last = static_cast<std::uint32_t>(stretches_.size() - 1);
    if (last != ring_begin) {
      stretches_[last].next = ring_begin;
      stretches_[ring_begin].previous = last;
    }
  }
}

bool WallFollower::open_in(const Cell& c) const {
  for (std::uint32_t s = first_in(c); s != kNone; s = stretches_[s].next_in_cell)
    if (!stretches_[s].followed) return true;
  return false;
}

bool WallFollower::any_left(const Cell& c) const {
  if (tried_.get(c)) return false;
  for (int di = -1; di <= 1; ++di)
    for (int dj = -1; dj <= 1; ++dj)
      if (open_in({c.i + di, c.j + dj})) return true;
  return false;
}

void WallFollower::follow_all(CellWalk& walk, bool wall_on_left) {
  const Cell at = walk.at();
  for (int di = -1; di <= 1; ++di)
    for (int dj = -1; dj <= 1; ++dj) follow(walk, {at.i + di, at.j + dj}, wall_on_left);
  tried_[at] = 1;
}

void WallFollower::follow(CellWalk& walk, const Cell& partial, bool wall_on_left) {
  for (std::uint32_t s = first_in(partial); s != kNone; s = stretches_[s].next_in_cell)
    if (!stretches_[s].followed) follow(walk, s, wall_on_left);
}

/// A few steps over free cells to one beside the wall's cell: what the robot may come back by.
std::optional<std::vector<Cell>> WallFollower::beside(const Cell& from, const Cell& wall) const {
  std::vector<std::vector<Cell>> ways{{from}};
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const std::vector<Cell> way = ways[k];
    if (apart(way.back(), wall) <= 1) return way;
    if (way.size() > kDetour) continue;
    for (const Direction d : kAllDirections) {
      const Cell to = neighbour(way.back(), d);
      if (!passable(way.back(), d) ||
          std::any_of(ways.begin(), ways.end(), [&](const auto& w) { return w.back() == to; }))
        continue;
      ways.push_back(way);
      ways.back().push_back(to);
    }
  }
  return std::nullopt;
}

bool WallFollower::follow(CellWalk& walk, std::uint32_t stretch, bool wall_on_left) {
  const Cell home = walk.at();
  const Point centre = robot_.centre(home);
  // The nearest of its points in sight.
  std::vector<std::uint32_t> order;
  for (std::uint32_t p = stretches_[stretch].begin; p < stretches_[stretch].end; ++p) order.push_back(p);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return (points_[a] - centre).squaredNorm() < (points_[b] - centre).squaredNorm();
  });
  const auto seen = std::find_if(order.begin(), order.end(),
                                 [&](std::uint32_t p) { return problem_.walls().contains(centre, points_[p]); });
  if (seen == order.end()) return false;

  // To it, back to the stretch's beginning, then along the wall; `shadow` is the way by which the robot may come back.
  Polyline line{points_[*seen]};
  for (std::uint32_t p = *seen; p != (wall_on_left ? stretches_[stretch].end - 1 : stretches_[stretch].begin);)
    line.push_back(points_[wall_on_left ? ++p : --p]);
  std::vector<Cell> shadow{home};
  std::size_t good = 0, good_shadow = 0;  // where the lattice was last in sight
  for (std::uint32_t s = stretch; s != kNone && !stretches_[s].followed;
       s = wall_on_left ? stretches_[s].previous : stretches_[s].next) {
    const auto way = beside(shadow.back(), stretches_[s].cell);
    if (!way) break;
    shadow.insert(shadow.end(), way->begin() + 1, way->end());
    stretches_[s].followed = true;
    const std::uint32_t n = stretches_[s].end - stretches_[s].begin;
    for (std::uint32_t p = 0; p < n; ++p)
      line.push_back(points_[wall_on_left ? stretches_[s].end - 1 - p : stretches_[s].begin + p]);
    if (!problem_.walls().contains(line.back(), robot_.centre(shadow.back()))) continue;
    good = line.size() - 1;
    good_shadow = shadow.size() - 1;
  }
  // What was followed beyond the last sight of the lattice is driven back.
  for (std::size_t k = line.size() - 1; k-- > good;) line.push_back(line[k]);
  shadow.resize(good_shadow + 1);
  line.push_back(robot_.centre(shadow.back()));
  length_ += oxturn::length(line);
  walk.drive(line, shadow.back());
  for (std::size_t k = shadow.size() - 1; k-- > 0;) {
    for (const Direction d : kAllDirections)
      if (neighbour(shadow[k + 1], d) == shadow[k]) walk.step(d);
  }
  return true;
}

}  // namespace oxturn
