// Map + robot + start -> configuration space and target.
//
// Complexity  n corners: repair, erosion and dilation O(n log n) each; target, its excess, shortest paths and walls
//             are made at the first question, once, whichever thread asks.
// Decisions   1. Configuration space errs inside by at most tool_width / 1000 (erode, Bound::inside): what it calls
//                free is free. `target` is what can be covered from that space, not from the ideal one.
//             2. A tool no wider than the robot never leaves free space, so nothing is intersected then.
//             3. A tether's classes are those of robot paths: gaps that the robot cannot pass are closed by barriers. A gap
//                counts as open if configuration space reaches through it, whatever its width says.
//             4. {distance <= tether length} is cut out along its border by a strip w / 10^4 wide, inside of it; the area
//                lost counts in target_excess. What the leash reaches only past places that it does not reach is no
//                part of configuration space.
//             5. A tethered robot whose anchor is given and whose start is not starts as near to the anchor as it fits.
//             6. A polygonal footprint keeps its orientation, so configuration space is a plane region: free space less the
//                Minkowski sum of walls and reflected footprint (minkowski.hpp). Its `radius` becomes that of the largest
//                disc inside, so that what planners conclude from the radius (a tool that cannot reach over walls) holds.
//             7. The place offered to a start in a wall has as few decimals as still lie inside, to be typed again.
#include "maps/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <stdexcept>

#include "geometry/overlay/boolean.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/overlay/minkowski.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/predicates.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/overlay/validity.hpp"
#include "maps/formats.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"

namespace oxturn {
namespace {

std::string text(const Point& p) { return fmt::format("({}, {})", to_decimal(p.x()), to_decimal(p.y())); }

double largest_coordinate(const Region& region) {
  const Box box = bounding_box(region);
  return box.empty() ? 0 : std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
}

double tolerance_of(const Region& free, const Robot& robot) {
  return 1e-6 * robot.tool_width + 1e-12 * largest_coordinate(free);
}

Region repaired_or_named(const Map& map) {
  if (map.free.empty()) throw std::invalid_argument(fmt::format("map '{}' has no free space at all", map.name));
  Region free;
  try {
    free = repaired(map.free);
  } catch (const std::invalid_argument& flaw) {
    throw std::invalid_argument(fmt::format("map '{}': {}", map.name, flaw.what()));
  }
  if (free.empty()) throw std::invalid_argument(fmt::format("map '{}' has no free space at all", map.name));
  return free;
}

std::string size_of(const Robot& robot) {
  if (robot.footprint.empty()) return "radius " + to_decimal(robot.radius);
  return fmt::format("footprint of {} corners", robot.footprint.size());
}

/// Everywhere the robot fits, in all connected parts.
Region eroded(const Map& map, const Region& free, const Robot& robot) {
  Region all = !robot.footprint.empty() ? erode(free, robot.footprint, Bound::inside)
               : robot.radius > 0       ? erode(free, robot.radius, robot.tool_width / 1000, Bound::inside)
                                        : free;
  if (all.empty())
    throw std::invalid_argument(
        fmt::format("robot '{}' ({}) fits nowhere in map '{}'; its widest passage is too narrow", robot.name,
                    size_of(robot), map.name));
  return all;
}

/// The largest part of configuration space and the centroid of its largest triangle; the first of equals.
struct Middle {
  Point place;
  const Polygon* part;
  Mesh mesh;
};

Middle middle(const Region& all) {
  const Polygon* largest = nullptr;
  double most = -1;
  for (const Polygon& polygon : all.polygons)
    if (const double a = area(polygon); a > most) {
      most = a;
      largest = &polygon;
    }
  Mesh mesh(Region{{*largest}});
  const auto corner = [&](const Mesh::Triangle& t, std::size_t k) -> const Point& {
    return mesh.points()[static_cast<std::size_t>(t.corner[k])];
  };
  const Mesh::Triangle* best = nullptr;
  double widest = -1;
  for (const Mesh::Triangle& t : mesh.triangles())
    if (const double a = cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)); a > widest) {
      widest = a;
      best = &t;
    }
  // thinner than any triangle: its boundary is all there is
  const Point place =
      best == nullptr ? largest->outer.front() : Point((corner(*best, 0) + corner(*best, 1) + corner(*best, 2)) / 3);
  return {place, largest, std::move(mesh)};
}

