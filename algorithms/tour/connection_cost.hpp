/// What it costs to go from the exit of one pattern to the entry of another: the interface through which a tour learns
/// of distances, times, curves or obstacles.
///
///   MatrixCost matrix(n, {0, 3, 4,  ...});                         // any costs, by rows
///   FunctionCost cost(length_of_curve, true);                      // a function of two patterns
///   MatrixCost table = tabulate(cost, patterns);                   // an expensive function, asked once for each pair
///
/// Patterns are numbered through all elements. Costs are finite; kForbidden marks connections that must not be used.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

using ElementId = std::uint32_t;
using PatternId = std::uint32_t;
inline constexpr PatternId kNoPattern = 0xffffffff;

/// Dearer than any real tour, and small enough that a sum of many keeps four decimal places.
inline constexpr double kForbidden = 1e12;

class ConnectionCost {
 public:
  virtual ~ConnectionCost() = default;
  virtual double operator()(PatternId from, PatternId to) const = 0;
  /// Whether driving backwards costs the same: c(p, q) = c(reverse of q, reverse of p) for all pairs. `reverse` holds
  /// the reverse of each pattern, kNoPattern if there is none.
  virtual bool symmetric(const std::vector<PatternId>& reverse) const = 0;
  /// Entry and exit of a pattern, if costs grow with straight distance: then nearest patterns are found by a grid, not
  /// by asking for all pairs.
  struct Ends {
    Point entry, exit;
  };
  virtual const std::vector<Ends>* ends() const { return nullptr; }
};

/// Costs by rows: from, to. The diagonal is not used.
class MatrixCost final : public ConnectionCost {
 public:
  /// Throws std::invalid_argument unless there are n * n finite costs.
  MatrixCost(std::size_t n, std::vector<double> costs);
  double operator()(PatternId from, PatternId to) const override { return costs_[from * n_ + to]; }
  /// O(n^2).
  bool symmetric(const std::vector<PatternId>& reverse) const override;
  std::size_t size() const { return n_; }

 private:
  std::size_t n_;
  std::vector<double> costs_;
};

/// All costs between n patterns. O(n^2) calls.
MatrixCost tabulate(const ConnectionCost& cost, std::size_t n);

/// Straight distance from exit to entry.
class StraightCost final : public ConnectionCost {
 public:
  explicit StraightCost(std::vector<Ends> ends) : ends_(std::move(ends)) {}
  /// Each point is an element.
  explicit StraightCost(const std::vector<Point>& points) {
    for (const Point& p : points) ends_.push_back({p, p});
  }
  double operator()(PatternId from, PatternId to) const override { return (ends_[from].exit - ends_[to].entry).norm(); }
  bool symmetric(const std::vector<PatternId>& reverse) const override;
  const std::vector<Ends>* ends() const override { return &ends_; }

 private:
  std::vector<Ends> ends_;
};

/// Costs by any function.
class FunctionCost final : public ConnectionCost {
 public:
  using Function = std::function<double(PatternId from, PatternId to)>;
  /// `symmetric`: see ConnectionCost::symmetric, which is not checked. `ends`: if costs grow with straight distance.
  FunctionCost(Function f, bool symmetric, std::vector<Ends> ends = {})
      : f_(std::move(f)), symmetric_(symmetric), ends_(std::move(ends)) {}
  double operator()(PatternId from, PatternId to) const override { return f_(from, to); }
  bool symmetric(const std::vector<PatternId>&) const override { return symmetric_; }
  const std::vector<Ends>* ends() const override { return ends_.empty() ? nullptr : &ends_; }

 private:
  Function f_;
  bool symmetric_;
  std::vector<Ends> ends_;
};

}  // namespace oxturn
