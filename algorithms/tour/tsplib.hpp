/// Tour problems and tours as files of TSPLIB (Reinelt 1991), the format of LKH, Concorde and most published instances.
///
///   const TsplibInstance instance = read_tsplib(read_file("eil51.tsp"), "eil51.tsp");
///   const auto cost = instance.cost();
///   const TourProblem problem(*cost, instance.size());
///   write_file("eil51.tour", write_tsplib_tour("eil51", order));
///
/// Types TSP, ATSP and SOP (sequential ordering: a path from the first node to the last, where some nodes must come
/// before others); edge weights EUC_2D, CEIL_2D and EXPLICIT as FULL_MATRIX.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

struct TsplibInstance {
  enum class Weights { euc_2d, ceil_2d, full_matrix };
  std::string name = {};
  bool symmetric = true;    // TSP, else ATSP or SOP
  bool sequential = false;  // SOP: a weight of -1 from i to j says that j comes before i
  Weights weights = Weights::euc_2d;
  std::vector<Point> points = {};  // of euc_2d (distances rounded to the nearest whole number) and ceil_2d (rounded up)
  std::vector<double> matrix = {};  // of full_matrix: by rows
  std::size_t dimension = 0;

  std::size_t size() const { return dimension; }
  /// Keeps a copy of what it needs. Of a SOP: that of closed tours which return to the first node at no cost.
  std::unique_ptr<ConnectionCost> cost() const;
  /// Adds the precedence of a SOP to the problem of its nodes.
  void require_order(TourProblem& problem) const;
};

/// Throws std::invalid_argument "SOURCE:LINE: what is wrong", and for what it cannot read names what it can.
TsplibInstance read_tsplib(std::string_view text, const std::string& source);
/// Reads back as the same instance. Numbers of a matrix are written as they are; LKH wants whole ones.
std::string write_tsplib(const TsplibInstance& instance);

/// The TOUR_SECTION of a tour file, counted from 0. Throws as read_tsplib, also for nodes that are missing or repeated.
std::vector<std::size_t> read_tsplib_tour(std::string_view text, const std::string& source);
std::string write_tsplib_tour(const std::string& name, const std::vector<std::size_t>& order);

}  // namespace oxturn
