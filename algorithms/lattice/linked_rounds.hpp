/// Drives around trees of sub-cells, one in each connected component: where a round passes the start of a link to
/// another component, the robot goes there, around that component and back.
///
///   LinkedRounds rounds(fine, links, path);
///   rounds.drive({.to = root, .path = &arrival}, context, [&](const Cell& c) { return steps_around_tree_of(c); });
///
/// Straight steps become one segment. Time and memory are linear in steps and links.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/lattice/grid_graph.hpp"
#include "geometry/path.hpp"

namespace oxturn {

class LinkedRounds {
 public:
  struct Link {
    std::size_t from = 0;  // the sub-cell, by number, where the path begins
    Cell to;               // where it enters the component
    const Polyline* path;  // transit, both ends included
  };
  /// The steps of the round that begins at a sub-cell; none if its component is this sub-cell alone.
  using Steps = std::function<std::vector<Direction>(const Cell&)>;

  /// All must outlive it.
  LinkedRounds(const GridGraph& fine, std::vector<Link> links, PathBuilder& path);
  /// Follows `root` and drives the round there with all that branch off. Asks for the steps of each component once, on
  /// arrival.
  void drive(const Link& root, const Context& context, const Steps& steps_from);

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Round {
    Cell at;
    std::vector<Direction> steps;
    std::size_t driven;  // steps
    const Polyline* arrival;
  };
  void enter(const Link& link, std::vector<Direction> steps);
  void step(Round& round);
  void leave();
  void transit(const Polyline& line, bool tool_on);
  std::uint32_t next_link(const Cell& c);

  const GridGraph& fine_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> first_, next_;  // links from each sub-cell that have not been followed, as linked lists
  PathBuilder& path_;
  std::vector<Round> open_;  // rounds begun
  Polyline line_;            // with the tool on, not yet in the path
  std::optional<Direction> last_;
};

}  // namespace oxturn
