#include "algorithms/lanes/repair.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/lanes/boundary_arcs.hpp"
#include "algorithms/lanes/corridors.hpp"
#include "algorithms/lanes/inner_space.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/stops.hpp"
#include "base/math.hpp"
#include "geometry/convex_hull.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/spatial_order.hpp"

namespace oxturn {
namespace {

// Of the tool's width, or of its square.
constexpr double kNegligible = 1e-6;          // pieces of less area
constexpr double kSeamChord = 1.0 / 8;        // of a seam's thickness, where seams are looked for
constexpr double kTips = 8;                   // thicknesses of a seam: tips of pieces are kept so far beyond
constexpr double kLane = 0.98;                // distance of lanes at most: they overlap by more than the errors
constexpr std::size_t kShortestCorridor = 2;  // slabs: each lane is a detour of its own
constexpr double kStep = 1.0 / 8;             // between the points of a lane that are looked at
constexpr double kStop = 1.0 / 50;            // length of a stop
constexpr double kOffWall = 1e-4;             // of that: where rounding puts a position outside, a stop begins off it
constexpr double kReach = 0.5 * 0.999;        // from which a stop covers
constexpr double kBeside = 0.5 * 1.01;        // from a wall: about what an arc of it covers
constexpr double kAttached = 4;               // that it takes to attach a detour
constexpr std::size_t kManyLanes = 4;         // from which on arcs beside walls are tried first,
constexpr double kLongLanes = 24;             // or from this length on, with what attaches them
constexpr int kRounds = 4;                    // of lanes and arcs of the boundary, before whole rings

/// The boundary that arcs follow; the arcs that are to be driven, and those whose length is looked at.
struct WallArcs {
  explicit WallArcs(const Region& space) : boundary(space), arcs(boundary), trial(boundary) {}
  EdgeIndex boundary;
  BoundaryArcs arcs, trial;
};

/// What is thicker than a seam of the polygon, with the tips beside it.
Region without_seams(const Polygon& polygon, double seam) {
  const Region thick = erode({{polygon}}, seam / 2, kSeamChord * seam, Bound::outside);
  if (thick.empty()) return thick;
  return intersect({{polygon}}, dilate(thick, kTips * seam, kSeamChord * seam, Bound::outside));
}

/// Without negligible pieces, and without those that consist of seams; seams may also connect pieces that are thicker.
Region without_negligible(const Region& region, const Robot& robot) {
  const double seam = covered_seam(robot), least = kNegligible * math::pow(robot.tool_width, 2);
  Region left;
  for (const Polygon& p : region.polygons) {
    const double size = area(p);
    if (size < least) continue;
    if (2 * size >= seam * perimeter({{p}})) {
      left.polygons.push_back(p);
      continue;
    }
    for (Polygon& part : without_seams(p, seam).polygons)
      if (area(part) >= least) left.polygons.push_back(std::move(part));
  }
  return left;
}

class Repair {
 public:
  Repair(const Problem& problem, Region uncovered)
      : problem_(problem),
        walls_(problem.walls()),
        width_(problem.robot().tool_width),
        seam_(covered_seam(problem.robot())),
        left_(std::move(uncovered)) {}

  /// The detours as rings, of one or two points where the robot comes back the way it went.
  std::vector<Ring> find(const Context& context) {
    std::erase_if(left_.polygons, [this](const Polygon& piece) { return add_covering_stop(piece); });
    for (int round = 0; round < kRounds && !left_.empty() && !context.cancelled(); ++round) {
      const std::size_t before = pieces_.size();
      for (const Polygon& piece : left_.polygons) {
        if (round == 0)
          fill(piece);
        else
          fill_rest(piece, round + 1 < kRounds);
      }
      add_arcs();
      left_ = rest(left_, std::span(pieces_).subspan(before));
      put_neighbours_together(left_);
    }
    if (!left_.empty() && !context.cancelled()) add_whole_rings();
    return std::move(pieces_);
  }

