#include "algorithms/smoothing/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kMostTurn = kPi * 2 / 3;  // of a rounded corner
constexpr double kAlmost = 0.995;          // chords of an arc are shorter than its tangents
constexpr double kParallel = 1e-6;         // radians
constexpr double kShort = 1;               // radii; edges shorter than this may be left out
constexpr double kMostLeftOut = 3;         // radii, of consecutive edges together

struct Edge {
  Point a{0, 0}, along{1, 0};
  double length = 0;
  Point at(double s) const { return a + s * along; }
};

double turn_between(const Edge& a, const Edge& b) { return math::atan2(cross(a.along, b.along), a.along.dot(b.along)); }

/// From one edge to a later one.
struct Joint {
  double leave = 0, enter = 0;      // positions on the two edges
  std::optional<CurvePiece> arc{};  // none: the edges meet in a vertex that is kept
  double before = 0, turn = 0;      // of a vertex that is kept: metres from the point before it, change of heading
};

/// An edge of the run that grows, and how it is reached.
struct Part {
  std::size_t edge;
  Joint joint;  // from the part before
};

class Rounding {
 public:
  Rounding(const Polyline& line, const CarSpace& space) : space_(space), radius_(space.radius()) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Point step = line[i] - line[i - 1];
      const double length = step.norm();
      if (length > 0) edges_.push_back({line[i - 1], step / length, length});
    }
  }

  std::vector<Polyline> run() {
    for (std::size_t k = 0; k < edges_.size();) {
      if (parts_.empty() || extend(k)) {
        if (parts_.empty()) parts_.push_back({k, {}});
        ++k;
        continue;
      }
      const std::size_t last = parts_.back().edge;
      if (may_leave_out(last, k)) {
        ++k;
        if (k < edges_.size()) continue;
      }
      finish();
      k = last + 1;
    }
    if (!parts_.empty()) finish();
    return std::move(runs_);
  }

 private:
  /// Appends the edge, perhaps in place of short ones at the end of the run.
  bool extend(std::size_t k) {
    for (std::size_t keep = parts_.size(); keep > 0; --keep) {
      const Part& top = parts_[keep - 1];
      if (const auto joint = joint_between(top, k)) {
        parts_.resize(keep);
        parts_.push_back({k, *joint});
        return true;
      }
      if (edges_[top.edge].length > kShort * radius_) break;
    }
    return false;
  }

  bool may_leave_out(std::size_t last, std::size_t k) const {
    double left_out = 0;
    for (std::size_t i = last + 1; i <= k; ++i) left_out += edges_[i].length;
    return edges_[k].length <= kShort * radius_ && left_out <= kMostLeftOut * radius_;
  }

  std::optional<Joint> joint_between(const Part& top, std::size_t k) const {
    const Edge &a = edges_[top.edge], &b = edges_[k];
    const double turn = turn_between(a, b);
    const double tangent = kAlmost * radius_ * math::tan(std::abs(turn) / 2);
    if (top.edge + 1 == k && smooth(turn)) {
      if (a.length - tangent < top.joint.enter || tangent > b.length) return std::nullopt;
      const double before = a.length - (top.joint.arc ? top.joint.enter : 0);
      if (keeps_radius(before, b.length, turn)) return Joint{a.length, tangent, {}, before, turn};
    }
    if (std::abs(turn) > kMostTurn || std::abs(turn) < kParallel) return std::nullopt;
    // The lines meet at a.at(s) = b.at(t).
    const Point between = b.a - a.a;
    const double s = cross(between, b.along) / cross(a.along, b.along);
    const double t = cross(between, a.along) / cross(a.along, b.along);
    const double touch = tangent / kAlmost;
    const Joint joint{s - touch, t + touch,
                      CurvePiece{turn > 0 ? Steering::left : Steering::right, radius_ * std::abs(turn)}};
    const bool fits = joint.leave > top.joint.enter && keeps_radius(top.joint.before, joint.leave, top.joint.turn) &&
                      joint.enter < b.length && s < a.length + 2 * radius_ && t > -2 * radius_;
    return fits && free(a, b, joint) ? std::optional(joint) : std::nullopt;
  }

  /// The arc, and where edges are extended to meet it.
  bool free(const Edge& a, const Edge& b, const Joint& joint) const {
    return space_.free(pose(a, joint.leave), *joint.arc) &&
           (joint.leave <= a.length || space_.free(Polyline{a.at(a.length), a.at(joint.leave)})) &&
           (joint.enter >= 0 || space_.free(Polyline{b.at(joint.enter), b.a}));
  }

  /// The circle through a vertex and the points `before` and `after` metres beside it is not smaller.
  bool keeps_radius(double before, double after, double turn) const {
    const double chord = std::sqrt(before * before + after * after + 2 * before * after * math::cos(turn));
    return 2 * math::sin(std::abs(turn)) * kAlmost * radius_ <= chord;
  }

  /// A curve of the least radius, sampled as paths must be, may turn that much at a vertex.
  bool smooth(double turn) const { return (1 - math::cos(turn / 2)) * radius_ <= space_.chord_error(); }

  static Pose pose(const Edge& edge, double s) { return {edge.at(s), math::atan2(edge.along.y(), edge.along.x())}; }

  void finish() {
    Polyline run{edges_[parts_.front().edge].a};
    const auto add = [&](const Point& p) {
      if (distance(run.back(), p) > 1e-9 * radius_) run.push_back(p);
    };
    for (std::size_t i = 1; i < parts_.size(); ++i) {
      const Joint& joint = parts_[i].joint;
      const Pose from = pose(edges_[parts_[i - 1].edge], joint.leave);
      add(from.at);
      if (!joint.arc) continue;
      const Curve arc{from, pose(edges_[parts_[i].edge], joint.enter), radius_, {*joint.arc}};
      for (const Leg& leg : sampled(arc, space_.chord_error(), true))
        for (const Point& p : leg.points) add(p);
    }
    const Edge& last = edges_[parts_.back().edge];
    add(last.at(last.length));
    if (run.size() > 1) runs_.push_back(std::move(run));
    parts_.clear();
  }

  const CarSpace& space_;
  double radius_;
  std::vector<Edge> edges_;
  std::vector<Part> parts_;
  std::vector<Polyline> runs_;
};

/// A closed polyline from the middle of its longest edge, so that all its corners are inside.
Polyline from_longest_edge(const Polyline& ring) {
  std::size_t longest = 1;
  for (std::size_t i = 2; i < ring.size(); ++i)
    if (distance(ring[i - 1], ring[i]) > distance(ring[longest - 1], ring[longest])) longest = i;
  const std::size_t n = ring.size() - 1;
  const Point middle = lerp(ring[longest - 1], ring[longest], 0.5);
  Polyline line{middle};
  for (std::size_t i = 0; i < n; ++i) line.push_back(ring[(longest + i) % n]);
  line.push_back(middle);
  return line;
}

}  // namespace

std::vector<Polyline> rounded_runs(const Polyline& line, const CarSpace& space) {
  const bool closed = line.size() > 3 && line.front() == line.back();
  return Rounding(closed ? from_longest_edge(line) : line, space).run();
}

}  // namespace oxturn
