// Ways over a lattice: from node to node, and to the nearest node of a kind. What a planner needs that moves between very
// many places: nothing is triangulated, and near places are found at the cost of the cells in between.
//
// Ways follow the lattice (shortest in steps: A* with two stacks, for steps cost one and detours two; or breadth first) and
// are then pulled straight wherever that stays in configuration space, exactly.
// Complexity  build O(nodes), 10 bytes a node; a question O(nodes nearer than the answer)
#pragma once

#include <array>
#include <cstddef>
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
  Point place(std::size_t node) const { return graph_.centre(column(node), row(node)); }
  /// A free node near p to which the robot can drive straight, the nearest of those up to 8 cells away.
  std::optional<std::size_t> node_near(const Point& p) const;
  /// The straight way from a node to its neighbour is free.
  bool open(std::size_t node, Direction d) const { return (open_[node] >> d & 1) != 0; }
  std::size_t neighbour(std::size_t node, Direction d) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + step_[static_cast<std::size_t>(d)]);
  }
  /// The way over these nodes, each a neighbour of the one before, pulled straight.
  Polyline along(const std::vector<std::size_t>& nodes) const;
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
  int column(std::size_t node) const { return static_cast<int>(static_cast<std::uint32_t>(node) % columns_); }
  int row(std::size_t node) const { return static_cast<int>(static_cast<std::uint32_t>(node) / columns_); }
  Polyline traced_back(std::size_t to) const;
  void forget();
  void see(std::size_t node, std::uint8_t came) {
    came_[node] = came;
    seen_.push_back(static_cast<std::uint32_t>(node));
  }

  const GridGraph& graph_;
  const EdgeIndex& walls_;
  std::uint32_t columns_;
  std::array<std::ptrdiff_t, 4> step_;  // to a node's neighbours
  std::vector<std::uint8_t> open_;      // the ways out of each node, a bit each
  std::vector<std::int32_t> part_;
  std::vector<std::uint8_t> came_;   // the direction in which a node was entered
  std::vector<std::uint32_t> seen_;  // by the question at hand
};

}  // namespace oxturn
