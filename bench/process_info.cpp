#include "bench/process_info.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace oxturn {
namespace {

/// The beginning of a small file; "" if it cannot be read.
struct SmallFile {
  char text[8192] = {};
  explicit SmallFile(const char* name) {
    const int fd = ::open(name, O_RDONLY | O_CLOEXEC);
    if (fd < 0) return;
    std::size_t size = 0;
    for (ssize_t got = 1; got > 0 && size < sizeof text - 1; size += static_cast<std::size_t>(got)) {
      got = ::read(fd, text + size, sizeof text - 1 - size);
      if (got < 0) got = 0;
    }
    text[size] = 0;
    ::close(fd);
  }
};

struct FileName {
  char text[64];
  FileName(pid_t pid, const char* name) {
    std::snprintf(text, sizeof text, "/proc/%d/%s", static_cast<int>(pid), name);
  }
};

void statm(pid_t pid, unsigned long& size, unsigned long& resident) {
  const SmallFile file(FileName(pid, "statm").text);
  if (std::sscanf(file.text, "%lu %lu", &size, &resident) != 2) size = resident = 0;
}

double pages(unsigned long count) { return static_cast<double>(count) * static_cast<double>(::sysconf(_SC_PAGESIZE)); }

/// The number after `key` at the beginning of a line; 0 if there is none.
unsigned long number_after(const char* text, const char* key) {
  for (const char* at = std::strstr(text, key); at != nullptr; at = std::strstr(at + 1, key))
    if (at == text || at[-1] == '\n') return std::strtoul(at + std::strlen(key), nullptr, 10);
  return 0;
}

struct ProcessorTime {
  double own = 0, children = 0;  // seconds; of the children that have been waited for
};

ProcessorTime processor_time(pid_t pid) {
  const SmallFile stat(FileName(pid, "stat").text);
  const char* end = std::strrchr(stat.text, ')');
  unsigned long user = 0, system = 0;
  long children_user = 0, children_system = 0;
  if (end == nullptr || std::sscanf(end + 1, " %*c %*d %*d %*d %*d %*d %*u %*u %*u %*u %*u %lu %lu %ld %ld", &user,
                                    &system, &children_user, &children_system) != 4)
    return {};
  const double ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));  // per second
  return {static_cast<double>(user + system) / ticks, static_cast<double>(children_user + children_system) / ticks};
}

/// By the threads' lists of children, where the kernel has them; false if it does not.
bool listed_children(pid_t pid, std::vector<pid_t>& children) {
  DIR* tasks = ::opendir(FileName(pid, "task").text);
  if (tasks == nullptr) return true;  // the process is gone
  bool listed = true;
  while (const dirent* entry = ::readdir(tasks)) {
    if (entry->d_name[0] == '.') continue;
    char name[128];
    std::snprintf(name, sizeof name, "/proc/%d/task/%.20s/children", static_cast<int>(pid), entry->d_name);
    if (::access(name, R_OK) != 0) listed = false;
    const SmallFile file(name);
    for (const char* at = file.text; *at != 0;) {
      char* end = nullptr;
      const long child = std::strtol(at, &end, 10);
      if (end == at) break;
      children.push_back(static_cast<pid_t>(child));
      at = end + (*end == ' ' ? 1 : 0);
    }
  }
  ::closedir(tasks);
  return listed;
}

/// Parent of a process by /proc/PID/stat, whose second field may contain anything in parentheses.
pid_t parent_of(pid_t pid) {
  const SmallFile stat(FileName(pid, "stat").text);
  const char* end = std::strrchr(stat.text, ')');
  char state = 0;
  int parent = 0;
  return end != nullptr && std::sscanf(end + 1, " %c %d", &state, &parent) == 2 ? parent : 0;
}

std::vector<pid_t> searched_children(pid_t pid) {
  std::vector<pid_t> children;
  DIR* all = ::opendir("/proc");
  if (all == nullptr) return children;
  while (const dirent* entry = ::readdir(all))
    if (const auto other = static_cast<pid_t>(std::atoi(entry->d_name)); other > 0 && parent_of(other) == pid)
      children.push_back(other);
  ::closedir(all);
  return children;
}

}  // namespace

double resident_bytes(pid_t pid) {
  unsigned long size = 0, resident = 0;
  statm(pid, size, resident);
  return pages(resident);
}

double address_space_bytes(pid_t pid) {
  unsigned long size = 0, resident = 0;
  statm(pid, size, resident);
  return pages(size);
}

double private_bytes(pid_t pid) {
  const SmallFile rollup(FileName(pid, "smaps_rollup").text);
  return 1024.0 *
         static_cast<double>(number_after(rollup.text, "Private_Clean:") + number_after(rollup.text, "Private_Dirty:"));
}

double cpu_seconds(pid_t pid) {
  const ProcessorTime time = processor_time(pid);
  return time.own + time.children;
}

double precise_cpu_seconds(pid_t pid) {
  clockid_t clock{};
  timespec t{};
  if (::clock_getcpuclockid(pid, &clock) != 0 || ::clock_gettime(clock, &t) != 0) return 0;
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec) + processor_time(pid).children;
}

double peak_resident_bytes(pid_t pid) {
  const SmallFile status(FileName(pid, "status").text);
  return 1024.0 * static_cast<double>(number_after(status.text, "VmHWM:"));
}

std::vector<pid_t> children_of(pid_t pid) {
  std::vector<pid_t> children;
  return listed_children(pid, children) ? children : searched_children(pid);
}

std::vector<pid_t> descendants(pid_t pid) {
  std::vector<pid_t> all = children_of(pid);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const std::vector<pid_t> more = children_of(all[i]);
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

unsigned long out_of_memory_kills() {
  const int fd = ::open("/proc/vmstat", O_RDONLY | O_CLOEXEC);
  if (fd < 0) return 0;
  char text[32768];
  const ssize_t got = ::read(fd, text, sizeof text - 1);
  ::close(fd);
  text[got > 0 ? got : 0] = 0;
  return number_after(text, "oom_kill ");
}

}  // namespace oxturn
