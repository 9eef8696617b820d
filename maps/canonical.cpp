// One form of a region for all its ways of being written down, and its address by content.
#include <algorithm>

#include "base/sha256.hpp"
#include "maps/drawing_file.hpp"
#include "maps/map.hpp"

namespace oxturn {
namespace {

/// The ring from its smallest corner on; among equal corners (a ring may touch itself) the one whose
/// continuation is smallest, so that the answer does not depend on where the ring began.
Ring from_smallest(const Ring& ring) {
  const std::size_t n = ring.size();
  std::size_t best = 0;
  for (std::size_t start = 1; start < n; ++start) {
    if (before(ring[best], ring[start])) continue;
    for (std::size_t k = 0; k < n; ++k) {
      const Point &a = ring[(start + k) % n], &b = ring[(best + k) % n];
      if (before(a, b)) best = start;
      if (before(a, b) || before(b, a)) break;
    }
  }
  Ring result = ring;
  std::rotate(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(best), result.end());
  return result;
}

std::string bytes_of(const Ring& ring) {
  std::string bytes;
  bytes.reserve(8 + 16 * ring.size());
  append_canonical(bytes, std::uint64_t{ring.size()});
  for (const Point& p : from_smallest(ring)) {
    append_canonical(bytes, p.x());
    append_canonical(bytes, p.y());
  }
  return bytes;
}

/// Their number, then the items in order.
std::string sorted_list(std::vector<std::string> items) {
  std::sort(items.begin(), items.end());
  std::string bytes;
  append_canonical(bytes, std::uint64_t{items.size()});
  for (const std::string& item : items) bytes += item;
  return bytes;
}

}  // namespace

std::string canonical_bytes(const Region& region) {
  std::vector<std::string> polygons;
  for (const Polygon& polygon : region.polygons) {
    std::vector<std::string> holes;
    for (const Ring& hole : polygon.holes) holes.push_back(bytes_of(hole));
    polygons.push_back(bytes_of(polygon.outer) + sorted_list(std::move(holes)));
  }
  return sorted_list(std::move(polygons));
}

std::string canonical_bytes(const Map& map) {
  std::string bytes = canonical_bytes(map.free);
  if (map.target_area) bytes += "target" + canonical_bytes(*map.target_area);
  if (map.drawing) bytes += "drawing" + canonical_bytes(*map.drawing);
  return bytes;
}

std::string content_hash(const Map& map) { return sha256(canonical_bytes(map)); }

}  // namespace oxturn