 private:
  /// What detours leave of the region.
  Region rest(const Region& region, std::span<const Ring> detours) const {
    std::vector<Polyline> lines;
    for (const Ring& ring : detours) {
      const std::size_t n = ring.size();
      lines.push_back(ring);
      if (n > 2 && ring[1] == ring[n - 1])  // there and back
        lines.back().resize(n / 2 + 1);
      else if (n > 2)
        lines.back().push_back(ring.front());
    }
    return without_negligible(left_of_pieces(region, lines, width_ / 2, seam_), problem_.robot());
  }
  /// The position of the robot that is nearest to p.
  Point position(const Point& p) const { return walls_.contains(p) ? p : walls_.nearest(p)->point; }

  /// A stop, if the tool covers the whole piece from there.
  bool add_covering_stop(const Polygon& piece) {
    const Point stop = position(bounding_box(piece.outer).centre());
    const bool covers =
        std::ranges::all_of(piece.outer, [&](const Point& p) { return distance(p, stop) <= kReach * width_; });
    if (covers) pieces_.push_back(stop_at(stop));
    return covers;
  }

  /// Lanes; or, where walls are beside the piece and that is shorter, arcs of the boundary, and lanes for what they
  /// leave. A band along walls waits for the next round, when lanes near by have covered some of it, unless lanes are
  /// shorter than its arcs.
  void fill(const Polygon& piece) {
    const std::vector<Ring> lanes = lanes_in(piece);
    const bool along = lies_along_walls(piece);
    if (along && lanes.empty()) return;
    const bool few = lanes.size() < kManyLanes && length_with(lanes) < kLongLanes * width_;
    if (!along && (few || !is_beside_walls(piece))) return append(lanes);
    const std::vector<Ring> arcs = arcs_beside({{piece}});
    const std::vector<Ring> between = along ? std::vector<Ring>{} : lanes_in(rest({{piece}}, arcs));
    if (length_with(arcs) + length_with(between) >
        length_with(lanes) + length_with(arcs_beside(rest({{piece}}, lanes))))
      return append(lanes);
    append(between);
    if (!along) note_walls(piece, wall_arcs().arcs);
  }
  /// Arcs where they reach, or no lane does.
  void fill_rest(const Polygon& piece, bool by_lanes) {
    const std::vector<Ring> lanes = by_lanes && !arcs_reach(piece) ? lanes_in(piece) : std::vector<Ring>{};
    if (lanes.empty()) note_walls(piece, wall_arcs().arcs);
    append(lanes);
  }
  void append(const std::vector<Ring>& more) { pieces_.insert(pieces_.end(), more.begin(), more.end()); }

  std::vector<Ring> lanes_in(const Region& region) const {
    std::vector<Ring> lanes;
    for (const Polygon& piece : region.polygons) std::ranges::move(lanes_in(piece), std::back_inserter(lanes));
    return lanes;
  }
  std::vector<Ring> arcs_beside(const Region& region) {
    for (const Polygon& piece : region.polygons) note_walls(piece, wall_arcs().trial);
    return wall_arcs().trial.take(width_);
  }
  /// Of detours and what attaches them.
  double length_with(std::span<const Ring> detours) const {
    double sum = 0;
    for (const Ring& ring : detours) {
      sum += kAttached * width_;
      for_each_edge(ring, [&](const Point& a, const Point& b) { sum += distance(a, b); });
    }
    return sum;
  }

