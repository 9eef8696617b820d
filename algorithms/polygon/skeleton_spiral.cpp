// Spirals through the insets of a straight skeleton.
//
// Source      BeachBot (Vollprecht 2014), Algorithm 1: spirals whose offset grows with each vertex, read off a straight
//             skeleton, with recursion where the inset splits
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target with `repair` (lanes/repair.hpp; along traced walls but for 0.0005 of it). Inside
//             faces of the skeleton laps are at most `spacing` apart; at sharp vertices they are farther
// Complexity  O(n log n) for the skeleton of n vertices of usual maps (straight_skeleton.hpp), O(k log k) for laps with
//             k vertices in all, and for each split (or spacing / 64, in which there may be many) the vertices of the
//             ring that splits
// Decisions   1. The boundary of configuration space is driven as closed rings, by detours (lanes/outline.hpp). The
//                spirals fill the inset a spacing further inside, whose round vertices have few chords: one vertex
//                where an obstacle turns gently, as each vertex of the skeleton costs as much as a metre of path.
//             2. growth = length (ours): at length x of a lap of length l the offset is t + s x / l. growth = vertex
//                (source): after vertex i of n it is t + s i / n; laps then lie unevenly where edges differ in length.
//                With growth = length each vertex keeps its share of the lap while other edges vanish
//                (moving_rings.hpp), and s is less by what laps would be farther apart at the ends of edges: they
//                leave no gaps there.
//             3. A part begins with a closed lap and goes on as a spiral. When it splits or vanishes within the next
//                lap, a closed lap ends the spiral, and the spirals of the new parts begin at the split. With order =
//                recursion they follow at once, the nearest part first (the source drops the recursion's result); with
//                order = tour (ours) all spirals of all parts are driven in the order of a tour, from either end.
//             4. The ridge that the last lap of a part leaves is covered by repair.
//             5. Islands are connected with the boundary by their shortest bridges, cuts w / 1000 wide; each side of a
//                bridge is driven.
//             6. Vertices of the inset are moved by up to 1e-5 of the tool width, each to another side: among like
//                obstacles many events of the skeleton have the same time, and to see that CGAL computes it with
//                rational numbers, in a third of all time.
#include "algorithms/polygon/skeleton_spiral.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/laps.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/lanes/strips.hpp"
#include "algorithms/polygon/moving_rings.hpp"
#include "base/random.hpp"
#include "geometry/coarse_arcs.hpp"
#include "geometry/mesh/shortest_bridges.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/overlay/validity.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// Tool widths.
constexpr double kChord = 0.08;          // error of round vertices, which lie so much nearer to the boundary
constexpr double kSimplify = 0.02;       // by which the inset may be simplified, round vertices and others
constexpr double kBridge = 1e-3;         // width of the cuts along bridges
constexpr double kStirred = 1e-5;        // by which vertices of the inset are moved
constexpr int kBisections = 8;           // to find the time of a split
constexpr double kLeastStep = 1.0 / 64;  // spacings from one split to the next

enum class Order { tour, recursion };  // in the order of their names in skeleton_spiral()

struct Params {
  SpiralGrowth growth = SpiralGrowth::length;
  Order order = Order::tour;
  double spacing = 0;
  bool repair = true;
};

/// A component of the inset that is still to be filled. A closed lap was driven at the offset `closed`.
struct Part {
  MovingRing ring;
  double time = 0, closed = 0;
};

/// The spirals of one polygon, each a strip.
class SkeletonSpirals {
 public:
  /// Begins at the vertex nearest to `from`.
  SkeletonSpirals(const MovingRings& rings, double spacing, SpiralGrowth growth, const Connector& connector,
                  const Point& from)
      : rings_(rings), spacing_(spacing), growth_(growth), connector_(connector), at_(from) {}

  std::vector<Strip> find(const Context& context) {
    for (MovingRing& ring : rings_.begin()) {
      std::vector<Part> open{{turned_to(std::move(ring), 0), 0, 0}};
      drive(rings_.closed(open.back().ring, 0));
      while (!open.empty() && !context.cancelled()) {
        Part part = std::move(open.back());
        open.pop_back();
        push_nearest_last(open, fill(std::move(part), context));
        end_strip();
      }
    }
    return std::move(strips_);
  }

 private:
  /// A ring with the share of a lap that is driven at each of its vertices.
  struct Lap {
    MovingRing ring;
    std::vector<double> share;
  };

  /// Drives a part until it splits or vanishes, and returns what it splits into.
  std::vector<Part> fill(Part part, const Context& context) {
    if (splits_at_once(part)) return parts_of(part.ring, part.time + kLeastStep * spacing_, part.closed);
    Lap lap = measured(turned_to(std::move(part.ring), part.time), part.time);
    double t = part.time, end = std::max(part.closed + growth_of(lap, t), t + kLeastStep * spacing_);
    bool spiralled = false;
    while (!context.cancelled()) {
      std::vector<MovingRing> next = rings_.advance(lap.ring, end);
      if (next.size() != 1) break;
      spiral(lap, t, end - t);
      lap = continued(lap, std::move(next[0]), end);
      t = end;
      end += growth_of(lap, t);
      spiralled = true;
    }
    if (spiralled) drive(rings_.closed(lap.ring, t));
    return children(lap.ring, t, end, spiralled ? t : part.closed);
  }

