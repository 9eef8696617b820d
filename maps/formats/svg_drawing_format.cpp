// SVG files: drawings in, pictures of maps out. A drawing's map is its canvas.
#include "base/files.hpp"
#include "maps/formats/readers.hpp"
#include "maps/picture.hpp"
#include "maps/svg_drawing.hpp"

namespace oxturn {
namespace {

MapFile read_drawing(const std::string& file, const DrawingOptions& options) {
  SvgDrawing read = drawing_from_svg(read_file(file), file, options);
  MapFile result;
  result.map = {stem_of(file), box_region({0, 0}, {options.canvas_width, options.canvas_height}), "file", file};
  result.start = read.drawing.start;
  if (Region area = drawn_area(read.drawing); !area.empty()) result.map.target_area = std::move(area);
  result.map.drawing = std::make_shared<const Drawing>(std::move(read.drawing));
  result.remarks = std::move(read.remarks);
  return result;
}

}  // namespace

std::vector<Parameter<DrawingOptions>> drawing_parameters() {
  using O = DrawingOptions;
  const Range width{0, 1e6, true};
  return {{"canvas_width", &O::canvas_width, width, "metres, of a drawing's canvas"},
          {"canvas_height", &O::canvas_height, width, "metres, of a drawing's canvas"},
          {"margin", &O::margin, Range{0, 1e6}, "metres that a drawing leaves empty along its canvas's boundary"},
          {"width_1", &O::width_1, width, "metres that a stroke up to 1 pixel wide draws"},
          {"width_3", &O::width_3, width, "metres that a stroke up to 3 pixels wide draws"},
          {"width_5", &O::width_5, width, "metres that a stroke up to 5 pixels wide draws"},
          {"width_7", &O::width_7, width, "metres that a wider stroke draws"},
          {"literal", &O::literal, "drawings as Vollprecht 2014 reads them: widths as written, white does not erase"}};
}

MapFormat svg_format() {
  return describe_format<DrawingOptions>("svg", "SVG: a drawing in, a picture of a map out", {".svg"},
                                         drawing_parameters(), read_drawing,
                                         [](const MapFile& file) { return to_svg(file.map); });
}

}  // namespace oxturn
