/// A worker's share of a suite: some runs of one problem, one after the other, in a process of their own. The map is
/// made and the problem built once; each planner gets a process of its own; paths are scored and drawn by the worker.
/// Internal to bench/.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bench/run_suite.hpp"

namespace oxturn {

/// Runs first..last-1 of the suite's list, all of one map and robot.
struct Unit {
  std::size_t first = 0, last = 0;
};

/// One cell of a suite. The list is map by map, robot by robot, planner by planner, repeat by repeat.
struct SuiteCell {
  std::size_t map = 0, robot = 0, planner = 0;
  int repeat = 1;
};
std::vector<SuiteCell> cells_of(const Suite& suite);

/// What a resumed folder holds.
struct Earlier {
  int attempts = 0;
  bool done = false;  // neither cancelled nor infrastructure
};

/// Cells of runs.csv that describe a map, the same for every robot.
using MapCells = std::map<std::string, std::string>;
/// Of a row.
MapCells map_cells_of(const Row& row);

struct Work {
  const Suite& suite;
  const Registry& registry;
  const SuiteRunOptions& options;
  const std::vector<SuiteCell>& cells;
  const std::map<std::string, Earlier>& earlier;      // by run_id
  const std::map<std::size_t, MapCells>& known_maps;  // by index: what earlier units have found out
};

/// What a worker sends about run `index`. Frames: [index u64][payload].
namespace messages {
inline constexpr char kReady = 'S';    // the problem is set up, or cannot be
inline constexpr char kBegun = 'B';    // the row so far, packed
inline constexpr char kMetrics = 'V';  // lines of metrics.csv; before kDone, if any
inline constexpr char kTrace = 'T';    // lines of trace.csv; before kDone, if any
inline constexpr char kDone = 'D';     // the row, packed
inline constexpr char kKept = 'K';     // run_id of a row that an earlier session left
inline constexpr char kRemark = 'N';   // a sentence for the user
inline constexpr char kBroken = 'X';   // why the worker gives up
}  // namespace messages

/// Throws std::runtime_error if the parent has closed the pipe.
void send_message(int fd, char type, std::size_t index, const std::string& payload);

/// Lines as one payload, and back.
std::string joined(const std::vector<std::string>& lines);
std::vector<std::string> lines_from(std::string_view bytes);

/// A row as bytes, and back.
std::string pack(const Row& row);
Row row_from(std::string_view bytes);

/// The row of a run whose problem is not known (yet).
Row blank_row(const Work& work, std::size_t index);

/// Works through the unit and sends messages to `fd`.
void run_unit(const Work& work, const Unit& unit, int fd);

}  // namespace oxturn
