// Number of turns, transit included: bends with a change of heading above 0.3 rad in total. A bend is a sequence of
// linked changes of the same sense (heading.hpp), whether a corner or a sampled curve; so the number does not depend on
// how finely a curve is sampled.
#include <cmath>

#include "metrics/heading.hpp"

namespace oxturn {

extern const Metric kTurns;

const Metric kTurns{"turns", "count", Better::lower,
                    "changes of direction by more than 0.3 rad, a smooth bend counts once",
                    [](const Scored& s) -> std::optional<double> {
                      double count = 0, bend = 0;
                      for (const Turn& turn : headings(s.problem, s.path).turns) {
                        if (!turn.linked) {
                          if (std::abs(bend) > kCorner) ++count;
                          bend = 0;
                        }
                        bend += turn.angle;
                      }
                      return std::abs(bend) > kCorner ? count + 1 : count;
                    }};

}  // namespace oxturn
