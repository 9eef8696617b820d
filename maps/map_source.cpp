#include "maps/map_source.hpp"

namespace oxturn {

MapFile load_map(const MapSource& source, const Generators& generators, const MapFormats& formats) {
  if (!source.file.empty()) return read_map(source.file, source.settings, formats);
  MapFile file;
  file.map = generate(source.generator, source.settings, source.seed, generators);
  return file;
}

}  // namespace oxturn
