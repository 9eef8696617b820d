// Parallel lanes in each part of a partition, parts joined by a tour, then every wall once.
//
// Source      BeachBot (Vollprecht 2014), zig zag filling; Greene 1983 for the optimal convex partition
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target (along traced walls but for 0.0005 of it, see straightened_space in outline.hpp)
//             with `fit` cover, `outline`, `small_parts` merge and `margin` at most w/2. Proof:
//             let C be configuration space, w the tool width, m the margin, R the points of C at least m from its
//             boundary. Driving the walls covers all points within w/2 of them. The region that is partitioned is
//             R' = simplify_inward(E, 0.04 m), where E (lane_region) contains all points of C at least 0.96 m from its
//             boundary. Simplifying removes only points within 0.04 m of the boundary of E: a point between a chain of
//             removed vertices and its chord is, measured across the chord, no farther from the chain than the chain
//             from the chord. Such a point is within m of the boundary of C (or beyond it, where chords make E
//             larger), so driving the walls covers it. Hence R is in R' up to boundary points. The parts make up R',
//             their slab projections make up that of R', and a point p of R in a slab no wider than w with centre x is
//             covered from (x, p.y), which is no farther from p than p from the boundary and so lies in C.
//             fit = literal, small_parts = drop and larger margins leave gaps, as in the source.
// Complexity  O((n + k) log n) for n vertices and k crossings of parts with slab lines, plus the partition (convex:
//             cubic, at most 150 vertices), plus the tour: about O(m log m) steps and path searches for m strips
// Decisions   1. The source draws a line through the start vertex. That line has no two intersections there, and the
//                loop would end. The first line is w/2 inside the part (literal), or slabs are fitted (cover).
//             2. cover: all parts share one set of slabs. Where two parts reach into the same slab, each height
//                belongs to one of them, the larger part first, so a seam between parts costs no second lane.
//             3. The source's start rule (leftmost vertex for lanes steeper than 45 degrees, else bottommost) decides
//                from which side lines are counted (literal). The tour decides where a part is entered.
//             4. sweep = best: the least sum of the parts' widths across the lanes. Trapezoids lie along the
//                lanes: for these, and for one part (none), the direction is chosen first, as in boustrophedon.
//             5. Slivers, which the source drops, are merged into a neighbour (small_parts = merge).
//             6. partition = auto is the source's optimal partition wherever CGAL can compute it. Its seams run in all
//                directions and lanes end at each. The default is trapezoid: on 26 generated maps a path 9 % shorter
//                than auto's, with 45 % fewer turns.
//             7. cover: where a run of lanes is a corridor across them no higher than w, it takes one lane along
//                (lanes/corridors.hpp). That lane lies in C from one side of its slabs to the other, so the foot of p
//                on it does, too, and is no farther from p than w/2.
#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "algorithms/lanes/corridors.hpp"
#include "algorithms/lanes/headland.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/polygon/needed_outline.hpp"
#include "algorithms/polygon/segment_fill.hpp"
#include "algorithms/polygon/skeleton_spiral.hpp"
#include "base/math.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kSimplify = 0.04;     // of the margin: how much the region to fill may shrink, for fewer vertices
constexpr double kChord = 0.1;         // of the tool width: chord error of its round vertices
constexpr double kSpiralChord = 0.02;  // of the tool width: error of round vertices in a part with a spiral
constexpr double kBridge = 1e-3;       // of the tool width: cuts to the holes of such a part
constexpr const char* kOwner = "planner 'zigzag'";

enum class Fit { cover, literal };
enum class SmallParts { merge, drop };
enum class Directions { common, own };

struct Params : Headland, OutlineChoice {
  Partition partition = Partition::trapezoid;
  double margin = 0;
  LaneDirection sweep = LaneDirection::best;
  double angle = 0;
  Fit fit = Fit::cover;
  SmallParts small_parts = SmallParts::merge;
  StripOrder order = StripOrder::improved;
  Directions directions = Directions::common;
  SegmentFill::Kind fill = SegmentFill::Kind::lanes;
  std::string segments;

