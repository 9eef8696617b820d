// Laps parallel to the boundary, a tool width apart, connected to one path.
//
// Source      BeachBot (Vollprecht 2014), section 5.1: inset polygons with holes and three connections of them
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target with `repair` (lanes/repair.hpp; along traced walls but for 0.0003 of it)
// Complexity  O(m log m) for laps with m vertices in all; with `join = tree` as outline.hpp
// Decisions   1. Laps are boundaries of erosions of configuration space, holes included. Each is made from the one
//                before it. Vertices of arcs are left out where a lap moves by less than a hundredth of the tool's
//                width; laps are nearer to each other by as much.
//             2. join = tree (ours) is a spanning tree of the laps by the lengths of their links: each lap is a closed
//                detour of another one, from the point where they are nearest. The others are the source's:
//                nearest        each lap is closed, the next one begins at its vertex nearest to there
//                alternating    each lap ends a tool width before it closes; directions alternate
//                longest-edge   each lap is left open at one edge (of the innermost lap: the longest). Instead, a
//                               diagonal leads to the vertex of the next lap that follows the nearest one
//             3. The source begins with the innermost lap, but does not say what follows where laps split or merge. A
//                lap's parent is the lap before it that is nearest. Laps follow their children; among children the
//                nearest one goes first.
//             4. Links up to two tool widths long are driven with the tool on.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// Tool widths.
constexpr double kChord = 0.005;    // error of the laps' arcs
constexpr double kSimplify = 0.01;  // by which a lap may leave out vertices of its arcs
constexpr double kLongLink = 2;     // links up to this length are work

enum class Join { tree, nearest, alternating, longest_edge };

struct Params {
  Join join = Join::tree;
  double spacing = 0;
  bool repair = true;
};

struct Lap {
  Ring ring;
  std::vector<std::size_t> inner = {};  // laps whose parent this is
};

/// Laps level by level, from the boundary inwards; `outermost` of them have no parent.
struct Laps {
  std::vector<Lap> all;
  std::size_t outermost = 0;
  Region between = {};  // what closed laps leave uncovered
};

/// The laps of one level, to find the nearest.
class Level {
 public:
  Level(const Region& region, std::size_t first) : index_(region) {
    std::size_t number = first;
    for_each_ring(region, [&](const Ring& ring) {
      lap_of_edge_.insert(lap_of_edge_.end(), ring.size(), number);
      ++number;
    });
  }
  std::size_t nearest(const Point& p) const { return lap_of_edge_[index_.nearest(p)->edge]; }

 private:
  EdgeIndex index_;
  std::vector<std::size_t> lap_of_edge_;
};

/// Adds what the tool leaves uncovered on its laps around two levels, one inside the other.
void add_uncovered(Region& between, const Region& outer, const Region& inner, const Robot& robot) {
  const double half = robot.tool_width / 2, seam = covered_seam(robot);
  const Region inside = erode(outer, half, seam, Bound::inside);
  Region uncovered = inner.empty() ? inside : subtract(inside, dilate(inner, half, seam, Bound::outside));
  for (Polygon& p : uncovered.polygons) between.polygons.push_back(std::move(p));
}

Laps laps_of(const Problem& problem, double spacing, const Context& context) {
  const double width = problem.robot().tool_width, chord = kChord * width, simplify = kSimplify * width;
  Laps laps;
  std::optional<Level> outer;
  for (Region level = straightened_space(problem); !level.empty() && !context.cancelled();) {
    const std::size_t first = laps.all.size();
    for_each_ring(level, [&](const Ring& ring) {
      if (outer) laps.all[outer->nearest(ring.front())].inner.push_back(laps.all.size());
      laps.all.push_back({ring});
    });
    if (!outer) laps.outermost = laps.all.size();
    outer.emplace(level, first);
    Region next = simplify_inward(erode(level, spacing - chord - simplify, chord, Bound::inside), simplify);
    add_uncovered(laps.between, level, next, problem.robot());
    level = std::move(next);
  }
  return laps;
}

/// Where a lap is entered, and the points that follow.
struct Entry {
  std::size_t vertex;
  double distance;
};

Entry nearest_vertex(const Ring& ring, const Point& p) {
  Entry best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t v = 0; v < ring.size(); ++v)
    if (const double d = distance(ring[v], p); d < best.distance) best = {v, d};
  return best;
}

/// The source's connections: laps one after the other, each after those inside it.
class LapDrive {
 public:
  LapDrive(const Problem& problem, const Laps& laps, Join join, const Connector& connector)
      : laps_(laps), join_(join), width_(problem.robot().tool_width), connector_(connector), path_(problem.start()) {}

  Path run(const Context& context) {
    std::vector<std::size_t> outermost(laps_.outermost);
    for (std::size_t k = 0; k < outermost.size(); ++k) outermost[k] = k;
    open_.push_back({std::nullopt, std::move(outermost)});
    while (!open_.empty() && !context.cancelled()) {
      Open& top = open_.back();
      if (!top.inner.empty()) {
        const std::size_t next = take_nearest(top.inner);
        open_.push_back({next, laps_.all[next].inner});
        continue;
      }
      if (top.lap) drive(*top.lap);
      open_.pop_back();
    }
    return path_.take();
  }

 private:
  struct Open {
    std::optional<std::size_t> lap;  // driven when all inner ones are; none: the root of the outermost laps
    std::vector<std::size_t> inner;  // not driven yet
  };

