#include "bench/shard.hpp"

#include "base/text.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const auto index = parse_whole(text.substr(0, slash));
  const auto count = slash == std::string::npos ? index : parse_whole(text.substr(slash + 1));
  constexpr std::uint64_t kMost = 1'000'000;
  if (slash == std::string::npos || !index || !count || *index < 1 || *index > *count || *count > kMost)
    throw_invalid("shard is '{}', expected K/N with K from 1 to N, at most {}", text, kMost);
  return {static_cast<std::size_t>(*index), static_cast<std::size_t>(*count)};
}

}  // namespace oxturn