  bool has_spirals() const { return fill == SegmentFill::Kind::spiral || segments.find("spiral") != std::string::npos; }
  bool by_segment() const {
    return directions == Directions::own || fill == SegmentFill::Kind::spiral || !segments.empty();
  }
};

std::vector<Segment> edges_in(const LaneFrame& frame, const std::vector<Ring>& rings) {
  std::vector<Segment> edges;
  for (const Ring& r : rings) add_ring(edges, r);
  for (Segment& s : edges) s = {frame.to_frame(s.a), frame.to_frame(s.b)};
  return edges;
}

/// What lanes are made from.
struct Field {
  const std::vector<Part>& parts;
  const LaneFrame& frame;
  double angle;            // of the lanes, degrees
  const EdgeIndex& space;  // configuration space, in the frame
  double width;            // of the tool
  double margin;           // how far lane ends keep off walls
  bool whole;              // one part, the whole region with its holes
};

struct NumberedLane {
  long number;  // lanes with consecutive numbers may follow each other
  double x, low, high;
};
using LanesOfParts = std::vector<std::vector<NumberedLane>>;

/// One set of slabs shared by all parts: each height of a slab belongs to the part that claims it first.
class SharedSlabs {
 public:
  SharedSlabs(std::size_t slabs, std::size_t parts, double width) : taken_(slabs), lanes_(parts), width_(width) {}

  /// Gives the part what is still free of the interval.
  void claim(std::size_t part, const LaneInterval& wanted) {
    for (const LaneInterval& free : free_parts(wanted)) add(part, free);
  }
  /// The part's intervals by slab, then bottom to top.
  std::vector<LaneInterval> take(std::size_t part) {
    std::vector<LaneInterval> lanes = std::move(lanes_[part]);
    std::sort(lanes.begin(), lanes.end(), [](const LaneInterval& a, const LaneInterval& b) {
      return std::pair(a.slab, a.low) < std::pair(b.slab, b.low);
    });
    return lanes;
  }

 private:
  struct Taken {
    double low, high;
    std::size_t part, index;  // lanes_[part][index]
  };

  std::vector<LaneInterval> free_parts(const LaneInterval& wanted) const {
    std::vector<LaneInterval> free;
    double from = wanted.low;
    for (const Taken& t : taken_[wanted.slab]) {
      if (t.high < from) continue;
      if (t.low > wanted.high) break;
      if (t.low > from) free.push_back({wanted.slab, from, t.low});
      from = std::max(from, t.high);
      if (from >= wanted.high) return free;
    }
    free.push_back({wanted.slab, from, wanted.high});
    return free;
  }

  void add(std::size_t part, const LaneInterval& free) {
    std::vector<Taken>& taken = taken_[free.slab];
    // A short remainder lengthens the lane that it touches; a longer one only a lane of the same part.
    const auto extends = [&](const Taken& t) {
      return (t.high == free.low || t.low == free.high) && (t.part == part || free.high - free.low < width_ / 2);
    };
    const auto beside = std::find_if(taken.begin(), taken.end(), extends);
    if (beside != taken.end()) {
      LaneInterval& lane = lanes_[beside->part][beside->index];
      lane.low = beside->low = std::min(beside->low, free.low);
      lane.high = beside->high = std::max(beside->high, free.high);
      return;
    }
    const Taken t{free.low, free.high, part, lanes_[part].size()};
    lanes_[part].push_back(free);
    const auto lower = [](const Taken& a, const Taken& b) { return a.low < b.low; };
    taken.insert(std::upper_bound(taken.begin(), taken.end(), t, lower), t);
  }

  std::vector<std::vector<Taken>> taken_;         // by slab; sorted, disjoint
  std::vector<std::vector<LaneInterval>> lanes_;  // by part
  double width_;
};

