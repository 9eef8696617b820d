// Any planner on a leash: it sweeps the space cut open along the anchor's cut locus, then comes home.
//
// Source      ours; the cut locus: algorithms.md section 1
// Model       that of the planner, offline, disc footprint
// Guarantee   the string equals the geodesic of where the robot stands, except on the ways between parts that the cut
//             isolates (leash.hpp): within the leash, never wound, never driven over; covers what the planner covers of
//             each part
// Complexity  the planner's, plus O((n + k) log n) for the cut
// Decisions   1. The planner gets the cut space by Problem::restricted and is not told why: the cut is a wall to it. It
//                drives along both sides of it, if it drives along walls.
//             2. It is one of the zoo; its parameters are given beside `planner`, under their own names.
//             3. Parts that the cut isolates (leash.hpp) are swept one after the other, each by a call of the planner.
#include <fmt/format.h>

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {
namespace {

constexpr const char* kOwner = "planner 'leashed'";

class Leashed final : public CoveragePlanner {
 public:
  Leashed(std::unique_ptr<CoveragePlanner> inner, bool return_home)
      : inner_(std::move(inner)), return_home_(return_home) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace leash(problem, "leashed");
    if (context.wants_traces()) context.trace("cut", leash.cut());
    return cover_components(
        leash, [&](const TetherSpace::Component& part, Context& inner) { return inner_->plan(part.problem, inner); },
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
        fmt::format("{}: planner '{}' knows the tether by itself; expected one that does not", kOwner, inner.name));
  return inner;
}

}  // namespace

PlannerInfo leashed() {
  PlannerInfo info;
  info.name = "leashed";
  info.family = "tethered";
  info.title = "any planner, made tether-safe by the cut locus of the anchor";
  info.citation = "oxturn";
  info.capabilities = {Capability::tether, Capability::holes};
  info.guarantee = "within the leash, never over its own line; covers what `planner` covers of the cut space";
  info.parameters = {
      {"planner", std::string("boustrophedon"), {}, {}, "name of the planner; its own parameters go beside it"},
      {"return_home", true, {}, {}, "drive back to the start at the end"}};
  info.more_parameters = [](const Settings& settings, const Planners& planners) {
    return inner_of(settings, planners).parameters;
  };
  info.make = [](const Settings& settings, const Planners& planners) -> std::unique_ptr<CoveragePlanner> {
    const PlannerInfo& inner = inner_of(settings, planners);
    const std::vector<ParameterInfo> parameters = parameters_of(leashed(), settings, planners);
    Settings own, its;
    for (const auto& [name, value] : settings) {
      const bool mine = name == "planner" || name == "return_home";
      (mine ? own : its)[name] = checked(kOwner, find_parameter(kOwner, parameters, name), value);
    }
    const bool home = own.count("return_home") == 0 || std::get<bool>(own["return_home"]);
    return std::make_unique<Leashed>(inner.make(its, planners), home);
  };
  return info;
}

}  // namespace oxturn
