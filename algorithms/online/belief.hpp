/// What an online robot believes of the world: an occupancy grid (free, occupied, unknown) that grows as the robot
/// drives and, without noise, the outline of what is free (outline.hpp), for which the grid is the quick answer.
///
///   Belief belief(robot, start);
///   belief.add(lidar.scan(start, rng));
///   if (belief.free_for(a, b, robot.radius)) ...       // the robot can drive straight from a to b
///
/// Without noise a cell is free when all of it lies in the star that one scan makes certain (star.hpp), in one of two
/// degrees: `near`, where rays are so close together that nothing is overlooked, and `far`, where something as narrow
/// as a quarter of the robot may be. A hit in a free cell closes it for good, and withdraws the far cells around it
/// until they are seen from near. So what is believed free is free in truth wherever the robot drives.
/// With noise near stars are evidence for a cell, hits are evidence against the cells around them. Stars keep a margin
/// of three standard deviations, and far ones count only where no evidence contradicts. A few wrong hits change little.
/// Certainty requires that two radii around the robot are near: 200 rays. With fewer, details narrower than the
/// distance between rays may be touched.
/// The lattice is placed by the start, so it reveals nothing of the map's extent; the window grows with what is seen.
/// Resolution   radius / 16 (with noise half its standard deviation, between radius / 32 and radius / 4); twice as
///              coarse each time the window would exceed 2^26 cells
/// Complexity   a scan O(cells that it sees), a few bytes each; region() O(window), or one union of the stars since the
///              last call
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "algorithms/online/lidar.hpp"
#include "algorithms/online/outline.hpp"
#include "geometry/raster.hpp"
#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {

class Belief {
 public:
  /// The robot is at `start`: its own disc is free. `robot.lidar` must be given.
  Belief(const Robot& robot, const Point& start);

  void add(const Scan& scan);

  /// Changes whenever a cell becomes free or ceases to be.
  std::uint64_t revision() const { return gained_ + lost_; }
  /// How many free cells have been closed.
  std::uint64_t lost() const { return lost_; }
  /// How many cells have become free.
  std::uint64_t gained() const { return gained_; }

  double cell() const { return cell_; }
  /// The disc of `radius`, moved from a to b, touches free cells only, or stays within the outline. With noise one and
  /// a half cells at its boundary do not count: they flicker, and the margin of the stars is larger.
  bool free_for(const Point& a, const Point& b, double radius) const;

  /// The coarsest level: cells of side cell() * 2^level.
  static constexpr int kCoarsest = 3;
  struct Cells {
    BitGrid free, wall;  // wall: a part of it is wall; neither: unknown
  };
  /// Cells of a coarser level are free if all of their cells are. Valid until the next add().
  const Cells& cells(int level) const;
  /// Without noise the outline, less up to radius / 128 at its walls (radius / 32 at coarser levels); else the free
  /// cells with fewer vertices, less up to 1.1 cells.
  const Region& region(int level) const;
  /// No scan makes anything farther away free: there rays are more than half a radius apart.
  double trusted_range() const;

 private:
  // Marks of a cell. Far and near: it lies in a star of that degree.
  static constexpr std::uint8_t kFar = 1, kNear = 2;
  // Without noise, a hit: the cell is not free. With noise: far stars do not count here.
  static constexpr std::uint8_t kHit = 4;
  static constexpr std::uint8_t kWall = 8;         // on a chord between hits of one wall
  static constexpr std::uint8_t kDistrusted = 16;  // with noise: distrust() has been called for a hit nearby

  // Evidence, with noise: what a near star and a hit add, and its limits.
  static constexpr int kFor = 2, kAgainst = -4, kMost = 20;
  // A cell is free from this evidence on; with evidence from 0 on, a far star is enough.
  static constexpr int kFreeFrom = 2;

  static constexpr int kBlock = 64;  // cells in a row that are marked together; windows begin and end at multiples

