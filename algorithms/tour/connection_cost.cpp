#include "algorithms/tour/connection_cost.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace oxturn {

MatrixCost::MatrixCost(std::size_t n, std::vector<double> costs) : n_(n), costs_(std::move(costs)) {
  if (costs_.size() != n * n)
    throw std::invalid_argument(
        fmt::format("a matrix of costs for {} patterns has {} values, expected {}", n, costs_.size(), n * n));
  for (std::size_t i = 0; i < costs_.size(); ++i)
    if (!std::isfinite(costs_[i]))
      throw std::invalid_argument(fmt::format("the cost from {} to {} is {}, expected a finite number (forbidden: {})",
                                              i / n, i % n, costs_[i], kForbidden));
}

bool MatrixCost::symmetric(const std::vector<PatternId>& reverse) const {
  for (std::size_t p = 0; p < n_; ++p)
    for (std::size_t q = 0; q < n_; ++q)
      if (p != q && reverse[p] != q && costs_[p * n_ + q] != costs_[reverse[q] * n_ + reverse[p]]) return false;
  return true;
}

MatrixCost tabulate(const ConnectionCost& cost, std::size_t n) {
  std::vector<double> costs(n * n, 0.0);
  for (std::size_t p = 0; p < n; ++p)
    for (std::size_t q = 0; q < n; ++q)
      if (p != q) costs[p * n + q] = cost(static_cast<PatternId>(p), static_cast<PatternId>(q));
  return {n, std::move(costs)};
}

bool StraightCost::symmetric(const std::vector<PatternId>& reverse) const {
  for (std::size_t p = 0; p < ends_.size(); ++p)
    if (ends_[p].entry != ends_[reverse[p]].exit || ends_[p].exit != ends_[reverse[p]].entry) return false;
  return true;
}

}  // namespace oxturn
