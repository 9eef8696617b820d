#include "geometry/tether/geodesic_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/math.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/tether/geodesic_cones.hpp"

namespace oxturn {

namespace {

/// The triangles at a point, in groups that are connected with each other.
std::vector<std::vector<std::int32_t>> sides_of(const Mesh& mesh, std::vector<std::int32_t> home) {
  std::vector<std::vector<std::int32_t>> sides;
  while (!home.empty()) {
    std::vector<std::int32_t>& side = sides.emplace_back(1, home.front());
    home.erase(home.begin());
    for (std::size_t i = 0; i < side.size(); ++i)
      for (const std::int32_t n : mesh.triangle(side[i]).neighbour)
        if (const auto found = std::find(home.begin(), home.end(), n); n != Mesh::kWall && found != home.end()) {
          side.push_back(n);
          home.erase(found);
        }
    std::sort(side.begin(), side.end());
  }
  return sides;
}

/// How paths may begin: along `stem`, then into the triangles of one side of its last point.
struct Departure {
  Polyline stem;
  std::vector<std::int32_t> side;
};

/// Along the barriers through `anchor`, a point of the mesh, their last point excluded: a barrier may run along a wall
/// for a while, and only where it leaves that are its two sides different.
std::vector<Departure> departures(const Mesh& mesh, const Point& anchor, const std::vector<Polyline>& barriers) {
  std::vector<Polyline> stems{{anchor}};
  for (const Polyline& line : barriers)
    if (const auto here = std::find(line.begin(), line.end(), anchor); here != line.end())
      for (auto next = here + 1; next < line.end() - 1; ++next) stems.emplace_back(here, next + 1);
  std::vector<Departure> all;
  std::vector<std::int32_t> home;
  for (const Polyline& stem : stems) {
    Point end = stem.back();
    mesh.move_inside(end, 0, home);
    for (std::vector<std::int32_t>& side : sides_of(mesh, home)) all.push_back({stem, std::move(side)});
  }
  return all;
}

/// The point of a barrier nearest to the anchor, if that is within the tolerance: a barrier through the anchor divides
/// free space exactly there.
std::optional<Point> barrier_point_at(const Point& anchor, const std::vector<Polyline>& barriers, double tolerance) {
  std::optional<Point> best;
  double least = tolerance;
  for (const Polyline& line : barriers)
    for (const Point& p : line)
      if (const double d = distance(p, anchor); d < least || (d == least && !best)) {
        least = d;
        best = p;
      }
  return best;
}

std::shared_ptr<const GeodesicCones> cones_from(Mesh mesh, const Point& anchor, const std::vector<Polyline>& barriers,
                                                double tolerance, const std::optional<Point>& start) {
  constexpr double kTie = 1e-9;  // relative: of equal departures the first, which has the shortest stem
  const std::optional<Point> at_barrier = barrier_point_at(anchor, barriers, tolerance);
  Point inside = at_barrier.value_or(anchor);
  std::vector<std::int32_t> home;
  if (!finite(anchor) || !mesh.move_inside(inside, tolerance, home))
    throw_invalid("anchor ({}, {}) is outside free space; move it inside", anchor.x(), anchor.y());
  if (!start) return std::make_shared<const GeodesicCones>(std::move(mesh), Polyline{inside}, home, tolerance);
  std::vector<Departure> all;
  if (at_barrier)
    all = departures(mesh, inside, barriers);
  else
    for (std::vector<std::int32_t>& side : sides_of(mesh, home)) all.push_back({{inside}, std::move(side)});
  std::shared_ptr<const GeodesicCones> best;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [stem, side] : all) {
    auto cones = std::make_shared<const GeodesicCones>(mesh, stem, side, tolerance);
    const double length = all.size() == 1 ? 0 : cones->distance(*start);
    if (best && !(length < least * (1 - kTie))) continue;
    least = length;
    best = std::move(cones);
  }
  return best;
}

}  // namespace

GeodesicField::GeodesicField(const Region& free, const Point& anchor, const std::vector<Polyline>& barriers,
                             double tolerance, const std::optional<Point>& start)
    : anchor_(anchor) {
  if (!(tolerance >= 0)) throw_invalid("tolerance of a geodesic field must be 0 or more metres");
  cones_ = cones_from(Mesh(free, barriers), anchor, barriers, tolerance, start);
}

double GeodesicField::distance(const Point& p) const { return cones_->distance(p); }

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
std::vector<std::vector<std::vector<GeodesicField::Arc>>> GeodesicField::level_sets(
    const std::vector<double>& lengths) const {
  return level_sets_of(*cones_, lengths);
}
std::vector<Polyline> GeodesicField::cut_locus(double chord_error, double beyond) const {
  return cut_locus_of(*cones_, chord_error, beyond);
}
void GeodesicField::find_cut_locus() const { cones_->cut_pieces(); }

Polyline sampled(const std::vector<GeodesicField::Arc>& chain, double chord_error) {
  if (!(chord_error > 0)) throw_invalid("chord error of an arc must be above 0 metres");
  Polyline out;
  for (const GeodesicField::Arc& arc : chain) {
    // The error of a chord over the angle 2 h is r (1 - cos h) = 2 r sin^2(h / 2).
    const double half = 2 * math::asin(std::min(1.0, std::sqrt(chord_error / (2 * arc.radius))));
    const int steps = std::max(1, static_cast<int>(std::ceil((arc.end - arc.begin) / (2 * half) - 1e-9)));
    for (int i = out.empty() ? 0 : 1; i <= steps; ++i)
      out.push_back(arc.at(arc.begin + (arc.end - arc.begin) * i / steps));
  }
  return out;
}

}  // namespace oxturn
