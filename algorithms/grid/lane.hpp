/// Nodes of a lattice in one column, or one row.
///
///   const Lane lane{true, 3, 0, 7};                        // column 3, rows 0 to 7
///   const std::size_t end = node_of(graph, lane, lane.high);
#pragma once

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

struct Lane {
  bool upright;         // in a column
  int line, low, high;  // a column and rows, or a row and columns
};

inline std::size_t node_of(const GridGraph& graph, bool upright, int line, int along) {
  return upright ? graph.at(line, along) : graph.at(along, line);
}
inline std::size_t node_of(const GridGraph& graph, const Lane& lane, int along) {
  return node_of(graph, lane.upright, lane.line, along);
}

}  // namespace oxturn
