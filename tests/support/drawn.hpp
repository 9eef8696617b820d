// Maps drawn in letters: '#' wall, '.' or ' ' free, 'S' free and the start, 'A' free and the anchor. The first row
// is the top; the lower left corner of the drawing is (0, 0); a letter is a square of side `cell`, 1 m by default.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/raster.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct DrawnMap {
  double cell = 1;
  Robot robot = {};  // radius 0.2, tool 0.4
  std::optional<Point> start = {}, anchor = {};
  std::string name = "drawn";
};

inline BitGrid drawn_grid(const std::vector<std::string>& rows, double cell = 1) {
  BitGrid grid({0, 0}, cell, static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int j = 0; j < grid.rows; ++j) {
    const std::string& row = rows[rows.size() - 1 - static_cast<std::size_t>(j)];
    if (row.size() != rows.front().size()) throw std::logic_error("drawn: rows of different length");
    for (int i = 0; i < grid.columns; ++i) grid.set(i, j, row[static_cast<std::size_t>(i)] != '#');
  }
  return grid;
}

inline Region drawn_region(const std::vector<std::string>& rows, double cell = 1) {
  return trace(drawn_grid(rows, cell));
}

/// The middle of the first such letter.
inline std::optional<Point> drawn_point(const std::vector<std::string>& rows, char letter, double cell = 1) {
  for (std::size_t row = 0; row < rows.size(); ++row)
    if (const std::size_t i = rows[row].find(letter); i != std::string::npos)
      return Point(cell * (static_cast<double>(i) + 0.5), cell * (static_cast<double>(rows.size() - 1 - row) + 0.5));
  return std::nullopt;
}

inline Problem drawn(const std::vector<std::string>& rows, const DrawnMap& how = {}) {
  Map map{how.name, drawn_region(rows, how.cell), "drawn", "drawn"};
  return Problem(std::move(map), how.robot, how.start ? how.start : drawn_point(rows, 'S', how.cell),
                 how.anchor ? how.anchor : drawn_point(rows, 'A', how.cell));
}

}  // namespace oxturn
