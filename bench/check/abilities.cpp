// What its description says is true: capabilities, parameters, promise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/check/subject.hpp"
#include "metrics/score.hpp"

namespace oxturn {
namespace {

void require(const CheckSubject& subject, Capability capability) {
  if (!subject.planner().has(capability)) throw CheckSkipped("it does not declare this");
}

std::string must_manage(const CheckSubject& subject, const Problem& problem, const PlanRequest& request = {}) {
  const Planned planned = subject.plan(problem, request);
  if (planned.outcome == Outcome::infeasible)
    return fmt::format("on '{}': says infeasible: {}", problem.map().name, planned.reason);
  return subject.must_be_valid(problem, planned);
}

std::string holes(CheckSubject& subject) {
  require(subject, Capability::holes);
  for (const char* name : {"pillar", "clutter:3"})
    if (std::string wrong = must_manage(subject, subject.problem(name)); !wrong.empty()) return wrong;
  return "";
}

std::string tether(CheckSubject& subject) {
  require(subject, Capability::tether);
  const Problem& problem = subject.problem("pillar");
  const Planned planned = subject.plan(problem);
  if (std::string wrong = subject.must_be_valid(problem, planned); !wrong.empty() || !planned.path) return wrong;
  return find_flaw(problem, *planned.path);
}

std::string footprint(CheckSubject& subject) {
  require(subject, Capability::footprint);
  const Problem plain = subject.problem("polygon:3");  // with oblique walls
  Robot robot = plain.robot();
  robot.footprint = parse_footprint("square:0.4");
  return must_manage(subject, subject.take(Problem(plain.map(), robot)));
}

std::string curvature(CheckSubject& subject) {
  require(subject, Capability::curvature);
  const Problem plain = subject.problem("symmetries");
  Robot robot = plain.robot();
  robot.min_turn_radius = robot.radius;
  return must_manage(subject, subject.take(Problem(plain.map(), robot, plain.start())));
}

/// A hall in which the far end is out of the lidar's range at first.
Problem hall(const CheckSubject& subject, double length) {
  Robot robot = check_robot();
  robot.lidar = Lidar{.range = 3, .rays = 180};
  if (subject.tethered()) robot.tether = Tether{60, 0};
  return Problem({fmt::format("hall of {} m", length), box_region({0, 0}, {length, 3}), "check", "hall"}, robot,
                 Point(1, 1.5));
}

/// The points of a path until the robot comes near where the halls differ.
Polyline until(const Path& path, double x) {
  Polyline points;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points) {
      if (p.x() > x) return points;
      points.push_back(p);
    }
  return points;
}

std::string online(CheckSubject& subject) {
  require(subject, Capability::online);
  const auto& parameters = subject.planner().parameters;
  Settings settings;
  if (std::any_of(parameters.begin(), parameters.end(), [](const ParameterInfo& p) { return p.name == "sensing"; }))
    settings["sensing"] = std::string("lidar");
  const Problem near = subject.take(hall(subject, 12)), far = subject.take(hall(subject, 15));
  const Planned a = subject.plan(near, {.settings = settings}), b = subject.plan(far, {.settings = settings});
  for (const auto& [problem, planned] : {std::pair(&near, &a), std::pair(&far, &b)})
    if (std::string wrong = subject.must_be_valid(*problem, *planned); !wrong.empty()) return wrong;
  if (!a.path || !b.path) return "";
  const double out_of_sight = 12 - 3 - 1;
  const Polyline first = until(*a.path, out_of_sight), second = until(*b.path, out_of_sight);
  const std::size_t common = std::min(first.size(), second.size());
  for (std::size_t i = 0; i < common; ++i)
    if (distance(first[i], second[i]) > near.tolerance())
      return fmt::format("drives to {} or to {}, as the hall is 12 or 15 m long, before it can see the end",
                         to_text(first[i]), to_text(second[i]));
  return "";
}

std::string promise(CheckSubject& subject) {
  if (subject.planner().promised({}) == Promise::nothing) throw CheckSkipped("it promises nothing");
  const bool with_holes = subject.planner().has(Capability::holes);
  for (const char* name : {"room", "symmetries", "polygon:3", "rooms:2", "cave:1"}) {
    if (!with_holes && std::string(name).ends_with("s:2")) continue;
    try {
      const Problem& problem = subject.problem(name);
      if (std::string wrong = subject.must_keep_promise(problem, subject.plan(problem)); !wrong.empty()) return wrong;
    } catch (const CheckSkipped&) {}  // a generated map may have holes
  }
  return "";
}

/// Every other value of the parameters that have a few, one at a time.
std::string parameters(CheckSubject& subject) {
  const Problem& problem = subject.problem(subject.planner().has(Capability::holes) ? "pillar" : "room");
  int tried = 0;
  for (const ParameterInfo& parameter : subject.planner().parameters) {
    std::vector<Value> values;
    if (const bool* truth = std::get_if<bool>(&parameter.fallback)) values.emplace_back(!*truth);
    for (const std::string& choice : parameter.choices) values.emplace_back(choice);
    for (const Value& value : values) {
      if (value == parameter.fallback) continue;
      const Planned planned = subject.plan(problem, {.settings = {{parameter.name, value}}});
      ++tried;
      if (planned.outcome == Outcome::infeasible || planned.outcome == Outcome::unsupported) continue;
      if (const std::string wrong = subject.must_be_valid(problem, planned); !wrong.empty())
        return fmt::format("with {}={}, {}", parameter.name, to_text(value), wrong);
    }
  }
  if (tried == 0) throw CheckSkipped("it has no parameters with a few values");
  return "";
}

}  // namespace

PlannerChecks ability_checks() {
  return {{"holes", "capability holes: a valid path around obstacles", holes},
          {"tether", "capability tether: keeps the tether length limit", tether},
          {"footprint", "capability footprint: a valid path of a robot that is no disc", footprint},
          {"curvature", "capability curvature: a valid path of a robot that cannot turn on the spot", curvature},
          {"online", "capability online: does not know what its lidar has not seen", online},
          {"promise", "covers what it promises", promise},
          {"parameters", "a valid path or a refusal with each value of its parameters", parameters}};
}

}  // namespace oxturn
