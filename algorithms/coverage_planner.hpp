// The one interface that every strategy implements, and the data that describes it.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "base/random.hpp"
#include "maps/formats.hpp"
#include "base/parameters.hpp"
#include "maps/problem.hpp"
#include "geometry/trace.hpp"

namespace oxturn {

/// The planner can prove, or is certain, that it cannot solve this problem. Outcome `infeasible`.
struct Infeasible : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The planner lacks what the problem asks for. Outcome `unsupported`.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What a run gives its planner besides the problem. Not copyable; one per call of plan().
class Context {
 public:
  struct Sinks {  // all optional
    std::function<void(const Path&)> publish;
    std::function<void(double)> progress;
    std::function<void(const Trace&)> trace;
    std::function<void(const std::string&, double)> report;
  };
  using Clock = std::chrono::steady_clock;
  explicit Context(std::uint64_t seed = 1, double wall_s = 1e9, Sinks sinks = {});
  Context(const Context&) = delete;

  Rng& rng() { return rng_; }  // the only source of randomness
  /// True once the time is up or somebody cancelled: stop soon, return what you have.
  bool cancelled() const;
  double seconds_left() const;
  void cancel() { cancelled_ = true; }
  /// The best path so far: survives a timeout.
  void publish(const Path& path);
  void progress(double fraction);
  /// A picture of the inside. wants_traces() tells whether making one is worth it.
  void trace(std::string name, std::vector<Polyline> lines);
  void trace(std::string name, const Region& region);
  bool wants_traces() const { return static_cast<bool>(sinks_.trace); }
  /// A figure of the run that the path does not show ("explored_share"): a row of metrics.csv. Not to be confused with
  /// metrics/, which judge the path. Throws std::invalid_argument for a name that is not [a-z0-9_]+.
  void report(const std::string& name, double value);

 private:
  Rng rng_;
  Clock::time_point deadline_;
  Sinks sinks_;
  bool cancelled_ = false;
};

class CoveragePlanner {
 public:
  virtual ~CoveragePlanner() = default;
  /// Throws Infeasible, Unsupported, std::invalid_argument. Const: no state between calls.
  virtual Path plan(const Problem& problem, Context& context) const = 0;
};

enum class Capability { tether, online, holes, curvature, footprint };
std::string to_text(Capability capability);

struct PlannerInfo {
  std::string name, family, title, citation;
  std::vector<Capability> capabilities;
  std::string guarantee;
  std::vector<ParameterInfo> parameters;
  std::function<std::unique_ptr<CoveragePlanner>(const Settings&)> make;  // checks the settings
  /// For planners that run another one: what more there is to set, once the settings say which. Empty for most.
  std::function<std::vector<ParameterInfo>(const Settings&)> more_parameters = {};
  bool has(Capability capability) const;
};

/// The description of a planner with its parameters, in one literal.
template <class P>
struct Description {
  std::string name, family, title, citation;
  std::vector<Capability> capabilities;
  std::string guarantee;
  std::vector<Parameter<P>> parameters;
};
template <class Planner, class P>
PlannerInfo describe(Description<P> d) {
  PlannerInfo info{d.name, d.family, d.title, d.citation, d.capabilities, d.guarantee, to_infos(d.parameters), {}, {}};
  info.make = [owner = "planner '" + d.name + "'", lines = std::move(d.parameters)](const Settings& s) {
    return std::make_unique<Planner>(with_settings<P>(owner, lines, s));
  };
  return info;
}

/// All parameters that the planner takes beside these settings. Throws as `make` does if they name a planner that is none.
std::vector<ParameterInfo> parameters_of(const PlannerInfo& planner, const Settings& settings);

/// Why this planner cannot take this problem at all ("planner 'stc' has no capability 'tether'"), or "".
std::string missing_capability(const PlannerInfo& planner, const Problem& problem);

/// The built-in planners, listed in algorithms/zoo.cpp and nowhere else.
const std::vector<PlannerInfo>& zoo();
/// Throws "no planner 'boustrofedon'; did you mean 'boustrophedon'? There are: ...".
const PlannerInfo& find_planner(const std::vector<PlannerInfo>& planners, const std::string& name);

}  // namespace oxturn
