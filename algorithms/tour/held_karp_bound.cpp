#include "algorithms/tour/held_karp_bound.hpp"

#include <algorithm>
#include <limits>

#include "algorithms/tour/assignment.hpp"
#include "algorithms/tour/neighbour_lists.hpp"
#include "algorithms/tour/one_tree.hpp"
#include "algorithms/tour/tour_start.hpp"

namespace oxturn {
namespace {

constexpr int kSteps = 500;             // subgradient steps on one sparse graph
constexpr int kGraphs = 12;             // each with the edges that were missing in the one before
constexpr double kCloseEnough = 1e-5;   // of the bound: sparse and complete graph agree
constexpr std::size_t kEdgesAdded = 3;  // of each element
constexpr int kIdleSteps = 10;          // without a better bound: then steps become shorter
constexpr double kShorter = 0.7;
constexpr std::size_t kNeighbours = 8;
constexpr std::size_t kMostForMatrix = 3000;  // elements, for what takes O(n^2) memory

class Ascent {
 public:
  Ascent(const TourProblem& problem, double tour_cost)
      : problem_(problem), n_(problem.elements()), tour_cost_(tour_cost), leave_(n_, 0.0), enter_(n_, 0.0) {
    for (ElementId e = 0; e < n_; ++e) {
      double least = std::numeric_limits<double>::infinity();
      for (PatternId p = problem.first_pattern(e); p < problem.end_pattern(e); ++p)
        least = std::min(least, problem.inner(p));
      inner_ += least;
    }
    if (problem.patterns() > n_ && n_ <= kMostForMatrix) remember_arcs();
    build_graph();
    if (!problem.symmetric() && n_ <= kMostForMatrix) start_from_assignment();
  }

  double run() {
    double best = evaluate();
    for (int graph = 0; graph < kGraphs; ++graph) {
      const double sparse = climb();  // no bound yet: edges may be missing
      const double bound = evaluate();
      best = std::max(best, bound);
      if (sparse - bound <= kCloseEnough * bound) break;
    }
    return best;
  }

 private:
  double arc(ElementId a, ElementId b) const { return arcs_.empty() ? least_connection(a, b) : arcs_[a * n_ + b]; }
  /// The least cost over pairs of patterns, in one direction.
  double least_connection(ElementId a, ElementId b) const {
    double least = std::numeric_limits<double>::infinity();
    for (PatternId p = problem_.first_pattern(a); p < problem_.end_pattern(a); ++p)
      for (PatternId q = problem_.first_pattern(b); q < problem_.end_pattern(b); ++q)
        least = std::min(least, problem_.connection(p, q));
    return least;
  }
  /// An edge with prices, and whether its cheaper direction is from b to a.
  double priced(ElementId a, ElementId b, bool& turned) const {
    const double forwards = arc(a, b) + leave_[a] + enter_[b];
    if (problem_.symmetric()) return forwards;
    const double backwards = arc(b, a) + leave_[b] + enter_[a];
    turned = backwards < forwards;
    return std::min(forwards, backwards);
  }
  double priced(ElementId a, ElementId b) const {
    bool turned = false;
    return priced(a, b, turned);
  }
  double prices() const {
    double sum = 0;
    for (ElementId e = 0; e < n_; ++e) sum += leave_[e] + enter_[e];
    return sum;
  }

  void remember_arcs() {
    std::vector<double> arcs(n_ * n_, 0.0);
    for (ElementId a = 0; a < n_; ++a)
      for (ElementId b = 0; b < n_; ++b)
        if (a != b) arcs[a * n_ + b] = least_connection(a, b);
    arcs_ = std::move(arcs);
  }
  void add_edge(ElementId a, ElementId b) {
    if (a == b || std::find(graph_[a].begin(), graph_[a].end(), b) != graph_[a].end()) return;
    graph_[a].push_back(b);
    graph_[b].push_back(a);
  }
  void build_graph() {
    graph_.resize(n_);
    const NeighbourLists lists(problem_, kNeighbours);
    for (PatternId p = 0; p < problem_.patterns(); ++p)
      for (const Neighbour& n : lists.after(p)) add_edge(problem_.element_of(p), n.element);
    const Tour tour = greedy_tour(problem_, lists);  // so that the graph is connected
    for (std::size_t i = 0; i < n_; ++i)
      add_edge(static_cast<ElementId>(tour[i].element), static_cast<ElementId>(tour[(i + 1) % n_].element));
  }
  void start_from_assignment() {
    const Assignment dual = solve_assignment(n_, [&](std::size_t i, std::size_t j) {
      return i == j ? kForbidden : arc(static_cast<ElementId>(i), static_cast<ElementId>(j));
    });
    for (ElementId e = 0; e < n_; ++e) {
      leave_[e] = -dual.row_price[e];
      enter_[e] = -dual.column_price[e];
      add_edge(e, static_cast<ElementId>(dual.column[e]));
    }
  }

