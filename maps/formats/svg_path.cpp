#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "geometry/point_count.hpp"
#include "maps/formats/svg_parts.hpp"
#include "maps/picture.hpp"

namespace oxturn::svg {
namespace {

constexpr std::size_t kMostShaded = 20'000;  // vertices of a path whose overlap is shaded
constexpr int kArrows = 24;
constexpr int kPieces = 480;  // of the path, each with a colour and an element of its own

/// A change of heading by more than 60 degrees.
bool sharp_turn(const Point& a, const Point& b, const Point& c) {
  const Point before = b - a, after = c - b;
  return before.dot(after) < 0.5 * before.norm() * after.norm();
}

/// The legs for which `wanted` holds.
template <class Wanted>
std::string legs_data(const Canvas& canvas, const Path& path, Wanted wanted) {
  PathData data(canvas, kLeastLineStep);
  for (const Leg& leg : path.legs)
    if (wanted(leg)) data.add(leg.points);
  return data.take();
}
constexpr auto works = [](const Leg& leg) { return leg.tool; };
constexpr auto transits = [](const Leg& leg) { return !leg.tool; };
constexpr auto reverses = [](const Leg& leg) { return leg.gear == Gear::reverse; };

/// The work legs in pieces, each one colour. The whole path (transit too) is divided into kPieces equal lengths.
class ColouredPath {
 public:
  ColouredPath(std::string& out, const Canvas& canvas, double total)
      : out_(out), data_(canvas, kLeastLineStep), total_(total) {}

  void add(const Leg& leg) {
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point a = leg.points[i - 1], b = leg.points[i];
      const double len = distance(a, b);
      if (leg.tool && (i == 1 || data_.empty())) data_.move(a);
      // Where a piece ends within this segment the next colour begins.
      while (piece_ + 1 < kPieces && driven_ + len > piece_end() && len > 0) {
        const Point at = lerp(a, b, std::clamp((piece_end() - driven_) / len, 0.0, 1.0));
        if (leg.tool) data_.line(at);
        finish_piece();
        ++piece_;
        if (leg.tool) data_.move(at);
      }
      if (leg.tool) data_.line(b);
      driven_ += len;
    }
  }
  void finish_piece() {
    if (!data_.empty())
      out_ += fmt::format("<path stroke=\"{}\" d=\"{}\"/>\n", time_colour((piece_ + 0.5) / kPieces), data_.take());
  }

 private:
  double piece_end() const { return (piece_ + 1) * total_ / kPieces; }  // metres
  std::string& out_;
  PathData data_;
  double total_, driven_ = 0;  // metres
  int piece_ = 0;
};

void append_work(std::string& out, const Canvas& canvas, const Path& path, double line_px) {
  const double total = path.length();
  if (!(total > 0) || !std::isfinite(total)) return;
  out += fmt::format(
      "<g id=\"path\" fill=\"none\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
      px(line_px));
  ColouredPath coloured(out, canvas, total);
  for (const Leg& leg : path.legs) coloured.add(leg);
  coloured.finish_piece();
  out += "</g>\n";
}

std::string line_data(const Canvas& canvas, const Polyline& line) {
  PathData data(canvas, kLeastLineStep);
  data.add(line);
  return data.take();
}

/// A part of the work, and the width that it uses, metres; 0: all of the tool.
struct SwathPart {
  std::string data;
  double width = 0;
};

/// The work in parts that end at sharp turns, so that each part shades what another one has covered already. Very long
/// paths are one part.
std::vector<SwathPart> swath_parts(const Canvas& canvas, const Path& path) {
  std::vector<SwathPart> parts;
  if (point_count(path.legs) > kMostShaded) {
    std::set<double> widths;
    for (const Leg& leg : path.legs) widths.insert(leg.width);
    for (const double width : widths)
      parts.push_back({legs_data(canvas, path, [&](const Leg& leg) { return leg.tool && leg.width == width; }), width});
    return parts;
  }
  for (const Leg& leg : path.legs) {
    if (!leg.tool) continue;
    Polyline part;
    for (const Point& p : leg.points) {
      if (part.size() > 1 && sharp_turn(part[part.size() - 2], part.back(), p)) {
        parts.push_back({line_data(canvas, part), leg.width});
        part = {part.back()};
      }
      if (part.empty() || part.back() != p) part.push_back(p);
    }
    parts.push_back({line_data(canvas, part), leg.width});
  }
  return parts;
}

/// White dots on the legs that are driven backwards.
void append_reverse(std::string& out, const Canvas& canvas, const Path& path, double line_px) {
  const std::string reverse = legs_data(canvas, path, reverses);
  if (!reverse.empty())
    out += fmt::format(
        "<path id=\"reverse\" fill=\"none\" stroke=\"#fff\" stroke-width=\"{}\" stroke-linecap=\"round\" "
        "stroke-dasharray=\"0 {}\" d=\"{}\"><title>driven backwards</title></path>\n",
        px(std::max(0.4, 0.6 * line_px)), px(std::max(3.0, 2.5 * line_px)), reverse);
}

/// Arrowheads in the direction of driving, equally spaced along the work.
void append_arrows(std::string& out, const Canvas& canvas, const Path& path, double size) {
  const double total = path.length(true);
  if (!(total > 0) || !std::isfinite(total)) return;
  const double step = total / kArrows;
  double next = step / 2, driven = 0;
  PathData data(canvas, 0);
  for (const Leg& leg : path.legs) {
    if (!leg.tool) continue;
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point a = leg.points[i - 1], b = leg.points[i];
      const double len = distance(a, b);
      for (; next < driven + len; next += step) {
        const Point tip = lerp(a, b, (next - driven) / len), back = size * (a - b) / len,
                    side = 0.5 * perpendicular(back);
        data.add({tip + back + side, tip, tip + back - side});
      }
      driven += len;
    }
  }
  out += fmt::format(
      "<path id=\"direction\" fill=\"none\" stroke=\"#222\" stroke-width=\"1\" stroke-linejoin=\"round\" "
      "d=\"{}\"/>\n",
      data.take());
}

}  // namespace

