// Berg's laps: boundaries of equal tether length, divided into pieces at dividers and driven piece by piece.
//
// Source      Berg, "A Geometric Algorithm for Online Tethered Navigation", LTH 2021, sections 3.1 and 3.3
// Model       polygons with holes, offline, disc footprint, tether from an anchor; tether lengths are those of a thin
//             tether in free space, its nodes the obstacles' own corners
// Guarantee   the tether keeps its length limit (not with joins = shortest); nothing about coverage
// Complexity  n corners, s samples, p pieces: O((n + s) log n) on real maps for the boundaries and their tree, then a
//             shortest path from piece to piece. With trim = none boundaries overlap behind every obstacle, and s grows
//             faster than the area. With order = bfs-per-divider (as in Berg 2021) the next area may be anywhere at the
//             same distance from the anchor: among scattered obstacles the path grows as the area times its diameter,
//             n^1.5, and the time with it. order = dfs stays in the neighbourhood.
// Known flaws (of Berg 2021, kept)
//             1. Laps lie at multiples of the step: walls and corners in between are passed at up to a step more than
//                the radius and stay partly uncovered (4.2).
//             2. Connections ignore the tether, which may become too long or wind (3.3): joins = shortest. Such a path
//                is invalid, and its row says where. Decision 8 mends the length; berg-complete never winds.
//             3. A corner is looked at once (berg_boundary.hpp, 1). With a known map all are seen; online some are
//                missed (5.1).
//             4. Boundaries overlap behind an obstacle that the tether passes on both sides: trim = none. Among
//                scattered obstacles the path then is many times as long as with trim = geodesic.
//             5. Slow in the number of corners (5.1).
//             6. All pieces of all laps are driven, whatever the tool has covered from others. With a tool much wider
//                than the obstacles and the space between them there are few laps, but each obstacle divides them: on
//                clutter:9 with a tool of 20 robot radii the path is 8.9 times as long as the bound by area (that of
//                berg-complete 7.3 times, of leashed 7.4).
// Decisions   1. step: a robot radius, as in Berg 2021 (step_by = robot), but at least half and at most all of the
//                tool's width. By the radius a tool three times as wide as the robot makes 2.6 times as long a path.
//             2. "The entire area on one side of an obstacle before ... the other side" (3.1) and "a breadth first
//                traversal of the area graph" (5.3) are combined in `bfs-per-divider`: areas are what lies between
//                dividers; one is finished lap by lap up to the next divider before another is begun, nearer the anchor
//                first. `bfs` goes lap by lap through all areas; `dfs`, the default, to the end of a branch before the
//                next branch: paths of maps with 10^4 cells are a quarter shorter, and the same is driven.
//             3. Of the pieces that may come next the nearest, begun at its nearer end. (Berg 2021 does not say.)
//             4. Samples outside configuration space are dropped as hidden ones are.
//             5. Gates: berg_tree.hpp. A divider in front of which the robot fits nowhere has none.
//             6. The tool is always on: Berg 2021 counts all that the robot passes.
//             7. trim = geodesic (ours, the default) keeps the samples whose shortest tether has the lap's length.
//             8. joins = tethered (ours, the default): from point to point by the shortest path that keeps the tether
//                length limit. It is the same as with joins = shortest as long as that keeps it.
//             9. By default samples are left out between which the boundary is within w / 200 of a free segment, as
//                far as its node sees all of that: half of the points make the same laps. Not with a sampling of one's
//                own.
//            10. With trim = geodesic the robot keeps off obstacles as with other planners (coarser_space): by up to
//                a hundredth of its radius more round their corners.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grown_path.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lattice/grid_graph.hpp"
#include "algorithms/online/survey_then_plan.hpp"
#include "algorithms/tethered/berg_tree.hpp"
#include "algorithms/transit/connector.hpp"
#include "algorithms/transit/tethered_drive.hpp"

namespace oxturn {
namespace {

constexpr double kBreak = 1.5;          // spacings: samples farther apart are separated by a wall
constexpr double kStepsPerSpacing = 4;  // samples per step of tether, by default
constexpr double kGateRange = 3;        // radii in front of a divider within which its gate is sought
constexpr double kGateSteps = 4;        // tries per radius
constexpr double kTrimSlack = 5;        // tolerances: an anchor in a gap or on a wall is moved off either by two
constexpr double kThinnings = 200;      // tool widths over the error of laps (decision 9)
constexpr double kOpen = 500;           // tool widths over the clearance of the narrowest open passage (problem.hpp)

enum class Order { bfs_per_divider, bfs, dfs };
enum class Trim { none, geodesic };
enum class Joins { tethered, shortest };
enum class StepBy { tool, robot };

struct Params {
  Order order = Order::dfs;
  Trim trim = Trim::geodesic;
  Joins joins = Joins::tethered;
  StepBy step_by = StepBy::tool;
  double step = 0;
  double sampling = 0;
};

using Indices = std::vector<std::size_t>;

/// The path so far, and how the robot gets to the next point.
class BergDrive {
 public:
  BergDrive(const Problem& problem, Joins joins) : connector_(problem), shortest_(problem.start()) {
    if (joins == Joins::shortest) return;
    space_.emplace(problem, "berg");
    tethered_.emplace(*space_, TetheredDrive::Settings{});
  }

