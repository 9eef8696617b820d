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

/// By cell of the grid, whether it is horizontal.
std::vector<bool> horizontal_cells(const BitGrid& cells, bool compact) {
  std::vector<std::size_t> vertex(cells.bits.size(), 0);
  std::size_t n = 0;
  for (std::size_t c = 0; c < vertex.size(); ++c)
    if (cells.bits[c] != 0) vertex[c] = Cut::kFirst + n++;
  // A pair of different neighbours costs less than any run: there are at most 2 n pairs.
  const Capacity run = compact ? 8 * static_cast<Capacity>(n) : 1, pair = compact ? 1 : 0;
  Cut cut(n);
  for (int j = 0; j < cells.rows; ++j)
    for (int i = 0; i < cells.columns; ++i) {
      if (!cells.get(i, j)) continue;
      const std::size_t at = vertex[cells.at(i, j)];
      if (cells.get(i + 1, j))
        cut.add(at, vertex[cells.at(i + 1, j)], run + pair, pair);
      else
        cut.add(at, Cut::kSink, run, 0);
      if (cells.get(i, j - 1))
        cut.add(vertex[cells.at(i, j - 1)], at, run + pair, pair);
      else
        cut.add(Cut::kSource, at, run, 0);
    }
  const std::vector<bool> side = cut.source_side();
  std::vector<bool> horizontal(cells.bits.size(), false);
  for (std::size_t c = 0; c < vertex.size(); ++c) horizontal[c] = cells.bits[c] != 0 && side[vertex[c]];
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
