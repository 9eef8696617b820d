// A planner computes a path and does nothing else: it prints nothing on standard output, writes no file, and leaves the
// C library's random generators alone. (It may have a generator of its own, if it is seeded by the context's: that is
// what same-seed checks.)
//
// Decisions  1. In its process a planner finds an empty folder as current one, and TMPDIR and HOME name it. A file
//               written elsewhere shows by the bytes that the process has written (/proc/self/io).
//            2. A program finds its own folder, whose files are compared by name, and an empty TMPDIR.
#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "base/temporary_folder.hpp"
#include "bench/check/subject.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;

const Problem& usual(CheckSubject& subject) {
  return subject.problem(subject.planner().has(Capability::holes) ? "pillar" : "room");
}

double figure(const Planned& planned, const std::string& name) {
  for (const auto& [known, value] : planned.records)
    if (known == name) return value;
  return 0;
}

/// Plans with nobody listening, so that nothing is written on its behalf.
Path plan_alone(const CoveragePlanner& planner, const Problem& problem, const Context& context) {
  Context own(context.seed(), context.wall_s());
  return planner.plan(problem, own);
}

/// Bytes on standard output during the plan.
Path record_output(const CoveragePlanner& planner, const Problem& problem, Context& context) {
  std::fflush(stdout);
  const int file = ::memfd_create("stdout", MFD_CLOEXEC), before = ::dup(STDOUT_FILENO);
  ::dup2(file, STDOUT_FILENO);
  Path path = plan_alone(planner, problem, context);
  std::fflush(stdout);
  ::dup2(before, STDOUT_FILENO);
  context.record("printed", static_cast<double>(::lseek(file, 0, SEEK_END)));
  return path;
}

std::string no_output(CheckSubject& subject) {
  if (subject.is_program()) throw CheckSkipped("a program's standard output is its answer");
  const Problem& problem = usual(subject);
  const Planned planned = subject.plan(problem, {.how = record_output});
  if (const double bytes = figure(planned, "printed"); bytes > 0)
    return fmt::format("on '{}': prints {} bytes on standard output", problem.map().name, bytes);
  return subject.must_be_valid(problem, planned);
}

std::set<std::string> names_in(const fs::path& folder) {
  std::set<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) names.insert(entry.path().filename().string());
  names.erase("__pycache__");
  return names;
}

/// What this process has written since its beginning.
double written_bytes() {
  double bytes = 0;
  std::FILE* file = std::fopen("/proc/self/io", "r");
  if (file == nullptr) return 0;
  unsigned long long read = 0, written = 0;
  if (std::fscanf(file, "rchar: %llu wchar: %llu", &read, &written) == 2) bytes = static_cast<double>(written);
  std::fclose(file);
  return bytes;
}

std::string no_files(CheckSubject& subject) {
  const Problem& problem = usual(subject);
  const TemporaryFolder folder;
  const bool program = subject.is_program();
  const auto run = [&](const CoveragePlanner& planner, const Problem& given, Context& context) {
    ::setenv("TMPDIR", folder.path().c_str(), 1);
    if (!program) ::setenv("HOME", folder.path().c_str(), 1);
    if (!program && ::chdir(folder.path().c_str()) != 0)
      throw std::runtime_error("cannot enter " + folder.path().string());
    const double before = written_bytes();
    Path path = plan_alone(planner, given, context);
    std::fflush(nullptr);
    if (!program) context.record("written", written_bytes() - before);
    return path;
  };
  const auto before = names_in(".");
  const Planned planned = subject.plan(problem, {.how = run});
  for (const fs::path& where : {folder.path(), fs::path(".")})
    for (const std::string& name : names_in(where))
      if (where != "." || before.count(name) == 0)
        return fmt::format("on '{}': leaves the file '{}'", problem.map().name, name);
  // Without output: what it prints is another check's.
  if (const double bytes = figure(planned, "written"); bytes > 0 && no_output(subject).empty())
    return fmt::format("on '{}': writes {} bytes to files", problem.map().name, bytes);
  return subject.must_be_valid(problem, planned);
}

/// The generators of the C library go on as if nothing had happened.
Path record_random(const CoveragePlanner& planner, const Problem& problem, Context& context) {
  constexpr unsigned kSeed = 4711;
  std::srand(kSeed);
  ::srand48(kSeed);
  const int expected = std::rand();
  const long expected48 = ::lrand48();
  std::srand(kSeed);
  ::srand48(kSeed);
  Path path = plan_alone(planner, problem, context);
  context.record("disturbed", std::rand() != expected || ::lrand48() != expected48 ? 1 : 0);
  return path;
}

std::string no_global_random(CheckSubject& subject) {
  if (subject.is_program()) throw CheckSkipped("a program has its own");
  const Problem& problem = usual(subject);
  const Planned planned = subject.plan(problem, {.how = record_random});
  if (figure(planned, "disturbed") > 0)
    return fmt::format("on '{}': uses rand(), random() or drand48(); take Context::rng()", problem.map().name);
  return subject.must_be_valid(problem, planned);
}

/// Every path that it publishes could be the last one.
std::string published(CheckSubject& subject) {
  const Problem& problem = usual(subject);
  const auto watch = [](const CoveragePlanner& planner, const Problem& given, Context& context) {
    int count = 0;
    Context::Sinks sinks;
    sinks.publish = [&](const Path& path) {
      ++count;
      const std::string flaw = find_flaw(given, path, {.tether_counts = false});
      if (!flaw.empty()) throw std::runtime_error(fmt::format("published path {} is invalid: {}", count, flaw));
    };
    Context own(context.seed(), context.wall_s(), sinks);
    Path path = planner.plan(given, own);
    context.record("published", count);
    return path;
  };
  const Planned planned = subject.plan(problem, {.how = watch});
  if (std::string wrong = subject.must_be_valid(problem, planned); !wrong.empty()) return wrong;
  if (figure(planned, "published") == 0) throw CheckSkipped("it publishes nothing here");
  return "";
}

}  // namespace

PlannerChecks effect_checks() {
  return {{"no-output", "prints nothing on standard output", no_output},
          {"no-files", "writes no files", no_files},
          {"no-global-random", "leaves rand() and its like alone", no_global_random},
          {"published", "publishes valid paths only", published}};
}

}  // namespace oxturn
