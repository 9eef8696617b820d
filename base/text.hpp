/// Numbers and names as text, the same on every machine and in every locale.
///
///   to_decimal(0.1)                              // "0.1"
///   nearest_name("room", {"rooms", "maze"})      // "rooms"
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace oxturn {

/// Shortest decimal that reads back as the same double; -0 is written as 0.
std::string to_decimal(double value);

/// The value of a text that is a number of type T (a leading + is allowed) and nothing else; otherwise nullopt.
template <class T>
std::optional<T> parse_all(std::string_view text) {
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);  // from_chars does not accept a '+'
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}
/// The value of a text that is a finite number and nothing else ("2.5", "+1e-3"); otherwise nullopt.
std::optional<double> parse_number(std::string_view text);
/// The value of a text of digits, 0 to 2^64 - 1; nullopt for anything else.
std::optional<std::uint64_t> parse_whole(std::string_view text);

/// With the letters A to Z as a to z.
std::string lower_case(std::string_view text);

/// `text` with bytes that are not valid UTF-8 replaced by U+FFFD, and control characters by spaces.
std::string printable(std::string_view text);

/// The candidate with the least edit distance to `word`, the first of several; empty if no candidate is like it (more
/// than half of its letters differ). O(length of word * total length of the candidates).
std::string nearest_name(const std::string& word, const std::vector<std::string>& candidates);

/// The error message for an unknown name: "no planner 'stk'; did you mean 'stc'? There are: boustrophedon, stc".
std::string unknown_name(const std::string& kind, const std::string& name, const std::vector<std::string>& known);

}  // namespace oxturn
