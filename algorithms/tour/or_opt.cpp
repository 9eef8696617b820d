#include "algorithms/tour/tour_moves.hpp"

namespace oxturn {
namespace {

constexpr int kLongestRun = 3;  // elements (Or 1976)

/// One search for a move at a; elements and patterns as seen in the view's direction.
class OrOpt {
 public:
  OrOpt(MoveSearch& search, ElementId a, bool backwards)
      : search_(search), problem_(search.problem), view_(problem_, search.state, backwards), a_(a) {
    b_ = view_.next(a);
    from_ = view_.pattern(a);
    here_ = search.connection(from_, view_.pattern(b_));
  }

  bool run() {
    for (const Neighbour& near : search_.lists.after(from_)) {
      if (near.cost >= here_) return false;
      const ElementId c = near.element;
      if (c == b_) continue;
      const PatternId pattern = view_.pattern(c);
      if (pull(c, near.pattern == pattern ? near.cost : connection(from_, pattern)) || push(c, pattern)) return true;
      if (near.pattern != pattern && pull_one(c, near)) return true;
      if (!problem_.symmetric()) continue;
      const PatternId reversed = problem_.reverse(pattern);
      const double cost = near.pattern == reversed ? near.cost : connection(from_, reversed);
      if (pull_reversed(c, cost) || push_reversed(c, cost)) return true;
    }
    return false;
  }

 private:
  double connection(PatternId p, PatternId q) const { return search_.connection(p, q); }
  double between(ElementId e, ElementId f) const { return connection(view_.pattern(e), view_.pattern(f)); }
  PatternId reversed(ElementId e) const { return problem_.reverse(view_.pattern(e)); }

  /// c .. y goes to between a and b.
  bool pull(ElementId c, double to_c) {
    if (to_c >= here_) return false;
    const ElementId p = view_.previous(c);
    const double freed = here_ + between(p, c) - to_c;
    ElementId y = c;
    for (int count = 1; count <= kLongestRun && y != a_; ++count, y = view_.next(y)) {
      const ElementId n = view_.next(y);
      const double removed = freed + between(y, n), added = between(y, b_) + between(p, n);
      if (search_.better(removed, added) && move(c, y, count, a_, false, removed - added, {p, n})) return true;
    }
    return false;
  }

  /// x .. c goes to between a and b, driven backwards: c first.
  bool pull_reversed(ElementId c, double to_c) {
    if (to_c >= here_) return false;
    const ElementId n = view_.next(c);
    const double freed = here_ + between(c, n) - to_c;
    ElementId x = c;
    for (int count = 1; count <= kLongestRun && x != b_; ++count, x = view_.previous(x)) {
      const ElementId p = view_.previous(x);
      if (p == a_ || p == c) return false;
      const double removed = freed + between(p, x);
      const double added = connection(reversed(x), view_.pattern(b_)) + between(p, n);
      if (search_.better(removed, added) && move(x, c, count, a_, true, removed - added, {p, n})) return true;
    }
    return false;
  }

  /// c alone goes to between a and b, in the pattern that is best after a.
  bool pull_one(ElementId c, const Neighbour& near) {
    const ElementId p = view_.previous(c), n = view_.next(c);
    if (c == a_ || p == n) return false;
    const PatternId old = view_.pattern(c);
    const double removed = here_ + between(p, c) + between(c, n) + problem_.inner(old);
    const double added =
        near.cost + connection(near.pattern, view_.pattern(b_)) + between(p, n) + problem_.inner(near.pattern);
    if (!search_.better(removed, added)) return false;
    if (!move(c, c, 1, a_, false, removed - added, {p, n})) return false;
    search_.state.set_pattern(c, view_.seen(near.pattern));
    return true;
  }

  /// x .. a goes to before c.
  bool push(ElementId c, PatternId pattern) {
    const double to_c = connection(from_, pattern);
    if (to_c >= here_) return false;
    const ElementId e = view_.previous(c);
    const double freed = here_ + between(e, c) - to_c;
    ElementId x = a_;
    for (int count = 1; count <= kLongestRun && x != c; ++count, x = view_.previous(x)) {
      const ElementId p = view_.previous(x);
      const double removed = freed + between(p, x), added = between(e, x) + between(p, b_);
      if (search_.better(removed, added) && move(x, a_, count, e, false, removed - added, {p, c})) return true;
    }
    return false;
  }

  /// x .. a goes to after c, driven backwards: a first.
  bool push_reversed(ElementId c, double to_c) {
    if (to_c >= here_) return false;
    const ElementId f = view_.next(c);
    const double freed = here_ + between(c, f) - to_c;
    ElementId x = a_;
    for (int count = 1; count <= kLongestRun && x != c; ++count, x = view_.previous(x)) {
      const ElementId p = view_.previous(x);
      if (p == c || f == x) return false;
      const double removed = freed + between(p, x);
      const double added = connection(reversed(x), view_.pattern(f)) + between(p, b_);
      if (search_.better(removed, added) && move(x, a_, count, c, true, removed - added, {p, f})) return true;
    }
    return false;
  }

  /// The run x .. y to behind `after`. `ends`: the other two elements that lose a connection.
  bool move(ElementId x, ElementId y, int count, ElementId after, bool turn, double gain,
            std::initializer_list<ElementId> ends) {
    TourState& state = search_.state;
    const std::size_t mark = state.mark(), length = static_cast<std::size_t>(count);
    const ElementId follower = view_.next(after);
    const ElementId first = view_.backwards() ? y : x, last = view_.backwards() ? x : y;
    const ElementId left = view_.backwards() ? follower : after;
    if (!state.swap_blocks(state.position(first), length, state.count(state.next(last), left))) return false;
    if (turn && !state.reverse(state.position(first), length)) {
      state.undo(mark);
      return false;
    }
    search_.gained += gain;
    search_.push({x, y, after, follower});
    search_.push({a_, b_});
    search_.push(ends);
    return true;
  }

  MoveSearch& search_;
  const TourProblem& problem_;
  TourView view_;
  ElementId a_, b_;
  PatternId from_;  // of a
  double here_;     // cost of the connection from a to b
};

}  // namespace

bool or_opt(MoveSearch& search, ElementId a, bool backwards) { return OrOpt(search, a, backwards).run(); }

}  // namespace oxturn
