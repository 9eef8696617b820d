/// Chains of points from which the tool covers what is still uncovered, each going on from point to point as long as
/// there is something uncovered beside it.
///
///   UncoveredChains chains(problem, fine, samples, UncoveredChains::From::anywhere);
///   while (const auto chain = chains.from(i, j)) tree.attach(chain->nodes, ...);
///
/// Points are centres of free cells; where these do not reach, positions on the boundary of configuration space.
/// O(samples looked at), each a few times, and an exact segment test for each point.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/grid/uncovered_samples.hpp"
#include "algorithms/grid/wall_loops.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class UncoveredChains {
 public:
  enum class From { centres, anywhere };
  /// All must outlive it.
  UncoveredChains(const Problem& problem, const GridGraph& cells, UncoveredSamples& samples, From from);
  /// A chain that begins with what is uncovered in cell (i, j), which may be one outside of the lattice; nullopt if the
  /// tool covers nothing more there. It is `closed` where driving once around is shorter than there and back. What it
  /// covers is marked in the samples.
  std::optional<NodeChain> from(int i, int j);

 private:
  /// Where the robot goes next: for sample k of cell (i, j).
  struct Spot {
    Point at;
    int i, j, k;
    bool centre;
  };
  std::optional<Spot> spot_in(int i, int j);
  std::optional<Spot> next_spot(const Polyline& nodes, const Cell& at);
  std::optional<Point> point_that_covers(const Point& q) const;
  void take(const Spot& spot, const Point& from);
  void extend(Polyline& nodes, Cell at);
  std::size_t number(int i, int j) const {
    return static_cast<std::size_t>(j + 1) * static_cast<std::size_t>(cells_.columns() + 2) +
           static_cast<std::size_t>(i + 1);
  }

  const Problem& problem_;
  const GridGraph& cells_;
  UncoveredSamples& samples_;
  From from_;
  std::vector<bool> centre_tried_;  // by cell, with a margin of one
};

}  // namespace oxturn
