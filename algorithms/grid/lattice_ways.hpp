// Ways over a lattice: from node to node, and to the nearest node of a kind. What a planner needs that moves between very
// many places: nothing is triangulated, and near places are found at the cost of the cells in between.
//
// Ways follow the lattice (shortest in steps: A* with two stacks, for steps cost one and detours two; or breadth first) and
// are then pulled straight wherever that stays in configuration space, exactly.
// Complexity  build O(nodes), 9 bytes a node; a question O(nodes nearer than the answer)
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "algorithms/grid/grid_graph.hpp"

namespace oxturn {

class LatticeWays {
 public:
  /// Both must outlive it.
  LatticeWays(const GridGraph& graph, const EdgeIndex& walls);

  /// Nodes with the same part are joined by the lattice; -1: not free.
  int part(std::size_t node) const { return part_[node]; }
  /// A free node near p to which the robot can drive straight, the nearest of those up to 8 cells away.
  std::optional<std::size_t> node_near(const Point& p) const;
  /// From node to node; empty if the lattice does not join them.
  Polyline way(std::size_t from, std::size_t to);
  struct Found {
    std::size_t node;
    Polyline way;
  };
  /// The fewest steps from a node to one that is `wanted`.
  std::optional<Found> nearest(std::size_t from, const std::function<bool(std::size_t)>& wanted);

 private:
  static constexpr std::uint8_t kUnseen = 5, kRoot = 4;
  int column(std::size_t node) const { return static_cast<int>(node % static_cast<std::size_t>(graph_.columns())); }
  int row(std::size_t node) const { return static_cast<int>(node / static_cast<std::size_t>(graph_.columns())); }
  std::size_t neighbour(std::size_t node, Direction d) const {
    return graph_.at(column(node) + kColumnStep[d], row(node) + kRowStep[d]);
  }
  Polyline traced_back(std::size_t to) const;
  void forget();
  void see(std::size_t node, std::uint8_t came) {
    came_[node] = came;
    seen_.push_back(static_cast<std::uint32_t>(node));
  }

  const GridGraph& graph_;
  const EdgeIndex& walls_;
  std::vector<std::int32_t> part_;
  std::vector<std::uint8_t> came_;   // the direction in which a node was entered
  std::vector<std::uint32_t> seen_;  // by the question at hand
};

}  // namespace oxturn
