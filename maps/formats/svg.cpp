// A picture of a map, a problem or a path, as SVG that needs nothing from outside.
//
// Layers      grey walls; white free space; target in a warm tint (what stays visible of it is not covered); the
//             tool's swath; named traces; transit, dashed grey; the path coloured by the way driven, blue to red;
//             the tether at some moments, dark red, with dots where it bends and a ring where the robot is; anchor, start
//             and end; below, the scale bar in metres and the colour key
// Decisions   1. y points up in maps and down in SVG: flipped here, nowhere else.
//             2. Numbers are hundredths of a pixel, printed from integers: small, and the same on every machine.
//             3. Corners nearer than a quarter of a pixel to the last one drawn are left out of paths (a twentieth
//                for walls); the picture does not change, the file stays small.
//             4. The way is cut into at most kPieces stretches of equal length, one colour and one element each.
// Complexity  O(n)

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "geometry/trace.hpp"
#include "maps/formats.hpp"
#include "maps/formats/tether_moments.hpp"
#include "maps/picture.hpp"

namespace oxturn {
namespace {

constexpr int kPieces = 480;
constexpr double kMargin = 12;  // pixels
constexpr double kFooter = 34;  // pixels, for the scale bar

/// Hundredths of a pixel as a decimal: 1250 -> "12.5".
void append_hundredths(std::string& out, std::int64_t h) {
  if (h < 0) {
    out += '-';
    h = -h;
  }
  out += std::to_string(h / 100);
  const int rest = static_cast<int>(h % 100);
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / 10);
  if (rest % 10 != 0) out += static_cast<char>('0' + rest % 10);
}
std::int64_t hundredths(double px) { return std::llround(px * 100); }
std::string px(double value) {
  std::string out;
  append_hundredths(out, hundredths(value));
  return out;
}

/// From metres to pixels.
struct View {
  Point low{0, 0};
  double scale = 1, width = 0, height = 0;  // pixels a metre; size of the map's part of the picture

  View(const Box& box, double width_px) {
    const Point size = box.size();
    width = std::max(width_px, 100.0);
    const double inner = width - 2 * kMargin;
    // A tall map would make a picture of many screens: height at most twice the width.
    scale = std::min(inner / std::max(size.x(), 1e-9), 2 * inner / std::max(size.y(), 1e-9));
    low = box.low - Point((inner / scale - size.x()) / 2, 0);
    height = size.y() * scale + 2 * kMargin;
  }
  Point operator()(const Point& p) const {
    return {kMargin + (p.x() - low.x()) * scale, height - kMargin - (p.y() - low.y()) * scale};
  }
};

/// Path data of one polyline, in pixels, without the corners that nobody can see.
class Data {
 public:
  Data(const View& view, double least_px) : view_(view), least2_(least_px * least_px) {}
  void move(const Point& p) {
    flush();
    put('M', view_(p));
  }
  void line(const Point& p) {
    const Point at = view_(p);
    skipped_ = (at - last_).squaredNorm() < least2_;
    if (skipped_)
      skipped_at_ = at;
    else
      put('L', at);
  }
  void close() {
    skipped_ = false;
    text_ += 'Z';
  }
  bool empty() const { return text_.empty(); }
  std::string take() {
    flush();
    return std::exchange(text_, {});
  }

