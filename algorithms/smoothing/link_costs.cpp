#include "algorithms/smoothing/link_costs.hpp"

#include <algorithm>
#include <bit>

#include "base/multiplicative_hash.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kSlots = 64;            // for each pattern
constexpr std::size_t kMostSlots = 1u << 24;  // 256 MB

}  // namespace

LinkCosts::LinkCosts(std::size_t patterns, Bound bound) : patterns_(patterns), bound_(std::move(bound)) {
  if (patterns > kMostTabulated) {
    recent_.resize(std::min(std::bit_ceil(kSlots * patterns), kMostSlots));
    return;
  }
  table_.resize(patterns * patterns);
  for (PatternId p = 0; p < patterns; ++p)
    for (PatternId q = 0; q < patterns; ++q) table_[p * patterns + q] = computed(p, q);
}

double LinkCosts::computed(PatternId from, PatternId to) const {
  effort_ += kBoundEffort;
  return bound_(from, to);
}

LinkCosts::Slot& LinkCosts::slot(PatternId from, PatternId to) const {
  const std::uint64_t key = ((std::uint64_t{from} << 32) | to) * kHashFactor;
  return recent_[(key >> 32) & (recent_.size() - 1)];
}

double LinkCosts::operator()(PatternId from, PatternId to) const {
  ++effort_;
  if (tabulated()) return table_[from * patterns_ + to];
  Slot& kept = slot(from, to);
  if (kept.from == from && kept.to == to) return kept.cost;
  const auto set = known_.find({from, to});
  kept = {from, to, set != known_.end() ? set->second : computed(from, to)};
  return kept.cost;
}

void LinkCosts::set(PatternId from, PatternId to, double cost) {
  known_[{from, to}] = cost;
  if (tabulated())
    table_[from * patterns_ + to] = cost;
  else
    slot(from, to) = {from, to, cost};
}

}  // namespace oxturn
