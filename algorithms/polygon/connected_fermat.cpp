// Laps connected to double spirals that lead in and out again, and these to one continuous path.
//
// Source      Zhao, Gu, Huang, Garcia, Chen, Tu, Benes, Zhang, Cohen-Or, Chen, "Connected Fermat spirals for layered
//             fabrication", ACM Transactions on Graphics 35(4), 2016
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target with `repair` (lanes/repair.hpp; along traced walls but for 0.0005 of it)
// Complexity  O(m log m) for laps with m vertices and tool widths in all, plus for each spiral its place on the lap
//             that it is spliced into
// Decisions   1. Laps, their shared parts and the tree: lanes/ring_graph.hpp. tree = shortest (paper) connects laps by
//                the shortest shared parts, longest by the longest.
//             2. A lap with two or more children in the tree is a path of its own, once around but for a gap; laps with
//                one child and the last one form a spiral. The seam of a spiral is that of 24 positions beside the
//                parent from which most laps can be linked: the gap of each lap is a tool width long, beside that of
//                the lap before. Ring i ends at a(i) before its gap and begins at b(i) after it. Odd laps lead
//                inwards, even ones outwards:
//
//                   b1 --lap 1-- a1 -> b3 --lap 3-- a3 -> ...  a(m) -> a(m-1) --lap m-1-- b(m-1) -> a(m-3) ... b2 ->
//
//                and from b2 to the middle of the gap of lap 1. The links are parallel diagonals.
//             3. Where the links would cross a lap or a wall, a spiral ends and another one begins.
//             4. Spirals are spliced into the path of their parent, parents first, where both ends lie beside one piece
//                of it; if there is none, into another neighbour. Laps left are closed detours.
//             5. The paper's last step, smoothing, is not done.
#include <algorithm>
#include <utility>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/lanes/ring_graph.hpp"
#include "algorithms/polygon/strand.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kSeams = 24;  // positions tried for the seam of a spiral
constexpr double kLongestCut = 3;   // tool widths of the parent's lap that a splice may take out
constexpr double kShortestGap = 3;  // a gap is at most one such part of its lap

struct Params {
  LinkLaps tree = LinkLaps::shortest_shared;
  double spacing = 0;
  bool repair = true;
};

/// The gap of a lap.
struct Gap {
  std::size_t lap;
  double seam, half;  // along the lap; half the gap's length
  bool forward;       // a lap is driven in the order of its vertices
  Point begin, end;   // of the lap's piece as driven inwards: b and a
};

/// Builds the double spiral of a chain of laps from a seam.
class Spirals {
 public:
  Spirals(const RingGraph& graph, const Connector& connector, double spacing, double width)
      : graph_(graph), connector_(connector), spacing_(spacing), width_(width) {}

  /// The gaps of as many laps of the chain as can be linked.
  std::vector<Gap> gaps(const std::vector<std::size_t>& chain, double seam) const {
    std::vector<Gap> all{gap(chain[0], seam, nullptr)};
    for (std::size_t k = 1; k < chain.size(); ++k) {
      const Point at = graph_.ring(chain[k - 1]).at(all.back().seam);
      const auto next = graph_.nearest(chain[k], at, graph_.reach(chain[k - 1], chain[k]));
      if (!next) break;
      all.push_back(gap(chain[k], next->along, &all.back()));
      if (linked(all)) continue;
      all.pop_back();
      break;
    }
    return all;
  }

  Strand spiral(const std::vector<Gap>& gaps) const {
    Strand strand;
    const std::size_t m = gaps.size();
    const auto drive = [&](const Gap& g, bool inwards) {
      Polyline line = around(g);
      if (!inwards) std::reverse(line.begin(), line.end());
      if (!strand.points.empty()) strand.add(connector_.path(strand.points.back(), line.front()), Strand::kLink);
      strand.add(line, g.lap);
    };
    for (std::size_t k = 0; k < m; k += 2) drive(gaps[k], true);
    for (std::size_t k = m / 2 * 2; k >= 2; k -= 2) drive(gaps[k - 1], false);
    if (m > 1) strand.add({strand.points.back(), graph_.ring(gaps[0].lap).at(gaps[0].seam)}, Strand::kLink);
    return strand;
  }

