/// How the heap asks the system for memory: seldom, and in huge pages. Results never depend on it.
///
///   int main() { keep_freed_memory(); ... }
///   reserve_heap(3e9);                        // before a computation that may need so much
///
/// Without effect where the C library is not glibc, the system has no huge pages to give or counts address space as
/// memory in use (vm.overcommit_memory = 2), or a sanitizer has replaced the heap.
#pragma once

namespace oxturn {

/// From now on the heap keeps what is freed. Planners of large maps, and scoring, make and drop vectors of up to
/// hundreds of megabytes; by default glibc gives each back at once, and the system clears the pages again for the next:
/// a sixth of smooth-spiral's time at 10^6 tool squares, and of scoring its path. Kept, they take up to a sixth more
/// memory.
void keep_freed_memory();

/// Extends the heap by so many bytes of address space, of which none is in use, and asks for huge pages there: a page
/// of 4 kB costs the system some microseconds when it is first touched, and the processor looks up its address far more
/// often. Planning at 10^6 cells takes 4 % (field-predictive) to 11 % (berg) less time, the quick suite a tenth less.
/// At most as much as the machine has memory, and as there is address space.
void reserve_heap(double bytes);

/// Gives the system what has been freed, and the heap is as long as before, with huge pages at its end. What a process
/// holds but does not use would not count as memory of its forked children when they take it. glibc's malloc_trim()
/// alone drops the reserve as well: `berg` at 10^6 cells, forked, then meets 218,000 page faults, not 6,000.
void give_back_freed_memory();

}  // namespace oxturn
