// Metres driven: all, with the tool on, with the tool off.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kPathM, kWorkM, kTransitM;

const Metric kPathM{"path_m", "m", Better::lower, "length of the whole path",
                    [](const Scored& s) -> std::optional<double> { return s.path.length(); }};

const Metric kWorkM{"work_m", "m", Better::lower, "length driven with the tool on",
                    [](const Scored& s) -> std::optional<double> { return s.path.length(true); }};

const Metric kTransitM{"transit_m", "m", Better::lower, "length driven with the tool off",
                       [](const Scored& s) -> std::optional<double> { return s.path.length(false); }};

}  // namespace oxturn
