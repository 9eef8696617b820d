// Number of changes of gear between forward and reverse.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCusps;

const Metric kCusps{"cusps", "count", Better::lower, "changes of gear between forward and reverse",
                    [](const Scored& s) -> std::optional<double> {
                      double count = 0;
                      for (std::size_t l = 1; l < s.path.legs.size(); ++l)
                        count += s.path.legs[l].gear != s.path.legs[l - 1].gear;
                      return count;
                    }};

}  // namespace oxturn
