// One form of a region for all its ways of being written down, and its address by content.
#include <algorithm>
#include <cstdint>

#include "base/sha256.hpp"
#include "maps/map.hpp"

namespace oxturn {
namespace {

void append(std::string& bytes, std::uint64_t word) {
  for (int shift = 56; shift >= 0; shift -= 8) bytes.push_back(static_cast<char>((word >> shift) & 0xff));
}

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
  Ring result(ring.begin() + static_cast<std::ptrdiff_t>(best), ring.end());
  result.insert(result.end(), ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(best));
  return result;
}

std::string bytes_of(const Ring& ring) {
  std::string bytes;
  bytes.reserve(8 + 16 * ring.size());
  append(bytes, static_cast<std::uint64_t>(ring.size()));
  for (const Point& p : from_smallest(ring)) {
    append_canonical(bytes, p.x());
    append_canonical(bytes, p.y());
  }
  return bytes;
}

}  // namespace

std::string canonical_bytes(const Region& region) {
  std::vector<std::string> polygons;
  for (const Polygon& polygon : region.polygons) {
    std::vector<std::string> holes;
    for (const Ring& hole : polygon.holes) holes.push_back(bytes_of(hole));
    std::sort(holes.begin(), holes.end());
    std::string bytes = bytes_of(polygon.outer);
    append(bytes, static_cast<std::uint64_t>(holes.size()));
    for (const std::string& hole : holes) bytes += hole;
    polygons.push_back(std::move(bytes));
  }
  std::sort(polygons.begin(), polygons.end());
  std::string all;
  append(all, static_cast<std::uint64_t>(polygons.size()));
  for (const std::string& polygon : polygons) all += polygon;
  return all;
}

std::string content_hash(const Map& map) { return sha256(canonical_bytes(map.free)); }

}  // namespace oxturn
