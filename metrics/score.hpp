// Scores a path against a problem, from the two alone. Nothing of algorithms/ is known here.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"
#include "metrics/swept_area.hpp"
#include "metrics/tether.hpp"

namespace oxturn {

/// What metrics are computed from: the pair, and the figures that several of them share.
struct Scored {
  const Problem& problem;
  const Path& path;
  const SweptArea& swept;
  double clearance;                   // metres, see clearance.cpp
  const TetherRun* tether = nullptr;  // none: no tether, or no string can follow the path
};

enum class Better { lower, higher, neither };

struct Metric {
  std::string name;  // the CSV column, unit included ("path_m")
  std::string unit;  // "m", "m2", "rad", "s", "1", "count"
  Better better;
  std::string help;  // one line, with the meaning of an empty cell
  std::optional<double> (*compute)(const Scored&);
};

/// All metrics in column order; listed in metrics/score.cpp and nowhere else.
const std::vector<const Metric*>& metrics();

struct Score {
  std::string flaw;                           // why the path is invalid: which rule, where, by how much; empty if valid
  std::vector<std::optional<double>> values;  // in the order of metrics(); all empty if the path cannot be
                                              // scored at all (no legs, not finite)
  std::optional<double> value(const std::string& metric) const;
};

struct ScoreOptions {
  bool tether_counts = true;  // false: pulling the tether over its limit is measured, but no flaw
};

/// Validity and every metric. O(n log n) for n segments on ordinary paths; 10^5 segments under a second.
Score score(const Problem& problem, const Path& path, const ScoreOptions& options = {});

/// Only validity: starts at the start, legs joined, finite, stays in configuration space, keeps the tether's limit.
/// "" if valid. Exact against the map itself (distance to the walls), sharing nothing with the erosion that planners
/// are given.
std::string find_flaw(const Problem& problem, const Path& path, const ScoreOptions& options = {});

}  // namespace oxturn
