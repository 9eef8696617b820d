/// The results folder: what a benchmark run leaves and reports read.
///
///   const Results results = read_results("out/quick");
///   results.rows.front().number("coverage");
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/row_cells.hpp"
#include "metrics/score.hpp"

namespace oxturn {

/// How a run ended. docs/method.md tells what each means.
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
/// The run was lost by the harness, not by the planner; it is run again on `--resume`.
bool is_unfinished(Outcome outcome);

/// One column of runs.csv.
struct Column {
  std::string name, type, unit, better, help, empty;
  bool timing = false;  // differs from run to run: plan_wall_s, plan_cpu_s, peak_rss_bytes, score_s
};
using Columns = std::vector<Column>;
/// The columns of runs.csv in their order. Those of `metrics` stand in the middle; the others are listed in
/// results.cpp.
Columns run_columns(const Metrics& metrics);
/// The same as JSON text: what columns.json holds.
std::string to_json(const Columns& columns);

/// One line of runs.csv, by column name. A missing name is an empty cell.
struct Row {
  RowCells cells;
  std::string get(const std::string& column) const { return cells.get(column); }  // "" if empty
  /// Throws std::invalid_argument if the cell holds something else than a number.
  std::optional<double> number(const std::string& column) const;
  Outcome outcome() const;
};

struct Results {
  std::string folder;
  std::vector<Row> rows;             // in suite order; of several attempts the last
  std::vector<std::string> columns;  // as the file has them
  std::vector<std::string> about;    // machine, build, limits, robots: from session.json, if it is there
  /// run_id -> its picture, relative to the folder; runs without one are missing.
  std::map<std::string, std::string> pictures;
};
/// Accepts columns that it does not know. Throws std::invalid_argument for a folder that is none ("no runs.csv in
/// 'out'"), a header without a column that reports need, a bad line.
Results read_results(const std::string& folder);

/// Where a run's path and picture, and a problem, lie relative to the results folder. Throw std::invalid_argument for
/// an id or a hash that could lead out of the folder.
std::string path_name(const std::string& run_id);
std::string picture_name(const std::string& run_id);
std::string problem_name(const std::string& hash);
/// There is such a file or folder, and no symbolic link in its name leads out of `folder`.
bool is_within(const std::string& folder, const std::string& name);

std::string csv_header(const Columns& columns);
std::string csv_line(const Row& row, const Columns& columns);
/// The rows of a file that csv_header and csv_line have written, attempt by attempt; `source` names it in errors.
std::vector<Row> rows_from_csv(const std::string& text, const std::string& source);

}  // namespace oxturn
