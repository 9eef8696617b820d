#include "algorithms/online/outline.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// Lengths are in sizes of the robot.
constexpr double kShrink = 5e-7;                      // of a star
constexpr double kSimpler[] = {1.0 / 128, 1.0 / 32};  // what region() may lose, fine and coarse
constexpr double kAround = 1.0 / 8;                   // half the side of the square around an overlooked wall point
constexpr double kNear = 8;                           // wall points from nearer are kept on the finer lattice
constexpr double kExact = 1e-3, kFine = 1.0 / 128, kCoarse = 1.0 / 16;  // squares of which one wall point is kept
constexpr double kSpeck = 1.0 / 4;  // holes up to this in which no wall was seen are no obstacles
constexpr std::size_t kMostPending = 64;

double angle_of(const Point& p) {
  const double angle = math::atan2(p.y(), p.x());
  return angle < 0 ? angle + 2 * kPi : angle;
}

/// The key of the square of side * size that contains p. The three lattices have different keys, almost always.
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
  return contains(p) && std::none_of(withdrawn.begin(), withdrawn.end(), [&](const Withdrawn& w) {
           return w.box.contains(p) && oxturn::contains(w.region, p);
         });
}

/// Between the two rays around p, in the box.
void Outline::Star::withdraw(const Point& p, const Box& box) {
  const double first = std::floor(angle_of(p - eye) / step) * step, far = 2 * std::sqrt(reach2);
  const Point u(math::cos(first), math::sin(first)), v(math::cos(first + step), math::sin(first + step));
  const Region wedge{{Polygon{{eye, eye + far * u, eye + far * v}, {}}}};
  withdrawn.push_back({box, intersect(wedge, box_region(box.low, box.high))});
}

/// A part of the star that contains all that the star has in the box.
Region Outline::Star::sector(const Box& box) const {
  const auto whole = [this] { return Region{{Polygon{ring, {}}}}; };
  if (box.contains(eye)) return whole();
  const Point middle = box.centre() - eye;
  const double half = math::atan2(box.size().norm() / 2, middle.norm()), at = angle_of(middle);
  if (at - half < 0 || at + half > 2 * kPi) return whole();
  const auto first = std::lower_bound(angle.begin(), angle.end(), at - half) - angle.begin();
  const auto last = std::upper_bound(angle.begin(), angle.end(), at + half) - angle.begin();
  if (first == 0 || last == static_cast<std::ptrdiff_t>(angle.size())) return whole();
  Ring part{eye};
  part.insert(part.end(), ring.begin() + first - 1, ring.begin() + last + 1);
  return {{Polygon{std::move(part), {}}}};
}

/// `part` of the star, without what was withdrawn in the box: at least what the star says is free there.
Region Outline::Star::free_of(Region part, const Box& box) const {
  std::vector<Region> cut;
  for (const Withdrawn& w : withdrawn)
    if (w.box.overlaps(box)) cut.push_back(w.region);
  return cut.empty() ? part : subtract(part, unite(cut));
}

bool Outline::Star::may_reach(const Box& box) const {
  const double away = std::max(0.0, distance(eye, box.centre()) - box.size().norm() / 2);
  return away * away < reach2;
}

Box Outline::box_around(const Point& p) const {
  Box box{p, p};
  box.grow(kAround * size_);
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
    if (star.says_free(p)) star.withdraw(p, box_around(p));
  Box everywhere{{-1e300, -1e300}, {1e300, 1e300}};
  Region region = star.free_of({{Polygon{star.ring, {}}}}, everywhere);
  stars_.push_back(std::move(star));
  pending_.push_back(std::move(region));
  simple_ = {};
  if (pending_.size() >= kMostPending) merge();
}

/// False if a wall point of this square is known.
bool Outline::is_new(const Point& wall, double side) { return seen_.insert(square_of(wall, side, size_)).second; }

/// Withdraws what stars say about p. The box where that changes what is free; nullopt: nowhere.
std::optional<Box> Outline::add_wall(const Point& p) {
  walls_.push_back(p);
  if (!is_free(p)) return std::nullopt;
  bool refuted = false;
  for (Star& star : stars_)
    if (star.says_free(p)) {
      star.withdraw(p, box_around(p));
      refuted = true;
    }
  return refuted ? std::optional(box_around(p)) : std::nullopt;
}

bool Outline::add_walls(const std::vector<Point>& hits, const std::vector<Point>& corners, const Point& eye) {
  std::vector<Box> boxes;
  const auto add = [&](const Point& p, double side) {
    if (!is_new(p, side)) return;
    if (const auto box = add_wall(p)) boxes.push_back(*box);
  };
  for (const Point& p : hits) add(p, distance(p, eye) < kNear * size_ ? kFine : kCoarse);
  for (const Point& p : corners) add(p, kExact);
  if (boxes.empty()) return false;
  merge();
  unite_again(boxes);
  return true;
}

/// In the boxes, which stars have changed; the rest stays.
void Outline::unite_again(const std::vector<Box>& boxes) {
  std::vector<Region> squares, parts;
  for (const Box& box : boxes) {
    squares.push_back(box_region(box.low, box.high));
    std::vector<Region> sectors;
    for (const Star& star : stars_)
      if (star.may_reach(box)) sectors.push_back(star.free_of(star.sector(box), box));
    parts.push_back(intersect(unite(sectors), squares.back()));
  }
  parts.push_back(subtract(free_, unite(squares)));
  free_ = unite(parts);
  edges_.emplace(free_);
  simple_ = {};
}

const Region& Outline::region(bool coarse) const {
  merge();
  auto& known = simple_[coarse ? 1 : 0];
  if (!known) known = without_specks(simplify_inward(free_, kSimpler[coarse ? 1 : 0] * size_));
  return *known;
}

Region Outline::without_specks(Region region) const {
  const double most = kSpeck * size_;
  const auto is_speck = [&](const Ring& hole) {
    Box box = bounding_box(hole);
    if (box.size().maxCoeff() > most) return false;
    box.grow(most);
    return std::none_of(walls_.begin(), walls_.end(), [&](const Point& wall) { return box.contains(wall); });
  };
  for (Polygon& polygon : region.polygons) std::erase_if(polygon.holes, is_speck);
  return region;
}

bool Outline::free_for(const Point& a, const Point& b, double radius) const {
  const auto inside = [&] { return edges_ && edges_->contains(a) && !edges_->nearest(a, b, radius); };
  if (inside()) return true;
  if (pending_.empty()) return false;
  merge();
  return inside();
}

}  // namespace oxturn
