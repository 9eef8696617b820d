/// Where a tethered robot may drive, and the shortest path from its present state to a goal.
///
///   const TetheredWorld world(corners, walls, space, paths, cut_paths, field, tether_length, tolerance);
///   TetheredRobot robot(world, start);
///   if (const auto p = robot.path_to(goal)) robot.drive(p->points);
///
/// Source      Xavier 1999 (untangling); Brass, Vigan and Xu 2015; Salzman and Halperin 2015; Yang, Xiong and Wang 2022
///             (arXiv 2208.03969): the admissible states of one homotopy class are convex, so the best path between two
///             of them is the ordinary shortest path of its class
/// Method      The class of a path is that of the path driven so far, followed by the new one. The robot's own path,
///             pulled taut in its configuration space (its trail), represents the class; the tether itself lies in free
///             space.
#pragma once

#include <functional>
#include <optional>

#include "geometry/edge_index.hpp"
#include "geometry/paths/shortest_path.hpp"
#include "geometry/tether/geodesic_field.hpp"
#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

/// What stays the same while a robot drives. The references must outlive it.
struct TetheredWorld {
  /// `free`: where the tether may lie. `walls`, `paths`: of `space`, where the robot's centre may be. `cut_paths`: in
  /// the part of `space` within the tether length limit, cut open along the field's cut locus and connected to the
  /// start; along its shortest paths the tether is the geodesic. `longest`: the tether length limit; `tolerance`: by
  /// how much rounding may exceed it; metres. Throws std::invalid_argument for a negative limit.
  TetheredWorld(const TautSpace& free, const EdgeIndex& walls, const Region& space, ShortestPaths paths,
                ShortestPaths cut_paths, const GeodesicField& field, double longest, double tolerance);
  bool too_long(const TautTether& tether) const { return tether.length() > longest + tolerance; }

  const TautSpace& free;
  TautSpace space;
  const EdgeIndex& walls;          // of `space`
  ShortestPaths paths, cut_paths;  // in `space` and in the cut space
  const GeodesicField& field;
  double longest, tolerance;
  /// If the caller knows them: a path from the robot's start to a goal outside the cut space, in the class of the
  /// goal's geodesic and within the tether length limit; nullopt if there is none.
  std::function<std::optional<Polyline>(const Point&)> path_out;
};

enum class Retraction {
  automatic,  // the tether can be taken in at any time: the shortest path of all classes
  untangle,   // back along the path driven, pulled taut, until the goal can be reached straight (Xavier 1999)
};

/// The shortest path in `space`, from `start` (in the cut space) to `goal`, in the class of the goal's geodesic: at its
/// end the tether is as long as field.distance(goal). To a goal outside the cut space (separated by walls that the cut
/// locus touches) the path crosses the cut locus and returns; meanwhile the tether is longer than the geodesic by at
/// most `slack` metres. nullopt if there is none, or if the search needs more than `budget` expansions.
std::optional<Polyline> geodesic_path(const TetheredWorld& world, const Point& start, const Point& goal, double slack,
                                      std::size_t budget = 20000);
/// The same where more is known than the paths of the cut space: `known` gives a path from the start to a point in the
/// class of that point's geodesic, or nullopt. The search begins at the last point of the goal's geodesic to which it
/// does.
std::optional<Polyline> geodesic_path(const TetheredWorld& world, const Point& start, const Point& goal, double slack,
                                      const std::function<std::optional<Polyline>(const Point&)>& known,
                                      std::size_t budget = 20000);
/// `line` pulled taut in `space`, with its ends fixed.
Polyline pulled_taut(const TetheredWorld& world, const Polyline& line);

/// Does the tether keep its length limit while the robot drives `path`, if it is the geodesic where that begins? Costs
/// the bends that change, and a look at the others.
bool within_tether(const TetheredWorld& world, const Polyline& path);

struct TetheredPath {
  Polyline points;       // from the robot to the goal, both included
  bool shortest = true;  // proven the shortest of all admissible classes; false: the search's budget ran out
};

class TetheredRobot {
 public:
  /// At `start`, with the tether along the geodesic from the anchor. `world` must outlive it. Throws
  /// std::invalid_argument if the start is not reachable from the anchor.
  TetheredRobot(const TetheredWorld& world, const Point& start);

  /// The shortest path to `goal` along which the tether keeps its length limit; nullopt if there is none. The plain
  /// shortest path is tried first, then other classes by length, and finally the class of the geodesic, which is
  /// admissible for every goal in the cut space. `budget`: expansions of the search for other classes.
  std::optional<TetheredPath> path_to(const Point& goal, Retraction retraction = Retraction::automatic,
                                      std::size_t budget = 2000) const;
  /// The shortest path back to the start after which the tether is as it was there; nullopt as above.
  std::optional<Polyline> path_home() const;
  /// Drives along `points`; a first point equal to the robot's position is skipped.
  void drive(const Polyline& points);

  const TautTether& tether() const { return tether_; }
  /// The path driven from the start, pulled taut in the robot's space.
  const TautTether& trail() const { return trail_; }
  const Point& at() const { return tether_.robot(); }

 private:
  std::optional<TetheredPath> path_by_start(const Point& goal, std::size_t budget) const;

  const TetheredWorld* world_;
  TautTether tether_;  // in free space
  TautTether trail_;   // in the robot's space
};

}  // namespace oxturn
