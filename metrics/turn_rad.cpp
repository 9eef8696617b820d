// Total absolute change of heading, radians, transit included:
//   sum over all changes of heading of |angle|, plus what the chords of a sampled curve hide at its ends
// A curve of n chords shows n - 1 changes at its vertices. Where it begins or ends without a tangent line (at the
// path's end, at an inflexion) half a chord's change is in no vertex and is added, so sampling a curve finer changes
// nothing.
#include <algorithm>
#include <cmath>

#include "metrics/heading.hpp"

namespace oxturn {

extern const Metric kTurnRad;

namespace {

constexpr double kTangent =
    0.75;  // a last change below this share of the one before: the curve continues in its tangent

constexpr double kSameChord = 0.1;  // lengths that differ by less, relatively, are a curve's chords

/// One end of a curve: `last` and `inner` are its last two changes, `chord` metres apart. `out` metres lead on from
/// `last`, to the path's end or to the next change.
struct CurveEnd {
  double last, inner, chord, out;
  bool path_ends;
  double beyond;  // the change `out` metres on, 0 if the path ends
};

/// The change of heading that the chords hide there. If the curve continues in a tangent line, `last` is half as large
/// as `inner`, and nothing is hidden.
double hidden_change(const CurveEnd& end) {
  if (std::abs(end.last) <= kTangent * std::abs(end.inner)) return 0;
  // A curve of the other sense begins one chord on: at that vertex half a chord's change of this curve is hidden, and
  // half a chord's change of the other is taken off.
  if (end.beyond * end.last < 0 && std::abs(end.out - end.chord) < kSameChord * end.chord) return std::abs(end.last);
  const double curved = end.path_ends ? end.out - end.chord / 2 : (end.out - end.chord) / 2;
  return std::abs(end.last) * std::clamp(curved / end.chord, 0.0, 0.5);
}

double total_change(const Headings& h) {
  const std::vector<Turn>& turns = h.turns;
  double sum = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    sum += std::abs(turns[i].angle);
    const bool goes_on = i + 1 < turns.size() && turns[i + 1].linked;
    const double after = i + 1 < turns.size() ? turns[i + 1].before : h.after;
    if (goes_on && !turns[i].linked)  // a curve begins
      sum += hidden_change(
          {turns[i].angle, turns[i + 1].angle, after, turns[i].before, i == 0, i == 0 ? 0 : turns[i - 1].angle});
    if (turns[i].linked && !goes_on)  // a curve ends
      sum += hidden_change({turns[i].angle, turns[i - 1].angle, turns[i].before, after, i + 1 == turns.size(),
                            i + 1 == turns.size() ? 0 : turns[i + 1].angle});
  }
  return sum;
}

}  // namespace

const Metric kTurnRad{
    "turn_rad", "rad", Better::lower, "total absolute change of heading",
    [](const Scored& s) -> std::optional<double> { return total_change(headings(s.problem, s.path)); }};

}  // namespace oxturn
