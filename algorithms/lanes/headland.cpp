#include "algorithms/lanes/headland.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "algorithms/lanes/laps.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/short_segments.hpp"

namespace oxturn {
namespace {

class HeadlandDrive {
 public:
  HeadlandDrive(const Problem& problem, const Connector& connector, PathBuilder& path)
      : width_(problem.robot().tool_width), connector_(connector), path_(path) {}

  /// All laps beside one part of the boundary, then those beside the part whose first lap is nearest.
  void drive(const Laps& laps, bool inside_out, const Context& context) {
    const std::vector<Group> groups = groups_of(laps, inside_out);
    Group first;
    for (const Group& group : groups) first.push_back(group.front());
    for (NearestRing left(first); !left.empty() && !context.cancelled();)
      for (const Ring* ring : groups[left.take(path_.at())]) drive(*ring);
  }

 private:
  using Group = std::vector<const Ring*>;  // in driving order

  /// A group for each outermost lap: itself and those inside it, level by level.
  static std::vector<Group> groups_of(const Laps& laps, bool inside_out) {
    std::vector<std::size_t> group(laps.all.size());
    for (std::size_t k = 0; k < laps.outermost; ++k) group[k] = k;
    std::vector<Group> groups(laps.outermost);
    for (std::size_t k = 0; k < laps.all.size(); ++k) {
      for (const std::size_t inner : laps.all[k].inner) group[inner] = group[k];
      groups[group[k]].push_back(&laps.all[k].ring);
    }
    if (inside_out)
      for (Group& rings : groups) std::ranges::reverse(rings);
    return groups;
  }

  void drive(const Ring& ring) {
    const std::size_t entry = nearest_vertex(ring, path_.at());
    const Polyline link = connector_.path(path_.at(), ring[entry]);
    path_.drive(link, begun_ && length(link) <= kLongestLinkOn * width_);
    path_.drive(lap_from(ring, entry), true);
    begun_ = true;
  }

  double width_;
  const Connector& connector_;
  PathBuilder& path_;
  bool begun_ = false;
};

}  // namespace

Path drive_with_headland(const Problem& problem, const Headland& headland,
                         const std::function<std::vector<Strip>(double depth)>& strips_deeper_than, StripOrder order,
                         Context& context) {
  Laps laps = laps_of(problem, problem.robot().tool_width, context, headland.headland);
  std::vector<Strip> strips = strips_deeper_than(laps.depth_m);
  for (Strip& strip : strips) strip.work_links = headland.headland_tool == HeadlandTool::on;
  if (strips.empty() && headland.headland_tool == HeadlandTool::off)
    throw Infeasible(fmt::format(
        "a headland of {} laps leaves no room for lanes; take fewer laps, or headland_tool=laps", headland.headland));
  const Connector connector(problem);
  PathBuilder path(problem.start());
  const auto drive_lanes = [&] {
    Path lanes = drive_strips(problem, path.at(), strips, order, connector, context);
    for (Leg& leg : lanes.legs) path.drive(std::move(leg.points), leg.tool);
  };
  if (headland.headland_tool == HeadlandTool::off) {
    drive_lanes();
    return without_short_segments(path.take(), problem);
  }
  const bool last = headland.headland_order == HeadlandOrder::last;
  if (last) drive_lanes();
  HeadlandDrive(problem, connector, path).drive(laps, last, context);
  if (!last && !context.cancelled()) drive_lanes();
  const Path whole = without_short_segments(path.take(), problem);
  context.publish(whole);
  return context.cancelled() ? whole : repaired(problem, whole, std::move(laps.between), connector, context);
}

}  // namespace oxturn
