// Along the boundary of what is left, always where the next round or the next two swaths cover most for their time.
//
// Source      after Oksanen and Visala, "Coverage path planning algorithms for agricultural field machines", Journal of
//             Field Robotics 26(8), 2009, second algorithm: all routes over a short horizon are predicted, and of the
//             best one only the part up to the next turn is driven
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target with `repair` (lanes/repair.hpp; along traced walls but for 0.0003 of it)
// Complexity  O(s n log n) for s stretches between turns and n vertices of what is left; s grows as the area over the
//             tool's width and the length of a stretch
// Decisions   1. What is left is kept as the positions whose disc is uncovered: at first configuration space, then less
//                all positions nearer than a tool width to what was driven. Its boundary is half a tool width inside
//                what is uncovered, as the source's insets are.
//             2. A stretch is a part of that boundary between turns above 45 degrees, driven in either sense. Its value
//                is that of the better of two routes: the whole round that begins with it, or it and a swath back
//                beside it; area over time, turns and the straight drive there included. Where fewer than two tool
//                widths are left beside a stretch, the swath back covers what is there.
//             3. Stretches shorter than half a tool width are not driven. Uncovered bands narrower than the tool, where
//                no disc fits, are left to repair.
//             4. Not the same on a scaled map: the robot's speed and acceleration do not scale with it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/lanes/laps.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/polygon/cell_strips.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kTurn = kPi / 4;         // a stretch ends at sharper turns
constexpr double kChord = 0.01;           // tool widths: error of arcs, and by which what is left is simplified
constexpr double kShortestStretch = 0.5;  // tool widths
constexpr double kWorkLink = 2;           // tool widths: shorter links are driven with the tool on

struct Params {
  bool repair = true;
};

/// A part of a ring between sharp turns, in the ring's sense.
struct Stretch {
  Polyline points;
  double metres = 0;
  double round_metres = 0, round_turns = 0;  // of the whole ring; turns in radians
  double back_share = 1;                     // of a swath back beside it, how much is uncovered
};

double turn_at(const Point& before, const Point& at, const Point& after) {
  const Point a = at - before, b = after - at;
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

class PredictiveDrive {
 public:
  PredictiveDrive(const Problem& problem, const Connector& connector)
      : robot_(problem.robot()),
        width_(robot_.tool_width),
        walls_(problem.walls()),
        connector_(connector),
        path_(problem.start()) {}

  Path run(Region left, const Context& context) {
    while (!left.empty() && !context.cancelled()) {
      const auto [stretch, reversed] = best_stretch(left);
      if (stretch.points.empty()) break;
      Polyline line = stretch.points;
      if (reversed) std::ranges::reverse(line);
      drive(line);
      left = simplify_inward(subtract(left, swath({line}, width_ * (1 - 2 * kChord), kChord * width_, Bound::outside)),
                             kChord * width_);
      bring_inside(left);
    }
    return path_.take();
  }

 private:
  /// Where a cut ends on a wall, rounding may leave the new vertex outside; the next cut there would start from it, and
  /// so go astray by the sum of all.
  void bring_inside(Region& left) const {
    const auto bring = [&](Ring& ring) {
      for (Point& p : ring)
        if (!walls_.contains(p))
          if (const auto wall = walls_.nearest(p)) p = wall->point;
    };
    for (Polygon& polygon : left.polygons) {
      bring(polygon.outer);
      for (Ring& hole : polygon.holes) bring(hole);
    }
  }

  void drive(const Polyline& line) {
    const Polyline link = connector_.path(path_.at(), line.front());
    path_.drive(link, begun_ && length(link) <= kWorkLink * width_);
    path_.drive(line, true);
    begun_ = true;
  }

  std::pair<Stretch, bool> best_stretch(const Region& left) const {
    const EdgeIndex index(left);
    std::pair<Stretch, bool> best;
    double most = 0;
    for_each_ring(left, [&](const Ring& ring) {
      for (Stretch& s : stretches(ring)) {
        if (s.metres < kShortestStretch * width_) continue;
        // The drive there only lowers the value.
        for (const bool reversed : {false, true}) {
          const Point& begin = reversed ? s.points.back() : s.points.front();
          const double there = distance(path_.at(), begin) / robot_.speed;
          if (most > 0 && std::max(round_value(s, there), swath_value(s, there)) <= most) continue;
          s.back_share = share_beside(s.points, index);
          const double v = std::max(round_value(s, there), swath_value(s, there));
          s.back_share = 1;
          if (v > most) {
            most = v;
            best = {s, reversed};
          }
        }
      }
    });
    return best;
  }

  /// Of a line a tool width inside a stretch, how much lies in what is left; sampled every tool width.
  double share_beside(const Polyline& line, const EdgeIndex& left) const {
    int inside = 0, all = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Point d = line[i] - line[i - 1];
      const int samples = std::max(1, static_cast<int>(d.norm() / width_));
      const Point inwards = Point(-d.y(), d.x()).normalized() * width_;
      for (int k = 0; k < samples; ++k, ++all)
        if (left.contains(Point(line[i - 1] + d * ((k + 0.5) / samples) + inwards))) ++inside;
    }
    return all > 0 ? static_cast<double>(inside) / all : 0;
  }

  double round_value(const Stretch& s, double there) const {
    const double turning = s.round_turns / robot_.turn_rate;
    return width_ * s.round_metres / (there + s.round_metres / robot_.speed + turning);
  }
  double swath_value(const Stretch& s, double there) const {
    const double seconds = there + 2 * s.metres / robot_.speed + seconds_to_next_lane(robot_);
    return width_ * s.metres * (1 + s.back_share) / seconds;
  }

  /// The ring, cut at its sharp turns; a ring without any is cut at its vertex nearest to where the robot is.
  std::vector<Stretch> stretches(const Ring& ring) const {
    const std::size_t n = ring.size();
    std::vector<std::size_t> cuts;
    double metres = 0, turns = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const Point& at = ring[i];
      const double turn = turn_at(ring[(i + n - 1) % n], at, ring[(i + 1) % n]);
      if (turn > kTurn) cuts.push_back(i);
      turns += turn;
      metres += distance(at, ring[(i + 1) % n]);
    }
    if (cuts.empty()) cuts.push_back(nearest_vertex(ring, path_.at()));
    std::vector<Stretch> all;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
      Stretch s{{ring[cuts[k]]}, 0, metres, turns};
      for (std::size_t i = (cuts[k] + 1) % n;; i = (i + 1) % n) {
        s.points.push_back(ring[i]);
        if (i == cuts[(k + 1) % cuts.size()]) break;
      }
      s.metres = length(s.points);
      all.push_back(std::move(s));
    }
    return all;
  }

  const Robot& robot_;
  double width_;
  const EdgeIndex& walls_;
  const Connector& connector_;
  PathBuilder path_;
  bool begun_ = false;
};

Path plan(const Params& p, const Problem& problem, Context& context) {
  const Connector connector(problem);
  Path path = PredictiveDrive(problem, connector).run(straightened_space(problem), context);
  path = without_short_segments(std::move(path), problem);
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
       .guarantee = "covers the whole target (with repair; along traced walls but for 0.0003 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift},
       .parameters = {{"repair", &Params::repair, "cover what is left where the tool no longer fits"}},
       .published = {{"repair", false}},
       .promises_with = [](const Params& p) { return p.repair; }});
}

}  // namespace oxturn
