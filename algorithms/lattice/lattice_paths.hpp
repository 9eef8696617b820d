// Ways over a lattice: from node to node, and to the nearest node of a kind. What a planner needs that moves between very
// many places: nothing is triangulated, and near places are found at the cost of the cells in between.
//
// Ways follow the lattice and are then pulled straight wherever that stays in configuration space, exactly. To the nearest
// of a kind they take the fewest steps; to a given node at most an eighth more (weighted A*: among scattered obstacles the
// last few steps cost ten times what all others do).
// Complexity  build O(nodes), 9 bytes a node; a question O(nodes nearer than the answer)
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

class LatticePaths {
 public:
  /// Both must outlive it.
  LatticePaths(const GridGraph& graph, const EdgeIndex& walls);

  /// Nodes with the same part are joined by the lattice; -1: not free.
  int part(std::size_t node) const { return part_[node]; }
  Point place(std::size_t node) const { return graph_.centre(column(node), row(node)); }
  /// A free node near p to which the robot can drive straight, the nearest of those up to 8 cells away.
  std::optional<std::size_t> node_near(const Point& p) const;
  /// The straight way from a node to its neighbour is free.
  bool open(std::size_t node, Direction d) const { return (state_[node] >> d & 1) != 0; }
  std::size_t neighbour(std::size_t node, Direction d) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + step_[static_cast<std::size_t>(d)]);
  }
  /// The way over these nodes, each a neighbour of the one before, pulled straight.
  Polyline along(const std::vector<std::size_t>& nodes) const;
  /// From node to node, in at most 9/8 of the fewest steps; empty if the lattice does not join them.
  Polyline way(std::size_t from, std::size_t to);
  struct Found {
    std::size_t node;
    Polyline way;
  };
  /// The fewest steps from a node to one that is `wanted`.
  std::optional<Found> nearest(std::size_t from, const std::function<bool(std::size_t)>& wanted);
  /// The same from a place, by the node near it.
  std::optional<Found> nearest(const Point& from, const std::function<bool(std::size_t)>& wanted);

  static constexpr std::uint8_t kRoot = 4;
  /// The nodes by which a search came to that one; came(node): in which direction, kRoot where it began.
  template <class Came>
  std::vector<std::size_t> nodes_to(std::size_t to, Came came) const {
    std::vector<std::size_t> nodes{to};
    while (came(nodes.back()) != kRoot)
      nodes.push_back(neighbour(nodes.back(), opposite(static_cast<Direction>(came(nodes.back())))));
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }

 private:
  static constexpr std::uint8_t kUnseen = 5;
  static constexpr std::size_t kDriven = 8, kLeft = 9;
  int column(std::size_t node) const { return static_cast<int>(static_cast<std::uint32_t>(node) % columns_); }
  int row(std::size_t node) const { return static_cast<int>(static_cast<std::uint32_t>(node) / columns_); }
  Polyline traced_back(std::size_t to) const {
    return along(nodes_to(to, [this](std::size_t node) { return came(node); }));
  }
  void forget();
  std::uint8_t came(std::size_t node) const { return static_cast<std::uint8_t>(state_[node] >> 4); }
  void note(std::size_t node, std::uint8_t came) {
    state_[node] = static_cast<std::uint8_t>((state_[node] & 0xf) | came << 4);
  }
  void see(std::size_t node, std::uint8_t came) {
    note(node, came);
    seen_.push_back(static_cast<std::uint32_t>(node));
  }

  const GridGraph& graph_;
  const EdgeIndex& walls_;
  std::uint32_t columns_;
  std::array<std::ptrdiff_t, 4> step_;  // to a node's neighbours
  // Of each node the ways out, a bit each, and above these the direction in which the question at hand entered it.
  std::vector<std::uint8_t> state_;
  std::vector<std::int32_t> part_;
  std::vector<std::uint32_t> seen_;  // by the question at hand
  struct Step {
    std::uint32_t node;
    std::uint8_t came;
  };
  std::vector<std::vector<Step>> waiting_;  // way(): by what they promise
};

}  // namespace oxturn
