// SVG files: drawings in, pictures of maps out. A drawing's map is its canvas.
#include <algorithm>
#include <filesystem>

#include "base/files.hpp"
#include "maps/drawing_edits.hpp"
#include "maps/drawing_file.hpp"
#include "maps/formats/readers.hpp"
#include "maps/picture.hpp"
#include "maps/svg_drawing.hpp"

namespace oxturn {
namespace {

struct Params : DrawingOptions {
  std::string edits;
};

/// The drawing robot of Vollprecht 2014. It may drive up to the drawing's margin.
Robot drawing_robot(const DrawingOptions& options) {
  constexpr double kRadius = 0.2;  // metres
  Robot robot;
  robot.name = "beachbot";
  robot.radius = std::min(kRadius, options.margin);
  robot.tool_width = options.width_7;
  return robot;
}

/// The edits' file is named as seen from the drawing's folder.
Drawing with_edits(Drawing drawing, const std::string& file, const std::string& edits) {
  const std::string name = (std::filesystem::path(file).parent_path() / edits).string();
  return edited(std::move(drawing), read_file(name), name);
}

MapFile read_drawing(const std::string& file, const Params& options) {
  SvgDrawing read = drawing_from_svg(read_file(file), file, options);
  if (!options.edits.empty()) read.drawing = with_edits(std::move(read.drawing), file, options.edits);
  MapFile result;
  result.map = {stem_of(file), box_region({0, 0}, {options.canvas_width, options.canvas_height}), "file", file};
  result.robot = drawing_robot(options);
  result.start = read.drawing.start;
  if (Region area = drawn_area(read.drawing); !area.empty()) result.map.target_area = std::move(area);
  result.map.drawing = std::make_shared<const Drawing>(std::move(read.drawing));
  result.remarks = std::move(read.remarks);
  return result;
}

std::vector<Parameter<Params>> parameters() {
  using O = Params;
  const Range width{0, 1e6, true};
  return {{"canvas_width", &DrawingOptions::canvas_width, width, "metres, of a drawing's canvas"},
          {"canvas_height", &DrawingOptions::canvas_height, width, "metres, of a drawing's canvas"},
          {"margin", &DrawingOptions::margin, Range{0, 1e6},
           "metres that a drawing leaves empty along its canvas's boundary"},
          {"width_1", &DrawingOptions::width_1, width, "metres that a stroke up to 1 pixel wide draws"},
          {"width_3", &DrawingOptions::width_3, width, "metres that a stroke up to 3 pixels wide draws"},
          {"width_5", &DrawingOptions::width_5, width, "metres that a stroke up to 5 pixels wide draws"},
          {"width_7", &DrawingOptions::width_7, width, "metres that a wider stroke draws"},
          {"edits", &O::edits, Choices{}, "a drawing's edits, JSON; named as seen from the drawing's folder"},
          {"literal", &DrawingOptions::literal,
           "drawings as Vollprecht 2014 reads them: widths as written, white does not erase"}};
}

}  // namespace

MapFormat svg_format() {
  return describe_format<Params>("svg", "SVG: a drawing in, a picture of a map out", {".svg"}, parameters(),
                                 read_drawing, [](const MapFile& file) { return to_svg(file.map); });
}

}  // namespace oxturn
