// A simulated 2-D lidar on the true map.
//
// Rays go out evenly spaced from heading 0 (the x axis, whatever way the robot looks). A ray ends where it first meets a
// wall; one that meets none within the range gives no reading. Noise is Gaussian, along the ray.
// Complexity  build O(corners); a scan O(rays * (cells and edges on the way of a ray))
#pragma once

#include <vector>

#include "geometry/uniform_grid.hpp"
#include "geometry/edge_index.hpp"
#include "base/random.hpp"
#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// What one turn of the lidar saw: all that an online planner ever learns of the map.
struct Scan {
  Point eye{0, 0};
  Lidar lidar;
  std::vector<double> reading;  // metres, one a ray; infinity: nothing within the range

  double step() const { return 2 * kPi / static_cast<double>(reading.size()); }  // radians between two rays
};

/// Unit vectors of `rays` rays, counter-clockwise from (1, 0).
std::vector<Point> ray_directions(int rays);

class LidarSimulator {
 public:
  /// Throws std::invalid_argument for a lidar without rays, range or with noise below 0.
  LidarSimulator(const Region& free, const Lidar& lidar);
  /// `eye` in free space. Draws from `rng` only if there is noise: two or more numbers a reading.
  Scan scan(const Point& eye, Rng& rng) const;

 private:
  double cast(const Point& eye, const Point& direction) const;

  Lidar lidar_;
  std::vector<Point> direction_;
  std::vector<EdgeIndex::Edge> edges_;
  UniformGrid grid_;
};

}  // namespace oxturn
