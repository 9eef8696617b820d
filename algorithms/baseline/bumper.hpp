/// A robot that perceives walls by contact: all that the habits of simple vacuum cleaners know of the world.
///
///   Bumper robot(problem);
///   if (const auto away = robot.drive(robot.at() + Point(5, 0))) ...   // contact: the unit vector away from the wall
///
/// The body is a disc with a ring of bumpers, so a contact shows on which side it is. A feeler (the infrared wall
/// sensor of real vacuum cleaners) measures the distance to the nearest wall, up to a given reach. The robot knows its
/// pose exactly. It stops a quarter of the problem's tolerance before a wall.
/// A motion O(its length / tool width + edges near it).
#pragma once

#include <optional>

#include "maps/problem.hpp"

namespace oxturn {

class Bumper {
 public:
  /// `problem` must outlive it. Only what is declared here can be learnt of it.
  explicit Bumper(const Problem& problem);

  const Point& at() const { return at_; }
  double tool_width() const { return tool_width_; }
  double driven() const { return driven_; }  // metres

  /// Straight to `to`, or until a contact: then the unit vector from the wall to the robot.
  std::optional<Point> drive(const Point& to);

  struct Wall {
    double distance;  // metres from the robot's boundary
    Point away;       // unit vector from the wall to the robot
  };
  /// The nearest wall less than `reach` metres from the robot's boundary, of those whose direction makes at most the
  /// angle with this `cosine` with the unit vector `towards` (-2: all around).
  std::optional<Wall> feel(double reach, const Point& towards, double cosine) const;

  /// Driven so far; straight runs are one segment.
  const Polyline& path() const { return path_; }

 private:
  struct Hit {
    double distance;  // metres to drive until the robot stops before the wall
    Point away;
  };
  std::optional<Hit> first_hit(const Point& along, double length) const;
  std::optional<Hit> hit(std::size_t edge, const Point& along, double length) const;
  void go(const Point& to);
  Point normal(std::size_t edge) const;

  const EdgeIndex& walls_;
  double tool_width_, gap_, driven_ = 0;  // gap_: at which the robot stops before a wall
  Point at_;
  Polyline path_;
  Point heading_{0, 0};  // of the last segment of path_
};

}  // namespace oxturn