void append_swath(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path) {
  const double tool_px = problem.robot().tool_width * canvas.scale;
  out += fmt::format(
      "<clipPath id=\"inside\"><path clip-rule=\"evenodd\" d=\"{}\"/></clipPath>\n"
      "<g id=\"swath\" clip-path=\"url(#inside)\" fill=\"none\" stroke=\"#8fc3f2\" stroke-opacity=\"0.55\" "
      "stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
      region_data(canvas, problem.map().free), px(std::max(tool_px, 0.02)));
  for (const SwathPart& part : swath_parts(canvas, path)) {
    const std::string width = part.width > 0 ? fmt::format("stroke-width=\"{}\" ", px(part.width * canvas.scale)) : "";
    out += fmt::format("<path {}d=\"{}\"/>\n", width, part.data);
  }
  out += "</g>\n";
}

void append_missed(std::string& out, const Canvas& canvas, const std::vector<Ring>& missed) {
  if (missed.empty()) return;
  PathData data(canvas, 0);
  for (const Ring& ring : missed) {
    data.add(ring);
    data.close();
  }
  // The outline closes the seams between the parts of a piece and keeps small pieces visible.
  out += fmt::format(
      "<path id=\"missed\" fill=\"#e5006d\" stroke=\"#e5006d\" stroke-width=\"1.2\" stroke-linejoin=\"round\" "
      "d=\"{}\"/>\n",
      data.take());
}

void append_path(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path) {
  const double tool_px = problem.robot().tool_width * canvas.scale;
  const double line_px = std::clamp(tool_px * 0.14, 0.5, 2.2);
  const std::string transit = legs_data(canvas, path, transits);
  if (!transit.empty())
    out += fmt::format(
        "<path id=\"transit\" fill=\"none\" stroke=\"#555\" stroke-width=\"{}\" stroke-dasharray=\"{} {}\" "
        "d=\"{}\"/>\n",
        px(std::max(0.7, line_px * 0.8)), px(std::max(3.0, 3 * line_px)), px(std::max(2.0, 2 * line_px)), transit);
  append_work(out, canvas, path, line_px);
  append_reverse(out, canvas, path, line_px);
  append_arrows(out, canvas, path, std::max(5.0, 3 * line_px) / canvas.scale);
}

void append_traces(std::string& out, const Canvas& canvas, const std::vector<Trace>& traces) {
  static constexpr std::array<const char*, 6> kColours{"#7a3fa8", "#0b7a75", "#b5651d",
                                                       "#d6336c", "#1b4f9c", "#5c7a00"};
  std::vector<std::string> names;  // in order of appearance
  for (const Trace& trace : traces) {
    const auto known = std::find(names.begin(), names.end(), trace.name);
    const auto order = static_cast<std::size_t>(known - names.begin());
    if (known == names.end()) names.push_back(trace.name);
    PathData data(canvas, kLeastLineStep);
    for (const Polyline& line : trace.lines) data.add(line);
    out += fmt::format(
        "<g id=\"{0}\" fill=\"none\" stroke=\"{2}\" stroke-width=\"1\" stroke-opacity=\"0.7\">"
        "<title>{0}</title><path d=\"{1}\"/></g>\n",
        escape_xml(trace.name), data.take(), kColours[order % kColours.size()]);
  }
}

}  // namespace oxturn::svg
