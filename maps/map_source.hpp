/// Where a map comes from, so that it can be loaded again: a file and the reader's settings, or a generator with
/// settings and seed.
///
///   const MapFile file = load_map({.generator = "rooms", .seed = 7}, generators, formats);
#pragma once

#include <cstdint>
#include <string>

#include "maps/formats.hpp"
#include "maps/generators.hpp"

namespace oxturn {

struct MapSource {
  std::string file = {};  // empty: a generator
  std::string generator = {};
  Settings settings = {};   // of the file's reader, or of the generator
  std::uint64_t seed = 1;   // of the generator
  std::string target = {};  // a map file whose free space is the target area; empty: the map's own target area, if any
};

/// The free space that a map file describes, taken as a target area. Throws as read_map() does.
Region load_target_area(const std::string& file, const MapFormats& formats);
/// Throws as read_map() and generate() do.
MapFile load_map(const MapSource& source, const Generators& generators, const MapFormats& formats);

}  // namespace oxturn
