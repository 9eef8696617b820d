#include "base/sha256.hpp"

#include <openssl/evp.h>

#include <bit>
#include <stdexcept>

namespace oxturn {

std::string sha256(const std::string& bytes) {
  unsigned char digest[EVP_MAX_MD_SIZE];
  unsigned int size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest, &size, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("OpenSSL cannot compute SHA-256");
  static constexpr char kHex[] = "0123456789abcdef";
  std::string text;
  for (unsigned int i = 0; i < size; ++i) {
    text.push_back(kHex[digest[i] >> 4]);
    text.push_back(kHex[digest[i] & 15]);
  }
  return text;
}

void append_canonical(std::string& bytes, std::uint64_t word) {
  for (int shift = 56; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>((word >> shift) & 0xff));
}

void append_canonical(std::string& bytes, double value) {
  append_canonical(bytes, std::bit_cast<std::uint64_t>(value == 0 ? 0.0 : value));
}

}  // namespace oxturn
