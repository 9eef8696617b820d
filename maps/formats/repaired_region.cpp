// Repairs what a map file describes, and says what changed.
#include "geometry/overlay/validity.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {

Region repaired_region(const Region& written, const std::string& file, std::vector<std::string>& remarks) {
  Region free;
  try {
    free = repaired(written);
  } catch (const std::invalid_argument& e) { throw_invalid("{}: {}", file, e.what()); }
  if (free.empty()) throw_invalid("{}: the polygons have no area", file);
  const auto note = [&](std::size_t before, std::size_t after, const char* what, const char* why) {
    if (before != after) remarks.push_back(fmt::format("repaired: {} {} became {}{}", before, what, after, why));
  };
  note(written.polygons.size(), free.polygons.size(), "polygons", "");
  note(hole_count(written), hole_count(free), "holes",
       " (those that touch each other are united, those that touch the boundary cut out)");
  note(vertex_count(written), vertex_count(free), "vertices", "");
  return free;
}

}  // namespace oxturn
