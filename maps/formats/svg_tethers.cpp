#include <fmt/format.h>

#include "maps/formats/svg_parts.hpp"
#include "maps/formats/tether_moments.hpp"

namespace oxturn::svg {
namespace {

/// Sizes in pixels, and opacity.
struct TetherStyle {
  const char *line, *opacity, *bend, *robot;
};
constexpr TetherStyle kOrdinary{"1", "0.7", "2.4", "2.6"}, kLongest{"2.2", "1", "3.2", "4"};

/// The tether, dots where it bends, a ring where the robot is.
void append_tether(std::string& out, const Canvas& canvas, const TetherMoment& moment) {
  const TetherStyle& style = moment.longest ? kLongest : kOrdinary;
  PathData data(canvas, 0);
  data.add(moment.line);
  out += fmt::format("<g stroke-width=\"{}\" stroke-opacity=\"{}\"><title>{:.4g} m of tether after {:.4g} m{}</title>",
                     style.line, style.opacity, moment.length, moment.path_m, moment.longest ? ": the longest" : "");
  out += fmt::format("<path d=\"{}\"/>", data.take());
  for (std::size_t i = 1; i + 1 < moment.line.size(); ++i) {
    const Point bend = canvas(moment.line[i]);
    out += fmt::format("<circle class=\"bend\" cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#8b0000\" stroke=\"none\"/>",
                       px(bend.x()), px(bend.y()), style.bend);
  }
  const Point robot = canvas(moment.line.back());
  out += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" fill=\"#fff\"/></g>\n", px(robot.x()), px(robot.y()),
                     style.robot);
}

}  // namespace

void append_tethers(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path, int count) {
  const std::vector<TetherMoment> moments = tether_moments(problem, path, count);
  if (moments.empty()) return;
  out += "<g id=\"tether\" fill=\"none\" stroke=\"#8b0000\" stroke-linejoin=\"round\">\n";
  for (const bool longest : {false, true})  // the longest on top
    for (const TetherMoment& moment : moments)
      if (moment.longest == longest) append_tether(out, canvas, moment);
  out += "</g>\n";
}

}  // namespace oxturn::svg
