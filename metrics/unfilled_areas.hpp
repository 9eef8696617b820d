/// Areas of a drawing of which a path leaves a part unfilled, as where they are narrower than the tool.
///
///   for (const std::string& sentence : remarks_on(unfilled_areas(problem, path))) say(sentence);
///
/// Areas that are not to be filled are none. Complexity: coverage_of() for each area, by the legs near it.
#pragma once

#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct UnfilledArea {
  std::string element;
  std::size_t area = 0;  // position in the drawing's areas
  double share = 0;      // filled, certified lower bound
};

/// Those with a share below `least`, in the drawing's order. None on a map without a drawing.
std::vector<UnfilledArea> unfilled_areas(const Problem& problem, const Path& path, double least = 0.98);

/// A sentence for each.
std::vector<std::string> remarks_on(const std::vector<UnfilledArea>& areas);

}  // namespace oxturn
