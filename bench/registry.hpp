/// What there is to choose from: planners, metrics, map generators, map formats and report tables, each described as
/// data.
///
///   Registry registry = built_in_registry();       // reports/built_in_registry.hpp
///   registry.planners.add(my_planner());
///   run_suite(read_suite("quick.toml", registry), registry, options);
///
/// There is no global list: a registry is made once and passed down. Command line, suites, listings, CSV columns and
/// reports follow from what it holds.
#pragma once

#include <functional>
#include <string>

#include "algorithms/planner_info.hpp"
#include "base/named_list.hpp"
#include "bench/results.hpp"
#include "maps/formats.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"

namespace oxturn {

/// A section of report.md, made from results alone.
struct ReportTable {
  std::string name, title;
  std::function<std::string(const Results&)> markdown;  // "": nothing to show in these results
};
using ReportTables = NamedList<ReportTable>;

struct Registry {
  Planners planners{"planner"};
  Metrics metrics{"metric"};
  Generators generators{"generator"};
  MapFormats formats{"map format"};
  ReportTables tables{"report table"};
};

}  // namespace oxturn
