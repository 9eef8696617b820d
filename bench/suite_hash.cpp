// What a suite says, as canonical text and its hash.
#include <fmt/format.h>

#include "bench/run_id.hpp"
#include "bench/suite.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"

namespace oxturn {

Settings PlannerSpec::said() const {
  Settings all = settings;
  if (ignore_tether) all[kIgnoreTether] = true;
  return all;
}

std::string PlannerSpec::variant() const {
  const Settings all = said();
  return all.empty() ? name : fmt::format("{}[{}]", name, settings_text(all));
}

std::string content_hash(const Suite& suite) {
  std::string text = fmt::format("schema 1\nname {}\nseed {}\nrepeats {}\ntarget {}\nwall_s {}\nmemory_mb {}\n",
                                 suite.name, suite.seed, suite.repeats, to_decimal(suite.target_coverage),
                                 to_decimal(suite.limits.wall_s), to_decimal(suite.limits.memory_mb));
  for (const Robot& r : suite.robots) {
    text += fmt::format("robot {}", r.name);
    for (const double value : {r.radius, r.tool_width, r.speed, r.acceleration, r.turn_rate, r.min_turn_radius}) {
      text += ' ' + to_decimal(value);
    }
    if (r.tether)
      text += fmt::format(" tether {} {} {}", to_decimal(r.tether->length), to_decimal(r.tether->reach),
                          to_decimal(r.tether->sharp_angle));
    if (r.lidar) {
      text += fmt::format(" lidar {} {}", to_decimal(r.lidar->range), r.lidar->rays);
      if (r.lidar->noise != 0) text += fmt::format(" noise {}", to_decimal(r.lidar->noise));
    }
    if (!r.footprint.empty()) text += " footprint";
    for (const Point& p : r.footprint) text += fmt::format(" {} {}", to_decimal(p.x()), to_decimal(p.y()));
    text += '\n';
  }
  for (const MapSpec& m : suite.maps) {
    text += fmt::format("map {} {} {} {} {}", m.name, m.generator, settings_text(m.settings), m.seed, m.file);
    if (m.content) {
      text += fmt::format(" {} {} {} {} {}", content_hash(m.content->map), m.read.unknown_is_free,
                          to_decimal(m.read.drop_speckle_m2), to_decimal(m.read.simplify_m),
                          to_decimal(m.read.metres_per_pixel));
    }
    if (m.start) text += " start " + to_text(*m.start);
    if (m.anchor) text += " anchor " + to_text(*m.anchor);
    text += '\n';
  }
  for (const PlannerSpec& p : suite.planners) text += fmt::format("planner {}\n", p.variant());
  return sha256(text);
}

}  // namespace oxturn
