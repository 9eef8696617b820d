/// The small languages inside SVG's attributes: numbers, lengths, transforms, paints, path data. Private to maps.
///
///   Scanner scan("10, -.5e1");
///   const double x = *scan.number(), y = *scan.number();
///
/// Why no library: the parsers of SVG++ would bring in Boost.Spirit for what these few pages do, and add eight seconds
/// to each build; they also tell neither where an error is nor how long a list may become. Source: SVG 1.1 (2nd
/// edition), sections 4.2, 7.6, 8.3; CSS Color 3.
#pragma once

#include <optional>
#include <string_view>

#include "maps/drawings/outline.hpp"

namespace oxturn::svg {

/// Reads numbers and names from the front of a text.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}
  void skip_blanks();
  /// Blanks with at most one comma.
  void skip_separator();
  bool done();
  char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
  char take();
  bool take(char c);
  /// A number by SVG's grammar, without blanks before it. Too large: 1e300; too small: 0.
  std::optional<double> number();
  /// A single 0 or 1, which needs no separator after it.
  std::optional<bool> flag();
  std::string_view word();  // letters, digits, - and _
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

std::string_view trimmed(std::string_view text);

/// In CSS pixels: px, pt, pc, in, cm, mm, % of `whole`, or no unit. Nullopt for anything else.
std::optional<double> parse_length(std::string_view text, double whole);
/// Numbers with blanks or commas between them; nullopt if there is anything else.
std::optional<std::vector<double>> parse_numbers(std::string_view text);
std::optional<Affine> parse_transform(std::string_view text);

/// What matters of a colour in a drawing for the robot.
enum class Paint { none, white, red, green, other, current };
/// Also `url(#gradient)`, which paints plainly: `server` becomes true. Nullopt if it is no paint.
std::optional<Paint> parse_paint(std::string_view text, bool& server);

struct ParsedPath {
  Outline outline;
  std::size_t commands = 0;
  bool broken = false;  // there was an error: the outline is what came before it
};
/// Stops with an error after `most` commands.
ParsedPath parse_path(std::string_view text, std::size_t most);

}  // namespace oxturn::svg
