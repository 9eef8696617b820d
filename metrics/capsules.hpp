// A path's tool-on segments as capsules, in tile units, and their polygons. Internal to metrics/.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/path.hpp"
#include "metrics/convex.hpp"

namespace oxturn {

/// All points within the tool's radius of the segment ab.
struct Capsule {
  Vec a, b, along;  // `along`: unit vector
  std::uint32_t leg = 0;
  bool disc = false;  // where the tool is switched on: a == b, counts for visits only unless it is all
  bool visits_only = false;
};

struct CapsuleSet {
  std::vector<Capsule> all;
  double work = 0;        // length of the capsules' segments, tile units
  std::size_t discs = 0;  // times that the tool was switched on inside `room`
};

/// Tool-on segments of `path` as (p - origin) / side, cut to `room` (tile units). Straight-on segments are merged
/// while every point in between stays within 1e-10 of the merged line (callers shrink by more than that).
/// Tool-on legs that join within `joint` (metres) are one stretch: the tool stays on.
CapsuleSet capsules(const Path& path, const Point& origin, double side, const Box& room, double joint);

/// Directions of the chords of a half disc: k + 1/2 of n parts of 180 degrees, from -90 to 90.
class Chords {
 public:
  explicit Chords(int n);
  /// Where the chords' lines lie on a disc of radius 1: inscribed, of equal area, circumscribed.
  double inscribed() const { return inscribed_; }
  double equal_area() const { return equal_area_; }
  const std::vector<Vec>& directions() const { return directions_; }

 private:
  std::vector<Vec> directions_;
  double inscribed_, equal_area_;
};

/// Half-planes whose intersection, within `where`, is the capsule's polygon: sides at distance `side`, chords at
/// `cap`. `where` and the answer are relative to `centre`. Those that hold all of `where` are left out.
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
