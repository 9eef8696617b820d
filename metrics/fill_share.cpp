// Share of a drawing's filled areas that the path covers, certified lower bound; and the same of the part that the
// tool's disc reaches without leaving them. Where the areas are all that the problem's target is, their share is the
// target's.
#include <cmath>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "maps/drawing.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kFillShare, kFillShareReachable;

namespace {

constexpr double kChordError = 1e-3;  // of the tool's width

/// Areas that are to be filled.
Region areas_of(const Scored& s) {
  Region areas;
  if (s.problem.map().drawing)
    for (const FilledArea& area : s.problem.map().drawing->areas)
      if (area.choice.fill != "none") areas.polygons.push_back(area.area);
  return areas;
}

/// Square metres by which a boolean may move an area: it snaps to 2^-30 of the extent.
double rounding_of(const Region& areas) {
  return perimeter(areas) * bounding_box(areas).size().maxCoeff() * std::ldexp(1.0, -28);
}

std::optional<double> covered_share(const Scored& s, const Region& areas) {
  if (!(area(areas) > 0)) return std::nullopt;
  const Region& target = s.problem.target();
  const double rounding = rounding_of(areas), lower = s.swept.coverage.lower - rounding / area(areas);
  if (area(subtract(areas, target)) <= rounding && area(subtract(target, areas)) <= rounding) return lower;
  return coverage_of(areas, 0, s.problem.robot().tool_width, s.path).lower;
}

/// Morphological opening by the tool's disc.
Region opened(const Region& areas, double width) {
  const Region core = erode(areas, width / 2, kChordError * width, Bound::inside);
  return core.empty() ? core : dilate(core, width / 2, kChordError * width, Bound::inside);
}

}  // namespace

const Metric kFillShare{"fill_share", "1", Better::higher,
                        "covered share of a drawing's filled areas, certified; empty: nothing to fill",
                        [](const Scored& s) { return covered_share(s, areas_of(s)); }};

const Metric kFillShareReachable{
    "fill_share_reachable", "1", Better::higher,
    "the same of the part that the tool covers without leaving the areas; empty: nothing to fill, or too narrow",
    [](const Scored& s) { return covered_share(s, opened(areas_of(s), s.problem.robot().tool_width)); }};

}  // namespace oxturn
