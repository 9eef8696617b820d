#include "algorithms/tour/keep_together.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/throw_invalid.hpp"

namespace oxturn {

KeepTogether::KeepTogether(const ConnectionCost& cost, std::vector<std::size_t> groups)
    : cost_(cost), groups_(std::move(groups)) {
  const auto n = static_cast<PatternId>(groups_.size());
  double largest = 1;
  for (PatternId p = 0; p < n; ++p)
    for (PatternId q = 0; q < n; ++q)
      if (const double c = p == q ? 0 : std::abs(cost(p, q)); c < kForbidden) largest = std::max(largest, c);
  penalty_ = 2 * static_cast<double>(n) * largest;
  if (penalty_ * static_cast<double>(n) > kForbidden)
    throw_invalid("groups of a tour: a connection costs {:.6g}, expected at most {:.6g} for {} patterns", largest,
                  kForbidden / (2.0 * n * n), n);
}

double KeepTogether::operator()(PatternId from, PatternId to) const {
  const bool together = groups_[from] == groups_[to] && groups_[from] != kNoGroup;
  return cost_(from, to) + (together ? 0 : penalty_);
}

}  // namespace oxturn
