#include "base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace oxturn {

void in_parallel(int threads, std::size_t n, const std::function<void(std::size_t)>& work) {
  std::vector<std::exception_ptr> thrown(n);
  std::atomic<std::size_t> next = 0;
  const auto take_pieces = [&] {
    for (std::size_t k = next++; k < n; k = next++) try {
        work(k);
      } catch (...) { thrown[k] = std::current_exception(); }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < std::min(static_cast<std::size_t>(std::max(threads, 1)), n); ++k)
      others.emplace_back(take_pieces);
    take_pieces();
  }
  for (const std::exception_ptr& e : thrown)
    if (e) std::rethrow_exception(e);
}

}  // namespace oxturn
