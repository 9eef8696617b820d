// A robot that feels a wall only when it touches it: all that a vacuum's habits are given of the world.
//
// The body is a disc with a ring of bumpers, so a contact says on which side it is. A feeler (the infrared wall sensor of
// real vacuums) measures how far the nearest wall is, no farther than it is asked to. The robot knows its pose exactly.
// It stops a hair (a quarter of the problem's tolerance) before a wall.
// Complexity  a stretch O(its length / tool width + edges near it)
#pragma once

#include <optional>

#include "maps/problem.hpp"

namespace oxturn {

class Bumper {
 public:
  /// `problem` must outlive it. Nothing of it can be asked for but what is below.
  explicit Bumper(const Problem& problem);

  const Point& at() const { return at_; }
  double tool_width() const { return tool_width_; }
  double driven() const { return driven_; }  // metres

  /// Straight on to `to`, or as far as a wall lets it: then the unit vector from the wall to the robot.
  std::optional<Point> drive(const Point& to);

  struct Wall {
    double distance;  // metres from the rim
    Point away;       // unit vector from the wall to the robot
  };
  /// The nearest wall if it is nearer than `reach` metres from the robot's rim, of those whose direction makes at most the
  /// angle with this `cosine` with the unit vector `towards` (-2: all round).
  std::optional<Wall> feel(double reach, const Point& towards, double cosine) const;

  /// What has been driven, straight stretches in one piece.
  const Polyline& way() const { return way_; }

 private:
  struct Hit {
    double far;  // metres to drive until a hair before the wall
    Point away;
  };
  std::optional<Hit> first_hit(const Point& along, double far) const;
  void go(const Point& to);
  Point normal(std::size_t edge) const;

  const EdgeIndex& walls_;
  double tool_width_, hair_, driven_ = 0;
  Point at_;
  Polyline way_;
  Point heading_{0, 0};  // of the last stretch of way_
};

}  // namespace oxturn