/// The part's intervals of slabs. Ring by ring: merged parts may overlap by rounding, which the even-odd rule over all
/// edges together would turn inside out. A single part is the whole region, with its holes.
std::vector<LaneInterval> intervals_of(const Field& f, const Part& part, const Slabs& slabs) {
  if (f.whole) return project(edges_in(f.frame, part.rings), slabs).intervals;
  std::vector<LaneInterval> all;
  for (const Ring& r : part.rings) {
    const std::vector<LaneInterval> of_ring = project(edges_in(f.frame, {r}), slabs).intervals;
    all.insert(all.end(), of_ring.begin(), of_ring.end());
  }
  return all;
}

/// Lanes without gaps: each part's intervals of one common set of slabs, larger parts first, every height once.
LanesOfParts covering_lanes(const Field& f) {
  Box all;
  for (const Part& part : f.parts)
    for (const Box box = box_in(f.frame, part); const Point& p : {box.low, box.high}) all.add(p);
  std::vector<std::size_t> order(f.parts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return f.parts[a].area > f.parts[b].area; });
  const Slabs slabs = slabs_over(all.low.x(), all.high.x(), f.width);
  SharedSlabs shared(slabs.count, f.parts.size(), f.width);
  for (const std::size_t p : order)
    for (const LaneInterval& s : intervals_of(f, f.parts[p], slabs)) shared.claim(p, s);
  LanesOfParts lanes(f.parts.size());
  for (std::size_t p = 0; p < f.parts.size(); ++p)
    for (const LaneInterval& s : clip_lanes(shared.take(p), slabs, f.space, 2 * f.width, f.margin).pieces)
      lanes[p].push_back({static_cast<long>(s.slab), slabs.centre(s.slab), s.low, s.high});
  return lanes;
}

/// The source's start vertex of a part: does it lie on the low side of the lanes' frame?
bool starts_low(const Field& f, const Part& part) {
  const bool steep = std::abs(math::sin(f.angle * kPi / 180)) > std::abs(math::cos(f.angle * kPi / 180));
  const Point* first = &part.rings.front().front();
  for (const Ring& r : part.rings)
    for (const Point& p : r)
      if (steep ? before(p, *first) : std::pair(p.y(), p.x()) < std::pair(first->y(), first->x())) first = &p;
  return f.frame.to_frame(*first).x() <= box_in(f.frame, part).centre().x();
}

/// The source's lines in one part: a tool width apart, the first half a width inside, counted from the start vertex.
class SourceLines {
 public:
  SourceLines(const Field& f, const Part& part)
      : box_(box_in(f.frame, part)),
        width_(f.width),
        from_low_(starts_low(f, part)),
        crossings_(static_cast<std::size_t>(std::floor(box_.size().x() / width_ + 0.5))) {
    for (const Segment& s : edges_in(f.frame, part.rings)) cross(s);
    for (std::vector<double>& ys : crossings_) std::sort(ys.begin(), ys.end());
  }
  std::size_t count() const { return crossings_.size(); }
  double x(std::size_t k) const {
    const double inside = (static_cast<double>(k) + 0.5) * width_;
    return from_low_ ? box_.low.x() + inside : box_.high.x() - inside;
  }
  /// Heights at which the part's boundary crosses line k, ascending.
  const std::vector<double>& crossings(std::size_t k) const { return crossings_[k]; }

 private:
  void cross(const Segment& s) {
    const auto [x0, x1] = std::minmax(s.a.x(), s.b.x());
    const double near = from_low_ ? x0 - box_.low.x() : box_.high.x() - x1;
    const double far = from_low_ ? x1 - box_.low.x() : box_.high.x() - x0;
    const auto from = static_cast<std::size_t>(std::max(0.0, std::floor(near / width_ - 0.5)));
    const auto end = static_cast<std::size_t>(std::max(0.0, std::ceil(far / width_ - 0.5) + 1));
    for (std::size_t k = from; k < std::min(end, count()); ++k)
      if (const double at = x(k); x0 <= at && at < x1)
        crossings_[k].push_back(s.a.y() + (at - s.a.x()) / (s.b.x() - s.a.x()) * (s.b.y() - s.a.y()));
  }
  Box box_;
  double width_;
  bool from_low_;
  std::vector<std::vector<double>> crossings_;
};

