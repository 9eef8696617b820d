// The area that the tool sweeps, with certified bounds.
//
// Method      The plane is cut into square tiles of half a tool width. In each tile the convex polygons inscribed
//             in (lower bound) or circumscribed about (upper bound) the capsules of the path's segments are
//             subtracted, one after the other, from the tile; what remains is not covered, and target_rows.hpp
//             measures the target in it. Convex by convex subtraction needs only half-plane clips, so it is robust
//             and fast. Polygons are shrunk or grown by 1e-9 of the tile, far above rounding, so the bounds hold
//             for the real numbers; only the summing of areas rounds (1e-12 of the target).
// Complexity  O(n + tiles touched + capsules per tile + target edges per row); near-linear for real paths.
// Decisions   1. The path counts where it comes within 1.5 tool widths of the target's bounding box: no valid path
//                leaves that, and a wild one costs no more than the map.
//             2. Areas that need no certificate (union, legs, `seen_m2`) are 1/3 inscribed + 2/3 circumscribed,
//                which cancels the leading error of both (Huygens).
//             3. A visit begins in a segment at a point of its capsule that is not in the disc about the segment's
//                start (capsules are convex), or in the disc where the tool is switched on. So visits are counted
//                by area: over the whole plane width * length + discs, less what lies outside the target.
//                Tool-on legs that follow each other are one stretch.
#pragma once

#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct Interval {
  double lower = 0, upper = 0;
  double middle() const { return (lower + upper) / 2; }
};

struct SweptArea {
  Interval coverage;      // share of the target, certified
  double covered_m2 = 0;  // certified lower bound of covered target
  double seen_m2 = 0;     // best estimate of covered target
  double union_m2 = 0;    // area of the union of all tool-on swaths (target or not)
  double legs_m2 = 0;     // sum of each leg's own swept area
  double visits_m2 = 0;   // integral over the target of the number of separate visits
};

/// `target` errs inside by at most `target_excess` m^2. `width` is the tool's. The coverage interval is at most
/// `certainty` wide (chords are refined until it is), unless `target_excess` alone is more. Throws
/// std::invalid_argument if width is not above 0, the target is empty, or the path is not finite.
SweptArea swept_area(const Region& target, double target_excess, double width, const Path& path, double certainty = 0.001);

}  // namespace oxturn
