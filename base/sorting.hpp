/// Sorting: without repeats, and by a key that is spread evenly over its range. Not installed.
///
///   sort_unique(points, before);
///   spread_sort(sites, [](const Site& s) { return packed(s); }, std::less<>());    // by coordinates, indices, ...
///
/// spread_sort distributes the items to n / 4 buckets by key, then each bucket is sorted by std::sort: O(n) for evenly
/// spread keys, O(n log n) otherwise. About twice as fast as std::sort on the edges of an overlay. Boost's spreadsort
/// is no substitute: it sorts by key only, and equal keys here need a comparison.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace oxturn {

/// Sorts by `less` and leaves one of equal (==) items.
template <class T, class Less = std::less<>>
void sort_unique(std::vector<T>& items, Less less = {}) {
  std::sort(items.begin(), items.end(), less);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

/// Sorts by `less`. key(item) is an unsigned 64-bit number that agrees with it: less(a, b) implies key(a) <= key(b).
template <class T, class Key, class Less>
void spread_sort(std::vector<T>& items, Key key, Less less) {
  constexpr std::size_t kFew = 64;  // below, buckets cost more than they save
  if (items.size() <= kFew) return std::sort(items.begin(), items.end(), less);
  std::uint64_t low = key(items[0]), high = low;
  for (const T& item : items) {
    const std::uint64_t k = key(item);
    low = std::min(low, k);
    high = std::max(high, k);
  }
  int shift = 0;
  while ((high - low) >> shift >= items.size() / 4) ++shift;
  const std::size_t buckets = static_cast<std::size_t>((high - low) >> shift) + 1;
  std::vector<std::uint32_t> start(buckets + 1, 0);
  for (const T& item : items) ++start[static_cast<std::size_t>((key(item) - low) >> shift) + 1];
  for (std::size_t b = 0; b < buckets; ++b) start[b + 1] += start[b];
  std::vector<T> spread(items.size());
  std::vector<std::uint32_t> next(start.begin(), start.end() - 1);
  for (const T& item : items) spread[next[static_cast<std::size_t>((key(item) - low) >> shift)]++] = item;
  items.swap(spread);
  for (std::size_t b = 0; b < buckets; ++b) {
    const auto begin = items.begin() + static_cast<std::ptrdiff_t>(start[b]);
    const auto end = items.begin() + static_cast<std::ptrdiff_t>(start[b + 1]);
    if (end - begin > 1) std::sort(begin, end, less);
  }
}

}  // namespace oxturn
