#include "algorithms/lanes/corridors.hpp"

#include <algorithm>

namespace oxturn {
namespace {

/// The longest part from item `from` on that is no higher than `most`, or that item alone.
ChainPart level_part(const std::vector<LaneInterval>& chain, std::size_t from, double most, std::size_t shortest) {
  double low = chain[from].low, high = chain[from].high;
  std::size_t end = from + 1;
  for (; end < chain.size(); ++end) {
    const double lower = std::min(low, chain[end].low), higher = std::max(high, chain[end].high);
    if (higher - lower > most) break;
    low = lower;
    high = higher;
  }
  return {from, end - from, end - from >= shortest && high - low <= most, (low + high) / 2, high - low};
}

}  // namespace

std::vector<std::vector<std::size_t>> chains(std::size_t count,
                                             const std::vector<std::pair<std::size_t, std::size_t>>& links) {
  std::vector<std::size_t> next(count, count), successors(count, 0), predecessors(count, 0);
  for (const auto& [a, b] : links) {
    next[a] = b;
    ++successors[a];
    ++predecessors[b];
  }
  const auto follows_alone = [&](std::size_t a) { return successors[a] == 1 && predecessors[next[a]] == 1; };
  std::vector<std::vector<std::size_t>> all;
  std::vector<bool> taken(count, false);
  for (std::size_t i = 0; i < count; ++i) {  // successors have higher indices, so a chain's first item comes first
    if (taken[i]) continue;
    all.push_back({i});
    for (std::size_t k = i; follows_alone(k); k = next[k]) all.back().push_back(next[k]);
    for (const std::size_t k : all.back()) taken[k] = true;
  }
  return all;
}

std::vector<ChainPart> corridors_in(const std::vector<LaneInterval>& chain, double most, std::size_t shortest) {
  std::vector<ChainPart> parts;
  for (std::size_t i = 0; i < chain.size();) {
    ChainPart part = level_part(chain, i, most, shortest);
    if (!part.corridor) part.count = 1;
    i += part.count;
    if (!part.corridor && !parts.empty() && !parts.back().corridor)
      ++parts.back().count;
    else
      parts.push_back(part);
  }
  return parts;
}

}  // namespace oxturn