/// How far p is from a closed polygon. By a scan: one question does not pay for an EdgeIndex.
double distance_to(const Polygon& polygon, const Point& p) {
  const Region region{{polygon}};
  double least = std::numeric_limits<double>::infinity();
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
      least = on_segment(p, ring[j], ring[i]) ? 0 : std::min(least, distance_to_segment(p, ring[j], ring[i]));
  });
  return contains(region, p) ? 0 : least;
}

/// The polygon that holds p, or the nearest of those within the tolerance; nullptr if there is none.
const Polygon* part_with(const Region& all, const Point& p, double tolerance) {
  const Polygon* nearest = nullptr;
  double least = tolerance;
  for (const Polygon& polygon : all.polygons) {
    Box box;
    for (const Point& q : polygon.outer) box.add(q);
    box.grow(tolerance);
    if (!box.contains(p)) continue;
    const double away = distance_to(polygon, p);
    if (away == 0) return &polygon;
    if (away <= least) {
      least = away;
      nearest = &polygon;
    }
  }
  return nearest;
}

bool holds(const Region& region, const Point& p, double tolerance) {
  return part_with(region, p, tolerance) != nullptr;
}

/// A place of `all` next to the one nearest to p, with as few decimals as keep it inside.
Point nearest_point_inside(const Region& all, const Point& p, double tool_width) {
  const EdgeIndex edges(all);
  const auto hit = edges.nearest(p);
  const Point place = hit ? hit->place : all.polygons.front().outer.front();
  for (const double unit : {1e2, 1e3, 1e4, 1e5, 1e6}) {
    std::optional<Point> best;
    for (const int i : {0, -1, 1})
      for (const int j : {0, -1, 1}) {
        const Point q((std::round(place.x() * unit) + i) / unit, (std::round(place.y() * unit) + j) / unit);
        if (distance(q, place) > tool_width / 5 || !edges.contains(q)) continue;
        if (!best || distance(q, p) < distance(*best, p)) best = q;
      }
    if (best) return *best;
  }
  return place;
}

/// Sum of the angles by which the boundary turns left: each such radian becomes an arc when dilated.
double convex_turning(const Region& region) {
  double sum = 0;
  for_each_ring(region, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
      if (orientation(a, b, c) > 0) sum += std::atan2(std::abs(cross(b - a, c - b)), (b - a).dot(c - b));
    }
  });
  return sum;
}

/// Across every gap that the robot cannot pass; see Decision 3.
std::vector<Polyline> gaps_to_close(const Region& free, const Robot& robot, const Region& space) {
  if (robot.radius <= 0) return {};
  std::vector<Polyline> gaps = barriers(free, 2 * robot.radius + robot.tool_width / 250);
  const EdgeIndex walls(space);
  std::erase_if(gaps, [&](const Polyline& gap) { return walls.contains(lerp(gap.front(), gap.back(), 0.5)); });
  return gaps;
}

/// The largest distance within `space`: it is taken at a corner, or where two ways round an obstacle meet.
double farthest_in(const Region& space, const GeodesicField& field, double chord) {
  double most = 0;
  const auto add = [&](const Point& p) {
    if (const double d = field.distance(p); std::isfinite(d)) most = std::max(most, d);
  };
  for_each_ring(space, [&](const Ring& ring) { std::for_each(ring.begin(), ring.end(), add); });
  const EdgeIndex walls(space);
  for (const Polyline& curve : field.cut(chord))
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const double n = std::max(1.0, std::ceil(distance(curve[i - 1], curve[i]) / (5 * chord)));
      for (double k = 0; k <= n; ++k)
        if (const Point p = lerp(curve[i - 1], curve[i], k / n); walls.contains(p)) add(p);
    }
  return most;
}

