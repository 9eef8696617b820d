// Share covered of what the planner's description promises to cover, 0 to 1, certified lower bound (swept_area.hpp):
// all of the target, or the cells that the planner hands out. A planner that keeps its promise is told apart from one
// that falls short of it.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kPromiseCoverage;

const Metric kPromiseCoverage{
    "promise_coverage", "1", Better::higher,
    "covered share of what the planner promises, certified lower bound; empty: it promises nothing",
    [](const Scored& s) -> std::optional<double> { return s.kept_promise; }};

}  // namespace oxturn
