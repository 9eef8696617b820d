/// How far one sees from a point, by direction: in slices of a sector, never less than it really is.
///
///   SightRange range(node, begin, width, visibility.from(node), tolerance);
///   if (radius > range.farthest(from, to)) skip();     // nothing of this arc is seen
///
/// Complexity  n edges of what is seen: at most 64 slices, O(n + slices); farthest() O(slices)
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

class SightRange {
 public:
  SightRange() = default;
  /// `begin`: direction of the sector's right side; angles, in radians, count from there, counter-clockwise, up to
  /// `width`. `seen`: what is visible from `eye`, counter-clockwise. `tolerance`: metres.
  SightRange(const Point& eye, double begin, double width, const Ring& seen, double tolerance);

  /// Something is seen at this angle and distance as well.
  void add(double angle, double distance);
  /// Over the slices that meet [from, to], metres.
  double farthest(double from, double to) const;

  /// The slice with an angle of the sector, its range, and the angle where it ends.
  std::size_t slice_of(double angle) const;
  double range(std::size_t slice) const { return slices_[slice]; }
  double end_of(std::size_t slice) const { return static_cast<double>(slice + 1) * width_ / count(); }

 private:
  double count() const { return static_cast<double>(slices_.size()); }
  void add_edge(const Point& a, const Point& b, double begin);
  void add_edge_from_eye(const Point& b, double begin);
  void add_span(double from, double to, const Point& a, const Point& b, double begin);

  double width_ = 0, tolerance_ = 0;
  std::vector<double> slices_;
};

}  // namespace oxturn
