#include "maps/drawing_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/math.hpp"
#include "base/text.hpp"

namespace oxturn {
namespace {

constexpr double kStep = 0.05;        // metres
constexpr double kTurn = kPi / 9;     // radians: flattened curves turn by less at a vertex
constexpr double kWidthRound = 1.01;  // widths that differ by less are the same

int pins_of(const Leg& leg, const DrawingOptions& o) {
  if (!leg.tool) return 0;
  if (leg.width <= 0) return 7;
  if (leg.width <= o.width_1 * kWidthRound) return 1;
  if (leg.width <= o.width_3 * kWidthRound) return 3;
  return leg.width <= o.width_5 * kWidthRound ? 5 : 7;
}

/// The middle `pins` of seven bits.
int mask_of(int pins) {
  const int all = (1 << pins) - 1;
  return pins == 0 ? 0 : all << (7 - pins) / 2;
}

bool turns(const Point& a, const Point& b, const Point& c) {
  const Point before = b - a, after = c - b;
  return std::abs(math::atan2(cross(before, after), before.dot(after))) > kTurn;
}

/// A part of the path that is driven without a stop or a change of the rake.
struct Run {
  Polyline points;
  int rake = 0;
  bool stop = false;  // the robot stops and turns at its end
};

std::vector<Run> runs_of(const Path& path, const DrawingOptions& options, RakeText rake) {
  std::vector<Run> runs;
  const Leg* before = nullptr;
  for (const Leg& leg : path.legs) {
    const int pins = pins_of(leg, options), value = rake == RakeText::pins ? pins : mask_of(pins);
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      const Point& p = leg.points[i];
      if (runs.empty()) runs.push_back({{p}, value, false});
      Polyline& line = runs.back().points;
      if (p == line.back()) continue;
      const bool gear = before != nullptr && before->gear != leg.gear;
      const bool stop = gear || (line.size() > 1 ? turns(line[line.size() - 2], line.back(), p) : false);
      if (stop || value != runs.back().rake) {
        const Point from = line.back();
        runs.back().stop = stop;
        runs.push_back({{from}, value, false});
      }
      runs.back().points.push_back(p);
      before = &leg;
    }
  }
  return runs;
}

void append_line(std::string& text, const Point& p, int rake) {
  // To a hundredth of a millimetre: shorter than what the robot can follow.
  const auto rounded = [](double v) { return to_decimal(std::round(v * 1e5) / 1e5); };
  text += fmt::format("{} {} {}\n", rounded(p.x()), rounded(p.y()), rake);
}

/// Points of the run in equal steps of its length; without the first one if `begun`.
void append_run(std::string& text, const Run& run, bool begun) {
  const double total = length(run.points);
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(total / kStep - 1e-9)));
  if (!begun) append_line(text, run.points.front(), run.rake);
  double driven = 0;
  std::size_t k = 1;
  for (std::size_t i = 1; i < run.points.size(); ++i) {
    const Point &a = run.points[i - 1], &b = run.points[i];
    const double step = distance(a, b);
    for (; k < steps; ++k) {
      const double at = total * static_cast<double>(k) / static_cast<double>(steps);
      if (at > driven + step) break;
      append_line(text, lerp(a, b, (at - driven) / step), run.rake);
    }
    driven += step;
  }
  append_line(text, run.points.back(), run.rake);
}

}  // namespace

std::string drawing_text(const Path& path, const DrawingOptions& options, RakeText rake) {
  std::string text;
  const Run* before = nullptr;
  const std::vector<Run> runs = runs_of(path, options, rake);
  for (const Run& run : runs) {
    if (run.points.size() < 2) continue;
    append_run(text, run, before != nullptr && before->rake == run.rake);
    if (run.stop) text += "\n";
    before = &run;
  }
  return text;
}

}  // namespace oxturn
