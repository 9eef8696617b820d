#include "algorithms/tour/neighbour_lists.hpp"

#include <algorithm>
#include <optional>

#include "algorithms/tour/quadrant_tree.hpp"
#include "geometry/point_grid.hpp"

namespace oxturn {
namespace {

bool cheaper(const Neighbour& a, const Neighbour& b) {
  return a.cost != b.cost ? a.cost < b.cost : a.element < b.element;
}

double cost_between(const TourProblem& problem, PatternId p, PatternId other, bool after) {
  return after ? problem.connection(p, other) : problem.connection(other, p);
}

Neighbour best_pattern(const TourProblem& problem, PatternId p, ElementId e, bool after) {
  Neighbour best{cost_between(problem, p, problem.first_pattern(e), after), e, problem.first_pattern(e)};
  for (PatternId q = problem.first_pattern(e) + 1; q < problem.end_pattern(e); ++q)
    if (const double cost = cost_between(problem, p, q, after); cost < best.cost) best = {cost, e, q};
  return best;
}

void keep_cheapest(std::vector<Neighbour>& list, std::size_t k) {
  const auto end = list.begin() + static_cast<std::ptrdiff_t>(std::min(k, list.size()));
  std::partial_sort(list.begin(), end, list.end(), cheaper);
  list.erase(end, list.end());
}

/// Candidates by straight distance. Element 0 may be near to all others, wherever it is.
class NearElements {
 public:
  NearElements(const TourProblem& problem, bool after)
      : problem_(problem),
        after_(after),
        seen_(problem.elements(), kNoPattern),
        grid_(points(problem, after)),
        quadrants_(points(problem, after)) {}

  /// The k cheapest of the nearest, and the nearest in each quadrant, which lead from one cluster of points to others.
  std::vector<Neighbour> around(PatternId p, std::size_t k) {
    const Point at = position(p);
    const ElementId own = problem_.element_of(p);
    found_.clear();
    seen_[own] = seen_[0] = p;
    if (own != 0) found_.push_back(best_pattern(problem_, p, 0, after_));
    // Twice as many by distance as are kept by cost: the two orders differ somewhat.
    grid_.visit(at, [&](std::size_t q, double) {
      add(p, problem_.element_of(static_cast<PatternId>(q)));
      return found_.size() < 2 * k;
    });
    keep_cheapest(found_, k);
    for (const std::size_t q : quadrants_.nearest(
             at, [&](std::size_t other) { return problem_.element_of(static_cast<PatternId>(other)) != own; })) {
      const ElementId e = problem_.element_of(static_cast<PatternId>(q));
      if (std::none_of(found_.begin(), found_.end(), [&](const Neighbour& n) { return n.element == e; }))
        found_.push_back(best_pattern(problem_, p, e, after_));
    }
    std::sort(found_.begin(), found_.end(), cheaper);
    return found_;
  }

 private:
  void add(PatternId p, ElementId e) {
    if (seen_[e] == p) return;
    seen_[e] = p;
    found_.push_back(best_pattern(problem_, p, e, after_));
  }
  const Point& position(PatternId p) const {
    const auto& ends = (*problem_.connections().ends())[p];
    return after_ ? ends.exit : ends.entry;
  }
  static std::vector<Point> points(const TourProblem& problem, bool after) {
    std::vector<Point> all;
    for (const auto& e : *problem.connections().ends()) all.push_back(after ? e.entry : e.exit);
    return all;
  }

  const TourProblem& problem_;
  bool after_;
  std::vector<PatternId> seen_;  // by element: the pattern whose neighbours it was met among
  PointGrid grid_;
  QuadrantTree quadrants_;
  std::vector<Neighbour> found_;
};

std::vector<Neighbour> all_others(const TourProblem& problem, PatternId p, std::size_t k, bool after) {
  std::vector<Neighbour> all;
  for (ElementId e = 0; e < problem.elements(); ++e)
    if (e != problem.element_of(p)) all.push_back(best_pattern(problem, p, e, after));
  keep_cheapest(all, k);
  return all;
}

}  // namespace

NeighbourLists::NeighbourLists(const TourProblem& problem, std::size_t k)
    : after_(build(problem, k, true)), before_(problem.symmetric() ? Lists{} : build(problem, k, false)) {
  if (!problem.symmetric()) return;
  before_.first.assign(1, 0);
  for (PatternId p = 0; p < problem.patterns(); ++p) {
    for (Neighbour n : after_.of(problem.reverse(p))) {
      n.pattern = problem.reverse(n.pattern);
      before_.all.push_back(n);
    }
    before_.first.push_back(before_.all.size());
  }
}

NeighbourLists::Lists NeighbourLists::build(const TourProblem& problem, std::size_t k, bool after) {
  Lists lists;
  std::optional<NearElements> near;
  if (problem.connections().ends() != nullptr) near.emplace(problem, after);
  for (PatternId p = 0; p < problem.patterns(); ++p) {
    const std::vector<Neighbour> list = near ? near->around(p, k) : all_others(problem, p, k, after);
    lists.all.insert(lists.all.end(), list.begin(), list.end());
    lists.first.push_back(lists.all.size());
  }
  return lists;
}

}  // namespace oxturn
