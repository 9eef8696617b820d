// libFuzzer target: bytes to a drawing. Build with the preset `fuzz` (clang), then
//   build/fuzz/tests/fuzz/fuzz_svg_drawing -max_len=4096 -timeout=20 -rss_limit_mb=4096 corpus/
#include "maps/svg_drawing.hpp"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    oxturn::drawing_from_svg({reinterpret_cast<const char*>(data), size}, "fuzz.svg");
  } catch (const std::invalid_argument&) {  // refused in one sentence
  }
  return 0;
}
