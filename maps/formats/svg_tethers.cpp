#include <fmt/format.h>

#include <algorithm>

#include "maps/followed_path.hpp"
#include "maps/formats/svg_parts.hpp"

namespace oxturn::svg {
namespace {

/// The tether at one moment of a path.
struct TetherMoment {
  Polyline line;         // anchor, bends, robot
  double length = 0;     // metres, of the tether
  double path_m = 0;     // metres driven until then
  bool longest = false;  // the tether is never longer than here
};

constexpr double kSame = 1e-9;  // of the path's length: moments nearer than this are one

/// Metres driven until the tether is longest.
double longest_after(const Problem& problem, const Polyline& path) {
  TautTether tether = tether_at_start(problem);
  double most = tether.length(), driven = 0, after = 0;
  const auto note = [&](double length, double path_m) {
    if (length <= most) return;
    most = length;
    after = path_m;
  };
  for (const Point& to : path) {
    const Point from = tether.robot();
    tether.drive(to, [&](const TautTether::Swing& swing) {
      note(swing.before + distance(swing.pivot, swing.to), driven + distance(from, swing.to));
    });
    driven += distance(from, to);
    note(tether.length(), driven);
  }
  return after;
}

/// The moments in driving order, without their tethers.
std::vector<TetherMoment> chosen_moments(double total, int count, double longest) {
  std::vector<TetherMoment> moments;
  for (int k = 1; k <= count; ++k) moments.push_back({{}, 0, total * k / count, false});
  // Often the tether is longest at the end, which is one of these but for rounding.
  const auto same = std::ranges::find_if(
      moments, [&](const TetherMoment& m) { return std::abs(m.path_m - longest) <= kSame * total; });
  if (same != moments.end())
    same->longest = true;
  else
    moments.push_back({{}, 0, longest, true});
  std::ranges::stable_sort(moments, [](const TetherMoment& a, const TetherMoment& b) { return a.path_m < b.path_m; });
  return moments;
}

/// At `count` points of the path, equally far apart, the last at its end, and where the tether is longest; in driving
/// order. Up to where a tether can follow (maps/followed_path.hpp). Tethered problems only. Simulates the tether twice.
std::vector<TetherMoment> tether_moments(const Problem& problem, const Path& path, int count, double tolerance) {
  const Polyline points = followed_path(problem, path, problem.map_edges(), problem.tolerance() + tolerance).points;
  const double total = length(points);
  if (!(total > 0) || count <= 0) return {};
  std::vector<TetherMoment> moments = chosen_moments(total, count, longest_after(problem, points));
  TautTether tether = tether_at_start(problem);
  double driven = 0;
  auto next = moments.begin();
  const auto keep = [&] {
    next->line = tether.polyline();
    next->length = tether.length();
    ++next;
  };
  for (const Point& to : points) {
    const Point from = tether.robot();
    const double metres = distance(from, to);
    while (next != moments.end() && next->path_m < driven + metres) {
      tether.drive(lerp(from, to, std::clamp((next->path_m - driven) / metres, 0.0, 1.0)));
      keep();
    }
    tether.drive(to);
    driven += metres;
  }
  while (next != moments.end()) keep();
  return moments;
}

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

void append_tethers(std::string& out, const Canvas& canvas, const Problem& problem, const Path& path, int count,
                    double tolerance) {
  const std::vector<TetherMoment> moments = tether_moments(problem, path, count, tolerance);
  if (moments.empty()) return;
  out += "<g id=\"tether\" fill=\"none\" stroke=\"#8b0000\" stroke-linejoin=\"round\">\n";
  for (const bool longest : {false, true})  // the longest on top
    for (const TetherMoment& moment : moments)
      if (moment.longest == longest) append_tether(out, canvas, moment);
  out += "</g>\n";
}

}  // namespace oxturn::svg
