#include "algorithms/tour/exact_tour.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace oxturn {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr std::size_t kMostElements = 20;

/// Element e > 0 is bit e - 1 of a set.
class SubsetTable {
 public:
  explicit SubsetTable(const TourProblem& problem)
      : problem_(problem), sets_(std::size_t{1} << (problem.elements() - 1)), patterns_(problem.patterns()) {
    for (ElementId e = 1; e < problem.elements(); ++e) {
      std::size_t needed = 0;
      for (const ElementId sooner : problem.before(e)) needed |= std::size_t{1} << (sooner - 1);
      needed_.push_back(needed);
    }
  }

  /// The least cost of a tour that begins with the pattern `root` of element 0.
  double solve(PatternId root) {
    cost_.assign(sets_ * patterns_, kNone);
    from_.assign(sets_ * patterns_, kNoPattern);
    cost_[root] = problem_.inner(root);
    for (std::size_t set = 0; set < sets_; ++set)
      for (PatternId p = 0; p < patterns_; ++p)
        if (cost_[set * patterns_ + p] < kNone) extend(set, p);
    double least = kNone;
    for (PatternId p = 0; p < patterns_; ++p) {
      const double so_far = cost_[(sets_ - 1) * patterns_ + p];
      if (so_far == kNone) continue;
      const double cost = so_far + (problem_.elements() > 1 ? problem_.connection(p, root) : 0.0);
      if (cost >= least) continue;
      least = cost;
      last_ = p;
    }
    return least;
  }
  /// The tour of the last solve().
  Tour tour() const {
    Tour tour(problem_.elements());
    std::size_t set = sets_ - 1;
    PatternId p = last_;
    for (std::size_t i = tour.size(); i-- > 0;) {
      tour[i] = problem_.stop_of(p);
      const PatternId before = from_[set * patterns_ + p];
      if (i > 0) set &= ~(std::size_t{1} << (problem_.element_of(p) - 1));
      p = before;
    }
    return tour;
  }

 private:
  void extend(std::size_t set, PatternId p) {
    const double so_far = cost_[set * patterns_ + p];
    for (ElementId e = 1; e < problem_.elements(); ++e) {
      const std::size_t bit = std::size_t{1} << (e - 1);
      if ((set & bit) != 0 || (needed_[e - 1] & ~set) != 0) continue;
      for (PatternId q = problem_.first_pattern(e); q < problem_.end_pattern(e); ++q) {
        const double cost = so_far + problem_.connection(p, q) + problem_.inner(q);
        const std::size_t state = (set | bit) * patterns_ + q;
        if (cost >= cost_[state]) continue;
        cost_[state] = cost;
        from_[state] = p;
      }
    }
  }

  const TourProblem& problem_;
  std::size_t sets_, patterns_;
  std::vector<std::size_t> needed_;  // by element: those before it
  std::vector<double> cost_;         // by set and last pattern
  std::vector<PatternId> from_;
  PatternId last_ = 0;
};

}  // namespace

bool exact_tour_is_cheap(const TourProblem& problem) {
  constexpr double kMostCosts = 1e8;
  if (problem.elements() > 13) return false;
  const double patterns = static_cast<double>(problem.patterns());
  const double roots = problem.has_direction() ? 1 : static_cast<double>(problem.pattern_count(0));
  return std::ldexp(roots * patterns * patterns, static_cast<int>(problem.elements()) - 1) <= kMostCosts;
}

Tour exact_tour(const TourProblem& problem) {
  if (problem.elements() > kMostElements)
    throw std::invalid_argument(fmt::format("{} elements are too many for an exact tour, expected at most {}",
                                            problem.elements(), kMostElements));
  SubsetTable table(problem);
  double least = kNone;
  Tour best;
  for (PatternId root = problem.first_pattern(0); root < problem.end_pattern(0); ++root) {
    if (problem.has_direction() && root != problem.first_pattern(0)) continue;
    const double cost = table.solve(root);
    if (cost >= least) continue;
    least = cost;
    best = table.tour();
  }
  if (best.empty())
    throw std::invalid_argument("elements of a tour are required before each other in a cycle; remove one requirement");
  return best;
}

}  // namespace oxturn
