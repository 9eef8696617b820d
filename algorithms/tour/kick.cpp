#include "algorithms/tour/kick.hpp"

#include <algorithm>
#include <array>

namespace oxturn {
namespace {

constexpr std::size_t kLongestBlock = 30;  // the search undoes the exchange of short blocks more often
constexpr std::size_t kFewest = 4;

}  // namespace

std::optional<ElementId> kick(MoveSearch& search, Rng& rng) {
  TourState& state = search.state;
  const std::size_t n = state.size();
  if (n < kFewest) return std::nullopt;
  const std::size_t longest = std::min(kLongestBlock, (n - 1) / 3);
  const std::size_t from = rng.below(n);
  std::array<std::size_t, 3> length{};
  for (std::size_t& l : length) l = 1 + rng.below(longest);
  std::array<std::size_t, 4> first{};  // of the three blocks and what follows
  first[0] = from;
  for (std::size_t k = 0; k < 3; ++k) first[k + 1] = (first[k] + length[k]) % n;
  std::array<ElementId, 4> heads{}, tails{};  // tails[k] -> heads[k] are the four connections
  for (std::size_t k = 0; k < 4; ++k) {
    heads[k] = state.at(first[k]);
    tails[k] = state.at((first[k] + n - 1) % n);
  }
  const auto cost = [&](ElementId a, ElementId b) { return search.connection(state.pattern(a), state.pattern(b)); };
  double gain = 0;
  for (std::size_t k = 0; k < 4; ++k) gain += cost(tails[k], heads[k]);
  gain -= cost(tails[0], heads[2]) + cost(tails[3], heads[1]) + cost(tails[2], heads[0]) + cost(tails[1], heads[3]);
  const std::size_t mark = state.mark();
  if (!state.swap_blocks(from, length[0], length[1] + length[2]) ||
      !state.swap_blocks(state.position(heads[1]), length[1], length[2])) {
    state.undo(mark);
    return std::nullopt;
  }
  search.gained += gain;
  for (std::size_t k = 0; k < 4; ++k) search.push({heads[k], tails[k]});
  return heads[1];
}

}  // namespace oxturn
