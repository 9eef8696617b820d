#include "metrics/unfilled_areas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "maps/drawing.hpp"
#include "metrics/swept_area.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostFine = 10;           // areas whose share is measured finely only to be said
constexpr double kRough = 0.01, kFine = 0.001;  // certainty of a share: the first is enough for most areas

}  // namespace

std::vector<UnfilledArea> unfilled_areas(const Problem& problem, const Path& path, double least) {
  std::vector<UnfilledArea> found;
  const Drawing* drawing = problem.map().drawing.get();
  if (drawing == nullptr) return found;
  const double width = problem.robot().tool_width;
  std::vector<std::pair<Box, const Leg*>> work;
  for (const Leg& leg : path.legs)
    if (leg.tool) work.push_back({bounding_box(leg.points), &leg});
  for (std::size_t k = 0; k < drawing->areas.size(); ++k) {
    const FilledArea& filled = drawing->areas[k];
    if (filled.choice.fill == "none") continue;
    Box box = bounding_box(filled.area.outer);
    box.grow(width);
    Path near;
    for (const auto& [leg_box, leg] : work)
      if (leg_box.overlaps(box)) near.legs.push_back(*leg);
    const auto share_within = [&](double certainty) { return coverage_of({{filled.area}}, 0, width, near, certainty); };
    Interval share;
    if (!near.legs.empty()) share = share_within(kRough);
    if (share.lower >= least) continue;
    // The fine one where the rough one does not decide, and where the share is said.
    if (share.upper >= least || (share.upper > 0 && found.size() < kMostFine)) share = share_within(kFine);
    if (share.lower < least) found.push_back({filled.element, k, share.lower});
  }
  return found;
}

std::vector<std::string> remarks_on(const std::vector<UnfilledArea>& areas) {
  std::vector<std::string> sentences;
  sentences.reserve(areas.size());
  for (const UnfilledArea& area : areas)
    sentences.push_back(
        area.share > 0
            ? fmt::format("area '{}' is filled to {:.1f} %: the rest is too narrow for the tool, or for its bends",
                          area.element, std::floor(1000 * area.share) / 10)
            : fmt::format("area '{}' is not filled: it is too narrow for the tool", area.element));
  return sentences;
}

}  // namespace oxturn
