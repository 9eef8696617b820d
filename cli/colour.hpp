/// Colour on a terminal.
///
///   fmt::print("{}\n", coloured(stdout, Colour::red, "failed"));
#pragma once

#include <cstdio>
#include <string>

#include "bench/results.hpp"

namespace oxturn::cli {

enum class Colour { green, yellow, red };

/// Green for ok, yellow for partial, red for any other.
Colour colour_of(Outcome outcome);

/// The text as it is unless `out` is a terminal; never coloured if the environment sets NO_COLOR (to other than the
/// empty text, as https://no-color.org asks) or TERM is "dumb".
std::string coloured(std::FILE* out, Colour colour, const std::string& text);

}  // namespace oxturn::cli
