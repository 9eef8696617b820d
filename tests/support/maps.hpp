// Maps by the generators and readers that come with oxturn, made once for all tests.
#pragma once

#include <string>

#include "maps/formats.hpp"
#include "maps/generators.hpp"

namespace oxturn {

inline const Generators& built_in_maps() {
  static const Generators all = built_in_generators();
  return all;
}
inline const MapFormats& built_in_formats() {
  static const MapFormats all = built_in_map_formats();
  return all;
}

inline Map generate(const std::string& generator, const Settings& settings, std::uint64_t seed) {
  return generate(generator, settings, seed, built_in_maps());
}
inline MapFile read_map(const std::string& file, const Settings& settings = {}) {
  return read_map(file, settings, built_in_formats());
}

}  // namespace oxturn
