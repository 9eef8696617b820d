/// The tour over the elements of a drawing: polylines from either end, closed strokes from any of their entries, fills.
///
///   DrawingTour tour(elements, demands, start, radius);
///   std::vector<ElementVisit> order = tour.solve(context);
///   tour.raise(order[3], order[4], 12.5);                  // that connection costs more than was thought
///   order = tour.improve(order, context);
///
/// Connections cost what the shortest curve between the two poses would cost if nothing were in the way: the straight
/// distance, or for a robot with a least turning radius that of Dubins' curve; until they are raised. Elements joined
/// by connections are one, driven from either end. Solved by tour/solve_tour.hpp.
/// Source: Vollprecht 2014, section 2.3, with real precedence where he forbids direct connections only.
#pragma once

#include <memory>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/drawing/demands.hpp"

namespace oxturn {

class DrawingTour {
 public:
  /// `elements` must outlive it. `radius`: least turning radius, or 0. Throws std::invalid_argument, naming the
  /// elements, for joints and containment that contradict each other (shape_chains.hpp).
  DrawingTour(const std::vector<DrawingElement>& elements, TourDemands demands, const Point& start, double radius);
  ~DrawingTour();

  /// In driving order. Throws Infeasible if no tour keeps all demands.
  std::vector<ElementVisit> solve(Context& context) const;
  /// A better tour from this one, which is one of those returned before. Never dearer.
  std::vector<ElementVisit> improve(const std::vector<ElementVisit>& order, Context& context) const;
  /// Whether the order keeps containment and joints, drives no one-way element backwards, and uses no deleted
  /// connection. O(n).
  bool allows(const std::vector<ElementVisit>& order) const;
  const TourDemands& demands() const;
  /// What the tour's connections cost, as far as is known.
  double cost(const std::vector<ElementVisit>& order) const;
  /// The connection from one visit to the next costs this; `from` none: the start. No effect on joined ones.
  void raise(const ElementVisit* from, const ElementVisit& to, double cost);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace oxturn