  /// Does the part split so soon that children() finds it split after the least step, whatever the laps' growth?
  /// Without looking at all of the ring, as there may be thousands of such parts.
  bool splits_at_once(const Part& part) const {
    const double least = part.time + kLeastStep * spacing_, latest = std::max(part.closed + spacing_, least);
    const auto split = rings_.split_until(part.ring, part.time, latest);
    return split && *split + (latest - part.time) / (1 << kBisections) < least;
  }

  std::vector<Part> parts_of(const MovingRing& ring, double time, double closed) const {
    std::vector<Part> parts;
    for (MovingRing& child : rings_.advance(ring, time)) parts.push_back({std::move(child), time, closed});
    return parts;
  }

  /// What a ring has split into soon after it is no longer one.
  std::vector<Part> children(const MovingRing& ring, double time, double end, double closed) const {
    double before = time, after = end;
    for (int k = 0; k < kBisections; ++k) {
      const double middle = (before + after) / 2;
      (rings_.single(ring, time, middle) ? before : after) = middle;
    }
    return parts_of(ring, std::max(after, time + kLeastStep * spacing_), closed);
  }

  /// One lap, the offset of which grows.
  void spiral(const Lap& lap, double time, double growth) {
    Polyline line;
    const std::size_t n = lap.ring.arcs.size();
    for (std::size_t i = 0; i <= n; ++i) {
      const double at = time + growth * (i < n ? lap.share[i] : 1);
      if (const auto p = rings_.later(lap.ring.arcs[i % n], at)) line.push_back(*p);
    }
    drive(line);
  }

  /// Of the offset, during one lap. The next lap's vertices lie elsewhere along their edges, so at the same position it
  /// has another share of its growth than this one. Where that share is larger, laps are farther apart than they grow.
  double growth_of(const Lap& lap, double time) const {
    if (growth_ == SpiralGrowth::vertex) return spacing_;
    const std::size_t n = lap.ring.arcs.size();
    double widest = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double share = (i + 1 < n ? lap.share[i + 1] : 1) - lap.share[i];
      widest = std::max(widest, share * lead(lap.ring.arcs[i], lap.ring.arcs[(i + 1) % n], time));
    }
    return spacing_ / (1 + widest);
  }

  /// By how much of an edge, at most, its next lap is ahead of this one: where it ends earlier or begins earlier.
  double lead(std::size_t from, std::size_t to, double time) const {
    const Point a = rings_.at(from, time), b = rings_.at(to, time);
    const auto later_a = rings_.later(from, time + spacing_), later_b = rings_.later(to, time + spacing_);
    if (a == b) return 0;
    if (!later_a || !later_b || *later_a == *later_b) return 1;  // it vanishes
    const Point along = (b - a).normalized();
    const double ends_earlier = along.dot(b - *later_b) / distance(a, b);
    const double begins_earlier = along.dot(a - *later_a) / distance(*later_a, *later_b);
    return std::clamp(std::max(ends_earlier, begins_earlier), 0.0, 1.0);
  }

  Lap measured(MovingRing ring, double time) const {
    Lap lap{std::move(ring), {}};
    const Polyline line = rings_.closed(lap.ring, time);
    const double whole = length(line), count = static_cast<double>(lap.ring.arcs.size());
    double driven = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      lap.share.push_back(growth_ == SpiralGrowth::vertex ? static_cast<double>(i) / count : driven / whole);
      driven += distance(line[i], line[i + 1]);
    }
    return lap;
  }

  /// The ring begins at the vertex nearest to the robot.
  MovingRing turned_to(MovingRing ring, double time) const {
    std::size_t nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < ring.arcs.size(); ++k)
      if (const double far = distance(rings_.at(ring.arcs[k], time), at_); far < least) least = far, nearest = k;
    std::ranges::rotate(ring.arcs, ring.arcs.begin() + static_cast<std::ptrdiff_t>(nearest));
    return ring;
  }

  /// The next lap begins at the vertex that continues the first one. Each vertex keeps its share, so that laps are as
  /// far apart everywhere; of vertices that have become one the least share counts.
  Lap continued(const Lap& lap, MovingRing ring, double time) const {
    std::map<std::size_t, double> share;
    for (std::size_t i = 0; i < lap.ring.arcs.size(); ++i)
      if (const auto now = rings_.follow(lap.ring.arcs[i], time)) share.try_emplace(*now, lap.share[i]);
    const auto first = rings_.follow(lap.ring.arcs.front(), time);
    const auto found = first ? std::ranges::find(ring.arcs, *first) : ring.arcs.end();
    if (growth_ == SpiralGrowth::vertex || found == ring.arcs.end() || share.size() != ring.arcs.size()) {
      if (found != ring.arcs.end()) std::ranges::rotate(ring.arcs, found);
      return measured(std::move(ring), time);
    }
    std::ranges::rotate(ring.arcs, found);
    Lap next{std::move(ring), {}};
    for (const std::size_t arc : next.ring.arcs) next.share.push_back(share.at(arc));
    return next;
  }

  void push_nearest_last(std::vector<Part>& open, std::vector<Part> parts) const {
    std::vector<std::pair<double, std::size_t>> order;  // metres from the robot, part
    for (const Part& part : parts) {
      double least = std::numeric_limits<double>::infinity();
      for (const std::size_t a : part.ring.arcs) least = std::min(least, distance(rings_.at(a, part.time), at_));
      order.emplace_back(least, order.size());
    }
    std::ranges::stable_sort(order, std::greater<>{}, [](const auto& far) { return far.first; });
    for (const auto& [far, k] : order) open.push_back(std::move(parts[k]));
  }

  void drive(const Polyline& line) {
    for (const Point& p : line) {
      if (line_.empty()) line_.push_back(p);
      const Polyline link = connector_.path(line_.back(), p);
      line_.insert(line_.end(), link.begin() + 1, link.end());
      at_ = p;
    }
  }
  void end_strip() {
    if (line_.size() > 1) strips_.push_back({.lanes = {{line_.front(), line_.back(), line_}}});
    line_.clear();
  }

  const MovingRings& rings_;
  double spacing_;
  SpiralGrowth growth_;
  const Connector& connector_;
  Point at_;
  Polyline line_;  // of the next strip
  std::vector<Strip> strips_;
};