 private:
  Gap gap(std::size_t lap, double seam, const Gap* outer) const {
    const MeasuredRing& ring = graph_.ring(lap);
    const double half = std::min(width_, ring.length() / kShortestGap) / 2;
    Gap g{lap, seam, half, true, ring.at(seam + half), ring.at(seam - half)};
    if (outer && (g.begin - g.end).dot(outer->begin - outer->end) < 0) {
      g.forward = false;
      std::swap(g.begin, g.end);
    }
    return g;
  }

  Polyline around(const Gap& g) const {
    const MeasuredRing& ring = graph_.ring(g.lap);
    Polyline line = ring.piece(g.seam + g.half, g.seam - g.half + ring.length());
    if (!g.forward) std::reverse(line.begin(), line.end());
    return line;
  }

  /// Are the links of the last gap free, and do they pass the laps in their gaps?
  bool linked(const std::vector<Gap>& all) const {
    const std::size_t n = all.size();
    const auto free = [&](const Point& a, const Point& b) {
      if (!connector_.straight(a, b) || distance(a, b) > 3 * spacing_ + width_) return false;
      for (std::size_t k = n - std::min<std::size_t>(n, 3); k < n; ++k)
        if (graph_.crosses(all[k].lap, a, b, all[k].seam, all[k].half)) return false;
      return true;
    };
    if (n == 2 && !free(all[1].begin, graph_.ring(all[0].lap).at(all[0].seam))) return false;
    if (n > 2 && !free(all[n - 3].end, all[n - 1].begin)) return false;
    return free(all[n - 2].end, all[n - 1].end);
  }

  const RingGraph& graph_;
  const Connector& connector_;
  double spacing_, width_;
};

/// One path over all laps that the tree connects; the others are left.
class FermatPath {
 public:
  FermatPath(const Problem& problem, const RingGraph& graph, LapTree tree, double spacing, const Connector& connector)
      : problem_(problem),
        graph_(graph),
        tree_(std::move(tree)),
        width_(problem.robot().tool_width),
        connector_(connector),
        spirals_(graph, connector, spacing, width_),
        driven_(graph.size(), false) {}

  Polyline drive(const Context& context) {
    const std::size_t root = tree_.order.front();
    const auto near = graph_.nearest(root, problem_.start(), 1e300);
    std::vector<double> seams{near->along};
    for (std::size_t k = 1; k < kSeams; ++k)
      seams.push_back(near->along + static_cast<double>(k) / kSeams * graph_.ring(root).length());
    const std::vector<Gap> gaps = best_first(chain_from(root), seams).front();
    SplicedPath path(spirals_.spiral(gaps), graph_.size());
    mark(gaps);
    for (const std::size_t lap : tree_.order)
      if (!driven_[lap] && driven_[*tree_.parent[lap]] && !context.cancelled()) attach(lap, *tree_.parent[lap], path);
    attach_to_others(path, context);
    return path.points();
  }
  std::vector<std::size_t> left() const {
    std::vector<std::size_t> laps;
    for (std::size_t k = 0; k < driven_.size(); ++k)
      if (!driven_[k]) laps.push_back(k);
    return laps;
  }

 private:
  /// The lap and those after it, while each has one child.
  std::vector<std::size_t> chain_from(std::size_t lap) const {
    std::vector<std::size_t> chain{lap};
    if (tree_.children[lap].size() > 1) return chain;
    while (tree_.children[chain.back()].size() == 1) {
      const std::size_t next = tree_.children[chain.back()][0];
      if (tree_.children[next].size() > 1 || driven_[next]) break;
      chain.push_back(next);
    }
    return chain;
  }

  /// The gaps from every seam, those that link most laps first.
  std::vector<std::vector<Gap>> best_first(const std::vector<std::size_t>& chain,
                                           const std::vector<double>& seams) const {
    std::vector<std::vector<Gap>> all;
    for (const double seam : seams) all.push_back(spirals_.gaps(chain, seam));
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return all;
  }

  /// Laps that could not be spliced into their parent, into other neighbours.
  void attach_to_others(SplicedPath& path, const Context& context) {
    std::vector<std::size_t> open;
    for (std::size_t lap = 0; lap < driven_.size(); ++lap)
      if (driven_[lap]) open.push_back(lap);
    for (std::size_t k = 0; k < open.size() && !context.cancelled(); ++k) {
      const std::size_t parent = open[k];
      for (const std::size_t lap : graph_.neighbours(parent)) {
        if (driven_[lap]) continue;
        for (const Gap& g : attach(lap, parent, path)) open.push_back(g.lap);
      }
    }
  }