  std::size_t take_nearest(std::vector<std::size_t>& laps) const {
    const auto far = [&](std::size_t lap) { return nearest_vertex(laps_.all[lap].ring, path_.at()).distance; };
    const auto nearest = std::ranges::min_element(laps, [&](std::size_t a, std::size_t b) { return far(a) < far(b); });
    const std::size_t lap = *nearest;
    laps.erase(nearest);
    return lap;
  }

  void drive(std::size_t number) {
    const Ring& ring = laps_.all[number].ring;
    const std::size_t n = ring.size(), entry = entry_of(ring);
    const bool reversed = join_ == Join::alternating && reverse_;
    Polyline lap;
    for (std::size_t k = 0; k < n; ++k) lap.push_back(ring[(reversed ? entry + n - k : entry + k) % n]);
    if (join_ != Join::longest_edge) lap.push_back(ring[entry]);
    if (join_ == Join::alternating) shorten(lap, width_);
    const Polyline link = connector_.path(path_.at(), lap.front());
    const bool diagonal = join_ == Join::longest_edge && link.size() == 2 && is_inside(number);
    path_.drive(link, last_ && (diagonal || length(link) <= kLongLink * width_));
    path_.drive(lap, true);
    reverse_ = !reverse_;
    last_ = number;
  }

  /// Was the last lap one of those inside this one?
  bool is_inside(std::size_t lap) const { return last_ && std::ranges::count(laps_.all[lap].inner, *last_) > 0; }

  std::size_t entry_of(const Ring& ring) const {
    const std::size_t n = ring.size();
    if (join_ != Join::longest_edge) return nearest_vertex(ring, path_.at()).vertex;
    if (last_) return (nearest_vertex(ring, path_.at()).vertex + 1) % n;
    std::size_t longest = 0;
    for (std::size_t k = 1; k < n; ++k)
      if (distance(ring[k], ring[(k + 1) % n]) > distance(ring[longest], ring[(longest + 1) % n])) longest = k;
    return (longest + 1) % n;
  }

  /// Cuts `off` metres from the end, but not more than half of the line.
  static void shorten(Polyline& line, double off) {
    off = std::min(off, length(line) / 2);
    while (line.size() > 2 && distance(line.back(), line[line.size() - 2]) <= off) {
      off -= distance(line.back(), line[line.size() - 2]);
      line.pop_back();
    }
    const Point& before = line[line.size() - 2];
    line.back() = lerp(line.back(), before, off / std::max(distance(line.back(), before), off));
  }

  const Laps& laps_;
  Join join_;
  double width_;
  const Connector& connector_;
  PathBuilder path_;
  std::vector<Open> open_;
  bool reverse_ = false;
  std::optional<std::size_t> last_;  // lap driven
};

/// One closed detour of another, from the lap that is nearest to the start.
Path drive_tree(const Problem& problem, const Laps& laps, const Connector& connector, Context& context) {
  std::vector<Ring> rings;
  Point nearest = problem.start();
  double least = std::numeric_limits<double>::infinity();
  for (const Lap& lap : laps.all) {
    rings.push_back(lap.ring);
    for_each_edge(lap.ring, [&](const Point& a, const Point& b) {
      const Point p = nearest_on_segment(problem.start(), a, b);
      if (distance(p, problem.start()) < least) nearest = p, least = distance(p, problem.start());
    });
  }
  PathBuilder arrival(problem.start());
  arrival.drive(connector.path(problem.start(), nearest), false);
  return with_rings(problem, rings, arrival.take(), problem.robot().tool_width, connector, context);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double width = problem.robot().tool_width, spacing = p.spacing > 0 ? p.spacing : width;
  Laps laps = laps_of(problem, spacing, context);
  if (context.wants_traces()) {
    std::vector<Polyline> lines;
    for (const Lap& lap : laps.all) lines.push_back(lap.ring), lines.back().push_back(lap.ring.front());
    context.trace("laps", lines);
  }
  const Connector connector(problem);
  Path path = p.join == Join::tree ? drive_tree(problem, laps, connector, context)
                                   : LapDrive(problem, laps, p.join, connector).run(context);
  path = without_short_segments(std::move(path), problem);
  context.publish(path);
  if (!p.repair || context.cancelled()) return path;
  const bool closed = p.join == Join::tree || p.join == Join::nearest;
  return closed ? repaired(problem, path, std::move(laps.between), connector, context)
                : repaired(problem, path, connector, context);
}

}  // namespace

PlannerInfo contour() {
  return describe<Params, plan>(
      {.name = "contour",
       .family = "polygon",
       .title = "laps parallel to the boundary",
       .citation = "BeachBot (Vollprecht 2014)",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with repair; along traced walls but for 0.0003 of it)",
       .promise = Promise::target,
       .parameters = {{"join", &Params::join, Choices{"tree", "nearest", "alternating", "longest-edge"},
                       "how laps are connected; tree: closed laps, each a detour of another; the others: from the "
                       "innermost outwards, as in the source"},
                      {"spacing", &Params::spacing, Range{0, 1000}, "metres between laps; 0: the tool width"},
                      {"repair", &Params::repair, "cover what laps leave uncovered at corners and in the middle"}},
       .published = {{"join", std::string("nearest")}, {"repair", false}},
       .promises_with = [](const Params& p) { return p.repair; }});
}

}  // namespace oxturn
