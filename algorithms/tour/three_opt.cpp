#include "algorithms/tour/tour_moves.hpp"

namespace oxturn {
namespace {

/// One search at a, in a view's direction. All moves remove a -> b and make c the successor of a:
///
///   two       a [b..c] d                   a [c..b] d             c is reversed
///   both      a [b..c] [d..f] e            a [c..b] [f..d] e
///   outer     a [b..e] [f..c] d            a [c..f] [b..e] d
///   swap      a [b..d] [c..f] e            a [c..f] [b..d] e      c keeps its direction
///   inner     a [b..d] [c..e] f            a [c..e] [d..b] f
///
/// These are all sequential exchanges of two or three connections.
class ThreeOpt {
 public:
  ThreeOpt(MoveSearch& search, ElementId a, bool backwards)
      : search_(search), state_(search.state), view_(search.problem, search.state, backwards), a_(a) {
    b_ = view_.next(a);
    from_ = view_.pattern(a);
    here_ = connection(from_, view_.pattern(b_));
  }

  bool run() {
    for (const Neighbour& near : search_.lists.after(from_)) {
      if (near.cost >= here_) return false;
      const ElementId c = near.element;
      if (const double cost = cost_to(near, reversed(c), from_); cost < here_ && reverse_to(c, cost)) return true;
      if (c == b_) continue;
      if (const double cost = cost_to(near, view_.pattern(c), from_); cost < here_ && keep_to(c, cost)) return true;
    }
    return false;
  }

 private:
  double connection(PatternId p, PatternId q) const { return search_.connection(p, q); }
  double between(ElementId e, ElementId f) const { return connection(view_.pattern(e), view_.pattern(f)); }
  PatternId reversed(ElementId e) const { return search_.problem.reverse(view_.pattern(e)); }
  double cost_to(const Neighbour& near, PatternId p, PatternId from) const {
    return near.pattern == p ? near.cost : connection(from, p);
  }
  /// Stops from b on; a is the last.
  std::size_t offset(ElementId e) const {
    const std::size_t b = state_.position(b_), p = state_.position(e), n = state_.size();
    return view_.backwards() ? (b + n - p) % n : (p + n - b) % n;
  }

  /// a -> c, and from c on backwards. d, behind c, needs a new neighbour.
  bool reverse_to(ElementId c, double cost) {
    const ElementId d = view_.next(c);
    const double removed = here_ + between(c, d), gain = removed - cost;
    const double close = connection(reversed(b_), view_.pattern(d));
    if (search_.better(removed, cost + close) && reverse(b_, c)) return done(removed - cost - close, {a_, b_, c, d});
    const std::size_t at_c = offset(c), at_d = offset(d);
    for (const Neighbour& near : search_.lists.after(reversed(d))) {
      if (near.cost >= gain) return false;
      const ElementId e = near.element;
      const std::size_t at_e = offset(e);
      if (at_e > at_d ? both(c, d, e, removed, cost, near) : at_e < at_c && outer(c, d, e, removed, cost, near))
        return true;
    }
    return false;
  }

  bool both(ElementId c, ElementId d, ElementId e, double removed, double cost, const Neighbour& near) {
    const ElementId f = view_.previous(e);
    removed += between(f, e);
    cost += cost_to(near, view_.pattern(e), reversed(d)) + connection(reversed(b_), reversed(f));
    if (!search_.better(removed, cost)) return false;
    const std::size_t mark = state_.mark();
    if (!reverse(b_, c)) return false;
    // The reversal may have turned the other side instead: then the second run lies backwards.
    const bool turned = view_.next(f) != e;
    if (!(turned ? reverse(f, d) : reverse(d, f))) return undo(mark);
    return done(removed - cost, {a_, b_, c, d, e, f});
  }

  bool outer(ElementId c, ElementId d, ElementId e, double removed, double cost, const Neighbour& near) {
    const ElementId f = view_.next(e);
    removed += between(e, f);
    cost += cost_to(near, reversed(e), reversed(d)) + connection(reversed(f), view_.pattern(b_));
    if (!search_.better(removed, cost)) return false;
    const std::size_t mark = state_.mark();
    if (!swap(b_, e, f, c)) return false;
    if (!reverse(f, c)) return undo(mark);
    return done(removed - cost, {a_, b_, c, d, e, f});
  }

  /// a -> c, and from c on as before. d, before c, needs a new neighbour, behind c.
  bool keep_to(ElementId c, double cost) {
    const ElementId d = view_.previous(c);
    const double removed = here_ + between(d, c), gain = removed - cost;
    const std::size_t at_c = offset(c);
    for (const Neighbour& near : search_.lists.after(view_.pattern(d))) {
      if (near.cost >= gain) return false;
      const ElementId e = near.element;
      const std::size_t at_e = offset(e);
      if (at_e > at_c && swap_before(c, d, e, removed, cost, near)) return true;
      if (at_e >= at_c && e != a_ && inner(c, d, e, removed, cost, near)) return true;
    }
    return false;
  }

  bool swap_before(ElementId c, ElementId d, ElementId e, double removed, double cost, const Neighbour& near) {
    const ElementId f = view_.previous(e);
    removed += between(f, e);
    cost += cost_to(near, view_.pattern(e), view_.pattern(d)) + between(f, b_);
    if (!search_.better(removed, cost) || !swap(b_, d, c, f)) return false;
    return done(removed - cost, {a_, b_, c, d, e, f});
  }

  bool inner(ElementId c, ElementId d, ElementId e, double removed, double cost, const Neighbour& near) {
    const ElementId f = view_.next(e);
    removed += between(e, f);
    cost += cost_to(near, reversed(e), view_.pattern(d)) + connection(reversed(b_), view_.pattern(f));
    if (!search_.better(removed, cost)) return false;
    const std::size_t mark = state_.mark();
    if (!swap(b_, d, c, e)) return false;
    if (!reverse(b_, d)) return undo(mark);
    return done(removed - cost, {a_, b_, c, d, e, f});
  }

  /// x .. y in the view's direction.
  bool reverse(ElementId x, ElementId y) {
    if (view_.backwards()) std::swap(x, y);
    return state_.reverse(state_.position(x), state_.count(x, y));
  }
  /// x .. y and the run behind it, u .. v.
  bool swap(ElementId x, ElementId y, ElementId u, ElementId v) {
    if (view_.backwards()) {
      std::swap(x, v);
      std::swap(y, u);
    }
    return state_.swap_blocks(state_.position(x), state_.count(x, y), state_.count(u, v));
  }
  bool undo(std::size_t mark) {
    state_.undo(mark);
    return false;
  }
  bool done(double gain, std::initializer_list<ElementId> ends) {
    search_.gained += gain;
    search_.push(ends);
    return true;
  }

  MoveSearch& search_;
  TourState& state_;
  TourView view_;
  ElementId a_, b_;
  PatternId from_;  // of a
  double here_;     // cost of the connection from a to b
};

}  // namespace

bool three_opt(MoveSearch& search, ElementId a, bool backwards) { return ThreeOpt(search, a, backwards).run(); }

}  // namespace oxturn
