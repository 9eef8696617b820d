// Oracle for homotopy classes: every taut path of a small region, by brute force.
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {

/// Every taut path by the definition alone: depth-first over the visibility graph; a bend turns about both of its
/// corner's walls.
class TautPaths {
 public:
  explicit TautPaths(const Region& region) : index_(region) {
    for_each_ring(region, [&](const Ring& r) {
      for (std::size_t i = 0; i < r.size(); ++i) {
        const Point &before = r[(i + r.size() - 1) % r.size()], &after = r[(i + 1) % r.size()];
        if (orientation(before, r[i], after) < 0) corners_.push_back({r[i], {before, after}});
      }
    });
  }
  std::vector<Polyline> from(const Point& a, const Point& b, double longest) {
    found_.clear();
    Polyline line{a};
    extend(line, nullptr, b, longest);
    std::sort(found_.begin(), found_.end(), [](const auto& p, const auto& q) { return length(p) < length(q); });
    return found_;
  }

 private:
  struct Corner {
    Point at;
    std::array<Point, 2> walls;
  };
  static bool turns_about(const Corner& c, const Point& u, const Point& w) {
    const int turn = orientation(u, c.at, w);
    return turn != 0 && std::all_of(c.walls.begin(), c.walls.end(), [&](const Point& x) {
             return turn * orientation(u, c.at, x) >= 0 && turn * orientation(c.at, w, x) >= 0;
           });
  }
  void extend(Polyline& line, const Corner* last, const Point& b, double left) {
    const Point at = line.back();
    const auto goes = [&](const Point& to) {
      return distance(at, to) + distance(to, b) <= left && index_.contains(at, to) &&
             (last == nullptr || turns_about(*last, line[line.size() - 2], to));
    };
    if (goes(b)) {
      found_.push_back(line);
      found_.back().push_back(b);
    }
    for (const Corner& c : corners_) {
      if (c.at == at || !goes(c.at)) continue;
      line.push_back(c.at);
      extend(line, &c, b, left - distance(at, c.at));
      line.pop_back();
    }
  }
  EdgeIndex index_;
  std::vector<Corner> corners_;
  std::vector<Polyline> found_;
};

}  // namespace oxturn
