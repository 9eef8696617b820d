// Back-and-forth lanes in cells without critical points inside, joined by transit.
//
// Source      Choset and Pignon, "Coverage Path Planning: The Boustrophedon Cellular Decomposition", FSR 1997;
//             Choset, Autonomous Robots 9, 2000
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   with `outline`: covers the whole target (along traced walls but for 0.0003 of it, see
//             straightened_space in outline.hpp). Let C be configuration space, w the tool width, R the points of
//             C at least w/2 from its boundary. Driving the boundary covers all points within w/2 of it, inside and
//             outside C. A point p of R lies in a slab no wider than w with centre line x. The point (x, p.y) is no
//             farther from p than p from the boundary, so it lies in C, on the slab's lane, and covers p (lanes.hpp).
//             Without `outline`, slanted ends of lanes and a seam along the walls stay uncovered, as in the paper.
// Complexity  n vertices, m lanes, k crossings of walls with slab lines: O((n + k) log n) for the lanes (up to 16 times
//             that to find the direction), about O(m log m) steps and path searches for the order
// Decisions   1. Lanes are projections of whole slabs, not samples on a line. The rings of the outline are inserted
//                where the path passes next to them, so no wall needs a second visit.
//             2. cells = slab (default): one set of slabs over the whole map; a cell is a longest run of lanes that
//                follow each other one to one. Where two critical points are nearer than w, the exact cells need an
//                extra lane each; slabs never do. On maps traced from laser scans that is most of the length. A
//                component of R that is no wider than a slab takes one lane of its own.
//             3. cells = exact: the paper's cells (of R with `outline`, of C without), with evenly spaced lanes in
//                each. A lane whose part of the cell lies under lanes placed before is omitted.
//             4. sweep = best counts a turn as 2 w and a break between cells as 4 w.
//             5. Links longer than 3 w between lanes of a cell are transit.
//             6. Planner `trapezoid` is the older decomposition (Latombe 1991), which cuts at every vertex; all else is
//                the same. Cells narrower than w are joined with their neighbours, else round corners would be cells.
#include <algorithm>
#include <numeric>

#include "algorithms/lanes/headland.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "geometry/mesh/partition.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

constexpr double kMostBuckets = 1e7;

enum class Decomposition { slab, exact, trapezoid };

struct Params : Headland {
  LaneDirection sweep = LaneDirection::best;
  double angle = 0;
  bool outline = true;
  Decomposition cells = Decomposition::slab;
  double spacing = 1;
  StripOrder order = StripOrder::improved;
};

struct TrapezoidParams : Params {
  TrapezoidParams() { cells = Decomposition::trapezoid; }
};

/// What strips are made from, in the lanes' frame.
struct Field {
  const LaneFrame& frame;
  const Region region;                       // to be covered by lanes
  const EdgeIndex& space;                    // configuration space
  double spacing, width;                     // of lanes; of the tool
  double margin;                             // how far lane ends keep off walls
  double join() const { return 2 * width; }  // pieces of a lane this near to each other become one
};

using Links = std::vector<std::pair<std::size_t, std::size_t>>;
using Cells = std::vector<BoustrophedonCell>;

Strip to_world(const std::vector<LaneEnds>& lanes, const LaneFrame& frame) {
  Strip strip;
  for (const LaneEnds& l : lanes) strip.lanes.push_back({frame.to_world(l.low), frame.to_world(l.high)});
  return strip;
}

LaneEnds upright(double x, double low, double high) { return {{x, low}, {x, high}}; }

/// Pairs of clipped lanes whose slabs the region connects. Sorted, unique.
Links links_of(const Projection& projection, const ClippedLanes& lanes) {
  Links links;
  for (const auto& [a, b] : projection.links)
    if (lanes.piece_of[a] != ClippedLanes::kNone && lanes.piece_of[b] != ClippedLanes::kNone)
      links.push_back({lanes.piece_of[a], lanes.piece_of[b]});
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

/// One set of slabs over the whole region; strips are the longest one-to-one runs of lanes.
std::vector<Strip> slab_strips(const Field& f) {
  const Box box = bounding_box(f.region);
  const Slabs slabs = slabs_over(box.low.x(), box.high.x(), f.spacing);
  const Projection projection = project(edges_of(f.region), slabs);
  const ClippedLanes lanes = clip_lanes(projection.intervals, slabs, f.space, f.join(), f.margin);
  const Links links = links_of(projection, lanes);
  const std::size_t n = lanes.pieces.size();
  std::vector<std::vector<std::size_t>> right(n), left(n);
  for (const auto& [a, b] : links) {
    right[a].push_back(b);
    left[b].push_back(a);
  }
  const auto has_one_successor = [&](std::size_t a) { return right[a].size() == 1 && left[right[a][0]].size() == 1; };
  std::vector<Strip> strips;
  std::vector<std::size_t> strip_of(n, ClippedLanes::kNone);
  for (std::size_t i = 0; i < n; ++i) {  // by slab, so a run's first lane comes first
    if (strip_of[i] != ClippedLanes::kNone) continue;
    std::vector<LaneEnds> run;
    for (std::size_t k = i;; k = right[k][0]) {
      const LaneInterval& s = lanes.pieces[k];
      run.push_back(upright(slabs.centre(s.slab), s.low, s.high));
      strip_of[k] = strips.size();
      if (!has_one_successor(k)) break;
    }
    strips.push_back(to_world(run, f.frame));
  }
  for (const auto& [a, b] : links) connect(strips, strip_of[a], strip_of[b]);
  return strips;
}

/// Strips with lanes in one direction: one set of slabs for all of `wide`, a slab of its own for each polygon of
/// `narrow`, so that none lies astride two.
std::vector<Strip> strips_along(double direction, const Region& wide, const Region& narrow, double spacing,
                                const Problem& problem) {
  if (wide.empty() && narrow.empty()) return {};
  const LaneFrame frame(direction);
  const EdgeIndex space(frame.to_frame(problem.configuration_space()));
  const auto strips_of = [&](const Region& region) {
    return slab_strips(
        {frame, frame.to_frame(region), space, spacing, problem.robot().tool_width, 2 * problem.tolerance()});
  };
  std::vector<Strip> strips;
  if (!wide.empty()) strips = strips_of(wide);
  for (const Polygon& polygon : narrow.polygons)
    for (Strip& strip : strips_of({{polygon}})) strips.push_back(std::move(strip));  // they have no neighbours
  return strips;
}

/// A part of the region that is no wider than one slab takes one lane, along the others or across them.
std::vector<Strip> slab_strips(const Region& region, double direction, double spacing, const Problem& problem) {
  const LaneFrame frame(direction);
  Region wide, along, across;
  for (const Polygon& polygon : region.polygons) {
    Box box;
    for (const Point& p : polygon.outer) box.add(frame.to_frame(p));
    Region& part = box.size().x() <= spacing ? along : box.size().y() <= spacing ? across : wide;
    part.polygons.push_back(polygon);
  }
  std::vector<Strip> strips = strips_along(direction, wide, along, spacing, problem);
  for (Strip& strip : strips_along(direction + 90, {}, across, spacing, problem)) strips.push_back(std::move(strip));
  return strips;
}

/// y of an x-monotone chain at x.
double height_on(const Polyline& chain, double x) {
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Point& a = chain[i - 1];
    const Point& b = chain[i];
    if (x <= b.x() && b.x() > a.x())
      return a.y() + std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0) * (b.y() - a.y());
  }
  return chain.back().y();
}