  const Point& at() const { return tethered_ ? tethered_->at() : shortest_.at(); }
  const Path& path() const { return tethered_ ? tethered_->path() : shortest_.path(); }
  Path take() { return tethered_ ? tethered_->take() : shortest_.take(); }
  std::size_t missed() const { return missed_; }  // points that the tether does not let the robot reach

  void go(const Point& to) {
    if (!tethered_)
      shortest_.drive(connector_.path(at(), to), true);
    else if (!tethered_->go(to))
      ++missed_;
  }
  void go_along(const Polyline& points) {
    if (tethered_)
      missed_ += tethered_->go_along(points);
    else
      for (const Point& p : points) go(p);
  }
  /// Of the shortest path; infinity if it is longer than `longest`.
  double length(const Point& to, double longest = std::numeric_limits<double>::infinity()) const {
    return connector_.length(at(), to, longest);
  }

 private:
  Connector connector_;
  PathBuilder shortest_;
  std::optional<TetherSpace> space_;
  std::optional<TetheredDrive> tethered_;
  std::size_t missed_ = 0;
};

/// Drives pieces one after the other.
class PieceDrive {
 public:
  PieceDrive(const Problem& problem, const BergBoundary& boundary, const BergTree& tree, const BergTree::Laps& laps,
             Joins joins, Context& context)
      : problem_(problem),
        boundary_(boundary),
        tree_(tree),
        laps_(laps),
        context_(context),
        drive_(problem, joins),
        grown_(context) {}

  Path run(Order order) {
    order == Order::bfs ? drive_laps() : drive_regions(order);
    context_.record("samples_missed", static_cast<double>(drive_.missed()));
    return drive_.take();
  }

 private:
  const Polyline& points(std::size_t piece) const { return tree_.pieces()[piece].points; }

  /// Lap by lap, always the nearest piece.
  void drive_laps() {
    const auto& pieces = tree_.pieces();
    for (std::size_t i = 0; i < pieces.size();) {
      Indices waiting;
      const std::size_t lap = pieces[i].lap;
      for (; i < pieces.size() && pieces[i].lap == lap; ++i)
        if (!pieces[i].points.empty()) waiting.push_back(i);
      while (!waiting.empty() && !context_.cancelled())
        drive_piece(take_nearest(waiting, [](std::size_t piece) { return piece; }));
      context_.progress(static_cast<double>(i) / static_cast<double>(pieces.size()));
    }
  }

  // Sibling regions wait as a group. The next region is the nearest of one group: depth-first of the last group, else
  // of the first.
  void drive_regions(Order order) {
    std::deque<Indices> groups{tree_.roots()};
    while (!groups.empty() && !context_.cancelled()) {
      Indices& group = order == Order::dfs ? groups.back() : groups.front();
      if (!group.empty())
        groups.push_back(drive_region(take_nearest(group, [this](std::size_t r) { return first_piece(r); })));
      else
        order == Order::dfs ? groups.pop_back() : groups.pop_front();
    }
  }
  /// Returns the region's children.
  const Indices& drive_region(std::size_t index) {
    const BergTree::Region& region = tree_.regions()[index];
    for (const std::size_t p : region.pieces)
      if (!points(p).empty()) drive_piece(p);
    context_.progress(static_cast<double>(++regions_done_) / static_cast<double>(tree_.regions().size()));
    return region.children;
  }

  /// The first piece of a region that has points.
  std::size_t first_piece(std::size_t region) const {
    for (;;) {
      const BergTree::Region& r = tree_.regions()[region];
      for (const std::size_t p : r.pieces)
        if (!points(p).empty()) return p;
      region = r.children.front();  // every region leads to points, or it would not be in the tree
    }
  }

