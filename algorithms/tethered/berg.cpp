// Berg's laps: boundaries of equal tether length, a step apart, cut into pieces at dividers and driven one by one.
//
// Source      Berg, "A Geometric Algorithm for Online Tethered Navigation", LTH 2021, sections 3.1 and 3.3
// Model       polygons with holes, offline, disc footprint, tether from an anchor; tether lengths are those of the thin
//             string in free space, its nodes the obstacles' own corners
// Guarantee   stays in configuration space; nothing about the tether or coverage
// Complexity  n corners, k nodes (at most n), s samples, p pieces, d dividers: O((k n + s) times a test of sight)
//             + O(p d) + about p^2 shortest paths where many pieces wait for their turn
// Known flaws (the thesis's own, kept)
//             1. Laps lie at multiples of the step: walls and corners in between are passed at up to a step more than
//                the radius and stay partly uncovered (4.2).
//             2. Joins are plain shortest paths: the tether is not asked, and may become too long or wind (3.3).
//             3. A corner is looked at once (berg_boundary.hpp, 1). With the whole map known all are seen; online some
//                are missed (5.1).
//             4. Boundaries overlap behind an obstacle that the tether passes on both sides; trim = geodesic mends it.
//             5. Slow in the number of corners (5.1).
// Decisions   1. step: a robot radius, as in the thesis; half a tool width for a robot without one.
//             2. "The entire area on one side of an obstacle before ... the other side" (3.1) and "a breadth first
//                traversal of the area graph" (5.3) go together in `bfs-per-divider`: areas are what lies between
//                dividers; one is finished lap by lap up to the next divider before another is begun, nearer the anchor
//                first. `bfs` goes lap by lap through all areas; `dfs` to the end of a branch before the next branch.
//             3. Of what may come next the nearest, a piece from its nearer end. (The thesis does not say.)
//             4. Samples outside configuration space are dropped as hidden ones are.
//             5. Gates: berg_tree.hpp. A divider in front of which the robot fits nowhere has none.
//             6. The tool is on all the way: the thesis counts whatever the robot passes.
//             7. trim = geodesic (ours) keeps the samples whose shortest tether has the lap's length.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/online/sensing.hpp"
#include "algorithms/coverage_planner.hpp"
#include "algorithms/tethered/berg_tree.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {
namespace {

struct Params {
  std::string order = "bfs-per-divider";
  std::string trim = "none";
  double step = 0;
  double sampling = 0;
};

/// Drives pieces one after the other.
class Drive {
 public:
  Drive(const Problem& problem, const BergBoundary& boundary, const BergTree& tree, double spacing, Context& context)
      : problem_(problem),
        boundary_(boundary),
        tree_(tree),
        spacing_(spacing),
        context_(context),
        connector_(problem),
        builder_(problem.start()) {}

  void laps() {
    std::size_t i = 0;
    const auto& pieces = tree_.pieces();
    while (i < pieces.size()) {
      std::vector<int> waiting;
      const int lap = pieces[i].lap;
      for (; i < pieces.size() && pieces[i].lap == lap; ++i)
        if (!pieces[i].points.empty()) waiting.push_back(static_cast<int>(i));
      while (!waiting.empty() && !context_.cancelled()) {
        const std::size_t next = nearest(waiting, [](int piece) { return piece; });
        piece(waiting[next]);
        waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(next));
      }
      context_.progress(static_cast<double>(i) / static_cast<double>(pieces.size()));
    }
  }

  /// Siblings wait together; the next is the nearest of the last (`depth`) or of the first group that waits.
  void regions(bool depth) {
    std::vector<std::vector<int>> groups{tree_.roots()};
    std::size_t first = 0, driven = 0;
    while (first < groups.size() && !context_.cancelled()) {
      std::vector<int>& group = depth ? groups.back() : groups[first];
      if (group.empty()) {
        if (depth)
          groups.pop_back();
        else
          ++first;
        continue;
      }
      const std::size_t next = nearest(group, [this](int region) { return first_piece(region); });
      const BergTree::Region& region = tree_.regions()[static_cast<std::size_t>(group[next])];
      group.erase(group.begin() + static_cast<std::ptrdiff_t>(next));
      for (const int p : region.pieces)
        if (!points(p).empty()) piece(p);
      groups.push_back(region.children);  // `group` is void from here on
      context_.progress(static_cast<double>(++driven) / static_cast<double>(tree_.regions().size()));
    }
  }

