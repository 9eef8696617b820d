#include "test_planners.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "reports/built_in_registry.hpp"

namespace oxturn::testing {

namespace {

struct Params {
  std::string how = "good";
  double amount = 0;
  int lanes = 0;
};

[[noreturn]] void spin() {
  volatile unsigned long turns = 0;
  for (;;) {
    const unsigned long next = turns + 1;
    turns = next;
  }
}

// The kernel is to find it, not the sanitizer.
int* volatile nowhere = nullptr;
[[gnu::no_sanitize("undefined", "address")]] void write_nowhere() {
  int* const target = nowhere;
  *target = 1;
}

// Each call needs its frame: no compiler turns this into a loop.
[[gnu::noinline]] double descend(double depth) {
  volatile double frame[512] = {depth};
  return depth < 0 ? depth : descend(frame[0] + 1) + frame[0];
}

/// 64 processes, every second one in a session of its own, that never end.
void fork_bomb() {
  for (int generation = 0; generation < 6; ++generation)
    if (::fork() == 0 && generation % 2 == 0) ::setsid();
}

/// Bytes that are no frames, to everything that is open.
void write_garbage() {
  const std::string garbage(4096, '\xff');
  for (int fd = 3; fd < 64; ++fd) [[maybe_unused]] const ssize_t put = ::write(fd, garbage.data(), garbage.size());
}

// Lanes over the box of the configuration space, and once round it: whole coverage of a rectangle.
Path lanes(const Problem& problem) {
  const Box box = bounding_box(problem.configuration_space());
  const double step = problem.robot().tool_width * 0.9;
  PathBuilder path(problem.start());
  path.drive(box.low, false);
  path.drive({{box.high.x(), box.low.y()}, box.high, {box.low.x(), box.high.y()}, box.low}, true);
  bool right = true;
  for (double y = box.low.y(); y <= box.high.y(); y += step, right = !right) {
    path.drive(Point(right ? box.low.x() : box.high.x(), y), true);
    path.drive(Point(right ? box.high.x() : box.low.x(), y), true);
  }
  return path.take();
}

class TestPlanner final : public CoveragePlanner {
 public:
  explicit TestPlanner(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    die_if_told();
    if (auto path = bad_path(problem, context)) return *path;
    behave(problem, context);
    if (context.cancelled()) return {};
    context.progress(0.5);
    context.trace("box", {{problem.start(), problem.start() + Point(1, 0)}});
    return lanes(problem);
  }

 private:
  /// Never returns: crashes, throws, exits or goes on for ever.
  void die_if_told() const {
    crash();
    never_return();
    allocate();
    const std::string& how = p_.how;
    if (how == "throw") throw std::runtime_error("my tour\nis broken");
    if (how == "throw_int") throw 3;
    if (how == "throw_bytes") throw std::runtime_error("caf\xe9 \xff\n\"is\", closed");
    if (how == "throw_megabytes") throw std::runtime_error(std::string(10'000'000, 'x'));
    if (how == "infeasible") throw Infeasible("the map is too small for me");
    if (how == "unsupported") throw Unsupported("no rectangles, please");
    if (how == "exit") std::exit(3);
    if (how == "quiet_exit") ::_exit(0);
  }

  void crash() const {
    const std::string& how = p_.how;
    if (how == "null") write_nowhere();
    if (how == "abort") std::abort();
    if (how == "stack") descend(0);
    if (how == "kill_itself") ::raise(SIGKILL);
    if (how == "kill_parent") ::kill(::getppid(), SIGKILL);
    if (how == "kill_parents_group") ::kill(-::getpgid(::getppid()), SIGKILL);
    if (how.starts_with("kill_")) ::sleep(1000);
    if (how == "throw_in_thread") std::thread([] { throw std::runtime_error("nobody catches this"); }).join();
    if (how == "garbage") {
      write_garbage();
      ::sleep(1000);
    }
  }

