#include "algorithms/tour/tour_moves.hpp"

namespace oxturn {

bool two_opt(MoveSearch& search, ElementId a, bool backwards) {
  const TourProblem& problem = search.problem;
  const TourView view(problem, search.state, backwards);
  const ElementId b = view.next(a);
  const PatternId from = view.pattern(a), b_reversed = problem.reverse(view.pattern(b));
  const double here = search.connection(from, view.pattern(b));
  for (const Neighbour& near : search.lists.after(from)) {
    if (near.cost >= here) break;
    const ElementId c = near.element, d = view.next(c);
    const PatternId c_reversed = problem.reverse(view.pattern(c));
    const double to_c = c_reversed == near.pattern ? near.cost : search.connection(from, c_reversed);
    if (to_c >= here) continue;
    const double removed = here + search.connection(view.pattern(c), view.pattern(d));
    const double added = to_c + search.connection(b_reversed, view.pattern(d));
    if (!search.better(removed, added)) continue;
    const ElementId first = backwards ? c : b, last = backwards ? b : c;
    if (!search.state.reverse(search.state.position(first), search.state.count(first, last))) continue;
    search.gained += removed - added;
    search.push({a, b, c, d});
    return true;
  }
  return false;
}

}  // namespace oxturn
