// Decisions  1. The pull turns little during a stroke. It is looked up where each stroke begins, and strokes keep a
//               hundredth of a radian more than the angle asked for.
//            2. A stroke ends `width` beside the segment; its length is halved until it is free. If no stroke with at
//               least width / 16 of headway is free, the robot drives straight on for width / 8.
#include "algorithms/tethered/tacking.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/transit/connector.hpp"

namespace oxturn {
namespace {

constexpr double kSpare = 0.01;          // radians beyond the angle asked for
constexpr double kLeastHeadway = 16;     // width over the least headway of a stroke
constexpr double kStraightOn = 8;        // width over the distance driven straight on where there is no room
constexpr double kStrokesPerWidth = 64;  // bound of the number of strokes, which ends a field that turns about
constexpr double kLeastForward = 0.05;   // cosine of the angle between stroke and segment
constexpr double kNoPull = 1e-9;         // metres from the pivot within which there is no direction of pull

class Tacker {
 public:
  Tacker(const TetherSpace& space, double angle, double width)
      : space_(space),
        walls_(space.cut_problem().walls()),
        connector_(space.cut_problem()),
        angle_(angle + kSpare),
        width_(width) {}

  /// Drives to `to` along the straight segment from where `path` ends.
  void drive(PathBuilder& path, const Point& to, bool tool) {
    side_ = 1;
    const double total = distance(path.at(), to);
    const auto most = static_cast<std::size_t>(kStrokesPerWidth * total / width_ + kStrokesPerWidth);
    const Point along = total > 0 ? Point((to - path.at()) / total) : Point(1, 0);
    const Point from = path.at();
    for (std::size_t k = 0; k < most; ++k) {
      const Point at = path.at();
      const double remaining = (to - at).dot(along);
      const auto pull = pull_at(at);
      if (!pull || remaining <= width_ / kStraightOn || !folds(*pull, to - at)) break;
      if (const auto next = stroke(at, *pull, from, along, remaining))
        path.drive(*next, tool);
      else
        go(path, to - along * std::max(0.0, remaining - width_ / kStraightOn), tool);
    }
    go(path, to, tool);
  }

 private:
  void go(PathBuilder& path, const Point& to, bool tool) const { path.drive(connector_.path(path.at(), to), tool); }

  /// Unit vector from p along the tether.
  std::optional<Point> pull_at(const Point& p) const {
    const Point d = space_.field().sight(p).from - p;
    if (!(d.norm() > kNoPull) || !finite(d)) return std::nullopt;
    return Point(d.normalized());
  }
  bool folds(const Point& pull, const Point& heading) const {
    return std::acos(std::clamp(pull.dot(heading.normalized()), -1.0, 1.0)) < angle_;
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
        if (walls_.contains(at, next)) return next;
      }
    }
    return std::nullopt;
  }

  const TetherSpace& space_;
  const EdgeIndex& walls_;
  const Connector connector_;
  double angle_, width_;
  int side_ = 1;  // of the last stroke: 1 left of the pull, -1 right
};

}  // namespace

Path tacked(const TetherSpace& space, const Path& path, double angle, double width) {
  Tacker tacker(space, angle, width);
  PathBuilder out(space.problem().start());
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) tacker.drive(out, leg.points[i], leg.tool);
  return out.take();
}

}  // namespace oxturn
