#include "metrics/length_bound.hpp"

#include <algorithm>

#include "metrics/arm_bound.hpp"
#include "metrics/spill.hpp"

namespace oxturn {
namespace {

constexpr double kRounding = 1e-9;    // tool widths squared
constexpr double kLeastShare = 1e-6;  // of the covered area: less spill is none

}  // namespace

std::optional<LengthBound> length_bound(const Problem& problem, const Path& path, const SweptArea& swept, bool valid) {
  const Robot& robot = problem.robot();
  const double w = robot.tool_width;
  const auto metres = [&](double area) -> double { return (area - kPi * w * w / 4) / w; };
  LengthBound best{LengthBound::Kind::area, metres(swept.covered_m2)};
  const double uncovered = std::max(0.0, area(problem.target()) - swept.covered_m2);
  const bool whole_tool = std::ranges::all_of(path.legs, [](const Leg& leg) { return leg.width == 0; });
  if (whole_tool && (problem.map().target_area || w / 2 > robot.radius)) {
    const double spill = least_spill(problem.target(), w, uncovered);
    if (spill > kLeastShare * swept.covered_m2) best = {LengthBound::Kind::spill, metres(swept.covered_m2 + spill)};
  }
  if (valid)
    if (const auto arms = arm_bound(problem, uncovered); arms && *arms > best.metres * (1 + kLeastShare))
      best = {LengthBound::Kind::arms, *arms};
  if (best.metres <= kRounding * w) return std::nullopt;
  return best;
}

}  // namespace oxturn
