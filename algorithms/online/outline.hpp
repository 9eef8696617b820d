// The free space that scans without noise make certain, with its true corners: the union of their stars (star.hpp).
//
// An occupancy grid loses up to a cell at every wall and has a corner at every step of a slanting one; here straight
// walls stay straight, so what is planned on it covers what a plan on the true map would, with about as many corners.
// A star overlooks what is narrower than the rays are apart. So every wall point ever seen is held against every star,
// before and after: where one lies in a star, what that star says between the two rays about the point counts no
// longer, there and up to a quarter of the robot's size away. No place that was hit lies in what is free.
// Stars are shrunk by half a millionth: walls seen from several places overlap, and rounding never adds free space.
// They are united when somebody asks, many at once.
// Complexity  a star of n corners against w wall points known O(w log n); the first question after stars were added one
//             union, O(c log c) for c corners, and an index; every other question O(edges near by)
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class Outline {
 public:
  /// `size`: of the robot (its radius, say).
  explicit Outline(double size) : size_(size) {}

  /// Counter-clockwise about `eye` from the direction of the x axis, relative to it; of a scan with so many rays.
  void add(const Ring& star, const Point& eye, std::size_t rays);
  /// Places seen from `eye` where there is no free space: hits, and corners known exactly. Returns whether something was
  /// free that is no longer.
  bool add_walls(const std::vector<Point>& hits, const std::vector<Point>& corners, const Point& eye);

  /// What is free, less up to size / 128 at walls for having fewer corners; coarse: up to size / 32.
  const Region& region(bool coarse = false) const;
  /// The disc of `radius`, moved from a to b, stays in what is free.
  bool free_for(const Point& a, const Point& b, double radius) const;

 private:
  struct Star {
    Point eye{0, 0};
    Ring ring;                  // in the world
    std::vector<double> angle;  // of its corners, ascending
    double step = 0;            // radians between two rays
    double reach2 = 0;          // square of the farthest corner's distance
    std::vector<Box> cut_box;   // what does not count: in the box,
    std::vector<Region> cut;    // and between the two rays
    bool contains(const Point& p) const;
    bool says_free(const Point& p) const;
    void refute(const Point& p, const Box& box);
    Region sector(const Box& box) const;
  };
  Box about(const Point& p) const;
  bool is_free(const Point& p) const;
  void merge() const;

  double size_;
  std::vector<Star> stars_;
  std::vector<Point> walls_;
  std::unordered_set<std::uint64_t> seen_;               // squares that hold one of walls_: is there one, no more
  mutable std::vector<Region> pending_;                  // of the last stars
  mutable Region free_;                                  // of all others
  mutable std::optional<EdgeIndex> edges_;               // of free_
  mutable std::array<std::optional<Region>, 2> simple_;  // fine, coarse
};

}  // namespace oxturn
