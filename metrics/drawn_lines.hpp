/// The segments of a path by position, and which part of a segment lies near them. Private to metrics.
///
///   const PathSegments work(path, tool_width);
///   Cover cover;
///   work.for_each_near(a, b, reach, [&](const PathSegment& s) {
///     cover.add(within(a, b, s.a, s.b, reach));
///     return cover.is_whole();
///   });
///   drawn += cover.share() * distance(a, b);
///
/// For the metrics of drawings.
#pragma once

#include <algorithm>
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

/// The segments of all legs' lines with the tool on. O(n log n). Those of each width lie in a grid of their own, so
/// that what is asked for a narrow part of the tool does not look as far as the whole tool reaches.
class PathSegments {
 public:
  PathSegments(const Path& path, double tool_width);
  bool empty() const { return widths_.empty(); }
  /// Of the first leg with the tool on that has a length; only if not empty.
  std::size_t first_leg() const { return first_leg_; }
  /// Calls f(segment) for every segment that comes within `reach` of ab, some more than once, and for others, until f
  /// returns true.
  template <class F>
  void for_each_near(const Point& a, const Point& b, double reach, F f) const {
    for (const OfWidth& w : widths_)
      if (w.for_each_near(a, b, reach, f)) return;
  }
  /// The same for what comes nearer than half its own width and `growth`, which may be negative.
  template <class F>
  void for_each_touching(const Point& a, const Point& b, double growth, F f) const {
    for (const OfWidth& w : widths_)
      if (const double reach = w.segments.front().width / 2 + growth; reach >= 0 && w.for_each_near(a, b, reach, f))
        return;
  }

 private:
  struct OfWidth {
    template <class F>
    bool for_each_near(const Point& a, const Point& b, double reach, F& f) const {
      return grid.visit_items(std::array{a, b}, reach, [&](std::uint32_t i) { return f(segments[i]); });
    }
    std::vector<PathSegment> segments;  // in driving order
    UniformGrid grid;
  };
  std::vector<OfWidth> widths_;  // ascending
  std::size_t first_leg_ = 0;
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
  /// Whether one of the parts is the whole segment: no other part matters.
  bool is_whole() const { return !parts_.empty() && parts_.back().from <= 0 && parts_.back().to >= 1; }
  /// Covered share of the segment; sorts.
  double share();
  /// Covered by this but not by `other`.
  double share_without(Cover& other);

 private:
  std::vector<LinePart> united();
  std::vector<LinePart> parts_;
};

}  // namespace oxturn