/// The part of `space` that holds the start and that the tether reaches. `lost` grows by the area that may be missing.
Region within_tether(const Region& space, const GeodesicField& field, const Problem& problem, double& lost) {
  const double limit = problem.robot().tether->length, w = problem.robot().tool_width;
  const Point extent = bounding_box(space).size();
  const double strip = std::max(w / 10000, std::ldexp(extent.maxCoeff(), -24));
  std::vector<Polyline> border;
  for (const std::vector<GeodesicField::Arc>& chain : field.level(limit)) {
    Polyline line = sampled(chain, strip);
    if (line.size() < 2) continue;
    lost += 2 * strip * length(line);
    // Where the robot has no size, free space ends where the chain does: the strip must not leave a hair open.
    const Point first = line[0] - line[1], last = line[line.size() - 1] - line[line.size() - 2];
    if (line.front() != line.back()) {
      line.insert(line.begin(), line.front() + first.normalized() * 4 * strip);
      line.push_back(line.back() + last.normalized() * 4 * strip);
    }
    border.push_back(std::move(line));
  }
  if (border.empty()) return space;
  const Region parts = slit(space, border, strip);
  const Polygon* part = part_with(parts, problem.start(), 2 * strip);
  if (part == nullptr)
    throw std::invalid_argument(
        fmt::format("tether of robot '{}' ({} m) only just reaches the start {}; a longer one is needed to move",
                    problem.robot().name, to_decimal(limit), text(problem.start())));
  return Region{{*part}};
}

}  // namespace

/// What a problem and its restrictions share.
struct ProblemBasis {
  Map map;
  Robot robot;
  Point start{0, 0}, anchor{0, 0};
  double tolerance = 0;
  std::shared_ptr<const Region> space;
  // Tethered robots only.
  std::shared_ptr<const Region> robot_space;
  std::vector<Polyline> closed_gaps;
  std::unique_ptr<const GeodesicField> geodesics;
  double lost = 0;  // m^2 that `space` may be smaller than what the leash reaches

  mutable std::once_flag taut_once;
  mutable std::unique_ptr<const TautSpace> taut;

  mutable std::once_flag target_once, excess_once;
  mutable Region target_region;
  mutable double excess = 0;

  /// Between the arcs of an inside and an outside bound lies about (sum of angles) * reach * chord error: it is
  /// chosen for half of 1e-4 of the space's area, within limits that keep both bounds cheap.
  double target_chord() const {
    const double w = robot.tool_width, angles = convex_turning(*space);
    const double wanted = angles > 0 ? 0.5e-4 * area(*space) / (angles * w / 2) : w;
    return std::clamp(wanted, w / 20000, w / 1000);
  }

  const Region& target() const {
    std::call_once(target_once, [this] {
      target_region = dilate(*space, robot.tool_width / 2, target_chord(), Bound::inside);
      if (robot.tool_width / 2 > robot.radius) target_region = intersect(target_region, map.free);
    });
    return target_region;
  }

  double target_excess() const {
    std::call_once(excess_once, [this] {
      const Region outer = intersect(dilate(*space, robot.tool_width / 2, target_chord(), Bound::outside), map.free);
      // Both operands of a boolean are snapped to 2^-30 of their extent: as much may be lost along the boundary.
      const Box box = bounding_box(map.free);
      const double snapping = perimeter(outer) * box.size().maxCoeff() * std::ldexp(1.0, -29);
      excess = std::max(0.0, area(outer) - area(target())) + snapping + lost;
    });
    return excess;
  }
};

struct Problem::Impl {
  std::shared_ptr<const ProblemBasis> basis;
  std::shared_ptr<const Region> space;
  Point start;
  mutable std::once_flag transit_once, walls_once;
  mutable std::optional<Mesh> mesh;  // of the space, if the search for a start made it; shortest paths take it
  mutable std::unique_ptr<const ShortestPaths> transit;
  mutable std::unique_ptr<const EdgeIndex> walls;

