/// The order of a drawing's elements at what it really costs: transits go round what is drawn by then.
///
///   PricedOrder priced(elements, start, router, work);
///   DrivenOrder best = priced.search(tour, context);       // solves the tour, prices it, solves it again ...
///
/// What a transit costs depends on what was drawn before it. (1) The tour is solved as if nothing were drawn. (2) It is
/// driven, and every transit priced. (3) Connections dearer than they seemed are raised to their price, and the tour is
/// improved, ten times at most; the best one driven is kept. (4) Local search at the real price: elements beside dear
/// transits are moved, and runs of elements turned round, within 50 positions. Only transits between the changed
/// positions are priced again, and only where straight distances leave hope. Of up to 200 elements, without a radius,
/// it begins with several orders, the best one backwards among them, is repeated after (3) as long as that helps, and
/// after random changes of the best order. (5) Of up to nine elements all orders are tried (few_orders.hpp).
/// Source: the outlook of Vollprecht 2014, which raises connections over finished areas; (4) is ours.
#pragma once

#include <vector>

#include "algorithms/drawing/drawing_tour.hpp"
#include "algorithms/drawing/transit_router.hpp"

namespace oxturn {

/// How transits treat finished work. around: they go round it. weight: they do not, but connections that cross it are
/// given a constant weight and the tour is solved again. ignore: they do not, and cost their length.
enum class FinishedRule { around, weight, ignore };

struct DrivenOrder {
  std::vector<ElementVisit> order;
  std::vector<Transit> transits;            // to each visit
  std::vector<std::vector<Transit>> inner;  // of each visit, inside its fill
  double crossing_m = 0, length_m = 0;      // of all transits
  double price() const { return length_m + Transit::kCrossingWeight * crossing_m; }
};
/// The cheaper one.
bool better(const DrivenOrder& a, const DrivenOrder& b);

/// What each element draws; those of element e begin at first[e].
struct ElementPieces {
  std::vector<DrawnPiece> pieces;
  std::vector<std::size_t> first;
};
ElementPieces pieces_of(const std::vector<DrawingElement>& elements);

class PricedOrder {
 public:
  /// `work` holds pieces_of(elements). References must outlive it.
  PricedOrder(const std::vector<DrawingElement>& elements, const Point& start, FinishedRule rule, TransitRouter& router,
              FinishedWork& work);

  DrivenOrder search(DrawingTour& tour, Context& context);
  /// Metres of the tour between elements that search() began with: as if nothing were drawn.
  double straight_m() const { return straight_m_; }
  /// Step (4) alone.
  DrivenOrder improved(const DrivenOrder& from, const DrawingTour& tour, const Context& context);
  /// Drives the order and prices all transits.
  DrivenOrder driven(const std::vector<ElementVisit>& order);
  /// Drives the last visit of an order whose others are driven.
  void append(DrivenOrder& order);
  /// What the visit draws, or all, is not finished any more.
  void undo(const ElementVisit& visit);
  void undo_all();

 private:
  Transit transit(const Pose& from, const Pose& to);
  Transit transit_to(const std::vector<ElementVisit>& order, std::size_t k);
  std::vector<Transit> draw(const ElementVisit& visit);
  void raise(const DrivenOrder& order, DrawingTour& tour);
  bool is_cheap() const;
  std::vector<ElementVisit> backwards(std::vector<ElementVisit> order) const;
  DrivenOrder with_kicks(DrivenOrder best, const DrawingTour& tour, const Context& context);
  std::vector<DrivenOrder> starts(const DrivenOrder& best, const DrivenOrder& last, const DrawingTour& tour);

  const std::vector<DrawingElement>& elements_;
  Point start_;
  FinishedRule rule_;
  TransitRouter& router_;
  FinishedWork& work_;
  std::vector<std::size_t> first_piece_;
  double straight_m_ = 0;
};

}  // namespace oxturn
