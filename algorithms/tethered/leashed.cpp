// Makes any planner safe for a tethered robot: it covers the space cut open, where its position determines its tether.
//
// Source      ours; for the cut see tether_space.hpp and bridge_cut.hpp
// Model       that of the planner, offline, disc footprint
// Guarantee   the tether is within its length limit and never driven over; covers what the planner covers of each
//             component of the cut space. With cut = geodesic, the tether equals the geodesic to the robot's position,
//             except on paths between components
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
//             5. cut = least, the default: bridges between neighbouring obstacles, where the tether is long enough for
//                them and they are shorter than the cut locus. Planners drive along both sides of the cut and divide
//                their lanes there, so paths are 1 to 39 % shorter among obstacles (tether of 1.1 or 1.2 times
//                what the farthest point needs).
//             6. The robot keeps off obstacles by up to a hundredth of its radius more round their corners
//                (coarser_space), as most planners do by themselves.
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
  Leashed(Wrapped inner, bool return_home, TetherCut cut)
      : inner_(std::move(inner)), return_home_(return_home), cut_(cut) {}

  Path plan(const Problem& whole, Context& context) const override {
    const Problem problem = with_coarser_space(whole);
    const TetherSpace space(problem, "leashed", cut_);
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
  TetherCut cut_;
};

}  // namespace

PlannerInfo leashed() {
  PlannerInfo info;
  info.name = "leashed";
  info.family = "tethered";
  info.title = "any planner, made safe for a tether by cutting space open";
  info.citation = "oxturn";
  info.capabilities = {Capability::tether, Capability::holes};
  info.symmetries = {Symmetry::shift, Symmetry::scale};
  info.guarantee =
      "within the tether length limit, never over its own tether; covers what `planner` covers of the cut space";
  info.parameters = {
      {"return_home", true, {}, {}, "drive back to the start at the end"},
      {"cut",
       std::string("least"),
       {},
       Choices{"geodesic", "least"},
       "geodesic: along the anchor's cut locus, the tether as short as can be; least: along bridges between obstacles "
       "where these are shorter and the tether is long enough"}};
  return wrapper(std::move(info), "boustrophedon",
                 [](Wrapped inner, const Settings& own) -> std::unique_ptr<CoveragePlanner> {
                   const bool least = std::get<std::string>(own.at("cut")) == "least";
                   return std::make_unique<Leashed>(std::move(inner), std::get<bool>(own.at("return_home")),
                                                    least ? TetherCut::least : TetherCut::geodesic);
                 });
}

}  // namespace oxturn
