/// The cheapest perfect matching of a complete graph.
///
///   const std::vector<std::size_t> mate = perfect_matching(4, cost_between);
///
/// Edmonds' blossom algorithm with dual variables, in integers (Galil, "Efficient algorithms for finding maximum
/// matching in graphs", ACM Computing Surveys 18(1), 1986). O(n^3) time, O(n^2) memory. Boost 1.74's
/// maximum_weighted_matching is no substitute: it crashes on about one random graph in thirty.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace oxturn {

/// The mate of each of n vertices. `n` must be even and costs symmetric, at least 0, and less than 2^60 / n in sum.
std::vector<std::size_t> perfect_matching(std::size_t n,
                                          const std::function<std::int64_t(std::size_t, std::size_t)>& cost);

}  // namespace oxturn