  Path take() { return builder_.take(); }

 private:
  const Polyline& points(int piece) const { return tree_.pieces()[static_cast<std::size_t>(piece)].points; }

  int first_piece(int region) const {
    for (;;) {  // a region may begin with laps that nothing of is kept
      const BergTree::Region& r = tree_.regions()[static_cast<std::size_t>(region)];
      for (const int p : r.pieces)
        if (!points(p).empty()) return p;
      region = r.children.front();  // regions lead to something, or they would not be in the tree
    }
  }

  /// Which of them begins nearest to where the robot is.
  template <class PieceOf>
  std::size_t nearest(const std::vector<int>& waiting, PieceOf piece_of) const {
    if (waiting.size() == 1) return 0;
    struct End {
      double straight;
      std::size_t index;
      const Point* at;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < waiting.size(); ++i)
      for (const Point* p : {&points(piece_of(waiting[i])).front(), &points(piece_of(waiting[i])).back()})
        ends.push_back({distance(builder_.at(), *p), i, p});
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.straight < b.straight; });
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = ends.front().index;
    for (const End& e : ends) {
      if (e.straight >= least) break;
      const double d = connector_.length(builder_.at(), *e.at, least);
      if (d < least) {
        least = d;
        best = e.index;
      }
    }
    return best;
  }

  void go(const Point& to) { builder_.drive(connector_.path(builder_.at(), to), true); }

  void piece(int index) {
    if (last_ >= 0)
      for (const int divider : tree_.between(last_, index))
        if (const auto place = gate(divider)) go(*place);
    last_ = index;
    Polyline line = points(index);
    if (tree_.pieces()[static_cast<std::size_t>(index)].divider < 0) line = opened(line);
    if (line.size() > 1 &&
        connector_.length(builder_.at(), line.back()) < connector_.length(builder_.at(), line.front()))
      std::reverse(line.begin(), line.end());
    for (const Point& p : line) go(p);
  }

  /// A piece that goes all the way round: from the break nearest to the robot, or, unbroken, from the nearest place and
  /// back to it.
  Polyline opened(const Polyline& round) const {
    std::size_t begin = 0;
    double least = std::numeric_limits<double>::infinity();
    bool broken = false;
    const std::size_t n = round.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point& before = round[(i + n - 1) % n];
      const bool at_break = distance(before, round[i]) > 1.5 * spacing_;
      if (broken && !at_break) continue;
      double d = distance(builder_.at(), round[i]);
      if (at_break) d = std::min(d, distance(builder_.at(), before));
      if (d < least || (at_break && !broken)) {
        least = d;
        begin = i;
      }
      broken = broken || at_break;
    }
    Polyline line = round;
    std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(begin), line.end());
    if (!broken && n > 2) line.push_back(line.front());
    return line;
  }

  std::optional<Point> gate(int divider) const {
    const BergDivider& d = boundary_.dividers()[static_cast<std::size_t>(divider)];
    const Point& node = boundary_.nodes()[static_cast<std::size_t>(d.node)].at;
    const double rho = distance(node, d.at);
    const double room = problem_.robot().radius + problem_.robot().tool_width / 500;  // passages as wide count as open
    for (double off = room; off < std::min(rho, 3 * room); off += room / 4) {
      const Point p = lerp(d.at, node, off / rho);
      if (problem_.walls().contains(p)) return p;
    }
    return std::nullopt;
  }

  const Problem& problem_;
  const BergBoundary& boundary_;
  const BergTree& tree_;
  double spacing_;
  Context& context_;
  Connector connector_;
  PathBuilder builder_;
  int last_ = -1;
};