/// Vertices moved by up to `by`, each to another side, the same way in every run, but for those that would leave
/// configuration space. The polygon itself, if edges would cross then.
Polygon stirred(const Polygon& polygon, double by, const EdgeIndex& walls) {
  if (by == 0) return polygon;
  Polygon moved = polygon;
  Rng rng(1);  // not multiples of a number: obstacles of one shape would be moved as a whole
  const auto move = [&](Ring& ring) {
    for (Point& p : ring) {
      const double x = rng.unit() - 0.5, y = rng.unit() - 0.5;
      const Point there = p + by * Point(x, y);
      if (walls.contains(there)) p = there;
    }
  };
  move(moved.outer);
  for (Ring& hole : moved.holes) move(hole);
  return find_flaw({{moved}}) ? polygon : moved;
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width, spacing = p.spacing > 0 ? p.spacing : w;
  const double simplify = kSimplify * w;
  const Region inset =
      with_coarser_arcs(simplify_inward(lane_region(problem, spacing - simplify, kChord * w), simplify), 2 * simplify);
  const Connector connector(problem);
  const std::vector<Strip> strips =
      spiral_strips(inset, {spacing, kBridge * w, p.growth, kStirred * w}, problem, connector, context);
  const StripOrder order = p.order == Order::tour ? StripOrder::improved : StripOrder::given;
  Path path = with_outline(problem, drive_strips(problem, strips, order, connector, context), kLongestLinkOn * w,
                           connector, context);
  context.publish(path);
  return p.repair && !context.cancelled() ? repaired(problem, path, connector, context) : path;
}

}  // namespace

std::vector<Strip> spiral_strips(const Region& region, const SkeletonSpiralOptions& options, const Problem& problem,
                                 const Connector& connector, Context& context) {
  std::vector<Strip> strips;
  std::vector<Polyline> traced;
  for (const Polygon& part : cut_along(region, shortest_bridges(region), options.bridge).polygons) {
    if (context.cancelled()) break;
    const StraightSkeleton skeleton = straight_skeleton(stirred(part, options.stirred, problem.walls()));
    for (const StraightSkeleton::Arc& a : skeleton.arcs)
      if (context.wants_traces()) traced.push_back({skeleton.nodes[a.low].at, skeleton.nodes[a.high].at});
    const MovingRings rings(skeleton);
    const Point from = strips.empty() ? problem.start() : strips.back().lanes[0].high;
    for (Strip& strip : SkeletonSpirals(rings, options.spacing, options.growth, connector, from).find(context))
      strips.push_back(std::move(strip));
  }
  if (context.wants_traces()) context.trace("skeleton", std::move(traced));
  return strips;
}

PlannerInfo skeleton_spiral() {
  return describe<Params, plan>(
      {.name = "skeleton-spiral",
       .family = "polygon",
       .title = "spirals through the insets of a straight skeleton",
       .citation = "BeachBot (Vollprecht 2014)",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with repair; along traced walls but for 0.0005 of it)",
       .promise = Promise::target,
       .parameters = {{"growth", &Params::growth, Choices{"length", "vertex"},
                       "how the offset grows: with the length driven, or with each vertex, as in the source"},
                      {"order", &Params::order, Choices{"tour", "recursion"},
                       "of the spirals: a tour on shortest paths, or from each to its parts, as in the source"},
                      {"spacing", &Params::spacing, Range{0, 1000}, "metres between laps; 0: the tool width"},
                      {"repair", &Params::repair, "cover what laps leave uncovered at sharp vertices and ridges"}},
       .published = {{"growth", std::string("vertex")}, {"order", std::string("recursion")}, {"repair", false}},
       .promises_with = [](const Params& p) { return p.repair; }});
}

}  // namespace oxturn