  /// Cells [i0, i1) x [j0, j1) of the lattice.
  struct Bounds {
    std::int64_t i0 = 0, j0 = 0, i1 = 0, j1 = 0;
    std::int64_t columns() const { return i1 - i0; }
    std::int64_t rows() const { return j1 - j0; }
    bool contains(const Bounds& o) const { return o.i0 >= i0 && o.j0 >= j0 && o.i1 <= i1 && o.j1 <= j1; }
    bool contains(std::int64_t i, std::int64_t j) const { return i >= i0 && j >= j0 && i < i1 && j < j1; }
    /// Enlarged to multiples of `step`.
    Bounds aligned(std::int64_t step) const;
  };
  struct CellState {
    std::uint8_t mark;
    std::int8_t weight;
  };
  /// A scan's star and the degree of its certainty.
  struct RatedStar {
    Ring ring;  // relative to the eye
    std::uint8_t mark;
  };
  /// A row of a ring that is being filled in.
  struct Row {
    std::vector<double> crossings;           // of edges with the line through the cells' centres
    std::vector<std::pair<int, int>> edges;  // columns that an edge comes near
  };

  bool noisy() const { return lidar_.noise > 0; }
  double far_apart() const { return size_ / 2; }
  double near_apart() const { return size_ / 16; }
  // belief_window.cpp
  void grow(const Point& low, const Point& high);
  Bounds with_spare(const Bounds& wanted) const;
  void copy_to(const Bounds& bounds, std::vector<std::uint8_t>& mark, std::vector<std::int8_t>& weight) const;
  void merge_to(const Bounds& bounds, int block, std::vector<std::uint8_t>& mark,
                std::vector<std::int8_t>& weight) const;
  CellState merged(std::int64_t i, std::int64_t j, int block) const;
  // belief_fill.cpp
  bool fill(const Ring& ring, const Point& eye, std::uint8_t mark);
  void add_edge(const Point& p, const Point& q, int first, int last);
  void fill_row(int j, Row& row, std::uint8_t mark);
  void mark_span(int j, int from, int to, std::uint8_t mark);
  bool weigh(std::size_t begin, std::size_t end);
  void set_marks(std::size_t begin, std::size_t end, std::uint8_t mark);
  // belief.cpp
  void mark_own_disc(const Point& pose);
  std::array<RatedStar, 2> stars_of(const Scan& scan, std::vector<Point>& corners) const;
  void mark_hits(const Scan& scan, const std::vector<Point>& walls);
  void mark_exact_hit(int i, int j);
  void mark_noisy_hit(int i, int j, bool near);
  void mark_walls(const Scan& scan);
  void distrust(int i, int j);
  bool free_by_cells(const Point& a, const Point& b, double radius) const;
  bool free_span(int j, int from, int to) const;
  bool is_free(std::size_t c) const;
  std::uint64_t free_word(std::size_t c) const;
  template <class F>
  void for_each_cell_around(int i, int j, int reach, F f);

  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  std::size_t block_at(int i, int j) const { return at(i, j) / kBlock; }
  int column(double x) const { return static_cast<int>(std::floor((x - low_.x()) / cell_)); }
  int row(double y) const { return static_cast<int>(std::floor((y - low_.y()) / cell_)); }
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_; }

  Lidar lidar_;
  double radius_, size_, tolerance_;  // size_: the radius, or half the tool of a robot without one
  std::vector<Point> direction_;      // of the rays
  Point lattice_{0, 0}, low_{0, 0};   // lower left of lattice cell (0, 0), and of the window
  double cell_;
  Bounds window_;
  int columns_ = 0, rows_ = 0;  // of the window
  std::vector<std::uint8_t> mark_;
  std::vector<std::int8_t> weight_;       // with noise: evidence
  std::vector<std::uint8_t> block_mark_;  // of each block: the marks that all of its cells have
  std::uint64_t gained_ = 0, lost_ = 0;
  std::vector<Row> scratch_;
  mutable std::array<std::optional<Cells>, kCoarsest + 1> cells_;
  mutable std::array<std::optional<Region>, kCoarsest + 1> regions_;
  std::optional<Outline> outline_;  // without noise
  bool marked_anew_ = false;        // by the star that is being filled in
};

}  // namespace oxturn
