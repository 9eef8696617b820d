/// Finds where a robot drives over its own taut tether. Private to metrics/.
///
///   CrossingDetector detector(problem.tolerance());
///   for (const Point& to : path) {
///     count += detector.crossings(tether, to).size();      // before the tether is driven
///     tether.drive(to);
///   }
///
/// Fact        While the robot drives straight from a to b, it cannot cross a segment of the tether that appears or
///             disappears on the way: the line ab meets that segment's line at the robot's position at that moment,
///             beyond the bend. So only the segments that exist before the drive are tested, except the last one, and
///             all tests are exact predicates on given points.
///
///                anchor o-----. bend
///                      |      |
///             robot  --+------+-->   crossing: the robot passes over its tether
///
/// Decisions   1. A crossing is a point: several layers of the tether that lie on one line count once.
///             2. If the robot reaches the tether and leaves it to the side from which it came, that is no crossing,
///                however far it drives along it in between. Leaving to the other side is a crossing at the point where
///                it leaves. The contact may extend over several drives. A robot that touches its tether before the
///                first test came from no side.
///             3. At its ends, the anchor and the pivot, the tether cannot be crossed; nor within rounding of the
///                anchor: a path that returns to an anchor passes it on either side by rounding alone.
/// Method      For contacts the drive is shifted by (e, e^2) with an infinitesimal e (simulation of simplicity), so
///             that nothing touches any more. The robot has changed sides if the number of crossings of the shifted
///             drive, from the beginning of the contact to its end, is odd. The tether's segments are kept in a
///             hierarchy of boxes that grows and shrinks at its end, like the tether.
/// Complexity  a drive: O(bends changed by the last drive + segments in boxes that the drive meets)
#pragma once

#include <array>
#include <vector>

#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

class CrossingDetector {
 public:
  /// `rounding`: metres from the anchor within which nothing counts as a crossing.
  explicit CrossingDetector(double rounding) : rounding_(rounding) {}
  /// The points, in driving order and rounded, where the robot crosses its tether on the drive from tether.robot() to
  /// `to`. To be called before each drive of one and the same tether.
  std::vector<Point> crossings(const TautTether& tether, const Point& to);

 private:
  /// The robot touches the consecutive segments first .. last.
  struct Contact {
    std::size_t first, last;
    bool odd;     // number of crossings of the shifted drives so far
    bool counts;  // false: it involves an end of the tether, or the robot came from no side
  };
  /// A crossing.
  struct Candidate {
    Point at;
    std::size_t segment;  // if not exact: `at` is the rounded intersection with this segment's line
    bool exact;           // `at` is a given point
    double along;         // of the drive, 0 to 1
  };

  void follow(const TautTether& tether);
  std::vector<std::size_t> segments_near(const Box& drive) const;
  void add_near(const Box& drive, std::size_t level, std::size_t from, std::size_t until,
                std::vector<std::size_t>& near) const;
  void follow_contacts(const std::vector<std::size_t>& touched, const Point& a, const Point& b,
                       std::vector<Candidate>& found);
  Candidate extend(Contact& contact, const Point& a, const Point& b) const;
  bool inherit(Contact& contact) const;
  bool same(const Candidate& p, const Candidate& q) const;

  double rounding_;
  Polyline points_;  // anchor and bends; segment i leads from point i to point i + 1
  // boxes_[l][i] encloses the kFan^(l + 1) segments from i * kFan^(l + 1) on. It may be too large, because it does not
  // shrink when segments disappear; it disappears with its last segment.
  static constexpr std::size_t kFan = 16, kLevels = 3;
  std::array<std::vector<Box>, kLevels> boxes_;
  std::vector<Contact> contacts_;  // at the robot's position
};

}  // namespace oxturn
