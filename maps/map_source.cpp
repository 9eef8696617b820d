#include "maps/map_source.hpp"

namespace oxturn {

Region load_target_area(const std::string& file, const MapFormats& formats) {
  return read_map(file, {}, formats).map.free;
}

MapFile load_map(const MapSource& source, const Generators& generators, const MapFormats& formats) {
  MapFile file;
  if (source.file.empty())
    file.map = generate(source.generator, source.settings, source.seed, generators);
  else
    file = read_map(source.file, source.settings, formats);
  if (!source.target.empty()) file.map.target_area = load_target_area(source.target, formats);
  return file;
}

}  // namespace oxturn
