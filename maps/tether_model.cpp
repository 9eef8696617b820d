// Decisions   1. A gap counts as open if configuration space reaches through it, whatever its width says.
//             2. {distance <= tether length} is cut out along its boundary by a strip w / 10^4 wide, inside of it; the
//                area lost counts in Problem::target_excess. What the tether reaches only through points that it does
//                not reach is no part of configuration space.
//             3. An anchor in a closed gap has the tether on the side from which the start is nearer.
#include "maps/tether_model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "maps/configuration_space.hpp"

namespace oxturn {
namespace {

/// Half of the length along.
Point middle_of(const Polyline& line) {
  double left = length(line) / 2;
  std::size_t i = 1;
  for (; i + 1 < line.size() && distance(line[i - 1], line[i]) < left; ++i) left -= distance(line[i - 1], line[i]);
  return lerp(line[i - 1], line[i], left / distance(line[i - 1], line[i]));
}

/// A line across every gap of free space that the robot cannot pass; see Decisions 1 and 3.
std::vector<Polyline> gaps_to_close(const Region& free, const Robot& robot, const Region& space, const Point& anchor,
                                    double tolerance) {
  if (robot.radius <= 0) return {};
  const EdgeIndex walls(space);
  const auto is_open = [&](const Polyline& gap) { return walls.contains(middle_of(gap)); };
  const auto closed = [&](const std::optional<Point>& through) {
    return barriers(free, 2 * robot.radius + robot.tool_width / 250, through);
  };
  std::vector<Polyline> gaps = closed(anchor);
  const auto at_anchor = [&](const Polyline& gap) {
    return std::any_of(gap.begin(), gap.end(), [&](const Point& p) { return distance(p, anchor) <= tolerance; });
  };
  if (std::any_of(gaps.begin(), gaps.end(), [&](const Polyline& gap) { return at_anchor(gap) && is_open(gap); }))
    gaps = closed(std::nullopt);
  std::erase_if(gaps, is_open);
  return gaps;
}

/// The largest geodesic distance of a vertex. Distances grow by no more than points move, so most vertices of a ring
/// need not be asked for theirs.
double farthest_vertex(const Region& space, const GeodesicField& field) {
  constexpr double kRounding = 1e-9;  // relative
  double most = 0;
  for_each_ring(space, [&](const Ring& ring) {
    double bound = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (i > 0) bound += distance(ring[i - 1], ring[i]);
      if (bound * (1 + kRounding) < most) continue;
      bound = field.distance(ring[i]);
      if (std::isfinite(bound)) most = std::max(most, bound);
    }
  });
  return most;
}

/// The largest geodesic distance within `space`: it is taken at a vertex, or where two shortest paths round an obstacle
/// meet.
double farthest_in(const Region& space, const GeodesicField& field, double chord) {
  constexpr double kMostSteps = 1e6;  // of a segment: tools may be as thin as rounding
  double most = farthest_vertex(space, field);
  const std::vector<Polyline> curves = field.cut_locus(chord, most);
  if (curves.empty()) return most;
  const EdgeIndex walls(space);
  for (const Polyline& curve : curves)
    for (std::size_t i = 1; i < curve.size(); ++i) {
      const double steps = std::ceil(distance(curve[i - 1], curve[i]) / (5 * chord));
      const int n = static_cast<int>(std::clamp(steps, 1.0, kMostSteps));
      for (int k = 0; k <= n; ++k)
        if (const Point p = lerp(curve[i - 1], curve[i], double(k) / n); walls.contains(p))
          if (const double d = field.distance(p); std::isfinite(d)) most = std::max(most, d);
    }
  return most;
}

}  // namespace

TetherModel::TetherModel(const Region& free, std::shared_ptr<const Region> robot_space, const Robot& robot,
                         const Point& anchor, const Point& start, double tolerance)
    : free_(free),
      robot_space_(std::move(robot_space)),
      closed_gaps_(gaps_to_close(free, robot, *robot_space_, anchor, tolerance)),
      geodesics_(std::make_unique<const GeodesicField>(free, anchor, closed_gaps_, tolerance, start)),
      farthest_(farthest_in(*robot_space_, *geodesics_, robot.tool_width / 100)) {}

const TautSpace& TetherModel::taut_space() const {
  std::call_once(taut_once_, [this] { taut_ = std::make_unique<const TautSpace>(free_); });
  return *taut_;
}

TetherReach within_tether(const TetherModel& model, const Robot& robot, const Point& start) {
  const Region& space = model.robot_space();
  const double limit = robot.tether->length, w = robot.tool_width;
  TetherReach reach;
  const Point extent = bounding_box(space).size();
  const double strip = std::max(w / 10000, std::ldexp(extent.maxCoeff(), -24));
  std::vector<Polyline> border;
  for (const std::vector<GeodesicField::Arc>& chain : model.geodesics().level_set(limit)) {
    Polyline line = sampled(chain, strip);
    if (line.size() < 2) continue;
    reach.lost_m2 += 2 * strip * length(line);
    // Where the robot has no size, free space ends where the chain does: the strip must close it completely.
    const Point first = line[0] - line[1], last = line[line.size() - 1] - line[line.size() - 2];
    if (line.front() != line.back()) {
      line.insert(line.begin(), line.front() + first.normalized() * 4 * strip);
      line.push_back(line.back() + last.normalized() * 4 * strip);
    }
    border.push_back(std::move(line));
  }
  if (border.empty()) return {space, 0};
  const Region parts = cut_along(space, border, strip);
  const Polygon* part = component_at(parts, start, 2 * strip);
  if (part == nullptr)
    throw_invalid("tether of robot '{}' ({} m) only just reaches the start {}; a longer one is needed to move",
                  robot.name, to_decimal(limit), to_text(start));
  reach.space = Region{{*part}};
  return reach;
}

}  // namespace oxturn
