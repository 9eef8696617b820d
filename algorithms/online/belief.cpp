#include "algorithms/online/belief.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "algorithms/online/star.hpp"

namespace oxturn {
namespace {

// Bits of a cell.
constexpr std::uint8_t kFar = 1, kNear = 2, kHit = 4, kWall = 8;  // kWall: on a chord between hits of one wall
constexpr std::uint8_t kAsked =
    16;  // with noise: a hit so near by has been dealt with. There kHit means: far does not count

constexpr double kCellsARadius = 16, kCellsWithNoise = 32;
constexpr std::int64_t kMostCells = std::int64_t{1} << 26;
constexpr int kBlock = 64;         // cells, in a row, that are looked at together
constexpr int kAlign = kBlock;     // windows begin and end at multiples, so that coarse cells and halving fit
constexpr double kKeepOff = 1e-3;  // cells by which a certain cell is inside its star: more than all rounding

constexpr std::uint64_t kEveryByte = 0x0101010101010101;

// Evidence of near stars and of hits: a cell is free from kFreeFrom on; while nothing speaks against it, also by far.
constexpr int kFor = 2, kAgainst = -4, kMost = 20, kFreeFrom = 2;

double size_of(const Robot& robot) { return robot.radius > 0 ? robot.radius : robot.tool_width / 2; }

double first_cell(const Robot& robot) {
  const double size = size_of(robot);
  const double noise = robot.lidar->noise;
  return noise > 0 ? std::clamp(noise / 2, size / kCellsWithNoise, size / 4) : size / kCellsARadius;
}

std::int64_t floor_to(std::int64_t v, std::int64_t step) {
  const std::int64_t rest = v % step;
  return v - (rest < 0 ? rest + step : rest);
}

}  // namespace

Belief::Belief(const Robot& robot, const Point& start) {
  if (!robot.lidar) throw std::logic_error("a belief needs a robot with a lidar");
  lidar_ = *robot.lidar;
  radius_ = robot.radius;
  size_ = size_of(robot);
  tolerance_ = 1e-9 * robot.tool_width + 1e-15 * start.cwiseAbs().maxCoeff();
  direction_ = ray_directions(lidar_.rays);
  cell_ = first_cell(robot);
  // Walls at round distances from the start must not all fall on lattice lines, where they would cost a whole cell.
  lattice_ = start - cell_ * Point(0.37, 0.61);
  const Point reach(2 * radius_ + 8 * cell_, 2 * radius_ + 8 * cell_);
  grow(start - reach, start + reach);

  if (lidar_.noise == 0) outline_.emplace(size_);
  stand(start);
}

// Where the robot stands there is no wall, whatever hits say.
void Belief::stand(const Point& pose) {
  if (radius_ <= 0) return;
  constexpr int kCorners = 128;
  Ring disc;
  for (const Point& d : ray_directions(kCorners)) disc.push_back(radius_ * d);
  for (int times = 0; times < (lidar_.noise > 0 ? kMost / kFor : 1); ++times) fill(disc, pose, kNear);
  if (outline_) outline_->add(disc, pose, kCorners);
}

// Makes the window hold the box, with room to spare, so that growing is rare.
void Belief::grow(const Point& low, const Point& high) {
  const auto index = [&](double v, double origin) {
    return static_cast<std::int64_t>(std::floor((v - origin) / cell_));
  };
  std::int64_t i0 = index(low.x(), lattice_.x()) - 2, j0 = index(low.y(), lattice_.y()) - 2;
  std::int64_t i1 = index(high.x(), lattice_.x()) + 3, j1 = index(high.y(), lattice_.y()) + 3;
  if (columns_ > 0) {
    if (i0 >= i0_ && j0 >= j0_ && i1 <= i0_ + columns_ && j1 <= j0_ + rows_) return;
    // To the sides that grow, an eighth more.
    const std::int64_t spare_i = columns_ / 8, spare_j = rows_ / 8;
    i0 = i0 < i0_ ? i0 - spare_i : i0_;
    j0 = j0 < j0_ ? j0 - spare_j : j0_;
    i1 = i1 > i0_ + columns_ ? i1 + spare_i : i0_ + columns_;
    j1 = j1 > j0_ + rows_ ? j1 + spare_j : j0_ + rows_;
  }
  i0 = floor_to(i0, kAlign);
  j0 = floor_to(j0, kAlign);
  i1 = floor_to(i1 + kAlign - 1, kAlign);
  j1 = floor_to(j1 + kAlign - 1, kAlign);

  int halvings = 0;
  while (((i1 - i0) >> halvings) * ((j1 - j0) >> halvings) > kMostCells) ++halvings;
  if (halvings > 0) {  // begin and end at multiples that halve well
    const std::int64_t step = std::int64_t{kAlign} << halvings;
    i0 = floor_to(i0, step);
    j0 = floor_to(j0, step);
    i1 = floor_to(i1 + step - 1, step);
    j1 = floor_to(j1 + step - 1, step);
  }
  const int block = 1 << halvings;
  const auto columns = static_cast<int>((i1 - i0) >> halvings), rows = static_cast<int>((j1 - j0) >> halvings);
  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<std::uint8_t> mark(cells, 0);
  std::vector<std::int8_t> weight(lidar_.noise > 0 ? cells : 0, 0);
  if (halvings == 0) {
    for (int j = 0; j < rows_; ++j) {
      const std::size_t to = static_cast<std::size_t>(j + j0_ - j0) * static_cast<std::size_t>(columns) +
                             static_cast<std::size_t>(i0_ - i0);
      std::copy_n(mark_.begin() + static_cast<std::ptrdiff_t>(at(0, j)), columns_,
                  mark.begin() + static_cast<std::ptrdiff_t>(to));
      if (!weight.empty())
        std::copy_n(weight_.begin() + static_cast<std::ptrdiff_t>(at(0, j)), columns_,
                    weight.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  // A coarse cell is as certain as the least certain of its cells, and holds a wall if one of them does.
  for (int j = 0; j < rows && halvings > 0 && columns_ > 0; ++j)
    for (int i = 0; i < columns; ++i) {
      const std::size_t to =
          static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
      std::uint8_t all = kFar | kNear, any = 0;
      int least = kMost;
      bool known = true;
      for (int y = 0; y < block && known; ++y)
        for (int x = 0; x < block; ++x) {
          const std::int64_t old_i = i0 + std::int64_t{i} * block + x - i0_,
                             old_j = j0 + std::int64_t{j} * block + y - j0_;
          if (old_i < 0 || old_j < 0 || old_i >= columns_ || old_j >= rows_) {
            known = false;
            break;
          }
          const std::size_t from = at(static_cast<int>(old_i), static_cast<int>(old_j));
          std::uint8_t m = mark_[from];
          if ((m & kNear) != 0) m |= kFar;
          all &= m;
          any |= m;
          if (!weight.empty()) least = std::min<int>(least, weight_[from]);
        }
      if (!known) all = 0;
      mark[to] = static_cast<std::uint8_t>(all | (any & (kHit | kWall)));
      if (!weight.empty()) weight[to] = static_cast<std::int8_t>(known ? least : std::min(least, 0));
    }
  if (halvings > 0)
    lost_ += columns_ > 0 ? 1 : 0;  // coarser cells reach less far: what was planned must be looked at again
  done_.assign(cells / kBlock, 0);
  mark_ = std::move(mark);
  weight_ = std::move(weight);
  cell_ *= block;
  i0_ = i0 >> halvings;
  j0_ = j0 >> halvings;
  columns_ = columns;
  rows_ = rows;
  low_ = lattice_ + cell_ * Point(static_cast<double>(i0_), static_cast<double>(j0_));
}

double Belief::trusted_range() const {
  return std::min(lidar_.range, far_apart() / (2 * std::sin(kPi / std::max(5, lidar_.rays))));
}

std::size_t Belief::block_at(int i, int j) const { return at(i, j) / kBlock; }

bool Belief::is_free(std::size_t c) const {
  if (lidar_.noise > 0) return weight_[c] >= kFreeFrom || (weight_[c] >= 0 && (mark_[c] & (kFar | kHit)) == kFar);
  return (mark_[c] & (kFar | kNear)) != 0 && (mark_[c] & kHit) == 0;
}

// Eight cells at a time, and whole blocks of them at once where all have been marked before, as most have.
void Belief::mark_span(int j, int from, int to, std::uint8_t mark) {
  for (int i = from; i <= to;) {
    const int block = i / kBlock, end = std::min(to + 1, (block + 1) * kBlock);
    const bool whole = i == block * kBlock && end == i + kBlock;
    std::uint8_t& done = done_[block_at(i, j)];
    if ((done & mark) == 0) {
      const bool all = lidar_.noise > 0 && mark == kNear
                           ? weigh(at(i, j), at(i, j) + static_cast<std::size_t>(end - i))
                           : set_marks(at(i, j), at(i, j) + static_cast<std::size_t>(end - i), mark);
      if (whole && all) done = static_cast<std::uint8_t>(done | mark);
    }
    i = end;
  }
}

// Counts for the cells begin .. end - 1. Returns whether all have the greatest weight.
bool Belief::weigh(std::size_t begin, std::size_t end) {
  bool all = true;
  for (std::size_t c = begin; c < end; ++c) {
    if (weight_[c] == kMost) continue;
    const bool was = is_free(c);
    weight_[c] = static_cast<std::int8_t>(std::min(weight_[c] + kFor, kMost));
    all = all && weight_[c] == kMost;
    gained_ += !was && is_free(c) ? 1 : 0;
  }
  return all;
}

bool Belief::set_marks(std::size_t begin, std::size_t end, std::uint8_t mark) {
  const std::uint64_t marks = kEveryByte * mark;
  std::size_t c = begin;
  for (; c + 8 <= end; c += 8) {
    std::uint64_t eight;
    std::memcpy(&eight, mark_.data() + c, 8);
    if ((eight & marks) == marks) continue;
    marked_anew_ = true;
    const std::uint64_t known = (eight | eight >> 1 | eight >> 2) & kEveryByte;  // far, near or hit
    gained_ += 8 - static_cast<std::uint64_t>(std::popcount(known));
    eight |= marks;
    std::memcpy(mark_.data() + c, &eight, 8);
  }
  for (; c < end; ++c) {
    marked_anew_ = marked_anew_ || (mark_[c] & mark) == 0;
    gained_ += (mark_[c] & (kFar | kNear | kHit)) == 0 ? 1 : 0;
    mark_[c] = static_cast<std::uint8_t>(mark_[c] | mark);
  }
  return true;
}

// Cells wholly inside the ring: those whose centre is, less those that an edge comes near. Returns whether any had not
// been marked so before.
bool Belief::fill(const Ring& ring, const Point& eye, std::uint8_t mark) {
  marked_anew_ = false;
  if (ring.size() < 3) return false;
  std::vector<Point> corner;
  corner.reserve(ring.size());
  for (const Point& p : ring) corner.push_back((eye + p - low_) / cell_);
  double bottom = 1e300, top = -1e300;
  for (const Point& p : corner) {
    bottom = std::min(bottom, p.y());
    top = std::max(top, p.y());
  }
  const int first = std::max(0, static_cast<int>(std::floor(bottom - kKeepOff)));
  const int last = std::min(rows_ - 1, static_cast<int>(std::floor(top + kKeepOff)));
  if (last < first) return false;
  if (scratch_.size() < static_cast<std::size_t>(last - first + 1))
    scratch_.resize(static_cast<std::size_t>(last - first + 1));

  for (std::size_t k = 0; k < corner.size(); ++k) {
    const Point &p = corner[k], &q = corner[k + 1 < corner.size() ? k + 1 : 0];
    const Point &a = p.y() <= q.y() ? p : q, &b = p.y() <= q.y() ? q : p;
    const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0;
    const int from = std::max(first, static_cast<int>(std::floor(a.y() - kKeepOff)));
    const int to = std::min(last, static_cast<int>(std::floor(b.y() + kKeepOff)));
    for (int j = from; j <= to; ++j) {
      Row& row = scratch_[static_cast<std::size_t>(j - first)];
      const double y0 = std::clamp(j - kKeepOff, a.y(), b.y()), y1 = std::clamp(j + 1 + kKeepOff, a.y(), b.y());
      double left = b.y() > a.y() ? a.x() + slope * (y0 - a.y()) : a.x();
      double right = b.y() > a.y() ? a.x() + slope * (y1 - a.y()) : b.x();
      if (left > right) std::swap(left, right);
      row.cuts.emplace_back(static_cast<int>(std::floor(left - kKeepOff)),
                            static_cast<int>(std::floor(right + kKeepOff)));
      const double centre = j + 0.5;
      if ((a.y() <= centre) != (b.y() <= centre)) row.crossings.push_back(a.x() + slope * (centre - a.y()));
    }
  }
  for (int j = first; j <= last; ++j) {
    Row& row = scratch_[static_cast<std::size_t>(j - first)];
    std::sort(row.crossings.begin(), row.crossings.end());
    std::sort(row.cuts.begin(), row.cuts.end());
    std::size_t cut = 0;
    int done = 0;  // cells before it are dealt with
    for (std::size_t k = 0; k + 1 < row.crossings.size(); k += 2) {
      int from = std::max({0, done, static_cast<int>(std::ceil(row.crossings[k] - 0.5))});
      const int to = std::min(columns_ - 1, static_cast<int>(std::ceil(row.crossings[k + 1] - 0.5)) - 1);
      while (from <= to) {
        while (cut < row.cuts.size() && row.cuts[cut].second < from) ++cut;
        if (cut < row.cuts.size() && row.cuts[cut].first <= from) {
          from = row.cuts[cut].second + 1;
          continue;
        }
        const int end = cut < row.cuts.size() ? std::min(to, row.cuts[cut].first - 1) : to;
        mark_span(j, from, end, mark);
        from = end + 1;
      }
      done = std::max(done, from);
    }
    row.crossings.clear();
    row.cuts.clear();
  }
  return marked_anew_;
}

// Something narrow was overlooked, or may be: cells about it that were only seen from afar must be seen from near.
void Belief::distrust(int i, int j) {
  const bool noisy = lidar_.noise > 0;
  const int reach = static_cast<int>(std::ceil(size_ / 4 / cell_));
  for (int y = std::max(0, j - reach); y <= std::min(rows_ - 1, j + reach); ++y)
    for (int x = std::max(0, i - reach); x <= std::min(columns_ - 1, i + reach); ++x) {
      const std::size_t c = at(x, y);
      const bool was = is_free(c);
      if (noisy) {
        mark_[c] |= kHit;
        if (2 * std::max(std::abs(x - i), std::abs(y - j)) <= reach) mark_[c] |= kAsked;
      } else if ((mark_[c] & (kNear | kHit)) == 0)
        mark_[c] = static_cast<std::uint8_t>(mark_[c] & ~kFar);
      done_[block_at(x, y)] = 0;
      if (was && !is_free(c)) ++lost_;
    }
}

void Belief::mark_hits(const Scan& scan, const std::vector<Point>& walls) {
  const double near = near_apart() / scan.step();
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const int i = column(walls[k].x()), j = row(walls[k].y());
    if (!inside(i, j)) continue;
    const std::size_t c = at(i, j);
    if (lidar_.noise == 0) {
      const bool was = is_free(c);
      mark_[c] |= kHit;
      if (!was) continue;
      ++lost_;
      distrust(i, j);
      continue;
    }
    mark_[c] |= kWall;
    for (int y = std::max(0, j - 1); y <= std::min(rows_ - 1, j + 1); ++y)
      for (int x = std::max(0, i - 1); x <= std::min(columns_ - 1, i + 1); ++x) {
        const std::size_t about = at(x, y);
        const bool was = is_free(about);
        weight_[about] = static_cast<std::int8_t>(std::max(weight_[about] + kAgainst, -kMost));
        done_[block_at(x, y)] = 0;
        if (was && !is_free(about)) ++lost_;
      }
    if (distance(walls[k], scan.eye) <= near && (mark_[c] & kAsked) == 0) distrust(i, j);
  }
}

// The chord between neighbouring hits, where it is so short that nothing of interest is behind it.
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

void Belief::add(const Scan& scan) {
  StarRules rules;
  rules.tolerance = tolerance_;
  std::vector<Point> walls, corners;
  for (std::size_t k = 0; k < scan.reading.size(); ++k)
    if (std::isfinite(scan.reading[k])) walls.push_back(scan.eye + scan.reading[k] * direction_[k]);
  std::vector<std::pair<Ring, std::uint8_t>> stars;
  if (lidar_.noise > 0) {
    rules.caution = 3;
    rules.apart = near_apart();
    stars.emplace_back(noisy_star(scan, direction_, rules, 3 * lidar_.noise), kNear);
    rules.apart = far_apart();
    stars.emplace_back(noisy_star(scan, direction_, rules, 3 * lidar_.noise), kFar);
  } else {
    rules.caution = 2;
    rules.apart = near_apart();
    stars.emplace_back(star(scan, direction_, rules, &corners), kNear);
    for (Point& p : corners) p += scan.eye;
    rules.apart = far_apart();
    stars.emplace_back(star(scan, direction_, rules), kFar);
  }
  for (auto& known : cells_) known.reset();
  for (auto& known : regions_) known.reset();
  Box box;
  for (const auto& [ring, mark] : stars)
    for (const Point& p : ring) box.add(scan.eye + p);
  if (box.empty()) return;
  box.grow(2 * cell_);
  grow(box.low, box.high);
  const bool wrong = outline_ && outline_->add_walls(walls, corners, scan.eye);
  lost_ += wrong ? 1 : 0;
  for (const auto& [ring, mark] : stars)
    if ((fill(ring, scan.eye, mark) || wrong) && outline_ && mark == kFar)
      outline_->add(ring, scan.eye, scan.reading.size());
  walls.insert(walls.end(), corners.begin(), corners.end());
  mark_hits(scan, walls);
  mark_walls(scan);
  if (lidar_.noise > 0) stand(scan.eye);
}

bool Belief::free_span(int j, int from, int to) const {
  if (j < 0 || j >= rows_ || from < 0 || to >= columns_) return false;
  bool all = true;
  if (lidar_.noise > 0) {
    for (int i = from; i <= to; ++i) all &= is_free(at(i, j));
  } else {
    const std::uint8_t* m = mark_.data() + at(from, j);
    for (int k = 0; k <= to - from; ++k) all &= (m[k] & (kFar | kNear)) != 0 && (m[k] & kHit) == 0;
  }
  return all;
}

bool Belief::free_for(const Point& a, const Point& b, double radius) const {
  if (lidar_.noise > 0) radius = std::max(0.0, radius - 1.5 * cell_);
  const auto by_cells = [&] {
    const double low = std::min(a.y(), b.y()) - radius, high = std::max(a.y(), b.y()) + radius;
    const Point along = b - a;
    const double length = along.norm();
    const Point side = length > 0 ? Point(radius / length * perpendicular(along)) : Point(0, 0);
    for (int j = row(low); j <= row(high); ++j) {
      const double y0 = low_.y() + cell_ * j, y1 = y0 + cell_;
      double left = 1e300, right = -1e300;
      for (const Point* c : {&a, &b}) {
        const double dy = std::max({0.0, y0 - c->y(), c->y() - y1});
        if (dy >= radius) continue;
        const double half = std::sqrt(radius * radius - dy * dy);
        left = std::min(left, c->x() - half);
        right = std::max(right, c->x() + half);
      }
      for (const double sign : {-1.0, 1.0}) {  // the two straight sides
        const Point p = a + sign * side, q = b + sign * side;
        const double bottom = std::min(p.y(), q.y()), top = std::max(p.y(), q.y());
        if (bottom > y1 || top < y0 || length == 0) continue;
        const double rise = q.y() - p.y();
        const double t0 = rise == 0 ? 0 : (std::max(bottom, y0) - p.y()) / rise;
        const double t1 = rise == 0 ? 1 : (std::min(top, y1) - p.y()) / rise;
        for (const double t : {t0, t1}) {
          const double x = p.x() + std::clamp(t, 0.0, 1.0) * (q.x() - p.x());
          left = std::min(left, x);
          right = std::max(right, x);
        }
      }
      if (left > right) continue;
      // A side that runs along a lattice line touches no cell beyond it.
      const int from = column(left), to = std::max(from, static_cast<int>(std::ceil((right - low_.x()) / cell_)) - 1);
      if (!free_span(j, from, to)) return false;
    }
    return true;
  };
  if (by_cells()) return true;
  // Cells that a wall cuts are in the way of a robot that touches it.
  return outline_ && outline_->free_for(a, b, radius);
}

// Eight cells a word, one byte each: 1 if free.
std::uint64_t Belief::free_word(std::size_t c) const {
  std::uint64_t w = 0;
  if (lidar_.noise > 0) {
    for (std::size_t k = 0; k < 8; ++k) w |= std::uint64_t{is_free(c + k)} << (8 * k);
    return w;
  }
  std::memcpy(&w, mark_.data() + c, 8);
  return (w | w >> 1) & ~(w >> 2) & kEveryByte;
}

const Belief::Cells& Belief::cells(int level) const {
  auto& known = cells_[static_cast<std::size_t>(level)];
  if (known) return *known;
  static_assert(std::endian::native == std::endian::little && kAlign % 8 == 0 && kCoarsest <= 3);
  const int block = 1 << level, groups = 8 / block;  // groups: coarse cells a word
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
        if (marks == 0 && lidar_.noise == 0) {
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

double Belief::free_area() const {
  std::size_t n = 0;
  for (std::size_t c = 0; c < mark_.size(); ++c) n += is_free(c) ? 1 : 0;
  return static_cast<double>(n) * cell_ * cell_;
}

}  // namespace oxturn
