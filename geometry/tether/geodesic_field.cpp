#include "geometry/tether/geodesic_field.hpp"

#include <algorithm>
#include <cmath>

#include "base/throw_invalid.hpp"
#include "geometry/tether/geodesic_cones.hpp"

namespace oxturn {

GeodesicField::GeodesicField(const Region& free, const Point& anchor, const std::vector<Polyline>& barriers,
                             double tolerance)
    : anchor_(anchor), cones_(std::make_shared<const GeodesicCones>(free, anchor, barriers, tolerance)) {}

double GeodesicField::distance(const Point& p) const {
  Point inside = p;
  const std::int32_t root = cones_->last_root(inside);
  if (root == GeodesicCones::kNone) return std::numeric_limits<double>::infinity();
  const GeodesicCones::Root& r = cones_->root(root);
  return r.before + (inside - r.at).norm();
}

Polyline GeodesicField::path(const Point& p) const {
  Point inside = p;
  std::int32_t root = cones_->last_root(inside);
  if (root == GeodesicCones::kNone) return {};
  Polyline line{p};
  for (; root > 0; root = cones_->root(root).parent)
    if (cones_->root(root).at != line.back()) line.push_back(cones_->root(root).at);
  if (line.size() > 1 && line.back() == anchor_) line.pop_back();
  line.push_back(anchor_);
  std::reverse(line.begin(), line.end());
  return line;
}

GeodesicField::Sight GeodesicField::sight(const Point& p) const {
  Point inside = p;
  const std::int32_t root = cones_->last_root(inside);
  if (root == GeodesicCones::kNone) return {};
  const GeodesicCones::Root& r = cones_->root(root);
  return {root == 0 ? anchor_ : r.at, r.before, static_cast<std::size_t>(r.corners)};
}

double GeodesicField::farthest() const { return farthest_of(*cones_); }
std::vector<std::vector<GeodesicField::Arc>> GeodesicField::level_set(double length) const {
  return level_set_of(*cones_, length);
}
std::vector<Polyline> GeodesicField::cut_locus(double chord_error) const { return cut_locus_of(*cones_, chord_error); }

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
