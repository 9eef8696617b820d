// The shortest path that a budget of moves finds: the zoo's short paths, annealed.
//
// Source      ours; see improve/improve.hpp
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the share `coverage` of the target, but for seams thinner than a 250th of the tool's width; never
//             longer than its start, completed
// Complexity  a few microseconds a move
// Decisions   1. Starts: `boustrophedon` in its own direction and along both axes, and `contour`. Each is
//                annealed briefly, the best one at length. Where the moves are few for the problem's vertices, there
//                are fewer starts: a start takes the time of some moves for each of these. Unless the tool is wider
//                than four robots, there are two at least.
//             2. All starts but the first drive at half the tool's width from walls: nearer to them, a tool wider than
//                the robot is wasted in part, and annealing does not shift all lanes of a field by as much.
//             3. `contour` is judged whole, but annealed at length without its repair: annealing covers what is between
//                its laps on less length than its detours do, and does not get rid of these.
#include "algorithms/coverage_planner.hpp"
#include "algorithms/improve/improve.hpp"
#include "algorithms/improve/part.hpp"
#include "geometry/point_count.hpp"

namespace oxturn {
namespace {

constexpr double kNoLimit = 1e9;  // seconds
// Moves for each vertex of configuration space and of the starts so far, below which there are no more starts: making
// one takes the time of about so many.
constexpr double kMovesEach = 4;

struct Start {
  const char* planner;
  Settings settings;
  bool repaired = false;  // by detours, without which it can be planned, too
};
/// The first one covers the whole target.
std::vector<Start> starts(AnnealingPart without) {
  const std::string laps = without == AnnealingPart::laps ? "wall" : "inner", given = "given";
  std::vector<Start> all{{"boustrophedon", {}},
                         {"contour", {{"laps", laps}}, true},
                         {"boustrophedon", {{"laps", laps}, {"sweep", given}, {"angle", 0.0}}},
                         {"boustrophedon", {{"laps", laps}, {"sweep", given}, {"angle", 90.0}}}};
  if (without == AnnealingPart::starts) all.resize(1);
  return all;
}

/// However few the moves are. Lanes are shorter in some spaces, laps in others; but those of a tool that is much wider
/// than the robot leave much to repair among many obstacles, which takes longer than all moves.
std::size_t least_starts(const Robot& robot) { return is_wide_tool(robot) ? 1 : 2; }

class Shortest final : public CoveragePlanner {
 public:
  Shortest(const Improvement& how, const Planners& planners) : how_(how) {
    const AnnealingPart without = part_named(how.without);
    for (const Start& start : starts(without)) {
      const PlannerInfo& info = planners.find(start.planner);
      starts_.push_back({info.make(start.settings, planners), nullptr, info.promised(start.settings)});
      if (!start.repaired || without == AnnealingPart::unrepaired) continue;
      Settings unrepaired = start.settings;
      unrepaired["repair"] = false;
      starts_.back().unrepaired = info.make(unrepaired, planners);
    }
  }

  Path plan(const Problem& problem, Context& context) const override {
    std::vector<PathToImprove> paths;
    double vertices = 0;  // of configuration space and the path, for each start
    for (const auto& [planner, unrepaired, promise] : starts_) {
      // Where there is no time from the beginning, the first one, which is quick, is driven all the same.
      Context inner(context.seed(), context.cancelled() ? kNoLimit : context.seconds_left());
      try {
        paths.push_back({planner->plan(problem, inner)});
        paths.back().complete = promise == Promise::target && !inner.cancelled();
        if (unrepaired && enough_for_unrepaired(how_, problem) && !context.cancelled())
          paths.back().unrepaired = unrepaired->plan(problem, inner);
      } catch (const Infeasible&) { continue; }
      if (paths.size() == 1) context.publish(paths.front().path);
      vertices +=
          static_cast<double>(vertex_count(problem.configuration_space()) + point_count(paths.back().path.legs));
      const bool few = kMovesEach * vertices > moves_in_all(how_, problem);
      if (context.cancelled() || (few && paths.size() >= least_starts(problem.robot()))) break;
    }
    if (paths.empty()) paths.emplace_back();  // all of the path is detours
    return improved(problem, paths, how_, context);
  }

 private:
  struct Planned {
    std::unique_ptr<CoveragePlanner> planner, unrepaired;
    Promise promise;
  };
  Improvement how_;
  std::vector<Planned> starts_;
};

}  // namespace

PlannerInfo shortest() {
  PlannerInfo info = improving_planner("shortest", "the shortest path that a budget finds, by annealing",
                                       "covers the share `coverage` of the target; never longer than its start");
  info.covers_target_areas = true;
  info.make = [](const Settings& settings, const Planners& planners) {
    return std::make_unique<Shortest>(
        with_settings<Improvement>("planner 'shortest'", improvement_parameters(), settings), planners);
  };
  return info;
}

}  // namespace oxturn
