// Makes any planner safe for a tethered robot: it covers the space cut open along the anchor's cut locus.
//
// Source      ours; for the cut locus see tether_space.hpp
// Model       that of the planner, offline, disc footprint
// Guarantee   the tether equals the geodesic to the robot's position, except on paths between components that the cut
//             isolates: within the tether length limit, never wound, never driven over; covers what the planner covers
//             of each component
// Complexity  that of the planner, plus O((n + k) log n) for the cut
// Decisions   1. The planner gets the cut space by Problem::restricted. The cut is a wall to it: if it drives along
//                walls, it drives along both sides of the cut.
//             2. The planner is a built-in one; its parameters are given beside `planner`, under their own names.
//             3. Components that the cut isolates (tether_space.hpp) are covered one after the other, each by a call of
//                the planner.
//             4. The cut is thin, and its pieces short: vertices that this leaves on the path nearer to each other than
//                a hundredth of the robot's radius are dropped, where the straight segment stays in the cut space.
#include <fmt/format.h>

#include "algorithms/transit/short_segments.hpp"
#include "algorithms/transit/tether_space.hpp"

namespace oxturn {
namespace {

constexpr const char* kOwner = "planner 'leashed'";

class Leashed final : public CoveragePlanner {
 public:
  Leashed(std::unique_ptr<CoveragePlanner> inner, bool return_home)
      : inner_(std::move(inner)), return_home_(return_home) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace space(problem, "leashed");
    if (context.wants_traces()) context.trace("cut", space.cut());
    return cover_components(
        space,
        [&](const TetherSpace::Component& component, Context& inner) {
          return without_short_segments(inner_->plan(component.problem, inner), component.problem);
        },
        return_home_, context);
  }

 private:
  std::unique_ptr<CoveragePlanner> inner_;
  bool return_home_;
};

const PlannerInfo& inner_of(const Settings& settings, const Planners& planners) {
  const auto given = settings.find("planner");
  const std::string* name = given == settings.end() ? nullptr : std::get_if<std::string>(&given->second);
  const PlannerInfo& inner = planners.find(name != nullptr ? *name : "boustrophedon");
  if (inner.has(Capability::tether))
    throw std::invalid_argument(
        fmt::format("{}: planner '{}' handles the tether itself; expected one that does not", kOwner, inner.name));
  return inner;
}

}  // namespace

PlannerInfo leashed() {
  PlannerInfo info;
  info.name = "leashed";
  info.family = "tethered";
  info.title = "any planner, made safe for a tether by the cut locus of the anchor";
  info.citation = "oxturn";
  info.capabilities = {Capability::tether, Capability::holes};
  info.guarantee =
      "within the tether length limit, never over its own tether; covers what `planner` covers of the cut space";
  info.parameters = {
      {"planner", std::string("boustrophedon"), {}, {}, "name of the planner; its own parameters go beside it"},
      {"return_home", true, {}, {}, "drive back to the start at the end"}};
  info.more_parameters = [](const Settings& settings, const Planners& planners) {
    return inner_of(settings, planners).parameters;
  };
  info.make = [](const Settings& settings, const Planners& planners) -> std::unique_ptr<CoveragePlanner> {
    const PlannerInfo& inner = inner_of(settings, planners);
    const std::vector<ParameterInfo> parameters = parameters_of(leashed(), settings, planners);
    Settings own, of_inner;
    for (const auto& [name, value] : settings) {
      const bool is_own = name == "planner" || name == "return_home";
      (is_own ? own : of_inner)[name] = checked(kOwner, find_parameter(kOwner, parameters, name), value);
    }
    const bool home = own.count("return_home") == 0 || std::get<bool>(own["return_home"]);
    return std::make_unique<Leashed>(inner.make(of_inner, planners), home);
  };
  return info;
}

}  // namespace oxturn
