#include "algorithms/grid/wall_follower.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/transit/short_segments.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kDetour = 4;  // most steps on the lattice for one section of wall
constexpr double kWorth = 0.05;     // cells; a wall nearer to the lane beside it is covered by that lane

Cell cell_of(const Point& at) {
  return {static_cast<int>(std::floor(at.x() + 0.5)), static_cast<int>(std::floor(at.y() + 0.5))};
}
int apart(const Cell& a, const Cell& b) { return std::max(std::abs(a.i - b.i), std::abs(a.j - b.j)); }

/// Where the segment uv crosses cell borders, as ascending fractions from 0 to 1, both included. In cell coordinates.
void cut_at_borders(const Point& u, const Point& v, std::vector<double>& cuts) {
  cuts = {0, 1};
  for (const int axis : {0, 1}) {
    const double low = std::min(u[axis], v[axis]), high = std::max(u[axis], v[axis]);
    for (double border = std::floor(low + 0.5) + 0.5; border < high; border += 1)
      if (border > low) cuts.push_back((border - u[axis]) / (v[axis] - u[axis]));
  }
  std::sort(cuts.begin(), cuts.end());
}

}  // namespace

WallFollower::WallFollower(const Problem& problem, const CellRobot& robot)
    : problem_(problem), robot_(robot), lattice_(robot.lattice()) {
  for_each_ring(problem.configuration_space(), [&](const Ring& ring) { add_ring(ring); });
}

// The lane through the centre of a free cell covers a wall that it runs along.
bool WallFollower::worth_following(const Point& a, const Point& b, const Cell& cell) const {
  const Point along = b - a, out = robot_.centre(cell) - a;
  const double away = std::abs(along.x() * out.y() - along.y() * out.x()) / along.norm();
  return !lattice_.graph.free(in_graph(cell)) || away > kWorth * robot_.side();
}

void WallFollower::begin_section(const Point& at, const Cell& cell, bool continues) {
  const auto index = static_cast<std::uint32_t>(sections_.size());
  const auto begin = static_cast<std::uint32_t>(points_.size());
  Section section{begin, begin, cell};
  if (continues) {
    section.previous = index - 1;
    sections_.back().next = index;
  }
  section.next_in_cell = first_in(cell);
  first_[cell] = index + 1;
  sections_.push_back(section);
  points_.push_back(at);
}

// Free space is on the left of a ring's edges: along the ring, the wall is on the right.
void WallFollower::add_ring(const Ring& ring) {
  const Point origin(lattice_.first.i, lattice_.first.j);
  const auto first = static_cast<std::uint32_t>(sections_.size());
  bool continues = false;  // the piece before ended sections_.back()
  std::vector<double> cuts;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
    const Point u = lattice_.graph.coordinates(a) - origin, v = lattice_.graph.coordinates(b) - origin;
    cut_at_borders(u, v, cuts);
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
      if (cuts[c + 1] <= cuts[c] || a == b) continue;
      const Point from = cuts[c] == 0 ? a : lerp(a, b, cuts[c]), to = cuts[c + 1] == 1 ? b : lerp(a, b, cuts[c + 1]);
      const double middle = (cuts[c] + cuts[c + 1]) / 2;
      const Cell cell = cell_of(u + middle * (v - u));
      if (!worth_following(from, to, cell)) {
        continues = false;
        continue;
      }
      if (!continues || sections_.back().cell != cell) begin_section(from, cell, continues);
      points_.push_back(to);
      sections_.back().end = static_cast<std::uint32_t>(points_.size());
      continues = true;
    }
  }
  close_ring(first, ring.front(), continues);
}

/// Links the ring's last section to its first if both meet at `end`.
void WallFollower::close_ring(std::uint32_t first, const Point& end, bool continues) {
  if (!continues || first >= sections_.size() || points_[sections_[first].begin] != end) return;
  const auto last = static_cast<std::uint32_t>(sections_.size() - 1);
  if (last == first) return;
  sections_[last].next = first;
  sections_[first].previous = last;
}

bool WallFollower::any_unfollowed_in(const Cell& c) const {
  for (std::uint32_t s = first_in(c); s != kNone; s = sections_[s].next_in_cell)
    if (!sections_[s].followed) return true;
  return false;
}

bool WallFollower::any_left(const Cell& c) const {
  if (tried_.get(c)) return false;
  for (int di = -1; di <= 1; ++di)
    for (int dj = -1; dj <= 1; ++dj)
      if (any_unfollowed_in({c.i + di, c.j + dj})) return true;
  return false;
}

bool WallFollower::follow_on(CellWalk& walk, bool left) {
  const Cell at = walk.at();
  for (int di = -1; di <= 1; ++di)
    for (int dj = -1; dj <= 1; ++dj)
      for (std::uint32_t s = first_in({at.i + di, at.j + dj}); s != kNone; s = sections_[s].next_in_cell)
        if (unfollowed(s) && follow(walk, s, left)) return true;
  tried_[at] = 1;
  return false;
}

