#include "algorithms/improve/part.hpp"

#include <algorithm>
#include <stdexcept>

namespace oxturn {

const std::vector<std::string>& part_names() {
  static const std::vector<std::string> names{"none",    "starts",     "laps",     "unrepaired", "heat",
                                              "windows", "reordering", "covering", "walls",      "focus",
                                              "closing", "strokes",    "detours"};
  return names;
}

AnnealingPart part_named(const std::string& name) {
  const auto at = std::ranges::find(part_names(), name);
  if (at == part_names().end()) throw std::invalid_argument("unknown part '" + name + "'");
  return static_cast<AnnealingPart>(at - part_names().begin());
}

}  // namespace oxturn
