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
  Settings settings = {};  // of the file's reader, or of the generator
  std::uint64_t seed = 1;  // of the generator
};

/// Throws as read_map() and generate() do.
MapFile load_map(const MapSource& source, const Generators& generators, const MapFormats& formats);

}  // namespace oxturn
