// A worker's share of a sweep: some runs of one problem, one after the other, in a process of their own. The map is
// made and the problem built once; each planner gets a process of its own; paths are scored here, outside of it.
// Internal to bench/.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
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

struct Work {
  const Suite& suite;
  const std::vector<PlannerInfo>& planners;
  const SuiteRunOptions& options;
  const std::vector<SuiteCell>& cells;
  const std::map<std::string, Earlier>& earlier;  // by run_id
};

/// What a worker says about run `index`. Frames: [index u64][text].
namespace messages {
inline constexpr char kBegun = 'B';  // row so far, as a CSV line
inline constexpr char kRecords =
    'V';  // [value f64, name] for each report of the planner, before kDone; only if there are any
inline constexpr char kDone = 'D';    // row, as a CSV line
inline constexpr char kKept = 'K';    // run_id of a row that an earlier sweep left
inline constexpr char kBroken = 'X';  // why the worker gives up
}  // namespace news

void tell(int fd, char type, std::size_t index, const std::string& text);

/// The row of a run whose problem is not known (yet).
Row blank_row(const Work& work, std::size_t index);

/// Works through the unit and writes its news to `fd`.
void run_unit(const Work& work, const Unit& unit, int fd);

}  // namespace oxturn
