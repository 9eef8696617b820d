// One smooth spiral from the middle to the boundary.
//
// Source      Held and Spielberger, "A smooth spiral tool path for high speed machining of 2D pockets", Computer-Aided
//             Design 41(7), 2009; islands after "Improved spiral high-speed machining of multiply-connected pockets",
//             Computer-Aided Design and Applications 11(3), 2014
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target (along traced walls but for 0.0003 of it): points of neighbouring laps on the
//             path to the same leaf are at most 0.95 w apart, and straight motion from one lap to the next sweeps all
//             between them. So each point is within 0.475 w of the end of such a segment, which is on a lap before it
//             is smoothed; smoothing moves it by at most 0.025 w. The rest is within w/2 of the last lap, the boundary.
// Complexity  O(n log n) for the medial axis, and its output: l m points of l feet on the boundary and m laps
// Decisions   1. The wave over the medial axis and its laps: polygon/wave_tree.hpp.
//             2. Islands are connected with the boundary by their shortest bridges, a minimum spanning tree (2014: by
//                local minima of clearance, which these are). A bridge is a cut w / 1000 wide; each of its sides is
//                driven.
//             3. start = spine: the wave leaves all points higher above the boundary than 1.5 times the greatest
//                clearance at time 0, and the robot drives these first. Otherwise laps of long shapes lie many times
//                closer than the tool is wide, because all parts have as many laps as the longest branch.
//             4. Smoothing: vertices that matter less than 0.005 w are left out; corners become tangent arcs within
//                0.02 w, but for those of the last lap, which is the boundary.
#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/polygon/smooth_curve.hpp"
#include "algorithms/polygon/wave_tree.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/overlay/cut_along.hpp"

namespace oxturn {
namespace {

// Tool widths.
constexpr double kStep = 0.95;        // between laps
constexpr double kSkip = 0.005;       // by which vertices may be left out
constexpr double kRound = 0.02;       // by which arcs may cut corners
constexpr double kChord = 0.01;       // error of the axis' parabolas
constexpr double kBridge = 1e-3;      // width of the cuts along bridges
constexpr double kLeastCut = 1e-6;    // the same at least, of the map's extent
constexpr double kSpineHeight = 1.5;  // greatest clearances

enum class Start { spine, centre, start };
enum class Direction { out, in };

struct Params {
  Start start = Start::spine;
  Direction direction = Direction::out;
  bool repair = true;
};

Region without_holes(const Region& space, double width) {
  const double cut = std::max(kBridge * width, kLeastCut * bounding_box(space).size().maxCoeff());
  return cut_along(space, shortest_bridges(space), cut);
}

/// A tree's spiral as it is driven outwards.
Polyline spiral_of(WaveTree tree, const Params& p, const Problem& problem, const Connector& connector) {
  const double w = problem.robot().tool_width;
  p.start == Start::start ? tree.root_near(problem.start()) : tree.root_at_centre();
  const double high =
      p.start == Start::spine ? kSpineHeight * tree.greatest_clearance() : std::numeric_limits<double>::infinity();
  WaveSpiral spiral = tree.spiral(kStep * w, high, problem.start());
  Polyline curve = std::move(spiral.spine);
  curve.insert(curve.end(), spiral.laps.begin(), spiral.laps.end());
  curve = rounded_corners(with_fewer_vertices(curve, kSkip * w, connector), kRound * w, connector);
  const Polyline boundary = without_collinear_vertices(spiral.boundary);
  curve.insert(curve.end(), boundary.begin(), boundary.end());
  if (p.direction == Direction::in) std::ranges::reverse(curve);
  return curve;
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  const MedialAxis axis = medial_axis(without_holes(straightened_space(problem), w), kChord * w);
  if (context.wants_traces()) {
    std::vector<Polyline> lines;
    for (const MedialAxis::Edge& e : axis.edges) lines.push_back({axis.nodes[e.a].at, axis.nodes[e.b].at});
    context.trace("axis", std::move(lines));
  }
  const Connector connector(problem);
  PathBuilder path(problem.start());
  for (WaveTree& tree : wave_trees(axis)) {
    if (context.cancelled()) break;
    const Polyline curve = spiral_of(std::move(tree), p, problem, connector);
    path.drive(connector.path(path.at(), curve.front()), false);
    path.drive(curve, true);
  }
  Path whole = without_short_segments(path.take(), problem);
  context.publish(whole);
  return p.repair && !context.cancelled() ? repaired(problem, whole, connector, context) : whole;
}

}  // namespace

PlannerInfo smooth_spiral() {
  return describe<Params, plan>(
      {.name = "smooth-spiral",
       .family = "polygon",
       .title = "one smooth spiral from the middle to the boundary",
       .citation = "Held, Spielberger 2009",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (along traced walls but for 0.0003 of it)",
       .promise = Promise::target,
       .parameters = {{"start", &Params::start, Choices{"spine", "centre", "start"},
                       "from where the spiral grows: the axis' middle part, its centre, or the robot's start"},
                      {"direction", &Params::direction, Choices{"out", "in"}, "driven outwards or inwards"},
                      {"repair", &Params::repair, "cover what rounding leaves at bridges"}},
       .published = {{"start", std::string("centre")}, {"repair", false}}});
}

}  // namespace oxturn
