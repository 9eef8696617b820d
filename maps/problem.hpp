/// Map + robot + start: what a planner is given. Computes configuration space and target once and hands them out.
///
///   const Problem problem(map, robot, Point(1, 1));
///   problem.configuration_space();                       // where the robot's centre may be
///   problem.transit().path(from, to);                    // shortest collision-free paths
#pragma once

#include <memory>
#include <optional>

#include "geometry/edge_index.hpp"
#include "geometry/paths/shortest_path.hpp"
#include "maps/map.hpp"
#include "maps/tether_model.hpp"

namespace oxturn {

class Problem {
 public:
  /// Erodes the map by the robot (inside bound; of a disc, chord error tool_width / 1000) and keeps the connected
  /// component that contains the start. A passage must be wider than 2 radius + tool_width / 500 to count as open; for
  /// a polygonal footprint, wider than the robot across the passage plus about 2^-25 of the map's extent.
  /// No start: `default_start`. Throws std::invalid_argument in one sentence: a bad robot, an invalid or empty
  /// map, a robot that fits nowhere, a target area of which nothing can be covered, "start (2, 3) is inside a wall of
  /// 'rooms-7'; nearest point where the robot fits: (2.14, 3.31)", a start that is not finite, an anchor outside free
  /// space.
  Problem(Map map, Robot robot, std::optional<Point> start = {}, std::optional<Point> anchor = {});

  const Map& map() const;
  const Robot& robot() const;
  const Point& start() const;
  const Point& anchor() const;  // by default the start

  /// Where the robot's centre may be: one polygon with holes. Closed. With a tether: that part of
  /// tether()->robot_space() which the tether reaches (geodesics().distance <= length) and which holds the start.
  const Region& configuration_space() const;
  /// What can be covered: configuration space (+) disc(tool_width / 2), within free space and the map's target area,
  /// if it has one; `target` errs inside, and `target_excess` bounds from above the area by which the true target is
  /// larger (m^2).
  const Region& target() const;
  double target_excess() const;
  /// Where the robot works: the part of configuration space within tool_width / 2 of the target. All of it without a
  /// target area; with one, planners work there and drive anywhere in configuration space. It may have several
  /// components. Built at the first call (thread-safe).
  const Region& work_space() const;

  /// Geodesic distances from the anchor and all else that a tether brings along; nullptr for robots without one.
  const TetherModel* tether() const;

  /// Shortest paths in configuration space (or see Transit::shared); built at the first call (thread-safe).
  const ShortestPaths& transit() const;
  /// Edges of configuration space; built at the first call (thread-safe).
  const EdgeIndex& walls() const;
  /// Edges of the map's free space; built at the first call (thread-safe), shared with restricted problems.
  const EdgeIndex& map_edges() const;
  /// Are the map's walls staircases (geometry/staircase.hpp) of steps shorter than half the tool width? Found at the
  /// first call (thread-safe), shared with restricted problems.
  bool has_staircase_walls() const;
  /// How far outside configuration space a point may lie by rounding alone: 1e-6 of the tool width plus
  /// 1e-12 of the largest coordinate.
  double tolerance() const;

  /// Configuration space ends elsewhere than near the map's walls: by a tether's length, or by restricted().
  bool limited() const;

  /// Where a restricted problem's shortest paths may lead: through its own configuration space, or through all of this
  /// problem's, which spares a triangulation.
  enum class Transit { own, shared };
  /// The same problem with a smaller configuration space (which must hold the start); the target stays. A
  /// wrapper gives an ordinary planner less room this way.
  Problem restricted(Region configuration_space, Transit transit = Transit::own) const;
  /// The same with another start.
  Problem restricted(Region configuration_space, const Point& start) const;

  /// The same problem for a robot without min_turn_radius.
  Problem turning_on_the_spot() const;

  /// SHA-256 of map, robot, start and anchor in canonical form.
  std::string content_hash() const;

 private:
  struct Impl;
  explicit Problem(std::shared_ptr<const Impl>);
  std::shared_ptr<const Impl> impl_;
};

/// Where a robot starts by default: at the roomiest point (Mesh::roomiest_point) of free space, or of a target area
/// that is no drawing if the robot fits there, of those in the largest component of configuration space. Well inside,
/// always the same.
Point default_start(const Map& map, const Robot& robot);

}  // namespace oxturn
