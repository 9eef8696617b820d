// Pictures of maps, problems and paths, as SVG without external parts.
//
// Layers      grey walls; white free space; the target in a warm tint (what stays visible of it is not covered); the
//             tool's swath; named traces; transit, dashed grey; the path coloured by the distance driven, blue to red,
//             with white dots where the robot drives backwards; the tether at some moments, dark red, with dots where
//             it bends and a ring where the robot is; anchor, start and end; below, the scale bar in metres and the
//             colour key
// Complexity  O(n); the path takes at most a few hundred elements, and vertices too near to be seen are left out
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "maps/formats.hpp"
#include "maps/formats/svg_parts.hpp"
#include "maps/picture.hpp"

namespace oxturn {

std::string escape_xml(const std::string& text) {
  static const std::map<char, std::string> escapes{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string out;
  for (const char c : text)
    if (const auto escape = escapes.find(c); escape != escapes.end())
      out += escape->second;
    else
      out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;  // control characters are not allowed in XML
  return out;
}

namespace svg {
namespace {

constexpr double kMostCoordinate = 1e12;  // metres: points farther away are not drawn

/// Half the size of the marks of start, end and anchor, pixels.
double mark_size(const Canvas& canvas, const Problem& problem) {
  return std::clamp(problem.robot().tool_width * canvas.scale * 0.3, 3.5, 7.0);
}

/// A black diamond with a white border.
void append_anchor(std::string& out, const Canvas& canvas, const Problem& problem) {
  const Point at = canvas(problem.anchor());
  const double r = mark_size(canvas, problem) + 1.5;
  out += fmt::format(
      "<path id=\"anchor\" d=\"M{} {} {} {} {} {} {} {}Z\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"1.5\">"
      "<title>anchor</title></path>\n",
      px(at.x() - r), px(at.y()), px(at.x()), px(at.y() - r), px(at.x() + r), px(at.y()), px(at.x()), px(at.y() + r));
}

/// A red square.
void append_end(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path) {
  if (path.legs.empty()) return;
  const double r = mark_size(canvas, problem);
  const Point end = canvas(path.legs.back().points.back());
  out += fmt::format(
      "<rect id=\"end\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#c82020\" stroke=\"#fff\" "
      "stroke-width=\"1.5\"><title>end</title></rect>\n",
      px(end.x() - 0.8 * r), px(end.y() - 0.8 * r), px(1.6 * r), px(1.6 * r));
}

/// A green disc with a ring; the footprint, if there is one.
void append_start(std::string& out, const Canvas& canvas, const Problem& problem) {
  const double r = mark_size(canvas, problem);
  const Point start = canvas(problem.start());
  if (const Ring& footprint = problem.robot().footprint; !footprint.empty())
    out += fmt::format("<path id=\"footprint\" fill=\"none\" stroke=\"#0a7d2c\" stroke-width=\"1.2\" d=\"{}\"/>\n",
                       region_data(canvas, transformed({{{footprint, {}}}}, 0, problem.start())));
  out += fmt::format(
      "<g id=\"start\"><title>start</title><circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\" fill=\"none\" stroke=\"#0a7d2c\" "
      "stroke-width=\"1.6\"/><circle cx=\"{0}\" cy=\"{1}\" r=\"{3}\" fill=\"#12a33d\" stroke=\"#fff\" "
      "stroke-width=\"1.2\"/></g>\n",
      px(start.x()), px(start.y()), px(r + 4), px(r));
}

/// The path up to the first point that cannot be drawn.
Path drawable(const Path& path) {
  Path out;
  for (const Leg& leg : path.legs) {
    const auto bad = std::ranges::find_if_not(
        leg.points, [](const Point& p) { return finite(p) && p.cwiseAbs().maxCoeff() < kMostCoordinate; });
    if (bad - leg.points.begin() > 1) out.legs.push_back({leg.tool, {leg.points.begin(), bad}, leg.gear, leg.width});
    if (bad != leg.points.end()) break;
  }
  return out;
}

}  // namespace
}  // namespace svg

std::string to_svg(const Problem& problem, const Path* path, const PictureOptions& options) {
  const svg::Canvas canvas(bounding_box(problem.map().free), options.width_px);
  const bool tethered = problem.robot().tether.has_value();
  const Path shown = path != nullptr ? svg::drawable(*path) : Path{};
  std::string out;
  svg::append_frame(out, canvas, problem.map().name, problem.map().free);
  out += fmt::format("<path id=\"target\" fill=\"#fbe9c6\" fill-rule=\"evenodd\" d=\"{}\"/>\n",
                     svg::region_data(canvas, problem.target()));
  if (path != nullptr && options.swath) svg::append_swath(out, canvas, problem, shown);
  if (options.missed != nullptr) svg::append_missed(out, canvas, *options.missed);
  if (options.traces != nullptr) svg::append_traces(out, canvas, *options.traces);
  if (path != nullptr) svg::append_path(out, canvas, problem, shown);
  if (path != nullptr && tethered) svg::append_tethers(out, canvas, problem, shown, options.tethers, options.tolerance);
  svg::append_end(out, canvas, problem, shown);
  svg::append_start(out, canvas, problem);
  if (tethered) svg::append_anchor(out, canvas, problem);
  svg::append_scale_bar(out, canvas);
  if (path != nullptr) svg::append_colour_key(out, canvas);
  return out + "</svg>\n";
}

std::string to_svg(const Map& map, const PictureOptions& options) {
  const svg::Canvas canvas(bounding_box(map.free), options.width_px);
  std::string out;
  svg::append_frame(out, canvas, map.name, map.free);
  svg::append_scale_bar(out, canvas);
  return out + "</svg>\n";
}

}  // namespace oxturn
