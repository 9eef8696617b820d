#include "algorithms/tour/assignment.hpp"

#include <algorithm>
#include <limits>

namespace oxturn {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr std::size_t kFree = static_cast<std::size_t>(-1);

class AugmentingPaths {
 public:
  AugmentingPaths(std::size_t n, const std::function<double(std::size_t, std::size_t)>& cost)
      : n_(n), cost_(n * n), row_(n, kFree) {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) cost_[i * n + j] = cost(i, j);
    result_.column.assign(n, kFree);
    result_.row_price.assign(n, kNone);
    result_.column_price.assign(n, kNone);
  }

  Assignment solve() {
    reduce();
    for (std::size_t i = 0; i < n_; ++i)
      if (result_.column[i] == kFree) augment(i);
    for (std::size_t i = 0; i < n_; ++i)  // prices of rows follow from those of columns
      result_.row_price[i] = cost_[i * n_ + result_.column[i]] - result_.column_price[result_.column[i]];
    return std::move(result_);
  }

 private:
  double reduced(std::size_t i, std::size_t j) const {
    return cost_[i * n_ + j] - result_.row_price[i] - result_.column_price[j];
  }

  /// Prices such that no reduced cost is negative; pairs of reduced cost 0 are matched where both are free.
  void reduce() {
    auto &rows = result_.row_price, &columns = result_.column_price;
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < n_; ++j) columns[j] = std::min(columns[j], cost_[i * n_ + j]);
    for (std::size_t i = 0; i < n_; ++i) {
      std::size_t best = 0;
      for (std::size_t j = 0; j < n_; ++j)
        if (const double c = cost_[i * n_ + j] - columns[j]; c < rows[i]) {
          rows[i] = c;
          best = j;
        }
      if (row_[best] != kFree) continue;
      row_[best] = i;
      result_.column[i] = best;
    }
  }

  /// Dijkstra's search over reduced costs from a free row to the nearest free column.
  void augment(std::size_t start) {
    std::vector<double> distance(n_, kNone);
    std::vector<std::size_t> from(n_, start);
    std::vector<bool> done(n_, false);
    std::size_t i = start, last = kFree;
    double reached = 0;
    while (last == kFree) {
      std::size_t nearest = kFree;
      for (std::size_t j = 0; j < n_; ++j) {
        if (done[j]) continue;
        if (const double d = reached + reduced(i, j); d < distance[j]) {
          distance[j] = d;
          from[j] = i;
        }
        if (nearest == kFree || distance[j] < distance[nearest]) nearest = j;
      }
      reached = distance[nearest];
      done[nearest] = true;
      i = row_[nearest];
      if (i == kFree) last = nearest;
    }
    for (std::size_t j = 0; j < n_; ++j) {
      if (!done[j] || j == last) continue;
      result_.row_price[row_[j]] += reached - distance[j];
      result_.column_price[j] -= reached - distance[j];
    }
    result_.row_price[start] += reached;
    for (std::size_t j = last; j != kFree;) {
      const std::size_t row = from[j];
      row_[j] = row;
      std::swap(j, result_.column[row]);
    }
  }

  std::size_t n_;
  std::vector<double> cost_;
  std::vector<std::size_t> row_;  // of each column
  Assignment result_;
};

}  // namespace

Assignment solve_assignment(std::size_t n, const std::function<double(std::size_t, std::size_t)>& cost) {
  return AugmentingPaths(n, cost).solve();
}

}  // namespace oxturn
