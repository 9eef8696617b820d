// Path length over the shortest length that could cover as much:
//   path_m / ((covered - pi w^2 / 4) / w),   w = tool width, covered = certified lower bound of the covered area
// A curve of length L sweeps at most L w + pi w^2 / 4, so the ratio is never below 1 for a path whose legs join. Empty
// if at most one tool disc is covered, and if legs do not join: no bound is valid then.
#include "metrics/legs_join.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kLengthRatio;

namespace {

constexpr double kRounding = 1e-9;  // tool widths squared

}  // namespace

const Metric kLengthRatio{
    "length_ratio", "1", Better::lower,
    "path length over the shortest that could cover as much; empty: no more than one tool disc covered, or legs do "
    "not join",
    [](const Scored& s) -> std::optional<double> {
      if (!legs_join(s.path, s.tolerance)) return std::nullopt;
      const double w = s.problem.robot().tool_width;
      const double swept = s.swept.covered_m2 - kPi * w * w / 4;
      if (swept <= kRounding * w * w) return std::nullopt;
      return s.path.length() * w / swept;
    }};

}  // namespace oxturn
