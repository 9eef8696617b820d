// PGM images (P2, P5) to grey values.

#include "maps/formats/readers.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostDigits = 9;

class PgmReader {
 public:
  PgmReader(const std::string& file, const std::string& bytes) : file_(file), bytes_(bytes) {}

  GreyImage read() {
    const bool binary = bytes_[1] == '5';
    at_ = 2;
    const double width = number("width"), height = number("height"), most = number("greatest value");
    check_image_size(file_, width, height);
    if (most < 1 || most > 65535) throw_invalid("{}: the greatest value is {}, expected 1 to 65535", file_, most);
    GreyImage image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    const std::size_t n = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const std::size_t bytes_per_pixel = most > 255 ? 2 : 1;
    check_remaining(n, binary, bytes_per_pixel);
    image.grey.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double value = binary ? binary_value(bytes_per_pixel) : number("pixel");
      if (value > most) throw_invalid("{}: pixel {} is {}, expected at most {}", file_, i + 1, value, most);
      image.grey[i] = static_cast<float>(value * 255 / most);
    }
    return image;
  }

 private:
  /// So that no memory is allocated for pixels that the file cannot contain.
  void check_remaining(std::size_t pixels, bool binary, std::size_t bytes_per_pixel) {
    if (binary) {
      ++at_;  // exactly one space after the header
      if (bytes_.size() < at_ || bytes_.size() - at_ < pixels * bytes_per_pixel) throw_end();
    } else if (bytes_.size() - at_ < 2 * pixels - 1) {  // each a digit, with spaces in between
      throw_end();
    }
  }
  [[noreturn]] void throw_end() const { throw_invalid("{}: the file ends in the middle of the image", file_); }
  double binary_value(std::size_t bytes_per_pixel) {
    double value = 0;
    for (std::size_t k = 0; k < bytes_per_pixel; ++k) value = 256 * value + static_cast<unsigned char>(bytes_[at_++]);
    return value;
  }
  static bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  /// The next whole number, after spaces and comments.
  double number(const char* what) {
    for (; at_ < bytes_.size() && (is_space(bytes_[at_]) || bytes_[at_] == '#'); ++at_)
      if (bytes_[at_] == '#')
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
    if (at_ >= bytes_.size()) throw_end();
    const std::size_t begin = at_;
    double value = 0;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_)
      value = 10 * value + (bytes_[at_] - '0');
    if (at_ == begin || at_ - begin > kMostDigits)
      throw_invalid("{}: {} is not a whole number (byte {})", file_, what, begin + 1);
    return value;
  }

  const std::string& file_;
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

GreyImage read_pgm(const std::string& file, const std::string& bytes) { return PgmReader(file, bytes).read(); }

}  // namespace oxturn