/// Least and greatest y of a chain between two x.
std::pair<double, double> range_on(const Polyline& chain, double x0, double x1) {
  const double y0 = height_on(chain, x0), y1 = height_on(chain, x1);
  double low = std::min(y0, y1), high = std::max(y0, y1);
  for (const Point& p : chain)
    if (p.x() >= x0 && p.x() <= x1) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
  return {low, high};
}

/// The vertices of a chain strictly between two points, and the points.
Polyline chain_between(const Polyline& chain, const Point& from, const Point& to) {
  Polyline link{from};
  for (const Point& p : chain)
    if (p.x() > from.x() && p.x() < to.x()) link.push_back(p);
  link.push_back(to);
  return link;
}

/// Lanes placed so far, in buckets by x.
class PlacedLanes {
 public:
  PlacedLanes(const Box& box, double width)
      : width_(width),
        origin_(box.low.x()),
        buckets_(static_cast<std::size_t>(std::min(box.size().x() / width + 1, kMostBuckets))) {}

  void add(const LaneEnds& lane) { buckets_[bucket(lane.low.x())].push_back(lane); }
  /// True if the box from (x0, low) to (x1, high) lies under lanes that each span its whole height.
  bool cover(double x0, double x1, double low, double high) const {
    std::vector<double> across;
    for (std::size_t b = bucket(x0 - width_); b <= bucket(x1 + width_); ++b)
      for (const LaneEnds& lane : buckets_[b])
        if (lane.low.y() <= low && lane.high.y() >= high) across.push_back(lane.low.x());
    std::sort(across.begin(), across.end());
    double reached = x0;
    for (const double x : across)
      if (x - width_ / 2 <= reached) reached = std::max(reached, x + width_ / 2);
    return reached >= x1;
  }

