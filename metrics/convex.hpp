// Small convex polygons and the two things the sweep does with them: clip and subtract. Internal to metrics/.
//
// Coordinates are relative to a tile's centre, in tile sides, so everything is about 1 in size. A point counts as
// inside a half-plane up to kSlack beyond it: callers shrink what they subtract by far more than that, so slack
// and rounding never make a certified bound wrong, and slivers thinner than kSlack never arise.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace oxturn {

struct Vec {
  double x, y;
};  // left unset: these are made by the million
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y; }
inline double cross(Vec a, Vec b) { return a.x * b.y - a.y * b.x; }

inline constexpr double kSlack = 1e-12;

/// normal . x <= reach; `normal` has length 1.
struct HalfPlane {
  Vec normal;
  double reach;
};

/// Counter-clockwise. Cutting off a corner adds one, so larger ones than kWide are split before they are cut.
struct Convex {
  static constexpr std::size_t kWide = 20, kMost = 24;
  std::size_t size;
  std::array<Vec, kMost> at;
  Convex() : size(0) {}
  Convex(const Convex& o) : size(o.size) { copy(o); }  // only the corners that are there
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

/// Axis-parallel: `half` each way from `centre`.
struct Extent {
  Vec centre, half;
};
Extent extent_of(const std::vector<Convex>& pieces);

double area(const Convex& c);
/// Two convex halves; `c` has at least 4 corners.
std::pair<Convex, Convex> halves(const Convex& c);
/// The part inside `h`.
Convex clipped(const Convex& c, const HalfPlane& h);
/// pieces \ (intersection of `cut`), again as convex pieces with disjoint interiors. `spare` is working room.
void subtract(std::vector<Convex>& pieces, const std::vector<HalfPlane>& cut, std::vector<Convex>& spare);
double area(const std::vector<Convex>& pieces);

}  // namespace oxturn
