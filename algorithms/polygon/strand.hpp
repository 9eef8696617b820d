/// A path over laps into which others are spliced: each of its segments knows on which lap it lies.
///
///   Strand spiral = ...;                                    // a first path, e.g. over the outermost laps
///   SplicedPath path(spiral, graph.size());
///   if (const auto cut = path.cut(parent, child.front(), child.back(), reach, longest)) path.splice(*cut, child);
///   drive(path.points());
///
/// A splice takes a piece of one lap out of the path and leads to the ends of another path instead:
///
///     parent  --->--.        .--->---
///                   |        |
///     child         '--....--'
///
/// A cut costs the path's segments on one lap near its ends, and a 64th of all on that lap; a splice the points spliced
/// in.
#pragma once

#include <optional>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

/// points[i] to points[i + 1] lies on lap[i], or links two laps; as many entries as points, the last one is not used.
struct Strand {
  static constexpr std::size_t kLink = static_cast<std::size_t>(-1);
  Polyline points = {};
  std::vector<std::size_t> lap = {};

  /// Appends a line on a lap (kLink: a link) that begins where the strand ends.
  void add(const Polyline& line, std::size_t on);
  void reverse();
};

class SplicedPath {
 public:
  SplicedPath(const Strand& first, std::size_t laps);

  struct Position {
    std::size_t node = 0;
    Point at{0, 0};
    double along = 0, distance = 0;  // from the node; from the point asked for
  };
  struct Cut {
    Position first, last;    // in driving order
    bool backwards = false;  // the strand's end is next to `first`
  };
  /// Where the strand from `begin` to `end` can be spliced into `lap`: next to both ends within `reach`, with at most
  /// `longest` metres of that lap and nothing else in between.
  std::optional<Cut> cut(std::size_t lap, const Point& begin, const Point& end, double reach, double longest) const;
  void splice(const Cut& cut, Strand strand);
  Polyline points() const;

 private:
  static constexpr std::size_t kEnd = static_cast<std::size_t>(-1);
  struct Node {
    Point at;
    std::size_t lap;   // of the segment to the next node; kDropped: no longer part of the path
    std::size_t next;  // kEnd: the last
  };
  static constexpr std::size_t kDropped = static_cast<std::size_t>(-2);
  static constexpr std::size_t kBlock = 64;
  /// The nodes on a lap, dropped ones too, with a box about the segments of each block of them. Splices shorten
  /// segments and add some, but move none.
  struct Lap {
    std::vector<std::size_t> nodes;
    std::vector<Box> boxes;
    void add(std::size_t node, const Point& from, const Point& to);
  };

  std::size_t append(const Strand& strand);
  std::optional<Position> nearest(std::size_t lap, const Point& p, double reach) const;
  /// From a to b along the path at most `longest` metres, all on the lap of a.
  bool follows(const Position& a, const Position& b, double longest) const;

  std::vector<Node> nodes_;
  std::vector<Lap> on_lap_;
};

}  // namespace oxturn
