#include <algorithm>
#include <array>

#include "algorithms/tour/tour_start.hpp"
#include "algorithms/tour/tour_state.hpp"
#include "base/disjoint_sets.hpp"

namespace oxturn {
namespace {

using Port = PatternId;  // one end of a pattern

/// Paths of elements that grow together. In symmetric problems an exit is also the entry of the reverse pattern, so
/// links have no direction; a pattern that is its own reverse has both its links at one port.
class Paths {
 public:
  explicit Paths(const TourProblem& problem)
      : problem_(problem),
        partners_(2 * problem.patterns(), {kNoPattern, kNoPattern}),
        chosen_(problem.elements(), kNoPattern),
        sets_(problem.elements()) {}

  bool entry_free(PatternId q) const { return fits(q) && free(entry(q), q); }
  bool exit_free(PatternId p) const { return fits(p) && free(p, p); }
  bool same_path(ElementId e, ElementId f) { return sets_.same(e, f); }
  /// Links p -> q if both ends are free and no cycle is closed.
  void link(PatternId p, PatternId q) {
    const ElementId e = problem_.element_of(p), f = problem_.element_of(q);
    if (!exit_free(p) || !entry_free(q) || !sets_.unite(e, f)) return;
    if (chosen_[e] == kNoPattern) chosen_[e] = p;
    if (chosen_[f] == kNoPattern) chosen_[f] = q;
    add(p, entry(q));
    add(entry(q), p);
  }
  /// The patterns of a path that is entered by q.
  std::vector<PatternId> from(PatternId q) const {
    std::vector<PatternId> all{q};
    for (Port came_from = kNoPattern;;) {
      const PatternId at = all.back();
      const auto& [a, b] = partners_[at];
      const Port to = a == came_from ? b : a;
      if (to == kNoPattern) return all;
      came_from = at;
      all.push_back(problem_.symmetric() ? problem_.reverse(to) : to - static_cast<Port>(problem_.patterns()));
    }
  }

 private:
  Port entry(PatternId q) const {
    return problem_.symmetric() ? problem_.reverse(q) : q + static_cast<Port>(problem_.patterns());
  }
  bool fits(PatternId p) const {
    const PatternId c = chosen_[problem_.element_of(p)];
    return c == kNoPattern || c == p || (problem_.symmetric() && problem_.reverse(c) == p);
  }
  bool free(Port port, PatternId p) const {
    const bool both_ends = problem_.symmetric() && problem_.reverse(p) == p;
    return partners_[port][both_ends ? 1 : 0] == kNoPattern;
  }
  void add(Port port, Port partner) {
    auto& [a, b] = partners_[port];
    (a == kNoPattern ? a : b) = partner;
  }

  const TourProblem& problem_;
  std::vector<std::array<Port, 2>> partners_;  // by port
  std::vector<PatternId> chosen_;              // by element, if it is linked
  DisjointSets sets_;
};

void link_cheapest(Paths& paths, const TourProblem& problem, const NeighbourLists& lists) {
  struct Link {
    double cost;
    PatternId from, to;
    auto operator<=>(const Link&) const = default;
  };
  std::vector<Link> links;
  for (PatternId p = 0; p < problem.patterns(); ++p)
    for (const Neighbour& n : lists.after(p)) links.push_back({n.cost, p, n.pattern});
  std::sort(links.begin(), links.end());
  for (const Link& l : links) paths.link(l.from, l.to);
}

}  // namespace

Tour greedy_tour(const TourProblem& problem, const NeighbourLists& lists) {
  Paths paths(problem);
  link_cheapest(paths, problem, lists);
  std::vector<PatternId> entries;
  for (PatternId q = 0; q < problem.patterns(); ++q)
    if (paths.entry_free(q)) entries.push_back(q);
  PatternId next = *std::find_if(entries.begin(), entries.end(),
                                 [&](PatternId q) { return paths.same_path(problem.element_of(q), 0); });
  Tour tour;
  while (true) {
    const std::vector<PatternId> path = paths.from(next);
    for (const PatternId p : path) tour.push_back(problem.stop_of(p));
    if (tour.size() == problem.elements()) return TourState(problem, tour).tour();
    const ElementId done = problem.element_of(next);
    std::erase_if(entries, [&](PatternId q) { return paths.same_path(problem.element_of(q), done); });
    double least = 0;
    next = kNoPattern;
    for (const PatternId q : entries)
      if (const double cost = problem.connection(path.back(), q); next == kNoPattern || cost < least) {
        next = q;
        least = cost;
      }
  }
}

}  // namespace oxturn