  /// Is the piece a band along walls, which arcs of the boundary cover but for what a next round does?
  bool lies_along_walls(const Polygon& piece) const {
    return 2 * area(piece) <= kBeside * width_ * perimeter({{piece}}) &&
           all_beside_walls(piece, kBeside * width_, [](const Point&) { return false; });
  }
  /// Does what lanes or arcs have left lie outside of configuration space, or beside its wall?
  bool arcs_reach(const Polygon& piece) const {
    return all_beside_walls(piece, kReach * width_, [this](const Point& p) { return !walls_.contains(p); });
  }
  /// Are all points of the piece's boundary nearer to a wall than `within`, or else what `other` says?
  template <class Other>
  bool all_beside_walls(const Polygon& piece, double within, Other other) const {
    bool all = true;
    for_each_ring(Region{{piece}}, [&](const Ring& ring) {
      double known = 0;  // metres further on which that is certain: the point before is so much nearer
      for_each_sample(ring, [&](const Point& p, double step) {
        if (!all || known > 0) return void(known -= step);
        const auto wall = walls_.nearest(p, within);
        all = wall || other(p);
        known = (wall ? within - wall->distance : 0) - step;
      });
    });
    return all;
  }
  /// Do arcs of the boundary cover some of the piece?
  bool is_beside_walls(const Polygon& piece) const {
    bool any = false;
    for_each_sample(piece, [&](const Point& p) { any = any || walls_.nearest(p, kReach * width_).has_value(); });
    return any;
  }
  /// Points of the piece's boundary.
  template <class F>
  void for_each_sample(const Polygon& piece, F f) const {
    for_each_ring(Region{{piece}},
                  [&](const Ring& ring) { for_each_sample(ring, [&](const Point& p, double) { f(p); }); });
  }
  /// Calls f(point, metres to the next one).
  template <class F>
  void for_each_sample(const Ring& ring, F f) const {
    for_each_edge(ring, [&](const Point& a, const Point& b) {
      const double steps = std::max(1.0, std::ceil(distance(a, b) / (kStep * width_))), step = distance(a, b) / steps;
      for (double k = 0; k < steps; ++k) f(lerp(a, b, k / steps), step);
    });
  }

  /// In the direction across which the piece's hull is narrowest, along its longest diameter, along most of its
  /// boundary, or across that: a strip needs one lane in the first, a ring of strips fewest in the second, and strips
  /// at right angles in one of the others, those that lie across lanes one lane each.
  std::vector<Ring> lanes_in(const Polygon& piece) const {
    const Ring hull = convex_hull(piece.outer);
    std::vector<Ring> best = lanes_along(narrowest_direction(hull), piece);
    if (best.size() < 2) return best;
    const double along = lane_directions({{piece}}).front();
    for (const double degrees : {direction_of(diameter(hull)), along, along + 90}) {
      std::vector<Ring> lanes = lanes_along(degrees, piece);
      if (length_with(lanes) < length_with(best)) best = std::move(lanes);
    }
    return best;
  }
  std::vector<Ring> lanes_along(double degrees, const Polygon& piece) const {
    std::vector<Ring> found;
    const LaneFrame frame(degrees);
    const Region turned = frame.to_frame({{piece}});
    const Box box = bounding_box(turned);
    const Slabs slabs = slabs_over(box.low.x(), box.high.x(), kLane * width_);
    const Projection projection = project(edges_of(turned), slabs);
    const double before_end = reach_along(slabs.width);
    for (const std::vector<std::size_t>& chain : chains(projection.intervals.size(), projection.links)) {
      std::vector<LaneInterval> lanes;
      for (const std::size_t i : chain) lanes.push_back(projection.intervals[i]);
      for (const ChainPart& part : corridors_in(lanes, kLane * width_, kShortestCorridor)) {
        if (part.corridor && add_corridor(frame, slabs, lanes[part.from].slab, part, found)) continue;
        for (std::size_t i = part.from; i < part.from + part.count; ++i) {
          const double x = slabs.centre(lanes[i].slab), middle = (lanes[i].low + lanes[i].high) / 2;
          add_lane(frame.to_world({x, std::min(lanes[i].low + before_end, middle)}),
                   frame.to_world({x, std::max(lanes[i].high - before_end, middle)}), found);
        }
      }
    }
    return found;
  }
  /// One lane along the corridor, unless it leaves configuration space other than at its ends: arcs of the boundary
  /// would have to cover the rest.
  bool add_corridor(const LaneFrame& frame, const Slabs& slabs, std::size_t left, const ChainPart& part,
                    std::vector<Ring>& found) const {
    const auto at = [&](double x) { return frame.to_world({x, part.middle}); };
    const double low = slabs.line(left), high = slabs.line(left + part.count), before_end = reach_along(part.height);
    if (!walls_.contains(at(low + slabs.width), at(high - slabs.width))) return false;
    add_lane(at(std::min(low + before_end, (low + high) / 2)), at(std::max(high - before_end, (low + high) / 2)),
             found);
    return true;
  }
  /// How far before the end of a strip a lane along its middle may end: the tool covers the rest from there.
  double reach_along(double strip) const {
    return std::sqrt(std::max(0.0, math::pow(kReach * width_, 2) - math::pow(strip / 2, 2)));
  }
  static Point diameter(const Ring& hull) {
    Point longest(0, 0);
    for (const Point& a : hull)
      for (const Point& b : hull)
        if ((b - a).squaredNorm() > longest.squaredNorm()) longest = b - a;
    return longest;
  }

