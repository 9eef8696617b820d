/// The segments of a path by position, and which part of a segment lies near them. Private to metrics.
///
///   const PathSegments work(path, tool_width);
///   Cover cover;
///   work.for_each_near(a, b, reach, [&](const PathSegment& s) { cover.add(within(a, b, s.a, s.b, reach)); });
///   drawn += cover.share() * distance(a, b);
///
/// For the metrics of drawings.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/path.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

struct PathSegment {
  Point a{0, 0}, b{0, 0};
  std::size_t leg = 0;
  double width = 0;  // metres of the tool that are used
};

/// Metres of the tool that a leg uses.
double width_of(const Leg& leg, double tool_width);
/// A leg's line. If vertices are less than a millimetre apart on average it is thinned (thinned.hpp), within 0.01 mm.
Polyline line_of(const Leg& leg);

/// The segments of all legs' lines with the tool on, in driving order. O(n).
class PathSegments {
 public:
  PathSegments(const Path& path, double tool_width);
  const std::vector<PathSegment>& all() const { return all_; }
  /// Calls f(segment) for every segment that comes within `reach` of ab, some more than once, and for others.
  template <class F>
  void for_each_near(const Point& a, const Point& b, double reach, F f) const {
    if (all_.empty()) return;
    grid_.visit(std::array{a, b}, reach, [&](std::size_t cell) {
      for (const std::uint32_t i : grid_.items(cell)) f(all_[i]);
      return false;
    });
  }

 private:
  std::vector<PathSegment> all_;
  UniformGrid grid_;
};

/// A part of a segment, as fractions of its length.
struct LinePart {
  double from, to;
};
/// The part of ab within `reach` of the segment cd: a capsule is convex, so it is one part.
std::optional<LinePart> within(const Point& a, const Point& b, const Point& c, const Point& d, double reach);

/// A union of parts of one segment.
class Cover {
 public:
  void add(const std::optional<LinePart>& part) {
    if (part) parts_.push_back(*part);
  }
  /// Covered share of the segment; sorts.
  double share();
  /// Covered by this but not by `other`.
  double share_without(Cover& other);

 private:
  std::vector<LinePart> united();
  std::vector<LinePart> parts_;
};

}  // namespace oxturn