void WallFollower::follow(CellWalk& walk, const Cell& cell, bool left) {
  for (std::uint32_t s = first_in(cell); s != kNone; s = sections_[s].next_in_cell) {
    if (!unfollowed(s)) continue;
    const auto cells = follow(walk, s, left);
    if (!cells) continue;
    for (std::size_t k = cells->size() - 1; k-- > 0;)
      for (const Direction d : kAllDirections)
        if (neighbour((*cells)[k + 1], d) == (*cells)[k]) walk.step(d);
  }
}

/// A few steps over free cells to one beside the wall's cell; both ends are included.
std::optional<std::vector<Cell>> WallFollower::cells_to(const Cell& from, const Cell& wall) const {
  std::vector<std::vector<Cell>> paths{{from}};
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::vector<Cell> path = paths[k];
    if (apart(path.back(), wall) <= 1) return path;
    if (path.size() > kDetour) continue;
    for (const Direction d : kAllDirections) {
      const Cell to = neighbour(path.back(), d);
      if (!lattice_.graph.passable(in_graph(path.back()), d) ||
          std::any_of(paths.begin(), paths.end(), [&](const auto& p) { return p.back() == to; }))
        continue;
      paths.push_back(path);
      paths.back().push_back(to);
    }
  }
  return std::nullopt;
}

std::optional<std::uint32_t> WallFollower::nearest_point_in_sight(const Section& section, const Point& eye) const {
  std::vector<std::uint32_t> order;
  for (std::uint32_t p = section.begin; p < section.end; ++p) order.push_back(p);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return (points_[a] - eye).squaredNorm() < (points_[b] - eye).squaredNorm();
  });
  const auto seen = std::find_if(order.begin(), order.end(),
                                 [&](std::uint32_t p) { return problem_.walls().contains(eye, points_[p]); });
  return seen == order.end() ? std::nullopt : std::optional(*seen);
}

/// To `first_point` of the section, back to the section's beginning, then along the wall from section to section. Ends
/// in the centre of the last cell of `return_cells`.
WallFollower::Excursion WallFollower::excursion(const Cell& from, std::uint32_t section, std::uint32_t first_point,
                                                bool left) {
  Polyline line{points_[first_point]};
  for (std::uint32_t p = first_point; p != (left ? sections_[section].end - 1 : sections_[section].begin);)
    line.push_back(points_[left ? ++p : --p]);
  std::vector<Cell> cells{from};
  std::size_t last_point = 0, last_cell = 0;  // where the robot could last drive straight to a cell's centre
  for (std::uint32_t s = section; unfollowed(s); s = after(s, left)) {
    const auto on = cells_to(cells.back(), sections_[s].cell);
    if (!on) break;
    cells.insert(cells.end(), on->begin() + 1, on->end());
    sections_[s].followed = true;
    const std::uint32_t n = sections_[s].end - sections_[s].begin;
    for (std::uint32_t p = 0; p < n; ++p)
      line.push_back(points_[left ? sections_[s].end - 1 - p : sections_[s].begin + p]);
    if (!problem_.walls().contains(line.back(), robot_.centre(cells.back()))) continue;
    last_point = line.size() - 1;
    last_cell = cells.size() - 1;
  }
  // What was followed beyond that is driven back.
  for (std::size_t k = line.size() - 1; k-- > last_point;) line.push_back(line[k]);
  cells.resize(last_cell + 1);
  line.push_back(robot_.centre(cells.back()));
  return {std::move(line), std::move(cells)};
}

/// Without the points where borders of cells cut straight walls, and without those a hundredth of the radius apart that
/// the robot need not visit one by one.
Polyline WallFollower::straightened(const Polyline& line) const {
  const double close = shortest_segment(problem_.robot()), off = 1e-9 * robot_.side();
  Polyline straight{line.front()};
  for (std::size_t k = 1; k + 1 < line.size(); ++k) {
    const Point &before = straight.back(), &at = line[k], &next = line[k + 1];
    const Point along = next - before, to = at - before;
    const bool between = std::abs(along.x() * to.y() - along.y() * to.x()) <= off * along.norm() &&
                         to.dot(next - at) >= 0 && to.dot(along) >= 0;
    if (!between && !(to.norm() < close && problem_.walls().contains(before, next))) straight.push_back(at);
  }
  straight.push_back(line.back());
  return straight;
}

/// Returns the cells by which the robot can come back from where it is then; nullopt: the section is not in sight.
std::optional<std::vector<Cell>> WallFollower::follow(CellWalk& walk, std::uint32_t section, bool left) {
  const auto first_point = nearest_point_in_sight(sections_[section], robot_.centre(walk.at()));
  if (!first_point) return std::nullopt;
  if (!unfollowed(after(section, left)) && unfollowed(after(section, !left))) left = !left;
  Excursion drive = excursion(walk.at(), section, *first_point, left);
  const Polyline line = straightened(drive.line);
  length_ += oxturn::length(line);
  walk.drive(line, drive.return_cells.back());
  return std::move(drive.return_cells);
}

}  // namespace oxturn
