/// The path over a drawing's elements in their order: strokes with rounded corners, transits, a person's curves.
///
///   OrderDriver driver(elements, router, work, {.corner = CornerRule::automatic, .radius = 0.5});
///   driver.drive(order, path);
///
/// For a robot without radius every corner is a stop. Else corners are rounded (smoothing/corners.hpp); where that does
/// not fit, the robot leaves the stroke with the tool off and comes back in the new direction.
/// Source: Vollprecht 2014, section 3.7, with the curves of his outlook.
#pragma once

#include <map>
#include <vector>

#include "algorithms/drawing/demands.hpp"
#include "algorithms/drawing/last_detours.hpp"
#include "algorithms/drawing/priced_order.hpp"
#include "algorithms/smoothing/corners.hpp"

namespace oxturn {

struct CornerChoice {
  CornerRule rule = CornerRule::automatic;
  double radius = 0;             // metres; 0: corners are kept
  double largest_deviation = 0;  // metres that an arc inside may leave a vertex
};

/// A person's curve between two ports.
struct PortCurve {
  ConnectionKind kind = ConnectionKind::spiro;
  std::vector<Point> points;
};
using PortCurves = std::map<std::pair<ElementPort, ElementPort>, PortCurve>;
/// Those of the drawing, in both directions.
PortCurves curves_of(const Drawing& drawing, const TourDemands& demands);

class OrderDriver {
 public:
  /// References must outlive it. `smooth`: nullptr without radius. `last`: nullptr if transits may cross finished work.
  OrderDriver(const std::vector<DrawingElement>& elements, TransitRouter& router, FinishedWork& work,
              const SmoothTransits* smooth, const CornerChoice& corners, LastDetours* last);

  void drive(const DrivenOrder& order, const PortCurves& curves, PathBuilder& path, const Context& context);
  const std::vector<Polyline>& transits() const { return transits_; }
  struct Crossing {
    Transit transit;
    LastDetour::End why;  // there is no path round it
  };
  /// Those of them that cross finished work.
  const std::vector<Crossing>& crossing() const { return crossing_; }
  /// Those that would, but for the last resort.
  std::size_t last_detours() const { return last_detours_; }
  /// Of a person's curves.
  std::size_t curves_used() const { return curves_used_; }

 private:
  void drive(const DrawingElement& element, const ElementVisit& visit, const std::vector<Transit>& inner,
             PathBuilder& path, const Context& context);
  void stroke(const DrawingElement& element, const Leg& leg, const ElementVisit& visit, PathBuilder& path,
              const Context& context);
  void take(Transit t, LastDetour::End why, PathBuilder& path);
  void transit(Transit t, const Pose& from, const Pose& to, PathBuilder& path, const Context& context);
  /// The person's curve. Throws std::invalid_argument, naming the elements, if there is none through its points or it
  /// leaves configuration space.
  Transit by_hand(const ElementVisit& from, const ElementVisit& to, const PortCurve& curve);
  std::vector<std::size_t> corners(const DrawingElement& element, const ElementVisit& visit,
                                   const Polyline& line) const;

  const std::vector<DrawingElement>& elements_;
  TransitRouter& router_;
  FinishedWork& work_;
  const SmoothTransits* smooth_;
  CornerChoice corners_;
  LastDetours* last_;
  std::vector<std::size_t> first_piece_;
  std::vector<Polyline> transits_;
  std::vector<Crossing> crossing_;
  std::size_t curves_used_ = 0, last_detours_ = 0;
};

}  // namespace oxturn
