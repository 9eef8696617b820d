#include "geometry/tether/geodesic_field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/tether/geodesic_cones.hpp"
#include "geometry/tether/geodesic_curves.hpp"

namespace oxturn {

struct GeodesicField::Impl {
  Point anchor;
  GeodesicCones cones;

  /// The root of the shortest way to p, and p's place in the mesh; -1 if there is none. Of equal ways that with fewest
  /// corners.
  std::int32_t last_root(Point& p) const {
    thread_local std::vector<std::int32_t> found;
    if (!finite(p) || !cones.place(p, found)) return -1;
    double least = std::numeric_limits<double>::infinity();
    const auto each = [&](auto f) {
      for (const std::int32_t t : found) {
        for (const Cone& c : cones.cones(t)) {
          if (cones.holds(c, p)) f(c.root, cones.distance_by(c, p));
        }
      }
    };
    each([&](std::int32_t, double d) { least = std::min(least, d); });
    std::int32_t best = -1;
    each([&](std::int32_t root, double d) {
      if (d > least * (1 + 1e-12)) return;
      const auto rank = [&](std::int32_t r) { return std::pair(cones.root(r).corners, r); };
      if (best < 0 || rank(root) < rank(best)) best = root;
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
const Mesh& GeodesicField::mesh() const { return impl_->cones.mesh(); }

double GeodesicField::distance(const Point& p) const {
  Point place = p;
  const std::int32_t root = impl_->last_root(place);
  if (root < 0) return std::numeric_limits<double>::infinity();
  const GeodesicCones::Root& r = impl_->cones.root(root);
  return r.before + (place - r.at).norm();
}

Polyline GeodesicField::path(const Point& p) const {
  Point place = p;
  std::int32_t root = impl_->last_root(place);
  if (root < 0) return {};
  Polyline line{p};
  for (; root > 0; root = impl_->cones.root(root).parent) {
    if (impl_->cones.root(root).at != line.back()) line.push_back(impl_->cones.root(root).at);
  }
  if (line.size() > 1 && line.back() == impl_->anchor) line.pop_back();
  line.push_back(impl_->anchor);
  std::reverse(line.begin(), line.end());
  return line;
}

GeodesicField::Sight GeodesicField::sight(const Point& p) const {
  Point place = p;
  const std::int32_t root = impl_->last_root(place);
  if (root < 0) return {};
  const GeodesicCones::Root& r = impl_->cones.root(root);
  return {root == 0 ? impl_->anchor : r.at, r.before, static_cast<std::size_t>(r.corners)};
}

double GeodesicField::farthest() const { return farthest_of(impl_->cones); }
std::vector<std::vector<GeodesicField::Arc>> GeodesicField::level_set(double l) const { return level_of(impl_->cones, l); }
std::vector<Polyline> GeodesicField::cut_locus(double chord) const { return cut_of(impl_->cones, chord); }

Polyline sampled(const std::vector<GeodesicField::Arc>& chain, double chord) {
  if (!(chord > 0)) throw std::invalid_argument("chord error of an arc must be above 0 metres");
  Polyline out;
  for (const GeodesicField::Arc& arc : chain) {
    // A chord over the angle 2 h is off by r (1 - cos h) = 2 r sin^2(h / 2).
    const double half = 2 * std::asin(std::min(1.0, std::sqrt(chord / (2 * arc.radius))));
    const int steps = std::max(1, static_cast<int>(std::ceil((arc.end - arc.begin) / (2 * half) - 1e-9)));
    for (int i = out.empty() ? 0 : 1; i <= steps; ++i)
      out.push_back(arc.at(arc.begin + (arc.end - arc.begin) * i / steps));
  }
  return out;
}

}  // namespace oxturn
