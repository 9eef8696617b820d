// Map + robot + start -> configuration space and target.
//
// Complexity  n vertices: repair, erosion and dilation O(n log n) each; target, its excess, shortest paths and edge
//             indexes are built at the first call, once, whichever thread asks.
// Decisions   1. Configuration space errs inside by at most tool_width / 1000 (erode, Bound::inside): what it calls
//                free is free. `target` is what can be covered from that space, not from the ideal one.
//             2. A tool no wider than the robot never leaves free space, so nothing is intersected then.
//             3. A tethered robot whose anchor is given and whose start is not starts as near to the anchor as it fits.
//             4. A polygonal footprint keeps its orientation, so configuration space is a plane region: free space less
//                the Minkowski sum of walls and reflected footprint (minkowski.hpp). Its `radius` becomes that of the
//                largest disc inside, so that what planners conclude from the radius (a tool that cannot reach over
//                walls) holds.
#include "maps/problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "base/sha256.hpp"
#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/overlay/validity.hpp"
#include "geometry/staircase.hpp"
#include "maps/configuration_space.hpp"
#include "maps/drawing_file.hpp"

namespace oxturn {
namespace {

constexpr double kLongestStep = 0.5;  // tool widths, of a staircase

double largest_coordinate(const Region& region) {
  const Box box = bounding_box(region);
  return box.empty() ? 0 : std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
}

double tolerance_of(const Region& free, const Robot& robot) {
  return 1e-6 * robot.tool_width + 1e-12 * largest_coordinate(free);
}

Region repaired_or_named(const Map& map) {
  Region free;
  try {
    free = repaired(map.free);
  } catch (const std::invalid_argument& flaw) { throw_invalid("map '{}': {}", map.name, flaw.what()); }
  if (free.empty()) throw_invalid("map '{}' has no free space at all", map.name);
  return free;
}

/// The target area in canonical form. That it reaches beyond free space is no fault, that it lies outside of it is.
Region repaired_target_area(const Map& map) {
  Region target;
  try {
    target = repaired(*map.target_area);
  } catch (const std::invalid_argument& flaw) { throw_invalid("target area of map '{}': {}", map.name, flaw.what()); }
  if (target.empty()) throw_invalid("target area of map '{}' has no area", map.name);
  if (intersect(target, map.free).empty())
    throw_invalid("target area of map '{}' lies outside its free space, near {}; expected an area that overlaps it",
                  map.name, to_text(bounding_box(target).centre()));
  return target;
}

/// Does the robot start in the target area by default? That of a drawing is thin lines, and where the robot begins does
/// not matter for them.
bool starts_in_target(const Map& map) { return map.target_area && !map.drawing; }

void require_finite(const char* what, const std::optional<Point>& p) {
  if (p && !finite(*p)) throw_invalid("{} {} is not finite, expected metres", what, to_text(*p));
}

[[noreturn]] void refuse_start(const Map& map, const Robot& robot, const Point& start, const Region& all,
                               double tolerance) {
  const std::string nearest = to_text(nearest_point_inside(all, start, robot.tool_width));
  if (!holds(map.free, start, tolerance))
    throw_invalid("start {} is inside a wall of '{}'; nearest point where the robot fits: {}", to_text(start), map.name,
                  nearest);
  throw_invalid("start {} is too near a wall of '{}' for robot '{}' ({}); nearest point where the robot fits: {}",
                to_text(start), map.name, robot.name, size_text(robot), nearest);
}

}  // namespace

/// What a problem and its restrictions share.
struct ProblemBasis {
  Map map;
  Robot robot;
  Point start{0, 0}, anchor{0, 0};
  double tolerance = 0;
  std::shared_ptr<const Region> space;
  std::unique_ptr<const TetherModel> tether;  // nullptr: no tether
  double lost_m2 = 0;                         // area by which `space` may be smaller than what the tether reaches

  mutable std::once_flag target_once, excess_once, edges_once, staircase_once;
  mutable std::unique_ptr<const EdgeIndex> edges;
  mutable Region target_region;
  mutable double excess = 0;
  mutable bool staircase = false;

  /// Between arcs and chords lies less than (sum of angles) * reach * chord error: it is chosen for half of 1e-4 of the
  /// space's area, within limits that keep the target cheap.
  double target_chord() const {
    const double w = robot.tool_width, angles = convex_turning(*space);
    const double wanted = angles > 0 ? 0.5e-4 * area(*space) / (angles * w / 2) : w;
    return std::clamp(wanted, w / 20000, w / 1000);
  }

