/// Local search over the order of a drawing's elements, at the price that transits really have (priced_order.hpp).
///
///   OrderMoves moves(elements, start, tour, radius, router, work, first_piece);
///   order = moves.improved(driven, context);
///
/// At each transit that is longer than the straight line, or crosses finished work: the element on either side is moved
/// up to 50 positions away, in either direction of driving, as are those that are in the way; and a run of up to 50
/// elements beside it is turned round.
/// What is drawn before the first and after the last changed position stays the same, so only transits between are
/// priced. A move whose shortest curves already cost more is rejected at once.
#pragma once

#include <vector>

#include "algorithms/drawing/drawing_tour.hpp"
#include "algorithms/drawing/transit_router.hpp"

namespace oxturn {

struct DrivenOrder;

class OrderMoves {
 public:
  /// References must outlive it.
  OrderMoves(const std::vector<DrawingElement>& elements, const Point& start, const DrawingTour& tour, double radius,
             TransitRouter& router, FinishedWork& work, const std::vector<std::size_t>& first_piece);

  std::vector<ElementVisit> improved(const DrivenOrder& from, const Context& context);

 private:
  using Order = std::vector<ElementVisit>;
  /// Positions low to high of an order are replaced by others of the same elements.
  struct Move {
    std::size_t low, high;
    Order block;
  };
  bool improve_at(std::size_t k, const Context& context);
  std::vector<std::size_t> obstacles(std::size_t k);
  bool try_moving(std::size_t k, std::size_t to);
  bool try_moving(std::size_t k);
  bool try_passing(std::size_t k);
  bool try_turning(std::size_t k);
  bool accept(const Move& move);
  /// The price of the transits to positions low to high + 1; infinity once it is `most` or more.
  double price(const Order& order, std::size_t low, std::size_t high, double most, std::vector<double>& prices);
  double bound(const Order& order, std::size_t k) const;
  Transit transit_to(const Order& order, std::size_t k);
  void set_finished(const ElementVisit& visit, bool finished);
  void finish_before(std::size_t k);
  ElementVisit turned(ElementVisit visit) const;
  Point exit_before(const Order& order, std::size_t k) const;

  const std::vector<DrawingElement>& elements_;
  Point start_;
  const DrawingTour& tour_;
  double radius_;  // 0: transits may have bends
  TransitRouter& router_;
  FinishedWork& work_;
  const std::vector<std::size_t>& first_piece_;
  Order order_;
  std::vector<double> prices_;  // of the transit to each position
  std::size_t finished_ = 0;    // so many positions of the order are marked as finished
  std::size_t budget_ = 0;      // of transits still to be priced
};

}  // namespace oxturn
