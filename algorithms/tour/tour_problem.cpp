#include "algorithms/tour/tour_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace oxturn {
namespace {

std::vector<PatternId> own_reverse(std::size_t n) {
  std::vector<PatternId> reverse(n);
  std::iota(reverse.begin(), reverse.end(), PatternId{0});
  return reverse;
}

}  // namespace

TourProblem::TourProblem(const ConnectionCost& cost, std::size_t n)
    : TourProblem(cost, std::vector<std::size_t>(n, 1), own_reverse(n)) {}

TourProblem::TourProblem(const ConnectionCost& cost, const std::vector<std::size_t>& patterns,
                         std::vector<PatternId> reverse, std::vector<double> inner)
    : cost_(&cost),
      reverse_(std::move(reverse)),
      inner_(std::move(inner)),
      before_(patterns.size()),
      after_(patterns.size()) {
  for (std::size_t e = 0; e < patterns.size(); ++e) {
    first_.push_back(first_.back() + static_cast<PatternId>(patterns[e]));
    element_of_.insert(element_of_.end(), patterns[e], static_cast<ElementId>(e));
  }
  if (inner_.empty()) inner_.assign(element_of_.size(), 0.0);
  check_patterns();
  symmetric_ = std::find(reverse_.begin(), reverse_.end(), kNoPattern) == reverse_.end() && cost.symmetric(reverse_);
  for (std::size_t e = 0; e < patterns.size(); ++e) {
    const bool pair = patterns[e] == 2 && reverse_[first_[e]] == first_[e] + 1;
    if (patterns[e] > 1 && !(pair && symmetric_)) has_choice_ = true;
  }
}

void TourProblem::check_patterns() const {
  if (elements() == 0) throw std::invalid_argument("a tour without elements; expected at least one");
  if (reverse_.size() != patterns() || inner_.size() != patterns())
    throw std::invalid_argument(fmt::format("{} patterns have {} reverse patterns and {} costs, expected one each",
                                            patterns(), reverse_.size(), inner_.size()));
  for (ElementId e = 0; e < elements(); ++e)
    if (pattern_count(e) == 0) throw std::invalid_argument(fmt::format("element {} of a tour has no pattern", e));
  for (PatternId p = 0; p < patterns(); ++p)
    if (reverse_[p] != kNoPattern &&
        (reverse_[p] >= patterns() || element_of_[reverse_[p]] != element_of_[p] || reverse_[reverse_[p]] != p))
      throw std::invalid_argument(
          fmt::format("the reverse of pattern {} is {}, expected a pattern of its element {} "
                      "with the reverse {}",
                      p, reverse_[p], element_of_[p], p));
}

void TourProblem::require_before(ElementId first, ElementId later) {
  if (first == 0 || later == 0 || first == later || first >= elements() || later >= elements())
    throw std::invalid_argument(
        fmt::format("element {} cannot be required before element {}: expected two of the elements 1 to {}", first,
                    later, elements() - 1));
  before_[later].push_back(first);
  after_[first].push_back(later);
  has_precedence_ = true;
}

double TourProblem::cost(const Tour& tour) const {
  double sum = 0;
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const PatternId p = pattern_of(tour[i]);
    sum += inner_[p];
    if (tour.size() > 1) sum += connection(p, pattern_of(tour[i + 1 < tour.size() ? i + 1 : 0]));
  }
  return sum;
}

}  // namespace oxturn
