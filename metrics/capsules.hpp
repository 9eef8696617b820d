/// The segments of a path with the tool on as capsules, and polygons in place of capsules. Private to metrics/.
///
///        .-----------------------.
///       (  a===================b  )      capsule: all points within the tool's radius of the segment ab
///        '-----------------------'       its polygon has chords in place of the arcs
///
/// Lengths are in tile sides (see swept_area.hpp).
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/path.hpp"
#include "metrics/convex.hpp"

namespace oxturn {

struct Capsule {
  Vec a, b, along;  // along: unit vector
  std::uint32_t leg = 0;
  bool disc = false;         // a == b: where the tool is switched on, or a leg without length
  bool visits_only = false;  // counts for visits, not for areas
};

struct CapsuleSet {
  std::vector<Capsule> all;
  double work = 0;        // total length of the segments
  std::size_t discs = 0;  // how often the tool was switched on inside `room`
};

/// The segments of `path` with the tool on, as (p - origin) / side, clipped to `room`. Consecutive segments are merged
/// while every point in between stays within 1e-10 of the merged segment (users shrink polygons by more than that).
/// Between legs with the tool on that join within `joint` metres the tool stays on.
CapsuleSet capsules(const Path& path, const Point& origin, double side, const Box& room, double joint);

/// Directions of the normals of a half disc's n chords: (k + 1/2) / n * 180 degrees from -90 degrees.
class Chords {
 public:
  explicit Chords(int n);
  /// Distance of the chords' lines from the centre of a disc of radius 1, if the polygon is inscribed.
  double inscribed() const { return inscribed_; }
  /// The same, if the polygon has the area of the disc.
  double equal_area() const { return equal_area_; }
  const std::vector<Vec>& directions() const { return directions_; }

 private:
  std::vector<Vec> directions_;
  double inscribed_, equal_area_;
};

/// Half-planes whose intersection, within `where`, is the polygon of the capsule: its sides at distance `side` from the
/// segment, its chords at distance `cap` from the ends. `where` and the result are relative to `centre`. Half-planes
/// that contain all of `where` are left out.
void polygon_of(const Capsule& capsule, Vec centre, const Extent& where, const Chords& chords, double side, double cap,
                std::vector<HalfPlane>& out);
/// The same for the disc about the capsule's first point.
void disc_of(const Capsule& capsule, Vec centre, const Extent& where, const Chords& chords, double cap,
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
