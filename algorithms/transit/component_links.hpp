/// How to connect many connected components by driven paths: a minimum spanning tree of them.
///
///   ComponentLinks links(problem);
///   for (...) links.add(entry_point, component, id);
///   for (const ComponentLinks::Link& link : links.tree(root)) ...      // parents first
///
/// Source      Mehlhorn, "A faster approximation algorithm for the Steiner problem in graphs", IPL 27, 1988
/// Method      One wave spreads from all entry points at once over the sides of the transit mesh. Where the waves of
///             two components meet, they can be connected; Kruskal's algorithm chooses among these connections.
/// Complexity  O((m + t) log (m + t)) for m entry points and t triangles, and a shortest path for each link, which is
///             short because it crosses nothing but the two components' own surroundings
/// Decisions   1. A wave enters a triangle's next side at the point that is nearest to where it was, so lengths are
///                those of feasible paths, a little too long. The links are exact shortest paths between their ends.
#pragma once

#include <cstdint>
#include <vector>

#include "maps/problem.hpp"

namespace oxturn {

class ComponentLinks {
 public:
  /// `problem` must outlive it.
  explicit ComponentLinks(const Problem& problem) : problem_(problem) {}
  /// An entry point of a component (numbered from 0), in configuration space; `id` is the caller's.
  void add(const Point& p, int component, std::size_t id);

  struct Link {
    std::size_t from, to;  // entry points, by the caller's ids
    Polyline path;         // both included
  };
  /// One link for each component that can be reached from `root`, except itself; `from` belongs to the root or to a
  /// component that an earlier link leads to.
  std::vector<Link> tree(int root);

 private:
  class Wave;
  struct Entry {
    Point at;
    int component;
    std::int32_t triangle;
    std::size_t id;
  };
  const Problem& problem_;
  std::vector<Entry> entries_;  // tree() sorts them by triangle
  int count_ = 0;               // components
};

}  // namespace oxturn
