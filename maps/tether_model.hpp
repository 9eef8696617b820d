/// What a tether adds to a problem: geodesic distances from the anchor, and what the tether can bend about.
///
///   if (const TetherModel* tether = problem.tether())
///     const double needed = tether->geodesics().distance(p);     // metres of tether to reach p
///
/// A tether's homotopy classes are those of robot paths: a thin string would fit through gaps that the robot can never
/// pass, so these gaps are closed by barriers.
#pragma once

#include <memory>
#include <mutex>

#include "geometry/tether/geodesic_field.hpp"
#include "geometry/tether/taut_tether.hpp"
#include "maps/robot.hpp"

namespace oxturn {

class TetherModel {
 public:
  /// `free`: the map's free space, which must outlive the model. `robot_space`: configuration space of the same robot
  /// without a tether. Distances hold within `tolerance` metres. Where a gap is closed at the anchor, the tether leaves
  /// it on the side of the start only. O(n log n) for n vertices.
  TetherModel(const Region& free, std::shared_ptr<const Region> robot_space, const Robot& robot, const Point& anchor,
              const Point& start, double tolerance);

  /// Where the robot's centre might be if its tether were endless.
  const Region& robot_space() const { return *robot_space_; }
  /// Segments across the gaps of free space that the robot cannot pass.
  const std::vector<Polyline>& closed_gaps() const { return closed_gaps_; }
  /// Geodesic distances from the anchor in free space less the closed gaps.
  const GeodesicField& geodesics() const { return *geodesics_; }
  /// What a taut tether can bend about; no barriers, because a driven path has its class. Built at the first call
  /// (thread-safe).
  const TautSpace& taut_space() const;
  /// Geodesic distance of the farthest point of robot_space().
  double farthest() const { return farthest_; }

 private:
  const Region& free_;
  std::shared_ptr<const Region> robot_space_;
  std::vector<Polyline> closed_gaps_;
  std::unique_ptr<const GeodesicField> geodesics_;
  double farthest_ = 0;
  mutable std::once_flag taut_once_;
  mutable std::unique_ptr<const TautSpace> taut_;
};

/// The part of robot_space() within `length` metres of tether that holds `start`, cut out by a strip as thin as
/// rounding allows, inside of the level set. Throws std::invalid_argument if the start is at the very end of the
/// tether.
struct TetherReach {
  Region space;
  double lost_m2 = 0;  // area by which `space` may be smaller than what the tether reaches
};
TetherReach within_tether(const TetherModel& model, const Robot& robot, const Point& start);

}  // namespace oxturn
