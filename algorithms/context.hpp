/// What a run gives its planner besides the problem: random numbers, a deadline, and channels for results.
///
///   Context context(seed, 20.0);                     // 20 s
///   while (!context.cancelled()) improve(path, context.rng());
///   context.record("rounds", n);                     // a figure of this run
#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "geometry/path.hpp"
#include "geometry/region.hpp"
#include "geometry/trace.hpp"

namespace oxturn {

/// The planner can prove, or is certain, that it cannot solve this problem. Outcome `infeasible`.
struct Infeasible : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// The planner lacks what the problem asks for. Outcome `unsupported`.
struct Unsupported : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One for each call of plan(); not copyable.
class Context {
 public:
  struct Sinks {  // all optional
    std::function<void(const Path&)> publish;
    std::function<void(double)> progress;
    std::function<void(const Trace&)> trace;
    std::function<void(const std::string&, double)> record;
    std::function<void(std::function<Region()>)> promise;
    std::function<void()> begin;
    std::function<void(double)> peak_memory;
  };
  using Clock = std::chrono::steady_clock;
  /// `wall_s`: seconds from now to the deadline.
  explicit Context(std::uint64_t seed = 1, double wall_s = 1e9, Sinks sinks = {});
  Context(const Context&) = delete;

  /// The only source of randomness, seeded with seed().
  Rng& rng() { return rng_; }
  std::uint64_t seed() const { return seed_; }
  /// Seconds from the beginning to the deadline.
  double wall_s() const { return wall_s_; }
  /// For planners that start a program: planning begins now. What came before is not measured, and the deadline counts
  /// from here. Only the first call counts; without one, planning begins with plan().
  void begin();
  /// For planners that start a program: its memory at its peak, bytes. Stands in place of what is measured of this
  /// process.
  void peak_memory(double bytes);
  /// True once the deadline has passed or cancel() was called: return the best path so far soon. Reads the clock.
  bool cancelled() const;
  double seconds_left() const;
  void cancel() { cancelled_ = true; }
  /// Hands out the best path so far; it is scored after a timeout.
  void publish(const Path& path);
  /// The share of the work that is done, 0 to 1; shown on a terminal. For planners that take long.
  void progress(double fraction);
  /// A named drawing of what the planner works with (cells, tree, skeleton). If wants_traces() is false it is
  /// discarded.
  void trace(std::string name, std::vector<Polyline> lines);
  void trace(std::string name, const Region& region);
  bool wants_traces() const { return static_cast<bool>(sinks_.trace); }
  /// What the planner promises to cover, where its description promises cells rather than the whole target. `region` is
  /// called after plan() has returned, if at all, and owns what it needs; it is not timed. The last call counts.
  void promise(std::function<Region()> region);
  bool wants_promise() const { return static_cast<bool>(sinks_.promise); }
  /// Records a figure of the run that the path does not show ("explored_share"): a row of metrics.csv. (Metrics judge
  /// the path alone.) Throws std::invalid_argument for a name that is not [a-z0-9_]+.
  void record(const std::string& name, double value);
  /// For the context of an inner planner, of which only the drawings are passed on.
  Sinks traces_only() const;
  /// For the context of a planner whose path becomes this one's: all is passed on but what it promises.
  Sinks without_promise() const;

 private:
  std::uint64_t seed_;
  double wall_s_;
  Rng rng_;
  Clock::time_point deadline_;
  Sinks sinks_;
  bool begun_ = false, cancelled_ = false;
};

}  // namespace oxturn
