// What a planner returns: legs in driving order, tool on or off.
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

struct Leg {
  bool tool = true;  // on: work; off: transit
  Polyline points;   // at least two; the first is the last of the leg before
};

struct Path {
  std::vector<Leg> legs;
  double length() const;
  double length(bool tool) const;
  std::size_t segment_count() const;
};

/// Appends stretches and keeps a Path well formed: repeated points dropped, neighbours of the same kind merged,
/// exactly straight-on points kept (they cost nothing and say where the planner thought).
class PathBuilder {
 public:
  explicit PathBuilder(const Point& start) : at_(start) {}
  const Point& at() const { return at_; }
  /// Drives `points` in order from where the path ends now (a first point equal to it is dropped).
  void drive(const Polyline& points, bool tool);
  void drive(Polyline&& points, bool tool);  // a long leg is not copied
  void drive(const Point& to, bool tool) { drive(Polyline{to}, tool); }
  Path take() { return std::move(path_); }

 private:
  Point at_;
  Path path_;
};

}  // namespace oxturn
