// Length driven over what earlier legs drew, metres, with the tool up and (apart) with the tool on. Within half a tool
// width and 1 cm of a leg's two ends it does not count: a connection must leave and reach the drawing. Nor does what is
// nearer to the boundary of what was drawn than a thousandth of half its width.
#include "metrics/over_finished.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "maps/drawing.hpp"
#include "metrics/drawn_lines.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kOverFinishedM, kWorkOverFinishedM;

namespace {

constexpr double kNear = 0.01;  // metres
// Of half a leg's width: paths along what was drawn are off it by rounding, or by chords.
constexpr double kTouch = 1e-3;

double length_over(const Leg& leg, std::size_t index, const PathSegments& work, double tool_width) {
  if (work.empty() || work.first_leg() >= index) return 0;  // nothing is drawn yet
  const double at_ends = tool_width / 2 + kNear;
  const Polyline line = line_of(leg);
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Point &a = line[i - 1], &b = line[i];
    Cover over, ends;
    work.for_each_touching(a, b, 0, [&](const PathSegment& s) {
      if (s.leg < index) over.add(within(a, b, s.a, s.b, s.width / 2 * (1 - kTouch)));
      return over.is_whole();
    });
    for (const Point& end : {line.front(), line.back()}) ends.add(within(a, b, end, end, at_ends));
    sum += over.share_without(ends) * distance(a, b);
  }
  return sum;
}

/// Calls f(leg's index, metres over finished work) for the legs with the tool on, or off.
template <class F>
void for_each_over(const Problem& problem, const Path& path, bool tool, F f) {
  const double tool_width = problem.robot().tool_width;
  const PathSegments work(path, tool_width);
  for (std::size_t l = 0; l < path.legs.size(); ++l)
    if (path.legs[l].tool == tool) f(l, length_over(path.legs[l], l, work, tool_width));
}

std::optional<double> compute(const Scored& s, bool tool) {
  if (!s.problem.map().drawing) return std::nullopt;
  double sum = 0;
  for_each_over(s.problem, s.path, tool, [&](std::size_t, double over) { sum += over; });
  return sum;
}

}  // namespace

std::vector<TransitOver> transits_over_finished(const Problem& problem, const Path& path, double least) {
  std::vector<TransitOver> found;
  if (!problem.map().drawing) return found;
  for_each_over(problem, path, false, [&](std::size_t l, double over) {
    const Polyline& points = path.legs[l].points;
    if (over >= least) found.push_back({l, points.front(), points.back(), over});
  });
  std::ranges::stable_sort(found, std::greater<>(), &TransitOver::over_m);
  return found;
}

std::vector<std::string> remarks_on(const std::vector<TransitOver>& transits,
                                    const std::function<std::string(const TransitOver&)>& reason) {
  std::vector<std::string> sentences;
  sentences.reserve(transits.size());
  for (const TransitOver& t : transits)
    sentences.push_back(
        fmt::format("the transit from ({:.2f}, {:.2f}) to ({:.2f}, {:.2f}) drives {:.2f} m over finished work{}",
                    t.from.x(), t.from.y(), t.to.x(), t.to.y(), t.over_m, reason(t)));
  return sentences;
}

const Metric kOverFinishedM{"over_finished_m", "m", Better::lower,
                            "length driven with the tool up over what was drawn before; empty: no drawing",
                            [](const Scored& s) { return compute(s, false); }};
const Metric kWorkOverFinishedM{"work_over_finished_m", "m", Better::lower,
                                "length driven with the tool on over what earlier legs drew; empty: no drawing",
                                [](const Scored& s) { return compute(s, true); }};

}  // namespace oxturn
