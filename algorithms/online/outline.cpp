#include "algorithms/online/outline.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/overlay/boolean.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kShrink = 5e-7;
constexpr double kSimpler[] = {1.0 / 128, 1.0 / 32};  // of the size
constexpr double kAbout = 1.0 / 8;  // of the size: half the side of the square about a wall point that was overlooked
constexpr double kNear = 8;         // sizes: wall points from nearer are kept on a fine lattice
constexpr double kExact = 1e-3, kFine = 1.0 / 128, kCoarse = 1.0 / 16;  // of the size: squares with one point each
constexpr std::size_t kMostPending = 64;

double angle_of(const Point& p) {
  const double angle = std::atan2(p.y(), p.x());
  return angle < 0 ? angle + 2 * kPi : angle;
}

/// Of squares of side * size; three lattices have different keys (or hardly ever the same).
std::uint64_t square_of(const Point& p, double side, double size) {
  const auto i = static_cast<std::uint64_t>(std::llround(p.x() / (side * size)));
  const auto j = static_cast<std::uint64_t>(std::llround(p.y() / (side * size)));
  return (i << 32 | (j & 0xffffffff)) * 0x9e3779b97f4a7c15 + static_cast<std::uint64_t>(1 / side);
}

}  // namespace

bool Outline::Star::contains(const Point& p) const {
  if ((p - eye).squaredNorm() >= reach2) return false;
  const auto after = std::upper_bound(angle.begin(), angle.end(), angle_of(p - eye)) - angle.begin();
  const std::size_t k = static_cast<std::size_t>(after), n = ring.size();
  const Point &a = ring[(k + n - 1) % n], &b = ring[k % n];
  return cross(b - a, p - a) > 0;
}

bool Outline::Star::says_free(const Point& p) const {
  if (!contains(p)) return false;
  for (std::size_t k = 0; k < cut.size(); ++k)
    if (cut_box[k].contains(p) && oxturn::contains(cut[k], p)) return false;
  return true;
}

void Outline::Star::refute(const Point& p, const Box& box) {
  const double first = std::floor(angle_of(p - eye) / step) * step, far = 2 * std::sqrt(reach2);
  const Point u(std::cos(first), std::sin(first)), v(std::cos(first + step), std::sin(first + step));
  const Region wedge{{Polygon{{eye, eye + far * u, eye + far * v}, {}}}};
  cut_box.push_back(box);
  cut.push_back(intersect(wedge, box_region(box.low, box.high)));
}

/// A part of the star that holds all that it has in the box.
Region Outline::Star::sector(const Box& box) const {
  if (box.contains(eye)) return {{Polygon{ring, {}}}};
  const Point middle = box.centre() - eye;
  const double half = std::atan2(box.size().norm() / 2, middle.norm()), at = angle_of(middle);
  if (at - half < 0 || at + half > 2 * kPi) return {{Polygon{ring, {}}}};
  const auto first = std::lower_bound(angle.begin(), angle.end(), at - half) - angle.begin();
  const auto last = std::upper_bound(angle.begin(), angle.end(), at + half) - angle.begin();
  if (first == 0 || last == static_cast<std::ptrdiff_t>(angle.size())) return {{Polygon{ring, {}}}};
  Ring part{eye};
  part.insert(part.end(), ring.begin() + first - 1, ring.begin() + last + 1);
  return {{Polygon{std::move(part), {}}}};
}

Box Outline::about(const Point& p) const {
  Box box;
  box.add(p);
  box.grow(kAbout * size_);
  return box;
}

bool Outline::is_free(const Point& p) const {
  if (edges_ && edges_->contains(p)) return true;
  return std::any_of(stars_.end() - static_cast<std::ptrdiff_t>(pending_.size()), stars_.end(),
                     [&](const Star& star) { return star.says_free(p); });
}

void Outline::merge() const {
  if (pending_.empty()) return;
  pending_.push_back(std::move(free_));
  free_ = unite(pending_);
  pending_.clear();
  edges_.emplace(free_);
}

void Outline::add(const Ring& ring, const Point& eye, std::size_t rays) {
  Star star;
  star.eye = eye;
  star.step = 2 * kPi / static_cast<double>(rays);
  for (const Point& p : ring) {
    const Point q = (1 - kShrink) * p;
    star.ring.push_back(eye + q);
    star.angle.push_back(std::max(star.angle.empty() ? 0 : star.angle.back(), angle_of(p)));
    star.reach2 = std::max(star.reach2, q.squaredNorm());
  }
  for (const Point& p : walls_)
    if (star.says_free(p)) star.refute(p, about(p));
  Region region{{Polygon{star.ring, {}}}};
  if (!star.cut.empty()) region = subtract(region, unite(star.cut));
  stars_.push_back(std::move(star));
  pending_.push_back(std::move(region));
  simple_ = {};
  if (pending_.size() >= kMostPending) merge();
}

bool Outline::add_walls(const std::vector<Point>& hits, const std::vector<Point>& corners, const Point& eye) {
  std::vector<Box> boxes;
  const auto add = [&](const Point& p, double side) {
    if (!seen_.insert(square_of(p, side, size_)).second) return;
    walls_.push_back(p);
    if (!is_free(p)) return;
    bool wrong = false;
    for (Star& star : stars_)
      if (star.says_free(p)) {
        star.refute(p, about(p));
        wrong = true;
      }
    if (wrong) boxes.push_back(about(p));
  };
  for (const Point& p : hits) add(p, distance(p, eye) < kNear * size_ ? kFine : kCoarse);
  for (const Point& p : corners) add(p, kExact);
  if (boxes.empty()) return false;

  // In the boxes all is united anew.
  merge();
  std::vector<Region> squares, patches;
  for (const Box& box : boxes) {
    squares.push_back(box_region(box.low, box.high));
    std::vector<Region> sectors;
    for (const Star& star : stars_) {
      const double away = std::max(0.0, distance(star.eye, box.centre()) - box.size().norm() / 2);
      if (away * away >= star.reach2) continue;
      Region sector = star.sector(box);
      std::vector<Region> cut;
      for (std::size_t k = 0; k < star.cut.size(); ++k)
        if (star.cut_box[k].overlaps(box)) cut.push_back(star.cut[k]);
      if (!cut.empty()) sector = subtract(sector, unite(cut));
      sectors.push_back(std::move(sector));
    }
    patches.push_back(intersect(unite(sectors), squares.back()));
  }
  patches.push_back(subtract(free_, unite(squares)));
  free_ = unite(patches);
  edges_.emplace(free_);
  simple_ = {};
  return true;
}

const Region& Outline::region(bool coarse) const {
  merge();
  auto& known = simple_[coarse ? 1 : 0];
  if (!known) known = simplify_inward(free_, kSimpler[coarse ? 1 : 0] * size_);
  return *known;
}

bool Outline::free_for(const Point& a, const Point& b, double radius) const {
  const auto holds = [&] { return edges_ && edges_->contains(a) && !edges_->nearest(a, b, radius); };
  if (holds()) return true;
  if (pending_.empty()) return false;
  merge();
  return holds();
}

}  // namespace oxturn