 private:
  void flush() {
    if (skipped_) put('L', skipped_at_);
    skipped_ = false;
  }
  void put(char letter, const Point& at) {
    // After M, further pairs are lines: the letter is not needed.
    if (letter == 'M')
      text_ += 'M';
    else
      text_ += ' ';
    append_hundredths(text_, hundredths(at.x()));
    text_ += ' ';
    append_hundredths(text_, hundredths(at.y()));
    last_ = at;
  }
  const View& view_;
  double least2_;
  std::string text_;
  Point last_{0, 0}, skipped_at_{0, 0};
  bool skipped_ = false;
};

std::string region_data(const View& view, const Region& region) {
  Data data(view, 0.05);
  for_each_ring(region, [&](const Ring& ring) {
    if (ring.empty()) return;
    data.move(ring.front());
    for (std::size_t i = 1; i < ring.size(); ++i) data.line(ring[i]);
    data.close();
  });
  return data.take();
}

std::string legs_data(const View& view, const Path& path, bool tool) {
  Data data(view, 0.25);
  for (const Leg& leg : path.legs) {
    if (leg.tool != tool || leg.points.empty()) continue;
    data.move(leg.points.front());
    for (std::size_t i = 1; i < leg.points.size(); ++i) data.line(leg.points[i]);
  }
  return data.take();
}

/// Blue, cyan, green, amber, red; `t` in [0, 1].
std::string colour(double t) {
  static constexpr std::array<std::array<int, 3>, 5> kStops{
      {{37, 66, 190}, {22, 142, 205}, {36, 160, 96}, {222, 150, 20}, {200, 32, 32}}};
  const double at = std::clamp(t, 0.0, 1.0) * (kStops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const double f = at - static_cast<double>(i);
  std::array<int, 3> c{};
  for (std::size_t k = 0; k < 3; ++k)
    c[k] = static_cast<int>(std::lround(kStops[i][k] + f * (kStops[i + 1][k] - kStops[i][k])));
  return fmt::format("#{:02x}{:02x}{:02x}", c[0], c[1], c[2]);
}

/// Work legs cut at equal stretches of the way driven (transit counts too), one element a stretch.
void append_coloured(std::string& out, const View& view, const Path& path, double line_px) {
  const double total = path.length();
  if (!(total > 0) || !std::isfinite(total)) return;
  out += fmt::format(
      "<g id=\"path\" fill=\"none\" stroke-width=\"{}\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n",
      px(line_px));
  int piece = 0;
  double driven = 0;
  Data data(view, 0.25);
  const auto finish = [&] {
    if (!data.empty())
      out += fmt::format("<path stroke=\"{}\" d=\"{}\"/>\n", colour((piece + 0.5) / kPieces), data.take());
  };
  for (const Leg& leg : path.legs) {
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point a = leg.points[i - 1], b = leg.points[i];
      const double len = distance(a, b);
      if (leg.tool && (i == 1 || data.empty())) data.move(a);
      // The piece ends inside this segment: cut there and go on in the next colour.
      while (piece + 1 < kPieces && driven + len > (piece + 1) * total / kPieces && len > 0) {
        const double cut = (piece + 1) * total / kPieces;
        const Point at = lerp(a, b, std::clamp((cut - driven) / len, 0.0, 1.0));
        if (leg.tool) data.line(at);
        finish();
        ++piece;
        if (leg.tool) data.move(at);
      }
      if (leg.tool) data.line(b);
      driven += len;
    }
  }
  finish();
  out += "</g>\n";
}

void append_traces(std::string& out, const View& view, const std::vector<Trace>& traces) {
  static constexpr std::array<const char*, 6> kColours{"#7a3fa8", "#0b7a75", "#b5651d",
                                                       "#d6336c", "#1b4f9c", "#5c7a00"};
  std::vector<std::string> names;  // traces of one name have one colour
  for (const Trace& trace : traces) {
    const auto known = std::find(names.begin(), names.end(), trace.name);
    const auto order = static_cast<std::size_t>(known - names.begin());
    if (known == names.end()) names.push_back(trace.name);
    Data data(view, 0.25);
    for (const Polyline& line : trace.lines) {
      if (line.empty()) continue;
      data.move(line.front());
      for (std::size_t i = 1; i < line.size(); ++i) data.line(line[i]);
    }
    out += fmt::format(
        "<g id=\"{0}\" fill=\"none\" stroke=\"{2}\" stroke-width=\"1\" stroke-opacity=\"0.7\">"
        "<title>{0}</title><path d=\"{1}\"/></g>\n",
        escape_xml(trace.name), data.take(), kColours[order % kColours.size()]);
  }
}

void append_tether(std::string& out, const View& view, const TetherMoment& moment) {
  Data data(view, 0);
  data.move(moment.line.front());
  for (std::size_t i = 1; i < moment.line.size(); ++i) data.line(moment.line[i]);
  out += fmt::format("<g stroke-width=\"{}\" stroke-opacity=\"{}\"><title>{:.4g} m of tether after {:.4g} m{}</title>",
                     moment.longest ? "2.2" : "1", moment.longest ? "1" : "0.7", moment.length, moment.path_m,
                     moment.longest ? ": the longest" : "");
  out += fmt::format("<path d=\"{}\"/>", data.take());
  for (std::size_t i = 1; i + 1 < moment.line.size(); ++i) {
    const Point bend = view(moment.line[i]);
    out += fmt::format("<circle class=\"bend\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#8b0000\" stroke=\"none\"/>",
                       px(bend.x()), px(bend.y()), moment.longest ? "3.2" : "2.4");
  }
  const Point robot = view(moment.line.back());
  out += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#fff\"/></g>\n", px(robot.x()), px(robot.y()),
                     moment.longest ? "4" : "2.6");
}