  Impl(std::shared_ptr<const ProblemBasis> b, std::shared_ptr<const Region> s, const Point& from)
      : basis(std::move(b)), space(std::move(s)), start(from) {}
};

Problem::Problem(Map map, Robot robot, std::optional<Point> start, std::optional<Point> anchor) {
  check(robot);
  if (!robot.footprint.empty()) robot.radius = in_radius(robot.footprint);
  const auto basis = std::make_shared<ProblemBasis>();
  map.free = repaired_or_named(map);
  if (start && !finite(*start))
    throw std::invalid_argument(fmt::format("start {} is not finite, expected metres", text(*start)));
  if (anchor && !finite(*anchor))
    throw std::invalid_argument(fmt::format("anchor {} is not finite, expected metres", text(*anchor)));

  const Region all = eroded(map, map.free, robot);
  const double tolerance = tolerance_of(map.free, robot);
  std::optional<Middle> found;
  if (!start && !(robot.tether && anchor)) found = middle(all);
  basis->start = start                    ? *start
                 : found                  ? found->place
                 : holds(all, *anchor, 0) ? *anchor
                                          : nearest_point_inside(all, *anchor, robot.tool_width);
  const Polygon* part = part_with(all, basis->start, tolerance);
  if (part == nullptr) {
    const std::string place = text(nearest_point_inside(all, basis->start, robot.tool_width));
    if (!holds(map.free, basis->start, tolerance))
      throw std::invalid_argument(fmt::format("start {} is inside a wall of '{}'; nearest place the robot fits: {}",
                                              text(basis->start), map.name, place));
    throw std::invalid_argument(
        fmt::format("start {} is too near a wall of '{}' for robot '{}' ({}); nearest place the robot fits: {}",
                    text(basis->start), map.name, robot.name, size_of(robot), place));
  }
  basis->anchor = anchor ? *anchor : basis->start;
  if (anchor && !holds(map.free, *anchor, tolerance))
    throw std::invalid_argument(
        fmt::format("anchor {} is inside a wall of '{}', expected a place in free space", text(*anchor), map.name));
  basis->space = std::make_shared<const Region>(Region{{*part}});
  basis->tolerance = tolerance;
  basis->map = std::move(map);
  basis->robot = std::move(robot);
  const bool meshed = found && found->part == part;
  impl_ = std::make_shared<const Impl>(basis, basis->space, basis->start);
  if (meshed) impl_->mesh = std::move(found->mesh);
  if (!basis->robot.tether) return;

  const Region& free = basis->map.free;
  basis->robot_space = basis->space;
  basis->closed_gaps = gaps_to_close(free, basis->robot, *basis->space);
  basis->geodesics = std::make_unique<const GeodesicField>(free, basis->anchor, basis->closed_gaps, tolerance);
  const GeodesicField& field = *basis->geodesics;
  const double away = field.distance(basis->start);
  if (!std::isfinite(away))
    throw std::invalid_argument(
        fmt::format("anchor {} is out of reach: no way wide enough for robot '{}' leads there from the start {}; "
                    "expected a place in the same part of '{}'",
                    text(basis->anchor), basis->robot.name, text(basis->start), basis->map.name));
  const double most = farthest_in(*basis->robot_space, field, basis->robot.tool_width / 100);
  Tether& tether = *basis->robot.tether;
  if (tether.reach > 0) tether = {tether.reach * most, 0, tether.sharp_angle};
  if (away > tether.length)
    throw std::invalid_argument(fmt::format(
        "tether of robot '{}' is {} m long, too short for the start {}, {} m from the anchor {}", basis->robot.name,
        to_decimal(tether.length), text(basis->start), fmt::format("{:.4g}", away), text(basis->anchor)));
  // Between two places looked at on the cut the distance may be a little larger.
  if (most + basis->robot.tool_width / 5 <= tether.length) return;
  basis->space = std::make_shared<const Region>(within_tether(*basis->robot_space, field, *this, basis->lost));
  impl_ = std::make_shared<const Impl>(basis, basis->space, basis->start);
}

