// Decisions  1. Nothing of the machine's is changed: no controller is enabled, no process but the child is moved.
//            2. The kernel's limit on memory lies a tenth above ours: what grows slower is stopped and reported by the
//               supervisor, as it is without a control group.
//            3. An oxturn that was killed leaves empty groups behind; the next one removes them.
#include "bench/control_group.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace oxturn {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "oxturn-";  // oxturn-PID-N
constexpr double kKernelLimit = 1.1;        // times the supervisor's
constexpr int kRemovalRounds = 5000;        // a process that was killed takes a moment to end
constexpr useconds_t kRemovalPause = 200;   // microseconds

/// Returns the error's number, or 0. Allocates nothing.
int put(const std::string& file, std::string_view text) {
  const int fd = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
  if (fd < 0) return errno;
  const ssize_t done = ::write(fd, text.data(), text.size());
  const int error = done < 0 ? errno : 0;
  ::close(fd);
  return error;
}

/// False if something lives in the group, or there is none. A child may have made groups below its own.
bool remove_group(const std::string& folder) {
  if (::rmdir(folder.c_str()) == 0) return true;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.is_directory(error)) remove_group(entry.path().string());
  return ::rmdir(folder.c_str()) == 0;
}

/// The folder of the group in which this process is; "" without cgroup v2.
std::string own_folder() {
  std::string group, line;
  for (std::ifstream in("/proc/self/cgroup"); std::getline(in, line);)
    if (line.starts_with("0::/")) group = line.substr(3);
  if (group.empty()) return "";
  for (std::ifstream in("/proc/self/mountinfo"); std::getline(in, line);) {
    if (line.find(" - cgroup2 ") == std::string::npos) continue;
    std::string skipped, root, mount;
    std::istringstream(line) >> skipped >> skipped >> skipped >> root >> mount;
    if (root == "/") return mount + group;
    if (group.starts_with(root)) return mount + group.substr(root.size());
  }
  return "";
}

void remove_stale_groups(const std::string& folder) {
  if (folder.empty()) return;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kPrefix)) continue;
    const pid_t owner = std::atoi(name.c_str() + std::strlen(kPrefix));
    if (owner > 0 && ::kill(owner, 0) != 0 && errno == ESRCH) remove_group(entry.path().string());
  }
}

std::string new_group(const std::string& parent) {
  static unsigned long serial = 0;
  for (;;) {
    const std::string folder = fmt::format("{}/{}{}-{}", parent, kPrefix, ::getpid(), ++serial);
    if (::mkdir(folder.c_str(), 0755) == 0) return folder;
    if (errno != EEXIST) return "";  // EEXIST: of an earlier process with the same id
  }
}

/// By trying: there are more rules than those of the files' permissions.
bool can_be_entered(const std::string& folder) {
  const std::string processes = folder + "/cgroup.procs";
  const pid_t pid = ::fork();
  if (pid == 0) ::_exit(put(processes, "0") == 0 ? 0 : 1);
  int status = 1;
  while (pid > 0 && ::waitpid(pid, &status, 0) < 0 && errno == EINTR) {}
  return pid > 0 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Where groups can be made. Found out once; forked processes know it too.
struct Parent {
  std::string folder;  // "": nowhere
  bool limits_memory = false;
};
const Parent& parent() {
  static const Parent found = [] {
    Parent p{own_folder()};
    if (p.folder.empty()) return p;
    remove_stale_groups(p.folder);
    const std::string probe = new_group(p.folder);
    if (probe.empty() || ::access((probe + "/cgroup.kill").c_str(), W_OK) != 0 || !can_be_entered(probe))
      p.folder.clear();
    p.limits_memory = !p.folder.empty() && ::access((probe + "/memory.max").c_str(), W_OK) == 0;
    if (!probe.empty()) ::rmdir(probe.c_str());
    return p;
  }();
  return found;
}

}  // namespace

ControlGroup::ControlGroup(std::string folder)
    : folder_(std::move(folder)), kill_(::open((folder_ + "/cgroup.kill").c_str(), O_WRONLY | O_CLOEXEC)) {}

std::optional<ControlGroup> ControlGroup::make(double memory_bytes) {
  if (parent().folder.empty()) return std::nullopt;
  std::string folder = new_group(parent().folder);
  if (folder.empty())
    throw std::runtime_error(
        fmt::format("cannot make a control group in '{}': {}", parent().folder, std::strerror(errno)));
  ControlGroup group(std::move(folder));
  if (parent().limits_memory) {
    put(group.folder_ + "/memory.max", fmt::format("{:.0f}", kKernelLimit * memory_bytes));
    put(group.folder_ + "/memory.swap.max", "0");
    put(group.folder_ + "/memory.oom.group", "1");  // all of them, not the largest
  }
  return group;
}

ControlGroup::~ControlGroup() {
  if (folder_.empty()) return;
  kill();
  for (int round = 0; round < kRemovalRounds && !remove_group(folder_); ++round) ::usleep(kRemovalPause);
}

void ControlGroup::enter() const {
  if (const int error = put(folder_ + "/cgroup.procs", "0"); error != 0)
    throw std::runtime_error(fmt::format("cannot enter the control group '{}': {}", folder_, std::strerror(error)));
}

std::vector<pid_t> ControlGroup::processes() const {
  std::vector<pid_t> all;
  std::ifstream in(folder_ + "/cgroup.procs");
  for (pid_t p = 0; in >> p;) all.push_back(p);
  return all;
}

void ControlGroup::kill() const { [[maybe_unused]] const ssize_t done = ::write(kill_.number(), "1", 1); }

unsigned long ControlGroup::out_of_memory_kills() const {
  std::ifstream in(folder_ + "/memory.events");
  std::string key;
  for (unsigned long count = 0; in >> key >> count;)
    if (key == "oom_kill") return count;
  return 0;
}

Confinement confinement() {
  const char* const kGroups = "cgroup v2";
  return {parent().folder.empty() ? "subreaper" : kGroups, parent().limits_memory ? kGroups : "polled"};
}

void remove_stale_control_groups() { remove_stale_groups(parent().folder); }

}  // namespace oxturn
