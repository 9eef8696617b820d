/// A part of a suite's runs, for one of several machines.
///
///   const Shard shard = parse_shard("3/16");
///   const auto [first, last] = shard.range(runs);        // runs first .. last - 1 of the suite's list
///
/// Shards are consecutive, so that each sets up few problems and their rows, one after the other, are in suite order.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

namespace oxturn {

struct Shard {
  std::size_t index = 1, count = 1;  // 1 .. count
  std::pair<std::size_t, std::size_t> range(std::size_t runs) const {
    const auto begin = [&](std::size_t k) { return runs / count * k + runs % count * k / count; };
    return {begin(index - 1), begin(index)};
  }
  std::string text() const { return std::to_string(index) + "/" + std::to_string(count); }
  bool operator==(const Shard&) const = default;
};

/// Throws std::invalid_argument "shard is '0/4', expected K/N with K from 1 to N".
Shard parse_shard(const std::string& text);

}  // namespace oxturn