  /// The bound that the present prices give, on the complete graph; its tree becomes part of the sparse one.
  double evaluate() {
    const OneTree tree = complete_one_tree(n_, [&](ElementId a, ElementId b) { return priced(a, b); });
    for (const auto& [a, b] : tree.edges) add_edge(a, b);
    if (!problem_.symmetric() && n_ <= kMostForMatrix) add_cheapest_edges();
    return tree.cost - prices() + inner_;
  }

  /// The edges of each element that are cheapest at the present prices.
  void add_cheapest_edges() {
    std::vector<std::pair<double, ElementId>> edges;
    for (ElementId a = 0; a < n_; ++a) {
      edges.clear();
      for (ElementId b = 0; b < n_; ++b)
        if (a != b) edges.push_back({priced(a, b), b});
      const std::size_t count = std::min(kEdgesAdded, edges.size());
      std::partial_sort(edges.begin(), edges.begin() + static_cast<std::ptrdiff_t>(count), edges.end());
      for (std::size_t k = 0; k < count; ++k) add_edge(a, edges[k].second);
    }
  }

  /// Subgradient steps; leaves the best prices found, and returns what they give on the sparse graph.
  double climb() {
    std::vector<double> best_leave = leave_, best_enter = enter_;
    std::vector<double> leaving(n_, 0.0), entering(n_, 0.0);
    double best = -std::numeric_limits<double>::infinity(), length = 2;
    int idle = 0;
    for (int step = 0; step < kSteps; ++step) {
      const OneTree tree = sparse_one_tree(graph_, [&](ElementId a, ElementId b) { return priced(a, b); });
      const double bound = tree.cost - prices() + inner_;
      if (bound > best) {
        idle = bound > best * (1 + 1e-6) ? 0 : idle + 1;
        best = bound;
        best_leave = leave_;
        best_enter = enter_;
      } else if (++idle >= kIdleSteps) {
        idle = 0;
        length *= kShorter;
      }
      if (length < 1e-3) break;
      if (!take_step(tree, length * std::max(tour_cost_ - bound, 1e-4 * tour_cost_), leaving, entering)) break;
    }
    leave_ = best_leave;
    enter_ = best_enter;
    return best;
  }

  /// Raises the prices of elements with too many edges, and lowers the others'. `leaving` and `entering` are the last
  /// step's directions, which have a part in this one (Helsgaun 2000). False if the tree is a tour.
  bool take_step(const OneTree& tree, double rise, std::vector<double>& leaving, std::vector<double>& entering) {
    std::vector<int> out(n_, -1), in(n_, -1);
    for (const auto& [a, b] : tree.edges) {
      bool turned = false;
      if (!problem_.symmetric()) priced(a, b, turned);
      ++out[turned ? b : a];
      ++in[turned ? a : b];
    }
    double square = 0;
    for (ElementId e = 0; e < n_; ++e) {
      if (problem_.symmetric()) out[e] = in[e] = out[e] + in[e];  // degree less 2; both prices are the same
      square += static_cast<double>(out[e] * out[e] + in[e] * in[e]);
    }
    if (square == 0) return false;
    for (ElementId e = 0; e < n_; ++e) {
      leave_[e] += rise / square * (0.7 * out[e] + 0.3 * leaving[e]);
      enter_[e] += rise / square * (0.7 * in[e] + 0.3 * entering[e]);
      leaving[e] = out[e];
      entering[e] = in[e];
    }
    return true;
  }

  const TourProblem& problem_;
  std::size_t n_;
  double tour_cost_;
  double inner_ = 0;
  std::vector<double> leave_, enter_;  // prices
  std::vector<double> arcs_;           // least costs by pair of elements; empty: not remembered
  SparseGraph graph_;
};

}  // namespace

double held_karp_bound(const TourProblem& problem, double tour_cost) {
  if (problem.elements() < 3) return 0;  // no tree has an edge more than a spanning tree
  return Ascent(problem, tour_cost).run();
}

}  // namespace oxturn
