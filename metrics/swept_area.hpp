/// The area that the tool sweeps, with certified bounds.
///
///   const SweptArea s = swept_area(problem.target(), problem.target_excess(), tool_width, path);
///   s.coverage.lower;                                            // coverage is certainly not below this
///
/// Method      The plane is divided into square tiles of half a tool width. The tool's swath along a segment is a
///             capsule (capsules.hpp). In each tile the convex polygons inscribed in the capsules (lower bound) or
///             circumscribed about them (upper bound) are subtracted from the tile one after the other. What remains is
///             not covered, and target_rows.hpp measures the target in it. Subtracting convex polygons from convex
///             polygons needs only half-plane clips, so it is robust and fast. Polygons are shrunk or grown by 1e-9 of
///             a tile, far more than rounding, so the bounds are true; only the sums of areas are rounded (1e-12 of the
///             target).
/// Complexity  O(n + tiles touched + capsules per tile + target edges per row); near-linear for real paths
/// Decisions   1. Only the path within 1.5 tool widths of the target's bounding box counts: no valid path leaves that,
///                and one that goes astray costs no more than the map.
///             2. Areas without a certificate (union, estimates) are 1/3 inscribed + 2/3 circumscribed, which
///                cancels the leading errors of both (Huygens).
///             3. Curves are simplified: short segments that stay within a small distance of one long segment are
///                replaced by it, and the tool's radius is reduced (lower bound) or increased (upper bound) by that
///                distance. Segments that are driven again count once for areas.
///             4. During a segment a visit begins at the points of its capsule outside of the disc about the segment's
///                first point (capsules are convex), and where the tool is switched on, at the points of the disc
///                there. So visits are counted by areas: width * length + discs over the whole plane, less what lies
///                outside the target. Between legs that join the tool stays on.
#pragma once

#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct Interval {
  double lower = 0, upper = 0;
  double middle() const { return (lower + upper) / 2; }
};

/// How much of the target had been covered when `path_m` metres were driven.
struct CoveragePoint {
  double path_m, coverage;  // coverage: share of the target
};

/// A connected piece of the target that was certainly not covered.
struct MissedPiece {
  double area_m2 = 0;
  Point at{0, 0};             // inside
  std::vector<Ring> outline;  // convex parts of the piece, disjoint, counter-clockwise; empty if left out
};
/// They take most of the memory of a path that misses much, and only pictures show them.
enum class MissedOutlines { kept, left_out };

/// Where a path sweeps. `in_target`: nowhere outside the true target, such as a valid path of a tool no wider than the
/// robot. Then the slivers that `target` lacks of the true target count as target in the estimates, and tiles without
/// target are left out, which saves a quarter of the time.
enum class Swath { anywhere, in_target };

struct SweptArea {
  Interval coverage;                 // share of the target, certified
  double covered_m2 = 0;             // covered part of the target, certified lower bound
  double covered_estimate_m2 = 0;    // covered part of the target, best estimate
  double union_m2 = 0;               // area swept with the tool on, inside the target or not
  double work_m2 = 0;                // length driven with the tool on, times the width
  double visits_m2 = 0;              // integral over the target of the number of separate visits
  std::vector<CoveragePoint> curve;  // estimate; from (0, 0) to the path's end and coverage.middle()
  std::vector<MissedPiece> missed;   // largest first; pieces above a hundredth of the tool's disc
};

/// `target` may be smaller than the true target by at most `target_excess` m^2. `width`: the tool's, metres. The
/// coverage interval is at most `certainty` wide (chords are refined until it is), unless `target_excess` alone makes
/// it wider. Throws std::invalid_argument if the width is not above 0, the target is empty, the path is not finite, or
/// there is too much to scan: a target more than 2 * 10^7 tiles high, or more than 10^9 tile sides of work.
SweptArea swept_area(const Region& target, double target_excess, double width, const Path& path,
                     double certainty = 0.001, MissedOutlines outlines = MissedOutlines::kept,
                     Swath swath = Swath::anywhere);

/// Its `coverage` alone: half of the time, and no memory for what is missed.
Interval coverage_of(const Region& target, double target_excess, double width, const Path& path,
                     double certainty = 0.001);

}  // namespace oxturn
