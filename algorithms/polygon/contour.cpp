// Laps parallel to the boundary, a tool width apart, connected to one path.
//
// Source      BeachBot (Vollprecht 2014), section 5.1: inset polygons with holes and three connections of them
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target with `repair` (lanes/repair.hpp; along traced walls but for 0.0005 of it)
// Complexity  O(m log m) for laps with m vertices in all; with `join = tree` as outline.hpp
// Decisions   1. Laps are boundaries of erosions, holes included (lanes/laps.hpp).
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
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/lanes/lap_tree.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/transit/short_segments.hpp"

namespace oxturn {
namespace {

enum class Join { tree, nearest, alternating, longest_edge };

struct Params {
  Join join = Join::tree;
  double spacing = 0;
  bool repair = true;
};

/// The source's connections: laps one after the other, each after those inside it.
class LapDrive {
 public:
  LapDrive(const Problem& problem, const Laps& laps, Join join, const Connector& connector)
      : laps_(laps), join_(join), width_(problem.robot().tool_width), connector_(connector), path_(problem.start()) {}

  Path run(const Context& context) {
    std::vector<std::size_t> outermost(laps_.outermost);
    std::iota(outermost.begin(), outermost.end(), std::size_t{0});
    open(std::nullopt, std::move(outermost));
    while (!open_.empty() && !context.cancelled()) {
      Open& top = open_.back();
      if (!top.left.empty()) {
        const std::size_t next = top.inner[top.left.take(path_.at())];
        open(next, laps_.all[next].inner);
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
    std::vector<std::size_t> inner;
    NearestRing left;  // of the inner ones
  };

  void open(std::optional<std::size_t> lap, std::vector<std::size_t> inner) {
    std::vector<const Ring*> rings;
    for (const std::size_t k : inner) rings.push_back(&laps_.all[k].ring);
    open_.push_back({lap, std::move(inner), NearestRing(rings)});
  }

  void drive(std::size_t number) {
    const Ring& ring = laps_.all[number].ring;
    Polyline lap = lap_from(ring, entry_of(ring));
    if (join_ == Join::alternating && reverse_) std::ranges::reverse(lap);
    if (join_ == Join::longest_edge) lap.pop_back();
    if (join_ == Join::alternating) shorten(lap, width_);
    const Polyline link = connector_.path(path_.at(), lap.front());
    const bool diagonal = join_ == Join::longest_edge && link.size() == 2 && is_inside(number);
    path_.drive(link, last_ && (diagonal || length(link) <= kLongestLinkOn * width_));
    path_.drive(lap, true);
    reverse_ = !reverse_;
    last_ = number;
  }

  /// Was the last lap one of those inside this one?
  bool is_inside(std::size_t lap) const { return last_ && std::ranges::count(laps_.all[lap].inner, *last_) > 0; }

  std::size_t entry_of(const Ring& ring) const {
    const std::size_t n = ring.size();
    if (join_ != Join::longest_edge) return nearest_vertex(ring, path_.at());
    if (last_) return (nearest_vertex(ring, path_.at()) + 1) % n;
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

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double width = problem.robot().tool_width, spacing = p.spacing > 0 ? p.spacing : width;
  const bool closed = p.join == Join::tree || p.join == Join::nearest;
  Laps laps = closed && p.repair ? laps_of(problem, spacing, context) : laps_alone(problem, spacing, context);
  if (context.wants_traces()) {
    std::vector<Polyline> lines;
    for (const Lap& lap : laps.all) lines.push_back(lap.ring), lines.back().push_back(lap.ring.front());
    context.trace("laps", lines);
  }
  const Connector connector(problem);
  Path path = p.join == Join::tree ? drive_lap_tree(problem, laps, connector, context)
                                   : LapDrive(problem, laps, p.join, connector).run(context);
  path = without_short_segments(std::move(path), problem);
  context.publish(path);
  if (!p.repair || context.cancelled()) return path;
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
       .guarantee = "covers the whole target (with repair; along traced walls but for 0.0005 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = {{"join", &Params::join, Choices{"tree", "nearest", "alternating", "longest-edge"},
                       "how laps are connected; tree: closed laps, each a detour of another; the others: from the "
                       "innermost outwards, as in the source"},
                      {"spacing", &Params::spacing, Range{0, 1000}, "metres between laps; 0: the tool width"},
                      {"repair", &Params::repair, "cover what laps leave uncovered at corners and in the middle"}},
       .published = {{"join", std::string("nearest")}, {"repair", false}},
       .promises_with = [](const Params& p) { return p.repair; }});
}

}  // namespace oxturn
