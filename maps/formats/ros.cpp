// ROS map_server maps: a YAML file beside an image.
//
// Source     ros-planning/navigation map_server, image_loader.cpp; navigation2 nav2_map_server, map_io.cpp
// Decisions  1. p = (255 - grey) / 255 (negate: grey / 255); a cell is occupied above occupied_thresh, free below
//               free_thresh, else unknown, as in map_server's modes trinary and scale. Mode raw: the grey value is the
//               occupancy in percent, above 100 unknown; the thresholds then separate free from occupied.
//            2. Unlike map_server, alpha is not averaged into the grey value in mode trinary: that would turn the usual
//               grey of unknown (205) into free as soon as an image has an alpha channel. Pixels that are more than
//               half transparent (mode scale: transparent at all) are unknown.
//            3. A key that map_server requires is required here too; no default is guessed.
#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "base/files.hpp"
#include "base/text.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {
namespace {

/// The keys of a map's YAML file. Every error names the file and the line.
class RosYaml {
 public:
  explicit RosYaml(const std::string& file) : file_(file) {
    try {
      root_ = YAML::Load(read_file(file));
    } catch (const YAML::Exception& e) { throw_invalid("{}:{}: not YAML: {}", file, e.mark.line + 1, e.msg); }
    if (!root_.IsMap())
      throw_invalid(
          "{}: not a ROS map, expected keys image, resolution, origin, negate, "
          "occupied_thresh, free_thresh",
          file);
  }

  [[noreturn]] void refuse(const YAML::Node& at, const std::string& sentence) const {
    throw_invalid("{}:{}: {}", file_, at.Mark().line + 1, sentence);
  }
  bool has(const char* key) const { return static_cast<bool>(root_[key]); }
  YAML::Node at(const char* key, const char* expected) const {
    const YAML::Node node = root_[key];
    if (!node || node.IsNull()) throw_invalid("{}: {} is missing, expected {}", file_, key, expected);
    return node;
  }
  std::string text(const char* key, const char* expected) const {
    const YAML::Node node = at(key, expected);
    if (!node.IsScalar() || node.Scalar().empty())
      refuse(node, fmt::format("{} is not a string, expected {}", key, expected));
    return node.Scalar();
  }
  double number(const YAML::Node& node, const std::string& key, const char* expected) const {
    double value = 0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value))
      refuse(node, fmt::format("{} is {}, expected {}", key,
                               node.IsScalar() ? "'" + node.Scalar() + "'" : "not a number", expected));
    if (!std::isfinite(value)) refuse(node, fmt::format("{} is {}, expected {}", key, to_decimal(value), expected));
    return value;
  }
  double number(const char* key, const char* expected) const { return number(at(key, expected), key, expected); }
  double fraction(const char* key) const {
    const double value = number(key, "a number from 0 to 1");
    if (value < 0 || value > 1)
      refuse(root_[key], fmt::format("{} is {}, expected a number from 0 to 1", key, to_decimal(value)));
    return value;
  }
  bool flag(const char* key) const {
    const std::string given = text(key, "0 or 1");
    if (given == "0" || given == "false" || given == "False") return false;
    if (given == "1" || given == "true" || given == "True") return true;
    refuse(root_[key], fmt::format("{} is '{}', expected 0 or 1", key, given));
  }

 private:
  std::string file_;
  YAML::Node root_;
};

enum class Mode { trinary, scale, raw };

Mode mode_of(const RosYaml& yaml) {
  if (!yaml.has("mode")) return Mode::trinary;
  const char* expected = "trinary, scale or raw";
  const std::string given = yaml.text("mode", expected);
  if (given == "trinary") return Mode::trinary;
  if (given == "scale") return Mode::scale;
  if (given == "raw") return Mode::raw;
  yaml.refuse(yaml.at("mode", expected), fmt::format("mode is '{}', expected {}", given, expected));
}

Placement placement_of(const RosYaml& yaml) {
  Placement placement;
  const char* metres = "metres per pixel above 0";
  placement.resolution = yaml.number("resolution", metres);
  if (placement.resolution <= 0)
    yaml.refuse(yaml.at("resolution", metres),
                fmt::format("resolution is {}, expected {}", to_decimal(placement.resolution), metres));
  const char* three = "[x, y, yaw] in metres and radians";
  const YAML::Node origin = yaml.at("origin", three);
  if (!origin.IsSequence() || origin.size() < 2 || origin.size() > 3)
    yaml.refuse(origin, fmt::format("origin is not a list of three numbers, expected {}", three));
  placement.origin = {yaml.number(origin[0], "origin's x", "metres"), yaml.number(origin[1], "origin's y", "metres")};
  if (origin.size() == 3) placement.yaw = yaml.number(origin[2], "origin's yaw", "radians");
  return placement;
}

/// How grey values become occupancies.
struct Thresholds {
  Mode mode = Mode::trinary;
  bool negate = false;
  double occupied = 0, free = 0;

  Occupancy operator()(double grey) const {
    const double shade = negate ? 255 - grey : grey;
    if (mode == Mode::raw && shade > 100) return Occupancy::unknown;
    const double p = mode == Mode::raw ? shade / 100 : (255 - shade) / 255;
    return p > occupied ? Occupancy::occupied : p < free ? Occupancy::free : Occupancy::unknown;
  }
  /// Pixels with less alpha are unknown.
  int least_alpha() const { return mode == Mode::scale ? 255 : 128; }
};

Thresholds thresholds_of(const RosYaml& yaml) {
  Thresholds t;
  t.mode = mode_of(yaml);
  t.negate = yaml.flag("negate");
  t.occupied = yaml.fraction("occupied_thresh");
  t.free = yaml.fraction("free_thresh");
  if (t.free > t.occupied)
    yaml.refuse(yaml.at("free_thresh", ""),
                fmt::format("free_thresh is {}, expected at most occupied_thresh, which is {}", to_decimal(t.free),
                            to_decimal(t.occupied)));
  return t;
}

GreyImage image_of(const RosYaml& yaml, const std::string& name, const std::string& file) {
  try {
    return read_image((std::filesystem::path(file).parent_path() / name).string());
  } catch (const std::invalid_argument& e) { yaml.refuse(yaml.at("image", ""), e.what()); }
}

MapFile read_ros(const std::string& file, const RasterOptions& options) {
  const RosYaml yaml(file);
  const std::string name = yaml.text("image", "the image's file, relative to this one");
  const Placement placement = placement_of(yaml);
  const Thresholds occupancy = thresholds_of(yaml);
  const GreyImage image = image_of(yaml, name, file);
  OccupancyGrid cells(image.width, image.height);
  std::size_t transparent = 0;
  for (int row = 0; row < image.height; ++row)
    for (int i = 0; i < image.width; ++i) {
      const std::size_t pixel = image.index(i, row);
      if (!image.alpha.empty() && image.alpha[pixel] < occupancy.least_alpha())
        ++transparent;  // stays unknown
      else
        cells.at(i, row) = occupancy(static_cast<double>(image.grey[pixel]));
    }
  MapFile result = map_from_grid(file, cells, placement, options);
  if (transparent > 0)
    result.remarks.push_back(fmt::format("{} pixels are transparent and count as unknown", transparent));
  return result;
}

}  // namespace

MapFormat ros_format() {
  return describe_format<RasterOptions>("ros", "ROS map_server: YAML with a PNG or PGM image", {".yaml", ".yml"},
                                        with_raster_options<RasterOptions>({}), read_ros);
}

}  // namespace oxturn
