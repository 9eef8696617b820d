/// A closed tour as an array, with the two changes that all moves are made of, and their undoing.
///
///   TourState state(problem, tour);
///   state.reverse(state.position(a), 7);              // seven stops from a on, driven backwards
///   state.swap_blocks(state.position(b), 3, 5);       // three stops from b on and the five after them change places
///   state.undo();                                     // all since the last commit()
///
/// Positions count around the tour. A reversal costs O(shorter side), a swap O(its two shortest blocks): reversing one
/// side or the other gives the same tour, driven forwards or backwards. Where elements have an order to keep, element 0
/// stays at position 0, changes are made on the other side, and one that breaks the order is refused.
/// Arrays are the fastest representation up to some 10^5 elements (Fredman, Johnson, McGeoch and Ostheimer 1995).
#pragma once

#include <vector>

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

class TourState {
 public:
  /// `tour` has every element once. Keeps a reference to `problem`.
  TourState(const TourProblem& problem, const Tour& tour);

  std::size_t size() const { return order_.size(); }
  ElementId at(std::size_t position) const { return order_[position]; }
  std::size_t position(ElementId e) const { return position_[e]; }
  ElementId next(ElementId e) const {
    const std::size_t i = position_[e] + 1;
    return order_[i == order_.size() ? 0 : i];
  }
  ElementId previous(ElementId e) const {
    const std::size_t i = position_[e];
    return order_[i == 0 ? order_.size() - 1 : i - 1];
  }
  PatternId pattern(ElementId e) const { return pattern_[e]; }
  /// How many stops from a to b, driving forwards, both included.
  std::size_t count(ElementId a, ElementId b) const { return (position_[b] + size() - position_[a]) % size() + 1; }

  /// Reverses `count` stops from a position on, or all others. False, and nothing done, if that breaks the order.
  bool reverse(std::size_t from, std::size_t count);
  /// Exchanges two neighbouring blocks. False, and nothing done, if that breaks the order.
  bool swap_blocks(std::size_t from, std::size_t first, std::size_t second);
  void set_pattern(ElementId e, PatternId p);

  /// For undo(): how much has been changed since the last commit().
  std::size_t mark() const { return journal_.size(); }
  void commit() { journal_.clear(); }
  /// Takes back what was changed since `mark`.
  void undo(std::size_t mark = 0);
  /// From element 0 on; driven backwards if that puts it into its first pattern.
  Tour tour() const;

 private:
  enum class Kind : std::uint8_t { reverse, swap, pattern };
  struct Change {
    Kind kind;
    std::uint32_t a, b, c;
  };

  std::size_t wrap(std::size_t i) const { return i >= order_.size() ? i - order_.size() : i; }
  void put(std::size_t position, ElementId e) {
    order_[position] = e;
    position_[e] = static_cast<std::uint32_t>(position);
  }
  void flip(ElementId e) { pattern_[e] = problem_->reverse(pattern_[e]); }
  bool holds_depot(std::size_t from, std::size_t count) const { return from == 0 || from + count > size(); }
  bool in_block(ElementId e, std::size_t from, std::size_t count) const {
    return (position_[e] + size() - from) % size() < count;
  }
  bool may_reverse(std::size_t from, std::size_t count) const;
  bool may_swap(std::size_t from, std::size_t first, std::size_t second) const;
  void do_reverse(std::size_t from, std::size_t count);
  void do_swap(std::size_t from, std::size_t first, std::size_t second);

  const TourProblem* problem_;
  std::vector<ElementId> order_;
  std::vector<std::uint32_t> position_;  // by element
  std::vector<PatternId> pattern_;       // by element
  std::vector<Change> journal_;
  std::vector<ElementId> moved_;  // a block while it is moved
};

}  // namespace oxturn