  /// Removes and returns the item whose piece has the end nearest to the robot by path length.
  template <class PieceOf>
  std::size_t take_nearest(Indices& waiting, PieceOf piece_of) const {
    std::vector<std::pair<double, std::pair<std::size_t, const Point*>>> ends;  // of pieces, by index in `waiting`
    for (std::size_t i = 0; i < waiting.size() && waiting.size() > 1; ++i)
      for (const Point* p : {&points(piece_of(waiting[i])).front(), &points(piece_of(waiting[i])).back()})
        ends.push_back({distance(drive_.at(), *p), {i, p}});
    const auto found = nearest_by_path(
        std::move(ends), [this](const auto& end, double longest) { return drive_.length(*end.second, longest); });
    const std::size_t best = found ? found->first : 0;
    const std::size_t item = waiting[best];
    waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(best));
    return item;
  }

  /// Through the gates on the way, then along the piece from its nearer end.
  void drive_piece(std::size_t piece) {
    if (last_piece_)
      for (const std::size_t divider : tree_.between(*last_piece_, piece))
        if (const auto p = gate(divider)) drive_.go(*p);
    last_piece_ = piece;
    Polyline line = points(piece);
    if (!tree_.pieces()[piece].divider) line = opened(line);
    if (line.size() > 1 && is_nearer(line.back(), line.front())) std::reverse(line.begin(), line.end());
    drive_.go_along(line);
    grown_.offer(drive_.path());
  }

  /// By path from the robot. The one that is nearer in a straight line is looked at first: it bounds the other search.
  bool is_nearer(const Point& a, const Point& b) const {
    const Point& here = drive_.at();
    if (distance(here, a) > distance(here, b)) {
      const double to_b = drive_.length(b);
      return drive_.length(a, to_b) < to_b;
    }
    const double to_a = drive_.length(a);
    return to_a < drive_.length(b, to_a);
  }

  /// Is a wall between two samples that follow one another?
  bool is_break(const Point& a, const Point& b) const {
    return distance(a, b) > kBreak * laps_.spacing && (laps_.thinning.error <= 0 || !laps_.thinning.is_free(a, b));
  }

