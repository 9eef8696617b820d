/// What /proc tells of processes: memory, processor time, children. Internal to bench/.
///
///   resident_bytes(pid);                       // of one process
///   for (const pid_t p : descendants(pid)) ::kill(p, SIGKILL);
///
/// Nothing here allocates unless it returns a vector, so that it works near a memory limit too. A process that is gone
/// gives 0.
#pragma once

#include <sys/types.h>

#include <vector>

namespace oxturn {

/// Resident memory of a process, pages shared with others included.
double resident_bytes(pid_t pid);
/// Address space of a process.
double address_space_bytes(pid_t pid);
/// Memory that belongs to this process alone: of a forked process, what it has written since the fork. Slow
/// (milliseconds for gigabytes).
double private_bytes(pid_t pid);
/// User and system time of a process and of its children that have been waited for.
double cpu_seconds(pid_t pid);
/// The same, its own part to the microsecond.
double precise_cpu_seconds(pid_t pid);
/// The most resident memory that a process has had since it began its program.
double peak_resident_bytes(pid_t pid);

/// Processes that this one has started and that still exist.
std::vector<pid_t> children_of(pid_t pid);
/// Children, their children, and so on.
std::vector<pid_t> descendants(pid_t pid);

/// How many processes the kernel has killed since it started because memory ran out.
unsigned long out_of_memory_kills();

}  // namespace oxturn
