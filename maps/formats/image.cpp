// Plain images as maps, with a scale.
//
// Decision   At most 10^8 pixels: an image's header may claim any size, and memory is allocated only below that.

#include "base/files.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {

void check_image_size(const std::string& file, double width, double height) {
  constexpr double kMostPixels = 1e8;
  if (width < 1 || height < 1)
    throw_invalid("{}: the image is {} x {} pixels, expected at least 1 x 1", file, width, height);
  if (width * height > kMostPixels)
    throw_invalid("{}: the image is {} x {} pixels, expected at most 100 million", file, width, height);
}

GreyImage read_image(const std::string& file) {
  const std::string bytes = read_file(file);
  if (bytes.empty()) throw_invalid("{}: the file is empty, expected a PNG or PGM image", file);
  if (is_png(bytes)) return read_png(file, bytes);
  if (bytes.size() >= 3 && bytes[0] == 'P' && (bytes[1] == '2' || bytes[1] == '5')) return read_pgm(file, bytes);
  throw_invalid("{}: neither a PNG nor a PGM (P2, P5) image, convert it to one", file);
}

namespace {

// map_server's usual thresholds: only what is nearly white is free, so that the usual grey of unknown is not.
constexpr double kFreeBelow = 0.196, kOccupiedAbove = 0.65;
constexpr int kLeastOpaque = 128;  // alpha: more than half transparent is unknown

struct ImageOptions : RasterOptions {
  double scale = 0;
};

Occupancy occupancy_of(const GreyImage& image, std::size_t pixel) {
  if (!image.alpha.empty() && image.alpha[pixel] < kLeastOpaque) return Occupancy::unknown;
  const double darkness = (255.0 - static_cast<double>(image.grey[pixel])) / 255.0;
  return darkness < kFreeBelow ? Occupancy::free : darkness > kOccupiedAbove ? Occupancy::occupied : Occupancy::unknown;
}

MapFile read_plain_image(const std::string& file, const ImageOptions& options) {
  if (options.scale <= 0)
    throw_invalid("{}: a plain image needs a scale in metres per pixel: --scale, or `scale` of the map in a suite",
                  file);
  const GreyImage image = read_image(file);
  OccupancyGrid cells(image.width, image.height);
  for (int row = 0; row < image.height; ++row)
    for (int i = 0; i < image.width; ++i) cells.at(i, row) = occupancy_of(image, image.index(i, row));
  return map_from_grid(file, cells, {{0, 0}, 0, options.scale}, options);
}

}  // namespace

MapFormat image_format() {
  return describe_format<ImageOptions>(
      "image", "plain PNG or PGM with a scale: white is free", {".png", ".pgm"},
      with_raster_options<ImageOptions>(
          {{"scale", &ImageOptions::scale, Range{0, 1e9}, "metres per pixel; required for plain images"}}),
      read_plain_image);
}

}  // namespace oxturn
