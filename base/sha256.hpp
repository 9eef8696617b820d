/// Content addresses.
///
///   sha256("")      // "e3b0c44298fc1c14..."
#pragma once

#include <string>

namespace oxturn {

/// Lower-case hexadecimal SHA-256 of the bytes. Throws std::runtime_error if OpenSSL fails.
std::string sha256(const std::string& bytes);

/// Appends a double as eight big-endian bytes, -0 as 0: the same bytes on every machine.
void append_canonical(std::string& bytes, double value);

}  // namespace oxturn
