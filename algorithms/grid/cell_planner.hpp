/// Runs a planner that drives a CellRobot, on the true map or by lidar: what online grid planners share.
///
///   Path plan(const Problem& problem, Context& context) const override {
///     return walk_cells(problem, context, p_, {}, [&](CellWalk& walk) { Spirals(walk).run(); });
///   }
///
/// The lattice has a node at the start.
#pragma once

#include <functional>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/cell_walk.hpp"
#include "algorithms/lattice/grid_options.hpp"

namespace oxturn {

/// What a planner asks of its robot.
struct CellNeeds {
  int reach = 1;           // how far it feels, in cells
  bool diagonals = false;  // it leaves the lattice on straight segments (CellRobot::straight)
  bool walls = false;      // it follows walls (WallFollower): on the map only
  bool all_cells = true;   // it promises to visit every cell that free lattice edges connect to the start
};

/// `drive` moves the robot from the start on and returns when it is done. Throws Infeasible if the robot cannot leave
/// the start's cell, Unsupported for sensing = lidar without a lidar.
Path drive_cells(const Problem& problem, Context& context, const CellOptions& options, const CellNeeds& needs,
                 const std::function<void(CellRobot&)>& drive);
/// The same for a planner that needs the robot's memory; records `cells` and `moves`.
Path walk_cells(const Problem& problem, Context& context, const CellOptions& options, const CellNeeds& needs,
                const std::function<void(CellWalk&)>& walk);

}  // namespace oxturn
