#include "geometry/tether/geodesic_field.hpp"

#include <algorithm>
#include <cmath>

#include "base/throw_invalid.hpp"
#include "geometry/tether/geodesic_cones.hpp"
#include "geometry/tether/geodesic_curves.hpp"

namespace oxturn {

struct GeodesicField::Impl {
  Point anchor;
  GeodesicCones cones;

  /// The root of the shortest path to p, which is moved into the mesh; of equal paths the one with fewest corners.
  /// kNone if there is none.
  std::int32_t last_root(Point& p) const {
    constexpr double kEqual = 1e-12;  // relative
    thread_local std::vector<std::int32_t> found;
    if (!finite(p) || !cones.move_inside(p, found)) return GeodesicCones::kNone;
    const auto for_each_path = [&](auto f) {
      for (const std::int32_t t : found)
        for (const Cone& c : cones.cones(t))
          if (cones.contains(c, p)) f(c.root, cones.distance_by(c, p));
    };
    double least = std::numeric_limits<double>::infinity();
    for_each_path([&](std::int32_t, double d) { least = std::min(least, d); });
    std::int32_t best = GeodesicCones::kNone;
    for_each_path([&](std::int32_t root, double d) {
      if (d > least * (1 + kEqual)) return;
      const auto rank = [&](std::int32_t r) { return std::pair(cones.root(r).corners, r); };
      if (best == GeodesicCones::kNone || rank(root) < rank(best)) best = root;
    });
    return best;
  }
};

GeodesicField::GeodesicField(const Region& free, const Point& anchor, const std::vector<Polyline>& barriers,
                             double tolerance)
    : impl_(new Impl{anchor, GeodesicCones(free, anchor, barriers, tolerance)}) {}
GeodesicField::~GeodesicField() = default;
GeodesicField::GeodesicField(GeodesicField&&) noexcept = default;

const Point& GeodesicField::anchor() const { return impl_->anchor; }

double GeodesicField::distance(const Point& p) const {
  Point inside = p;
  const std::int32_t root = impl_->last_root(inside);
  if (root == GeodesicCones::kNone) return std::numeric_limits<double>::infinity();
  const GeodesicCones::Root& r = impl_->cones.root(root);
  return r.before + (inside - r.at).norm();
}

Polyline GeodesicField::path(const Point& p) const {
  Point inside = p;
  std::int32_t root = impl_->last_root(inside);
  if (root == GeodesicCones::kNone) return {};
  Polyline line{p};
  for (; root > 0; root = impl_->cones.root(root).parent)
    if (impl_->cones.root(root).at != line.back()) line.push_back(impl_->cones.root(root).at);
  if (line.size() > 1 && line.back() == impl_->anchor) line.pop_back();
  line.push_back(impl_->anchor);
  std::reverse(line.begin(), line.end());
  return line;
}

GeodesicField::Sight GeodesicField::sight(const Point& p) const {
  Point inside = p;
  const std::int32_t root = impl_->last_root(inside);
  if (root == GeodesicCones::kNone) return {};
  const GeodesicCones::Root& r = impl_->cones.root(root);
  return {root == 0 ? impl_->anchor : r.at, r.before, static_cast<std::size_t>(r.corners)};
}

double GeodesicField::farthest() const { return farthest_of(impl_->cones); }
std::vector<std::vector<GeodesicField::Arc>> GeodesicField::level_set(double length) const {
  return level_set_of(impl_->cones, length);
}
std::vector<Polyline> GeodesicField::cut_locus(double chord_error) const {
  return cut_locus_of(impl_->cones, chord_error);
}

Polyline sampled(const std::vector<GeodesicField::Arc>& chain, double chord_error) {
  if (!(chord_error > 0)) throw_invalid("chord error of an arc must be above 0 metres");
  Polyline out;
  for (const GeodesicField::Arc& arc : chain) {
    // The error of a chord over the angle 2 h is r (1 - cos h) = 2 r sin^2(h / 2).
    const double half = 2 * std::asin(std::min(1.0, std::sqrt(chord_error / (2 * arc.radius))));
    const int steps = std::max(1, static_cast<int>(std::ceil((arc.end - arc.begin) / (2 * half) - 1e-9)));
    for (int i = out.empty() ? 0 : 1; i <= steps; ++i)
      out.push_back(arc.at(arc.begin + (arc.end - arc.begin) * i / steps));
  }
  return out;
}

}  // namespace oxturn
