// Pictures to grey values: PNG by libpng, PGM by hand; and plain pictures as maps.
//
// Decisions  1. libpng's full interface, not the simplified one: that would apply gAMA chunks and shift the grey
//               values that map_server's thresholds are made for.
//            2. At most 10^8 pixels: a header may claim anything, memory is asked for only below that.
#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <cstring>
#include <stdexcept>

#include "base/files.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {
namespace {

constexpr double kMostPixels = 1e8;

void check_size(const std::string& file, double width, double height) {
  if (width < 1 || height < 1)
    throw std::invalid_argument(
        fmt::format("{}: the picture is {} x {} pixels, expected at least 1 x 1", file, width, height));
  if (width * height > kMostPixels)
    throw std::invalid_argument(
        fmt::format("{}: the picture is {} x {} pixels, expected at most 100 million", file, width, height));
}

// --- PNG -------------------------------------------------------------------------------------------------

/// libpng leaves by longjmp, so all that owns memory lives here, outside the function that is left.
struct PngJob {
  const std::string& bytes;
  std::size_t at = 0;
  std::string error;
  png_structp png = nullptr;
  png_infop info = nullptr;
  png_uint_32 width = 0, height = 0;
  std::vector<png_byte> pixels;
  std::vector<png_bytep> rows;
  explicit PngJob(const std::string& b) : bytes(b) {}
  PngJob(const PngJob&) = delete;
  PngJob& operator=(const PngJob&) = delete;
  ~PngJob() { png_destroy_read_struct(&png, &info, nullptr); }
};

void png_feed(png_structp png, png_bytep out, png_size_t count) {
  PngJob& job = *static_cast<PngJob*>(png_get_io_ptr(png));
  if (count > job.bytes.size() - job.at) png_error(png, "the file ends in the middle of the picture");
  std::memcpy(out, job.bytes.data() + job.at, count);
  job.at += count;
}
void png_failed(png_structp png, png_const_charp message) {
  static_cast<PngJob*>(png_get_error_ptr(png))->error = message;
  png_longjmp(png, 1);
}
void png_warned(png_structp, png_const_charp) {}  // odd ancillary chunks do not touch the pixels

bool png_open(PngJob& job) {
  job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, png_failed, png_warned);
  job.info = job.png ? png_create_info_struct(job.png) : nullptr;
  if (!job.info) {
    job.error = "out of memory";
    return false;
  }
  if (setjmp(png_jmpbuf(job.png))) return false;
  png_set_read_fn(job.png, &job, png_feed);
  png_set_user_limits(job.png, 0x7fffffff, 0x7fffffff);  // check_size says it better
  png_read_info(job.png, job.info);
  job.width = png_get_image_width(job.png, job.info);
  job.height = png_get_image_height(job.png, job.info);
  png_set_expand(job.png);  // palettes, 1 2 4 bit and tRNS to 8 bit channels
  png_set_strip_16(job.png);
  png_set_gray_to_rgb(job.png);
  png_set_add_alpha(job.png, 0xff, PNG_FILLER_AFTER);
  png_set_interlace_handling(job.png);
  png_read_update_info(job.png, job.info);
  if (png_get_rowbytes(job.png, job.info) != 4u * static_cast<png_size_t>(job.width)) {
    job.error = "an unusual pixel layout";
    return false;
  }
  return true;
}

bool png_pixels(PngJob& job) {
  if (setjmp(png_jmpbuf(job.png))) return false;
  png_read_image(job.png, job.rows.data());
  png_read_end(job.png, nullptr);
  return true;
}

GreyImage read_png(const std::string& file, const std::string& bytes) {
  PngJob job(bytes);
  const auto fail = [&] { throw std::invalid_argument(fmt::format("{}: not a readable PNG: {}", file, job.error)); };
  if (!png_open(job)) fail();
  check_size(file, job.width, job.height);
  job.pixels.resize(static_cast<std::size_t>(job.width) * job.height * 4);
  for (png_uint_32 j = 0; j < job.height; ++j)
    job.rows.push_back(job.pixels.data() + static_cast<std::size_t>(j) * job.width * 4);
  if (!png_pixels(job)) fail();

  GreyImage image;
  image.width = static_cast<int>(job.width);
  image.height = static_cast<int>(job.height);
  const std::size_t n = static_cast<std::size_t>(job.width) * job.height;
  image.grey.resize(n);
  image.alpha.resize(n);
  bool opaque = true;
  for (std::size_t i = 0; i < n; ++i) {
    const png_byte* p = &job.pixels[4 * i];
    image.grey[i] = static_cast<float>((p[0] + p[1] + p[2]) / 3.0);
    image.alpha[i] = p[3];
    opaque = opaque && p[3] == 255;
  }
  if (opaque) image.alpha.clear();
  return image;
}

