// Decisions   1. A planner that promises the whole target works in the inner space (inner_space.hpp), where no lap runs
//                beside the target. One that promises cells works wherever it can cover some of the target
//                (Problem::work_space): a cell counts if it lies in that space and holds some of the target.
//                One that promises nothing works in the inner space, or where that is empty, as the others do.
//             2. Components are visited in the order in which the robot comes to them, always the nearest by path.
//                Those that only cover what larger ones cover already are left out.
//             3. A component in which the planner finds nothing to drive, as where no cell fits, is left out; the
//                detours of a planner that promises the target cover it. If it finds nothing in any of them, its
//                reason is the answer.
//             4. Components start at the vertex that the robot reaches first; for planners on a lattice, whose cells
//                are counted from the start, at their roomiest point.
#include "algorithms/target_area_planner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "algorithms/lanes/inner_space.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/nearest_component.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"

namespace oxturn {
namespace {

constexpr double kNegligible = 1e-4;  // w^2: what a component must cover that larger ones do not

/// The components of the work space, largest first, without those that larger ones make superfluous.
std::vector<Polygon> needed_components(const Problem& problem) {
  const double w = problem.robot().tool_width;
  std::vector<Polygon> parts = problem.work_space().polygons, needed;
  std::ranges::stable_sort(parts, std::greater<>(), [](const Polygon& part) { return area(part); });
  Region left = reachable_target(problem);
  for (Polygon& part : parts) {
    const Region after = subtract(left, dilate(Region{{part}}, w / 2, w / 1000, Bound::outside));
    if (area(left) - area(after) < kNegligible * w * w) continue;
    left = after;
    needed.push_back(std::move(part));
  }
  return needed;
}

std::vector<Polygon> parts_to_work_in(const Problem& problem, Promise promise) {
  if (promise == Promise::cells) return needed_components(problem);
  std::vector<Polygon> inner = inner_space(problem).polygons;
  return inner.empty() && promise == Promise::nothing ? needed_components(problem) : inner;
}

/// One run of a planner in the components.
class TargetAreaRun {
 public:
  TargetAreaRun(const CoveragePlanner& inner, Promise promise, const Problem& problem, Context& context)
      : inner_(inner),
        promise_(promise),
        problem_(problem),
        context_(context),
        connector_(problem),
        parts_(parts_to_work_in(problem, promise)),
        nearest_(problem),
        builder_(problem.start()) {}

  Path run() {
    for (std::size_t k = 0; k < parts_.size(); ++k) add_entries(k);
    for (std::size_t done = 0; done < parts_.size() && !context_.cancelled(); ++done) cover_next(done);
    if (covered_ == 0 && !refusal_.empty() && promise_ != Promise::target) throw Infeasible(refusal_);
    Path path = builder_.take();
    promise_cells();
    if (promise_ != Promise::target || context_.cancelled()) return path;
    return repaired(problem_, path, uncovered(reachable_target(problem_), path, problem_.robot()), connector_,
                    context_);
  }

 private:
  void add_entries(std::size_t k) {
    const int component = static_cast<int>(k);
    const auto add = [&](const Point& at) {
      nearest_.add(at, component, entries_.size());
      entries_.push_back({at, k});
    };
    if (const EdgeIndex part(Region{{parts_[k]}}); part.contains(problem_.start()))
      add(problem_.start());
    else if (promise_ == Promise::cells)
      add(Mesh(Region{{parts_[k]}}).roomiest_point().value_or(parts_[k].outer.front()));
    else
      std::ranges::for_each(parts_[k].outer, add);
  }

  void cover_next(std::size_t number) {
    const auto found = nearest_.from(builder_.at());
    if (!found) throw std::logic_error("a component of the work space cannot be reached");
    const auto [entry, part] = entries_[found->id];
    nearest_.remove(static_cast<int>(part));
    Context inner(number == 0 ? context_.seed() : context_.rng().bits(), context_.seconds_left(), sinks(number));
    try {
      const Path path = inner_.plan(problem_.restricted(Region{{parts_[part]}}, entry), inner);
      builder_.drive(found->path, false);
      for (const Leg& leg : path.legs) drive(leg);
      ++covered_;
      if (number + 1 < parts_.size()) context_.publish(builder_.path());
    } catch (const Infeasible& e) { refusal_ = e.what(); }
  }
  /// With the tool off through all of configuration space.
  void drive(const Leg& leg) {
    if (leg.tool || leg.gear == Gear::reverse) return builder_.drive(leg.points, leg.tool, leg.gear, leg.width);
    const Polyline shortest = connector_.path(leg.points.front(), leg.points.back());
    builder_.drive(length(shortest) < length(leg.points) ? shortest : leg.points, false);
  }

