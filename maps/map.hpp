/// A map: the free space that a robot is to cover, and where it came from.
///
///   Map map{"hall", box({0, 0}, {8, 5}), "file", "hall.geojson"};
///   content_hash(map);                      // its address
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "geometry/region.hpp"
#include "maps/drawing.hpp"

namespace oxturn {

struct Map {
  std::string name;
  Region free;         // metres, canonical (see region.hpp)
  std::string family;  // generator's name, or "file"
  std::string source;  // "rooms --seed 7 --set rooms=9", or the file's path as given
  /// The part of the map that is to be covered; the robot may drive anywhere in free space. By default all of it, and
  /// of a drawing what it marks.
  std::optional<Region> target_area = {};
  /// What a drawing robot is to draw on this map, its canvas; usually nothing.
  std::shared_ptr<const Drawing> drawing = {};
};

/// Canonical bytes of a region: rings rotated to their smallest vertex, polygons and holes sorted, doubles as
/// big-endian bits (-0 as 0). Equal rings give equal bytes however they were written down.
std::string canonical_bytes(const Region& region);
/// Of the map's free space, and of its target area if it has one: name and source do not count.
std::string canonical_bytes(const Map& map);
/// Content address of a map: SHA-256 of its canonical bytes.
std::string content_hash(const Map& map);

}  // namespace oxturn
