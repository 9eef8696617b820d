#include "algorithms/online/belief.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "algorithms/lattice/grid_graph.hpp"
#include "algorithms/online/star.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kCellsARadius = 16, kCellsWithNoise = 32;
constexpr double kSigmas = 3;                          // by which stars keep off noisy readings
constexpr double kCaution = 2, kCautionWithNoise = 3;  // StarRules::caution
constexpr std::uint64_t kEveryByte = 0x0101010101010101;

double first_cell(const Robot& robot) {
  const double size = robot_size(robot);
  const double noise = robot.lidar->noise;
  return noise > 0 ? std::clamp(noise / 2, size / kCellsWithNoise, size / 4) : size / kCellsARadius;
}

}  // namespace

Belief::Belief(const Robot& robot, const Point& start) {
  if (!robot.lidar) throw std::logic_error("a belief needs a robot with a lidar");
  lidar_ = *robot.lidar;
  radius_ = robot.radius;
  size_ = robot_size(robot);
  tolerance_ = 1e-9 * robot.tool_width + 1e-15 * start.cwiseAbs().maxCoeff();
  direction_ = ray_directions(lidar_.rays);
  cell_ = first_cell(robot);
  // Off the start by odd fractions: walls at round distances from it must not all fall on lattice lines, where they
  // would cost a whole cell.
  lattice_ = start - cell_ * Point(0.37, 0.61);
  const Point reach(2 * radius_ + 8 * cell_, 2 * radius_ + 8 * cell_);
  grow(start - reach, start + reach);
  if (!noisy()) outline_.emplace(size_);
  mark_own_disc(start);
}

/// Where the robot is there is no wall, whatever hits say.
void Belief::mark_own_disc(const Point& pose) {
  if (radius_ <= 0) return;
  constexpr int kVertices = 128;
  Ring disc;
  for (const Point& d : ray_directions(kVertices)) disc.push_back(radius_ * d);
  for (int times = 0; times < (noisy() ? kMost / kFor : 1); ++times) fill(disc, pose, kNear);
  if (outline_) outline_->add(disc, pose, kVertices);
}

double Belief::trusted_range() const {
  return std::min(lidar_.range, far_apart() / (2 * math::sin(kPi / std::max(5, lidar_.rays))));
}

bool Belief::is_free(std::size_t c) const {
  if (noisy()) return weight_[c] >= kFreeFrom || (weight_[c] >= 0 && (mark_[c] & (kFar | kHit)) == kFar);
  return (mark_[c] & (kFar | kNear)) != 0 && (mark_[c] & kHit) == 0;
}

template <class F>
void Belief::for_each_cell_around(int i, int j, int reach, F f) {
  for (int y = std::max(0, j - reach); y <= std::min(rows_ - 1, j + reach); ++y)
    for (int x = std::max(0, i - reach); x <= std::min(columns_ - 1, i + reach); ++x) f(x, y);
}

/// Something narrow was overlooked, or may have been: cells around it that were only seen from afar must be seen from
/// near.
void Belief::distrust(int i, int j) {
  const int reach = static_cast<int>(std::ceil(size_ / 4 / cell_));
  for_each_cell_around(i, j, reach, [&](int x, int y) {
    const std::size_t c = at(x, y);
    const bool was_free = is_free(c);
    if (noisy()) {
      mark_[c] |= kHit;
      if (2 * std::max(std::abs(x - i), std::abs(y - j)) <= reach) mark_[c] |= kDistrusted;
    } else if ((mark_[c] & (kNear | kHit)) == 0) {
      mark_[c] = static_cast<std::uint8_t>(mark_[c] & ~kFar);
    }
    block_mark_[block_at(x, y)] = 0;
    if (was_free && !is_free(c)) ++lost_;
  });
}

void Belief::mark_hits(const Scan& scan, const std::vector<Point>& walls) {
  const double near = near_apart() / scan.step();
  for (const Point& wall : walls) {
    const int i = column(wall.x()), j = row(wall.y());
    if (!inside(i, j)) continue;
    if (noisy())
      mark_noisy_hit(i, j, distance(wall, scan.eye) <= near);
    else
      mark_exact_hit(i, j);
  }
}

void Belief::mark_exact_hit(int i, int j) {
  const std::size_t c = at(i, j);
  const bool was_free = is_free(c);
  mark_[c] |= kHit;
  if (!was_free) return;
  ++lost_;
  distrust(i, j);
}

