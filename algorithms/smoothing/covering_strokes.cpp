#include "algorithms/smoothing/covering_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace oxturn {
namespace {

// Tool widths.
constexpr double kRings[] = {0.12, 0.25, 0.37, 0.49};  // of positions around the point
constexpr double kLongest = 6, kLeast = 0.05;          // of a stroke
constexpr int kAround = 12;                            // positions of a ring
constexpr int kAxes = 8;                               // in all directions
constexpr std::size_t kWalls = 6;                      // whose directions are tried
constexpr int kHalvings = 6;                           // how exactly it is found how far an axis is free
constexpr std::size_t kMost = 8;                       // strokes

class StrokeSearch {
 public:
  StrokeSearch(const UncoveredPoints& uncovered, std::size_t target, const CarSpace& space, double width)
      : uncovered_(uncovered), space_(space), at_(uncovered.at(target)), width_(width) {
    points_.push_back(target);
    uncovered.near(at_, kLongest * width, [&](std::size_t k) {
      if (k != target) points_.push_back(k);
    });
  }

  std::vector<CoveringStroke> find() const {
    const std::vector<Point> axes = directions(), from = positions();
    std::vector<CoveringStroke> all;
    for (const Point& axis : axes) {
      std::optional<CoveringStroke> best;
      for (const Point& p : from)
        if (auto stroke = along(p, axis); stroke && (!best || stroke->worth > best->worth) && enterable(*stroke))
          best = std::move(stroke);
      if (best) all.push_back(std::move(*best));
    }
    std::ranges::stable_sort(all, [](const auto& a, const auto& b) { return a.worth > b.worth; });
    if (all.size() > kMost) all.resize(kMost);
    return all;
  }

 private:
  std::vector<Point> positions() const {
    std::vector<Point> all;
    const auto add = [&](const Point& p) {
      if (space_.walls().contains(p)) all.push_back(p);
    };
    add(at_);
    for (const double ring : kRings)
      for (int k = 0; k < kAround; ++k) add(at_ + ring * width_ * direction({at_, 2 * kPi * k / kAround}));
    // Where only a point of the boundary covers it, as at the end of a corner.
    if (const auto nearest = space_.walls().nearest(at_, kCoveredReach * width_)) all.push_back(nearest->point);
    return all;
  }

  std::vector<Point> directions() const {
    std::vector<Point> all;
    Box box;
    box.add(at_ - Point(width_, width_));
    box.add(at_ + Point(width_, width_));
    space_.walls().for_each_near(box, [&](std::size_t e) {
      const auto& edge = space_.walls().edges()[e];
      if (all.size() >= kWalls || distance_to_segment(at_, edge.a, edge.b) > width_) return;
      const Point along = (edge.b - edge.a).normalized();
      for (const Point& known : all)
        if (std::abs(cross(known, along)) < 0.05) return;
      all.push_back(along);
    });
    for (int k = 0; k < kAxes; ++k) all.push_back(direction({at_, kPi * k / kAxes}));
    return all;
  }

  /// A part of an axis, metres ahead and behind a position.
  struct Reach {
    double ahead, behind;
  };
  /// What of the axis is of use: where the tool covers a point it must get to, and no more; at most kLongest.
  Reach wanted(const Point& p, const Point& axis) const {
    const double least = kLeast * width_, most = kLongest * width_;
    Reach reach{least, least};
    for (const std::size_t k : points_) {
      const auto [s, half] = seen(k, p, axis);
      if (half < 0) continue;
      reach.ahead = std::max(reach.ahead, s - half);
      reach.behind = std::max(reach.behind, -s - half);
    }
    return {std::min(reach.ahead, most), std::min(reach.behind, most)};
  }
  /// How far of that the robot can drive from p.
  Reach free_reach(const Point& p, const Point& axis) const {
    const Reach reach = wanted(p, axis);
    if (space_.free(Polyline{p - reach.behind * axis, p + reach.ahead * axis})) return reach;
    return {free_length(p, axis, reach.ahead), free_length(p, -axis, reach.behind)};
  }
  double free_length(const Point& p, const Point& axis, double most) const {
    double low = 0, high = most;
    if (space_.free(Polyline{p, p + high * axis})) return high;
    for (int k = 0; k < kHalvings; ++k) {
      const double middle = (low + high) / 2;
      (space_.free(Polyline{p, p + middle * axis}) ? low : high) = middle;
    }
    return low;
  }

  /// A point as an axis through p passes it: the tool covers it from s - half to s + half; half < 0: from nowhere.
  struct Seen {
    double s, half;
  };
  Seen seen(std::size_t k, const Point& p, const Point& axis) const {
    const double reach = kCoveredReach * width_;
    const Point to = uncovered_.at(k) - p;
    const double side = cross(axis, to);
    return {axis.dot(to), std::abs(side) <= reach ? std::sqrt(reach * reach - side * side) : -1};
  }

  std::optional<CoveringStroke> along(const Point& p, const Point& axis) const {
    const auto [ahead, behind] = free_reach(p, axis);
    const double least = kLeast * width_;
    if (ahead + behind < least) return std::nullopt;
    double begin = std::numeric_limits<double>::infinity(), end = -begin, gain = 0;
    for (const std::size_t k : points_) {
      const auto [s, half] = seen(k, p, axis);
      if (half < 0 || s - half > ahead || s + half < -behind) {
        if (k == points_.front()) return std::nullopt;
        continue;
      }
      begin = std::min(begin, s + half), end = std::max(end, s - half);
      gain += uncovered_.share(k);
    }
    begin = std::clamp(begin, -behind, ahead), end = std::clamp(end, -behind, ahead);
    if (end - begin < least) {
      const double middle = std::clamp((begin + end) / 2, -behind + least / 2, ahead - least / 2);
      begin = middle - least / 2, end = middle + least / 2;
    }
    return CoveringStroke{{p + begin * axis, p + end * axis}, gain, gain / (end - begin + space_.radius() + width_)};
  }

  bool enterable(const CoveringStroke& stroke) const {
    const double turn = kPi * space_.radius();
    const Pose in{stroke.points[0], heading(stroke.points[0], stroke.points[1])}, out{stroke.points[1], in.heading};
    return space_.can_go_on(out, turn) && space_.can_go_on(turned_round(in), turn);
  }

  const UncoveredPoints& uncovered_;
  const CarSpace& space_;
  Point at_;
  double width_;
  std::vector<std::size_t> points_;  // the first is the one to be covered
};

}  // namespace

std::vector<CoveringStroke> covering_strokes(const UncoveredPoints& uncovered, std::size_t target,
                                             const CarSpace& space, double width) {
  return StrokeSearch(uncovered, target, space, width).find();
}

}  // namespace oxturn
