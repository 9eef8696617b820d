// The fewest straight lanes along two perpendicular directions, and a tour of them.
//
// Source      Ramesh, Imeson, Fidan, Smith, "Optimal partitioning of non-convex environments for minimum turn coverage
//             planning", IEEE Robotics and Automation Letters 7(4), 2022 (optimal axis-parallel rank partitioning)
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   the fewest lanes along the axes of its grid. With `outline`: covers the whole target (along traced walls
//             but for 0.0005 of it): a point of the region that is left to the lanes is at least w/2 from the boundary
//             of configuration space C, and at most that far from its foot on the centre line of its run of cells. So
//             the foot is in C, on the lane.
// Complexity  n cells, m lanes: about O(n) for the fewest lanes (polygon/fewest_lanes.hpp), about O(m log m) steps and
//             path searches for the order
// Decisions   1. Cells are as wide as the tool. The grid begins at the lower left end of the region in the lanes'
//                frame; with `shifts` = k that of k x k origins which gives the fewest lanes.
//             2. With `outline` the cells are those that the region left to lanes touches, and a lane is the projection
//                of that region onto the run's centre line (lanes/lanes.hpp). Without, as in the paper, they are those
//                whose centre is in C, and lanes go from the first cell's outer side to the last one's, as far as free.
//             3. The paper solves a linear program. A minimum cut has the same optimum.
//             4. compact = true: of all optima one with few borders between horizontal and vertical lanes.
//             5. group = true: runs of lanes side by side are one element of the tour, driven back and forth. Without,
//                as in the paper, each lane is an element with two directions.
#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/lanes/headland.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/polygon/fewest_lanes.hpp"
#include "algorithms/polygon/needed_outline.hpp"

namespace oxturn {
namespace {

constexpr double kMostCells = 2e7;

struct Params : Headland, OutlineChoice {
  LaneDirection align = LaneDirection::best;
  double angle = 0;
  bool compact = true;
  bool group = true;
  int shifts = 1;
};

/// Cells over a region in the frame of vertical lanes.
BitGrid cells_over(const Region& region, double side, const Point& shift, CellRule rule) {
  const Box box = bounding_box(region);
  const Point low = box.low - side * shift, size = (box.high - low) / side;
  if ((size.x() + 1) * (size.y() + 1) > kMostCells)
    throw Infeasible("the map has more than 2e7 cells as wide as the tool: take a wider tool or a smaller map");
  const auto count = [](double cells) { return std::max(1, static_cast<int>(std::ceil(cells - 1e-6))); };
  return rasterise(region, low, side, count(size.x()), count(size.y()), rule);
}

struct RunCover {
  BitGrid cells;
  std::vector<CellRun> runs;
};

/// The runs from the origin that needs fewest.
RunCover fewest_runs_of(const Region& region, double side, CellRule rule, const Params& p, const Context& context) {
  RunCover best;
  for (int k = 0; k < p.shifts * p.shifts && !context.cancelled(); ++k) {
    const Point shift = Point(k % p.shifts, k / p.shifts) / p.shifts;
    BitGrid cells = cells_over(region, side, shift, rule);
    std::vector<CellRun> runs = fewest_runs(cells, p.compact);
    if (k == 0 || runs.size() < best.runs.size()) best = {std::move(cells), std::move(runs)};
  }
  return best;
}

/// The lanes of runs along one direction, in the frame in which they are vertical.
class LaneMaker {
 public:
  /// `first`, `lines`: x of the first line's left side, and how many lines there are.
  LaneMaker(const Problem& problem, const Region& region, double degrees, double first, int lines)
      : frame_(degrees),
        space_(frame_.to_frame(problem.configuration_space())),
        slabs_{first, problem.robot().tool_width, static_cast<std::size_t>(lines)},
        margin_(2 * problem.tolerance()),
        by_slab_(slabs_.count) {
    for (const LaneInterval& i : project(edges_of(frame_.to_frame(region)), slabs_).intervals)
      by_slab_[std::min(i.slab, slabs_.count - 1)].push_back(i);
  }

  /// What the region has between two heights of a slab, on its centre line. With `whole`: all that is free there.
  std::vector<LaneEnds> lanes(std::size_t slab, double low, double high, bool whole) const {
    std::vector<LaneInterval> intervals;
    if (whole) intervals.push_back({slab, low, high});
    for (const LaneInterval& i : by_slab_[slab])
      if (const double a = std::max(low, i.low), b = std::min(high, i.high); !whole && a < b)
        intervals.push_back({slab, a, b});
    std::vector<LaneEnds> lanes;
    const double x = slabs_.centre(slab);
    for (const LaneInterval& i : clip_lanes(intervals, slabs_, space_, slabs_.width, margin_).pieces)
      lanes.push_back({frame_.to_world({x, i.low}), frame_.to_world({x, i.high})});
    return lanes;
  }

 private:
  LaneFrame frame_;
  EdgeIndex space_;
  Slabs slabs_;
  double margin_;
  std::vector<std::vector<LaneInterval>> by_slab_;
};

/// For each run the one beside it on the next line, if each is the only one beside the other; else -1.
std::vector<int> followers(const std::vector<CellRun>& runs) {
  std::vector<int> next(runs.size(), -1), previous(runs.size(), -1);
  constexpr int kSeveral = -2;
  std::size_t from = 0;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const CellRun& r = runs[i];
    const auto is_before = [&](const CellRun& o) {  // all that follows the line before this run's in the list
      return std::pair(!o.horizontal, o.line) < std::pair(!r.horizontal, r.line + 1);
    };
    while (from < runs.size() && is_before(runs[from])) ++from;
    for (std::size_t k = from; k < runs.size(); ++k) {
      const CellRun& o = runs[k];
      if (o.horizontal != r.horizontal || o.line != r.line + 1 || o.first > r.last) break;
      if (o.last < r.first) continue;
      next[i] = next[i] == -1 ? static_cast<int>(k) : kSeveral;
      previous[k] = previous[k] == -1 ? static_cast<int>(i) : kSeveral;
    }
  }
  for (std::size_t i = 0; i < runs.size(); ++i)
    if (next[i] < 0 || previous[static_cast<std::size_t>(next[i])] != static_cast<int>(i)) next[i] = -1;
  return next;
}

/// Strips of runs that follow each other; lanes that a run has besides its first are strips of their own.
std::vector<Strip> strips_of(const std::vector<CellRun>& runs, const std::vector<std::vector<LaneEnds>>& lanes,
                             bool group) {
  std::vector<int> next = group ? followers(runs) : std::vector<int>(runs.size(), -1);
  for (std::size_t i = 0; i < runs.size(); ++i)  // lanes in pieces stand alone
    if (lanes[i].size() != 1 || (next[i] >= 0 && lanes[static_cast<std::size_t>(next[i])].size() != 1)) next[i] = -1;
  std::vector<bool> follows(runs.size(), false);
  for (const int n : next)
    if (n >= 0) follows[static_cast<std::size_t>(n)] = true;
  std::vector<Strip> strips;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (follows[i]) continue;
    for (const LaneEnds& lane : lanes[i]) strips.push_back({.lanes = {lane}});
    for (int k = next[i]; k >= 0; k = next[static_cast<std::size_t>(k)])
      strips.back().lanes.push_back(lanes[static_cast<std::size_t>(k)].front());
  }
  return strips;
}

std::vector<Strip> strips_in(const Region& region, const Params& p, const Problem& problem, Context& context) {
  if (region.empty()) return {};
  const bool laps = p.outline != OutlineExtent::off || p.headland > 0;  // cover what cells beside walls do not
  const double w = problem.robot().tool_width;
  const double degrees = p.align == LaneDirection::given ? p.angle : best_lane_direction(region, w);
  const CellRule rule = laps ? CellRule::touches : CellRule::centre;
  const LaneFrame frame(degrees);
  const RunCover cover = fewest_runs_of(frame.to_frame(region), w, rule, p, context);
  if (cover.runs.empty()) return {};
  const Point& low = cover.cells.origin;
  context.record("lanes", static_cast<double>(cover.runs.size()));
  // In the frame of the horizontal lanes x is this frame's y, and y its -x.
  const LaneMaker vertical(problem, region, degrees, low.x(), cover.cells.columns);
  const LaneMaker horizontal(problem, region, degrees + 90, low.y(), cover.cells.rows);
  std::vector<std::vector<LaneEnds>> lanes;
  for (const CellRun& r : cover.runs) {
    const auto line = static_cast<std::size_t>(r.line);
    const double a = r.first * w, b = (r.last + 1) * w;
    lanes.push_back(r.horizontal ? horizontal.lanes(line, -low.x() - b, -low.x() - a, !laps)
                                 : vertical.lanes(line, low.y() + a, low.y() + b, !laps));
  }
  return strips_of(cover.runs, lanes, p.group);
}

/// All lanes on one grid's axes, so that what one set leaves uncovered is known for the next.
Path plan_needed(Params p, Path whole, const Problem& problem, Context& context) {
  if (p.align == LaneDirection::best) {
    p.angle = best_lane_direction(problem.configuration_space(), problem.robot().tool_width);
    p.align = LaneDirection::given;
  }
  const auto strips = [&](const Region& region) { return strips_in(region, p, problem, context); };
  return drive_needed_outline(problem, p.coverage, std::move(whole), strips, StripOrder::improved, context);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  const auto strips_deeper_than = [&](double depth) {
    return strips_in(lane_region(problem, depth, w / 50), p, problem, context);
  };
  if (p.headland > 0) return drive_with_headland(problem, p, strips_deeper_than, StripOrder::improved, context);
  if (p.outline == OutlineExtent::needed)
    return plan_needed(p, plan(with_whole_outline(p), problem, context), problem, context);
  const bool whole = p.outline == OutlineExtent::whole;
  const Region region = whole ? lane_region(problem, w / 2, w / 50) : problem.configuration_space();
  return drive_strips_and_walls(problem, strips_in(region, p, problem, context), StripOrder::improved, whole, context);
}

}  // namespace

PlannerInfo oarp() {
  return describe<Params, plan>(
      {.name = "oarp",
       .family = "polygon",
       .title = "fewest lanes along two directions",
       .citation = "Ramesh et al. 2022",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (unless outline = false, or coverage is below 1; along traced walls but "
                    "for 0.0005 of it)",
       .promise = Promise::target,
       .parameters = with_headland<Params>(with_outline_choice<Params>(
           {{"align", &Params::align, Choices{"best", "given"},
             "direction of the grid: the cheapest for parallel lanes, or `angle`"},
            {"angle", &Params::angle, Range{-360, 360}, "degrees; direction of the grid if align is given"},
            {"compact", &Params::compact, "of equally few lanes those with fewest neighbours at right angles"},
            {"group", &Params::group, "lanes side by side follow each other; off: each on its own in the tour"},
            {"shifts", &Params::shifts, Range{1, 16}, "origins of the grid tried along each axis"}},
           ", as in the paper")),
       .published = {{"outline", std::string("false")}, {"compact", false}, {"group", false}},
       .promises_with = [](const Params& p) { return p.works_walls(p.covers_walls()); }});
}

}  // namespace oxturn
