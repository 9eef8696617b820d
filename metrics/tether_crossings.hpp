// Where a robot drives over its own tether. Internal to metrics/.
//
// Fact        While the robot drives straight from a to b, no segment of the string that is gained or lost on the way can
//             be crossed: the line ab meets that segment's line where the robot stands at that moment, beyond the bend.
//             So it is enough to ask the segments that are there before the drive, all but the last one, and every
//             question is about given points: exact predicates decide.
// Decisions   1. A crossing is a place: layers of the string that lie on one line count once.
//             2. Coming to the string and leaving on the side from which one came is no crossing, however long the robot
//                drives along it in between; leaving on the other side is one, at the place where it leaves. That may be
//                drives later. A robot that stands on its string when it is first looked at came from no side.
//             3. At its ends, the anchor and the pivot, there is nothing to cross.
// Method      Sides at contacts: the robot's way is shifted by (e, e^2) for an infinitesimal e, so nothing touches any
//             more; an odd number of crossings with the shifted way from coming to leaving means that sides changed.
//             The string's segments lie in a hierarchy of boxes that grows and shrinks at its end, as the string does.
// Complexity  a drive costs O(bends that the last one changed + segments in boxes that it meets)
#pragma once

#include <array>
#include <vector>

#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

class OwnLine {
 public:
  /// The robot drives from string.robot() to `to`. Asked before each drive of the one string. Places on the way, in
  /// driving order, rounded, at which it has crossed the line.
  std::vector<Point> crossed(const TautTether& string, const Point& to);

 private:
  /// The robot is on segments first .. last, which follow each other.
  struct Contact {
    std::size_t first, last;
    bool odd, counts;
  };
  /// Where: at the point, or where the way meets the line of segment `line`.
  struct Location {
    Point at;
    std::size_t line;
    bool exact;
    double along;
  };
  /// Takes over the string as it is now.
  void follow(const TautTether& string);
  /// Of blocks from .. until - 1 of a level (of segments, below the lowest), what the box of the way overlaps.
  void find_near(const Box& way, std::size_t level, std::size_t from, std::size_t until,
                 std::vector<std::size_t>& near) const;
  void meet_contacts(const std::vector<std::size_t>& touched, const Point& a, const Point& b,
                     std::vector<Location>& places);
  bool same(const Location& p, const Location& q) const;

  Polyline corners_;  // anchor and bends; segment i goes from i to i + 1
  // boxes_[l][i] holds the kFan^(l + 1) segments from i * kFan^(l + 1) on, and perhaps more: for segments that are gone a
  // box does not shrink, but it goes with the last one in it.
  static constexpr std::size_t kFan = 16, kLevels = 3;
  std::array<std::vector<Box>, kLevels> boxes_;
  std::vector<Contact> contacts_;  // at the robot's place
};

}  // namespace oxturn
