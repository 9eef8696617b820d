// Numbers as text: the shortest decimal that reads back as the same double, with no locale.
#include <charconv>

#include "maps/formats.hpp"

namespace oxturn {

std::string to_decimal(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value == 0 ? 0.0 : value).ptr;
  return {text, end};
}

}  // namespace oxturn
