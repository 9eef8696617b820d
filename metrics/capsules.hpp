/// The segments of a path with the tool on as capsules, and polygons in place of capsules. Private to metrics/.
///
///        .-----------------------.
///       (  a===================b  )      capsule: all points within the tool's radius of the segment ab
///        '-----------------------'       its polygon has chords in place of the arcs
///
/// Lengths are in tile sides (see swept_area.hpp).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/path.hpp"
#include "metrics/convex.hpp"

namespace oxturn {

inline constexpr double kToolRadius = 1;  // in tile sides

struct Capsule {
  Vec a, b, along;                    // along: unit vector
  double path_m = 0, end_m = 0;       // driven before `a` and `b`, metres
  double radius = kToolRadius;        // of the part of the tool that is used
  double slack = 0;                   // the path is within this distance of the segment, and the segment of the path
  bool disc = false;                  // a == b: where the tool is switched on, or a chain without length
  bool visits_only = false;           // counts for visits, not for areas
  std::uint32_t forth = 1, back = 0;  // how often the path drives the segment from a to b, and from b to a
};

struct CapsuleSet {
  std::vector<Capsule> all;  // in driving order, each segment once
  double begun = 0;          // area swept if none overlapped: that of the driven segments, and of the discs inside
                             // `room` where the tool was switched on
  double slack = 0;          // the greatest
};

/// The path with the tool on: chains of points, the same however the path is cut into legs.
struct WorkChains {
  struct Station {
    Vec at;
    double path_m;  // driven before it, metres
  };
  std::vector<Station> stations;
  struct Chain {
    std::size_t end;  // in `stations`
    double radius;    // of the part of the tool that is used
  };
  std::vector<Chain> chains;
};
/// The points p of `path` with the tool on, as (p - origin) / side. Between legs with the tool on that join within
/// `joint` metres the tool stays on, unless they use different widths of it; no leg uses more than all of it. Repeated
/// points are dropped, except in chains without length.
WorkChains work_chains(const Path& path, const Point& origin, double side, double joint);
/// Length times width of the chains inside `room`, in tiles.
double work_in(const WorkChains& chains, const Box& room);

/// The segments of the chains, clipped to `room`. Consecutive segments are merged as long as they and the merged
/// segment are within `slack` of each other and the path does not turn back (slack below 1e-9 counts as rounding, users
/// shrink polygons by that). O(n log n).
CapsuleSet capsules(WorkChains chains, const Box& room, double slack);

/// Directions of the normals of a half disc's n chords: (k + 1/2) / n * 180 degrees from -90 degrees.
class Chords {
 public:
  explicit Chords(int n);
  /// Distance of the chords' lines from the centre of a disc of radius 1, if the polygon is inscribed.
  double inscribed() const { return inscribed_; }
  /// The same, if the polygon has the area of the disc.
  double equal_area() const { return equal_area_; }
  /// All directions d with d . (x, y) > near, and possibly others.
  std::span<const Vec> between(double x, double y, double near) const;

 private:
  std::vector<Vec> directions_;
  double inscribed_, equal_area_;
};

/// Half-planes whose intersection, within `where`, is the polygon of the capsule: its sides at distance `side` from the
/// segment, its chords at distance `cap` from the ends. `where` and the result are relative to `centre`. Half-planes
/// that contain all of `where` are left out.
void polygon_of(const Capsule& capsule, Vec centre, const Extent& where, const Chords& chords, double side, double cap,
                std::vector<HalfPlane>& out);
/// The same for the disc about the point `at`; one of its chords is perpendicular to `along`.
void disc_of(Vec at, Vec along, Vec centre, const Extent& where, const Chords& chords, double cap,
             std::vector<HalfPlane>& out);

inline double squared_distance(Vec p, const Capsule& k) {
  const Vec d = k.b - k.a, e = p - k.a;
  const double len2 = dot(d, d), t = dot(e, d);
  if (t <= 0 || len2 <= 0) return dot(e, e);
  if (t >= len2) return dot(p - k.b, p - k.b);
  const double off = cross(d, e);
  return off * off / len2;
}

}  // namespace oxturn
