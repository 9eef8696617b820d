#include "algorithms/lanes/joint_cover.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostSegments = 64;   // a bit for each
constexpr std::size_t kMostVertices = 256;  // of a ring with its edges cut: halving it costs their square
constexpr int kRingHalvings = 8;
constexpr int kEdgeHalvings = 3;  // to find the segments that cover an edge one after another

/// A vertex, and a bit for each segment that covers it.
struct Vertex {
  Point at;
  std::uint64_t covered_by;
};
using Vertices = std::vector<Vertex>;

class JointCover {
 public:
  JointCover(std::span<const Segment> segments, double radius) : segments_(segments), radius_(radius) {}

  bool covers(const Ring& ring) const {
    Vertices vertices;
    Point before = ring.back();
    for (const Point& p : ring) {
      const double parts = std::max(1.0, std::ceil(distance(before, p) / radius_));
      if (static_cast<double>(vertices.size()) + parts > kMostVertices) return false;
      const int n = static_cast<int>(parts);
      for (int k = 1; k <= n; ++k) {
        const Point at = k < n ? lerp(before, p, k / parts) : p;
        vertices.push_back({at, covering(at)});
        if (vertices.back().covered_by == 0) return false;
      }
      before = p;
    }
    return covers_inside(vertices, kRingHalvings);
  }

 private:
  std::uint64_t covering(const Point& p) const {
    std::uint64_t by = 0;
    for (std::size_t k = 0; k < segments_.size(); ++k)
      if (distance_to_segment(p, segments_[k].a, segments_[k].b) <= radius_) by |= std::uint64_t{1} << k;
    return by;
  }

  bool covers_inside(const Vertices& ring, int halvings) const {
    Box box;
    for (const Vertex& v : ring) box.add(v.at);
    return covers_ring(ring, covering(box.centre())) || (halvings > 0 && covers_halves(ring, halvings - 1));
  }
  /// By the segments of the set alone.
  bool covers_ring(const Vertices& ring, std::uint64_t set) const {
    const Vertex* before = &ring.back();
    return std::ranges::all_of(
        ring, [&](const Vertex& v) { return covers_edge(*std::exchange(before, &v), v, set, kEdgeHalvings); });
  }
  bool covers_edge(const Vertex& a, const Vertex& b, std::uint64_t set, int halvings) const {
    if ((a.covered_by & b.covered_by & set) != 0) return true;
    if ((a.covered_by & set) == 0 || (b.covered_by & set) == 0 || halvings == 0) return false;
    const Point middle = lerp(a.at, b.at, 0.5);
    const Vertex between{middle, covering(middle)};
    return covers_edge(a, between, set, halvings - 1) && covers_edge(between, b, set, halvings - 1);
  }

  /// Of both sides of the shortest chord that leaves three of eight vertices on each.
  bool covers_halves(const Vertices& ring, int halvings) const {
    const std::size_t n = ring.size(), least = std::max<std::size_t>(2, n * 3 / 8);
    double shortest = std::numeric_limits<double>::infinity();
    auto from = ring.end(), to = ring.end();
    for (auto i = ring.begin(); i != ring.end(); ++i)
      for (std::size_t k = least; k + least <= n && k < static_cast<std::size_t>(ring.end() - i); ++k) {
        const auto j = i + static_cast<std::ptrdiff_t>(k);
        if (const double d = (i->at - j->at).squaredNorm(); d < shortest) shortest = d, from = i, to = j;
      }
    if (from == ring.end()) return false;
    const Vertices between(from, to + 1);
    Vertices others(to, ring.end());
    others.insert(others.end(), ring.begin(), from + 1);
    return covers_inside(between, halvings) && covers_inside(others, halvings);
  }

  std::span<const Segment> segments_;
  double radius_;
};

}  // namespace

bool cover_inside(std::span<const Segment> segments, double radius, const Ring& ring) {
  return segments.size() <= kMostSegments && JointCover(segments, radius).covers(ring);
}

}  // namespace oxturn
