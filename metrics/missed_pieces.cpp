// Number of connected pieces of the target that are certainly not covered, above a hundredth of the tool's disc
// (pi w^2 / 400, w = tool width). Smaller ones are ignored.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kMissedPieces;

const Metric kMissedPieces{
    "missed_pieces", "count", Better::lower, "uncovered pieces of the target above a hundredth of the tool's disc",
    [](const Scored& s) -> std::optional<double> { return static_cast<double>(s.swept.missed.size()); }};

}  // namespace oxturn
