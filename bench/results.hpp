// The results folder: what a sweep leaves and reports read.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace oxturn {

/// Outcome names of design.md section 6.
enum class Outcome {
  ok,
  partial,
  invalid,
  infeasible,
  unsupported,
  timeout,
  out_of_memory,
  crash,
  error,
  cancelled,
  infrastructure
};
std::string to_text(Outcome outcome);
std::optional<Outcome> outcome_from(const std::string& text);

/// One column of runs.csv. Listed once, in results.cpp; metrics' columns come from metrics().
struct Column {
  std::string name, type, unit, better, help, empty;
  bool timing = false;  // differs from run to run: plan_wall_s, plan_cpu_s, peak_rss_bytes, score_s
};
const std::vector<Column>& columns();
/// The same as JSON text: what columns.json holds.
std::string columns_json();

/// One line of runs.csv, by column name. A missing name is an empty cell.
struct Row {
  std::map<std::string, std::string> cells;
  const std::string& get(const std::string& column) const;  // "" if empty; throws std::out_of_range for no such column
  std::optional<double> number(const std::string& column) const;
  Outcome outcome() const;
};

struct Results {
  std::string folder;
  std::vector<Row> rows;  // in suite order; of several attempts the last
};
/// Throws std::invalid_argument for a folder that is none ("no runs.csv in 'out'"), a wrong header, a bad line.
Results read_results(const std::string& folder);

std::string csv_header();
std::string csv_line(const Row& row);

}  // namespace oxturn
