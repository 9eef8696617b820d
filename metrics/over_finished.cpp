// Length driven over what earlier legs drew, metres, with the tool up and (apart) with the tool on. Within half a tool
// width and 1 cm of a leg's two ends it does not count: a connection must leave and reach the drawing.
#include "maps/drawing.hpp"
#include "metrics/drawn_lines.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kOverFinishedM, kWorkOverFinishedM;

namespace {

constexpr double kNear = 0.01;  // metres

double length_over(const Leg& leg, std::size_t index, const PathSegments& work, double tool_width) {
  const double at_ends = tool_width / 2 + kNear;
  double sum = 0;
  for (std::size_t i = 1; i < leg.points.size(); ++i) {
    const Point &a = leg.points[i - 1], &b = leg.points[i];
    Cover over, ends;
    work.for_each_near(a, b, tool_width / 2, [&](const PathSegment& s) {
      if (s.leg < index) over.add(within(a, b, s.a, s.b, s.width / 2));
    });
    for (const Point& end : {leg.points.front(), leg.points.back()}) ends.add(within(a, b, end, end, at_ends));
    sum += over.share_without(ends) * distance(a, b);
  }
  return sum;
}

std::optional<double> compute(const Scored& s, bool tool) {
  if (!s.problem.map().drawing) return std::nullopt;
  const double tool_width = s.problem.robot().tool_width;
  const PathSegments work(s.path, tool_width);
  double sum = 0;
  for (std::size_t l = 0; l < s.path.legs.size(); ++l)
    if (s.path.legs[l].tool == tool) sum += length_over(s.path.legs[l], l, work, tool_width);
  return sum;
}

}  // namespace

const Metric kOverFinishedM{"over_finished_m", "m", Better::lower,
                            "length driven with the tool up over what was drawn before; empty: no drawing",
                            [](const Scored& s) { return compute(s, false); }};
const Metric kWorkOverFinishedM{"work_over_finished_m", "m", Better::lower,
                                "length driven with the tool on over what earlier legs drew; empty: no drawing",
                                [](const Scored& s) { return compute(s, true); }};

}  // namespace oxturn
