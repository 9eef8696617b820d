#include "algorithms/grid/driven_nodes.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/grid/lane.hpp"

namespace oxturn {
namespace {

constexpr double kOff = 1e-3;  // cells

}  // namespace

DrivenNodes::DrivenNodes(const GridGraph& graph)
    : graph_(graph),
      columns_{true, graph.columns(), graph.rows()},
      rows_{false, graph.rows(), graph.columns()},
      along_column_(graph.size(), false),
      along_row_(graph.size(), false) {}

void DrivenNodes::add(const Point& from, const Point& to) {
  const Point a = graph_.coordinates(from), b = graph_.coordinates(to);
  if (std::abs(a.x() - b.x()) <= kOff) mark(columns_, a.x(), a.y(), b.y());
  if (std::abs(a.y() - b.y()) <= kOff) mark(rows_, a.y(), a.x(), b.x());
}

void DrivenNodes::mark(const Lines& lines, double at, double from, double to) {
  const int line = static_cast<int>(std::lround(at));
  if (std::abs(at - line) > kOff || line < 0 || line >= lines.count) return;
  const int low = std::max(0, static_cast<int>(std::ceil(std::min(from, to) - kOff)));
  const int high = std::min(lines.length - 1, static_cast<int>(std::floor(std::max(from, to) + kOff)));
  std::vector<bool>& driven = lines.upright ? along_column_ : along_row_;
  for (int k = low; k <= high; ++k) driven[node_of(graph_, lines.upright, line, k)] = true;
}

void DrivenNodes::fill_between(const Lines& lines, int cells, std::vector<bool>& done) const {
  const std::vector<bool>& driven = lines.upright ? along_column_ : along_row_;
  for (int k = 0; k < lines.length; ++k) {
    int last = -cells - 1;  // driven line
    for (int line = 0; line < lines.count; ++line) {
      if (!driven[node_of(graph_, lines.upright, line, k)]) continue;
      for (int between = line - last <= cells ? last : line; between <= line; ++between)
        done[node_of(graph_, lines.upright, between, k)] = true;
      last = line;
    }
  }
}

std::vector<bool> DrivenNodes::covered(int cells) const {
  std::vector<bool> done(graph_.size(), false);
  fill_between(columns_, cells, done);
  fill_between(rows_, cells, done);
  return done;
}

}  // namespace oxturn
