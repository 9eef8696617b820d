#include "base/disjoint_sets.hpp"

#include <boost/pending/disjoint_sets.hpp>
#include <numeric>

namespace oxturn {
namespace {

using Sets = boost::disjoint_sets<std::uint8_t*, std::uint32_t*, boost::find_with_path_halving>;

}  // namespace

DisjointSets::DisjointSets(std::size_t n) : parent_(n), rank_(n, 0) {
  std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
}

void DisjointSets::add() {
  parent_.push_back(static_cast<std::uint32_t>(parent_.size()));
  rank_.push_back(0);
}

std::size_t DisjointSets::find(std::size_t i) {
  return Sets(rank_.data(), parent_.data()).find_set(static_cast<std::uint32_t>(i));
}

bool DisjointSets::unite(std::size_t i, std::size_t j) {
  Sets sets(rank_.data(), parent_.data());
  const std::uint32_t a = sets.find_set(static_cast<std::uint32_t>(i));
  const std::uint32_t b = sets.find_set(static_cast<std::uint32_t>(j));
  if (a == b) return false;
  sets.link(a, b);
  return true;
}

}  // namespace oxturn
