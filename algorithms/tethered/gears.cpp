// Method      While the robot drives straight and the tether turns about one pivot, let h be the pivot's distance from
//             the line driven, s the robot's position along it (0 at the pivot's foot) and a the least angle. Forwards
//             is too near the pull for s < -h cot(a), in reverse for s > h cot(a); in between both gears will do, and
//             the side on which the tether is decides.
// Decisions   1. Where neither rule demands a gear, the gear stays; before the first demand it is the first one
//             demanded.
//             2. A tether within 0.02 rad of the line driven is on neither side.
#include "algorithms/tethered/gears.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "base/math.hpp"
#include "maps/followed_path.hpp"

namespace oxturn {
namespace {

constexpr double kInLine = 0.02;  // radians between the tether and the line driven: on neither side

/// A straight part of a path, and the gear that the rules demand there.
struct Part {
  Point to;
  bool tool;
  std::optional<Gear> demanded;
};

class GearChoice {
 public:
  explicit GearChoice(const GearRules& rules)
      : rules_(rules), cotangent_(rules.least_angle > 0 ? 1 / math::tan(rules.least_angle) : 0) {}

  /// Appends the parts of a drive in `direction`, a unit vector, during which the tether turns about one pivot.
  void add(const TautTether::Swing& swing, const Point& direction, bool tool, std::vector<Part>& parts) const {
    const double begin = (swing.from - swing.pivot).dot(direction), end = (swing.to - swing.pivot).dot(direction);
    const double left = cross(direction, swing.pivot - swing.from);  // of the pivot, from the line driven
    const double limit =
        rules_.least_angle > 0 ? std::abs(left) * cotangent_ : std::max(std::abs(begin), std::abs(end));
    double from = begin;
    const auto add_until = [&](double s) {
      if (s <= from) return;
      const Point to = s < end ? Point(swing.from + (s - begin) * direction) : swing.to;
      parts.push_back({to, tool, demanded(std::midpoint(from, s), left, limit)});
      from = s;
    };
    add_until(std::min(-limit, end));
    add_until(std::min(limit, end));
    add_until(end);
  }

 private:
  std::optional<Gear> demanded(double s, double left, double limit) const {
    if (std::abs(s) > limit) return s < 0 ? Gear::reverse : Gear::forward;
    if (rules_.side == TetherSide::any || std::abs(left) <= kInLine * std::abs(s)) return std::nullopt;
    return (left > 0) == (rules_.side == TetherSide::left) ? Gear::forward : Gear::reverse;
  }

  GearRules rules_;
  double cotangent_;
};

}  // namespace

Path with_gears(const Problem& problem, const Path& path, const GearRules& rules) {
  const GearChoice choice(rules);
  TautTether tether = tether_at_start(problem);
  std::vector<Part> parts;
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      if (a == b) continue;
      const Point direction = (b - a).normalized();
      tether.drive(b, [&](const TautTether::Swing& swing) { choice.add(swing, direction, leg.tool, parts); });
      if (!parts.empty()) parts.back().to = b;
    }
  const auto first = std::ranges::find_if(parts, [](const Part& part) { return part.demanded.has_value(); });
  Gear gear = first != parts.end() ? *first->demanded : Gear::forward;
  PathBuilder out(problem.start());
  for (const Part& part : parts) {
    gear = part.demanded.value_or(gear);
    out.drive(part.to, part.tool, gear);
  }
  return out.take();
}

namespace {

/// Runs a planner that knows nothing of gears, and chooses them.
class Reversing final : public CoveragePlanner {
 public:
  Reversing(std::unique_ptr<CoveragePlanner> inner, const GearRules& rules) : inner_(std::move(inner)), rules_(rules) {}
  Path plan(const Problem& problem, Context& context) const override {
    Context::Sinks sinks = context.without_promise();
    sinks.publish = [&](const Path& path) { context.publish(with_gears(problem, path, rules_)); };
    Context inner(context.rng().bits(), context.seconds_left(), std::move(sinks));
    Path path = with_gears(problem, inner_->plan(problem, inner), rules_);
    context.publish(path);
    return path;
  }

 private:
  std::unique_ptr<CoveragePlanner> inner_;
  GearRules rules_;
};

TetherSide side_of(const std::string& winding) {
  return winding == "left" ? TetherSide::left : winding == "right" ? TetherSide::right : TetherSide::any;
}

}  // namespace

PlannerInfo with_reverse(PlannerInfo planner) {
  const ParameterInfo reverse{
      "reverse", false, {}, {}, "winding and min_tether_angle by driving backwards where need be; no longer path"};
  const auto named = [&](const char* name) {
    return *std::ranges::find(planner.parameters, std::string(name), &ParameterInfo::name);
  };
  const ParameterInfo winding = named("winding"), angle = named("min_tether_angle");
  planner.parameters.push_back(reverse);
  planner.make = [make = std::move(planner.make), owner = "planner '" + planner.name + "'", reverse, winding, angle](
                     Settings settings, const Planners& planners) -> std::unique_ptr<CoveragePlanner> {
    const auto given = settings.extract("reverse");
    if (!given || !std::get<bool>(checked(owner, reverse, given.mapped()))) return make(std::move(settings), planners);
    GearRules rules;
    if (const auto value = settings.extract("winding"))
      rules.side = side_of(std::get<std::string>(checked(owner, winding, value.mapped())));
    if (const auto value = settings.extract("min_tether_angle"))
      rules.least_angle = std::get<double>(checked(owner, angle, value.mapped()));
    return std::make_unique<Reversing>(make(std::move(settings), planners), rules);
  };
  return planner;
}

}  // namespace oxturn