  /// Splices the spiral that begins with a lap into another lap. The gaps of its laps; none: it fits nowhere.
  std::vector<Gap> attach(std::size_t lap, std::size_t parent, SplicedPath& path) {
    const double reach = graph_.reach(lap, parent);
    std::vector<double> seams = graph_.beside(lap, parent, reach, width_ / 4);
    if (seams.size() > kSeams) {
      for (std::size_t k = 0; k < kSeams; ++k) seams[k] = seams[k * seams.size() / kSeams];
      seams.resize(kSeams);
    }
    for (std::vector<Gap>& gaps : best_first(chain_from(lap), seams)) {
      const Strand strand = spirals_.spiral(gaps);
      const auto cut = path.cut(parent, strand.points.front(), strand.points.back(), reach, kLongestCut * width_);
      if (!cut || !links_free(*cut, strand)) continue;
      path.splice(*cut, strand);
      mark(gaps);
      return std::move(gaps);
    }
    return {};
  }

  /// The links of a splice cross neither walls nor what is spliced in nor each other.
  bool links_free(const SplicedPath::Cut& cut, const Strand& strand) const {
    Point begin = strand.points.front(), end = strand.points.back();
    if (cut.backwards) std::swap(begin, end);
    const Point &a = cut.first.at, &b = cut.last.at;
    if (!connector_.straight(a, begin) || !connector_.straight(end, b) || crossing(a, begin, end, b)) return false;
    for (std::size_t i = 1; i < strand.points.size(); ++i)
      for (const auto& [from, to] : {std::pair(a, begin), std::pair(end, b)})
        if (crossing(from, to, strand.points[i - 1], strand.points[i])) return false;
    return true;
  }
  static bool crossing(const Point& a, const Point& b, const Point& c, const Point& d) {
    return orientation(a, b, c) * orientation(a, b, d) < 0 && orientation(c, d, a) * orientation(c, d, b) < 0;
  }

  void mark(const std::vector<Gap>& gaps) {
    for (const Gap& g : gaps) driven_[g.lap] = true;
  }

  const Problem& problem_;
  const RingGraph& graph_;
  LapTree tree_;
  double width_;
  const Connector& connector_;
  Spirals spirals_;
  std::vector<bool> driven_;  // by lap
};

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double width = problem.robot().tool_width, spacing = p.spacing > 0 ? p.spacing : width;
  const Laps laps = laps_alone(problem, spacing, context);
  if (laps.all.empty()) return {};  // cancelled
  const RingGraph graph(laps, spacing);
  const Connector connector(problem);
  FermatPath fermat(problem, graph, graph.tree(0, p.tree), spacing, connector);
  const Polyline spiral = fermat.drive(context);
  if (context.wants_traces()) context.trace("spiral", {spiral});
  PathBuilder builder(problem.start());
  builder.drive(connector.path(problem.start(), spiral.front()), false);
  builder.drive(spiral, true);
  std::vector<Ring> left;
  for (const std::size_t lap : fermat.left()) left.push_back(laps.all[lap].ring);
  context.record("closed_laps", static_cast<double>(left.size()));
  Path path = with_rings(problem, left, builder.take(), kLongestLinkOn * width, connector, context);
  path = without_short_segments(std::move(path), problem);
  context.publish(path);
  return p.repair && !context.cancelled() ? repaired(problem, path, connector, context) : path;
}

}  // namespace

PlannerInfo connected_fermat() {
  return describe<Params, plan>(
      {.name = "connected-fermat",
       .family = "polygon",
       .title = "double spirals of laps, connected to one path",
       .citation = "Zhao et al. 2016",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with repair; along traced walls but for 0.0005 of it)",
       .promise = Promise::target,
       .parameters = {{"tree", &Params::tree, Choices{"shortest", "longest"},
                       "which laps are connected: by the shortest shared parts, as in the paper, or the longest"},
                      {"spacing", &Params::spacing, Range{0, 1000}, "metres between laps; 0: the tool width"},
                      {"repair", &Params::repair, "cover what spirals leave uncovered at seams, corners and ridges"}},
       .published = {{"repair", false}},
       .promises_with = [](const Params& p) { return p.repair; }});
}

}  // namespace oxturn
