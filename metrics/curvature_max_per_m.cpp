// Greatest curvature of the path, 1/m; see geometry/bends.hpp. Its inverse is the least turning radius.
#include <algorithm>

#include "geometry/bends.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCurvatureMaxPerM;

const Metric kCurvatureMaxPerM{"curvature_max_per_m", "1/m", Better::lower,
                               "greatest curvature; a corner counts as a sampled curve",
                               [](const Scored& s) -> std::optional<double> {
                                 double most = 0;
                                 for_each_bend(s.path, s.tolerance, s.problem.robot().tool_width,
                                               [&](const Bend& bend) { most = std::max(most, bend.curvature); });
                                 return most;
                               }};

}  // namespace oxturn
