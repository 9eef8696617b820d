/// Which elements of a drawing lie inside which others.
///
///   for (const auto& [outer, inner] : contained_elements(elements, ContainmentTest::overlay)) ...
///
/// Elements inside a closed stroke or a filled area are drawn before it, so that the robot need not enter it again.
/// Source: Vollprecht 2014, sections 2.3.2 and 3.4. O(n^2) box tests for n elements, and some hundred point locations
/// for each pair whose boxes lie inside each other.
#pragma once

#include <utility>
#include <vector>

#include "algorithms/drawing/element.hpp"

namespace oxturn {

/// overlay: at most a thousandth of the inner one's length is outside the outer one. hull, as the program of Vollprecht
/// 2014: the convex hull of the outer one holds the first point of the inner one (or the last, of a polyline).
enum class ContainmentTest { overlay, hull };

/// Pairs (outer, inner): for each element the smallest one that contains it. Of two that contain each other the earlier
/// one is inside.
std::vector<std::pair<std::size_t, std::size_t>> contained_elements(const std::vector<DrawingElement>& elements,
                                                                    ContainmentTest test);

/// Pairs of a fill and one of the same area, near it, with a narrower part of the tool. If narrow parts, which fill an
/// area's corners, are driven first, transits between them may cross the area. Fills of an area are consecutive.
/// O(n + k^2) for k fills of an area.
std::vector<std::pair<std::size_t, std::size_t>> narrower_fills(const std::vector<DrawingElement>& elements);

}  // namespace oxturn
