/// Stops beside a path: positions from which the tool covers a small uncovered piece.
///
///   path = with_stops(path, start, pieces, 0.4995 * w, walls);      // `pieces` keeps those without a stop
///
///        S           The robot leaves the path where it passes the piece, goes towards it until the tool covers all
///       / \          of it, and comes back. Where the path turns and the piece lies outside of the turn, as at the
///      / V \         corners of laps, it leaves the path at A and comes back at B, without V:
///     A.---.B        nothing that the turn covered is lost, and the detour is shorter by a third.
///     |     |
///
/// Guarantee   the tool covers what it covered before, and the pieces that got a stop: let r be its reach, a the angle
///             between the segments at V, |AV| = |VB| <= r min(1, cot(a/2)), and S in the cone opposite to them. Then
///             every point within r of A V B or of V S is within r of A S B or of the rest of the two segments.
/// Complexity  O(n log n) for n segments, and for each piece those near by
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "algorithms/lanes/nearby_segments.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct Stop {
  std::size_t segment;
  double along;  // of the segment, metres
  Point from;    // on the path
  Point at;
  std::optional<std::size_t> turn = {};  // the vertex of the path that is cut off
  double cut = 0;                        // metres before and after that vertex
};
/// Where a stop that cuts off a turn leaves the path, and where it comes back.
std::pair<Point, Point> ends_of_cut(const Stop& stop, const Polyline& path);

class StopFinder {
 public:
  /// `tool`: is it on, for each segment? `reach`: metres from the robot's centre within which the tool covers. `walls`:
  /// those of configuration space. All must outlive it.
  StopFinder(const Polyline& path, const std::vector<bool>& tool, double reach, const EdgeIndex& walls);
  /// For these pieces only: holds the segments of the path near them.
  StopFinder(const Polyline& path, const std::vector<bool>& tool, double reach, const EdgeIndex& walls,
             const std::vector<Polygon>& pieces);
  /// The stop on the shortest detour; nullopt: no position covers the piece, or none in sight of the path does.
  std::optional<Stop> find(const Polygon& piece) const;
  /// Metres of the detour.
  double length(const Stop& stop) const;
  const NearbySegments& segments() const { return segments_; }

 private:
  Point covering(const NearbySegments::Near& from, const Point& centre, const Polygon& piece) const;
  Stop cut_short(Stop stop) const;

  const Polyline& path_;
  const std::vector<bool>& tool_;
  const NearbySegments segments_;
  double reach_;
  const EdgeIndex& walls_;
};

/// The path with stops; `pieces` keeps those without one.
Path with_stops(const Path& path, const Point& start, std::vector<Polygon>& pieces, double reach,
                const EdgeIndex& walls);

}  // namespace oxturn
