// The one list of map formats.
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "maps/formats/readers.hpp"
#include "base/files.hpp"
#include "base/text.hpp"

namespace oxturn {
namespace {

void check(const ReadOptions& options) {
  const auto refuse_negative = [](const char* name, double value, const char* unit) {
    if (!std::isfinite(value) || value < 0)
      throw std::invalid_argument(fmt::format("{} is {}, expected {} of at least 0", name, to_decimal(value), unit));
  };
  refuse_negative("scale", options.metres_per_pixel, "metres per pixel");
  refuse_negative("speckle", options.drop_speckle_m2, "square metres");
  refuse_negative("simplify", options.simplify_m, "metres");
}

}  // namespace

const std::vector<MapFormat>& map_formats() {
  static const std::vector<MapFormat> formats{
      {"ros", "ROS map_server: YAML with a PNG or PGM picture", {".yaml", ".yml"}, read_ros},
      {"geojson", "GeoJSON: Polygon or MultiPolygon in planar metres", {".geojson", ".json"}, read_geojson},
      {"image", "plain PNG or PGM with a scale: white is free", {".png", ".pgm"}, read_plain_image},
  };
  return formats;
}

MapFile read_map(const std::string& file, const ReadOptions& options) {
  check(options);
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0 || S_ISDIR(about.st_mode)) (void)read_file(file);  // says why, by throwing
  std::string suffix = std::filesystem::path(file).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::vector<std::string> known;
  for (const MapFormat& format : map_formats())
    for (const std::string& one : format.suffixes) {
      if (one == suffix) return format.read(file, options);
      known.push_back(one);
    }
  throw std::invalid_argument(
      fmt::format("{}: unknown kind of map '{}', expected one of: {}", file, suffix, fmt::join(known, ", ")));
}

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

}  // namespace oxturn