LanesOfParts literal_lanes(const Field& f) {
  LanesOfParts lanes(f.parts.size());
  for (std::size_t p = 0; p < f.parts.size(); ++p) {
    const SourceLines lines(f, f.parts[p]);
    for (std::size_t k = 0; k < lines.count(); ++k) {
      const std::vector<double>& ys = lines.crossings(k);
      for (std::size_t i = 0; i + 1 < ys.size(); i += 2)
        for (const auto& [low, high] : clip_vertical(f.space, lines.x(k), ys[i], ys[i + 1], f.margin))
          lanes[p].push_back({static_cast<long>(k), lines.x(k), low, high});
    }
  }
  return lanes;
}

using Run = std::vector<NumberedLane>;

/// Runs of lanes with consecutive numbers that overlap in height.
std::vector<Run> runs_of(const std::vector<NumberedLane>& lanes) {
  std::vector<Run> runs;
  std::vector<std::size_t> open, next;  // runs that may go on
  long number = std::numeric_limits<long>::min();
  for (const NumberedLane& lane : lanes) {
    if (lane.number != number) {
      open.swap(next);
      if (lane.number != number + 1) open.clear();
      next.clear();
      number = lane.number;
    }
    const auto fits = [&](std::size_t r) {
      const NumberedLane& last = runs[r].back();
      return last.low <= lane.high && lane.low <= last.high;
    };
    const auto found = std::find_if(open.begin(), open.end(), fits);
    std::size_t run = runs.size();
    if (found != open.end()) {
      run = *found;
      open.erase(found);
    } else {
      runs.emplace_back();
    }
    runs[run].push_back(lane);
    next.push_back(run);
  }
  return runs;
}

void add_across(std::vector<Strip>& strips, std::span<const NumberedLane> lanes, const LaneFrame& frame) {
  if (lanes.empty()) return;
  strips.emplace_back();
  for (const NumberedLane& l : lanes)
    strips.back().lanes.push_back({frame.to_world({l.x, l.low}), frame.to_world({l.x, l.high})});
}

/// One lane along a corridor in place of its lanes, without the first or the last where it would end outside of
/// configuration space. False if more than that would.
bool add_along(std::vector<Strip>& strips, std::span<const NumberedLane> lanes, double y, const Field& f) {
  const double half = (lanes[1].x - lanes[0].x) / 2;
  for (const auto& [first, last] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
    const auto along =
        lanes.subspan(static_cast<std::size_t>(first), lanes.size() - static_cast<std::size_t>(first + last));
    const Point left(along.front().x - half, y), right(along.back().x + half, y);
    if (!f.space.contains(left, right)) continue;
    add_across(strips, lanes.first(static_cast<std::size_t>(first)), f.frame);
    strips.push_back({{{f.frame.to_world(left), f.frame.to_world(right)}}});
    add_across(strips, lanes.last(static_cast<std::size_t>(last)), f.frame);
    return true;
  }
  return false;
}

/// Appends the strips of a run. Where it is a corridor across its lanes no higher than `most`, it takes one lane along.
void add_strips(std::vector<Strip>& strips, const Run& run, double most, const Field& f) {
  std::vector<LaneInterval> chain;
  for (const NumberedLane& lane : run) chain.push_back({0, lane.low, lane.high});
  for (const ChainPart& part : corridors_in(chain, most)) {
    const auto lanes = std::span(run).subspan(part.from, part.count);
    if (!part.corridor || !add_along(strips, lanes, part.middle, f)) add_across(strips, lanes, f.frame);
  }
}

/// The direction of lanes in all parts, degrees, if it does not depend on these: decision 4.
std::optional<double> direction_before_parts(const Region& filled, const Params& p, double width) {
  if (p.sweep == LaneDirection::given) return p.angle;
  if (p.partition == Partition::trapezoid || p.partition == Partition::none) return best_lane_direction(filled, width);
  return std::nullopt;
}

