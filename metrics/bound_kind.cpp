// Which bound `bound_m` is: 0 area, 1 spill, 2 arms, 3 tour (length_bound.hpp).
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kBoundKind;

const Metric kBoundKind{"bound_kind", "1", Better::neither,
                        "which bound is the best: 0 area, 1 area and what is spilled at corners and in narrow "
                        "parts, 2 how often narrow parts must be driven along, and area, 3 distances of points",
                        [](const Scored& s) -> std::optional<double> {
                          if (!s.bound) return std::nullopt;
                          return static_cast<double>(s.bound->kind);
                        }};

}  // namespace oxturn
