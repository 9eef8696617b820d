#include "algorithms/tour/tour_moves.hpp"

namespace oxturn {

bool reinsert(MoveSearch& search, ElementId a) {
  const TourProblem& problem = search.problem;
  TourState& state = search.state;
  const ElementId b = state.next(a);
  const PatternId from = state.pattern(a), to = state.pattern(b);
  const double here = search.connection(from, to);
  const auto between = [&](ElementId e, ElementId f) { return search.connection(state.pattern(e), state.pattern(f)); };
  for (const Neighbour& near : search.lists.after(from)) {
    if (near.cost >= here) return false;
    const ElementId c = near.element, p = state.previous(c), n = state.next(c);
    if (c == b || p == n || (c == 0 && problem.has_direction())) continue;
    const double removed = here + between(p, c) + between(c, n) + problem.inner(state.pattern(c));
    const double added = near.cost + search.connection(near.pattern, to) + between(p, n) + problem.inner(near.pattern);
    if (!search.better(removed, added)) continue;
    if (!state.swap_blocks(state.position(c), 1, state.count(n, a))) continue;
    state.set_pattern(c, near.pattern);
    search.gained += removed - added;
    search.push({a, b, c, p, n});
    return true;
  }
  return false;
}

}  // namespace oxturn
