// Number of places at which the path turns more sharply than the robot can: vertices where the heading changes by more
// than a degree, at the end of an edge on which the fillets of both its ends do not fit. An edge of length l between
// deflections d and e allows fillets of radius l / (tan(d / 2) + tan(e / 2)) at most. The path is simplified to a
// thousandth of the tool's width first; changes of gear are cusps and do not count.
#include <algorithm>

#include "base/math.hpp"
#include "maps/drawing.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTangentBreaks;

namespace {

constexpr double kSimplify = 1e-3;    // of the tool's width
constexpr double kBreak = kPi / 180;  // radians
constexpr double kSpare = 1.01;       // of the greatest curvature

/// Ramer 1972, Douglas and Peucker 1973, without recursion.
Polyline simplified(const Polyline& line, double tolerance) {
  std::vector<char> kept(line.size(), 0);
  kept.front() = kept.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, line.size() - 1}};
  while (!open.empty()) {
    const auto [from, to] = open.back();
    open.pop_back();
    double most = tolerance;
    std::size_t at = from;
    for (std::size_t i = from + 1; i < to; ++i)
      if (const double d = distance_to_segment(line[i], line[from], line[to]); d > most) {
        most = d;
        at = i;
      }
    if (at == from) continue;
    kept[at] = 1;
    open.emplace_back(from, at);
    open.emplace_back(at, to);
  }
  Polyline out;
  for (std::size_t i = 0; i < line.size(); ++i)
    if (kept[i] != 0 && (out.empty() || out.back() != line[i])) out.push_back(line[i]);
  return out;
}

/// Connected runs of one gear.
std::vector<Polyline> runs_of(const Path& path) {
  std::vector<Polyline> runs;
  for (std::size_t l = 0; l < path.legs.size(); ++l) {
    const Leg& leg = path.legs[l];
    if (leg.points.empty()) continue;
    if (runs.empty() || path.legs[l - 1].gear != leg.gear) runs.emplace_back();
    runs.back().insert(runs.back().end(), leg.points.begin(), leg.points.end());
  }
  return runs;
}

double breaks_of(const Polyline& line, double curvature) {
  std::vector<double> turn(line.size(), 0);  // at each vertex, radians
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const Point before = line[i] - line[i - 1], after = line[i + 1] - line[i];
    turn[i] = std::abs(math::atan2(cross(before, after), before.dot(after)));
  }
  std::vector<char> broken(line.size(), 0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double sum = math::tan(turn[i - 1] / 2) + math::tan(turn[i] / 2);
    if (sum / distance(line[i - 1], line[i]) <= kSpare * curvature) continue;
    for (const std::size_t v : {i - 1, i}) broken[v] = turn[v] > kBreak || broken[v] != 0;
  }
  return static_cast<double>(std::ranges::count(broken, 1));
}

std::optional<double> compute(const Scored& s) {
  const Robot& robot = s.problem.robot();
  if (!s.problem.map().drawing || !(robot.min_turn_radius > 0)) return std::nullopt;
  double count = 0;
  for (const Polyline& run : runs_of(s.path))
    count += breaks_of(simplified(run, kSimplify * robot.tool_width), 1 / robot.min_turn_radius);
  return count;
}

}  // namespace

const Metric kTangentBreaks{
    "tangent_breaks", "count", Better::lower,
    "vertices that turn more sharply than the robot can; empty: no drawing, or a robot that turns on the spot",
    compute};

}  // namespace oxturn
