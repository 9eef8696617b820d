/// MyCarbot (TH Nuernberg) in a known world: partitions it, drives from rectangle to rectangle and cleans each column
/// by column.
///
///   RectangleCleaner cleaner(options, problem, graph, std::vector<bool>(graph.size(), false), context);
///   Path path = cleaner.clean();
///
/// Costs: see rectangles.cpp.
#pragma once

#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/rectangle_world.hpp"
#include "algorithms/lattice/grid_options.hpp"
#include "algorithms/lattice/lattice_paths.hpp"

namespace oxturn {

enum class NextRectangle { first, nearest };
enum class ColumnStep { each, tool };
enum class Lanes { straight, diagonal };

/// Parameters of `rectangles`; what they mean is in its description.
struct RectangleOptions : CellOptions {
  NextRectangle choose = NextRectangle::first;
  ColumnStep columns = ColumnStep::each;
  ScanOrder scan = ScanOrder::columns;
  Lanes lanes = Lanes::straight;
  int smallest = 2;
  int gap = 1;
  int small_obstacle = 4;
  int shift = 4;
  bool via_centre = true;
  bool revisit_skipped = false;

  /// Metres: `cell_size`, or half the robot's width if that is 0.
  double side(const Robot& robot) const;
};

/// One run.
class RectangleCleaner {
 public:
  /// `graph`: the lattice over the problem's configuration space. `done`: nodes that have been cleaned before. All but
  /// `done` must outlive the cleaner.
  RectangleCleaner(const RectangleOptions& options, const Problem& problem, const GridGraph& graph,
                   std::vector<bool> done, Context& context);

  /// Empty if no rectangle can be driven.
  Path clean();

  struct Counts {
    std::size_t rectangles = 0;       // driven
    std::size_t skipped_columns = 0;  // where the robot does not fit
    std::size_t skipped_cells = 0;    // in skipped columns and below shifted starts
    std::size_t small_cells = 0;      // in rectangles that are too small to be driven
  };
  const Counts& counts() const { return counts_; }

 private:
  /// Lattice nodes in one column that can be driven without leaving it.
  struct Run {
    int column, low, high;
  };
  struct Job {
    CellRectangle rectangle;
    Run start;
  };
  enum class Approach { work_if_short, transit };
  BitGrid dirty_cells() const;
  std::vector<Run> runs(int i, int bottom, int top) const;
  std::vector<Run> uncleaned_lanes() const;
  std::optional<Run> start_of(CellRectangle& r) const;
  std::vector<Job> jobs();
  std::size_t start_node(const Job& job) const { return graph_.at(job.start.column, job.start.low); }
  bool begin(const std::vector<Job>& jobs);
  void clean_jobs_in_order(const std::vector<Job>& jobs);
  void clean_jobs_nearest_first(const std::vector<Job>& jobs);
  void clean_job(const Job& job, std::size_t number, std::size_t of);
  void clean_lanes();
  void clean_rectangle(const Job& job);
  void drive(const Run& run, bool up, Approach approach);
  void go(std::size_t node, Approach approach, double tail);
  void go_among_walls(double tail);
  void go_along(Polyline path, double tail);
  void revisit();
  void skip(int column, int bottom, int top);
  void trace_rectangles(const std::vector<CellRectangle>& rectangles);

  const RectangleOptions& p_;
  const Problem& problem_;
  const GridGraph& graph_;
  Context& context_;
  LatticePaths paths_;
  double side_;
  std::vector<bool> done_;
  std::size_t at_ = 0;  // the node where the path ends
  Counts counts_;
  std::vector<Polyline> skipped_;
  PathBuilder path_;
};

}  // namespace oxturn