std::vector<Part> without_small_parts(std::vector<Part> parts, SmallParts small, double width) {
  if (parts.size() <= 1) return parts;
  return small == SmallParts::merge ? with_slivers_merged(std::move(parts), width)
                                    : without_slivers(std::move(parts), width);
}

void add_lanes(std::vector<Strip>& strips, const Field& field, const Params& p) {
  const bool cover = p.fit == Fit::cover;
  const double highest_corridor = cover ? field.width - 2 * field.margin : -1;
  for (const std::vector<NumberedLane>& of_part : cover ? covering_lanes(field) : literal_lanes(field)) {
    if (p.partition == Partition::none) {
      for (const NumberedLane& lane : of_part) add_across(strips, {&lane, 1}, field.frame);  // every lane by itself
      continue;
    }
    for (const Run& run : runs_of(of_part)) add_strips(strips, run, highest_corridor, field);
  }
}

/// Parts that are filled one by one.
class Segments {
 public:
  /// All references must outlive it.
  Segments(const Region& filled, const Params& p, const Problem& problem, Context& context)
      : filled_(filled), p_(p), problem_(problem), context_(context), connector_(problem) {}

  std::vector<Strip> strips(const std::vector<Part>& parts, double angle) {
    SegmentOptions options{p_.fill, {}, read_segment_choices(kOwner, p_.segments), problem_.robot().tool_width};
    if (p_.directions == Directions::common) options.degrees = angle;
    const std::vector<SegmentFill> fills = segment_fills(kOwner, parts, options);
    for (std::size_t i = 0; i < parts.size() && !context_.cancelled(); ++i) {
      const bool spiral = fills[i].kind == SegmentFill::Kind::spiral && add_spirals(parts[i]);
      if (!spiral) add_lanes_of(parts[i], fills[i].degrees);
    }
    return std::move(strips_);
  }

 private:
  /// False if the part is narrower than the tool.
  bool add_spirals(const Part& part) {
    const double w = problem_.robot().tool_width;
    const Region region = p_.partition == Partition::none ? filled_ : unite({as_region({part})});
    const Region inner = erode(region, w / 2, kSpiralChord * w, Bound::inside);
    for (Strip& s : spiral_strips(inner, {w, kBridge * w, SpiralGrowth::length}, problem_, connector_, context_))
      strips_.push_back(std::move(s));
    return !inner.empty();
  }

  void add_lanes_of(const Part& part, double degrees) {
    auto found = frames_.find(degrees);
    if (found == frames_.end()) {
      const LaneFrame frame(degrees);
      found =
          frames_.emplace(degrees, std::pair(frame, EdgeIndex(frame.to_frame(problem_.configuration_space())))).first;
    }
    const auto& [frame, space] = found->second;
    const std::vector<Part> alone{part};
    const bool whole = p_.partition == Partition::none;
    add_lanes(strips_, {alone, frame, degrees, space, problem_.robot().tool_width, 2 * problem_.tolerance(), whole},
              p_);
  }

  const Region& filled_;
  const Params& p_;
  const Problem& problem_;
  Context& context_;
  Connector connector_;
  std::map<double, std::pair<LaneFrame, EdgeIndex>> frames_;
  std::vector<Strip> strips_;
};

std::vector<Strip> strips_in(const Region& filled, const Params& p, const Problem& problem, Context& context) {
  if (filled.empty()) return {};
  const double w = problem.robot().tool_width;
  const std::optional<double> known = direction_before_parts(filled, p, w);
  const std::vector<Part> parts =
      without_small_parts(cut_into_parts(filled, p.partition, known.value_or(0)), p.small_parts, w);
  if (context.wants_traces()) context.trace("parts", as_region(parts));
  if (parts.empty()) return {};
  const double angle = known ? *known : least_sum_of_widths(filled, parts);
  if (p.by_segment()) return Segments(filled, p, problem, context).strips(parts, angle);
  const LaneFrame frame(angle);
  const EdgeIndex space(frame.to_frame(problem.configuration_space()));
  std::vector<Strip> strips;
  add_lanes(strips, {parts, frame, angle, space, w, 2 * problem.tolerance(), parts.size() == 1}, p);
  return strips;
}

