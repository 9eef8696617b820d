/// Which nodes of a lattice a path has driven along columns and rows, and which lie under the tool between such lanes.
///
///   DrivenNodes driven(graph);
///   driven.add(a, b);                                  // a segment that is driven with the tool on
///   const std::vector<bool> done = driven.covered(2);  // by node; a tool as wide as two cells
///
/// O(nodes) memory; add() takes the nodes on the segment, covered() all nodes.
#pragma once

#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

class DrivenNodes {
 public:
  /// `graph` must outlive it.
  explicit DrivenNodes(const GridGraph& graph);
  /// Segments that do not run along a column or a row of nodes (within a thousandth of a cell) are ignored.
  void add(const Point& a, const Point& b);
  /// The nodes driven, and those between two driven ones in parallel lanes at most `cells` apart: a tool so many cells
  /// wide covers their cells from both sides.
  std::vector<bool> covered(int cells) const;

 private:
  /// Columns are upright lines, rows are not.
  struct Lines {
    bool upright;
    int count, length;
  };
  void mark(const Lines& lines, double line, double from, double to);
  void fill_between(const Lines& lines, int cells, std::vector<bool>& done) const;

  const GridGraph& graph_;
  Lines columns_, rows_;
  std::vector<bool> along_column_, along_row_;
};

}  // namespace oxturn
