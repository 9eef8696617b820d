#include "cli/colour.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace oxturn::cli {
namespace {

bool shows_colour(std::FILE* out) {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string_view(value == nullptr ? "" : value);
  };
  return ::isatty(::fileno(out)) == 1 && variable("NO_COLOR").empty() && variable("TERM") != "dumb";
}

/// ANSI's "select graphic rendition".
int code_of(Colour colour) {
  switch (colour) {
    case Colour::red:
      return 31;
    case Colour::green:
      return 32;
    case Colour::yellow:
      return 33;
  }
  return 0;
}

}  // namespace

Colour colour_of(Outcome outcome) {
  return outcome == Outcome::ok ? Colour::green : outcome == Outcome::partial ? Colour::yellow : Colour::red;
}

std::string coloured(std::FILE* out, Colour colour, const std::string& text) {
  return shows_colour(out) ? fmt::format("\033[{}m{}\033[0m", code_of(colour), text) : text;
}

}  // namespace oxturn::cli