  const Region& target() const {
    std::call_once(target_once, [this] {
      target_region = dilate(*space, robot.tool_width / 2, target_chord(), Bound::inside);
      if (robot.tool_width / 2 > robot.radius) target_region = intersect(target_region, map.free);
      if (map.target_area) target_region = intersect(target_region, *map.target_area);
    });
    return target_region;
  }

  double target_excess() const {
    std::call_once(excess_once, [this] {
      // A boolean snaps its operands to 2^-30 of their extent, so as much may be lost along the boundary.
      const Box box = bounding_box(map.free);
      const double snapping = perimeter(target()) * box.size().maxCoeff() * std::ldexp(1.0, -29);
      const double whole = map.target_area ? area(intersect(map.free, *map.target_area)) : area(map.free);
      const double left = std::max(whole - area(target()), 0.0);  // little where wide tools reach everything
      excess = std::min(dilation_shortfall(*space, robot.tool_width / 2, target_chord()), left) + snapping + lost_m2;
    });
    return excess;
  }

  const EdgeIndex& map_edges() const {
    std::call_once(edges_once, [this] { edges = std::make_unique<const EdgeIndex>(map.free); });
    return *edges;
  }

  bool has_staircase_walls() const {
    std::call_once(staircase_once, [this] { staircase = is_staircase(map.free, kLongestStep * robot.tool_width); });
    return staircase;
  }
};

struct Problem::Impl {
  std::shared_ptr<const ProblemBasis> basis;
  std::shared_ptr<const Region> space;
  Point start;
  Robot robot;
  mutable std::once_flag transit_once, walls_once, work_once;
  mutable Region work;  // with a target area
  mutable std::unique_ptr<const ShortestPaths> transit;
  mutable std::unique_ptr<const EdgeIndex> walls;
  std::shared_ptr<const Impl> transit_of;  // the problem whose shortest paths it shares, if they are not its own