 private:
  std::size_t bucket(double x) const {
    const double k = std::floor((x - origin_) / width_);
    return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(buckets_.size() - 1)));
  }
  double width_, origin_;
  std::vector<std::vector<LaneEnds>> buckets_;
};

double left_of(const BoustrophedonCell& cell) { return cell.lower.front().x(); }
double right_of(const BoustrophedonCell& cell) { return cell.lower.back().x(); }

/// A strip for each exact cell, if the outline is driven as well: the projections of slabs fitted to the cell. The
/// widest cells come first; a lane whose part of the cell lies under lanes of other cells is omitted.
std::vector<Strip> projected_strips(const Field& f, const Cells& cells, Context& context) {
  std::vector<Strip> strips(cells.size());
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto extent = [&](std::size_t c) { return right_of(cells[c]) - left_of(cells[c]); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return extent(a) > extent(b); });
  PlacedLanes placed(bounding_box(f.region), f.width);
  for (const std::size_t c : order) {
    const BoustrophedonCell& cell = cells[c];
    const double x0 = left_of(cell), x1 = right_of(cell);
    const Slabs slabs = slabs_over(x0, x1, f.spacing);
    std::vector<LaneInterval> intervals;
    for (std::size_t k = 0; k < slabs.count; ++k) {
      const double a = std::max(slabs.line(k), x0), b = std::min(slabs.line(k + 1), x1);
      const double low = range_on(cell.lower, a, b).first, high = range_on(cell.upper, a, b).second;
      if (!placed.cover(a, b, low, high)) intervals.push_back({k, low, high});
    }
    std::vector<LaneEnds> lanes;
    for (const LaneInterval& s : clip_lanes(intervals, slabs, f.space, f.join(), f.margin).pieces) {
      lanes.push_back(upright(slabs.centre(s.slab), s.low, s.high));
      placed.add(lanes.back());
    }
    strips[c] = to_world(lanes, f.frame);
    if (context.cancelled()) break;
  }
  return strips;
}

/// How a cell's boundary runs from one lane to the next, at the ends that `end_of` names.
template <class EndOf>
std::vector<Polyline> links_along(const Polyline& chain, const std::vector<LaneEnds>& lanes, const LaneFrame& frame,
                                  EndOf end_of) {
  std::vector<Polyline> links;
  for (std::size_t k = 1; k < lanes.size(); ++k) {
    links.push_back(chain_between(chain, end_of(lanes[k - 1]), end_of(lanes[k])));
    for (Point& p : links.back()) p = frame.to_world(p);
  }
  return links;
}

/// A strip for each exact cell, as in the paper: evenly spaced lanes from the cell's left end to its right end,
/// inclusive, and links that follow the boundary.
std::vector<Strip> spaced_strips(const Field& f, const Cells& cells, Context& context) {
  std::vector<Strip> strips(cells.size());
  for (std::size_t c = 0; c < cells.size() && !context.cancelled(); ++c) {
    const BoustrophedonCell& cell = cells[c];
    const double x0 = left_of(cell), x1 = right_of(cell);
    const Slabs slabs = slabs_over(x0, x1, f.spacing);
    std::vector<LaneEnds> lanes;
    for (std::size_t k = 0; k <= slabs.count; ++k) {
      const double x = k == slabs.count ? x1 : std::max(x0, slabs.line(k));
      const double low = height_on(cell.lower, x), high = std::max(low, height_on(cell.upper, x));
      const double keep = std::min(f.margin, (high - low) / 2);
      lanes.push_back(upright(x, low + keep, high - keep));
    }
    strips[c] = to_world(lanes, f.frame);
    strips[c].low_links = links_along(cell.lower, lanes, f.frame, [](const LaneEnds& l) { return l.low; });
    strips[c].high_links = links_along(cell.upper, lanes, f.frame, [](const LaneEnds& l) { return l.high; });
  }
  return strips;
}

/// The strips that have lanes, with the neighbours that their cells have.
std::vector<Strip> without_empty(std::vector<Strip> of_cell, const Cells& cells) {
  std::vector<std::size_t> index(cells.size(), ClippedLanes::kNone);
  std::vector<Strip> strips;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (!of_cell[c].lanes.empty()) {
      index[c] = strips.size();
      strips.push_back(std::move(of_cell[c]));
    }
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const std::size_t o : cells[c].neighbours)
      if (index[c] != ClippedLanes::kNone && index[o] != ClippedLanes::kNone)
        strips[index[c]].neighbours.push_back(index[o]);
  return strips;
}