Problem::Problem(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}
Problem::~Problem() = default;
Problem::Problem(Problem&&) noexcept = default;

const Map& Problem::map() const { return impl_->basis->map; }
const Robot& Problem::robot() const { return impl_->basis->robot; }
const Point& Problem::start() const { return impl_->start; }
const Point& Problem::anchor() const { return impl_->basis->anchor; }
const Region& Problem::configuration_space() const { return *impl_->space; }
bool Problem::limited() const {
  const ProblemBasis& basis = *impl_->basis;
  return impl_->space != basis.space || (basis.robot_space && basis.robot_space != basis.space);
}
const Region& Problem::target() const { return impl_->basis->target(); }
double Problem::target_excess() const { return impl_->basis->target_excess(); }
double Problem::tolerance() const { return impl_->basis->tolerance; }

namespace {
[[noreturn]] void no_tether(const Robot& robot) {
  throw std::logic_error(fmt::format("robot '{}' has no tether, but its tether was asked for", robot.name));
}
}  // namespace

const Region& Problem::space_of_robot() const {
  if (!robot().tether) no_tether(robot());
  return *impl_->basis->robot_space;
}

const std::vector<Polyline>& Problem::closed_gaps() const {
  if (!robot().tether) no_tether(robot());
  return impl_->basis->closed_gaps;
}
const GeodesicField& Problem::geodesics() const {
  if (!robot().tether) no_tether(robot());
  return *impl_->basis->geodesics;
}

const TautSpace& Problem::taut_space() const {
  if (!robot().tether) no_tether(robot());
  const ProblemBasis& basis = *impl_->basis;
  std::call_once(basis.taut_once, [&] { basis.taut = std::make_unique<const TautSpace>(basis.map.free); });
  return *basis.taut;
}

const ShortestPaths& Problem::transit() const {
  std::call_once(impl_->transit_once, [this] {
    Mesh mesh = impl_->mesh ? std::move(*impl_->mesh) : Mesh(*impl_->space);
    impl_->mesh.reset();
    impl_->transit = std::make_unique<const ShortestPaths>(std::move(mesh), tolerance());
  });
  return *impl_->transit;
}

const EdgeIndex& Problem::walls() const {
  std::call_once(impl_->walls_once, [this] { impl_->walls = std::make_unique<const EdgeIndex>(*impl_->space); });
  return *impl_->walls;
}

Problem Problem::restricted(Region configuration_space) const {
  return restricted(std::move(configuration_space), start());
}

Problem Problem::restricted(Region configuration_space, const Point& start) const {
  if (!holds(configuration_space, start, tolerance()))
    throw std::invalid_argument(
        fmt::format("restricted configuration space of '{}' does not hold the start {}", map().name, text(start)));
  return Problem(std::make_shared<const Impl>(impl_->basis,
                                              std::make_shared<const Region>(std::move(configuration_space)), start));
}

std::string Problem::content_hash() const {
  std::string bytes = canonical_bytes(map().free);
  const Robot& r = robot();
  for (const double value :
       {r.radius, r.tool_width, r.speed, r.acceleration, r.turn_rate, r.min_turn_radius, r.tether ? 1.0 : 0.0,
        r.tether ? r.tether->length : 0.0, r.lidar ? 1.0 : 0.0, r.lidar ? r.lidar->range : 0.0,
        r.lidar ? static_cast<double>(r.lidar->rays) : 0.0, start().x(), start().y(), anchor().x(), anchor().y()})
    append_canonical(bytes, value);
  if (r.tether) append_canonical(bytes, r.tether->sharp_angle);
  if (r.lidar && r.lidar->noise != 0) append_canonical(bytes, r.lidar->noise);
  for (const Point& p : r.footprint) {
    append_canonical(bytes, p.x());
    append_canonical(bytes, p.y());
  }
  return sha256(bytes);
}

Point default_start(const Map& map, const Robot& robot) {
  check(robot);
  return middle(eroded(map, repaired_or_named(map), robot)).place;
}

}  // namespace oxturn
