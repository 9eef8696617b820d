/// Where a path through a drawing turns more sharply than the robot can, in words that name what is drawn there.
///
///   for (const std::string& sentence : remarks_on_sharp_bends(problem, path)) say(sentence);
///
/// Complexity: O(n) for the path, and O(m) for each of ten bends and the m vertices of the drawing.
#pragma once

#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// A sentence for each such bend (geometry/bends.hpp), ten at most, and one that says how many more there are. None
/// without a drawing or a least turning radius.
std::vector<std::string> remarks_on_sharp_bends(const Problem& problem, const Path& path);

}  // namespace oxturn
