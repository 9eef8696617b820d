// Makes any planner safe for a tethered robot: it covers the space cut open along the anchor's cut locus.
//
// Source      ours; for the cut locus see tether_space.hpp
// Model       that of the planner, offline, disc footprint
// Guarantee   the tether equals the geodesic to the robot's position, except on paths between components that the cut
//             isolates: within the tether length limit, never wound, never driven over; covers what the planner covers
//             of each component
// Complexity  that of the planner, plus O((n + k) log n) for the cut
// Decisions   1. The planner gets the cut space by Problem::restricted. The cut is a wall to it: if it drives along
//                walls, it drives along both sides of the cut. These two passes lie a tool width apart where they fit
//                (cut_passes.hpp), so nothing is covered twice. What that leaves uncovered where the cut branches is
//                added as detours. A planner that does not promise the whole target gets all of the cut space: those
//                on a grid would lose the cells beside the cut.
//             2. The planner is a built-in one; its parameters are given beside `planner`, under their own names.
//             3. Components that the cut isolates (tether_space.hpp) are covered one after the other, each by a call of
//                the planner.
//             4. The cut is thin, and its pieces short: vertices that this leaves on the path nearer to each other than
//                a hundredth of the robot's radius are dropped or joined where the segments stay in the cut
//                space.
#include <utility>

#include "algorithms/lanes/repair.hpp"
#include "algorithms/tethered/cut_passes.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "algorithms/transit/tether_space.hpp"
#include "algorithms/wrapper.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

class Leashed final : public CoveragePlanner {
 public:
  Leashed(Wrapped inner, bool return_home) : inner_(std::move(inner)), return_home_(return_home) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace space(problem, "leashed");
    if (context.wants_traces()) context.trace("cut", space.cut());
    const CutPasses cut(problem, space.cut());
    return cover_components(
        space,
        [&](const TetherSpace::Component& component, Context& inner) { return cover(cut, component.problem, inner); },
        return_home_, context);
  }

 private:
  Path cover(const CutPasses& cut, const Problem& component, Context& context) const {
    if (inner_.promise != Promise::target)
      return without_short_segments(inner_.planner->plan(component, context), component);
    PassSpace passes = cut.beside(component);
    if (component.map().target_area) passes.pockets = intersect(passes.pockets, component.target());
    const Path path = inner_.planner->plan(passes.problem, context);
    return repaired(component, without_short_segments(path, component), std::move(passes.pockets), Connector(component),
                    context);
  }

  Wrapped inner_;
  bool return_home_;
};

}  // namespace

PlannerInfo leashed() {
  PlannerInfo info;
  info.name = "leashed";
  info.family = "tethered";
  info.title = "any planner, made safe for a tether by the cut locus of the anchor";
  info.citation = "oxturn";
  info.capabilities = {Capability::tether, Capability::holes};
  info.symmetries = {Symmetry::shift, Symmetry::scale};
  info.guarantee =
      "within the tether length limit, never over its own tether; covers what `planner` covers of the cut space";
  info.parameters = {{"return_home", true, {}, {}, "drive back to the start at the end"}};
  return wrapper(std::move(info), "boustrophedon",
                 [](Wrapped inner, const Settings& own) -> std::unique_ptr<CoveragePlanner> {
                   return std::make_unique<Leashed>(std::move(inner), std::get<bool>(own.at("return_home")));
                 });
}

}  // namespace oxturn
