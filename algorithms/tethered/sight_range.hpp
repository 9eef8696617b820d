/// How far one sees from a point, by direction: bounds from above and from below, in slices of a sector.
///
///   SightRange range(node, begin, width, visibility.from(node), tolerance);
///   if (radius > range.farthest(from, to)) skip();     // nothing of this arc is seen
///   if (radius < range.sure(from, to)) keep();         // all of it is
///
/// Complexity  n edges of what is seen: at most 64 slices, O(n log n + slices); farthest() and sure() O(slices), look()
///             O(log n)
#pragma once

#include <algorithm>
#include <utility>
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
  /// Nothing farther away is seen in the slices that meet [from, to], metres.
  double farthest(double from, double to) const;
  /// Everything nearer is seen in the slices from that of `from` to that of `to`, metres; 0 if nothing is known.
  double sure(double from, double to) const;

  /// Is the point at this angle and distance seen? Not known within some tolerances of what bounds the sight.
  /// `direction`: the unit vector at that angle, so that it is worked out once for the point as well.
  enum class Answer { seen, hidden, unknown };
  Answer look(double angle, const Point& direction, double distance) const;

  /// The slice with an angle of the sector, its range, and the angle where it ends.
  std::size_t slice_of(double angle) const;
  double range(std::size_t slice) const { return slices_[slice]; }
  double end_of(std::size_t slice) const { return static_cast<double>(slice + 1) * width_ / count(); }

 private:
  double count() const { return static_cast<double>(slices_.size()); }
  std::vector<Point> border_directions() const;
  void add_edge(const Point& a, const Point& b, const std::vector<Point>& borders);
  void add_edge_from_eye(const Point& b, bool at_eye);
  /// An edge of what is seen, between two angles.
  struct Edge {
    double from, to;
    Point a, b;  // from the eye, at these angles
    double pad;  // radians by which they may be off
  };
  struct Span {
    double least, most;
  };
  static Span distances(const Edge& edge, double angle, const Point& direction);
  void limit_sight(std::size_t slice, double distance) { sure_[slice] = std::min(sure_[slice], distance); }
  void add_span(double from, double to, const Point& a, const Point& b, const std::vector<Point>& borders);

  double begin_ = 0, width_ = 0, tolerance_ = 0;
  std::vector<double> slices_, sure_;
  std::vector<Edge> edges_;                               // in the sector, by `from`; few overlap, by rounding
  double widest_pad_ = 0;                                 // of them
  std::vector<std::pair<double, double>> along_walls_{};  // angles of edges that begin at the eye, 0 to 2 pi; pads
  bool reliable_ = true;                                  // no other edge passes the eye very near
};

}  // namespace oxturn
