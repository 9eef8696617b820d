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
/// it begins with several orders, the best one backwards among them, and is repeated after (3) as long as that helps.
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
};
/// The one with less driving over finished work; if it is the same, the shorter one.
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
  /// Drives the order and prices all transits.
  DrivenOrder driven(const std::vector<ElementVisit>& order);

 private:
  Transit transit(const Pose& from, const Pose& to);
  Transit transit_to(const std::vector<ElementVisit>& order, std::size_t k);
  std::vector<Transit> draw(const ElementVisit& visit);
  void raise(const DrivenOrder& order, DrawingTour& tour);
  bool is_cheap() const;
  std::vector<DrivenOrder> starts(const DrivenOrder& best, const DrivenOrder& last, const DrawingTour& tour);

  const std::vector<DrawingElement>& elements_;
  Point start_;
  FinishedRule rule_;
  TransitRouter& router_;
  FinishedWork& work_;
  std::vector<std::size_t> first_piece_;
};

}  // namespace oxturn
