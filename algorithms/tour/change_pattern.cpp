#include "algorithms/tour/tour_moves.hpp"

namespace oxturn {

bool change_pattern(MoveSearch& search, ElementId a) {
  const TourProblem& problem = search.problem;
  if ((a == 0 && problem.has_direction()) || problem.pattern_count(a) == 1) return false;
  TourState& state = search.state;
  const ElementId before = state.previous(a), after = state.next(a);
  const PatternId from = state.pattern(before), to = state.pattern(after), old = state.pattern(a);
  const auto cost = [&](PatternId p) {
    return search.connection(from, p) + problem.inner(p) + search.connection(p, to);
  };
  const double present = cost(old);
  PatternId best = old;
  double least = present;
  for (PatternId p = problem.first_pattern(a); p < problem.end_pattern(a); ++p)
    if (const double c = cost(p); search.better(least, c)) {
      best = p;
      least = c;
    }
  if (best == old) return false;
  state.set_pattern(a, best);
  search.gained += present - least;
  search.push({before, a, after});
  return true;
}

}  // namespace oxturn
