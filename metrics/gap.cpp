// Path length over the best lower bound, less 1 (length_bound.hpp). The optimum is at most so much shorter.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kGap;

const Metric kGap{"gap", "1", Better::lower,
                  "path length over bound_m, less 1: how much shorter a path could be at most",
                  [](const Scored& s) -> std::optional<double> {
                    if (!s.bound) return std::nullopt;
                    return s.path.length() / s.bound->metres - 1;
                  }};

}  // namespace oxturn
