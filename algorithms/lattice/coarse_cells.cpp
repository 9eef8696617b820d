#include "algorithms/lattice/coarse_cells.hpp"

namespace oxturn {

CoarseCells::CoarseCells(const GridGraph& fine)
    : CellNumbers(fine.columns() / 2, fine.rows() / 2), fine_(fine), free_(size()), tree_(size(), 0) {
  for (int j = 0; j < rows_; ++j)
    for (int i = 0; i < columns_; ++i)
      free_[at(i, j)] = fine.passable(2 * i, 2 * j, kEast) && fine.passable(2 * i, 2 * j, kNorth) &&
                        fine.passable(2 * i + 1, 2 * j, kNorth) && fine.passable(2 * i, 2 * j + 1, kEast);
}

bool CoarseCells::adjacent(std::size_t c, Direction d) const {
  const int i = column(c), j = row(c), i2 = i + kColumnStep[d], j2 = j + kRowStep[d];
  if (i2 < 0 || j2 < 0 || i2 >= columns_ || j2 >= rows_ || !free_[c] || !free_[at(i2, j2)]) return false;
  switch (d) {
    case kEast:
      return fine_.passable(2 * i + 1, 2 * j, kEast) && fine_.passable(2 * i + 1, 2 * j + 1, kEast);
    case kNorth:
      return fine_.passable(2 * i, 2 * j + 1, kNorth) && fine_.passable(2 * i + 1, 2 * j + 1, kNorth);
    case kWest:
      return fine_.passable(2 * i, 2 * j, kWest) && fine_.passable(2 * i, 2 * j + 1, kWest);
    default:
      return fine_.passable(2 * i, 2 * j, kSouth) && fine_.passable(2 * i + 1, 2 * j, kSouth);
  }
}

std::vector<std::size_t> grow_breadth_first(CoarseCells& cells, std::size_t root, std::size_t deepest) {
  std::vector<std::size_t> queue{root};
  std::size_t depth = 0, end_of_depth = 1;
  for (std::size_t k = 0; k < queue.size() && depth < deepest; ++k) {
    for (const Direction d : kAllDirections) {
      if (!cells.adjacent(queue[k], d)) continue;
      const std::size_t to = cells.neighbour(queue[k], d);
      if (to == root || cells.linked(to)) continue;
      cells.link(queue[k], d);
      queue.push_back(to);
    }
    if (k + 1 == end_of_depth) {
      ++depth;
      end_of_depth = queue.size();
    }
  }
  return queue;
}

// Counter-clockwise inside each coarse cell, unless a tree edge leads out of it; so the tree stays on the left.
Direction round_step(const CoarseCells& cells, const Cell& at) {
  const bool west = at.i % 2 == 0, south = at.j % 2 == 0;  // which of the four sub-cells
  // Over the side of the coarse cell that is on the right of the path, if the tree crosses it.
  const Direction out = south ? (west ? kSouth : kEast) : (west ? kWest : kNorth);
  return cells.in_tree(cells.at(at.i / 2, at.j / 2), out) ? out : left_of(out);
}

std::vector<Direction> steps_around(const CoarseCells& cells, const Cell& first) {
  std::vector<Direction> steps;
  Cell at = first;
  do {
    steps.push_back(round_step(cells, at));
    at = neighbour(at, steps.back());
  } while (at != first);
  return steps;
}

Polyline round_tree(const GridGraph& fine, const CoarseCells& cells, const Cell& first, RoundPoints points) {
  Polyline line{fine.centre(first)};
  Cell at = first;
  std::optional<Direction> last;
  for (const Direction d : steps_around(cells, first)) {
    at = neighbour(at, d);
    if (last == d && points == RoundPoints::at_turns) line.pop_back();
    line.push_back(fine.centre(at));
    last = d;
  }
  return line;
}

std::vector<Polyline> tree_lines(const CoarseCells& cells) {
  std::vector<Polyline> lines;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const Direction d : {kEast, kNorth})
      if (cells.free(c) && cells.in_tree(c, d)) lines.push_back({cells.centre(c), cells.centre(cells.neighbour(c, d))});
  return lines;
}

}  // namespace oxturn
