/// A control group of the kernel (cgroup v2) for one child process and all that it starts. Internal to bench/.
///
///   std::optional<ControlGroup> group = ControlGroup::make(4e9);      // empty: this process may make none
///   if (::fork() == 0) { group->enter(); work(); }
///   group->processes();                                               // daemons included
///   group->kill();
///
/// Nothing that the child starts can leave the group, so one write to cgroup.kill ends it all, processes that fork
/// faster than they can be found included. The group is made below the one that this process is in; that needs a
/// cgroup v2 that is writable: as root, in a container of one's own, or under
/// `systemd-run --user --scope -p Delegate=yes`. Making, entering, killing and removing one takes some 0.3 ms.
///
/// Source: Linux, Documentation/admin-guide/cgroup-v2.rst
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/wire.hpp"

namespace oxturn {

class ControlGroup {
 public:
  /// Memory of all its processes is limited by the kernel where the memory controller is enabled below this process's
  /// group. Empty if no group can be made.
  static std::optional<ControlGroup> make(double memory_bytes);
  /// Kills what is left in the group, and removes it.
  ~ControlGroup();
  ControlGroup(ControlGroup&& other) noexcept
      : folder_(std::exchange(other.folder_, {})), kill_(std::move(other.kill_)) {}
  ControlGroup(const ControlGroup&) = delete;
  ControlGroup& operator=(const ControlGroup&) = delete;

  /// This process, which is the child's, enters the group. Throws std::runtime_error.
  void enter() const;
  std::vector<pid_t> processes() const;
  /// Ends all processes of the group.
  void kill() const;
  /// Ends the processes when a byte "1" is written to it: for signal handlers. Open as long as the group lives.
  int kill_descriptor() const { return kill_.number(); }
  /// How many processes the kernel has killed because of the group's limit on memory.
  unsigned long out_of_memory_kills() const;

 private:
  explicit ControlGroup(std::string folder);
  std::string folder_;
  wire::Descriptor kill_;  // cgroup.kill
};

/// How children are confined here, for session.json.
struct Confinement {
  std::string kill;    // "cgroup v2", or "subreaper": processes are found as descendants, and adopted when orphaned
  std::string memory;  // "cgroup v2", or "polled": what /proc tells every 10 ms
};
Confinement confinement();

/// Removes the groups of processes that have ended without doing so, because they were killed.
void remove_stale_control_groups();

}  // namespace oxturn
