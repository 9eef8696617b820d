// Along the boundary of what is left, always where the next round or the next two swaths cover most for their time.
//
// Source      after Oksanen and Visala, "Coverage path planning algorithms for agricultural field machines", Journal of
//             Field Robotics 26(8), 2009, second algorithm: all routes over a short horizon are predicted, and of the
//             best one only the part up to the next turn is driven
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target with `repair` (lanes/repair.hpp; along traced walls but for 0.0005 of it)
// Complexity  O(s m log m) for s stretches between turns in a block and m vertices of the pieces that they cut; both
//             grow as the block's area. Linear in the number of blocks, each of bounded effort, and a shortest path for
//             each stretch.
// Decisions   1. What is left is kept as the positions whose disc is uncovered: at first configuration space, then less
//                all positions nearer than a tool width to what was driven. Its boundary is half a tool width inside
//                what is uncovered, as the source's insets are.
//             2. A stretch is a part of that boundary between turns above 45 degrees, driven in either sense. Its value
//                is that of the better of two routes: the whole round that begins with it, or it and a swath back
//                beside it; area over time, turns and the drive there included. Where fewer than two tool widths are
//                left beside a stretch, the swath back covers what is there. links = path (ours): the drive there is
//                a path if that is far longer than straight; links = straight (source) ignores walls: in rooms half of
//                all metres are links.
//                Values are often equal: two sides of a ring that meet where the robot is begin the same round. The
//                first (source: any) may be a short one, then the next short one beside it, and so on: rooms and
//                corridors get many short lanes. ties = longest (ours) drives long ones: on 12 maps of rooms missions
//                18 % shorter, in spirals 24 % longer.
//             3. Stretches shorter than half a tool width are not driven. Uncovered bands narrower than the tool, where
//                no disc fits, are left to repair.
//             4. Every choice looks at all of what is left, in time that grows as the square of the area. Large regions
//                are therefore halved until area times vertices is bounded, and their connected components driven one
//                by one, the nearest by path next, without what earlier ones have covered (`blocks`): on clutter of
//                42,000 tool squares paths 3 % longer in less than a tenth of the time.
//             5. Not the same on a scaled map: the robot's speed and acceleration do not scale with it.
#include <algorithm>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/polygon/cell_strips.hpp"
#include "algorithms/polygon/distant_holes.hpp"
#include "algorithms/polygon/driven_lines.hpp"
#include "algorithms/polygon/field_piece.hpp"
#include "algorithms/polygon/halves.hpp"
#include "algorithms/transit/mesh_wave.hpp"
#include "algorithms/transit/nearest_component.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 0.01;           // tool widths: error of arcs, and by which what is left is simplified
constexpr double kShortestStretch = 0.5;  // tool widths
constexpr double kWorkLink = 2;           // tool widths: shorter links are driven with the tool on
constexpr double kDetour = 3;             // straight distances, and
constexpr double kDetourMore = 10;        // tool widths: a path that is not longer than both counts as straight
constexpr double kAlmostStraight = 1.5;   // straight distances: a path that a search finds with little effort
constexpr double kCell = 32;              // tool widths: of the grid in which driven lines are found
constexpr std::size_t kEntries = 16;      // about so many vertices of a block, to find the nearest one
constexpr double kMostEffort = 5e5;       // of a block: vertices times area in squares of the tool's width
constexpr std::size_t kFewVertices = 64;  // of a block: its size does not matter, each stretch costs next to nothing

// In the order of their names in field_predictive().
enum class Links { path, straight };
enum class Ties { first, longest };

struct Params {
  Links links = Links::path;
  Ties ties = Ties::first;
  bool repair = true;
  bool blocks = true;
};

class PredictiveDrive {
 public:
  PredictiveDrive(const Problem& problem, const Connector& connector, const Params& p)
      : links_by_path_(p.links == Links::path),
        ties_(p.ties),
        robot_(problem.robot()),
        width_(robot_.tool_width),
        walls_(problem.walls()),
        connector_(connector),
        wave_(problem),
        path_(problem.start()),
        driven_(kCell * width_) {}

  /// Drives what earlier calls left of the region.
  void run(const Region& region, const Context& context) {
    left_.clear();
    add(simplify_inward(region, kChord * width_));
    cut(lines_near(left_));
    while (!context.cancelled()) {
      const Polyline line = best_line();
      if (line.empty()) break;
      drive(line);
      cut({line});
    }
  }
  const Point& at() const { return path_.at(); }
  Path take() { return path_.take(); }

