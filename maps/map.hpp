// The free space, and the robot that is to sweep it.
#pragma once

#include <optional>
#include <string>

#include "geometry/region.hpp"
#include "maps/parameters.hpp"

namespace oxturn {

struct Map {
  std::string name;
  Region free;         // metres, canonical (see region.hpp)
  std::string family;  // generator's name, or "file"
  std::string source;  // "rooms --seed 7 --set rooms=9", or the file's path as given
};

struct Tether {
  double length = 0;
};  // metres
struct Lidar {
  double range = 0;
  int rays = 0;
};  // metres, evenly spaced rays

/// Disc footprint. Convex polygonal footprints come with the planner that needs them.
struct Robot {
  std::string name = "disc";
  double radius = 0.2;         // metres, >= 0
  double tool_width = 0.4;     // metres, > 0
  double speed = 0.5;          // m/s, > 0
  double acceleration = 0.5;   // m/s^2, > 0
  double turn_rate = 1.5;      // rad/s, > 0
  double min_turn_radius = 0;  // metres, >= 0; 0: turns on the spot
  std::optional<Tether> tether;
  std::optional<Lidar> lidar;
};

/// Throws std::invalid_argument in one sentence ("robot 'disc': tool_width is 0, expected metres above 0").
void check(const Robot& robot);

/// Canonical bytes of a region: rings rotated to their smallest corner, polygons and holes sorted, doubles as
/// big-endian bits (-0 as 0). Equal point sets in equal rings give equal bytes however they were written down.
std::string canonical_bytes(const Region& region);
/// One double as canonical_bytes writes it: eight big-endian bytes, -0 as 0.
void append_canonical(std::string& bytes, double value);
/// Lower-case hex SHA-256.
std::string sha256(const std::string& bytes);
/// Content address of a map: sha256 of the canonical bytes of its free space (name and source do not count).
std::string content_hash(const Map& map);

}  // namespace oxturn
