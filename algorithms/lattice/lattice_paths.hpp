/// Paths over a lattice, from node to node and to the nearest node of a kind: for planners that move between very many
/// points. Nothing is triangulated, and a near goal costs only the nodes in between.
///
///   LatticePaths paths(graph, problem.walls());
///   Polyline path = paths.path(from, to);                         // empty: not connected
///   auto found = paths.nearest(from, [&](std::size_t node) { return uncovered[node]; });
///
/// Paths follow the lattice and are then pulled straight wherever that stays in configuration space, exactly. Those to
/// the nearest node of a kind have the fewest steps; those to a given node at most an eighth more (weighted A*: among
/// scattered obstacles the search for the very fewest would take ten times as long).
/// Build O(nodes), 9 bytes a node; a query O(nodes nearer than the answer).
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"
#include "base/graph_search.hpp"

namespace oxturn {

class LatticePaths {
 public:
  /// Both must outlive it.
  LatticePaths(const GridGraph& graph, const EdgeIndex& walls);

  /// The connected component of the lattice that contains the node; -1: the node is not free.
  int component(std::size_t node) const { return components_.of[node]; }
  Point centre(std::size_t node) const { return graph_.centre(column(node), row(node)); }
  /// The nearest free node at most 8 cells from p that can be reached straight.
  std::optional<std::size_t> node_near(const Point& p) const;
  /// The edge from a node to its neighbour is free.
  bool open(std::size_t node, Direction d) const { return (states_[node].open >> d & 1) != 0; }
  std::size_t neighbour(std::size_t node, Direction d) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + step_[static_cast<std::size_t>(d)]);
  }
  /// The path over these nodes, each a neighbour of the one before, pulled straight.
  Polyline along(const std::vector<std::size_t>& nodes) const;
  /// From node to node in at most 9/8 of the fewest steps; empty if the lattice does not connect them.
  Polyline path(std::size_t from, std::size_t to);
  struct Found {
    std::size_t node;
    Polyline path;
  };
  /// In the fewest steps to a node that is `wanted`.
  std::optional<Found> nearest(std::size_t from, const std::function<bool(std::size_t)>& wanted);
  /// The same from a point, by way of the node near it.
  std::optional<Found> nearest(const Point& from, const std::function<bool(std::size_t)>& wanted);

  /// How a search entered a node: by a step in one of the four directions, or it began there.
  static constexpr std::uint8_t kSource = 4;
  /// The nodes of the path by which a search reached `to`; entered(node) as above.
  template <class Entered>
  std::vector<std::size_t> nodes_to(std::size_t to, Entered entered) const {
    std::vector<std::size_t> nodes{to};
    while (entered(nodes.back()) != kSource)
      nodes.push_back(neighbour(nodes.back(), opposite(static_cast<Direction>(entered(nodes.back())))));
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

 private:
  static constexpr std::uint8_t kUnseen = 5;
  struct State {
    std::uint8_t open : 4 = 0;           // a bit for each direction in which the node can be left
    std::uint8_t entered : 4 = kUnseen;  // by the current search
  };
  struct Step {
    std::uint32_t node;
    std::uint8_t direction;
  };

  int column(std::size_t node) const { return static_cast<int>(static_cast<std::uint32_t>(node) % columns_); }
  int row(std::size_t node) const { return static_cast<int>(static_cast<std::uint32_t>(node) / columns_); }
  bool seen(std::size_t node) const { return states_[node].entered != kUnseen; }
  void enter(std::size_t node, std::uint8_t by) {
    states_[node].entered = by;
    seen_.push_back(static_cast<std::uint32_t>(node));
  }
  Polyline path_to(std::size_t to) const {
    return along(nodes_to(to, [this](std::size_t node) { return states_[node].entered; }));
  }
  void end_search();

  const GridGraph& graph_;
  const EdgeIndex& walls_;
  std::uint32_t columns_;
  std::array<std::ptrdiff_t, 4> step_;  // from a node's number to those of its neighbours
  std::vector<State> states_;
  ConnectedComponents components_;
  std::vector<std::uint32_t> seen_;         // by the current search, in its order
  std::vector<std::vector<Step>> waiting_;  // path(): by priority
};

}  // namespace oxturn