void trace_cells(const Cells& cells, const LaneFrame& frame, Context& context) {
  std::vector<Polyline> outlines;
  for (const BoustrophedonCell& cell : cells) {
    Polyline line = cell.lower;
    line.insert(line.end(), cell.upper.rbegin(), cell.upper.rend());
    line.push_back(line.front());
    for (Point& p : line) p = frame.to_world(p);
    outlines.push_back(std::move(line));
  }
  context.trace("cells", std::move(outlines));
}

std::vector<Strip> strips_in(const Region& region, const Params& p, const Problem& problem, Context& context) {
  if (region.empty()) return {};
  const double w = problem.robot().tool_width, spacing = p.spacing * w;
  const double direction = p.sweep == LaneDirection::given ? p.angle : best_lane_direction(region, spacing);
  if (p.cells == Decomposition::slab) return slab_strips(region, direction, spacing, problem);
  const LaneFrame frame(direction);
  const Region rotated = frame.to_frame(region);
  const EdgeIndex space(frame.to_frame(problem.configuration_space()));
  const Field field{frame, rotated, space, spacing, w, 2 * problem.tolerance()};
  // United first: rings that touch may cross by rounding once rotated, which the exact plane sweep rejects.
  const Region clean = unite({rotated});
  const Cells cells = p.cells == Decomposition::trapezoid ? trapezoid_cells(clean, w) : boustrophedon_cells(clean);
  std::vector<Strip> strips =
      p.outline || p.headland > 0 ? projected_strips(field, cells, context) : spaced_strips(field, cells, context);
  if (context.wants_traces()) trace_cells(cells, frame, context);
  return without_empty(std::move(strips), cells);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  const auto strips_deeper_than = [&](double depth) {
    return strips_in(lane_region(problem, depth, w / 50), p, problem, context);
  };
  if (p.headland > 0) return drive_with_headland(problem, p, strips_deeper_than, p.order, context);
  const Region region = p.outline ? lane_region(problem, w / 2, w / 50) : problem.configuration_space();
  return drive_strips_and_walls(problem, strips_in(region, p, problem, context), p.order, p.outline, context);
}

Path plan_trapezoids(const TrapezoidParams& p, const Problem& problem, Context& context) {
  return plan(p, problem, context);
}

/// The parameters of both planners, less `cells`.
template <class P>
std::vector<Parameter<P>> parameters(std::vector<Parameter<P>> own) {
  std::vector<Parameter<P>> all{
      {"sweep", &P::sweep, Choices{"best", "given"}, "lane direction: the cheapest of up to 16, or `angle`"},
      {"angle", &P::angle, Range{-360, 360}, "degrees; direction of the lanes if sweep is given"},
      {"outline", &P::outline, "drive every wall once; off: links follow the walls, as in the paper"}};
  all.insert(all.end(), own.begin(), own.end());
  all.push_back({"spacing", &P::spacing, Range{0.1, 1}, "distance of lanes, in tool widths"});
  all.push_back(
      {"order", &P::order, Choices{"improved", "nearest", "dfs"}, "of cells; dfs: depth-first on their graph"});
  return with_headland<P>(std::move(all));
}

}  // namespace

PlannerInfo boustrophedon() {
  return describe<Params, plan>(
      {.name = "boustrophedon",
       .family = "polygon",
       .title = "Boustrophedon decomposition",
       .citation = "Choset, Pignon 1998",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with outline; along traced walls but for 0.0003 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::quarter_turn, Symmetry::mirror, Symmetry::scale},
       .parameters = parameters<Params>(
           {{"cells", &Params::cells, Choices{"slab", "exact"}, "slab: runs of lanes; exact: cut at critical points"}}),
       // The paper: vertical lanes, cells visited depth-first, boundaries only followed between lanes.
       .published = {{"sweep", std::string("given")},
                     {"angle", 90.0},
                     {"outline", false},
                     {"cells", std::string("exact")},
                     {"order", std::string("dfs")}},
       .promises_with = [](const Params& p) { return p.outline || p.headland > 0; }});
}

PlannerInfo trapezoid() {
  return describe<TrapezoidParams, plan_trapezoids>(
      {.name = "trapezoid",
       .family = "polygon",
       .title = "trapezoidal decomposition",
       .citation = "Latombe 1991; Choset 2001",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with outline; along traced walls but for 0.0003 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::quarter_turn, Symmetry::mirror, Symmetry::scale},
       .parameters = parameters<TrapezoidParams>({}),
       .published =
           {{"sweep", std::string("given")}, {"angle", 90.0}, {"outline", false}, {"order", std::string("dfs")}},
       .promises_with = [](const TrapezoidParams& p) { return p.outline || p.headland > 0; }});
}

}  // namespace oxturn
