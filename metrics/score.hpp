/// Scores a path against a problem: validity and all metrics, from the two alone. Uses nothing of algorithms/.
///
///   const Score result = score(problem, path);
///   result.flaw;                                  // why the path is invalid, or ""
///   result.value("coverage");
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/named_list.hpp"
#include "geometry/path.hpp"
#include "maps/problem.hpp"
#include "maps/promise.hpp"
#include "metrics/length_bound.hpp"
#include "metrics/mission.hpp"
#include "metrics/swept_area.hpp"
#include "metrics/tether.hpp"

namespace oxturn {

/// What metrics are computed from: the problem, the path, and the figures that several metrics share.
struct Scored {
  const Problem& problem;
  const Path& path;
  const SweptArea& swept;
  double clearance;                   // metres, see clearance_m.cpp
  const TetherRun* tether = nullptr;  // nullptr: no tether, or none can follow the path
  const MissionClock* clock = nullptr;
  double tolerance = 0;                // metres within which legs must join
  std::optional<LengthBound> bound;    // of paths that cover as much; nullopt also if legs do not join
  std::optional<double> kept_promise;  // certified lower bound of the covered share of what the planner promises
};

enum class Better { lower, higher, neither };
std::string to_text(Better better);

struct Metric {
  std::string name;  // of the CSV column, with the unit ("path_m")
  std::string unit;  // "m", "m2", "rad", "s", "1", "count"
  Better better;
  std::string help;  // one line, with the meaning of an empty value
  std::function<std::optional<double>(const Scored&)> compute;
  /// Of a metric from a plug-in: its file, and a hash of that. Empty: it is part of oxturn.
  std::string origin = {}, identity = {};
};
using Metrics = NamedList<Metric>;

/// The metrics that come with oxturn, in column order; metrics/score.cpp lists them.
Metrics built_in_metrics();

struct MetricValue {
  std::string name;
  std::optional<double> value;
  bool operator==(const MetricValue&) const = default;
};

/// What had been covered when `path_m` metres were driven.
struct CurvePoint {
  double path_m, mission_s, coverage;  // coverage: share of the target
};

struct Score {
  std::string flaw;                 // why the path is invalid: which rule, where, by how much; empty: it is valid
  std::vector<MetricValue> values;  // one for each metric, in their order; all empty if the path has no points or is
                                    // not finite
  std::vector<CurvePoint> curve;  // from (0, 0, 0) to the path's end, at most 200 points; linear interpolation errs by
                                  // less than 0.005. Empty if the values are
  std::vector<MissedPiece> missed;  // largest first
  /// Of one metric; nullopt if it is empty or not in the list.
  std::optional<double> value(const std::string& metric) const;
};

struct ScoreOptions {
  bool tether_counts = true;  // false: a path that exceeds the tether length limit is valid, but still measured
  Promise promise = Promise::nothing;
  const Region* promised = nullptr;  // for Promise::cells: their union
  double tolerance = 0;  // metres, added to the problem's: how far outside configuration space and over the tether
                         // length limit a path may be, and how near it must start to the start and legs must join
  MissedOutlines outlines = MissedOutlines::kept;  // of Score::missed
};

/// Validity and every metric of the list. O(n log n) for n segments on ordinary paths; 10^5 segments take under a
/// second.
Score score(const Problem& problem, const Path& path, const Metrics& metrics, const ScoreOptions& options = {});
/// The same with the built-in metrics.
Score score(const Problem& problem, const Path& path, const ScoreOptions& options = {});

/// Only validity: the path is finite, starts at the start, its legs join, it stays in configuration space, keeps
/// min_turn_radius (geometry/bends.hpp), the gears that the robot has and the tether length limit. "" if valid. Exact
/// against the map itself (distance to the walls); shares nothing with the erosion from which planners get
/// configuration space.
std::string find_flaw(const Problem& problem, const Path& path, const ScoreOptions& options = {});

}  // namespace oxturn