void append_tethers(std::string& out, const View& view, const Problem& problem, const Path& path, int count) {
  const std::vector<TetherMoment> moments = tether_moments(problem, path, count);
  if (moments.empty()) return;
  out += "<g id=\"tether\" fill=\"none\" stroke=\"#8b0000\" stroke-linejoin=\"round\">\n";
  for (const bool longest : {false, true})
    for (const TetherMoment& moment : moments)
      if (moment.longest == longest) append_tether(out, view, moment);
  out += "</g>\n";
}

/// The longest of 1, 2, 5 x 10^k metres that is at most a quarter of the picture.
double bar_metres(const View& view) {
  const double most = view.width / view.scale / 4;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double m : {5.0, 2.0})
    if (m * power <= most) return m * power;
  return power;
}

void append_footer(std::string& out, const View& view, bool key) {
  const double y = view.height + 10, metres = bar_metres(view), right = kMargin + metres * view.scale;
  out += fmt::format(
      "<g id=\"scale\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#333\">"
      "<path d=\"M{0} {1}V{2}H{3}V{1}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.5\"/>"
      "<text x=\"{4}\" y=\"{5}\">{6:g} m</text></g>\n",
      px(kMargin), px(y - 5), px(y + 2), px(right), px(right + 8), px(y + 5), metres);
  if (!key) return;
  const double key_width = 120, key_x = view.width - kMargin - key_width - 30;
  if (key_x < right + 90) return;  // no room beside the bar: the picture is understood without
  out += "<defs><linearGradient id=\"time\">";
  for (int i = 0; i <= 4; ++i)
    out += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>", i * 0.25, colour(i * 0.25));
  out += fmt::format(
      "</linearGradient></defs>\n<g id=\"key\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#333\">"
      "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">start</text><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"6\" "
      "fill=\"url(#time)\"/><text x=\"{}\" y=\"{}\">end</text></g>\n",
      px(key_x - 6), px(y + 5), px(key_x), px(y - 2), px(key_width), px(key_x + key_width + 6), px(y + 5));
}

std::string head(const View& view, const std::string& name, const Region& free) {
  const std::string w = px(view.width), h = px(view.height + kFooter - 6);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<rect width=\"{0}\" height=\"{3}\" fill=\"#9aa1a9\"/>\n",
      w, h, escape_xml(name), px(view.height));
  out += fmt::format(
      "<path id=\"free\" fill=\"#fff\" fill-rule=\"evenodd\" stroke=\"#4a5057\" stroke-width=\"0.8\" d=\"{}\"/>\n",
      region_data(view, free));
  return out;
}

void append_path(std::string& out, const View& view, const Problem& problem, const Path& path, bool swath) {
  const double tool_px = problem.robot().tool_width * view.scale;
  if (swath)
    out += fmt::format(
        "<path id=\"swath\" fill=\"none\" stroke=\"#b9d9f7\" stroke-opacity=\"0.8\" stroke-width=\"{}\" "
        "stroke-linecap=\"round\" stroke-linejoin=\"round\" d=\"{}\"/>\n",
        px(std::max(tool_px, 0.02)), legs_data(view, path, true));
}

void append_lines(std::string& out, const View& view, const Problem& problem, const Path& path) {
  const double tool_px = problem.robot().tool_width * view.scale;
  const double line_px = std::clamp(tool_px * 0.14, 0.5, 2.2);
  const std::string transit = legs_data(view, path, false);
  if (!transit.empty())
    out += fmt::format(
        "<path id=\"transit\" fill=\"none\" stroke=\"#555\" stroke-width=\"{}\" stroke-dasharray=\"{} {}\" "
        "d=\"{}\"/>\n",
        px(std::max(0.7, line_px * 0.8)), px(std::max(3.0, 3 * line_px)), px(std::max(2.0, 2 * line_px)), transit);
  append_coloured(out, view, path, line_px);
}

