#include "algorithms/tour/tour_moves.hpp"

namespace oxturn {
namespace {

/// One search at a. Connections a -> a', b -> b', c -> c', in this order round the tour, become a -> b', c -> a',
/// b -> c': the runs a' .. b and b' .. c change places.
class OrThreeOpt {
 public:
  OrThreeOpt(MoveSearch& search, ElementId a)
      : search_(search), state_(search.state), a_(a), a_next_(state_.next(a)), here_(between(a, a_next_)) {}

  bool run() {
    for (const Neighbour& near : search_.lists.after(state_.pattern(a_))) {
      if (near.cost >= here_) break;
      if (near.element != a_next_ && from_second(near.element)) return true;
    }
    for (const Neighbour& near : search_.lists.before(state_.pattern(a_next_))) {
      if (near.cost >= here_) break;
      if (near.element != a_ && from_third(near.element)) return true;
    }
    return false;
  }

 private:
  double between(ElementId e, ElementId f) const { return search_.connection(state_.pattern(e), state_.pattern(f)); }
  /// Stops from a' on; a is the last.
  std::size_t offset(ElementId e) const {
    return (state_.position(e) + state_.size() - state_.position(a_next_)) % state_.size();
  }

  /// a -> b' is worthwhile: look for c.
  bool from_second(ElementId b_next) {
    const ElementId b = state_.previous(b_next);
    const double gain = here_ - between(a_, b_next) + between(b, b_next);
    if (gain <= 0) return false;
    for (const Neighbour& near : search_.lists.before(state_.pattern(a_next_))) {
      if (near.cost >= gain) break;
      if (move(b, near.element)) return true;
    }
    for (const Neighbour& near : search_.lists.after(state_.pattern(b))) {
      if (near.cost >= gain) break;
      if (move(b, state_.previous(near.element))) return true;
    }
    return false;
  }

  /// c -> a' is worthwhile: look for b.
  bool from_third(ElementId c) {
    const ElementId c_next = state_.next(c);
    const double gain = here_ - between(c, a_next_) + between(c, c_next);
    if (gain <= 0) return false;
    for (const Neighbour& near : search_.lists.before(state_.pattern(c_next))) {
      if (near.cost >= gain) break;
      if (move(near.element, c)) return true;
    }
    return false;
  }

  bool move(ElementId b, ElementId c) {
    const std::size_t at_b = offset(b), at_c = offset(c);
    if (at_c <= at_b || c == a_) return false;
    const ElementId b_next = state_.next(b), c_next = state_.next(c);
    const double removed = here_ + between(b, b_next) + between(c, c_next);
    const double added = between(a_, b_next) + between(c, a_next_) + between(b, c_next);
    if (!search_.better(removed, added)) return false;
    if (!state_.swap_blocks(state_.position(a_next_), at_b + 1, at_c - at_b)) return false;
    search_.gained += removed - added;
    search_.push({a_, a_next_, b, b_next, c, c_next});
    return true;
  }

  MoveSearch& search_;
  TourState& state_;
  ElementId a_, a_next_;
  double here_;  // cost of the connection from a to a'
};

}  // namespace

bool or_three_opt(MoveSearch& search, ElementId a) { return OrThreeOpt(search, a).run(); }

}  // namespace oxturn
