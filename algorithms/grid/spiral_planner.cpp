#include "algorithms/grid/spiral_planner.hpp"

namespace oxturn {

Path walk_spirals(const Problem& problem, Context& context, const SpiralOptions& options,
                  const std::function<void(CellWalk&, WallFollower*)>& walk) {
  return walk_cells(problem, context, options, {.walls = options.partial}, [&](CellWalk& cells) {
    std::optional<WallFollower> walls;
    if (options.partial) walls.emplace(problem, cells.robot());
    walk(cells, walls ? &*walls : nullptr);
    if (walls) context.record("along_walls_m", walls->length());
  });
}

bool escape(CellWalk& walk, WallFollower* walls, bool left) {
  if (!walls) return walk.escape();
  while (walk.go_to([&](const Cell& c) { return walk.any_fresh(c) || walls->any_left(c); }))
    if (!walls->follow_on(walk, left) && walk.any_fresh()) return true;
  return false;
}

}  // namespace oxturn
