#include "geometry/tether/geodesic_cones.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oxturn {

GeodesicCones::GeodesicCones(Mesh mesh, const Polyline& stem, const std::vector<std::int32_t>& home, double tolerance)
    : mesh_(std::move(mesh)), tolerance_(tolerance) {
  constexpr double kTie = 1e-12;  // relative, as in the search
  const Box box = bounding_box(mesh_.points());
  if (!box.empty()) rounding_ = 1e-13 * box.size().norm() + 1e-15 * std::max(box.low.norm(), box.high.norm());
  roots_.push_back({stem.front(), 0, kNone, 0});
  for (std::size_t i = 1; i < stem.size(); ++i) {
    const auto parent = static_cast<std::int32_t>(i - 1);
    roots_.push_back({stem[i], roots_.back().before + oxturn::distance(stem[i - 1], stem[i]), parent, parent + 1});
  }
  search(home);
  double longest = 0;
  for (const double l : label_)
    if (std::isfinite(l)) longest = std::max(longest, l);
  tie_ = 4 * kTie * longest + 4 * rounding_;
  prune();
}

/// Keeps the cones that may be shortest somewhere in their triangle.
void GeodesicCones::prune() {
  std::vector<Cone> kept;
  std::vector<std::size_t> first(1, 0);
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    const auto triangle = static_cast<std::int32_t>(t);
    const std::vector<Cone> here = needed(facet(triangle), cones(triangle));
    kept.insert(kept.end(), here.begin(), here.end());
    first.push_back(kept.size());
  }
  cones_.swap(kept);
  first_.swap(first);
}

double GeodesicCones::to_vertex(std::int32_t triangle, std::size_t k) const {
  return label_[static_cast<std::size_t>(fan_[3 * static_cast<std::size_t>(triangle) + k])];
}

bool GeodesicCones::meets(const Cone& cone, const Facet& facet) const {
  if (cone.whole) return true;
  const Point& r = root(cone.root).at;
  const auto all_beyond = [&](const Point& ray, int side) {
    return std::ranges::all_of(facet.vertices(), [&](const Point& p) { return side * cross(ray, p - r) > rounding_; });
  };
  return !all_beyond(cone.left, 1) && !all_beyond(cone.right, -1);
}

/// Is another cone shorter everywhere in the part that this one sees?
bool GeodesicCones::beaten(const Cone& cone, const Facet& part, std::span<const Cone> others) const {
  Facet share = part;
  clip(share, cone);
  if (share.empty()) return false;
  const Point middle = share.middle();
  const double mine = distance_by(cone, middle);
  const Cone* best = &cone;
  double least = mine;
  for (const Cone& c : others)
    if (const double d = distance_by(c, middle); d < least && contains(c, middle)) {
      least = d;
      best = &c;
    }
  if (mine - least <= tie_) return false;
  double radius = 0;
  for (const Point& p : share.vertices()) radius = std::max(radius, oxturn::distance(p, middle));
  if (mine - least > 2 * radius + tie_) return true;  // distances change at most as much as points move
  const auto vertices = share.vertices();
  if (!std::ranges::all_of(vertices, [&](const Point& p) { return contains(*best, p); })) return false;
  // Where the path by the later root is the shorter one is a convex set.
  if (root(best->root).before >= root(cone.root).before)
    return std::ranges::all_of(vertices,
                               [&](const Point& p) { return distance_by(cone, p) - distance_by(*best, p) > tie_; });
  // Both distances are convex functions. This one is above its tangent plane at the middle; the other rises above its
  // own by no more than its curvature allows.
  const Point to_mine = middle - root(cone.root).at, to_best = middle - root(best->root).at;
  const double far = to_best.norm() - radius;
  if (!(far > 0)) return false;
  const double tilt = (to_mine.normalized() - to_best.normalized()).norm();
  return mine - least - radius * tilt - radius * radius / (2 * far) > tie_;
}

std::vector<Cone> GeodesicCones::needed(const Facet& part, std::span<const Cone> from) const {
  std::vector<Cone> near, out;
  std::copy_if(from.begin(), from.end(), std::back_inserter(near), [&](const Cone& c) { return meets(c, part); });
  std::copy_if(near.begin(), near.end(), std::back_inserter(out),
               [&](const Cone& c) { return !beaten(c, part, near); });
  return out;
}

double GeodesicCones::distance(Point p) const {
  const std::int32_t last = last_root(p);
  return last == kNone ? std::numeric_limits<double>::infinity() : root(last).before + (p - root(last).at).norm();
}

std::int32_t GeodesicCones::last_root(Point& p) const {
  constexpr double kEqual = 1e-12;  // relative
  struct Found {
    std::vector<std::int32_t> triangles;  // of the point before, mostly near by
    std::vector<std::pair<double, std::int32_t>> paths;
  };
  thread_local const auto of_thread = std::make_unique<Found>();  // each use of a thread_local object itself is a call
  auto& [triangles, paths] = *of_thread;
  if (!finite(p) || !mesh_.move_inside(p, tolerance_, triangles)) return kNone;
  paths.clear();
  double least = std::numeric_limits<double>::infinity();
  for (const std::int32_t t : triangles)
    for (const Cone& c : cones(t)) {
      if (!contains(c, p)) continue;
      paths.emplace_back(distance_by(c, p), c.root);
      least = std::min(least, paths.back().first);
    }
  std::int32_t best = kNone;
  for (const auto& [d, i] : paths) {
    if (d > least * (1 + kEqual)) continue;
    const auto rank = [&](std::int32_t r) { return std::pair(root(r).corners, r); };
    if (best == kNone || rank(i) < rank(best)) best = i;
  }
  return best;
}

bool GeodesicCones::same_path(std::int32_t a, std::int32_t b, const Point& p) const {
  const auto length_by = [&](std::int32_t i) { return root(i).before + oxturn::distance(root(i).at, p); };
  const double to_a = length_by(a), to_b = length_by(b);
  // Up both paths, from the later root each time, as long as the path from there straight to p is no shorter.
  while (a != b) {
    const bool up_a = a > b;
    std::int32_t& later = up_a ? a : b;
    later = root(later).parent;
    if (later == kNone || (up_a ? to_a : to_b) - length_by(later) > tie_) return false;
  }
  return true;
}

}  // namespace oxturn
