/// The length and the pull of the tether along a path, as rows: for plots, and to find where a path goes wrong.
///
///   write_file("tether.csv", to_csv(tether_trace(problem, path, 0.1)));
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
  double mission_s = 0;  // the time then (mission.hpp), before turning on the spot
  Point at{0, 0};
  double length_m = 0;  // the tether's
  std::size_t bends = 0;
  std::optional<double> angle_rad;  // between heading and tether, at a vertex the heading before it; none at the start
  Event event = Event::sample;
};
std::string to_text(TetherRow::Event event);

/// A row for the start, each vertex of the path, each bend gained or lost (both at once: gained) and each crossing of
/// the tether. Samples in between, so that rows are at most `step` metres apart. Ends where no tether can follow the
/// path (maps/followed_path.hpp) within `tolerance` metres beyond the problem's. Throws std::invalid_argument if the
/// step is not above 0, std::logic_error without a tether. O(rows), beside the cost of TautTether.
std::vector<TetherRow> tether_trace(const Problem& problem, const Path& path, double step, double tolerance = 0);

/// One header line; RFC 4180.
std::string to_csv(const std::vector<TetherRow>& rows);

}  // namespace oxturn
