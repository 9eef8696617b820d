/// A taut tether from an anchor to a robot that drives among obstacles.
///
///   const TautSpace space(free_space);
///   TautTether tether(space, anchor);
///   tether.drive(path);
///   tether.length();                            // metres, of the shortest curve in the homotopy class of the path
///   driven
///
/// The tether's bends are decided by orientation predicates on given points (corners and the path's points), never on
/// rounded intersections and never by time steps.
///
/// Source      the taut tether of Xavier, "Shortest path planning for a tethered robot or an anchored cable", 1999; the
///             tests' oracle is Hershberger and Snoeyink 1994
/// Rules       1. A corner stops the tether if its obstacle lies on the side towards which the tether turns. A corner
///                that the tether touches with the obstacle on the other side does not.
///             2. If several corners become collinear with the tether at once, only the farthest becomes a bend.
///             3. A bend is released when the tether's last segment becomes collinear with the segment before it.
/// Complexity  a drive costs the corners in the grid cells of the triangles it sweeps over, and the bends that change:
///             see taut_tether.cpp
#pragma once

#include <functional>

#include "geometry/tether/taut_space.hpp"

namespace oxturn {

class TautTether {
 public:
  /// A corner about which the tether turns, seen from the anchor: left (+1, the obstacle is on the tether's left) or
  /// right (-1).
  struct Bend {
    Point at;
    int side;
    bool operator==(const Bend&) const = default;
  };
  /// A part of a drive, from `from` to `to`, during which the tether's last segment turns about one point.
  struct Swing {
    Point pivot;            // the last bend, or the anchor
    double before = 0;      // metres of tether from the anchor to the pivot
    std::size_t bends = 0;  // the number of bends, the pivot included unless it is the anchor
    Point from, to;         // on the segment driven; rounded, except at its ends
  };

  /// `space` must outlive the tether. The anchor may be on a wall or at a corner. The robot is at the anchor.
  TautTether(const TautSpace& space, const Point& anchor);

  /// Drives straight to `to`. The segment must lie in the closed free space, up to rounding; it may run along walls and
  /// through corners. `each`, if given, is called for every swing in order. Throws std::invalid_argument if `to` is not
  /// finite.
  void drive(const Point& to, const std::function<void(const Swing&)>& each = {});
  void drive(const Polyline& points) {
    for (const Point& p : points) drive(p);
  }

  const Point& anchor() const { return anchor_; }
  const Point& robot() const { return robot_; }
  const std::vector<Bend>& bends() const { return bends_; }
  /// So many of bends(), the first ones, did not change during the last drive.
  std::size_t kept() const { return kept_; }
  /// The last bend, or the anchor.
  const Point& pivot() const { return bends_.empty() ? anchor_ : bends_.back().at; }
  /// Metres from the anchor to the robot.
  double length() const { return before_.back() + distance(pivot(), robot_); }
  /// Anchor, bends, robot.
  Polyline polyline() const;

 private:
  class Motion;
  const TautSpace* space_;
  Point anchor_, robot_;
  std::vector<Bend> bends_;
  std::vector<double> before_{0};  // metres from the anchor to itself, then to each bend
  std::size_t kept_ = 0;
};

}  // namespace oxturn
