#include "geometry/paths/sleeve.hpp"

#include <algorithm>
#include <vector>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

/// The shortest path through portals, by a funnel: an apex and the narrowest view of the portals passed so far. Where
/// one side of the view crosses the other, the path bends there and a new view begins.
class Funnel {
 public:
  /// The last portal is the goal, twice.
  static Polyline path(const Point& start, const std::vector<Portal>& portals) {
    Funnel f(start, portals[0].left, portals[0].right);
    for (std::size_t i = 1; i < portals.size(); ++i) i = f.pass(i, portals[i].left, portals[i].right);
    const Point& goal = portals.back().left;
    if (goal != f.line_.back() || f.line_.size() == 1) f.line_.push_back(goal);
    return std::move(f.line_);
  }

 private:
  /// A side of the view, and the portal that it comes from.
  struct Side {
    Point at;
    std::size_t portal;
  };

  Funnel(const Point& start, const Point& left, const Point& right)
      : line_{start}, apex_(start), left_{left, 0}, right_{right, 0} {}

  /// Narrows the view by portal i. Returns i, or the portal of a bend, from which to go on.
  std::size_t pass(std::size_t i, const Point& left, const Point& right) {
    if (orientation(apex_, right_.at, right) >= 0) {
      if (apex_ != right_.at && orientation(apex_, left_.at, right) >= 0) return bend_at(left_);
      right_ = {right, i};
    }
    if (orientation(apex_, left_.at, left) <= 0) {
      if (apex_ != left_.at && orientation(apex_, right_.at, left) <= 0) return bend_at(right_);
      left_ = {left, i};
    }
    return i;
  }
  std::size_t bend_at(const Side side) {
    if (side.at != line_.back()) line_.push_back(side.at);
    apex_ = side.at;
    left_ = right_ = side;
    return side.portal;
  }

  Polyline line_;
  Point apex_;
  Side left_, right_;
};

}  // namespace

Portal portal_between(const Mesh& mesh, std::int32_t from, std::int32_t to) {
  const std::size_t k = mesh.edge_towards(from, to);
  return {mesh.vertex(from, k + 2), mesh.vertex(from, k + 1)};
}

Polyline shortest_in_sleeve(const Mesh& mesh, const Point& start, std::span<const std::int32_t> triangles,
                            const Point& goal) {
  thread_local std::vector<Portal> portals;
  portals.clear();
  for (std::size_t i = 1; i < triangles.size(); ++i)
    portals.push_back(portal_between(mesh, triangles[i - 1], triangles[i]));
  // A start on the first portals has passed them: seen from it they span 180 degrees, which orientations cannot tell
  // from none.
  portals.erase(portals.begin(), std::find_if(portals.begin(), portals.end(), [&](const Portal& p) {
                  return orientation(p.right, p.left, start) > 0;
                }));
  portals.push_back({goal, goal});
  const Polyline line = Funnel::path(start, portals);
  // Vertices that the path only touches are not bends.
  Polyline bends{line.front()};
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (orientation(bends.back(), line[i], line[i + 1]) != 0) bends.push_back(line[i]);
  bends.push_back(line.back());
  return bends;
}

}  // namespace oxturn