/// A black diamond with a white rim.
void append_anchor(std::string& out, const View& view, const Problem& problem) {
  const Point at = view(problem.anchor());
  const double r = std::clamp(problem.robot().tool_width * view.scale * 0.3, 3.5, 7.0) + 1.5;
  out += fmt::format(
      "<path id=\"anchor\" d=\"M{} {} {} {} {} {} {} {}Z\" fill=\"#111\" stroke=\"#fff\" stroke-width=\"1.5\">"
      "<title>anchor</title></path>\n",
      px(at.x() - r), px(at.y()), px(at.x()), px(at.y() - r), px(at.x() + r), px(at.y()), px(at.x()), px(at.y() + r));
}

void append_marks(std::string& out, const View& view, const Problem& problem, const Path* path) {
  const double r = std::clamp(problem.robot().tool_width * view.scale * 0.3, 3.5, 7.0);
  if (path != nullptr && !path->legs.empty() && !path->legs.back().points.empty() &&
      finite(path->legs.back().points.back())) {
    const Point end = view(path->legs.back().points.back());
    out += fmt::format(
        "<rect id=\"end\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#c82020\" stroke=\"#fff\" "
        "stroke-width=\"1.5\"><title>end</title></rect>\n",
        px(end.x() - 0.8 * r), px(end.y() - 0.8 * r), px(1.6 * r), px(1.6 * r));
  }
  const Point start = view(problem.start());
  if (const Ring& footprint = problem.robot().footprint; !footprint.empty())
    out += fmt::format("<path id=\"footprint\" fill=\"none\" stroke=\"#0a7d2c\" stroke-width=\"1.2\" d=\"{}\"/>\n",
                       region_data(view, transformed({{{footprint, {}}}}, 0, problem.start())));
  out += fmt::format(
      "<g id=\"start\"><title>start</title><circle cx=\"{0}\" cy=\"{1}\" r=\"{2}\" fill=\"none\" stroke=\"#0a7d2c\" "
      "stroke-width=\"1.6\"/><circle cx=\"{0}\" cy=\"{1}\" r=\"{3}\" fill=\"#12a33d\" stroke=\"#fff\" "
      "stroke-width=\"1.2\"/></g>\n",
      px(start.x()), px(start.y()), px(r + 4), px(r));
}

/// A path that is not finite has no picture; what can be drawn of it is everything up to there.
Path drawable(const Path& path) {
  Path out;
  for (const Leg& leg : path.legs) {
    Leg kept{leg.tool, {}};
    bool whole = true;
    for (const Point& p : leg.points) {
      whole = finite(p) && p.cwiseAbs().maxCoeff() < 1e12;
      if (!whole) break;
      kept.points.push_back(p);
    }
    if (kept.points.size() > 1) out.legs.push_back(std::move(kept));
    if (!whole) break;
  }
  return out;
}

}  // namespace

std::string escape_xml(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '"')
      out += "&quot;";
    else if (c == '\'')
      out += "&#39;";
    else if (static_cast<unsigned char>(c) < 0x20)
      out += ' ';  // control characters are not allowed in XML
    else
      out += c;
  }
  return out;
}

std::string to_svg(const Problem& problem, const Path* path, const PictureOptions& options) {
  const View view(bounding_box(problem.map().free), options.width_px);
  std::string out = head(view, problem.map().name, problem.map().free);
  out += fmt::format("<path id=\"target\" fill=\"#fbe9c6\" fill-rule=\"evenodd\" d=\"{}\"/>\n",
                     region_data(view, problem.target()));
  Path shown;
  if (path != nullptr) {
    shown = drawable(*path);
    append_path(out, view, problem, shown, options.swath);
  }
  if (options.traces != nullptr) append_traces(out, view, *options.traces);
  if (path != nullptr) append_lines(out, view, problem, shown);
  const bool tethered = problem.robot().tether.has_value();
  if (tethered && path != nullptr) append_tethers(out, view, problem, shown, options.tethers);
  append_marks(out, view, problem, path != nullptr ? &shown : nullptr);
  if (tethered) append_anchor(out, view, problem);
  append_footer(out, view, path != nullptr);
  return out + "</svg>\n";
}

std::string to_svg(const Map& map, const PictureOptions& options) {
  const View view(bounding_box(map.free), options.width_px);
  std::string out = head(view, map.name, map.free);
  append_footer(out, view, false);
  return out + "</svg>\n";
}

MapFormat svg_format() {
  MapFormat format{"svg", "picture of a map", {".svg"}, {}, {}, {}};
  format.write = [](const MapFile& file) { return to_svg(file.map); };
  return format;
}

}  // namespace oxturn
