// How often, and how much, the robot changes direction; transit included.
//
// A bend (heading.hpp: linked changes of the same sense) of more than 0.3 rad is one turn, be it a corner or a
// curve; gentler ones count in turn_rad only. How finely a curve is sampled changes neither: where a curve begins or
// ends without a tangent line (the path's end, an inflexion), the half chord's heading that no vertex shows is added.
#include <algorithm>
#include <cmath>

#include "metrics/heading.hpp"

namespace oxturn {

extern const Metric kTurns, kTurnRad;

namespace {

/// What the chords hide at one end of a curve: `last` and `inner` are its last two changes, `chord` metres apart;
/// `out` metres lead on from `last`, to the path's end or to the next change. After a tangent line `last` is half
/// as large as `inner`, and nothing is hidden.
double hidden(double last, double inner, double chord, double out, bool path_ends) {
  if (std::abs(last) <= 0.75 * std::abs(inner)) return 0;
  const double curved = path_ends ? out - chord / 2 : (out - chord) / 2;
  return std::abs(last) * std::clamp(curved / chord, 0.0, 0.5);
}

double total_change(const Headings& h) {
  const std::vector<Turn>& turns = h.turns;
  double sum = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    sum += std::abs(turns[i].angle);
    const bool goes_on = i + 1 < turns.size() && turns[i + 1].linked;
    const double after = i + 1 < turns.size() ? turns[i + 1].before : h.after;
    if (goes_on && !turns[i].linked) sum += hidden(turns[i].angle, turns[i + 1].angle, after, turns[i].before, i == 0);
    if (turns[i].linked && !goes_on)
      sum += hidden(turns[i].angle, turns[i - 1].angle, turns[i].before, after, i + 1 == turns.size());
  }
  return sum;
}

}  // namespace

const Metric kTurns{"turns", "count", Better::lower,
                    "changes of direction by more than 0.3 rad, a smooth bend counts once",
                    [](const Scored& s) -> std::optional<double> {
                      double count = 0, bend = 0;
                      for (const Turn& turn : headings(s.problem, s.path).turns) {
                        if (!turn.linked) {
                          if (std::abs(bend) > kCorner) ++count;
                          bend = 0;
                        }
                        bend += turn.angle;
                      }
                      return std::abs(bend) > kCorner ? count + 1 : count;
                    }};

const Metric kTurnRad{
    "turn_rad", "rad", Better::lower, "total absolute change of heading",
    [](const Scored& s) -> std::optional<double> { return total_change(headings(s.problem, s.path)); }};

}  // namespace oxturn
