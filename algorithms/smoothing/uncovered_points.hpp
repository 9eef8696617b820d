/// Points of what a path leaves uncovered, so that strokes can be judged by what they would cover of it.
///
///   UncoveredPoints points(uncovered(target, path, robot), width);
///   points.cover(stroke);                        // no longer uncovered
///   points.area();                               // square metres that are left, roughly
///
/// Pieces are sampled by their outlines and, inside, by a grid. Each point stands for an equal share of its piece.
/// Complexity  build O(n) for n points; cover() and near() cost those near by
#pragma once

#include <vector>

#include "geometry/region.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

/// Tool widths from the tool's centre line to the points that count as covered: half a width, and half of the seam that
/// uncovered() lets pass, because along walls points are exactly half a width from where the robot can be.
inline constexpr double kCoveredReach = 0.502;

class UncoveredPoints {
 public:
  /// `width`: of the tool, metres. Of pieces with less area than `least` only that is known.
  UncoveredPoints(const Region& uncovered, double width, double least);

  /// Square metres, of all pieces.
  double area() const { return area_; }
  std::size_t size() const { return points_.size(); }
  const Point& at(std::size_t k) const { return points_[k]; }
  /// Square metres that the point stands for.
  double share(std::size_t k) const { return share_[k]; }
  bool covered(std::size_t k) const { return covered_[k]; }
  /// Points by piece, the largest piece first; in each so that those one after the other are far apart.
  const std::vector<std::vector<std::size_t>>& pieces() const { return pieces_; }

  /// Those which a tool covers that is driven along the line. Square metres that were uncovered before.
  double cover(const Polyline& line);
  /// Square metres that the lines together would cover.
  double gain(const std::vector<Polyline>& lines) const;
  /// Would it cover any?
  bool covers_any(const Polyline& line) const;
  /// Calls f(k) for the uncovered points that may be nearer to p than `metres`.
  template <class F>
  void near(const Point& p, double metres, F f) const {
    const auto look = [&](std::size_t cell) {
      for (const std::uint32_t k : grid_.items(cell))
        if (!covered_[k] && distance(points_[k], p) <= metres) f(static_cast<std::size_t>(k));
      return false;
    };
    grid_.visit(std::array{p}, metres, look);
  }

 private:
  template <class F>
  bool visit(const Polyline& line, F f) const;
  void add(const Polygon& piece);

  double width_, area_ = 0;
  std::vector<Point> points_;
  std::vector<double> share_;
  std::vector<char> covered_;
  std::vector<std::vector<std::size_t>> pieces_;
  UniformGrid grid_;
};

}  // namespace oxturn
