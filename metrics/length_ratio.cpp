// Path length over the shortest length that could cover as much:
//   length / ((covered - pi w^2 / 4) / w),   w = tool width
// Uses the certified lower area, so it is never below 1 for a path that does not jump (what a curve of length L
// sweeps is at most L w + pi w^2 / 4). Empty when no more than one tool disc is covered, and for a path whose legs
// do not join: it teleports, and no bound holds.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kLengthRatio;

const Metric kLengthRatio{
    "length_ratio", "1", Better::lower,
    "path length over the shortest that could cover as much; empty: no more than one tool disc covered, or legs do "
    "not join",
    [](const Scored& s) -> std::optional<double> {
      const Point* last = nullptr;
      for (const Leg& leg : s.path.legs) {
        if (leg.points.empty()) continue;
        if (last != nullptr && distance(*last, leg.points.front()) > s.problem.tolerance()) return std::nullopt;
        last = &leg.points.back();
      }
      const double w = s.problem.robot().tool_width;
      const double swept = s.swept.covered_m2 - kPi * w * w / 4;
      if (swept <= 1e-9 * w * w) return std::nullopt;  // a single disc, but for rounding
      return s.path.length() * w / swept;
    }};

}  // namespace oxturn
