/// A simulated 2-D lidar on the true map.
///
///   const LidarSimulator lidar(map.free, *robot.lidar);
///   const Scan scan = lidar.scan(pose, rng);
///
/// Rays leave the lidar evenly, the first along the x axis, whatever the robot's heading. A ray ends where it first
/// meets a wall; one that meets none within the range gives no reading. Noise is Gaussian, along the ray.
/// Build O(vertices); a scan O(rays * (cells and edges along a ray)).
#pragma once

#include <vector>

#include "base/random.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/uniform_grid.hpp"
#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// The readings of one turn of the lidar: all that an online planner ever learns of the map.
struct Scan {
  Point eye{0, 0};
  Lidar lidar;
  std::vector<double> reading;  // metres, one for each ray; infinity: nothing within the range

  double step() const { return 2 * kPi / static_cast<double>(reading.size()); }  // radians between two rays
};

/// Unit vectors of `rays` rays, counter-clockwise from (1, 0).
std::vector<Point> ray_directions(int rays);

class LidarSimulator {
 public:
  /// Throws std::invalid_argument for a lidar without rays or range, or with noise below 0.
  LidarSimulator(const Region& free, const Lidar& lidar);
  /// `eye` lies in free space. Draws from `rng` only if there is noise: two or more numbers for each reading.
  Scan scan(const Point& eye, Rng& rng) const;

 private:
  double cast(const Point& eye, const Point& direction) const;

  Lidar lidar_;
  std::vector<Point> direction_;
  std::vector<EdgeIndex::Edge> edges_;
  UniformGrid grid_;
};

}  // namespace oxturn
