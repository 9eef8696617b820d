#include "algorithms/tour/node_matrix.hpp"

#include <algorithm>
#include <stdexcept>

namespace oxturn {
namespace {

/// Patterns that tours may use: of element 0, if its second only says that the tour is driven backwards, the first.
PatternId end_pattern(const TourProblem& problem, ElementId e) {
  return e == 0 && problem.has_direction() ? 1 : problem.end_pattern(e);
}

/// More than all connections and patterns of any tour cost together.
double enough(const TourProblem& problem) {
  double most = 0;
  for (PatternId p = 0; p < problem.patterns(); ++p)
    for (PatternId q = 0; q < problem.patterns(); ++q)
      if (problem.element_of(p) != problem.element_of(q))
        if (const double c = problem.connection(p, q) + problem.inner(p); c < kForbidden) most = std::max(most, c);
  return static_cast<double>(problem.elements() + 1) * (most + 1);
}

/// The cost of an element in its cheapest pattern: every tour pays it, so it stays out of the matrix.
double least_inner(const TourProblem& problem, ElementId e) {
  double least = problem.inner(problem.first_pattern(e));
  for (PatternId p = problem.first_pattern(e); p < problem.end_pattern(e); ++p)
    least = std::min(least, problem.inner(p));
  return least;
}

NodeMatrix begin(const TourProblem& problem, std::size_t nodes, ElementConstant constant) {
  if (problem.has_precedence())
    throw std::invalid_argument(
        "a matrix of costs cannot express that one element comes before another; "
        "remove precedence or solve the problem itself");
  NodeMatrix m;
  m.nodes = nodes;
  m.costs.assign(nodes * nodes, kForbidden);
  if (constant == ElementConstant::enough) m.between = enough(problem);
  m.surplus = m.between * static_cast<double>(problem.elements());
  for (ElementId e = 0; e < problem.elements(); ++e) m.surplus -= least_inner(problem, e);
  return m;
}

/// Nodes where a tour enters and leaves an element in a pattern.
struct Doors {
  std::vector<std::size_t> in, out;  // by pattern
};

/// Connections from the leaving nodes of one element to the entering nodes of another.
void connect(const TourProblem& problem, const Doors& doors, NodeMatrix& m) {
  for (ElementId e = 0; e < problem.elements(); ++e) {
    const double least = least_inner(problem, e);
    for (ElementId f = 0; f < problem.elements(); ++f)
      for (PatternId p = problem.first_pattern(e); e != f && p < end_pattern(problem, e); ++p)
        for (PatternId q = problem.first_pattern(f); q < end_pattern(problem, f); ++q)
          m.costs[doors.out[p] * m.nodes + doors.in[q]] =
              problem.connection(p, q) + problem.inner(p) - least + m.between;
  }
}

}  // namespace

double NodeMatrix::cost(const std::vector<std::size_t>& order) const {
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i) sum += costs[order[i] * nodes + order[(i + 1) % order.size()]];
  return sum;
}

Tour NodeMatrix::tour_of(const std::vector<std::size_t>& order, const TourProblem& problem) const {
  Tour tour;
  std::vector<bool> seen(problem.elements(), false);
  for (const std::size_t node : order) {
    if (seen[element[node]]) continue;
    seen[element[node]] = true;
    tour.push_back(problem.stop_of(pattern[node]));
  }
  return tour;
}

NodeMatrix weight_shifted(const TourProblem& problem, ElementConstant constant) {
  std::size_t nodes = 0;
  Doors doors{std::vector<std::size_t>(problem.patterns()), std::vector<std::size_t>(problem.patterns())};
  NodeMatrix owners;
  for (ElementId e = 0; e < problem.elements(); ++e) {
    const PatternId first = problem.first_pattern(e), end = end_pattern(problem, e);
    for (PatternId p = first; p < end; ++p) {
      doors.in[p] = nodes + (p - first);
      doors.out[p] = nodes + (p == first ? end - 1 - first : p - 1 - first);
      owners.pattern.push_back(p);
      owners.element.push_back(e);
    }
    nodes += end - first;
  }
  NodeMatrix m = begin(problem, nodes, constant);
  m.pattern = owners.pattern;
  m.element = owners.element;
  for (PatternId p = 0; p < problem.patterns(); ++p)
    if (p < end_pattern(problem, problem.element_of(p)) && doors.in[p] != doors.out[p])
      m.costs[doors.out[p] * nodes + doors.in[p]] = 0;  // from the node before to this one
  connect(problem, doors, m);
  return m;
}

NodeMatrix double_cities(const TourProblem& problem, ElementConstant constant) {
  std::size_t nodes = 0;
  Doors doors{std::vector<std::size_t>(problem.patterns()), std::vector<std::size_t>(problem.patterns())};
  NodeMatrix owners;
  for (ElementId e = 0; e < problem.elements(); ++e) {
    const bool alone = end_pattern(problem, e) == problem.first_pattern(e) + 1;
    for (PatternId p = problem.first_pattern(e); p < end_pattern(problem, e); ++p) {
      doors.in[p] = nodes;
      doors.out[p] = alone ? nodes : nodes + 1;
      for (; nodes <= doors.out[p]; ++nodes) {
        owners.pattern.push_back(p);
        owners.element.push_back(e);
      }
    }
  }
  NodeMatrix m = begin(problem, nodes, constant);
  m.pattern = owners.pattern;
  m.element = owners.element;
  for (ElementId e = 0; e < problem.elements(); ++e) {
    const PatternId first = problem.first_pattern(e), end = end_pattern(problem, e);
    for (PatternId p = first; p < end && end > first + 1; ++p) {
      // Entered at p: out and in of the next pattern, and so on; out of p comes last.
      const PatternId next = p + 1 == end ? first : p + 1;
      m.costs[doors.in[p] * nodes + doors.out[next]] = 0;
      m.costs[doors.out[p] * nodes + doors.in[p]] = 0;
    }
  }
  connect(problem, doors, m);
  return m;
}

}  // namespace oxturn
