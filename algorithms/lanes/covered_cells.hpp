/// Which cells of a grid over a region lines certainly cover: what may be uncovered lies in the others, mostly few.
///
///   const auto open = in_open_cells(target, {{lines, tool_width / 2, seam}});
///   if (open) left = subtract(open->region, swath_parts(open->near[0], ...));   // in place of the whole target
///
/// Curves of many short segments stand for themselves only where a cell is not covered by chords, under a tool narrower
/// by what these are off. The certificate errs by a quarter of the seam at most: so much wider is the tool.
/// O(n log n) for n segments and vertices, if few come near each cell; there are at most as many cells as segments.
#pragma once

#include <optional>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// Of the seam: so much wider is the tool where it is decided without an overlay what it covers.
inline constexpr double kSeamShare = 0.25;

/// Lines about which what is nearer than `radius` is covered; up to `seam` more may count as covered.
struct WideLines {
  std::vector<Polyline> lines;
  double radius, seam;
};

struct OpenCells {
  Region region;                            // the part of the region in cells that are not certainly covered
  std::vector<std::vector<Polyline>> near;  // for each of the given lines: their segments that reach these cells
};

/// nullopt where an overlay costs less: few segments, or more cells than segments.
std::optional<OpenCells> in_open_cells(const Region& region, const std::vector<WideLines>& lines);

}  // namespace oxturn
