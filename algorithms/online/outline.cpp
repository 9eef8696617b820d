#include "algorithms/online/outline.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/boolean.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kShrink = 5e-7;
constexpr double kSimpler[] = {1.0 / 128, 1.0 / 16};  // of the size
constexpr double kAbout = 1.0 / 8;  // of the size: half the side of the square about a wall point that was overlooked
constexpr double kNear = 8;         // sizes: wall points from nearer are kept on a fine lattice
constexpr double kExact = 1e-3, kFine = 1.0 / 128, kCoarse = 1.0 / 16;  // of the size: squares with one point each
constexpr double kNoFarther = 1.25;  // times as far: stars that are still trusted about such a point
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

/// The corner behind p, counter-clockwise.
std::size_t Outline::Star::after(const Point& p) const {
  return static_cast<std::size_t>(std::upper_bound(angle.begin(), angle.end(), angle_of(p - eye)) - angle.begin());
}

bool Outline::Star::contains(const Point& p) const {
  if ((p - eye).squaredNorm() >= reach2) return false;
  const std::size_t k = after(p), n = ring.size();
  const Point &a = ring[(k + n - 1) % n], &b = ring[k % n];
  return cross(b - a, p - a) > 0;
}

/// A part of the star that holds all that it has in the box (which the eye is not in).
Region Outline::Star::sector(const Box& box) const {
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
                     [&](const Star& star) { return star.contains(p); });
}

void Outline::merge() const {
  if (pending_.empty()) return;
  pending_.push_back(std::move(free_));
  free_ = unite(pending_);
  pending_.clear();
  edges_.emplace(free_);
}

void Outline::add(const Ring& ring, const Point& eye) {
  Star star{eye, {}, {}};
  for (const Point& p : ring) {
    const Point q = (1 - kShrink) * p;
    star.ring.push_back(eye + q);
    star.angle.push_back(std::max(star.angle.empty() ? 0 : star.angle.back(), angle_of(p)));
    star.reach2 = std::max(star.reach2, q.squaredNorm());
  }
  std::vector<Region> overlooked;
  Box last;
  for (const Point& p : walls_)
    if (star.contains(p) && !last.contains(p)) {
      last = about(p);
      overlooked.push_back(box_region(last.low, last.high));
      last.grow(-last.size().x() / 4);
    }
  Region region{{Polygon{star.ring, {}}}};
  star.cut = !overlooked.empty();
  if (star.cut) region = subtract(region, unite(overlooked));
  stars_.push_back(std::move(star));
  pending_.push_back(std::move(region));
  simple_ = {};
  if (pending_.size() >= kMostPending) merge();
}

bool Outline::add_walls(const std::vector<Point>& hits, const std::vector<Point>& corners, const Point& eye) {
  std::vector<Point> wrong;
  Box last;
  const auto add = [&](const Point& p, double side) {
    if (!seen_.insert(square_of(p, side, size_)).second) return;
    walls_.push_back(p);
    if (last.contains(p) || !is_free(p)) return;
    wrong.push_back(p);
    last = about(p);
    last.grow(-last.size().x() / 4);
  };
  for (const Point& p : hits) add(p, distance(p, eye) < kNear * size_ ? kFine : kCoarse);
  for (const Point& p : corners) add(p, kExact);
  if (wrong.empty()) return false;

  merge();
  std::vector<Region> boxes, patches;
  for (const Point& p : wrong) {
    const Box box = about(p);
    boxes.push_back(box_region(box.low, box.high));
    std::vector<Region> sectors;
    for (const Star& star : stars_)
      if (!star.cut && distance(star.eye, p) <= kNoFarther * distance(eye, p) && !box.contains(star.eye) &&
          !star.contains(p))
        sectors.push_back(star.sector(box));
    patches.push_back(intersect(unite(sectors), boxes.back()));
  }
  patches.push_back(subtract(free_, unite(boxes)));
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
