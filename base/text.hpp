/// Numbers and names as text, the same on every machine and in every locale.
///
///   to_decimal(0.1)                              // "0.1"
///   nearest_name("room", {"rooms", "maze"})      // "rooms"
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace oxturn {

/// Shortest decimal that reads back as the same double; -0 is written as 0.
std::string to_decimal(double value);

/// The value of a text that is a finite number and nothing else ("2.5", "+1e-3"); otherwise nullopt.
std::optional<double> parse_number(std::string_view text);
/// The value of a text of digits, 0 to 2^64 - 1; nullopt for anything else.
std::optional<std::uint64_t> parse_whole(std::string_view text);

/// `text` with bytes that are not valid UTF-8 replaced by U+FFFD, and control characters by spaces.
std::string printable(std::string_view text);

/// The candidate with the least edit distance to `word`, the first of several; empty only if there are no candidates.
/// O(length of word * total length of the candidates).
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);

/// The error message for an unknown name: "no planner 'stk'; did you mean 'stc'? There are: boustrophedon, stc".
std::string unknown_name(const std::string& kind, const std::string& name, const std::vector<std::string>& known);

}  // namespace oxturn
