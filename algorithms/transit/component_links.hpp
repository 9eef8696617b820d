/// How to connect many connected components by driven paths: a minimum spanning tree of them.
///
///   ComponentLinks links(problem);
///   for (...) links.add(entry_point, component, id);
///   for (const ComponentLinks::Link& link : links.tree(root)) ...      // parents first
///
/// Source      O. Boruvka, "O jistem problemu minimalnim", 1926
/// Method      In each round every group of components that are connected so far looks for the nearest entry point of
///             another group, by a wave over the sides of the transit mesh, and all of them are connected. The group
///             with the most entry points does not look: it is found by the others, so a few small components beside a
///             large one cost only their own surroundings.
/// Complexity  O(m + t) for m entry points and t triangles; in each of at most log2 m rounds O(s log s) for s sides
///             nearer to the groups that look than what they find; a shortest path for each link, which is short
///             because it crosses nothing but the two components' own surroundings
/// Decisions   1. A wave enters a triangle's next side at the point that is nearest to where it was, so lengths are
///                those of feasible paths, a little too long. The links are exact shortest paths between their ends.
///             2. Entry points of the component with the most of them count only within 16 to 32 tool widths of another
///                component's, as long as all components are reached so.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "base/disjoint_sets.hpp"
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
  /// Two entry points, by index, and roughly how long the path between them is.
  struct Candidate {
    double length = std::numeric_limits<double>::infinity();
    std::uint32_t a = 0, b = 0;
  };
  struct Group {
    std::vector<std::uint32_t> entries;
    Candidate best;  // to what is outside, of those that are known
  };
  std::vector<bool> near_others() const;
  void locate(const std::vector<bool>& chosen);
  std::vector<Link> tree_of_located(int root) const;
  std::vector<Group> groups_of(DisjointSets& joined, const std::vector<Candidate>& near) const;
  std::vector<Candidate> connections() const;

  const Problem& problem_;
  std::vector<Entry> all_;      // not located
  std::vector<Entry> entries_;  // by triangle
  int count_ = 0;               // components
};

}  // namespace oxturn
