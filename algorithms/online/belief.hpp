// What an online robot believes of the world, grown as the robot goes: an occupancy grid (free, occupied, unknown) and,
// without noise, the outline of what is free (outline.hpp), to which the grid is the quick answer.
//
// Without noise a cell is free when all of it lies in the star that one scan makes certain (star.hpp), in one of two
// degrees: `near`, where rays are so close together that nothing is overlooked, and `far`, where something as narrow as
// a quarter of the robot may be. A hit in a free cell closes it for good, and takes the far ones about it back until
// they are seen from near. So what is believed free is free in truth wherever the robot goes.
// With noise near stars are evidence for a cell, hits against those about them; stars keep a margin of three standard
// deviations, and far ones count only where nothing speaks against them. A few wrong hits change little.
// Certainty needs rays close enough together for two radii about the robot to be near: 200 of them. With fewer,
// details narrower than the rays are apart may be touched.
// The lattice hangs on the start, so it says nothing of the map's extent; the window grows with what is seen.
// Resolution   radius / 16 (noise: half its standard deviation, from radius / 32 to radius / 4); twice as coarse each time
//              the window would exceed 2^26 cells.
// Complexity   a scan O(cells that it sees), a few bytes each; region() O(window), or one union of the stars since the
//              last call
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
  /// The robot stands at `start`: its own disc is free. `robot.lidar` must be there.
  Belief(const Robot& robot, const Point& start);

  void add(const Scan& scan);

  /// Changes whenever any cell becomes free, or is free no longer.
  std::uint64_t revision() const { return gained_ + lost_; }
  /// How many free cells have been closed.
  std::uint64_t lost() const { return lost_; }
  /// How many cells have become free.
  std::uint64_t gained() const { return gained_; }

  double cell() const { return cell_; }
  /// The disc of `radius`, moved from a to b, touches free cells only, or stays within the outline.
  /// With noise cells at its rim (one and a half) do not count: they flicker, and the stars' margin is larger.
  bool free_for(const Point& a, const Point& b, double radius) const;

  /// The coarsest level that is offered: cells of side cell() * 2^level.
  static constexpr int kCoarsest = 3;
  enum class State : std::uint8_t { unknown, free, occupied };
  struct Cells {
    BitGrid free, wall;  // wall: something of it is a wall; neither: unknown
  };
  /// Cells of a coarser level are free if all of their cells are. Valid until the next add().
  const Cells& cells(int level) const;
  /// Without noise the outline, less up to radius / 128 at its walls (radius / 32 at coarser levels); else the free cells
  /// with fewer corners, less up to 1.1 cells.
  const Region& region(int level) const;
  double free_area() const;
  /// What is farther off than this, no scan makes free: there rays are more than half a radius apart.
  double trusted_range() const;

 private:
  double far_apart() const { return size_ / 2; }
  double near_apart() const { return size_ / 16; }
  struct Row {
    std::vector<double> crossings;
    std::vector<std::pair<int, int>> cuts;
  };
  void grow(const Point& low, const Point& high);
  bool fill(const Ring& ring, const Point& eye, std::uint8_t mark);
  void mark_span(int j, int from, int to, std::uint8_t mark);
  void stand(const Point& pose);
  void mark_hits(const Scan& scan, const std::vector<Point>& walls);
  void mark_walls(const Scan& scan);
  void distrust(int i, int j);
  bool weigh(std::size_t begin, std::size_t end);
  bool set_marks(std::size_t begin, std::size_t end, std::uint8_t mark);
  std::size_t block_at(int i, int j) const;
  bool free_span(int j, int from, int to) const;
  bool is_free(std::size_t c) const;
  std::uint64_t free_word(std::size_t c) const;
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  int column(double x) const { return static_cast<int>(std::floor((x - low_.x()) / cell_)); }
  int row(double y) const { return static_cast<int>(std::floor((y - low_.y()) / cell_)); }
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < columns_ && j < rows_; }

  Lidar lidar_;
  double radius_, size_, tolerance_;  // size_: the radius, or half the tool of a robot without one
  std::vector<Point> direction_;
  Point lattice_{0, 0}, low_{0, 0};  // low_: corner of the window
  double cell_;
  std::int64_t i0_ = 0, j0_ = 0;  // the window's first cell, on the lattice
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> mark_;   // bits, see belief.cpp
  std::vector<std::int8_t> weight_;  // with noise: evidence
  std::vector<std::uint8_t> done_;   // of blocks in a row: the marks that all of its cells have
  std::uint64_t gained_ = 0, lost_ = 0;
  std::vector<Row> scratch_;
  mutable std::array<std::optional<Cells>, kCoarsest + 1> cells_;
  mutable std::array<std::optional<Region>, kCoarsest + 1> regions_;
  std::optional<Outline> outline_;  // without noise
  bool marked_anew_ = false;        // by the star that is being filled in
};

}  // namespace oxturn
