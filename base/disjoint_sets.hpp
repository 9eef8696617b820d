/// Disjoint sets of 0 .. n-1 that can be united (union-find).
///
///   DisjointSets sets(4);
///   sets.unite(0, 2);         // true: they were two sets
///   sets.same(2, 0);          // true
///
/// Both operations take amortised O(inverse Ackermann(n)): Boost's union by rank with path halving. The representative
/// of a set is one of its members and depends on nothing but the calls made so far; which member it is, is unspecified.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace oxturn {

class DisjointSets {
 public:
  /// n sets of one member each; n < 2^32.
  explicit DisjointSets(std::size_t n);
  /// One more set of one member, whose number is the size before.
  void add();
  std::size_t size() const { return parent_.size(); }
  /// The representative of the set that contains i.
  std::size_t find(std::size_t i);
  bool same(std::size_t i, std::size_t j) { return find(i) == find(j); }
  /// Joins the two sets; false if they were one already.
  bool unite(std::size_t i, std::size_t j);

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> rank_;  // at most log2 n
};

}  // namespace oxturn
