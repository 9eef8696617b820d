/// Refuses bad input with a formatted sentence. Not installed: public headers do not show fmt.
///
///   if (n < 3) throw_invalid("ring has {} points, expected at least 3", n);
#pragma once

#include <fmt/format.h>

#include <stdexcept>

namespace oxturn {

template <class... Args>
[[noreturn]] void throw_invalid(fmt::format_string<Args...> text, Args&&... args) {
  throw std::invalid_argument(fmt::format(text, std::forward<Args>(args)...));
}

}  // namespace oxturn
