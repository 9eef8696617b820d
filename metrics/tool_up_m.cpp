// Length that a drawing robot drives with the tool up, without the strokes that the drawing wants driven so, metres.
#include <algorithm>

#include "maps/drawing.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kToolUpM;

const Metric kToolUpM{"tool_up_m", "m", Better::lower,
                      "length driven with the tool up, less a drawing's strokes of that kind; empty: no drawing",
                      [](const Scored& s) -> std::optional<double> {
                        if (!s.problem.map().drawing) return std::nullopt;
                        double wanted = 0;
                        for (const DrawnStroke& stroke : s.problem.map().drawing->strokes)
                          if (!stroke.tool) wanted += length(stroke.points);
                        return std::max(0.0, s.path.length(false) - wanted);
                      }};

}  // namespace oxturn
