#include "geometry/path.hpp"

#include <algorithm>
#include <utility>

namespace oxturn {
namespace {

bool repeats(const Point& a, const Point& b) {
  constexpr double kRounding = 1e-12;
  return (a - b).cwiseAbs().maxCoeff() <= kRounding * a.cwiseAbs().cwiseMax(b.cwiseAbs()).maxCoeff();
}

}  // namespace

double Path::length() const {
  double sum = 0;
  for (const Leg& l : legs) sum += oxturn::length(l.points);
  return sum;
}

double Path::length(bool tool) const {
  double sum = 0;
  for (const Leg& l : legs)
    if (l.tool == tool) sum += oxturn::length(l.points);
  return sum;
}

/// Is the last leg of this kind?
bool PathBuilder::goes_on(bool tool, Gear gear, double width) const {
  if (path_.legs.empty()) return false;
  const Leg& last = path_.legs.back();
  return last.tool == tool && last.gear == gear && last.width == width;
}

void PathBuilder::drive(const Polyline& points, bool tool, Gear gear, double width) {
  for (const Point& p : points) {
    if (repeats(p, at_)) continue;
    if (!goes_on(tool, gear, width)) path_.legs.push_back({tool, {at_}, gear, width});
    path_.legs.back().points.push_back(p);
    at_ = p;
  }
}

void PathBuilder::drive(Polyline&& points, bool tool, Gear gear, double width) {
  if (goes_on(tool, gear, width) || points.size() < 2 || points.front() != at_ ||
      std::adjacent_find(points.begin(), points.end(), repeats) != points.end())
    return drive(static_cast<const Polyline&>(points), tool, gear, width);
  at_ = points.back();
  path_.legs.push_back({tool, std::move(points), gear, width});
}

}  // namespace oxturn
