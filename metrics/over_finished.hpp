/// Transits that drive over finished work, as where a robot has no other path.
///
///   const auto sentences = remarks_on(transits_over_finished(problem, path), why);
///
/// What counts is that of the metric over_finished_m. Complexity: the work near each transit.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct TransitOver {
  std::size_t leg = 0;  // of the path
  Point from{0, 0}, to{0, 0};
  double over_m = 0;
};

/// Those of `least` metres over finished work at least, longest first. None on a map without a drawing.
std::vector<TransitOver> transits_over_finished(const Problem& problem, const Path& path, double least = 0.01);

/// A sentence for each, with the reason at its end.
std::vector<std::string> remarks_on(const std::vector<TransitOver>& transits,
                                    const std::function<std::string(const TransitOver&)>& reason);

}  // namespace oxturn