  /// The parts of the lane in configuration space.
  void add_lane(const Point& a, const Point& b, std::vector<Ring>& found) const {
    const double steps = std::max(1.0, std::ceil(distance(a, b) / (kStep * width_)));
    Polyline part;
    const auto end_part = [&] {
      if (!part.empty()) found.push_back(part.size() == 1 ? stop_at(part.front()) : Ring{part.front(), part.back()});
      part.clear();
    };
    for (double k = 0; k <= steps; ++k) {
      const Point p = lerp(a, b, k / steps);
      const bool inside = walls_.contains(p);
      if (!part.empty() && !(inside && walls_.contains(part.front(), p))) end_part();
      if (inside) part.push_back(p);
    }
    end_part();
  }

  /// A segment from there to some free point near by, because the tool works along segments only: along the wall, or to
  /// any side. Where rounding puts a position on a wall outside, the segment begins a little off the wall. A single
  /// point if there is no such segment.
  Ring stop_at(const Point& at) const {
    const double far = kStop * width_;
    std::vector<Point> ends;
    if (const auto wall = walls_.nearest(at, far)) {
      const EdgeIndex::Edge& e = walls_.edges()[wall->edge];
      for (const Point& end : {e.a, e.b})
        if (const double size = distance(at, end); size > 0) ends.push_back(lerp(at, end, std::min(1.0, far / size)));
    }
    for (int k = 0; k < 8; ++k) ends.push_back(at + rotated({far, 0}, k * kPi / 4));
    for (const Point& end : ends)
      if (walls_.contains(at, end)) return {at, end};
    for (int k = 0; k < 64; ++k) {
      const Point end = at + rotated({far, 0}, k * kPi / 32), from = lerp(at, end, kOffWall);
      if (walls_.contains(from, end)) return {from, end};
    }
    return {at};
  }

  /// The boundary of configuration space beside the piece, for its arcs.
  void note_walls(const Polygon& piece, BoundaryArcs& arcs) const {
    for_each_sample(piece, [&](const Point& p) { arcs.add(p); });
  }

  void add_arcs() {
    if (!wall_arcs_) return;
    for (Ring& arc : wall_arcs_->arcs.take(width_))
      pieces_.push_back(arc.size() == 1 ? stop_at(arc.front()) : std::move(arc));
  }
  /// Made when first needed.
  WallArcs& wall_arcs() {
    if (!wall_arcs_) wall_arcs_.emplace(coarser_space(problem_));
    return *wall_arcs_;
  }

  void add_whole_rings() {
    const EdgeIndex left(left_);
    for_each_ring(problem_.configuration_space(), [&](const Ring& ring) {
      bool near = false;
      for_each_edge(ring,
                    [&](const Point& a, const Point& b) { near = near || left.nearest(a, b, width_ / 2).has_value(); });
      if (near) pieces_.push_back(ring);
    });
  }

  const Problem& problem_;
  const EdgeIndex& walls_;
  double width_, seam_;
  std::optional<WallArcs> wall_arcs_;
  Region left_;  // of the target, not covered yet
  std::vector<Ring> pieces_;
};

}  // namespace

Path repaired(const Problem& problem, const Path& path, const Connector& connector, Context& context) {
  return repaired(problem, path, uncovered(reachable_target(problem), path, problem.robot()), connector, context);
}

Path repaired(const Problem& problem, const Path& path, Region missed, const Connector& connector, Context& context) {
  const double width = problem.robot().tool_width;
  missed = without_negligible(missed, problem.robot());
  put_neighbours_together(missed);
  Path whole = with_stops(path, problem.start(), missed.polygons, kReach * width, problem.walls());
  const std::vector<Ring> pieces = Repair(problem, std::move(missed)).find(context);
  if (pieces.empty()) return whole;
  if (context.wants_traces()) context.trace("repair", pieces);
  return with_detours(problem, pieces, whole, width, connector, context);
}

}  // namespace oxturn
