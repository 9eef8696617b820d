/// Generalised tours as plain asymmetric tours over nodes, for solvers that know nothing else.
///
///   const NodeMatrix m = weight_shifted(problem);
///   std::vector<std::size_t> order = ...;                    // by any solver: exact, LKH, ... from node 0 on
///   Tour tour = m.tour_of(order, problem);
///   problem.cost(tour) == m.cost(order) - m.surplus;         // for tours that visit each element in one run
#pragma once

#include <vector>

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

struct NodeMatrix {
  std::size_t nodes = 0;
  std::vector<double> costs;       // by rows
  std::vector<PatternId> pattern;  // of each node: how its element is driven if the tour enters it here
  std::vector<ElementId> element;  // of each node
  double between = 0;              // the constant M that is added to each connection between elements
  double surplus = 0;              // what every tour costs more than in the problem

  MatrixCost matrix() const { return {nodes, costs}; }
  double cost(const std::vector<std::size_t>& order) const;
  /// Back to elements: each is driven as the first of its nodes says. `order` begins with a node of element 0.
  Tour tour_of(const std::vector<std::size_t>& order, const TourProblem& problem) const;
};

/// The constant that is added to each connection between elements, M. Inside an element nodes follow one another at no
/// cost; without M a tour could leave an element, come back and use what remains as a free shortcut. As printed in
/// Vollprecht (2014) there is none. `enough`: more than all connections of a tour together cost (Noon and Bean 1993).
enum class ElementConstant { none, enough };

/// A node for each pattern; the nodes of an element form a cycle without cost, and what it costs to leave pattern i is
/// paid at the node before it, where a tour that has entered at i ends. O(patterns^2). Throws std::invalid_argument for
/// problems with precedence.
NodeMatrix weight_shifted(const TourProblem& problem, ElementConstant constant = ElementConstant::enough);
/// Two nodes for each pattern, to enter and to leave (elements of one pattern keep one node). The tour runs through all
/// of them and ends at the leaving node of the pattern that it has entered. The same costs, four times the matrix.
NodeMatrix double_cities(const TourProblem& problem, ElementConstant constant = ElementConstant::enough);

}  // namespace oxturn
