/// The part of free space that one scan makes certain, as a star-shaped polygon around the lidar.
///
///   const Ring ring = star(scan, ray_directions(rays), {.apart = radius / 2, .tolerance = 1e-9});
///
/// Between two neighbouring rays nothing is measured. What is believed there rests on one assumption: no wall (island,
/// tooth, slot) is narrower than the distance between the rays where it stands. So every wedge between two rays has an
/// end:
/// - Three hits in a line lie on one straight wall, which continues to the next ray. Where the walls of both sides meet
///   before the chord of the two hits, their corner protrudes into the wedge between the rays and is kept out, exactly.
///   Where they meet behind the chord, the chord is the end.
/// - Where hits do not show what wall they lie on (short edges, curves), the wedge ends at the nearer hit less
///   `caution` times the distance of the rays there.
/// - A wedge is cut off where the rays are farther apart than `apart`.
/// Rounding of hits up to `tolerance` is accepted; the caller keeps more distance than that.
/// O(rays).
#pragma once

#include "algorithms/online/lidar.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct StarRules {
  double apart = 0;      // metres: largest distance of neighbouring rays that is trusted
  double caution = 2;    // see above
  double tolerance = 0;  // metres: hits that near to a line lie on it
};

/// Counter-clockwise, relative to the eye; empty with fewer than 5 rays (wedges of more than a right angle mean
/// nothing). `corners` gets the corners that protrude into a wedge, at most 2 * apart from the hits on both sides.
Ring star(const Scan& scan, const std::vector<Point>& directions, const StarRules& rules,
          std::vector<Point>* corners = nullptr);

/// For a scan with noise: each reading counts as the least of itself and its two neighbours, less `margin` and
/// `caution` times the distance of the rays. One or two readings that are too long do no harm.
Ring noisy_star(const Scan& scan, const std::vector<Point>& directions, const StarRules& rules, double margin);

}  // namespace oxturn
