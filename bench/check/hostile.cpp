// A valid path, or a refusal that the planner may give, on problems that break programs. Who promises something keeps
// it there, too.
#include "bench/check/subject.hpp"

namespace oxturn {
namespace {

PlannerCheck on_problem(std::string name, std::string problem) {
  return {std::move(name), "a valid path, promise kept: " + problem, [problem](CheckSubject& subject) {
            const Problem& given = subject.problem(problem);
            return subject.must_keep_promise(given, subject.plan(given));
          }};
}

}  // namespace

PlannerChecks hostile_checks() {
  return {on_problem("one-cell", "one cell"),
          on_problem("corridor", "corridor as wide as the robot"),
          on_problem("disconnected", "disconnected"),
          on_problem("many-vertices", "ten thousand vertices"),
          on_problem("collinear", "collinear and duplicate points"),
          on_problem("huge-coordinates", "huge coordinates"),
          on_problem("huge", "huge"),
          on_problem("tiny", "tiny"),
          on_problem("start-on-boundary", "start on the boundary"),
          on_problem("wide-tool", "wide tool"),
          on_problem("narrow-tool", "narrow tool")};
}

}  // namespace oxturn
