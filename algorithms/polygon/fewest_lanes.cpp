#include "algorithms/polygon/fewest_lanes.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>
#include <cstdint>

namespace oxturn {
namespace {

using Capacity = std::int64_t;
using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
struct FlowVertex {
  boost::default_color_type color{};
  Capacity distance = 0;
  Traits::edge_descriptor predecessor{};
};
struct FlowEdge {
  Capacity capacity = 0, residual = 0;
  Traits::edge_descriptor reverse{};
};
using FlowGraph = boost::adjacency_list<boost::vecS, boost::vecS, boost::directedS, FlowVertex, FlowEdge>;

/// A minimum cut between the first two vertices.
class Cut {
 public:
  static constexpr std::size_t kSource = 0, kSink = 1, kFirst = 2;
  explicit Cut(std::size_t vertices) : graph_(vertices + kFirst) {}

  void add(std::size_t a, std::size_t b, Capacity forwards, Capacity backwards) {
    const auto there = boost::add_edge(a, b, graph_).first, back = boost::add_edge(b, a, graph_).first;
    graph_[there] = {forwards, 0, back};
    graph_[back] = {backwards, 0, there};
  }
  /// For each vertex whether it is on the source's side: those that the residual graph reaches. The smallest such
  /// side, so it does not depend on how the flow was found.
  std::vector<bool> source_side() {
    boost::boykov_kolmogorov_max_flow(graph_, get(&FlowEdge::capacity, graph_), get(&FlowEdge::residual, graph_),
                                      get(&FlowEdge::reverse, graph_), get(&FlowVertex::predecessor, graph_),
                                      get(&FlowVertex::color, graph_), get(&FlowVertex::distance, graph_),
                                      get(boost::vertex_index, graph_), kSource, kSink);
    std::vector<bool> reached(num_vertices(graph_), false);
    std::vector<std::size_t> open{kSource};
    reached[kSource] = true;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      for (const auto e : boost::make_iterator_range(out_edges(at, graph_)))
        if (const std::size_t to = target(e, graph_); graph_[e].residual > 0 && !reached[to]) {
          reached[to] = true;
          open.push_back(to);
        }
    }
    return reached;
  }

 private:
  FlowGraph graph_;
};

/// The first line of each band of lines that are as the one before; at the end, how many lines there are.
template <class SameAsBefore>
std::vector<int> bands(int lines, SameAsBefore same) {
  std::vector<int> first;
  for (int k = 0; k < lines; ++k)
    if (k == 0 || !same(k)) first.push_back(k);
  first.push_back(lines);
  return first;
}

std::vector<int> bands_of_columns(const BitGrid& cells) {
  return bands(cells.columns, [&](int i) {
    int j = 0;
    while (j < cells.rows && cells.get(i, j) == cells.get(i - 1, j)) ++j;
    return j == cells.rows;
  });
}
std::vector<int> bands_of_rows(const BitGrid& cells) {
  return bands(cells.rows, [&](int j) {
    int i = 0;
    while (i < cells.columns && cells.get(i, j) == cells.get(i, j - 1)) ++i;
    return i == cells.columns;
  });
}

/// By cell of the grid, whether it is horizontal. A band's lines are alike in the answer, so each block of cells in two
/// bands is one vertex: if the lines c and d of a band differ in a smallest minimum M, let C and D be M with both as c
/// or both as d. Together these cost no more than M twice (what differs between lines obeys the triangle inequality),
/// so both are minima and contain M: c lies in d, and d in c.
std::vector<bool> horizontal_cells(const BitGrid& cells, bool compact) {
  const std::vector<int> columns = bands_of_columns(cells), rows = bands_of_rows(cells);
  const auto block = [&](std::size_t i, std::size_t j) { return j * columns.size() + i; };
  std::vector<std::size_t> vertex(columns.size() * rows.size(), 0);
  std::size_t blocks = 0;
  Capacity n = 0;
  const auto for_each_block = [&](auto f) {
    for (std::size_t j = 0; j + 1 < rows.size(); ++j)
      for (std::size_t i = 0; i + 1 < columns.size(); ++i)
        if (cells.get(columns[i], rows[j])) f(i, j, columns[i + 1] - columns[i], rows[j + 1] - rows[j]);
  };
  for_each_block([&](std::size_t i, std::size_t j, int width, int height) {
    vertex[block(i, j)] = Cut::kFirst + blocks++;
    n += Capacity{width} * height;
  });
  // A pair of different neighbours costs less than any run: there are at most 2 n pairs.
  const Capacity run = compact ? 8 * n : 1, pair = compact ? 1 : 0;
  Cut cut(blocks);
  for_each_block([&](std::size_t i, std::size_t j, int width, int height) {
    const std::size_t at = vertex[block(i, j)];
    if (cells.get(columns[i + 1], rows[j]))
      cut.add(at, vertex[block(i + 1, j)], height * (run + pair), height * pair);
    else
      cut.add(at, Cut::kSink, height * run, 0);
    if (cells.get(columns[i], rows[j] - 1))
      cut.add(vertex[block(i, j - 1)], at, width * (run + pair), width * pair);
    else
      cut.add(Cut::kSource, at, width * run, 0);
  });
  const std::vector<bool> side = cut.source_side();
  std::vector<bool> horizontal(cells.bits.size(), false);
  for_each_block([&](std::size_t i, std::size_t j, int, int) {
    for (int y = rows[j]; y < rows[j + 1]; ++y)
      for (int x = columns[i]; x < columns[i + 1]; ++x) horizontal[cells.at(x, y)] = side[vertex[block(i, j)]];
  });
  return horizontal;
}

}  // namespace

std::vector<CellRun> fewest_runs(const BitGrid& cells, bool compact) {
  const std::vector<bool> horizontal = horizontal_cells(cells, compact);
  std::vector<CellRun> runs;
  for (const bool along_rows : {true, false}) {
    const int lines = along_rows ? cells.rows : cells.columns, length = along_rows ? cells.columns : cells.rows;
    for (int line = 0; line < lines; ++line) {
      bool open = false;
      for (int k = 0; k < length; ++k) {
        const int i = along_rows ? k : line, j = along_rows ? line : k;
        const bool in = cells.get(i, j) && horizontal[cells.at(i, j)] == along_rows;
        if (in && open) runs.back().last = k;
        if (in && !open) runs.push_back({along_rows, line, k, k});
        open = in;
      }
    }
  }
  return runs;
}

}  // namespace oxturn
