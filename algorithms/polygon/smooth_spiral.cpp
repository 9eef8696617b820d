// A smooth spiral from the middle to the boundary, with others nested in it.
//
// Source      Held and Spielberger, "A smooth spiral tool path for high speed machining of 2D pockets", Computer-Aided
//             Design 41(7), 2009; islands after "Improved spiral high-speed machining of multiply-connected pockets",
//             Computer-Aided Design and Applications 11(3), 2014
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target (along traced walls but for 0.0005 of it): points of neighbouring laps on the
//             path to the same leaf are at most 0.95 w apart, and straight motion from one lap to the next sweeps all
//             between them. So each point is within 0.475 w of the end of such a segment, which is on a lap before it
//             is smoothed; smoothing moves it by at most 0.025 w. The rest is within w/2 of the last lap, the boundary.
// Complexity  O(n log n) for the medial axis, and its output: l m points of l feet on the boundary and m laps
// Decisions   1. The wave over the medial axis and its laps: polygon/wave_tree.hpp.
//             2. islands = bridge: they are connected with the boundary by their shortest bridges, a minimum spanning
//                tree (2014: by local minima of clearance, which these are). A bridge is a cut w / 1000 wide; each of
//                its sides is driven. One curve. islands = decompose (2014): further cuts divide the rest, so that laps
//                lie more evenly (island_cuts.hpp); a spiral for each part, always the nearest one next.
//             3. start = spine: the wave leaves all points higher above the boundary than 1 or 1.5 times the greatest
//                clearance at time 0, or the root alone, whatever gives the shortest curve, and the robot drives these
//                first. Otherwise laps of long shapes lie many times closer than the tool is wide, because all parts
//                have as many laps as the longest branch. Where more than 0.9 of the work would still be done twice
//                (few laps in narrow shapes), laps are closed and linked: a spiral has one more.
//                start = nested: the wave may start lower, too, and wide parts then have spirals of their own
//                (nested_spirals.hpp): without, corridors have as many laps as rooms. Laps do not go into dead ends
//                that are covered from the boundary.
//             4. Where the boundary has thousands of vertices and islands = bridge, all laps but the last follow the
//                medial axis of a region whose arcs have fewer vertices: about half of them. They are off by up to 0.02
//                of the tool's or the robot's width, whichever is less. Where laps are as far apart as they may be and
//                an arc is off that far, repair covers a seam beside the last.
//             5. The heights of the spine are compared by an eighth of the feet where there are thousands.
//             6. Smoothing: vertices that matter less than 0.0125 w are left out; corners of 0.15 rad and more become
//                several within 0.0125 w, but for those of the last lap, which is the boundary.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/polygon/island_cuts.hpp"
#include "algorithms/polygon/nested_spirals.hpp"
#include "algorithms/polygon/smooth_curve.hpp"
#include "algorithms/polygon/wave_tree.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/coarse_arcs.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

// Tool widths.
constexpr double kStep = 0.95;         // between laps
constexpr double kSkip = 0.0125;       // by which vertices may be left out
constexpr double kRound = 0.0125;      // by which corners may be cut
constexpr double kChord = 0.01;        // error of the axis' parabolas
constexpr double kChordError = 0.001;  // of small arcs
constexpr double kCoarser = 0.02;      // tool or robot widths by which arcs may be off, for all laps but the last
constexpr double kBridge = 1e-3;       // width of the cuts along bridges
constexpr double kLeastCut = 1e-6;     // the same at least, of the map's extent

constexpr std::size_t kManyVertices = 8192;  // of the boundary, from which on all laps but the last are coarser

enum class Start { nested, spine, centre, start };
enum class Direction { out, in };
enum class Islands { bridge, decompose };

struct Params {
  Start start = Start::nested;
  Islands islands = Islands::bridge;
  Direction direction = Direction::out;
  bool repair = true;
};

Region without_holes(const Region& space, const Params& p, double width, const Context& context) {
  const double cut = std::max(kBridge * width, kLeastCut * bounding_box(space).size().maxCoeff());
  if (p.islands == Islands::bridge) return bridged(space, cut);
  const double height = p.start == Start::nested || p.start == Start::spine ? kSpineHeight : kRootAlone;
  return decomposed(space, {cut, kChord * width, height}, context);
}

/// The boundary of a region without holes, as laps end with it.
class Rings {
 public:
  explicit Rings(const Region& region) : edges_(region) {
    std::size_t first = 0;
    for (const Polygon& polygon : region.polygons) {
      ring_of_.insert(ring_of_.end(), polygon.outer.size(), {first, polygon.outer.size()});
      first += polygon.outer.size();
    }
  }
  /// The ring that comes nearest to a point, closed, from there on.
  Polyline from(const Point& p) const {
    const EdgeIndex::Nearest begin = *edges_.nearest(p);
    const auto [first, size] = ring_of_[begin.edge];
    Polyline ring{begin.point};
    for (std::size_t k = 1; k <= size; ++k) {
      const Point& next = edges_.edges()[first + (begin.edge - first + k) % size].a;
      if (next != ring.back()) ring.push_back(next);
    }
    if (begin.point != ring.back()) ring.push_back(begin.point);
    return ring;
  }

