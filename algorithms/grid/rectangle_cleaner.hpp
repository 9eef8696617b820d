// MyCarbot in a known world: partition it, go from rectangle to rectangle, clean each column by column.
#pragma once

#include <string>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/lattice_paths.hpp"
#include "algorithms/grid/rectangle_world.hpp"

namespace oxturn {

struct RectangleSettings {
  double cell_size = 0;
  std::string choose = "first";
  std::string columns = "each";
  std::string scan = "columns";
  std::string lanes = "straight";
  int smallest = 2;
  int gap = 1;
  int small_obstacle = 4;
  int shift = 4;
  bool via_centre = true;
  bool revisit_skipped = false;
  std::string align = "axes";

  double side(const Robot& robot) const;
};

/// One run. `graph`: the lattice over the problem's configuration space. `done`: nodes that have been cleaned before.
class RectangleCleaner {
 public:
  RectangleCleaner(const RectangleSettings& settings, const Problem& problem, const GridGraph& graph,
                   std::vector<bool> done, Context& context);

  /// Empty if no rectangle can be driven.
  Path clean();

  struct Counts {
    std::size_t rectangles = 0;       // that were driven
    std::size_t skipped_columns = 0;  // no place for the robot, in these
    std::size_t skipped_cells = 0;    // in skipped columns and below shifted starts
    std::size_t small_cells = 0;      // in rectangles that are too small to be driven
  };
  const Counts& counts() const { return counts_; }

 private:
  // A run of lattice nodes in one column that can be driven without leaving it.
  struct Stretch {
    int column, low, high;
  };
  struct Job {
    CellRectangle rectangle;
    Stretch start;
  };
  BitGrid dirty_cells() const;
  std::vector<Stretch> stretches(int i, int bottom, int top) const;
  std::optional<Stretch> start_of(CellRectangle& r);
  std::vector<Job> jobs();
  bool begin(const std::vector<Job>& jobs);
  void clean_all(const std::vector<Job>& jobs);
  void clean_lanes();
  void clean(const Job& job);
  void drive(const Stretch& stretch, bool up, bool may_work);
  void go(std::size_t node, bool may_work, double tail);
  void go_among_walls(double tail);
  void go_along(Polyline way, double tail);
  void revisit();
  void skip(int column, int bottom, int top);
  Point place(std::size_t node) const;
  std::vector<Polyline> outlines(const std::vector<CellRectangle>& rectangles) const;

  const RectangleSettings& p_;
  const Problem& problem_;
  const GridGraph& graph_;
  Context& context_;
  LatticePaths ways_;
  double side_;
  std::vector<bool> done_;
  std::size_t at_ = 0;  // the node where the path ends
  Counts counts_;
  std::vector<Polyline> skipped_;
  PathBuilder path_;
};

}  // namespace oxturn
