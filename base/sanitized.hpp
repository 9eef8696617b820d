/// Whether this program is built with the address or the thread sanitizer: their own memory counts like the
/// program's, and they end the program where a block is too large. Not installed.
///
///   if (kSanitized) GTEST_SKIP() << "a sanitizer's own memory counts, too";
#pragma once

namespace oxturn {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace oxturn