  void never_return() const {
    const std::string& how = p_.how;
    if (how == "spin") spin();
    if (how == "spin_and_tell") {  // in the file named by the environment, so that a test knows that it spins
      std::fclose(std::fopen(std::getenv("OXTURN_TEST_SPINS"), "w"));
      spin();
    }
    if (how == "sleep") ::sleep(1000);
    if (how == "stop") ::raise(SIGSTOP);
    if (how == "exec") ::execl("/bin/sleep", "sleep", "1000", nullptr);
    if (how == "ignore_signals") {
      for (int s = 1; s < 32; ++s) std::signal(s, SIG_IGN);
      spin();
    }
    if (how == "hide") {  // closes every descriptor and goes on
      for (int fd = 0; fd < 64; ++fd) ::close(fd);
      spin();
    }
  }

  void allocate() const {
    const std::string& how = p_.how;
    if (how == "allocate") {
      for (std::vector<std::string> all;;) all.emplace_back(std::size_t{1} << 20, 'x');
    }
    if (how == "allocate_100_gb") std::vector<char>(100'000'000'000).back() = 1;
    if (how == "allocate_by_mmap") {
      // Never asks operator new, and ignores refusals.
      for (;;) {
        void* page = ::mmap(nullptr, 1 << 20, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (page != MAP_FAILED) std::memset(page, 1, 1 << 20);
      }
    }
    if (how == "allocate_in_children") {  // each one within the limit
      for (int k = 0; k < 4; ++k) {
        if (::fork() != 0) continue;
        const std::vector<char> block(100'000'000, 1);
        ::sleep(1000);
        ::_exit(block[0] == 2 ? 1 : 0);
      }
      ::sleep(1000);
    }
  }

  std::optional<Path> bad_path(const Problem& problem, Context& context) const {
    const std::string& how = p_.how;
    const Point start = problem.start();
    if (how == "wall") {
      PathBuilder path(start);
      path.drive(start + Point(100, 0), true);
      return path.take();
    }
    if (auto path = degenerate_path(start)) return path;
    if (how == "publish") {
      context.publish({{{true, {start, start - Point(0.5, 0)}}}});
      context.publish({{{true, {start, start - Point(1, 0)}}}});
      spin();
    }
    if (how == "publish_nan") {
      context.publish(degenerate_path(start, "nan").value());
      spin();
    }
    if (how == "partial") {
      PathBuilder path(start);
      path.drive(start - Point(1, 0), true);
      return path.take();
    }
    if (how == "cut_short") {  // shows at the deadline what it has
      while (!context.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      return Path{{{true, {start, start + Point(0.3, 0)}}}};
    }
    if (how == "random") {
      PathBuilder path(start);
      for (int i = 0; i < 20; ++i) path.drive(Point(0.3 + 2 * context.rng().unit(), 0.3 + context.rng().unit()), true);
      return path.take();
    }
    return std::nullopt;
  }

  std::optional<Path> degenerate_path(Point start) const { return degenerate_path(start, p_.how); }

  static std::optional<Path> degenerate_path(Point start, const std::string& how) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
    if (how == "nan") return Path{{{true, {start, Point(nan, 1)}}}};
    if (how == "infinite") return Path{{{true, {start, Point(infinity, -infinity)}}}};
    if (how == "huge") return Path{{{true, {start, Point(1e300, 1e300)}}}};
    if (how == "empty") return Path{};
    if (how == "empty_leg") return Path{{{true, {}}}};
    if (how == "one_point") return Path{{{true, {start}}}};
    if (how == "zero_length") return Path{{{true, {start, start}}}};
    if (how == "jump") return Path{{{true, {start, start + Point(0.5, 0)}}, {true, {start, start + Point(1, 0)}}}};
    if (how == "elsewhere") return Path{{{true, {start + Point(0.5, 0), start}}}};
    if (how == "points") return there_and_back(start, 10'000'000);
    if (how == "million_points") return there_and_back(start, 1'000'000);
    if (how == "long_file") return slanted_line(start, 1'700'000);
    return std::nullopt;
  }

  static Path there_and_back(Point start, std::size_t count) {
    Path path;
    path.legs.emplace_back().tool = true;
    Polyline& points = path.legs[0].points;
    points.assign(count, start);                        // held once: it is to come back through the pipe
    const Point away(start.x() < 1.5 ? 0.5 : -0.5, 0);  // in a room three metres wide
    for (std::size_t i = 1; i < count; i += 2) points[i] += away;
    return path;
  }

  /// A metre, of points with many digits.
  static Path slanted_line(Point start, std::size_t count) {
    Path path;
    path.legs.emplace_back().tool = true;
    for (std::size_t i = 0; i < count; ++i) path.legs[0].points.push_back(start + Point(-0.9, 0.4) * i / (count - 1.0));
    return path;
  }

  /// A good path, and processes beside it.
  void start_processes() const {
    const std::string& how = p_.how;
    const pid_t self = ::getpid();
    if (how == "fork_bomb") fork_bomb();
    if (how == "leave_child") (void)::fork();
    if (how == "leave_daemon" && ::fork() == 0) {
      ::setsid();
      if (::fork() != 0) ::_exit(0);
      for (int fd = 0; fd < 64; ++fd) ::close(fd);
    }
    if (::getpid() == self) return;
    ::sleep(1000);
    ::_exit(0);
  }

  /// A good path, and something beside it.
  void behave(const Problem& problem, Context& context) const {
    start_processes();
    const std::string& how = p_.how;
    if (how == "babble") {
      for (int i = 0; i < 1000; ++i) std::printf("\x01\xff garbage \n");
      std::fprintf(stderr, "and more\n");
    }
    if (how == "report") {
      context.record("laps", 3);
      context.record("share", 0.25);
      context.record("laps", 4);  // the last one counts
      context.record("nothing", std::nan(""));
    }
    if (how == "record_megabytes") {
      for (int i = 0; i < 1'000'000; ++i)
        context.record("a_figure_with_a_long_name_that_is_number_" + std::to_string(i), i);
    }
    if (how == "trace_megabytes") {
      const Polyline line(1'000'000, problem.start());
      for (int i = 0; i < 20; ++i) context.trace("line " + std::to_string(i), {line});
    }
    if (how == "count_calls") {
      static int calls = 0;
      context.record("calls", ++calls);
    }
    if (how == "promise") context.promise([] { return box_region({0, 0}, {1, 1}); });
    if (how == "promise_throws") context.promise([]() -> Region { throw 3; });
    if (how == "promise_nan")
      context.promise([] { return box_region({0, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}); });
    if (how == "measure") {  // 50 MB resident for a tenth of a second of work
      std::vector<char> block(50'000'000, 1);
      const auto until = Context::Clock::now() + std::chrono::milliseconds(100);
      while (Context::Clock::now() < until) block[static_cast<std::size_t>(context.rng().below(block.size()))] = 2;
    }
    if (how == "polite") {  // stops at the deadline that it is told
      while (!context.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  Params p_;
};

}  // namespace

Planners test_planners() {
  Planners list("planner");
  list.add(
      describe<TestPlanner, Params>({.name = "test",
                                     .family = "test",
                                     .title = "does as told",
                                     .citation = "none",
                                     .capabilities = {Capability::holes},
                                     .guarantee = "none",
                                     .parameters = {{"how", &Params::how, Choices{}, "what to do"},
                                                    {"amount", &Params::amount, Range{0, 10}, "metres of nothing"}}}));
  list.add(describe<TestPlanner, Params>({.name = "other",
                                          .family = "test",
                                          .title = "another",
                                          .citation = "none",
                                          .capabilities = {},
                                          .guarantee = "none",
                                          .parameters = {{"how", &Params::how, Choices{}, "what to do"},
                                                         {"lanes", &Params::lanes, Range{0, 10}, "of nothing"}}}));
  return list;
}

Registry test_registry_copy() {
  Registry registry = built_in_registry();
  registry.planners = test_planners();
  return registry;
}

const Registry& test_registry() {
  static const Registry registry = test_registry_copy();
  return registry;
}

std::unique_ptr<CoveragePlanner> test_planner(const Settings& settings) {
  return test_registry().planners.find("test").make(settings, test_registry().planners);
}

Problem small_problem() {
  Map map;
  map.name = "small";
  map.family = "file";
  map.source = "test";
  map.free = box_region({0, 0}, {3, 2});
  return Problem(map, Robot{}, Point(0.21, 0.21));
}

}  // namespace oxturn::testing
