/// Small convex polygons, clipped and subtracted. Private to metrics/.
///
///   std::vector<Convex> uncovered;
///   subtract(tile, half_planes, uncovered, memory);      // tile without the half-planes' intersection
///
/// Coordinates are relative to a tile's centre, in tile sides, so all are about 1. A point counts as inside a
/// half-plane up to kSlack beyond it. Users shrink what they subtract by far more than that, so slack and rounding
/// never make a certified bound wrong, and slivers thinner than kSlack do not arise.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace oxturn {

struct Vec {
  double x, y;
};  // not initialised: millions are made
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }

inline constexpr double kSlack = 1e-12;

/// normal . x <= reach; `normal` has length 1.
struct HalfPlane {
  Vec normal;
  double reach;
};

/// Counter-clockwise vertices. Each cut adds at most one, so polygons with more than kWide are halved before they are
/// cut.
struct Convex {
  static constexpr std::size_t kWide = 20, kMost = 24;
  std::size_t size;
  std::array<Vec, kMost> at;
  Convex() : size(0) {}
  Convex(const Convex& o) : size(o.size) { copy(o); }  // only the vertices in use
  Convex& operator=(const Convex& o) {
    size = o.size;
    copy(o);
    return *this;
  }
  void add(Vec p) { at[size++] = p; }

 private:
  void copy(const Convex& o) {
    for (std::size_t i = 0; i < o.size; ++i) at[i] = o.at[i];
  }
};

/// An axis-parallel box: `half` on either side of `centre`.
struct Extent {
  Vec centre, half;
};
/// The bounding box; of no pieces, one with negative size.
Extent extent_of(std::span<const Convex> pieces);

Convex box_of(const Extent& extent);
/// Mean of the vertices.
Vec middle_of(const Convex& c);
double area(const Convex& c);
/// Two convex halves; `c` has at least 4 vertices.
std::pair<Convex, Convex> halves(const Convex& c);
/// The part inside `h`: `c` itself, or `cut`, another polygon, which it overwrites; nullptr if nothing is left.
const Convex* clip(const Convex& c, const HalfPlane& h, Convex& cut);
/// Appends the parts on both sides of the line that bounds `h`.
void divide(const Convex& c, const HalfPlane& h, std::vector<Convex>& out);
/// Appends `c` without the intersection of `cut`: convex pieces with disjoint interiors. False, and nothing is
/// appended, if one of the half-planes meets `c` in its boundary at most. `crossing` is working memory.
bool subtract(const Convex& c, const std::vector<HalfPlane>& cut, std::vector<Convex>& out,
              std::vector<HalfPlane>& crossing);
double area(const std::vector<Convex>& pieces);

}  // namespace oxturn