/// All lanes in one direction, so that what one set leaves uncovered is known for the next.
Path plan_needed(Params p, Path whole, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  if (const auto known = direction_before_parts(problem.configuration_space(), p, w)) {
    p.angle = *known;
    p.sweep = LaneDirection::given;
  }
  const auto strips = [&](const Region& region) {
    return strips_in(simplify_inward(region, kSimplify * w / 2), p, problem, context);
  };
  return drive_needed_outline(problem, p.coverage, std::move(whole), strips, p.order, context);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  const double inset = p.margin > 0 ? p.margin : w / 2;
  // Simplified by a part of the outermost inset, which the boundary's lap covers in any case.
  const auto strips_deeper_than = [&](double depth) {
    const Region filled =
        simplify_inward(lane_region(problem, depth - kSimplify * inset, kChord * w), kSimplify * inset);
    return strips_in(filled, p, problem, context);
  };
  if (p.headland == 0 && p.outline == OutlineExtent::needed)
    return plan_needed(p, plan(with_whole_outline(p), problem, context), problem, context);
  Path path = p.headland > 0 ? drive_with_headland(problem, p, strips_deeper_than, p.order, context)
                             : drive_strips_and_walls(problem, strips_deeper_than(inset), p.order,
                                                      p.outline == OutlineExtent::whole, context);
  if (path.legs.empty() && !context.cancelled())
    throw Infeasible(fmt::format("no lane lies {:.4g} m off the walls{}: lower margin, or set outline to true", inset,
                                 p.small_parts == SmallParts::drop ? " in a part that is not dropped" : ""));
  if (!p.works_walls(p.covers_walls()) || !p.has_spirals() || context.cancelled()) return path;
  return repaired(problem, path, Connector(problem), context);
}

}  // namespace

PlannerInfo zigzag() {
  return describe<Params, plan>(
      {.name = "zigzag",
       .family = "polygon",
       .title = "Zig zag filling",
       .citation = "BeachBot (Vollprecht 2014); Greene 1983",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (fit cover, outline not false, coverage 1, slivers merged, margin up to "
                    "half a tool width; "
                    "along traced walls but for 0.0005 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_headland<Params>(with_outline_choice<Params>(
           {{"partition", &Params::partition, Choices{"auto", "convex", "approximate", "monotone", "trapezoid", "none"},
             "parts; auto: the source, convex up to 150 vertices if CGAL finds one, else approximate; none: every lane "
             "by itself"},
            {"margin", &Params::margin, Range{0, 100}, "metres that lanes keep off walls; 0: half the tool width"},
            {"sweep", &Params::sweep, Choices{"best", "given"}, "lane direction: the cheapest, or `angle`"},
            {"angle", &Params::angle, Range{-360, 360}, "degrees; direction of the lanes if sweep is given"},
            {"fit", &Params::fit, Choices{"cover", "literal"},
             "cover: no gaps; literal: lanes a tool width apart, as in the source"},
            {"small_parts", &Params::small_parts, Choices{"merge", "drop"}, "what becomes of slivers"},
            {"order", &Params::order, Choices{"improved", "nearest"}, "of the parts' runs of lanes"},
            {"directions", &Params::directions, Choices{"common", "own"},
             "of lanes; own: each part along the direction across which it is narrowest"},
            {"fill", &Params::fill, Choices{"lanes", "spiral"}, "of all parts"},
            segments_parameter<Params>(kOwner)})),
       // The source: a direction that the user chooses, gaps where lines a tool width apart leave them.
       .published = {{"partition", std::string("auto")},
                     {"fit", std::string("literal")},
                     {"small_parts", std::string("drop")},
                     {"sweep", std::string("given")}},
       .promises_with = [](const Params& p) {
         return p.works_walls(p.covers_walls()) && p.margin == 0 && p.fit == Fit::cover &&
                p.small_parts == SmallParts::merge;
       }});
}

}  // namespace oxturn
