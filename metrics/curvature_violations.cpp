// Number of maximal runs of consecutive bends that are sharper than 1 / min_turn_radius by more than 1 %; see
// geometry/bends.hpp. Empty for a robot that turns on the spot.
#include "geometry/bends.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCurvatureViolations;

const Metric kCurvatureViolations{"curvature_violations", "count", Better::lower,
                                  "bends sharper than the robot can drive; empty: it turns on the spot",
                                  [](const Scored& s) -> std::optional<double> {
                                    const Robot& robot = s.problem.robot();
                                    if (!(robot.min_turn_radius > 0)) return std::nullopt;
                                    double count = 0;
                                    bool inside = false;
                                    for_each_bend(s.path, s.tolerance, robot.tool_width, [&](const Bend& bend) {
                                      const bool sharp = too_sharp(bend, robot.min_turn_radius);
                                      count += sharp && !inside;
                                      inside = sharp;
                                    });
                                    return count;
                                  }};

}  // namespace oxturn
