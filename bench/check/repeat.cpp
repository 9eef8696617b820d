// The same bytes again: in another process, after other problems, beside other runs, under observation.
#include <fmt/format.h>

#include <memory>

#include "base/temporary_folder.hpp"
#include "bench/check/subject.hpp"
#include "bench/run_suite.hpp"

namespace oxturn {
namespace {

constexpr std::uint64_t kSeed = 7;

/// Why these are not one result.
std::string difference(const Planned& a, const Planned& b, const std::string& when) {
  if (a.outcome != b.outcome)
    return fmt::format("{} is its outcome, {} {}: {}", to_text(a.outcome), to_text(b.outcome), when, b.reason);
  if (!a.path || same_path(*a.path, *b.path)) return "";
  return fmt::format("another path {} ({:.9g} m, {:.9g} m before)", when, b.path->length(), a.path->length());
}

const char* const kProblem = "rooms:2";

std::string again(CheckSubject& subject, const char* when, const PlanRequest& first, const PlanRequest& second) {
  const Problem& problem = subject.problem(subject.planner().has(Capability::holes) ? kProblem : "room");
  const Planned a = subject.plan(problem, first), b = subject.plan(problem, second);
  if (std::string wrong = subject.must_be_valid(problem, a); !wrong.empty()) return wrong;
  return difference(a, b, when);
}

/// Blocks of many sizes, some of them given back in another order than they were taken. What is allocated now gets
/// other addresses, in another order, than in a process that has just begun: processes are forked, so without this they
/// all have the same.
std::vector<std::unique_ptr<char[]>> disordered_heap() {
  constexpr std::size_t kBlocks = 20000, kLargest = 4096, kStride = 7919;  // a prime: visits all blocks
  std::vector<std::unique_ptr<char[]>> blocks(kBlocks);
  for (std::size_t k = 0; k < kBlocks; ++k) blocks[k] = std::make_unique<char[]>(1 + k * kStride % kLargest);
  for (std::size_t k = 0; k < kBlocks; k += 2) blocks[k * kStride % kBlocks].reset();
  return blocks;
}

/// A planner that sorts or hashes by address has another order the second time.
std::string same_seed(CheckSubject& subject) {
  const auto elsewhere = [](const CoveragePlanner& planner, const Problem& problem, Context& context) {
    const auto blocks = disordered_heap();
    return planner.plan(problem, context);
  };
  return again(subject, "at the second call with the same seed, with objects at other addresses", {.seed = kSeed},
               {.seed = kSeed, .how = elsewhere});
}

/// The same planner object plans for another problem in between, and for this one again.
std::string no_memory(CheckSubject& subject) {
  const Problem other = subject.problem("room");
  const auto third = [&](const CoveragePlanner& planner, const Problem& problem, Context& context) {
    for (const Problem* earlier : {&problem, &other}) {
      Context own(kSeed + 1, context.wall_s());
      (void)planner.plan(*earlier, own);
    }
    return planner.plan(problem, context);
  };
  return again(subject, "after other plans in the same process", {.seed = kSeed}, {.seed = kSeed, .how = third});
}

std::string unobserved(CheckSubject& subject) {
  const auto alone = [](const CoveragePlanner& planner, const Problem& problem, Context& context) {
    Context own(context.seed(), context.wall_s());
    return planner.plan(problem, own);
  };
  return again(subject, "when drawings, figures and promises are not asked for", {.seed = kSeed, .traces = true},
               {.seed = kSeed, .how = alone});
}

/// path_sha256 and outcome of each map.
std::map<std::string, std::string> run_all(CheckSubject& subject, const std::vector<Problem>& problems,
                                           const Robot& robot, int jobs) {
  const TemporaryFolder folder;
  Suite suite;
  suite.name = "check";
  suite.limits.wall_s = subject.wall_s();
  suite.robots = {robot};
  for (const Problem& problem : problems) {
    MapSpec map;
    map.name = map.file = problem.map().name;
    map.content = std::make_shared<const MapFile>(MapFile{problem.map(), {}, {}, {}, {}});
    suite.maps.push_back(std::move(map));
  }
  suite.planners = {{subject.planner().name, {}}};
  SuiteRunOptions options;
  options.folder = folder.file("results");
  options.jobs = jobs;
  options.pictures = options.progress = false;
  std::map<std::string, std::string> all;
  for (const Row& row : run_suite(suite, subject.registry(), options).rows)
    all[row.get("map")] = row.get("outcome") + " " + row.get("path_sha256");
  return all;
}

std::string any_order(CheckSubject& subject) {
  std::vector<Problem> problems;
  for (const char* name : {"room", "symmetries", "corridor as wide as the robot"})
    problems.push_back(subject.problem(name));
  const Robot robot = problems.front().robot();
  const auto one = run_all(subject, problems, robot, 1);
  const auto many = run_all(subject, {problems.rbegin(), problems.rend()}, robot, 3);
  for (const auto& [map, result] : one)
    if (many.at(map) != result)
      return fmt::format("on '{}': another path in a suite of other order with -j 3 ({}, {} before)", map, many.at(map),
                         result);
  return "";
}

}  // namespace

PlannerChecks repeat_checks() {
  return {{"same-seed", "same seed, same bytes", same_seed},
          {"no-memory", "same bytes after other plans in the same process", no_memory},
          {"unobserved", "same bytes whether drawings and figures are asked for or not", unobserved},
          {"any-order", "same bytes in any order of runs and with any -j", any_order}};
}

}  // namespace oxturn