 private:
  EdgeIndex edges_;
  std::vector<std::pair<std::size_t, std::size_t>> ring_of_;  // by edge: its ring's first edge, and how many
};

/// A tree's spiral as it is driven outwards.
Polyline spiral_of(WaveTree tree, const Rings& rings, const Params& p, const Problem& problem,
                   const Connector& connector) {
  const double w = problem.robot().tool_width;
  if (p.start == Start::start) tree.root_near(problem.start());
  if (p.start == Start::spine || p.start == Start::centre) tree.root_at_centre();
  const LapWidths widths{w, kStep * w};
  WaveSpiral spiral =
      p.start == Start::nested ? nested_spirals(tree, widths, problem.start())
      : p.start == Start::spine
          ? spiral_from_spine(tree, widths, problem.start())
          : tree.spiral(std::max(1.0, std::ceil(tree.height() / widths.step - 1e-9)), kRootAlone, problem.start());
  Polyline curve = std::move(spiral.laps);  // millions of points: nothing copies them
  curve.insert(curve.begin(), spiral.spine.begin(), spiral.spine.end());
  curve = with_fewer_vertices(std::move(curve), kSkip * w, connector);
  curve = rounded_corners(curve, {.off = kRound * w, .chord = kChordError * w}, connector);
  const Point end = spiral.boundary.front();
  Polyline last = rings.from(end);
  if (!connector.straight(end, last.front())) last = std::move(spiral.boundary);  // of another component: repair helps
  curve.push_back(end);
  const Polyline boundary = without_collinear_vertices(last);
  curve.insert(curve.end(), boundary.begin(), boundary.end());
  if (p.direction == Direction::in) std::ranges::reverse(curve);
  return curve;
}

/// The curve whose beginning is nearest.
std::size_t nearest_curve(const std::vector<Polyline>& curves, const Point& from, const Connector& connector) {
  if (curves.size() == 1) return 0;
  std::vector<std::pair<double, std::size_t>> candidates;
  for (std::size_t k = 0; k < curves.size(); ++k) candidates.push_back({distance(from, curves[k].front()), k});
  const auto length = [&](std::size_t k, double longest) { return connector.length(from, curves[k].front(), longest); };
  return nearest_by_path(std::move(candidates), length).value_or(0);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  const Region walls = straightened_space(problem), space = without_holes(walls, p, w, context);
  // By the robot's width, too: a tool many times wider is no measure of the passages that the robot fits through.
  const double coarser = kCoarser * std::min(w, 2 * problem.robot().radius);
  const bool coarse = p.islands == Islands::bridge && coarser > 0 && vertex_count(walls) > kManyVertices;
  MedialAxis axis =
      medial_axis(coarse ? without_holes(with_coarser_arcs(walls, coarser), p, w, context) : space, kChord * w);
  const Rings rings(space);
  if (context.wants_traces()) {
    std::vector<Polyline> lines;
    for (const MedialAxis::Edge& e : axis.edges) lines.push_back({axis.nodes[e.a].at, axis.nodes[e.b].at});
    context.trace("axis", std::move(lines));
  }
  const Connector connector(problem);
  std::vector<WaveTree> trees = wave_trees(axis);
  axis = {};
  std::vector<Polyline> curves;
  for (WaveTree& tree : trees) {
    if (context.cancelled()) break;
    curves.push_back(spiral_of(std::move(tree), rings, p, problem, connector));
  }
  trees.clear();
  context.record("spirals", static_cast<double>(curves.size()));
  PathBuilder path(problem.start());
  while (!curves.empty()) {
    const auto next = curves.begin() + static_cast<std::ptrdiff_t>(nearest_curve(curves, path.at(), connector));
    path.drive(connector.path(path.at(), next->front()), false);
    path.drive(std::move(*next), true);
    curves.erase(next);
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
       .title = "smooth spirals from the middle to the boundary, nested where wide parts meet narrow ones",
       .citation = "Held, Spielberger 2009",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (along traced walls but for 0.0005 of it)",
       .promise = Promise::target,
       .parameters =
           {{"start", &Params::start, Choices{"nested", "spine", "centre", "start"},
             "from where the spiral grows: nested: the axis' middle parts, with a spiral in each wide part; spine: "
             "its middle part alone; centre: its centre; start: the robot's start"},
            {"islands", &Params::islands, Choices{"bridge", "decompose"},
             "bridge: connected with the boundary, one spiral; decompose: cut into parts with even laps"},
            {"direction", &Params::direction, Choices{"out", "in"}, "driven outwards or inwards"},
            {"repair", &Params::repair, "cover what rounding leaves at bridges"}},
       .published = {{"start", std::string("centre")}, {"repair", false}}});
}

}  // namespace oxturn