void Belief::mark_noisy_hit(int i, int j, bool near) {
  mark_[at(i, j)] |= kWall;
  for_each_cell_around(i, j, 1, [&](int x, int y) {
    const std::size_t c = at(x, y);
    const bool was_free = is_free(c);
    weight_[c] = static_cast<std::int8_t>(std::max(weight_[c] + kAgainst, -kMost));
    block_mark_[block_at(x, y)] = 0;
    if (was_free && !is_free(c)) ++lost_;
  });
  if (near && (mark_[at(i, j)] & kDistrusted) == 0) distrust(i, j);
}

/// The chord between neighbouring hits, where it is so short that nothing of interest lies behind it.
void Belief::mark_walls(const Scan& scan) {
  const std::size_t n = scan.reading.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = k + 1 < n ? k + 1 : 0;
    if (!std::isfinite(scan.reading[k]) || !std::isfinite(scan.reading[next])) continue;
    const Point p = scan.eye + scan.reading[k] * direction_[k], q = scan.eye + scan.reading[next] * direction_[next];
    const double length = distance(p, q);
    if (length > std::max(radius_, 16 * cell_)) continue;
    const int steps = static_cast<int>(length / cell_) + 1;
    for (int s = 0; s <= steps; ++s) {
      const Point r = lerp(p, q, static_cast<double>(s) / steps);
      const int i = column(r.x()), j = row(r.y());
      if (inside(i, j)) mark_[at(i, j)] |= kWall;
    }
  }
}

/// The near star and the far one. `corners` gets the corners that the exact near star knows.
std::array<Belief::RatedStar, 2> Belief::stars_of(const Scan& scan, std::vector<Point>& corners) const {
  StarRules near{near_apart(), noisy() ? kCautionWithNoise : kCaution, tolerance_}, far = near;
  far.apart = far_apart();
  if (noisy()) {
    const double margin = kSigmas * lidar_.noise;
    return {{{noisy_star(scan, direction_, near, margin), kNear}, {noisy_star(scan, direction_, far, margin), kFar}}};
  }
  return {{{star(scan, direction_, near, &corners), kNear}, {star(scan, direction_, far), kFar}}};
}

void Belief::add(const Scan& scan) {
  std::vector<Point> walls, corners;
  for (std::size_t k = 0; k < scan.reading.size(); ++k)
    if (std::isfinite(scan.reading[k])) walls.push_back(scan.eye + scan.reading[k] * direction_[k]);
  const std::array<RatedStar, 2> stars = stars_of(scan, corners);
  for (Point& p : corners) p += scan.eye;
  for (auto& known : cells_) known.reset();
  for (auto& known : regions_) known.reset();
  Box box;
  for (const RatedStar& star : stars)
    for (const Point& p : star.ring) box.add(scan.eye + p);
  if (box.empty()) return;
  box.grow(2 * cell_);
  grow(box.low, box.high);
  const bool refuted = outline_ && outline_->add_walls(walls, corners, scan.eye);
  lost_ += refuted ? 1 : 0;
  for (const auto& [ring, mark] : stars)
    if ((fill(ring, scan.eye, mark) || refuted) && outline_ && mark == kFar)
      outline_->add(ring, scan.eye, scan.reading.size());
  walls.insert(walls.end(), corners.begin(), corners.end());
  mark_hits(scan, walls);
  mark_walls(scan);
  if (noisy()) mark_own_disc(scan.eye);
}

bool Belief::free_span(int j, int from, int to) const {
  if (j < 0 || j >= rows_ || from < 0 || to >= columns_) return false;
  bool all = true;
  if (noisy()) {
    for (int i = from; i <= to; ++i) all &= is_free(at(i, j));
  } else {
    const std::uint8_t* m = mark_.data() + at(from, j);
    for (int k = 0; k <= to - from; ++k) all &= (m[k] & (kFar | kNear)) != 0 && (m[k] & kHit) == 0;
  }
  return all;
}

bool Belief::free_for(const Point& a, const Point& b, double radius) const {
  if (noisy()) radius = std::max(0.0, radius - 1.5 * cell_);
  if (free_by_cells(a, b, radius)) return true;
  // A robot that touches a wall meets cells that the wall cuts.
  return outline_ && outline_->free_for(a, b, radius);
}

