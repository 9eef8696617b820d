/// What a planner is, as data: name, source, capabilities, guarantee and parameters, and how to make one.
///
///   PlannerInfo wavefront() {
///     return describe<Wavefront, Params>({.name = "wavefront", .family = "grid", ...});
///   }
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/named_list.hpp"
#include "base/parameters.hpp"
#include "maps/problem.hpp"
#include "maps/promise.hpp"

namespace oxturn {

class CoveragePlanner;
struct PlannerInfo;
using Planners = NamedList<PlannerInfo>;

/// What a problem may require and not every planner can do.
enum class Capability { tether, online, holes, curvature, footprint };
std::string to_text(Capability capability);

/// Changes of a problem that leave the path as it is, but for the same change: its length stays, or doubles with the
/// map and the robot. Declared by planners whose choices depend on nothing else; `oxturn check` holds them to it.
enum class Symmetry { shift, quarter_turn, mirror, scale };
std::string to_text(Symmetry symmetry);

struct PlannerInfo {
  std::string name, family, title, citation;
  std::vector<Capability> capabilities;
  std::string guarantee;
  Promise promise = Promise::nothing;  // to cover, with the default settings
  std::vector<ParameterInfo> parameters;
  /// Settings with which the planner does exactly what its source says: the meaning of `variant = published`. Empty:
  /// the planner has no such parameter.
  Settings published;
  /// Throws std::invalid_argument for wrong settings. `planners`: from which a planner that runs another one takes it.
  std::function<std::unique_ptr<CoveragePlanner>(const Settings&, const Planners& planners)> make;
  /// For a planner that runs another one, named in the settings: the parameters of that one.
  std::function<std::vector<ParameterInfo>(const Settings&, const Planners& planners)> more_parameters = {};
  /// Whether `promise` holds with these settings; empty: with all.
  std::function<bool(const Settings&)> promises_with = {};
  /// Of a planner from outside: where it comes from ("python3 lanes.py"), and a hash of everything that determines
  /// what it does. Empty: it is part of oxturn.
  std::string origin = {}, identity = {};
  bool is_program = false;                // an external planner: each plan is a program of its own
  std::vector<Symmetry> symmetries = {};  // with the default settings
  bool covers_target_areas = false;       // by itself: target_area_planner() leaves it as it is

  /// What it promises to cover with these settings. Nothing if the robot has a least turning radius: corners stay
  /// uncovered. Throws as `make` does.
  Promise promised(const Settings& settings, const Robot& robot = {}) const;
  bool has(Capability capability) const;
};

/// The parameters of the planner, and of the one that it runs with these settings. Throws as `make` does if they name a
/// planner that does not exist.
std::vector<ParameterInfo> parameters_of(const PlannerInfo& planner, const Settings& settings,
                                         const Planners& planners);

/// `settings`, completed by the published ones if they contain `variant = published`; given ones take precedence.
Settings with_variant(const PlannerInfo& planner, Settings settings);

/// Why this planner cannot take this problem at all ("planner 'stc' has no capability 'tether', ..."), or "".
std::string missing_capability(const PlannerInfo& planner, const Problem& problem);

/// The planners that come with oxturn, listed in algorithms/zoo.cpp.
Planners built_in_planners();

/// The description of a planner with its parameters P, as one literal.
template <class P>
struct Description {
  std::string name, family, title, citation;
  std::vector<Capability> capabilities;
  std::string guarantee;
  Promise promise = Promise::nothing;
  std::vector<Symmetry> symmetries = {};  // with the default settings
  std::vector<Parameter<P>> parameters;
  Settings published = {};
  bool (*promises_with)(const P&) = nullptr;  // whether `promise` holds with these parameters; nullptr: with all
};

/// The parameter `variant`, which describe() adds to planners with a published form.
ParameterInfo variant_parameter(const Settings& published);

template <class Planner, class P>
PlannerInfo describe(Description<P> d) {
  PlannerInfo info{d.name,         d.family,    d.title,   d.citation,
                   d.capabilities, d.guarantee, d.promise, infos_of(d.parameters),
                   d.published,    {},          {}};
  info.symmetries = d.symmetries;
  if (!d.published.empty()) info.parameters.push_back(variant_parameter(d.published));
  const auto params = [self = info, lines = std::move(d.parameters)](const Settings& settings) {
    const std::string owner = "planner '" + self.name + "'";
    Settings all = with_variant(self, checked(owner, self.parameters, settings));
    all.erase("variant");
    return with_settings<P>(owner, lines, all);
  };
  info.make = [params](const Settings& settings, const Planners&) {
    return std::make_unique<Planner>(params(settings));
  };
  if (d.promises_with)
    info.promises_with = [params, holds = d.promises_with](const Settings& settings) {
      return holds(params(settings));
    };
  return info;
}

}  // namespace oxturn