  Context::Sinks sinks(std::size_t number) {
    Context::Sinks sinks = context_.traces_only();
    if (number > 0 && sinks.trace)
      sinks.trace = [this, number](const Trace& trace) {
        context_.trace(fmt::format("{} {}", trace.name, number + 1), trace.lines);
      };
    if (context_.wants_promise())
      sinks.promise = [this](std::function<Region()> region) { promises_.push_back(std::move(region)); };
    return sinks;
  }
  void promise_cells() {
    if (promises_.empty()) return;
    context_.promise([promises = std::move(promises_)] {
      std::vector<Region> regions;
      for (const auto& region : promises) regions.push_back(region());
      return unite(regions);
    });
  }

  struct Entry {
    Point at;
    std::size_t part;
  };
  const CoveragePlanner& inner_;
  Promise promise_;
  const Problem& problem_;
  Context& context_;
  Connector connector_;
  std::vector<Polygon> parts_;
  std::vector<Entry> entries_;
  NearestComponent nearest_;
  PathBuilder builder_;
  std::size_t covered_ = 0;
  std::string refusal_;
  std::vector<std::function<Region()>> promises_;
};

class TargetAreaPlanner final : public CoveragePlanner {
 public:
  /// `inner_laps`: also where all of the map is to be covered.
  TargetAreaPlanner(std::unique_ptr<CoveragePlanner> inner, Promise promise, bool inner_laps)
      : inner_(std::move(inner)), promise_(promise), inner_laps_(inner_laps) {}
  Path plan(const Problem& problem, Context& context) const override {
    const Robot& robot = problem.robot();
    const bool wide = inner_laps_ && robot.tool_width / 2 > robot.radius;
    if (!problem.map().target_area && !wide) return inner_->plan(problem, context);
    return TargetAreaRun(*inner_, promise_, problem, context).run();
  }

 private:
  std::unique_ptr<CoveragePlanner> inner_;
  Promise promise_;
  bool inner_laps_;
};

constexpr const char* kLaps = "laps";

ParameterInfo laps_parameter() {
  return {
      kLaps,
      std::string("wall"),
      {},
      {"wall", "inner"},
      "of a tool wider than the robot: as near to walls as the robot can drive, or half the tool's width from them, "
      "with detours into corners"};
}

/// The settings of the planner itself.
Settings without_laps(Settings settings) {
  settings.erase(kLaps);
  return settings;
}

bool sees_by_lidar(const PlannerInfo& info, const Settings& settings) {
  if (!info.has(Capability::online)) return false;
  const bool choice = std::ranges::any_of(info.parameters, [](const ParameterInfo& p) { return p.name == "sensing"; });
  const auto sensing = settings.find("sensing");
  return !choice || (sensing != settings.end() && sensing->second == Value(std::string("lidar")));
}

}  // namespace

PlannerInfo target_area_planner(PlannerInfo info) {
  if (info.covers_target_areas || info.has(Capability::tether) || info.more_parameters) return info;
  const PlannerInfo original = info;
  const bool has_laps = info.promise == Promise::target;
  if (has_laps) info.parameters.push_back(laps_parameter());
  info.make = [original, has_laps](const Settings& settings,
                                   const Planners& planners) -> std::unique_ptr<CoveragePlanner> {
    const Settings own = has_laps ? without_laps(settings) : settings;
    std::unique_ptr<CoveragePlanner> inner = original.make(own, planners);
    if (sees_by_lidar(original, own)) return inner;
    const auto laps = settings.find(kLaps);
    const bool inner_laps =
        has_laps && laps != settings.end() &&
        checked("planner '" + original.name + "'", laps_parameter(), laps->second) == Value(std::string("inner"));
    return std::make_unique<TargetAreaPlanner>(std::move(inner), original.promised(own), inner_laps);
  };
  if (original.promises_with)
    info.promises_with = [holds = original.promises_with](const Settings& settings) {
      return holds(without_laps(settings));
    };
  return info;
}

}  // namespace oxturn
