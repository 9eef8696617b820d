// Oracle for the taut tether, after Hershberger & Snoeyink 1994: the word of triangles that the whole path runs
// through, reduced, and the funnel in what is left of it. Shares nothing with TautTether but Mesh and the predicates.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/mesh/mesh.hpp"
#include "geometry/predicates.hpp"
#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

class TautOracle {
 public:
  /// `anchor` in the closed region.
  TautOracle(const Mesh& mesh, const Point& anchor) : mesh_(&mesh), anchor_(anchor), at_(anchor) {
    sleeve_.push_back(mesh.locate(anchor, 0));
  }

  /// Follows the path; false (and of no more use) if it leaves the region or runs through a point where two fans of
  /// free space touch. Vertices may be corners; paths may run along walls and through corners.
  bool drive(const Point& to) {
    std::vector<Point> stops;
    for (const Point& v : mesh_->points())
      if (v != at_ && v != to && on_segment(v, at_, to)) stops.push_back(v);
    const Point from = at_;
    std::sort(stops.begin(), stops.end(),
              [&](const Point& a, const Point& b) { return a != b && on_segment(a, from, b); });
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    stops.push_back(to);
    for (const Point& stop : stops)
      if (!step(stop)) return false;
    return true;
  }

  /// The shortest path of the same class: anchor, corners with a turn, robot.
  Polyline line() const {
    // The edges crossed, without those at the ends that the path's end itself lies on.
    std::vector<std::array<std::int32_t, 2>> doors;  // right, left
    for (std::size_t i = 1; i < sleeve_.size(); ++i) {
      const Mesh::Triangle& t = triangle(sleeve_[i - 1]);
      std::size_t k = 0;
      while (t.neighbour[k] != sleeve_[i]) ++k;
      doors.push_back({t.vertex[(k + 1) % 3], t.vertex[(k + 2) % 3]});
    }
    const auto ends_at = [&](const std::array<std::int32_t, 2>& door, const Point& p) {
      return point(door[0]) == p || point(door[1]) == p;
    };
    std::size_t first = 0, last = doors.size();
    while (first < last && ends_at(doors[first], anchor_)) ++first;
    while (last > first && ends_at(doors[last - 1], at_)) --last;

    Polyline path, left{anchor_}, right{anchor_};
    for (std::size_t i = first; i < last; ++i) {
      narrow(right, left, point(doors[i][0]), -1, path);
      narrow(left, right, point(doors[i][1]), +1, path);
    }
    narrow(left, right, at_, +1, path);
    path.insert(path.end(), left.begin(), left.end());
    if (path.back() != at_) path.push_back(at_);
    Polyline out;
    for (const Point& p : path) {
      if (!out.empty() && out.back() == p) continue;
      while (out.size() > 1 && orientation(out[out.size() - 2], out.back(), p) == 0) out.pop_back();
      out.push_back(p);
    }
    if (out.size() == 1) out.push_back(at_);
    return out;
  }

  static std::vector<TautTether::Bend> bends(const Polyline& line) {
    std::vector<TautTether::Bend> out;
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      out.push_back({line[i], orientation(line[i - 1], line[i], line[i + 1])});
    return out;
  }

 private:
  const Mesh::Triangle& triangle(std::int32_t t) const { return mesh_->triangles()[static_cast<std::size_t>(t)]; }
  const Point& point(std::int32_t i) const { return mesh_->points()[static_cast<std::size_t>(i)]; }

  bool in_triangle(std::int32_t t, const Point& p) const {
    for (std::size_t k = 0; k < 3; ++k)
      if (orientation(point(triangle(t).vertex[k]), point(triangle(t).vertex[(k + 1) % 3]), p) < 0) return false;
    return true;
  }

  void enter(std::int32_t t) {
    if (sleeve_.size() > 1 && sleeve_[sleeve_.size() - 2] == t) {
      sleeve_.pop_back();
    } else {
      sleeve_.push_back(t);
    }
  }

  /// Straight to q; no corner lies strictly between.
  bool step(const Point& q) {
    if (q == at_) return true;
    for (std::size_t k = 0; k < 3; ++k)
      if (point(triangle(sleeve_.back()).vertex[k]) == at_ && !turn_to(triangle(sleeve_.back()).vertex[k], q))
        return false;
    while (!in_triangle(sleeve_.back(), q)) {
      const Mesh::Triangle& t = triangle(sleeve_.back());
      std::int32_t next = Mesh::kWall;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &a = point(t.vertex[(k + 1) % 3]), &b = point(t.vertex[(k + 2) % 3]);
        if (orientation(a, b, q) < 0 && orientation(at_, q, a) < 0 && orientation(at_, q, b) > 0) next = t.neighbour[k];
      }
      if (next == Mesh::kWall) return false;
      enter(next);
    }
    at_ = q;
    return true;
  }

  /// From corner v: turns within its fan to a triangle that holds the first part of the segment to q.
  bool turn_to(std::int32_t v, const Point& q) {
    for (const std::size_t side : {std::size_t{1}, std::size_t{2}}) {
      std::vector<std::int32_t> passed;
      std::int32_t t = sleeve_.back();
      while (t != Mesh::kWall && std::find(passed.begin(), passed.end(), t) == passed.end()) {
        passed.push_back(t);
        std::size_t k = 0;
        while (triangle(t).vertex[k] != v) ++k;
        const Point &a = point(triangle(t).vertex[(k + 1) % 3]), &b = point(triangle(t).vertex[(k + 2) % 3]);
        if (orientation(point(v), a, q) >= 0 && orientation(point(v), q, b) >= 0) {
          for (std::size_t i = 1; i < passed.size(); ++i) enter(passed[i]);
          return true;
        }
        t = triangle(t).neighbour[(k + side) % 3];
      }
    }
    return false;
  }

  /// The next door's end on one side: `mine` is that side's chain from the apex, `other` the opposite one; sign +1 for
  /// the left side. Corners that the apex passes go to `path`.
  static void narrow(Polyline& mine, Polyline& other, const Point& p, int sign, Polyline& path) {
    if (mine.back() == p) return;
    while (mine.size() > 1 && sign * orientation(mine[mine.size() - 2], mine.back(), p) <= 0) mine.pop_back();
    if (mine.size() == 1) {
      while (other.size() > 1) {
        const int turn = sign * orientation(other[0], other[1], p);
        if (turn > 0 || (turn == 0 && !on_segment(other[1], other[0], p))) break;
        path.push_back(other[0]);
        other.erase(other.begin());
        mine[0] = other[0];
      }
    }
    if (mine.back() != p) mine.push_back(p);
  }

  const Mesh* mesh_;
  Point anchor_, at_;
  std::vector<std::int32_t> sleeve_;  // reduced
};

}  // namespace oxturn
