/// What the moves of a local search share: the tour, the neighbour lists, and the elements still to be looked at.
///
///   MoveSearch search(problem, lists, state);
///   search.queue.push(e);
///   while (const auto a = search.queue.pop()) while (improve(search, *a)) {}
///   search.gained;                                             // by how much the tour became cheaper
#pragma once

#include <optional>
#include <vector>

#include "algorithms/tour/neighbour_lists.hpp"
#include "algorithms/tour/tour_state.hpp"

namespace oxturn {

/// Elements in the order they were pushed, each at most once: the don't-look bits of Bentley (1992), as a queue. Only
/// elements whose connections have changed are looked at again.
class WorkQueue {
 public:
  explicit WorkQueue(std::size_t n) : waiting_(n, false) {}
  void push(ElementId e) {
    if (waiting_[e]) return;
    waiting_[e] = true;
    items_.push_back(e);
  }
  std::optional<ElementId> pop() {
    if (head_ == items_.size()) {
      items_.clear();
      head_ = 0;
      return std::nullopt;
    }
    const ElementId e = items_[head_++];
    waiting_[e] = false;
    return e;
  }
  void clear() {
    while (pop()) {}
  }

 private:
  std::vector<bool> waiting_;
  std::vector<ElementId> items_;
  std::size_t head_ = 0;
};

/// The tour as seen when driving it forwards or backwards: moves are written once, for the forward direction.
class TourView {
 public:
  TourView(const TourProblem& problem, const TourState& state, bool backwards)
      : problem_(problem), state_(state), backwards_(backwards) {}
  bool backwards() const { return backwards_; }
  ElementId next(ElementId e) const { return backwards_ ? state_.previous(e) : state_.next(e); }
  ElementId previous(ElementId e) const { return backwards_ ? state_.next(e) : state_.previous(e); }
  PatternId pattern(ElementId e) const { return seen(state_.pattern(e)); }
  /// A pattern of the tour as seen from here, and back.
  PatternId seen(PatternId p) const { return backwards_ ? problem_.reverse(p) : p; }

 private:
  const TourProblem& problem_;
  const TourState& state_;
  bool backwards_;
};

struct MoveSearch {
  MoveSearch(const TourProblem& p, const NeighbourLists& l, TourState& s)
      : problem(p), lists(l), state(s), queue(p.elements()) {}

  double connection(PatternId p, PatternId q) const { return problem.connection(p, q); }
  /// Whether replacing connections of cost `removed` by those of cost `added` is a gain, and not a rounding error.
  static bool better(double removed, double added) { return removed - added > 1e-9 + 1e-12 * removed; }
  void push(std::initializer_list<ElementId> ends) {
    for (const ElementId e : ends) queue.push(e);
  }

  const TourProblem& problem;
  const NeighbourLists& lists;
  TourState& state;
  WorkQueue queue;
  double gained = 0;
};

}  // namespace oxturn