 private:
  void add(Region region) {
    for (Polygon& polygon : region.polygons) left_.emplace_back(std::move(polygon));
  }
  std::vector<Polyline> lines_near(const std::vector<FieldPiece>& pieces) const {
    Box all;
    for (const FieldPiece& piece : pieces) all.add(piece.box());
    all.grow(width_);
    return driven_.near(all);
  }
  /// Takes the positions nearer than a tool width to the lines from what is left.
  void cut(const std::vector<Polyline>& lines) {
    if (lines.empty()) return;
    Box near;
    for (const Polyline& line : lines)
      for (const Point& p : line) near.add(p);
    near.grow(width_);
    const std::vector<Region> swaths = swath_parts(lines, width_ * (1 - 2 * kChord), kChord * width_, Bound::outside);
    std::vector<FieldPiece> before = std::move(left_);
    left_.clear();
    for (FieldPiece& piece : before) {
      if (!piece.box().overlaps(near)) {
        left_.push_back(std::move(piece));
        continue;
      }
      const auto [beside, far] = without_holes_off(near, piece.region().polygons[0]);
      Region rest = without(Region{{beside}}, swaths, near);
      if (!put_back(far, rest)) rest = without(piece.region(), swaths, near);
      add(std::move(rest));
    }
  }

  /// Simplifies near the swaths only, because elsewhere holes may be missing, across which the boundary would move: by
  /// more than the robot's radius where the tool is many times as wide.
  Region without(const Region& piece, const std::vector<Region>& swaths, const Box& near) const {
    Region rest = simplify_inward(subtract(piece, swaths), kChord * width_, near);
    bring_inside(rest, near);
    return rest;
  }

  /// Where a cut ends on a wall, rounding may leave the new vertex outside; the next cut there would start from it, and
  /// so go astray by the sum of all.
  void bring_inside(Region& left, const Box& near) const {
    const auto bring = [&](Ring& ring) {
      for (Point& p : ring)
        if (near.contains(p) && !walls_.contains(p))
          if (const auto wall = walls_.nearest(p)) p = wall->point;
    };
    for (Polygon& polygon : left.polygons) {
      bring(polygon.outer);
      for (Ring& hole : polygon.holes) bring(hole);
    }
  }

  void drive(const Polyline& line) {
    const bool known = near_ && near_->front() == path_.at() && near_->back() == line.front();
    const Polyline link = known ? std::move(*near_) : connector_.path(path_.at(), line.front());
    near_.reset();
    path_.drive(link, begun_ && length(link) <= kWorkLink * width_);
    path_.drive(line, true);
    begun_ = true;
    driven_.add(line);
  }

  /// A stretch in one sense.
  struct Candidate {
    const Stretch* stretch = nullptr;
    bool reversed = false;
    double bound;           // of its value: if the drive there is straight and all beside it is uncovered
    std::size_t number;     // in the order of the pieces and their stretches
    double preference = 0;  // among equal values
    double share_beside = 1;
    bool looked_beside = false;
    bool settled = false;  // the wave has met it, or never will
    const Point& begin() const { return reversed ? stretch->points.back() : stretch->points.front(); }
  };
  static bool later(const Candidate& a, const Candidate& b) {
    if (a.bound != b.bound) return a.bound < b.bound;
    return a.preference != b.preference ? a.preference < b.preference : a.number > b.number;
  }

  /// The stretch of greatest value, in the sense in which it is driven; empty if none is left. Candidates come in the
  /// order of their bounds, and again when these are exact but for walls: few have to be looked at. If a path leads
  /// almost straight to the first of all, that is it.
  Polyline best_line() {
    std::deque<Stretch> rounds;
    std::vector<Candidate>& candidates = find_candidates(rounds);
    std::vector<Candidate> hidden;
    std::ranges::make_heap(candidates, later);
    Candidate best{.bound = 0, .number = 0};
    while (best.stretch == nullptr && !candidates.empty() && candidates.front().bound > 0) {
      std::ranges::pop_heap(candidates, later);
      Candidate& next = candidates.back();
      if (!next.looked_beside) {
        look_beside(next);
        std::ranges::push_heap(candidates, later);
        continue;
      }
      const bool near =
          !links_by_path_ || connector_.straight(path_.at(), next.begin()) || (hidden.empty() && is_near(next.begin()));
      if (near)
        best = next;
      else
        hidden.push_back(next);
      candidates.pop_back();
    }
    if (!hidden.empty()) find_hidden(hidden, best);
    if (best.stretch == nullptr) return {};
    const Polyline& line = best.stretch->points;
    return best.reversed ? Polyline(line.rbegin(), line.rend()) : line;
  }

