#include "algorithms/tour/solve_tour.hpp"

#include <algorithm>

#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/kick.hpp"
#include "algorithms/tour/pattern_choice.hpp"
#include "algorithms/tour/tour_moves.hpp"
#include "algorithms/tour/tour_start.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

/// Of a typical difference between neighbours' costs. In the plane, at 1000 points and 10^5 kicks: 0: 1.12 % above the
/// Held-Karp bound, 0.1: 1.09 %, 0.35: 0.94 %, 0.7: 0.97 %.
constexpr double kWarmth = 0.35;
constexpr std::size_t kPatternsNear = 10;          // elements before and after a kick
constexpr std::uint64_t kLooksBetweenClocks = 64;  // elements looked at between looks at the clock
constexpr std::size_t kMostForAssignment = 3000;   // elements: O(n^2) memory

/// How much of the effort is spent.
class Schedule {
 public:
  Schedule(const TourEffort& effort, std::size_t elements, const Context& context)
      : context_(context), elements_(elements), kicks_(effort.kicks_for(elements)), by_time_(effort.until_deadline) {
    seconds_ = context.seconds_left();
  }
  /// A check costs O(n).
  std::uint64_t kicks_between_checks() const { return std::max<std::uint64_t>(100, elements_ / 8); }
  double share(std::uint64_t kick) const {
    if (by_time_) return seconds_ > 0 ? 1 - context_.seconds_left() / seconds_ : 1;
    return kicks_ > 0 ? static_cast<double>(kick) / static_cast<double>(kicks_) : 1;
  }

 private:
  const Context& context_;
  std::size_t elements_;
  std::uint64_t kicks_;
  bool by_time_;
  double seconds_;
};

/// The median, over patterns, of the difference between the second and the sixth neighbour.
double typical_difference(const TourProblem& problem, const NeighbourLists& lists) {
  std::vector<double> differences;
  for (PatternId p = 0; p < problem.patterns(); ++p) {
    const auto list = lists.after(p);
    const auto at = [&](std::size_t k) { return list[std::min(k, list.size() - 1)].cost; };
    differences.push_back(at(5) - at(1));
  }
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  return *middle;
}

class IteratedSearch {
 public:
  IteratedSearch(const TourProblem& problem, const NeighbourLists& lists, const Tour& tour, Context& context,
                 const TourEffort& effort)
      : problem_(problem), context_(context), effort_(effort), state_(problem, tour), search_(problem, lists, state_) {}

  /// To a tour that no move makes cheaper, in the best patterns for its order.
  void descend() {
    for (std::size_t i = 0; i < state_.size(); ++i) search_.queue.push(state_.at(i));
    empty_queue();
    while (problem_.has_choice() && choose_patterns() && !ended()) empty_queue();
    state_.commit();
    keep_if_best({});
  }

  void kick_and_search() {
    const Schedule schedule(effort_, state_.size(), context_);
    const double warmth = kWarmth * typical_difference(problem_, search_.lists);
    double temperature = warmth;
    for (std::uint64_t k = 0; schedule.share(k) < 1 && !ended(); ++k) {
      if (k % schedule.kicks_between_checks() == 0) {
        keep_if_best(effort_.improved);
        temperature = warmth * (1 - schedule.share(k));
      }
      search_.gained = 0;
      const auto middle = kick(search_, context_.rng());
      if (!middle) continue;
      empty_queue();
      while (problem_.has_choice() && choose_patterns_near(*middle)) empty_queue();
      // As in simulated annealing (Kirkpatrick, Gelatt and Vecchi 1983): a little dearer is accepted at first.
      if (search_.gained >= 0 || search_.gained > temperature * math::log(1 - context_.rng().unit()))
        state_.commit();
      else
        state_.undo();
    }
    keep_if_best(effort_.improved);
  }

  /// The best tour of those seen at checks.
  const Tour& best() const { return best_; }

 private:
  bool ended() const { return context_.cancelled() || (effort_.enough && effort_.enough()); }

  bool improve(ElementId a) {
    if (problem_.has_choice() && (change_pattern(search_, a) || reinsert(search_, a))) return true;
    if (problem_.symmetric()) return three_opt(search_, a, false) || three_opt(search_, a, true);
    return or_three_opt(search_, a);
  }

  void empty_queue() {
    while (const auto a = search_.queue.pop()) {
      while (improve(*a)) {}
      if (++looked_at_ % kLooksBetweenClocks == 0 && ended()) search_.queue.clear();
    }
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

  /// The best patterns of the elements around e, element 0 apart. True if they have changed.
  bool choose_patterns_near(ElementId e) {
    if (e == 0) return false;
    ElementId first = e, end = state_.next(e);
    for (std::size_t k = 0; k < kPatternsNear && state_.previous(first) != 0; ++k) first = state_.previous(first);
    for (std::size_t k = 0; k < kPatternsNear && end != 0; ++k) end = state_.next(end);
    std::vector<ElementId> run;
    for (ElementId x = first; x != end; x = state_.next(x)) run.push_back(x);
    const ElementId before = state_.previous(first);
    double present = search_.connection(state_.pattern(before), state_.pattern(first));
    for (const ElementId x : run)
      present +=
          problem_.inner(state_.pattern(x)) + search_.connection(state_.pattern(x), state_.pattern(state_.next(x)));
    const double best = best_patterns_between(problem_, state_.pattern(before), run, state_.pattern(end), chosen_);
    if (!MoveSearch::better(present, best)) return false;
    for (std::size_t i = 0; i < run.size(); ++i) {
      if (chosen_[i] == state_.pattern(run[i])) continue;
      state_.set_pattern(run[i], chosen_[i]);
      search_.push({state_.previous(run[i]), run[i], state_.next(run[i])});
    }
    search_.gained += present - best;
    return true;
  }

  void keep_if_best(const std::function<void(const Tour&)>& improved) {
    Tour tour = state_.tour();
    const double cost = problem_.cost(tour);
    if (!best_.empty() && !MoveSearch::better(best_cost_, cost)) return;
    best_ = std::move(tour);
    best_cost_ = cost;
    if (improved) improved(best_);
  }

  const TourProblem& problem_;
  Context& context_;
  const TourEffort& effort_;
  TourState state_;
  MoveSearch search_;
  std::uint64_t looked_at_ = 0;  // elements
  std::vector<PatternId> chosen_;
  Tour best_;
  double best_cost_ = 0;
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
  IteratedSearch search(problem, lists, first, context, effort);
  search.descend();
  search.kick_and_search();
  if (!problem.has_choice()) return search.best();
  return best_patterns(problem, search.best());
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
