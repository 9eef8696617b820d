// A taut string from an anchor to a robot that drives among obstacles.
//
// The shortest curve in the homotopy class of the driven way, kept exactly: where it bends is decided by orientation
// predicates on given points (corners, way points), never on rounded meeting points, and never by time steps.
// Source      the string of algorithms.md section 1; oracle in the tests: Hershberger & Snoeyink 1994
// Rules       1. A corner holds the string if its obstacle lies on the side towards which the string swings; a corner
//                that it touches from its other side does not block.
//             2. Of several corners that come into line at once only the farthest becomes a bend.
//             3. A bend is released when the string comes into line with the part before it: at that very place.
// Complexity  a drive costs O(corners in the cells of its swept triangles + bends changed); see taut_string.cpp
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/point.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// The corners that a string can bend about: those where the boundary turns away from free space (more than 180
/// degrees of it), indexed. Immutable; shared by any number of strings and threads.
class TautSpace {
 public:
  explicit TautSpace(const Region& free);
  ~TautSpace();
  TautSpace(TautSpace&&) noexcept;
  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<const Impl> impl_;
};

class TautTether {
 public:
  /// A corner that the string turns about: left (+1; its obstacle lies at the string's left, as seen from the anchor)
  /// or right (-1).
  struct Bend {
    Point at;
    int side;
    bool operator==(const Bend&) const = default;
  };
  /// A stretch of a drive, from `from` to `to`, during which the last segment of the string turns about one place.
  struct Swing {
    Point pivot;            // last bend, or the anchor
    double before = 0;      // metres of string from the anchor to the pivot
    std::size_t bends = 0;  // number of bends, the pivot included unless it is the anchor
    Point from, to;         // on the driven segment; ends inside of it are rounded
  };

  /// `space` must outlive the string. The anchor may lie on a wall or at a corner. The robot stands at the anchor.
  TautTether(const TautSpace& space, const Point& anchor);

  /// Drives straight to `to`. The closed segment must lie in the closed free space (it may run along walls and
  /// through corners, and errors of rounding are forgiven); `each`, if given, is called for every swing in order.
  void drive(const Point& to, const std::function<void(const Swing&)>& each = {});
  void drive(const Polyline& points) {
    for (const Point& p : points) drive(p);
  }

  const Point& anchor() const { return anchor_; }
  const Point& robot() const { return robot_; }
  const std::vector<Bend>& bends() const { return bends_; }
  /// So many bends, the first of bends(), have stayed as they were throughout the last drive.
  std::size_t kept() const { return kept_; }
  /// The last bend, or the anchor.
  const Point& pivot() const { return bends_.empty() ? anchor_ : bends_.back().at; }
  double length() const { return before_.back() + distance(pivot(), robot_); }
  /// anchor, bends, robot (without repeated points, but at least anchor and robot).
  Polyline polyline() const;

 private:
  class Motion;
  const TautSpace* space_;
  Point anchor_, robot_;
  std::vector<Bend> bends_;
  std::vector<double> before_{0};  // metres to the anchor, then to each bend
  std::size_t kept_ = 0;
};

}  // namespace oxturn