  /// A piece that goes all the way round, opened at the break nearest to the robot; if there is no break, at the
  /// nearest point, and closed there.
  Polyline opened(const Polyline& round) const {
    std::size_t begin = 0;
    double least = std::numeric_limits<double>::infinity();
    bool broken = false;
    const std::size_t n = round.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point& previous = round[(i + n - 1) % n];
      const bool at_break = is_break(previous, round[i]);
      if (broken && !at_break) continue;
      double d = distance(drive_.at(), round[i]);
      if (at_break) d = std::min(d, distance(drive_.at(), previous));
      // Of points that are equally near but for rounding, as those of the first lap about the robot, the first.
      if (d < least - problem_.tolerance() || (at_break && !broken)) {
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

  /// The point nearest to the divider, towards its node, where the robot fits.
  std::optional<Point> gate(std::size_t divider) const {
    const BergDivider& d = boundary_.dividers()[divider];
    const Point& node = boundary_.nodes()[d.node].at;
    const double rho = distance(node, d.at);
    const double room = problem_.robot().radius + problem_.robot().tool_width / kOpen;
    for (double off = room; off < std::min(rho, kGateRange * room); off += room / kGateSteps) {
      const Point p = lerp(d.at, node, off / rho);
      if (problem_.walls().contains(p)) return p;
    }
    return std::nullopt;
  }

  const Problem& problem_;
  const BergBoundary& boundary_;
  const BergTree& tree_;
  const BergTree::Laps& laps_;
  Context& context_;
  BergDrive drive_;
  GrownPath grown_;
  std::optional<std::size_t> last_piece_;
  std::size_t regions_done_ = 0;
};

BergTree::Laps laps_for(const Params& p, const Problem& problem) {
  const Robot& robot = problem.robot();
  const double size = robot_size(robot), width = robot.tool_width;
  const double by_default = p.step_by == StepBy::robot ? size : std::clamp(size, width / 2, width);
  const double step = p.step > 0 ? p.step : by_default;
  BergTree::Laps laps{step, robot.tether->length, p.sampling > 0 ? p.sampling : step / kStepsPerSpacing};
  if (p.trim == Trim::geodesic)
    laps.trim = {[&](const Point& at) { return problem.tether()->geodesics().distance(at); },
                 kTrimSlack * problem.tolerance() + 1e-9 * laps.longest};
  if (p.sampling == 0)
    laps.thinning = {width / kThinnings,
                     [&walls = problem.walls()](const Point& a, const Point& b) { return walls.contains(a, b); }};
  return laps;
}

BergTree tree_of(const BergBoundary& boundary, const BergTree::Laps& laps, const Problem& problem, Context& context) {
  const auto keep = [&walls = problem.walls()](const Point& p) { return walls.contains(p); };
  return BergTree(boundary, laps, keep, [&] { return context.cancelled(); });
}

/// The anchor; where it lies on a closed gap, moved off that by two tolerances, to the side on which its tether is.
Point beside_closed_gaps(const Problem& problem) {
  const Point& anchor = problem.anchor();
  const auto at_anchor = [&](const Point& p) { return distance(p, anchor) <= problem.tolerance(); };
  const bool in_gap = std::ranges::any_of(problem.tether()->closed_gaps(),
                                          [&](const Polyline& gap) { return std::ranges::any_of(gap, at_anchor); });
  const Polyline out = problem.tether()->geodesics().path(problem.start());
  if (!in_gap || out.size() < 2 || distance(out[0], out[1]) <= 2 * problem.tolerance()) return anchor;
  return anchor + 2 * problem.tolerance() * (out[1] - out[0]).normalized();
}

void trace(const BergBoundary& boundary, const BergTree& tree, Context& context) {
  std::vector<Polyline> laps, nodes, dividers, branches;
  for (const BergTree::Piece& piece : tree.pieces()) {
    if (piece.points.size() > 1) laps.push_back(piece.points);
    if (piece.points.empty() || !piece.parent) continue;
    const Polyline& from = tree.pieces()[*piece.parent].points;
    if (!from.empty()) branches.push_back({from[from.size() / 2], piece.points[piece.points.size() / 2]});
  }
  for (const BergNode& node : boundary.nodes())
    if (node.parent) nodes.push_back({boundary.nodes()[*node.parent].at, node.at});
  for (const BergDivider& d : boundary.dividers()) dividers.push_back({boundary.nodes()[d.node].at, d.at});
  context.trace("boundaries", std::move(laps));
  context.trace("nodes", std::move(nodes));
  context.trace("dividers", std::move(dividers));
  context.trace("tree", std::move(branches));
}

Path plan(const Params& p, const Problem& whole, Context& context) {
  const Robot& robot = whole.robot();
  if (!robot.tether)
    throw Unsupported(
        fmt::format("planner 'berg' drives laps of equal tether length and robot '{}' has no tether; give it one, or "
                    "take a planner without",
                    robot.name));
  const Problem problem = p.trim == Trim::geodesic ? whole.restricted(coarser_space(whole)) : whole;
  const BergBoundary boundary(problem.map().free, problem.map_edges(), problem.tether()->closed_gaps(),
                              beside_closed_gaps(problem), robot.tether->length, problem.tolerance());
  const BergTree::Laps laps = laps_for(p, problem);
  const BergTree tree = tree_of(boundary, laps, problem, context);
  if (context.wants_traces()) trace(boundary, tree, context);
  if (tree.roots().empty()) {
    if (context.cancelled()) return {};
    throw Infeasible(
        fmt::format("planner 'berg': no lap {} m apart passes a point where robot '{}' fits in '{}'; a smaller step "
                    "may find one",
                    laps.step, robot.name, problem.map().name));
  }
  Path path = PieceDrive(problem, boundary, tree, laps, p.joins, context).run(p.order);
  context.publish(path);
  return path;
}

}  // namespace

PlannerInfo berg() {
  return with_sensing(describe<Params, plan>(
      {.name = "berg",
       .family = "tethered",
       .title = "Berg's laps of equal tether length",
       .citation = "Berg, A Geometric Algorithm for Online Tethered Navigation, LTH 2021, sections 3.1, 3.3",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "within the tether length limit (joins = shortest, as published, does not check that); no coverage",
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters =
           {{"order", &Params::order, Choices{"bfs-per-divider", "bfs", "dfs"},
             "area by area between dividers, lap by lap, or to the end of each branch first"},
            {"trim", &Params::trim, Choices{"none", "geodesic"}, "geodesic: without what a shorter tether reaches"},
            {"joins", &Params::joins, Choices{"tethered", "shortest"},
             "to the next point: within the tether length limit, or by the shortest path, whatever the tether does"},
            {"step_by", &Params::step_by, Choices{"tool", "robot"},
             "tether between laps: the robot's radius, as in the source; tool: at least half the tool's width, at most "
             "all"},
            {"step", &Params::step, Range{0, 100}, "metres of tether between laps; 0: as `step_by` says"},
            {"sampling", &Params::sampling, Range{0, 100},
             "metres between samples of a lap; 0: a quarter step, or more where the lap is nearly straight"}},
       .published = {{"order", std::string("bfs-per-divider")},
                     {"trim", std::string("none")},
                     {"joins", std::string("shortest")},
                     {"step_by", std::string("robot")}}}));
}

}  // namespace oxturn
