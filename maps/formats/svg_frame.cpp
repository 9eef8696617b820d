#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "maps/formats/svg_parts.hpp"
#include "maps/picture.hpp"

namespace oxturn::svg {
namespace {

// Pixels.
constexpr double kFooter = 28;     // height of the strip below the map
constexpr double kKeyWidth = 120;  // of the colour key

/// The longest of 1, 2, 5 x 10^k metres that takes at most a quarter of the picture.
double bar_metres(const Canvas& canvas) {
  const double most = canvas.width / canvas.scale / 4;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double m : {5.0, 2.0})
    if (m * power <= most) return m * power;
  return power;
}

double bar_right(const Canvas& canvas) { return kMargin + bar_metres(canvas) * canvas.scale; }
double footer_y(const Canvas& canvas) { return canvas.height + 10; }

}  // namespace

void append_frame(std::string& out, const Canvas& canvas, const std::string& name, const Region& free) {
  const std::string w = px(canvas.width), h = px(canvas.height + kFooter);
  out += fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<title>{2}</title>\n"
      "<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n"
      "<rect width=\"{0}\" height=\"{3}\" fill=\"#9aa1a9\"/>\n",
      w, h, escape_xml(name), px(canvas.height));
  out += fmt::format(
      "<path id=\"free\" fill=\"#fff\" fill-rule=\"evenodd\" stroke=\"#4a5057\" stroke-width=\"0.8\" d=\"{}\"/>\n",
      region_data(canvas, free));
}

void append_scale_bar(std::string& out, const Canvas& canvas) {
  const double y = footer_y(canvas), right = bar_right(canvas);
  out += fmt::format(
      "<g id=\"scale\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#333\">"
      "<path d=\"M{0} {1}V{2}H{3}V{1}\" fill=\"none\" stroke=\"#333\" stroke-width=\"1.5\"/>"
      "<text x=\"{4}\" y=\"{5}\">{6:g} m</text></g>\n",
      px(kMargin), px(y - 5), px(y + 2), px(right), px(right + 8), px(y + 5), bar_metres(canvas));
}

void append_colour_key(std::string& out, const Canvas& canvas) {
  const double y = footer_y(canvas), x = canvas.width - kMargin - kKeyWidth - 30;
  if (x < bar_right(canvas) + 90) return;
  out += "<defs><linearGradient id=\"time\">";
  for (int i = 0; i <= 4; ++i)
    out += fmt::format("<stop offset=\"{}\" stop-color=\"{}\"/>", i * 0.25, time_colour(i * 0.25));
  out += fmt::format(
      "</linearGradient></defs>\n<g id=\"key\" font-family=\"sans-serif\" font-size=\"13\" fill=\"#333\">"
      "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">start</text><rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"6\" "
      "fill=\"url(#time)\"/><text x=\"{}\" y=\"{}\">end</text></g>\n",
      px(x - 6), px(y + 5), px(x), px(y - 2), px(kKeyWidth), px(x + kKeyWidth + 6), px(y + 5));
}

std::string time_colour(double t) {
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

}  // namespace oxturn::svg
