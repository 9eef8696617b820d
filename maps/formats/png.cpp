// PNG images to grey values, by libpng.
//
// Decision   libpng's full interface, not the simplified one: that would apply gAMA chunks and shift the grey values
//            for which map_server's thresholds are made.
#include <png.h>

#include <csetjmp>
#include <cstring>

#include "maps/formats/readers.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kSignature = 8;  // bytes
constexpr std::size_t kChannels = 4;   // red, green, blue, alpha
constexpr png_uint_32 kNoLimit = 0x7fffffff;

/// libpng reports errors by longjmp, so everything that owns memory lives here, outside of the functions that it
/// leaves.
struct PngDecoder {
  const std::string& bytes;
  std::size_t at = 0;
  std::string error;
  png_structp png = nullptr;
  png_infop info = nullptr;
  png_uint_32 width = 0, height = 0;
  std::vector<png_byte> pixels;
  std::vector<png_bytep> rows;
  explicit PngDecoder(const std::string& b) : bytes(b) {}
  PngDecoder(const PngDecoder&) = delete;
  PngDecoder& operator=(const PngDecoder&) = delete;
  ~PngDecoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

void read_bytes(png_structp png, png_bytep out, png_size_t count) {
  PngDecoder& decoder = *static_cast<PngDecoder*>(png_get_io_ptr(png));
  if (count > decoder.bytes.size() - decoder.at) png_error(png, "the file ends in the middle of the image");
  std::memcpy(out, decoder.bytes.data() + decoder.at, count);
  decoder.at += count;
}
void on_error(png_structp png, png_const_charp message) {
  static_cast<PngDecoder*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}
void on_warning(png_structp, png_const_charp) {}  // unusual ancillary chunks do not affect the pixels

/// Reads the header. False: `error` says why.
bool open(PngDecoder& decoder) {
  decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, on_error, on_warning);
  decoder.info = decoder.png ? png_create_info_struct(decoder.png) : nullptr;
  if (!decoder.info) {
    decoder.error = "out of memory";
    return false;
  }
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_set_read_fn(decoder.png, &decoder, read_bytes);
  png_set_user_limits(decoder.png, kNoLimit, kNoLimit);  // check_image_size has the better message
  png_read_info(decoder.png, decoder.info);
  decoder.width = png_get_image_width(decoder.png, decoder.info);
  decoder.height = png_get_image_height(decoder.png, decoder.info);
  png_set_expand(decoder.png);  // palettes, 1 2 4 bit and tRNS to 8 bit channels
  png_set_strip_16(decoder.png);
  png_set_gray_to_rgb(decoder.png);
  png_set_add_alpha(decoder.png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(decoder.png);
  png_read_update_info(decoder.png, decoder.info);
  if (png_get_rowbytes(decoder.png, decoder.info) != kChannels * static_cast<png_size_t>(decoder.width)) {
    decoder.error = "an unusual pixel layout";
    return false;
  }
  return true;
}

bool read_pixels(PngDecoder& decoder) {
  if (setjmp(png_jmpbuf(decoder.png))) return false;
  png_read_image(decoder.png, decoder.rows.data());
  png_read_end(decoder.png, nullptr);
  return true;
}

}  // namespace

bool is_png(const std::string& bytes) {
  return bytes.size() >= kSignature && png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, kSignature) == 0;
}

GreyImage read_png(const std::string& file, const std::string& bytes) {
  PngDecoder decoder(bytes);
  const auto fail = [&] { throw_invalid("{}: not a readable PNG: {}", file, decoder.error); };
  if (!open(decoder)) fail();
  check_image_size(file, decoder.width, decoder.height);
  const std::size_t row_bytes = static_cast<std::size_t>(decoder.width) * kChannels;
  decoder.pixels.resize(row_bytes * decoder.height);
  for (png_uint_32 j = 0; j < decoder.height; ++j)
    decoder.rows.push_back(decoder.pixels.data() + static_cast<std::size_t>(j) * row_bytes);
  if (!read_pixels(decoder)) fail();

  GreyImage image;
  image.width = static_cast<int>(decoder.width);
  image.height = static_cast<int>(decoder.height);
  const std::size_t n = decoder.pixels.size() / kChannels;
  image.grey.resize(n);
  image.alpha.resize(n);
  bool opaque = true;
  for (std::size_t i = 0; i < n; ++i) {
    const png_byte* p = &decoder.pixels[kChannels * i];
    image.grey[i] = static_cast<float>((p[0] + p[1] + p[2]) / 3.0);
    image.alpha[i] = p[3];
    opaque = opaque && p[3] == 255;
  }
  if (opaque) image.alpha.clear();
  return image;
}

}  // namespace oxturn
