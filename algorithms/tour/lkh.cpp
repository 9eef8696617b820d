#include "algorithms/tour/lkh.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <thread>

#include "algorithms/tour/node_matrix.hpp"
#include "algorithms/tour/tsplib.hpp"
#include "base/files.hpp"
#include "base/temporary_folder.hpp"

extern char** environ;

namespace oxturn {
namespace {

namespace fs = std::filesystem;

constexpr double kLargestWeight = 1 << 30;  // LKH adds weights and penalties in 32 bits
constexpr auto kPoll = std::chrono::milliseconds(10);

/// Runs the program, without input and output, until it ends or the context is cancelled.
void run(const std::string& program, const std::string& argument, const Context& context) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  std::string name = program, file = argument;
  char* const arguments[] = {name.data(), file.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawn(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error(fmt::format("cannot run '{}'", program));
  int status = 0;
  while (::waitpid(child, &status, WNOHANG) == 0) {
    if (context.cancelled()) ::kill(child, SIGKILL);
    std::this_thread::sleep_for(kPoll);
  }
}

/// The matrix in whole numbers. Connections that are not allowed cost as much as is possible.
TsplibInstance whole_numbers(const NodeMatrix& m) {
  double most = 1e-300;
  for (const double c : m.costs)
    if (c < kForbidden / 2) most = std::max(most, c);
  const double scale = kLargestWeight / 4 / most;
  TsplibInstance instance{.name = "oxturn", .symmetric = false, .weights = TsplibInstance::Weights::full_matrix};
  instance.dimension = m.nodes;
  for (const double c : m.costs)
    instance.matrix.push_back(c < kForbidden / 2 ? std::round(c * scale) : kLargestWeight - 1);
  return instance;
}

}  // namespace

std::optional<std::string> find_lkh() {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    for (const char* name : {"LKH", "lkh"}) {
      const fs::path file = fs::path(folder) / name;
      std::error_code ignored;
      if (fs::is_regular_file(file, ignored) && ::access(file.c_str(), X_OK) == 0) return file.string();
    }
  }
  return std::nullopt;
}

Tour lkh_tour(const TourProblem& problem, const std::string& program, const Context& context) {
  const NodeMatrix nodes = weight_shifted(
      problem, problem.patterns() > problem.elements() ? ElementConstant::enough : ElementConstant::none);
  const TemporaryFolder folder;
  const std::string tour_file = folder.file("result.tour"), parameters = folder.file("problem.par");
  write_file(folder.file("problem.atsp"), write_tsplib(whole_numbers(nodes)));
  const double seconds = std::clamp(context.seconds_left(), 1.0, 1e6);
  write_file(parameters, fmt::format("PROBLEM_FILE = {}\nTOUR_FILE = {}\nRUNS = 1\nSEED = 1\nPRECISION = 1\n"
                                     "TRACE_LEVEL = 0\nTIME_LIMIT = {}\n",
                                     folder.file("problem.atsp"), tour_file, static_cast<long>(seconds)));
  run(program, parameters, context);
  if (!fs::exists(tour_file)) throw std::runtime_error(fmt::format("'{}' has left no tour", program));
  std::vector<std::size_t> order = read_tsplib_tour(read_file(tour_file), tour_file);
  std::rotate(order.begin(), std::find(order.begin(), order.end(), 0), order.end());
  return nodes.tour_of(order, problem);
}

}  // namespace oxturn
