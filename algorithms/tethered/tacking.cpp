// Decisions  1. The pull turns little along a stroke; it is looked up where each stroke begins, and the strokes bear
//               away by a hundredth of a radian more than asked.
//            2. A stroke ends `width` beside the stretch, or halves until it is free; below width / 16 the robot drives
//               on straight for that long.
#include "algorithms/tethered/tacking.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/transit/connector.hpp"

namespace oxturn {
namespace {

constexpr double kSpare = 0.01;  // radians

class Tacker {
 public:
  Tacker(const TetherSpace& leash, double angle, double width)
      : leash_(leash),
        walls_(leash.cut_problem().walls()),
        connector_(leash.cut_problem()),
        angle_(angle + kSpare),
        width_(width) {}

  void drive(PathBuilder& path, const Point& to, bool tool) {
    side_ = 1;
    // At least width / 16 of headway a turn, so this ends; the count only guards against a field that turns about.
    const double total = distance(path.at(), to);
    const auto most = static_cast<std::size_t>(64 * total / width_ + 64);
    const Point along = total > 0 ? Point((to - path.at()) / total) : Point(1, 0);
    const Point from = path.at();
    for (std::size_t k = 0; k < most; ++k) {
      const Point at = path.at();
      const double left = (to - at).dot(along);
      const auto pull = pull_at(at);
      if (!pull || left <= width_ / 8 || std::acos(std::clamp(pull->dot((to - at).normalized()), -1.0, 1.0)) >= angle_)
        break;
      if (const auto next = stroke(at, *pull, from, along, left))
        path.drive(*next, tool);
      else  // no room: a little way along the stretch itself
        go(path, to - along * std::max(0.0, left - width_ / 8), tool);
    }
    go(path, to, tool);
  }

 private:
  void go(PathBuilder& path, const Point& to, bool tool) const { path.drive(connector_.path(path.at(), to), tool); }

  std::optional<Point> pull_at(const Point& p) const {
    const Point d = leash_.field().sight(p).from - p;
    if (!(d.norm() > 1e-9) || !finite(d)) return std::nullopt;
    return Point(d.normalized());
  }

  /// The end of the next stroke: to the other side of the stretch than the last one, if there is room.
  std::optional<Point> stroke(const Point& at, const Point& pull, const Point& from, const Point& along, double left) {
    for (int attempt = 0; attempt < 2; ++attempt) {
      side_ = -side_;
      const Point heading = rotated(pull, side_ * angle_);
      const double sideways = cross(along, heading), forward = along.dot(heading);
      if (forward <= 0.05) continue;
      // How far to the side of the stretch it is still to go.
      const double offset = cross(along, at - from);
      const double room = sideways > 0 ? width_ - offset : width_ + offset;
      if (room <= width_ / 16 || sideways == 0) continue;
      for (double reach = std::min(room / std::abs(sideways), left / forward); reach * forward > width_ / 16;
           reach /= 2) {
        const Point next = at + reach * heading;
        if (walls_.contains(at, next)) return next;
      }
    }
    return std::nullopt;
  }

  const TetherSpace& leash_;
  const EdgeIndex& walls_;
  const Connector connector_;
  double angle_, width_;
  int side_ = 1;
};

}  // namespace

Path tacked(const TetherSpace& leash, const Path& path, double angle, double width) {
  Tacker tacker(leash, angle, width);
  PathBuilder out(leash.problem().start());
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) tacker.drive(out, leg.points[i], leg.tool);
  return out.take();
}

}  // namespace oxturn
