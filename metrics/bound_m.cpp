// The best lower bound of the length of a path that covers as much (length_bound.hpp), metres.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kBoundM;

const Metric kBoundM{
    "bound_m", "m", Better::neither,
    "no path that covers as much is shorter; empty: no more than one tool disc covered, or legs do not join",
    [](const Scored& s) -> std::optional<double> {
      if (!s.bound) return std::nullopt;
      return s.bound->metres;
    }};

}  // namespace oxturn
