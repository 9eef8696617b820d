/// Whether each leg of a path begins where the one before it ends.
///
///   if (!legs_join(path, tolerance)) return std::nullopt;
///
/// Lower bounds of length hold for such paths only.
#pragma once

#include "geometry/path.hpp"

namespace oxturn {

/// `tolerance` in metres.
inline bool legs_join(const Path& path, double tolerance) {
  const Point* last = nullptr;
  for (const Leg& leg : path.legs) {
    if (leg.points.empty()) continue;
    if (last != nullptr && distance(*last, leg.points.front()) > tolerance) return false;
    last = &leg.points.back();
  }
  return true;
}

}  // namespace oxturn
