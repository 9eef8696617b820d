#include <algorithm>
#include <limits>

#include "algorithms/tour/exact_tour.hpp"

namespace oxturn {
namespace {

class BranchAndBound {
 public:
  BranchAndBound(const TourProblem& problem, std::uint64_t most_nodes)
      : problem_(problem), most_nodes_(most_nodes), visited_(problem.elements(), false) {}

  BoundedTour run() {
    for (PatternId root = problem_.first_pattern(0); root < problem_.end_pattern(0); ++root) {
      if (problem_.has_direction() && root != problem_.first_pattern(0)) continue;
      path_ = {root};
      visited_[0] = true;
      descend(problem_.inner(root));
    }
    best_.proven = best_.nodes < most_nodes_;
    return best_;
  }

 private:
  bool allowed(ElementId e) const {
    const auto before = problem_.before(e);
    return !visited_[e] && std::all_of(before.begin(), before.end(), [&](ElementId b) { return visited_[b]; });
  }

  void descend(double cost) {
    const PatternId at = path_.back();
    if (path_.size() == problem_.elements()) {
      if (path_.size() > 1) cost += problem_.connection(at, path_.front());
      if (cost >= least_) return;
      least_ = cost;
      best_.tour.clear();
      for (const PatternId p : path_) best_.tour.push_back(problem_.stop_of(p));
      return;
    }
    std::vector<std::pair<double, PatternId>> offers;
    for (ElementId e = 1; e < problem_.elements(); ++e)
      if (allowed(e))
        for (PatternId q = problem_.first_pattern(e); q < problem_.end_pattern(e); ++q)
          offers.push_back({problem_.connection(at, q) + problem_.inner(q), q});
    std::sort(offers.begin(), offers.end());
    for (const auto& [step, q] : offers) {
      if (cost + step >= least_ || best_.nodes >= most_nodes_) return;
      ++best_.nodes;
      path_.push_back(q);
      visited_[problem_.element_of(q)] = true;
      descend(cost + step);
      visited_[problem_.element_of(q)] = false;
      path_.pop_back();
    }
  }

  const TourProblem& problem_;
  std::uint64_t most_nodes_;
  std::vector<bool> visited_;
  std::vector<PatternId> path_;
  double least_ = std::numeric_limits<double>::infinity();
  BoundedTour best_;
};

}  // namespace

BoundedTour branch_and_bound_tour(const TourProblem& problem, std::uint64_t most_nodes) {
  return BranchAndBound(problem, std::max<std::uint64_t>(most_nodes, problem.elements())).run();
}

}  // namespace oxturn
