#include "algorithms/tour/solve_tour.hpp"

#include <algorithm>

#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/kick.hpp"
#include "algorithms/tour/pattern_choice.hpp"
#include "algorithms/tour/tour_moves.hpp"
#include "algorithms/tour/tour_start.hpp"

namespace oxturn {
namespace {

constexpr std::uint64_t kKicksBetweenReports = 100;
constexpr std::size_t kMostForAssignment = 3000;  // elements: O(n^2) memory

class IteratedSearch {
 public:
  IteratedSearch(const TourProblem& problem, const NeighbourLists& lists, const Tour& tour, Context& context)
      : problem_(problem), context_(context), state_(problem, tour), search_(problem, lists, state_) {}

  /// To a tour that no move makes cheaper, in the best patterns for its order.
  void descend() {
    for (std::size_t i = 0; i < state_.size(); ++i) search_.queue.push(state_.at(i));
    empty_queue();
    while (problem_.has_choice() && choose_patterns() && !context_.cancelled()) empty_queue();
    state_.commit();
  }

  void kick_and_search(std::uint64_t kicks, const std::function<void(const Tour&)>& improved) {
    double gained = 0;
    for (std::uint64_t k = 0; k < kicks && !context_.cancelled(); ++k) {
      search_.gained = 0;
      if (kick(search_, context_.rng())) empty_queue();
      if (search_.gained >= 0) {
        state_.commit();
        gained += search_.gained;
      } else {
        state_.undo();
      }
      if (improved && gained > 0 && k % kKicksBetweenReports == 0) {
        improved(state_.tour());
        gained = 0;
      }
    }
  }

  Tour tour() const { return state_.tour(); }

 private:
  bool improve(ElementId a) {
    if (problem_.has_choice() && (change_pattern(search_, a) || reinsert(search_, a))) return true;
    if (problem_.symmetric()) return three_opt(search_, a, false) || three_opt(search_, a, true);
    return or_three_opt(search_, a);
  }

  void empty_queue() {
    while (const auto a = search_.queue.pop())
      while (improve(*a)) {}
  }

  /// True if patterns have changed.
  bool choose_patterns() {
    const Tour before = state_.tour(), after = best_patterns(problem_, before);
    if (!MoveSearch::better(problem_.cost(before), problem_.cost(after))) return false;
    state_ = TourState(problem_, after);
    for (std::size_t i = 0; i < after.size(); ++i)
      if (after[i].pattern != before[i].pattern) {
        const auto e = static_cast<ElementId>(after[i].element);
        search_.push({state_.previous(e), e, state_.next(e)});
      }
    return true;
  }

  const TourProblem& problem_;
  Context& context_;
  TourState state_;
  MoveSearch search_;
};

/// The cheapest of the tours that suit the problem.
Tour first_tour(const TourProblem& problem, const NeighbourLists& lists) {
  if (problem.has_precedence()) return nearest_neighbour_tour(problem);
  Tour tour = greedy_tour(problem, lists);
  if (problem.symmetric() || problem.patterns() > problem.elements() || problem.elements() > kMostForAssignment)
    return tour;
  Tour patched = patched_assignment_tour(problem);
  return problem.cost(patched) < problem.cost(tour) ? patched : tour;
}

Tour search(const TourProblem& problem, const NeighbourLists& lists, const Tour& first, Context& context,
            const TourEffort& effort) {
  IteratedSearch search(problem, lists, first, context);
  search.descend();
  search.kick_and_search(effort.kicks_for(problem.elements()), effort.improved);
  if (problem.has_choice()) search.descend();
  return search.tour();
}

NeighbourLists lists_for(const TourProblem& problem, const TourEffort& effort) {
  return {problem, effort.neighbours + (problem.symmetric() ? 0 : 2)};
}

}  // namespace

std::uint64_t TourEffort::kicks_for(std::size_t elements) const {
  return kicks ? *kicks : std::max<std::uint64_t>(20 * elements, 20000);
}

Tour improved_tour(const TourProblem& problem, const Tour& tour, Context& context, const TourEffort& effort) {
  const Tour first = best_patterns(problem, tour);
  return problem.elements() < 4 ? first : search(problem, lists_for(problem, effort), first, context, effort);
}

Tour solve_tour(const TourProblem& problem, Context& context, const TourEffort& effort) {
  Tour tour;
  if (problem.elements() < 4 || (effort.exact_if_small && exact_tour_is_cheap(problem))) {
    tour = exact_tour(problem);
  } else {
    const NeighbourLists lists = lists_for(problem, effort);
    tour = search(problem, lists, first_tour(problem, lists), context, effort);
  }
  if (problem.cost(tour) >= kForbidden / 2)
    throw Infeasible("no tour was found that does without forbidden connections");
  return tour;
}

}  // namespace oxturn
