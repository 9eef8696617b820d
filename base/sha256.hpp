/// SHA-256, to identify files and runs by their content.
///
///   sha256("")      // "e3b0c44298fc1c14..."
#pragma once

#include <cstdint>
#include <string>

namespace oxturn {

/// The hash as 64 lower-case hexadecimal digits. Throws std::runtime_error if OpenSSL fails.
std::string sha256(const std::string& bytes);

/// Appends eight bytes, big-endian.
void append_canonical(std::string& bytes, std::uint64_t word);
/// Appends a double in a form that is the same on every machine: eight bytes, big-endian, -0 as 0.
void append_canonical(std::string& bytes, double value);

}  // namespace oxturn
