// The part of free space that one scan makes certain, as a star-shaped polygon about the lidar.
//
// Between two neighbouring rays nothing is measured. What is believed there rests on one assumption: no wall (island,
// tooth, slot) is narrower than the rays are apart where it stands. So every such wedge has a depth:
// - Three hits in a line lie on one straight wall, which goes on to the next ray. Where the walls of both sides meet
//   before the chord of the two hits, that is a corner that pokes into the wedge between the rays: it is kept out,
//   exactly. Where they meet behind it, the chord is the end.
// - Where hits do not say what wall they lie on (short edges, curves), the wedge ends at the nearer hit less `caution`
//   times the distance of the rays there.
// - A wedge is cut off where the rays are farther apart than `apart`.
// Rounding of the hits is forgiven up to `tolerance`; the caller keeps more distance than that.
// Complexity  O(rays)
#pragma once

#include "algorithms/online/lidar.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct StarRules {
  double apart = 0;      // metres: largest distance of neighbouring rays that is trusted
  double caution = 2;    // see above
  double tolerance = 0;  // metres: hits so near to a line lie on it
};

/// Counter-clockwise, relative to the eye; empty with fewer than 5 rays (wedges of more than a right angle say nothing).
/// `corners`: gets the corners that poke into a wedge, not farther than 2 * apart from the hits at both sides.
Ring star(const Scan& scan, const std::vector<Point>& directions, const StarRules& rules,
          std::vector<Point>* corners = nullptr);

/// For a scan with noise: each reading counts as the least of itself and its two neighbours, less `margin` and
/// `caution` times the rays' distance. One or two readings that are too long do no harm.
Ring noisy_star(const Scan& scan, const std::vector<Point>& directions, const StarRules& rules, double margin);

}  // namespace oxturn