  /// Looks with a wave among the candidates that are not in straight reach for a better one.
  void find_hidden(std::vector<Candidate>& hidden, Candidate& best) {
    const auto from = wave_.triangle_of(path_.at());
    if (!from) return;
    std::vector<std::pair<std::size_t, std::size_t>> in_triangle;  // and the number in `hidden`
    for (std::size_t k = 0; k < hidden.size(); ++k)
      if (const auto t = wave_.triangle_of(hidden[k].begin()))
        in_triangle.emplace_back(*t, k);
      else
        hidden[k].settled = true;
    std::ranges::sort(in_triangle);
    FarthestOfUse farthest(hidden.size(), [&](std::size_t k) { return farthest_of_use(hidden[k], best.bound); });
    const auto is_settled = [&](std::size_t k) { return hidden[k].settled; };
    wave_.spread(path_.at(), *from, [&](std::size_t t) {
      for (auto k = std::ranges::lower_bound(in_triangle, std::pair(t, std::size_t{0}));
           k != in_triangle.end() && k->first == t; ++k) {
        Candidate& c = hidden[k->second];
        const double straight = distance(path_.at(), c.begin());
        const double wave = wave_.metres(t) + distance(wave_.entered_at(t), c.begin());
        c.bound = value(*c.stretch, wave > farthest_near(straight) ? wave : straight, c.share_beside);
        c.settled = true;
        if (best.stretch == nullptr || later(best, c)) best = c;
      }
      return wave_.metres(t) > farthest.of(is_settled);
    });
  }

  /// The greatest of many numbers that only become less.
  class FarthestOfUse {
   public:
    FarthestOfUse(std::size_t n, std::function<double(std::size_t)> now) : now_(std::move(now)) {
      for (std::size_t k = 0; k < n; ++k) heap_.emplace_back(now_(k), k);
      std::ranges::make_heap(heap_);
    }
    /// Over those that are not settled.
    template <class Settled>
    double of(Settled settled) {
      while (!heap_.empty()) {
        const auto [before, k] = heap_.front();
        const double now = settled(k) ? 0 : now_(k);
        if (now == before && !settled(k)) return now;
        std::ranges::pop_heap(heap_);
        heap_.pop_back();
        if (settled(k)) continue;
        heap_.emplace_back(now, k);
        std::ranges::push_heap(heap_);
      }
      return 0;
    }

   private:
    std::function<double(std::size_t)> now_;
    std::vector<std::pair<double, std::size_t>> heap_;
  };

  /// `rounds` gets those that no piece keeps.
  std::vector<Candidate>& find_candidates(std::deque<Stretch>& rounds) {
    candidates_.clear();
    const auto add = [&](const Stretch& s) {
      if (s.metres < kShortestStretch * width_) return;
      for (const bool reversed : {false, true}) {
        candidates_.push_back({.stretch = &s, .reversed = reversed, .bound = 0, .number = candidates_.size()});
        if (ties_ == Ties::longest) candidates_.back().preference = s.metres;
        candidates_.back().bound = value(s, distance(path_.at(), candidates_.back().begin()), 1);
      }
    };
    for (const FieldPiece& piece : left_) piece.for_each_stretch(path_.at(), rounds, add);
    return candidates_;
  }

