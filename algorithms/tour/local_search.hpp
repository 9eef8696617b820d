/// Or-opt and 2-opt moves over neighbour lists: the improvement of an open tour.
///
///   LocalSearch(costs, tour, context).run();
///
/// O(n log n) to build; a round of moves looks at some hundred candidates for each stop. The number of path searches is
/// limited, so the effort does not depend on the clock.
#pragma once

#include <array>
#include <vector>

#include "algorithms/tour/tour_costs.hpp"

namespace oxturn {

class LocalSearch {
 public:
  /// All must outlive it.
  LocalSearch(const TourCosts& costs, std::vector<TourStop>& tour, Context& context);
  /// Until no move helps, or the effort is spent.
  void run();

 private:
  static constexpr std::size_t kNeighbours = 10;
  /// One possible order and direction of a run of stops.
  struct Variant {
    TourStop head, tail;  // its first and its last stop
    double extra = 0;     // what its patterns cost more than the present ones
  };
  /// Where a run of stops may be inserted: between two ports.
  struct Gap {
    std::size_t left, right;
    bool has_right;  // else it is the end of the tour
  };
  void find_neighbours();
  void renumber(std::size_t from, std::size_t to);
  /// The port where the robot leaves for stop i.
  std::size_t exit_before(std::size_t i) const { return i == 0 ? costs_.start() : costs_.exit(tour_[i - 1]); }
  bool improve_at(std::size_t i);
  bool try_reversals(std::size_t i);
  bool try_moves(std::size_t i, std::size_t count);
  bool try_reversal(std::size_t i, std::size_t j);
  bool try_move(std::size_t i, std::size_t count, std::size_t to);
  std::vector<Variant> variants_of(std::size_t i, std::size_t count) const;
  std::size_t best_insertion(const std::vector<Variant>& variants, const Gap& gap, double closed, double removed) const;
  void move(std::size_t i, std::size_t count, std::size_t to, const Variant& variant);

  const TourCosts& costs_;
  std::vector<TourStop>& tour_;
  Context& context_;
  std::size_t n_;
  std::vector<std::array<std::uint32_t, kNeighbours>> neighbours_;  // of each port: the nearest of other elements
  std::vector<std::uint8_t> neighbour_count_;
  std::vector<std::size_t> index_of_;  // of each element in the tour; n_ if it is not there
};

}  // namespace oxturn