bool Belief::free_by_cells(const Point& a, const Point& b, double radius) const {
  const double low = std::min(a.y(), b.y()) - radius, high = std::max(a.y(), b.y()) + radius;
  const Point along = b - a;
  const double length = along.norm();
  const Point side = length > 0 ? Point(radius / length * perpendicular(along)) : Point(0, 0);
  for (int j = row(low); j <= row(high); ++j) {
    const double y0 = low_.y() + cell_ * j, y1 = y0 + cell_;
    double left = 1e300, right = -1e300;  // of the capsule, in this row
    const auto add = [&](double x) {
      left = std::min(left, x);
      right = std::max(right, x);
    };
    for (const Point* c : {&a, &b}) {  // the two discs
      const double dy = std::max({0.0, y0 - c->y(), c->y() - y1});
      if (dy >= radius) continue;
      const double half = std::sqrt(radius * radius - dy * dy);
      add(c->x() - half);
      add(c->x() + half);
    }
    for (const double sign : {-1.0, 1.0}) {  // the two flanks
      const Point p = a + sign * side, q = b + sign * side;
      const double bottom = std::min(p.y(), q.y()), top = std::max(p.y(), q.y());
      if (bottom > y1 || top < y0 || length == 0) continue;
      const double rise = q.y() - p.y();
      const double t0 = rise == 0 ? 0 : (std::max(bottom, y0) - p.y()) / rise;
      const double t1 = rise == 0 ? 1 : (std::min(top, y1) - p.y()) / rise;
      for (const double t : {t0, t1}) add(p.x() + std::clamp(t, 0.0, 1.0) * (q.x() - p.x()));
    }
    if (left > right) continue;
    // A flank along a lattice line touches no cell beyond it.
    const int from = column(left), to = std::max(from, static_cast<int>(std::ceil((right - low_.x()) / cell_)) - 1);
    if (!free_span(j, from, to)) return false;
  }
  return true;
}

/// Eight cells as a word, a byte each: 1 if free.
std::uint64_t Belief::free_word(std::size_t c) const {
  std::uint64_t w = 0;
  if (noisy()) {
    for (std::size_t k = 0; k < 8; ++k) w |= std::uint64_t{is_free(c + k)} << (8 * k);
    return w;
  }
  std::memcpy(&w, mark_.data() + c, 8);
  static_assert(kFar == 1 && kNear == 2 && kHit == 4);
  return (w | w >> 1) & ~(w >> 2) & kEveryByte;
}

const Belief::Cells& Belief::cells(int level) const {
  auto& known = cells_[static_cast<std::size_t>(level)];
  if (known) return *known;
  static_assert(std::endian::native == std::endian::little && kBlock % 8 == 0 && kCoarsest <= 3);
  const int block = 1 << level, groups = 8 / block;  // cells a side of a coarse cell; coarse cells a word
  const std::uint64_t group = level == 3 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * block)) - 1;
  Cells& out = known.emplace();
  out.free = BitGrid(low_, cell_ * block, columns_ / block, rows_ / block);
  out.wall = out.free;
  for (int j = 0; j < out.free.rows; ++j)
    for (int word = 0; word < columns_ / 8; ++word) {
      std::uint64_t all = kEveryByte, any = 0;
      for (int y = 0; y < block; ++y) {
        const std::size_t c = at(8 * word, j * block + y);
        std::uint64_t marks;
        std::memcpy(&marks, mark_.data() + c, 8);
        if (marks == 0 && !noisy()) {
          all = 0;
          continue;
        }
        all &= free_word(c);
        any |= marks & (kEveryByte * (kHit | kWall));
      }
      for (int g = 0; g < groups; ++g) {
        const std::uint64_t here = group << (8 * block * g);
        const std::size_t to = out.free.at(word * groups + g, j);
        const bool free = (all & here) == (kEveryByte & here);
        out.free.bits[to] = free ? 1 : 0;
        out.wall.bits[to] = !free && (any & here) != 0 ? 1 : 0;
      }
    }
  return out;
}

const Region& Belief::region(int level) const {
  if (outline_) return outline_->region(level > 0);
  auto& known = regions_[static_cast<std::size_t>(level)];
  if (!known) {
    const BitGrid& grid = cells(level).free;
    known = simplify_inward(trace(grid), 1.05 * grid.cell);
  }
  return *known;
}

}  // namespace oxturn
