// Transformed problems, as far as the planner declares that nothing changes: length and work of the path are the same.
//
// The transformations are exact in floating point (a shift by whole metres, a factor of 2), so a planner sees the same
// decisions but for rounding in its own computation.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/check/subject.hpp"

namespace oxturn {
namespace {

constexpr double kRelative = 1e-4;  // lengths that agree: arcs may be cut into other chords

struct Transformation {
  Symmetry symmetry;
  const char* title;
  double scale;  // of lengths
  Point (*apply)(const Point&);
};

const Transformation kAll[] = {
    {Symmetry::shift, "shifted", 1, [](const Point& p) { return Point(p.x() + 32, p.y() - 16); }},
    {Symmetry::quarter_turn, "turned by 90 degrees", 1, [](const Point& p) { return Point(-p.y(), p.x()); }},
    {Symmetry::mirror, "mirrored", 1, [](const Point& p) { return Point(-p.x(), p.y()); }},
    {Symmetry::scale, "twice as large", 2, [](const Point& p) { return Point(2 * p); }}};

Problem transformed(const Problem& problem, const Transformation& t) {
  Map map = problem.map();
  map.name += fmt::format(", {}", t.title);
  const auto transform = [&](Ring& ring) {
    for (Point& p : ring) p = t.apply(p);
    if (t.symmetry == Symmetry::mirror) std::reverse(ring.begin(), ring.end());
  };
  for (auto& polygon : map.free.polygons) {
    transform(polygon.outer);
    for (Ring& hole : polygon.holes) transform(hole);
  }
  Robot robot = problem.robot();
  robot.radius *= t.scale;
  robot.tool_width *= t.scale;
  if (robot.tether) robot.tether->length *= t.scale;
  return Problem(std::move(map), robot, t.apply(problem.start()), t.apply(problem.anchor()));
}

/// Why the paths of a problem and of the transformed one are not alike, or "".
std::string difference(CheckSubject& subject, const Problem& problem, const Transformation& t) {
  const Problem& other = subject.take(transformed(problem, t));
  const Planned before = subject.plan(problem), after = subject.plan(other);
  if (std::string wrong = subject.must_be_valid(other, after); !wrong.empty()) return wrong;
  if (before.outcome != after.outcome)
    return fmt::format("{}, {} on '{}'", to_text(before.outcome), to_text(after.outcome), other.map().name);
  if (!before.path || !after.path) return "";
  for (const bool tool : {true, false}) {
    const double expected = t.scale * before.path->length(tool), found = after.path->length(tool);
    if (std::abs(expected - found) > kRelative * t.scale * before.path->length())
      return fmt::format("on '{}': drives {:.9g} m with the tool {}, expected {:.9g} m", other.map().name, found,
                         tool ? "on" : "off", expected);
  }
  return "";
}

PlannerCheck check_of(const Transformation& t) {
  const auto run = [t](CheckSubject& subject) -> std::string {
    const auto& declared = subject.planner().symmetries;
    if (std::find(declared.begin(), declared.end(), t.symmetry) == declared.end())
      throw CheckSkipped("it does not declare this");
    for (const char* name : {"symmetries", "symmetries with a pillar"}) {
      const bool holes = std::string_view(name) != "symmetries";
      if (holes && !subject.planner().has(Capability::holes)) continue;
      const Problem problem = subject.problem(name);
      if (std::string wrong = difference(subject, problem, t); !wrong.empty()) return wrong;
    }
    return "";
  };
  return {to_text(t.symmetry), fmt::format("a path of the same length on a problem that is {}", t.title), run};
}

}  // namespace

PlannerChecks symmetry_checks() {
  PlannerChecks checks;
  for (const Transformation& t : kAll) checks.push_back(check_of(t));
  return checks;
}

}  // namespace oxturn
