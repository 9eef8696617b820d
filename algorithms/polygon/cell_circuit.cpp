#include "algorithms/polygon/cell_circuit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/polygon/cell_strips.hpp"
#include "algorithms/polygon/postman.hpp"
#include "base/disjoint_sets.hpp"

namespace oxturn {
namespace {

using Cells = std::vector<BoustrophedonCell>;

/// One side of a cell, where it meets others.
struct End {
  double low, high;
};
End left_end(const BoustrophedonCell& c) { return {c.lower.front().y(), c.upper.front().y()}; }
End right_end(const BoustrophedonCell& c) { return {c.lower.back().y(), c.upper.back().y()}; }

/// The height at which cells that begin (or end) together are parted, if there are several.
std::optional<double> parting(std::vector<End> ends) {
  if (ends.size() < 2) return std::nullopt;
  std::ranges::sort(ends, {}, &End::low);
  return (ends[0].high + ends[1].low) / 2;
}

/// y of a chain just right of x.
double height_after(const Polyline& chain, double x) {
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (chain[i - 1].x() <= x && x < chain[i].x()) {
      const double t = (x - chain[i - 1].x()) / (chain[i].x() - chain[i - 1].x());
      return std::lerp(chain[i - 1].y(), chain[i].y(), t);
    }
  return chain.back().y();
}

/// How high a vertex lies between floor and ceiling at an end of a cell.
double share_at(const End& end, const Point& vertex) {
  const double size = end.high - end.low;
  return size > 0 ? std::clamp((vertex.y() - end.low) / size, 0.0, 1.0) : 0.5;
}

/// The vertex nearest to a point, of those with edges that are not driven yet.
std::optional<std::size_t> nearest_start(const ReebGraph& graph, const std::vector<bool>& driven, const Point& from) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < driven.size(); ++c)
    for (const std::size_t v : {graph.left[c], graph.right[c]})
      if (const double d = distance(graph.at[v], from); !driven[c] && d < least) {
        least = d;
        best = v;
      }
  return best;
}

}  // namespace

ReebGraph reeb_graph(const Cells& cells) {
  const std::size_t n = cells.size();
  DisjointSets sets(2 * n);  // end 2 c is the left one of cell c, 2 c + 1 the right one
  for (std::size_t c = 0; c < n; ++c)
    for (const std::size_t o : cells[c].neighbours)
      if (right_of(cells[c]) <= left_of(cells[o])) sets.unite(2 * c + 1, 2 * o);
  ReebGraph graph{std::vector<std::size_t>(n), std::vector<std::size_t>(n), {}};
  std::vector<std::size_t> number(2 * n, 2 * n);
  std::vector<std::vector<End>> beginning, ending;  // by vertex: left ends, right ends
  for (std::size_t e = 0; e < 2 * n; ++e) {
    std::size_t& vertex = number[sets.find(e)];
    if (vertex == 2 * n) {
      vertex = beginning.size();
      beginning.emplace_back();
      ending.emplace_back();
    }
    const BoustrophedonCell& cell = cells[e / 2];
    (e % 2 == 0 ? graph.left : graph.right)[e / 2] = vertex;
    if (e % 2 == 0)
      beginning[vertex].push_back(left_end(cell));
    else
      ending[vertex].push_back(right_end(cell));
    if (vertex == graph.at.size()) {
      const End end = e % 2 == 0 ? left_end(cell) : right_end(cell);
      graph.at.push_back({e % 2 == 0 ? left_of(cell) : right_of(cell), (end.low + end.high) / 2});
    }
  }
  for (std::size_t v = 0; v < graph.at.size(); ++v)
    for (const auto* ends : {&beginning[v], &ending[v]})
      if (const auto y = parting(*ends)) graph.at[v].y() = *y;
  return graph;
}

std::pair<BoustrophedonCell, BoustrophedonCell> halves(const BoustrophedonCell& cell, double left, double right) {
  std::vector<double> xs;
  for (const Polyline* chain : {&cell.lower, &cell.upper})
    for (const Point& p : *chain) xs.push_back(p.x());
  std::ranges::sort(xs);
  xs.erase(std::unique(xs.begin(), xs.end()), xs.end());
  const double x0 = left_of(cell), x1 = right_of(cell);
  Polyline curve;
  const auto add = [&](const Point& p) {
    if (curve.empty() || curve.back() != p) curve.push_back(p);
  };
  for (const double x : xs) {
    const double share = x1 > x0 ? std::lerp(left, right, (x - x0) / (x1 - x0)) : left;
    if (x > x0) add({x, std::lerp(height_on(cell.lower, x), height_on(cell.upper, x), share)});
    if (x < x1) add({x, std::lerp(height_after(cell.lower, x), height_after(cell.upper, x), share)});
  }
  return {{cell.lower, curve, {}}, {curve, cell.upper, {}}};
}

Cells cell_circuit(const Cells& cells, const Point& start) {
  const ReebGraph graph = reeb_graph(cells);
  std::vector<GraphEdge> edges;
  for (std::size_t c = 0; c < cells.size(); ++c)
    edges.push_back({graph.left[c], graph.right[c], right_of(cells[c]) - left_of(cells[c])});
  const std::vector<bool> twice = doubled_edges(graph.at.size(), edges);
  std::vector<bool> driven(cells.size(), false);
  Cells parts;
  Point at = start;
  while (const auto from = nearest_start(graph, driven, at)) {
    for (const EdgeVisit& visit : closed_tour(graph.at.size(), edges, twice, *from)) {
      const BoustrophedonCell& cell = cells[visit.edge];
      if (twice[visit.edge]) {
        auto [lower, upper] = halves(cell, share_at(left_end(cell), graph.at[graph.left[visit.edge]]),
                                     share_at(right_end(cell), graph.at[graph.right[visit.edge]]));
        parts.push_back(driven[visit.edge] ? std::move(upper) : std::move(lower));
      } else {
        parts.push_back({cell.lower, cell.upper, {}});
      }
      driven[visit.edge] = true;
    }
    at = graph.at[*from];
  }
  return parts;
}

}  // namespace oxturn
