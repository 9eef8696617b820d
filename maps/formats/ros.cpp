// ROS map_server maps: YAML beside a picture.
//
// Source     ros-planning/navigation map_server, image_loader.cpp; navigation2 nav2_map_server, map_io.cpp
// Decisions  1. p = (255 - grey) / 255 (negate: grey / 255); occupied above occupied_thresh, free below free_thresh,
//               else unknown, as map_server has it in its modes trinary and scale. Mode raw: the grey value is the
//               occupancy in percent, above 100 unknown; the thresholds then tell free from occupied.
//            2. Unlike map_server, alpha is not averaged into the grey value in mode trinary: that turns the usual
//               grey of unknown (205) into free as soon as a picture has an alpha channel. Pixels that are more
//               than half transparent (mode scale: at all) are unknown.
//            3. A key that map_server demands is demanded here too; no default is guessed.
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

class RosYaml {
 public:
  explicit RosYaml(const std::string& file) : file_(file) {
    try {
      root_ = YAML::Load(read_file(file));
    } catch (const YAML::Exception& e) {
      throw std::invalid_argument(fmt::format("{}:{}: not YAML: {}", file, e.mark.line + 1, e.msg));
    }
    if (!root_.IsMap())
      throw std::invalid_argument(
          fmt::format("{}: not a ROS map, expected keys image, resolution, origin, negate, "
                      "occupied_thresh, free_thresh",
                      file));
  }

  [[noreturn]] void refuse(const YAML::Node& at, const std::string& sentence) const {
    throw std::invalid_argument(fmt::format("{}:{}: {}", file_, at.Mark().line + 1, sentence));
  }
  bool has(const char* key) const { return static_cast<bool>(root_[key]); }
  YAML::Node at(const char* key, const char* expected) const {
    const YAML::Node node = root_[key];
    if (!node || node.IsNull())
      throw std::invalid_argument(fmt::format("{}: {} is missing, expected {}", file_, key, expected));
    return node;
  }
  std::string text(const char* key, const char* expected) const {
    const YAML::Node node = at(key, expected);
    if (!node.IsScalar() || node.Scalar().empty())
      refuse(node, fmt::format("{} is not a text, expected {}", key, expected));
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

MapFile read_ros(const std::string& file, const RasterOptions& options) {
  const RosYaml yaml(file);
  const std::string name = yaml.text("image", "the picture's file, relative to this one");
  const Placement placement = placement_of(yaml);
  const Mode mode = mode_of(yaml);
  const bool negate = yaml.flag("negate");
  const double occupied = yaml.fraction("occupied_thresh"), free = yaml.fraction("free_thresh");
  if (free > occupied)
    yaml.refuse(yaml.at("free_thresh", ""),
                fmt::format("free_thresh is {}, expected at most occupied_thresh, which is {}", to_decimal(free),
                            to_decimal(occupied)));
  const std::string picture = (std::filesystem::path(file).parent_path() / name).string();
  GreyImage image;
  try {
    image = read_image(picture);
  } catch (const std::invalid_argument& e) { yaml.refuse(yaml.at("image", ""), e.what()); }

  const int least_alpha = mode == Mode::scale ? 255 : 128;
  std::vector<Occupancy> cells(image.grey.size());
  const std::size_t width = static_cast<std::size_t>(image.width), height = static_cast<std::size_t>(image.height);
  std::size_t transparent = 0;
  for (std::size_t row = 0; row < height; ++row)
    for (std::size_t i = 0; i < width; ++i) {
      const std::size_t from = row * width + i;
      const double grey = static_cast<double>(image.grey[from]), shade = negate ? 255 - grey : grey;
      const double p = mode == Mode::raw ? shade / 100 : (255 - shade) / 255;
      Occupancy& cell = cells[(height - 1 - row) * width + i];
      if (!image.alpha.empty() && image.alpha[from] < least_alpha) {
        cell = Occupancy::unknown;
        ++transparent;
      } else if (mode == Mode::raw && shade > 100) {
        cell = Occupancy::unknown;
      } else {
        cell = p > occupied ? Occupancy::occupied : p < free ? Occupancy::free : Occupancy::unknown;
      }
    }
  MapFile result = map_from_cells(file, image.width, image.height, std::move(cells), placement, options);
  if (transparent > 0)
    result.remarks.push_back(fmt::format("{} pixels are transparent and count as unknown", transparent));
  return result;
}

}  // namespace

MapFormat ros_format() {
  return describe_format<RasterOptions>("ros", "ROS map_server: YAML with a PNG or PGM picture", {".yaml", ".yml"},
                                        with_raster_options<RasterOptions>({}), read_ros);
}

}  // namespace oxturn