class Berg final : public CoveragePlanner {
 public:
  explicit Berg(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const Robot& robot = problem.robot();
    if (!robot.tether)
      throw Unsupported(
          fmt::format("planner 'berg' drives laps of equal tether length and robot '{}' has no tether; give it one, or "
                      "take a planner without",
                      robot.name));
    const double longest = robot.tether->length;
    const double step = p_.step > 0 ? p_.step : robot.radius > 0 ? robot.radius : robot.tool_width / 2;
    const double spacing = p_.sampling > 0 ? p_.sampling : step / 4;
    const EdgeIndex& space = problem.walls();
    const EdgeIndex& walls = problem.map_edges();
    const BergBoundary boundary(problem.map().free, walls, problem.tether()->closed_gaps(), problem.anchor(), longest,
                                problem.tolerance());
    const bool trim = p_.trim == "geodesic";
    const double slack = 1e-6 * robot.tool_width + 1e-9 * longest;
    const auto keep = [&](const Point& p, double length) {
      return space.contains(p) && (!trim || std::abs(problem.tether()->geodesics().distance(p) - length) <= slack);
    };
    const BergTree tree(boundary, step, longest, spacing, keep, [&] { return context.cancelled(); });
    if (context.wants_traces()) show(boundary, tree, context);
    if (tree.roots().empty()) {
      if (context.cancelled()) return {};
      throw Infeasible(
          fmt::format("planner 'berg': no lap {} m apart passes a place where robot '{}' fits in '{}'; a smaller step "
                      "may find one",
                      step, robot.name, problem.map().name));
    }
    Drive drive(problem, boundary, tree, spacing, context);
    if (p_.order == "bfs")
      drive.laps();
    else
      drive.regions(p_.order == "dfs");
    Path path = drive.take();
    context.publish(path);
    return path;
  }

 private:
  static void show(const BergBoundary& boundary, const BergTree& tree, Context& context) {
    std::vector<Polyline> laps, nodes, dividers, branches;
    for (const BergTree::Piece& piece : tree.pieces()) {
      if (piece.points.size() > 1) laps.push_back(piece.points);
      if (piece.points.empty() || piece.parent < 0) continue;
      const Polyline& from = tree.pieces()[static_cast<std::size_t>(piece.parent)].points;
      if (!from.empty()) branches.push_back({from[from.size() / 2], piece.points[piece.points.size() / 2]});
    }
    for (const BergNode& node : boundary.nodes())
      if (node.parent >= 0) nodes.push_back({boundary.nodes()[static_cast<std::size_t>(node.parent)].at, node.at});
    for (const BergDivider& d : boundary.dividers())
      dividers.push_back({boundary.nodes()[static_cast<std::size_t>(d.node)].at, d.at});
    context.trace("boundaries", std::move(laps));
    context.trace("nodes", std::move(nodes));
    context.trace("dividers", std::move(dividers));
    context.trace("tree", std::move(branches));
  }

  Params p_;
};

}  // namespace

PlannerInfo berg() {
  return with_sensing(describe<Berg, Params>(
      {.name = "berg",
       .family = "tethered",
       .title = "Berg's laps of equal tether length",
       .citation = "Berg, A Geometric Algorithm for Online Tethered Navigation, LTH 2021, sections 3.1, 3.3",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "stays in configuration space; checks neither coverage nor the tether while joining pieces",
       .parameters = {
           {"order",
            &Params::order,
            {"bfs-per-divider", "bfs", "dfs"},
            "area by area between dividers, lap by lap, or to the end of each branch first"},
           {"trim", &Params::trim, {"none", "geodesic"}, "geodesic: without what a shorter tether reaches"},
           {"step", &Params::step, Range{0, 100}, "metres between laps; 0: the robot's radius"},
           {"sampling", &Params::sampling, Range{0, 100}, "metres between samples of a lap; 0: a quarter step"}}}));
}

}  // namespace oxturn
