/// The free space that scans without noise make certain, with its true corners: the union of their stars (star.hpp).
///
///   Outline outline(robot.radius);
///   outline.add(star, eye, rays);
///   if (outline.free_for(a, b, radius)) ...
///   const Region& free = outline.region();
///
/// An occupancy grid loses up to a cell at every wall, and has a vertex at every step of a slanted one. Here straight
/// walls stay straight, so what is planned on the outline covers what a plan on the true map would, with about as many
/// vertices. A star overlooks what is narrower than the distance between rays. So every wall point ever seen is
/// compared with every star, earlier and later ones. Where a wall point lies in a star, what that star says between the
/// two rays around the point is withdrawn, within a square of a quarter of the robot's size around it. No point that
/// was hit is free. Stars are shrunk by half a millionth: walls seen from several positions overlap, and rounding never
/// adds free space. Stars are united lazily, many at once.
/// A star of n vertices against w known wall points O(w log n); the first query after stars were added one union,
/// O(c log c) for c vertices, and an index; every other query O(edges nearby).
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

  /// A star, relative to `eye`, counter-clockwise from the direction of the x axis, of a scan with so many rays.
  void add(const Ring& star, const Point& eye, std::size_t rays);
  /// Points seen from `eye` where there is no free space: hits, and corners known exactly. Returns whether something
  /// ceased to be free.
  bool add_walls(const std::vector<Point>& hits, const std::vector<Point>& corners, const Point& eye);

  /// What is free, less up to size / 128 at walls to save vertices; coarse: up to size / 32. Where stars leave out a
  /// speck up to a quarter of the robot's size, and no wall has been seen near it, there is no obstacle: it would only
  /// be something to wind a tether around. free_for() leaves it out until a star contains it.
  const Region& region(bool coarse = false) const;
  /// The disc of `radius`, moved from a to b, stays in free space.
  bool free_for(const Point& a, const Point& b, double radius) const;

 private:
  /// What does not count of a star: a part of a box.
  struct Withdrawn {
    Box box;
    Region region;
  };
  struct Star {
    Point eye{0, 0};
    Ring ring;                  // in the world
    std::vector<double> angle;  // of its vertices, ascending
    double step = 0;            // radians between two rays
    double reach2 = 0;          // square of the farthest vertex's distance
    std::vector<Withdrawn> withdrawn;
    bool contains(const Point& p) const;
    bool says_free(const Point& p) const;
    void withdraw(const Point& p, const Box& box);
    Region sector(const Box& box) const;
    Region free_of(Region part, const Box& box) const;
    bool may_reach(const Box& box) const;
  };
  Box box_around(const Point& p) const;
  bool is_free(const Point& p) const;
  bool is_new(const Point& wall, double side);
  std::optional<Box> add_wall(const Point& p);
  void unite_again(const std::vector<Box>& boxes);
  void merge() const;
  Region without_specks(Region region) const;

  double size_;
  std::vector<Star> stars_;
  std::vector<Point> walls_;
  std::unordered_set<std::uint64_t> seen_;               // keys of squares that contain one of walls_
  mutable std::vector<Region> pending_;                  // of the last stars
  mutable Region free_;                                  // of all others
  mutable std::optional<EdgeIndex> edges_;               // of free_
  mutable std::array<std::optional<Region>, 2> simple_;  // fine, coarse
};

}  // namespace oxturn
