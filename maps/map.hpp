// The free space, and the robot that is to sweep it.
#pragma once

#include <optional>
#include <string>

#include "geometry/region.hpp"
#include "base/parameters.hpp"

namespace oxturn {

struct Map {
  std::string name;
  Region free;         // metres, canonical (see region.hpp)
  std::string family;  // generator's name, or "file"
  std::string source;  // "rooms --seed 7 --set rooms=9", or the file's path as given
};

struct Tether {
  double length = 0;  // metres, > 0
  double reach = 0;   // > 0 in place of a length: that many times the farthest place's geodesic distance
                      // (Problem works it out; the robot that it hands on has a length)
  double sharp_angle =
      kPi * 3 / 4;  // radians in (0, pi]: a heading turned farther from "straight away from the string's
                    // pull" counts as sharp
};
struct Lidar {
  double range = 0;  // metres, > 0
  int rays = 0;      // evenly spaced from heading 0, >= 1
  double noise = 0;  // metres along the ray, standard deviation, >= 0
};

struct Robot {
  std::string name = "disc";
  double radius = 0.2;         // metres, >= 0; with a footprint Problem puts in_radius(footprint) here
  double tool_width = 0.4;     // metres, > 0
  double speed = 0.5;          // m/s, > 0
  double acceleration = 0.5;   // m/s^2, > 0
  double turn_rate = 1.5;      // rad/s, > 0
  double min_turn_radius = 0;  // metres, >= 0; 0: turns on the spot
  std::optional<Tether> tether;
  std::optional<Lidar> lidar;
  /// Empty: a disc. Else a convex polygon about the robot's centre, which lies strictly inside; counter-clockwise, metres.
  /// Its orientation stays as given: such a robot drives in all directions without turning.
  Ring footprint = {};
};

/// "square:0.5" or "octagon:0.5": regular, two sides parallel to each axis, so wide. Throws a sentence for anything else.
Ring named_footprint(const std::string& text);
/// The largest disc about the centre that lies inside the footprint.
double in_radius(const Ring& footprint);
/// From the lowest to the highest place of the robot, metres.
double height(const Robot& robot);

/// Throws std::invalid_argument in one sentence ("robot 'disc': tool_width is 0, expected metres above 0").
void check(const Robot& robot);

/// Canonical bytes of a region: rings rotated to their smallest corner, polygons and holes sorted, doubles as
/// big-endian bits (-0 as 0). Equal point sets in equal rings give equal bytes however they were written down.
std::string canonical_bytes(const Region& region);
/// Content address of a map: sha256 of the canonical bytes of its free space (name and source do not count).
std::string content_hash(const Map& map);

}  // namespace oxturn
