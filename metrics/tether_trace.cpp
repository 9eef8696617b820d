#include "metrics/tether_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>
#include <utility>

#include "base/text.hpp"
#include "maps/followed_path.hpp"
#include "maps/formats.hpp"
#include "metrics/mission.hpp"
#include "metrics/tether.hpp"

namespace oxturn {
namespace {

using Event = TetherRow::Event;

class Tracer {
 public:
  Tracer(const Problem& problem, const FollowedPath& path, double step) : clock_(problem, path.path()), step_(step) {
    const TautTether tether = tether_at_start(problem);
    bends_ = tether.bends().size();
    pivot_ = tether.pivot();
    rows_.push_back({0, 0, problem.start(), tether.length(), bends_, {}, Event::start});
    TetherVisitor visitor;
    visitor.crossing = [&](const TetherCrossing& crossing) { crossings_.push_back(crossing.path_m); };
    visitor.motion = [&](const PivotMotion& motion) { add(motion); };
    visitor.vertex = [&](const TautTether& reached, double path_m) { end_segment(reached, path_m); };
    drive_tether(problem, path, visitor);
  }
  std::vector<TetherRow> take() { return std::move(rows_); }

 private:
  void add(const PivotMotion& m) {
    for (const auto& [metres, event] : events_of(m)) {
      const double s = m.begin + metres, driven = m.path_m + metres;
      rows_.push_back({driven, clock_.at(driven), m.swing.from + metres * m.direction, m.length_at(s), bends_,
                       m.angle_at(s), event});
    }
    last_ = m;
  }

  /// With their distance from the motion's beginning, metres, in order.
  std::vector<std::pair<double, Event>> events_of(const PivotMotion& m) {
    const double length = m.end - m.begin;
    std::vector<std::pair<double, Event>> events;
    if (m.swing.bends != bends_ || m.swing.pivot != pivot_)
      events.emplace_back(0, m.swing.bends < bends_ ? Event::bend_lost : Event::bend_gained);
    bends_ = m.swing.bends;
    pivot_ = m.swing.pivot;
    for (; !crossings_.empty() && crossings_.front() <= m.path_m + length; crossings_.pop_front())
      events.emplace_back(std::max(0.0, crossings_.front() - m.path_m), Event::crossing);
    const int parts = static_cast<int>(std::clamp(std::ceil(length / step_), 1.0, 1e6));
    for (int k = 1; k < parts; ++k) events.emplace_back(length * k / parts, Event::sample);
    std::stable_sort(events.begin(), events.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return events;
  }

  void end_segment(const TautTether& tether, double path_m) {
    for (; !crossings_.empty(); crossings_.pop_front())  // beyond the last motion by rounding
      rows_.push_back({crossings_.front(), clock_.at(crossings_.front()), tether.robot(), tether.length(), bends_,
                       last_.angle_at(last_.end), Event::crossing});
    rows_.push_back({path_m, clock_.at(path_m), tether.robot(), tether.length(), tether.bends().size(),
                     last_.angle_at(last_.end), Event::waypoint});
  }

  MissionClock clock_;
  double step_;
  std::size_t bends_;
  Point pivot_{0, 0};
  PivotMotion last_;
  std::deque<double> crossings_;  // of the current segment, not yet in a row
  std::vector<TetherRow> rows_;
};

}  // namespace

std::string to_text(Event event) {
  switch (event) {
    case Event::start:
      return "start";
    case Event::waypoint:
      return "waypoint";
    case Event::sample:
      return "sample";
    case Event::bend_gained:
      return "bend_gained";
    case Event::bend_lost:
      return "bend_lost";
    case Event::crossing:
      return "crossing";
  }
  throw std::logic_error("an event of a tether without a name");
}

std::vector<TetherRow> tether_trace(const Problem& problem, const Path& path, double step, double tolerance) {
  if (!(step > 0)) throw std::invalid_argument(fmt::format("tether trace: step is {}, expected metres above 0", step));
  const EdgeIndex& walls = problem.map_edges();
  return Tracer(problem, followed_path(problem, path, walls, problem.tolerance() + tolerance), step).take();
}

std::string to_csv(const std::vector<TetherRow>& rows) {
  std::string text = "path_m,mission_s,x,y,length_m,bends,angle_rad,event\n";
  for (const TetherRow& row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{}\n", to_decimal(row.path_m), to_decimal(row.mission_s),
                        to_decimal(row.at.x()), to_decimal(row.at.y()), to_decimal(row.length_m), row.bends,
                        row.angle_rad ? to_decimal(*row.angle_rad) : "", to_text(row.event));
  return text;
}

}  // namespace oxturn