  Impl(std::shared_ptr<const ProblemBasis> b, std::shared_ptr<const Region> s, const Point& from, Robot r,
       std::shared_ptr<const Impl> shares = nullptr)
      : basis(std::move(b)), space(std::move(s)), start(from), robot(std::move(r)), transit_of(std::move(shares)) {}
};

namespace {

/// Configuration space is smaller than without the tether.
bool limited_by_tether(const ProblemBasis& basis) {
  return basis.tether && &basis.tether->robot_space() != basis.space.get();
}

/// Adds the tether to a basis whose space is still that of the robot alone, and cuts the space down to its reach.
void attach_tether(ProblemBasis& basis) {
  basis.tether = std::make_unique<const TetherModel>(basis.map.free, basis.space, basis.robot, basis.anchor,
                                                     basis.start, basis.tolerance);
  const TetherModel& model = *basis.tether;
  const double away = model.geodesics().distance(basis.start);
  if (!std::isfinite(away))
    throw_invalid(
        "anchor {} is out of reach: no path wide enough for robot '{}' leads there from the start {}; "
        "expected a point in the same part of '{}'",
        to_text(basis.anchor), basis.robot.name, to_text(basis.start), basis.map.name);
  Tether& tether = *basis.robot.tether;
  if (tether.reach > 0) tether = {tether.reach * model.farthest(), 0, tether.sharp_angle};
  if (away > tether.length)
    throw_invalid("tether of robot '{}' is {} m long, too short for the start {}, {} m from the anchor {}",
                  basis.robot.name, to_decimal(tether.length), to_text(basis.start), fmt::format("{:.4g}", away),
                  to_text(basis.anchor));
  // Between two samples of the cut the distance may be a little larger than at both.
  if (model.farthest() + basis.robot.tool_width / 5 <= tether.length) return;
  TetherReach reach = within_tether(model, basis.robot, basis.start);
  basis.lost_m2 = reach.lost_m2;
  basis.space = std::make_shared<const Region>(std::move(reach.space));
}

}  // namespace

Problem::Problem(Map map, Robot robot, std::optional<Point> start, std::optional<Point> anchor) {
  check(robot);
  if (!robot.footprint.empty()) robot.radius = in_radius(robot.footprint);
  map.free = repaired_or_named(map);
  if (map.target_area) map.target_area = repaired_target_area(map);
  require_finite("start", start);
  require_finite("anchor", anchor);

  const Region all = eroded(map, map.free, robot);
  const auto basis = std::make_shared<ProblemBasis>();
  basis->tolerance = tolerance_of(map.free, robot);
  if (!start && !(robot.tether && anchor))
    start = find_default_start(all, map.free, starts_in_target(map) ? &*map.target_area : nullptr, robot.tool_width);
  basis->start = start                    ? *start
                 : holds(all, *anchor, 0) ? *anchor
                                          : nearest_point_inside(all, *anchor, robot.tool_width);
  const Polygon* component = component_at(all, basis->start, basis->tolerance);
  if (component == nullptr) refuse_start(map, robot, basis->start, all, basis->tolerance);
  basis->anchor = anchor ? *anchor : basis->start;
  if (anchor && !holds(map.free, *anchor, basis->tolerance))
    throw_invalid("anchor {} is inside a wall of '{}', expected a point in free space", to_text(*anchor), map.name);
  basis->space = std::make_shared<const Region>(Region{{*component}});
  basis->map = std::move(map);
  basis->robot = std::move(robot);
  if (basis->robot.tether) attach_tether(*basis);
  impl_ = std::make_shared<const Impl>(basis, basis->space, basis->start, basis->robot);
  if (this->map().target_area && target().empty())
    throw_invalid("target area of map '{}' is out of reach: robot '{}' ({}) covers none of it from the start {}",
                  this->map().name, this->robot().name, size_text(this->robot()), to_text(this->start()));
}

Problem::Problem(std::shared_ptr<const Impl> impl) : impl_(std::move(impl)) {}

const Map& Problem::map() const { return impl_->basis->map; }
const Robot& Problem::robot() const { return impl_->robot; }
const Point& Problem::start() const { return impl_->start; }
const Point& Problem::anchor() const { return impl_->basis->anchor; }
const Region& Problem::configuration_space() const { return *impl_->space; }
bool Problem::limited() const { return impl_->space != impl_->basis->space || limited_by_tether(*impl_->basis); }
const TetherModel* Problem::tether() const { return impl_->basis->tether.get(); }
const Region& Problem::target() const { return impl_->basis->target(); }
const Region& Problem::work_space() const {
  if (!map().target_area) return configuration_space();
  std::call_once(impl_->work_once, [this] {
    const double w = robot().tool_width;
    impl_->work = intersect(dilate(target(), w / 2, w / 1000, Bound::outside), configuration_space());
  });
  return impl_->work;
}
double Problem::target_excess() const { return impl_->basis->target_excess(); }
bool Problem::has_staircase_walls() const { return impl_->basis->has_staircase_walls(); }
double Problem::tolerance() const { return impl_->basis->tolerance; }
const EdgeIndex& Problem::map_edges() const { return impl_->basis->map_edges(); }

const ShortestPaths& Problem::transit() const {
  if (impl_->transit_of) return Problem(impl_->transit_of).transit();
  std::call_once(impl_->transit_once,
                 [this] { impl_->transit = std::make_unique<const ShortestPaths>(Mesh(*impl_->space), tolerance()); });
  return *impl_->transit;
}

const EdgeIndex& Problem::walls() const {
  std::call_once(impl_->walls_once, [this] { impl_->walls = std::make_unique<const EdgeIndex>(*impl_->space); });
  return *impl_->walls;
}

namespace {

/// Throws unless the space holds the start.
std::shared_ptr<const Region> space_with(const Point& start, Region space, const Problem& problem) {
  if (!holds(space, start, problem.tolerance()))
    throw_invalid("restricted configuration space of '{}' does not hold the start {}", problem.map().name,
                  to_text(start));
  return std::make_shared<const Region>(std::move(space));
}

}  // namespace

Problem Problem::restricted(Region configuration_space, Transit transit) const {
  return Problem(std::make_shared<const Impl>(impl_->basis, space_with(start(), std::move(configuration_space), *this),
                                              start(), robot(), transit == Transit::shared ? impl_ : nullptr));
}

Problem Problem::restricted(Region configuration_space, const Point& start) const {
  return Problem(std::make_shared<const Impl>(impl_->basis, space_with(start, std::move(configuration_space), *this),
                                              start, robot()));
}

Problem Problem::turning_on_the_spot() const {
  Robot robot = impl_->robot;
  robot.min_turn_radius = 0;
  return Problem(
      std::make_shared<const Impl>(impl_->basis, impl_->space, start(), std::move(robot), impl_->transit_of));
}

std::string Problem::content_hash() const {
  std::string bytes = canonical_bytes(map()) + canonical_text(robot());
  for (const double value : {start().x(), start().y(), anchor().x(), anchor().y()}) append_canonical(bytes, value);
  return sha256(bytes);
}

Point default_start(const Map& map, const Robot& robot) {
  check(robot);
  const Region free = repaired_or_named(map), all = eroded(map, free, robot);
  std::optional<Region> target_area;
  if (starts_in_target(map)) target_area = repaired_target_area(map);
  return find_default_start(all, free, target_area ? &*target_area : nullptr, robot.tool_width);
}

}  // namespace oxturn