// --- PGM -------------------------------------------------------------------------------------------------

class PgmReader {
 public:
  PgmReader(const std::string& file, const std::string& bytes) : file_(file), bytes_(bytes) {}

  GreyImage read() {
    const bool binary = bytes_[1] == '5';
    at_ = 2;
    const double width = number("width"), height = number("height"), most = number("greatest value");
    check_size(file_, width, height);
    if (most < 1 || most > 65535)
      throw std::invalid_argument(fmt::format("{}: the greatest value is {}, expected 1 to 65535", file_, most));
    GreyImage image;
    image.width = static_cast<int>(width);
    image.height = static_cast<int>(height);
    const std::size_t n = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    const std::size_t wide = most > 255 ? 2 : 1;
    if (binary) {
      ++at_;  // exactly one blank after the header
      if (bytes_.size() < at_ || bytes_.size() - at_ < n * wide) ends();
    } else if (bytes_.size() - at_ < 2 * n - 1) {
      ends();  // a digit and a blank each: no memory is asked for what cannot be there
    }
    image.grey.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      double value = 0;
      if (!binary)
        value = number("pixel");
      else
        for (std::size_t k = 0; k < wide; ++k) value = 256 * value + static_cast<unsigned char>(bytes_[at_++]);
      if (value > most)
        throw std::invalid_argument(fmt::format("{}: pixel {} is {}, expected at most {}", file_, i + 1, value, most));
      image.grey[i] = static_cast<float>(value * 255 / most);
    }
    return image;
  }

 private:
  [[noreturn]] void ends() const {
    throw std::invalid_argument(fmt::format("{}: the file ends in the middle of the picture", file_));
  }
  static bool blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
  double number(const char* what) {
    for (; at_ < bytes_.size() && (blank(bytes_[at_]) || bytes_[at_] == '#'); ++at_)
      if (bytes_[at_] == '#')
        while (at_ < bytes_.size() && bytes_[at_] != '\n') ++at_;
    if (at_ >= bytes_.size()) ends();
    const std::size_t begin = at_;
    double value = 0;
    for (; at_ < bytes_.size() && bytes_[at_] >= '0' && bytes_[at_] <= '9'; ++at_)
      value = 10 * value + (bytes_[at_] - '0');
    if (at_ == begin || at_ - begin > 9)
      throw std::invalid_argument(fmt::format("{}: {} is not a whole number (byte {})", file_, what, begin + 1));
    return value;
  }

  const std::string& file_;
  const std::string& bytes_;
  std::size_t at_ = 0;
};

}  // namespace

GreyImage read_image(const std::string& file) {
  const std::string bytes = read_file(file);
  if (bytes.empty())
    throw std::invalid_argument(fmt::format("{}: the file is empty, expected a PNG or PGM picture", file));
  if (bytes.size() >= 8 && png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) == 0)
    return read_png(file, bytes);
  if (bytes.size() >= 3 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5'))
    return PgmReader(file, bytes).read();
  throw std::invalid_argument(
      fmt::format("{}: neither a PNG nor a PGM (P2, P5) picture, convert it to one of them", file));
}

namespace {

struct ImageOptions : RasterOptions {
  double scale = 0;
};

MapFile read_plain_image(const std::string& file, const ImageOptions& options) {
  if (options.scale <= 0)
    throw std::invalid_argument(fmt::format("{}: a plain image needs a scale; give scale = METRES_PER_PIXEL", file));
  const GreyImage image = read_image(file);
  std::vector<Occupancy> cells(image.grey.size());
  const std::size_t width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t from = row * width + i;
      const bool seen = image.alpha.empty() || image.alpha[from] >= 128;
      // ROS' usual free_thresh: only what is nearly white is free, so that the grey of unknown is not.
      const bool white = (255.0 - static_cast<double>(image.grey[from])) / 255.0 < 0.196;
      const bool black = (255.0 - static_cast<double>(image.grey[from])) / 255.0 > 0.65;
      cells[(height - 1 - row) * width + i] = !seen   ? Occupancy::unknown
                                              : white ? Occupancy::free
                                              : black ? Occupancy::occupied
                                                      : Occupancy::unknown;
    }
  return map_from_cells(file, image.width, image.height, std::move(cells), {{0, 0}, 0, options.scale}, options);
}

}  // namespace

MapFormat image_format() {
  return describe_format<ImageOptions>(
      "image", "plain PNG or PGM with a scale: white is free", {".png", ".pgm"},
      with_raster_options<ImageOptions>(
          {{"scale", &ImageOptions::scale, Range{0, 1e9}, "metres per pixel; a plain image does not say"}}),
      read_plain_image);
}

}  // namespace oxturn
