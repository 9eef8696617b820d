// Where a robot on a leash may drive, and how it gets from one place to another.
//
// Source      Xavier 1999 (untangle); Brass, Vigan, Xu 2015; Salzman & Halperin 2015; Yang, Xiong, Wang 2022
//             (arXiv 2208.03969): the admissible states of one class are convex, so the best way between two admissible
//             states is the ordinary shortest path of its class
// Method      A way's class is that of the way already driven, then the new one. The robot's own way, pulled taut in its
//             configuration space (the shadow), stands for the class; the string itself lies in free space.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "geometry/paths/shortest_path.hpp"
#include "geometry/tether/geodesic_field.hpp"
#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

/// What does not change while a robot drives. The regions must outlive it.
class TetheredWorld {
 public:
  /// `free`: where the string may lie. `space`: where the robot's centre may be. `cut_space`: the part of `space`
  /// within the leash, cut open along the field's cut locus, that holds the start: its shortest paths keep the string
  /// equal to the geodesic. `longest`: the leash, metres; `tolerance`: metres by which rounding may exceed it.
  TetheredWorld(const Region& free, const Region& space, const Region& cut_space, const GeodesicField& field,
                double longest, double tolerance);
  ~TetheredWorld();
  struct Impl;
  const Impl& impl() const { return *impl_; }

 private:
  std::unique_ptr<const Impl> impl_;
};

enum class Retraction {
  automatic,  // taken up at any time: the shortest way of all classes
  untangle,   // back along the way driven (pulled taut) until the goal is in straight reach, then go (Xavier)
};

/// The shortest way in `space` from `start` (of the cut space) to `goal` in the class of the goal's geodesic: at its end the
/// string is as long as field.distance(goal). For a goal outside of the cut space (cut off by walls that the cut
/// touches) the way crosses the cut and back; while it does, the string is at most `slack` metres longer than the
/// geodesic. nullopt if there is none, or `budget` expansions find none.
std::optional<Polyline> geodesic_path(const TetheredWorld& world, const Point& start, const Point& goal, double slack,
                                      std::size_t budget = 20000);
/// `line` pulled taut in `space`, ends fixed.
Polyline pulled_taut(const TetheredWorld& world, const Polyline& line);

class TetheredRobot {
 public:
  /// Stands at `start`, the string along the geodesic from the anchor. `world` must outlive it.
  TetheredRobot(const TetheredWorld& world, const Point& start);

  struct Way {
    Polyline points;        // from the robot to the goal, both included
    double tether_max = 0;  // metres, largest along the way
    double tether_end = 0;  // metres, at the goal
    bool shortest = true;   // proven the shortest of all admissible classes (false: the search's budget ran out)
  };
  /// The shortest way to `goal` that keeps the string within the leash all along; nullopt if there is none (the goal is
  /// out of reach). First the plain shortest path, then other classes by length, at last the class of the geodesic,
  /// which is admissible for every goal of the cut space. `budget`: expansions of the search for other classes.
  std::optional<Way> path_to(const Point& goal, Retraction retraction = Retraction::automatic,
                             std::size_t budget = 2000) const;
  /// The shortest way back to the start that leaves the string as it was there; nullopt as above.
  std::optional<Way> path_home() const;
  /// Drives along `points` (a first point equal to the robot's place is skipped).
  void drive(const Polyline& points);

  const TautTether& string() const { return string_; }
  const Point& at() const { return string_.robot(); }

 private:
  /// Back to the start, then on: where the cut space does not hold the goal and the search does not find it.
  std::optional<Way> path_by_start(const Point& goal, std::size_t budget) const;

  const TetheredWorld* world_;
  TautTether string_;  // in free space
  TautTether shadow_;  // the way driven from the start, pulled taut in the robot's space
};

}  // namespace oxturn
