/// Scores a path against a problem, from the two alone. Nothing of algorithms/ is known here.
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
#include "metrics/swept_area.hpp"
#include "metrics/tether.hpp"

namespace oxturn {

/// What metrics are computed from: problem and path, and the figures that several metrics share.
struct Scored {
  const Problem& problem;
  const Path& path;
  const SweptArea& swept;
  double clearance;                   // metres, see clearance.cpp
  const TetherRun* tether = nullptr;  // nullptr: the robot has no tether, or no tether can follow the path
};

enum class Better { lower, higher, neither };
std::string to_text(Better better);

struct Metric {
  std::string name;  // the CSV column, unit included ("path_m")
  std::string unit;  // "m", "m2", "rad", "s", "1", "count"
  Better better;
  std::string help;  // one line, with the meaning of an empty cell
  std::function<std::optional<double>(const Scored&)> compute;
};
using Metrics = NamedList<Metric>;

/// The metrics that come with oxturn, in column order; metrics/score.cpp lists them.
Metrics built_in_metrics();

struct MetricValue {
  std::string name;
  std::optional<double> value;
  bool operator==(const MetricValue&) const = default;
};

struct Score {
  std::string flaw;                 // why the path is invalid: which rule, where, by how much; empty if valid
  std::vector<MetricValue> values;  // one for each metric, in their order; all empty if the path cannot be scored at
                                    // all (no legs, not finite)
  /// Of one metric; nothing if it is empty or was not asked for.
  std::optional<double> value(const std::string& metric) const;
};

struct ScoreOptions {
  bool tether_counts = true;  // false: exceeding the tether's length limit is measured, but does not make a path invalid
};

/// Validity and every metric of the list. O(n log n) for n segments on ordinary paths; 10^5 segments under a second.
Score score(const Problem& problem, const Path& path, const Metrics& metrics, const ScoreOptions& options = {});
/// By the metrics that come with oxturn.
Score score(const Problem& problem, const Path& path, const ScoreOptions& options = {});

/// Only validity: starts at the start, legs joined, finite, stays in configuration space, keeps the tether's limit.
/// "" if valid. Exact against the map itself (distance to the walls), sharing nothing with the erosion that planners
/// are given.
std::string find_flaw(const Problem& problem, const Path& path, const ScoreOptions& options = {});

}  // namespace oxturn
