/// A tour to be found: elements with patterns, their costs, and which element must be driven before which.
///
///   StraightCost cost(points);
///   TourProblem problem(cost, points.size());              // plain: one pattern an element, driven either way
///   TourProblem clusters(cost, {2, 2, 32}, reverse);       // patterns of each element
///   clusters.require_before(1, 2);
///   double length = clusters.cost(tour);
///
/// A tour is closed; it begins and ends with element 0. Open tours get an element 0 whose connections cost nothing on
/// their free side (a depot): see tour_shapes.hpp. Exactly one pattern of each element is driven (a generalised tour).
/// If element 0 has two patterns, each the reverse of the other, its first says in which direction the tour is driven:
/// so a depot, whose entry is where the tour ends and whose exit is where it starts.
#pragma once

#include <span>
#include <vector>

#include "algorithms/tour/connection_cost.hpp"
#include "algorithms/tour/tour_elements.hpp"

namespace oxturn {

using Tour = std::vector<TourStop>;

class TourProblem {
 public:
  /// n elements of one pattern each, which is its own reverse. Keeps a reference to `cost`.
  TourProblem(const ConnectionCost& cost, std::size_t n);
  /// `patterns`: how many each element has; `reverse` and `inner` (the cost of driving it) by pattern. `inner` may be
  /// empty: all 0. Throws std::invalid_argument for an element without a pattern, or a reverse in another element.
  TourProblem(const ConnectionCost& cost, const std::vector<std::size_t>& patterns, std::vector<PatternId> reverse,
              std::vector<double> inner = {});

  /// Element `first` must be driven before element `later`. Throws std::invalid_argument for element 0 or itself;
  /// cycles are found by whoever solves the problem.
  void require_before(ElementId first, ElementId later);

  std::size_t elements() const { return first_.size() - 1; }
  std::size_t patterns() const { return element_of_.size(); }
  PatternId first_pattern(ElementId e) const { return first_[e]; }
  PatternId end_pattern(ElementId e) const { return first_[e + 1]; }
  std::size_t pattern_count(ElementId e) const { return first_[e + 1] - first_[e]; }
  ElementId element_of(PatternId p) const { return element_of_[p]; }
  PatternId reverse(PatternId p) const { return reverse_[p]; }
  double inner(PatternId p) const { return inner_[p]; }
  double connection(PatternId from, PatternId to) const { return (*cost_)(from, to); }
  const ConnectionCost& connections() const { return *cost_; }
  /// A run of elements can be driven backwards at the same cost.
  bool symmetric() const { return symmetric_; }
  /// Some element can be driven otherwise than in one pattern and its reverse (which reversing a run chooses between).
  bool has_choice() const { return has_choice_; }
  /// Element 0 is a pattern and its reverse, and tours are driven so that it is in the first.
  bool has_direction() const { return pattern_count(0) == 2 && reverse_[0] == 1; }
  bool has_precedence() const { return has_precedence_; }
  /// The elements that must be driven before e, and those after it, as required directly.
  std::span<const ElementId> before(ElementId e) const { return before_[e]; }
  std::span<const ElementId> after(ElementId e) const { return after_[e]; }

  PatternId pattern_of(const TourStop& s) const { return first_[s.element] + static_cast<PatternId>(s.pattern); }
  TourStop stop_of(PatternId p) const { return {element_of_[p], p - first_[element_of_[p]]}; }
  /// Patterns and connections, the one back to the first element included.
  double cost(const Tour& tour) const;

 private:
  void check_patterns() const;

  const ConnectionCost* cost_;
  std::vector<PatternId> first_{0};
  std::vector<ElementId> element_of_;
  std::vector<PatternId> reverse_;
  std::vector<double> inner_;
  std::vector<std::vector<ElementId>> before_, after_;
  bool symmetric_ = false, has_choice_ = false, has_precedence_ = false;
};

}  // namespace oxturn
