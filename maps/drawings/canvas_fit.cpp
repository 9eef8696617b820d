#include "maps/drawings/canvas_fit.hpp"

#include <algorithm>
#include <limits>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {

svg::Affine CanvasFit::placed(const Point& canvas, double margin) const {
  double scale = std::numeric_limits<double>::infinity();
  for (const auto& [reach, box] : boxes_)
    for (const auto& [other_reach, other] : boxes_)
      for (const Eigen::Index k : {0, 1}) {
        const double room = canvas[k] - 2 * margin - reach - other_reach, extent = box.high[k] - other.low[k];
        if (!(room > 0))
          throw_invalid("a canvas of {} x {} m with a margin of {} m has no room for a drawing with lines {} m wide",
                        to_decimal(canvas.x()), to_decimal(canvas.y()), to_decimal(margin), to_decimal(2 * reach));
        if (extent > 0) scale = std::min(scale, room / extent);
      }
  if (!std::isfinite(scale)) scale = 1;
  Box drawn;
  for (const auto& [reach, box] : boxes_) {
    Box metres{{scale * box.low.x(), -scale * box.high.y()}, {scale * box.high.x(), -scale * box.low.y()}};
    metres.grow(reach);
    drawn.add(metres);
  }
  const Point shift = canvas / 2 - drawn.centre();
  return {scale, 0, 0, -scale, shift.x(), shift.y()};
}

}  // namespace oxturn
