// How long the tether is and how it pulls, place by place along a path: for plots, and to find where a path goes wrong.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct TetherRow {
  enum class Event { start, waypoint, sample, bend_gained, bend_lost, crossing };
  double path_m = 0;     // driven
  double mission_s = 0;  // when, as the metric mission_s tells time; before turning on the spot
  Point at{0, 0};
  double length_m = 0;  // the tether's
  std::size_t bends = 0;
  std::optional<double> angle_rad;  // between heading and tether; at a way point the heading with which it is reached;
                                    // none before the first move
  Event event = Event::sample;
};
std::string to_text(TetherRow::Event event);

/// A row for the start, each way point, each bend gained or lost (both at once: gained) and each crossing of the own
/// line; between them samples so that rows are at most `step` metres apart (> 0, else std::invalid_argument). Ends where
/// no string can follow (maps/followed_path.hpp). Tethered problems only (else std::logic_error). O(rows) beside the
/// string's cost.
std::vector<TetherRow> tether_trace(const Problem& problem, const Path& path, double step);

/// One header line; RFC 4180.
std::string to_csv(const std::vector<TetherRow>& rows);

}  // namespace oxturn
