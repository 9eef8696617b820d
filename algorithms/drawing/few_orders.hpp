/// All orders of a few elements of a drawing, at the price that transits really have (priced_order.hpp).
///
///   FewOrders orders(elements, start, tour, priced);
///   best = orders.search(best, context);                      // the cheapest one, or `best` if none is cheaper
///
/// Depth-first branch and bound: elements are appended in both directions, closed ones at each of their entries, the
/// nearest first. An order is given up where its transits, and for each element still to come the straight distance
/// from the nearest exit, cost as much as the best one. Ends after a number of transits, in which five fills, or eight
/// strokes, are usually done.
#pragma once

#include <limits>
#include <vector>

#include "algorithms/drawing/drawing_tour.hpp"
#include "algorithms/drawing/priced_order.hpp"

namespace oxturn {

class FewOrders {
 public:
  static constexpr std::size_t kMostElements = 9;

  /// References must outlive it.
  FewOrders(const std::vector<DrawingElement>& elements, const Point& start, const DrawingTour& tour,
            PricedOrder& priced);

  DrivenOrder search(const DrivenOrder& best, const Context& context);

 private:
  struct Step {
    double bound;
    ElementVisit visit;
  };
  void append(const Context& context);
  std::vector<Step> next_steps() const;
  bool may_come(const ElementVisit& visit) const;
  double still_to_come() const;

  const std::vector<DrawingElement>& elements_;
  Point start_;
  const DrawingTour& tour_;
  PricedOrder& priced_;
  std::vector<double> least_;  // metres to each element from the nearest exit of any other
  std::vector<bool> drawn_;
  DrivenOrder at_, best_;
  std::size_t budget_ = 0;  // of transits still to be priced
};

}  // namespace oxturn
