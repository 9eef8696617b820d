#include "algorithms/drawing/last_detours.hpp"

#include <algorithm>

#include "algorithms/smoothing/car_space.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/paths/shortest_path.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 2e-3;                  // tool widths: error of the obstacles' arcs, outside
constexpr std::size_t kMostPoses = 100'000;      // of a search, from each end
constexpr std::size_t kAllPoses = 800'000;       // of all searches: some ten seconds
constexpr std::size_t kAllVertices = 4'000'000;  // of the regions of all searches

}  // namespace

std::string trace_of_crossing(LastDetour::End why) {
  static constexpr const char* kWhy[] = {"found", "enclosed", "no curve", "effort spent", "by hand"};
  return std::string("over finished work: ") + kWhy[static_cast<std::size_t>(why)];
}

LastDetours::LastDetours(const Problem& problem, const FinishedWork& work, double radius)
    : problem_(problem),
      work_(work),
      radius_(radius),
      chord_(kChord * problem.robot().tool_width),
      free_(problem.configuration_space()),
      taken_(work.pieces().size(), false) {}

void LastDetours::take_out_finished() {
  std::vector<Region> swept;
  for (std::size_t k = 0; k < taken_.size(); ++k) {
    if (taken_[k] || !work_.finished(k)) continue;
    taken_[k] = true;
    const DrawnPiece& piece = work_.pieces()[k];
    swept.push_back(swath({piece.points}, piece.half_width, chord_, Bound::outside));
  }
  if (!swept.empty()) free_ = subtract(free_, swept);
}

Region LastDetours::around(const Point& from, const Point& to) const {
  std::vector<Region> parts{free_};
  for (const Point& end : {from, to})
    parts.push_back(intersect(problem_.configuration_space(), swath({{end}}, work_.exempt(), chord_, Bound::inside)));
  return unite(parts);
}

LastDetour LastDetours::curve(const Region& free, const Pose& from, const Pose& to, const Context& context) {
  const EdgeIndex walls(free);
  const CarSpace space(problem_, walls, bounding_box(free), radius_);
  const std::size_t most = std::min(kMostPoses, (kAllPoses - std::min(poses_, kAllPoses)) / 2);
  if (most == 0) return {};
  const ThoroughDetour detour = thorough_search(space, from, to, most, context);
  poses_ += detour.poses;
  if (!detour.curve) return {detour.nothing_left ? LastDetour::End::no_curve : LastDetour::End::effort_spent, {}};
  Polyline path{from.at};
  for (const Leg& leg : sampled(*detour.curve, space.chord_error(), false))
    path.insert(path.end(), leg.points.begin() + 1, leg.points.end());
  path.back() = to.at;
  if (work_.crossing_m(path) > 0) return {};
  return {LastDetour::End::found, std::move(path)};
}

LastDetour LastDetours::find(const Pose& from, const Pose& to, const Context& context) {
  if (vertices_ >= kAllVertices) return {};
  take_out_finished();
  const Region free = around(from.at, to.at);
  vertices_ += vertex_count(free);
  auto path = ShortestPaths(free, problem_.tolerance()).path(from.at, to.at);
  if (!path) return {LastDetour::End::enclosed, {}};
  if (radius_ > 0) return curve(free, from, to, context);
  if (work_.crossing_m(*path) > 0) return {};
  return {LastDetour::End::found, std::move(*path)};
}

}  // namespace oxturn
