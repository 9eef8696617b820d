// Decisions  1. The pull turns little during a stroke. It is looked up where each stroke begins, and strokes keep a
//               hundredth of a radian more than the angle asked for.
//            2. A stroke ends `width` beside the segment; its length is halved until it is free. If no stroke with at
//               least width / 16 of headway is free, the robot drives straight on for width / 8.
#include "algorithms/tethered/tacking.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/transit/connector.hpp"
#include "base/math.hpp"
#include "geometry/point_outside.hpp"

namespace oxturn {
namespace {

constexpr double kSpare = 0.01;          // radians beyond the angle asked for
constexpr double kLeastHeadway = 16;     // width over the least headway of a stroke
constexpr double kStraightOn = 8;        // width over the distance driven straight on where there is no room
constexpr double kStrokesPerWidth = 64;  // bound of the number of strokes, which ends a field that turns about
constexpr double kLeastForward = 0.05;   // cosine of the angle between stroke and segment
constexpr double kOffWall = 1e-6;        // share of a stroke: where it begins may be outside by rounding
constexpr double kNoPull = 1e-9;         // metres from the pivot within which there is no direction of pull

class Tacker {
 public:
  Tacker(const GeodesicField& field, const Problem& component, const Tacking& tacking)
      : field_(field),
        walls_(component.walls()),
        connector_(component),
        rounding_(component.tolerance()),
        angle_(tacking.angle + kSpare),
        width_(tacking.width) {}

  /// Is ab, a segment of a path along walls and inside them, in the component?
  bool inside(const Point& a, const Point& b) const { return !point_outside(walls_, a, b, rounding_); }
  /// Is the heading from a to b too near the pull at a?
  bool folds(const Point& a, const Point& b) const {
    const auto pull = pull_at(a);
    return pull && too_near(*pull, b - a);
  }

  /// Drives to `to` along the straight segment from where `path` ends, tool off. False if it never leaves the segment.
  bool drive(PathBuilder& path, const Point& to) {
    side_ = 1;
    const double total = distance(path.at(), to);
    const auto most = static_cast<std::size_t>(kStrokesPerWidth * total / width_ + kStrokesPerWidth);
    const Point along = total > 0 ? Point((to - path.at()) / total) : Point(1, 0);
    const Point from = path.at();
    bool left = false;
    for (std::size_t k = 0; k < most; ++k) {
      const Point at = path.at();
      const double remaining = (to - at).dot(along);
      const auto pull = pull_at(at);
      if (!pull || remaining <= width_ / kStraightOn || !too_near(*pull, to - at)) break;
      if (const auto next = stroke(at, *pull, from, along, remaining)) {
        path.drive(*next, false);
        left = true;
      } else {
        go(path, to - along * std::max(0.0, remaining - width_ / kStraightOn));
      }
    }
    go(path, to);
    return left;
  }

 private:
  void go(PathBuilder& path, const Point& to) const { path.drive(connector_.path(path.at(), to), false); }

  /// Unit vector from p along the tether.
  std::optional<Point> pull_at(const Point& p) const {
    const Point d = field_.sight(p).from - p;
    if (!(d.norm() > kNoPull) || !finite(d)) return std::nullopt;
    return Point(d.normalized());
  }
  bool too_near(const Point& pull, const Point& heading) const {
    return math::acos(std::clamp(pull.dot(heading.normalized()), -1.0, 1.0)) < angle_;
  }

  /// The end of the next stroke: to the other side of the segment than the last one, if there is room.
  std::optional<Point> stroke(const Point& at, const Point& pull, const Point& from, const Point& along,
                              double remaining) {
    const double least = width_ / kLeastHeadway;
    for (int attempt = 0; attempt < 2; ++attempt) {
      side_ = -side_;
      const Point heading = rotated(pull, side_ * angle_);
      const double sideways = cross(along, heading), forward = along.dot(heading);
      if (forward <= kLeastForward) continue;
      const double offset = cross(along, at - from);  // from the segment, to the left
      const double room = sideways > 0 ? width_ - offset : width_ + offset;
      if (room <= least || sideways == 0) continue;
      for (double reach = std::min(room / std::abs(sideways), remaining / forward); reach * forward > least;
           reach /= 2) {
        const Point next = at + reach * heading;
        if (walls_.contains(lerp(at, next, kOffWall), next)) return next;
      }
    }
    return std::nullopt;
  }

  const GeodesicField& field_;
  const EdgeIndex& walls_;
  const Connector connector_;
  double rounding_;
  double angle_, width_;
  int side_ = 1;  // of the last stroke: 1 left of the pull, -1 right
};

/// The path from a to b, a part of a leg, in parts throughout which it folds or does not.
Polyline divided(const Tacker& tacker, const Point& a, const Point& b, double step) {
  const double n = std::max(1.0, std::ceil(distance(a, b) / step));
  Polyline points;
  bool before = tacker.folds(a, b);
  for (double i = 1; i < n; ++i) {
    const Point p = lerp(a, b, i / n);
    const bool here = tacker.folds(p, b);
    if (here != before) points.push_back(p);
    before = here;
  }
  points.push_back(b);
  return points;
}

void append(PathBuilder& path, const Path& more) {
  for (const Leg& leg : more.legs) path.drive(leg.points, leg.tool);
}

/// From where `path` ends along `inwards`, all of which folds.
void drive_folding(Tacker& tacker, const Polyline& inwards, bool tool, PathBuilder& path) {
  PathBuilder strokes(path.at());
  bool left = false;
  for (const Point& p : inwards) left = tacker.drive(strokes, p) || left;
  const Path in = strokes.take();
  if (!left) return path.drive(inwards, tool);
  Polyline outwards{path.at()};
  outwards.insert(outwards.end(), inwards.begin(), inwards.end());
  std::reverse(outwards.begin(), outwards.end());
  append(path, in);
  if (!tool) return;
  path.drive(outwards, true);
  append(path, in);
}

}  // namespace

Path tacked(const GeodesicField& field, const Problem& component, const Path& path, const Tacking& tacking) {
  if (path.legs.empty()) return path;
  Tacker tacker(field, component, tacking);
  PathBuilder out(path.legs.front().points.front());
  for (const Leg& leg : path.legs) {
    Polyline inwards;  // as yet undriven
    const auto flush = [&] {
      if (!inwards.empty()) drive_folding(tacker, std::exchange(inwards, {}), leg.tool, out);
    };
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      Point last = leg.points[i - 1];
      const bool inside = tacker.inside(last, leg.points[i]);
      for (const Point& p :
           inside ? divided(tacker, last, leg.points[i], tacking.width / 2) : Polyline{leg.points[i]}) {
        if (inside && tacker.folds(last, p)) {
          inwards.push_back(p);
        } else {
          flush();
          out.drive(p, leg.tool);
        }
        last = p;
      }
    }
    flush();
  }
  return out.take();
}

}  // namespace oxturn
