/// Independent pieces of work, done by several threads at a time.
///
///   std::vector<double> results(n);
///   in_parallel(threads, n, [&](std::size_t k) { results[k] = work_on(k); });
///
/// Which thread does which piece, and when, is left to chance: work(k) depends on k alone and writes to what no other
/// piece reads or writes.
#pragma once

#include <cstddef>
#include <functional>

namespace oxturn {

/// Calls work(0) to work(n - 1), by at most `threads` threads, of which the calling one is the first. All are called
/// even if one throws; then the exception of the first piece that threw is thrown.
void in_parallel(int threads, std::size_t n, const std::function<void(std::size_t)>& work);

}  // namespace oxturn
