/// A region divided by another one.
///
///   const auto [outside, inside] = divided(whole, strip);       // subtract(whole, strip), intersect(whole, strip)
///
/// In one overlay, with the properties of both (boolean.hpp).
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

struct DividedRegion {
  Region outside, inside;
};

DividedRegion divided(const Region& region, const Region& by);

}  // namespace oxturn