  void look_beside(Candidate& c) const {
    c.looked_beside = true;
    c.share_beside = share_beside(c.stretch->points);
    c.bound = value(*c.stretch, distance(path_.at(), c.begin()), c.share_beside);
  }
  /// Of a line a tool width inside a stretch, how much lies in what is left; sampled every tool width.
  double share_beside(const Polyline& line) const {
    int inside = 0, all = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Point d = line[i] - line[i - 1];
      const int samples = std::max(1, static_cast<int>(d.norm() / width_));
      const Point inwards = Point(-d.y(), d.x()).normalized() * width_;
      for (int k = 0; k < samples; ++k, ++all) {
        const Point p = line[i - 1] + d * ((k + 0.5) / samples) + inwards;
        if (std::ranges::any_of(left_, [&](const FieldPiece& piece) { return piece.contains(p); })) ++inside;
      }
    }
    return all > 0 ? static_cast<double>(inside) / all : 0;
  }

  /// Of the better of both routes: the whole round, or the stretch and a swath back, of which a share covers anything.
  double value(const Stretch& s, double metres_there, double back_share) const {
    const double there = metres_there / robot_.speed;
    const double round = s.round_metres / (there + round_seconds(s));
    const double back = s.metres * (1 + back_share) / (there + back_seconds(s));
    return width_ * std::max(round, back);
  }
  /// Does a path that is not much longer than the straight one lead to what is not in straight reach? Keeps it.
  bool is_near(const Point& p) {
    near_ = connector_.path_within(path_.at(), p, kAlmostStraight * distance(path_.at(), p));
    return near_.has_value();
  }
  /// How long the path over midpoints of triangles may be to what is straight near.
  double farthest_near(double straight) const { return kDetour * straight + kDetourMore * width_; }
  /// Metres over midpoints after which a candidate that is not in straight reach cannot be better any more.
  double farthest_of_use(const Candidate& c, double least) const {
    const double straight = distance(path_.at(), c.begin()), longest = longest_link(*c.stretch, least, c.share_beside);
    return longest < straight ? 0 : std::max(longest, farthest_near(straight));
  }
  /// Metres there with which the value is not less than `least`.
  double longest_link(const Stretch& s, double least, double back_share) const {
    if (!(least > 0)) return std::numeric_limits<double>::infinity();
    const double round = width_ * s.round_metres / least - round_seconds(s);
    const double back = width_ * s.metres * (1 + back_share) / least - back_seconds(s);
    return (1 + 1e-9) * robot_.speed * std::max(round, back);
  }
  double round_seconds(const Stretch& s) const {
    return s.round_metres / robot_.speed + s.round_turns / robot_.turn_rate;
  }
  double back_seconds(const Stretch& s) const { return 2 * s.metres / robot_.speed + seconds_to_next_lane(robot_); }

  bool links_by_path_;
  Ties ties_;
  const Robot& robot_;
  double width_;
  const EdgeIndex& walls_;
  const Connector& connector_;
  MeshWave wave_;
  PathBuilder path_;
  bool begun_ = false;
  std::optional<Polyline> near_;  // to the last candidate for which is_near()
  std::vector<FieldPiece> left_;
  std::vector<Candidate> candidates_;  // for the next line
  DrivenLines driven_;
};

/// The connected components of all parts, each a block.
std::vector<Region> blocks_of(const std::vector<Region>& parts) {
  if (parts.size() == 1) return parts;
  std::vector<Region> blocks;
  for (const Region& part : parts)
    for (const Polygon& polygon : part.polygons) blocks.push_back({{polygon}});
  return blocks;
}

/// The nearest by path always next, to some of its vertices.
void drive_blocks(const std::vector<Region>& blocks, const Problem& problem, PredictiveDrive& drive,
                  const Context& context) {
  NearestComponent nearest(problem);
  std::vector<bool> driven(blocks.size(), false);
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const Ring& ring = blocks[k].polygons[0].outer;
    const std::size_t step = std::max<std::size_t>(1, ring.size() / kEntries);
    for (std::size_t i = 0; i < ring.size(); i += step) nearest.add(ring[i], static_cast<int>(k), k);
  }
  const auto run = [&](std::size_t k) {
    driven[k] = true;
    nearest.remove(static_cast<int>(k));
    drive.run(blocks[k], context);
  };
  while (const auto next = nearest.nearest(drive.at())) {
    if (context.cancelled()) return;
    run(*next);
  }
  for (std::size_t k = 0; k < blocks.size(); ++k)  // those without a vertex inside, by rounding
    if (!driven[k] && !context.cancelled()) run(k);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const Connector connector(problem);
  PredictiveDrive drive(problem, connector, p);
  const double w = problem.robot().tool_width;
  const auto small = [&](const Region& block) {
    const std::size_t vertices = vertex_count(block);
    return !p.blocks || vertices <= kFewVertices || static_cast<double>(vertices) * area(block) <= kMostEffort * w * w;
  };
  drive_blocks(blocks_of(halved_until(straightened_space(problem), small)), problem, drive, context);
  Path path = without_short_segments(drive.take(), problem);
  context.publish(path);
  return p.repair && !context.cancelled() ? repaired(problem, path, connector, context) : path;
}

}  // namespace

PlannerInfo field_predictive() {
  return describe<Params, plan>(
      {.name = "field-predictive",
       .family = "polygon",
       .title = "stretches along what is left, by prediction",
       .citation = "Oksanen, Visala 2009",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with repair; along traced walls but for 0.0005 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift},
       .parameters =
           {{"links", &Params::links, Choices{"path", "straight"},
             "how far a stretch is, when the next one is chosen: around walls, or straight there"},
            {"ties", &Params::ties, Choices{"first", "longest"},
             "of stretches worth the same: any, or the longest: fewer turns, in mazes and spirals longer paths"},
            {"repair", &Params::repair, "cover what is left where the tool no longer fits"},
            {"blocks", &Params::blocks, "large regions in blocks, one after the other; off: as in the source"}},
       .published = {{"links", std::string("straight")}, {"repair", false}, {"blocks", false}},
       .promises_with = [](const Params& p) { return p.repair; }});
}

}  // namespace oxturn
