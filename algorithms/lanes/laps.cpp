#include "algorithms/lanes/laps.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "geometry/coarse_arcs.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// Tool widths.
constexpr double kChord = 0.005;    // error of the laps' arcs
constexpr double kSimplify = 0.01;  // by which a lap may leave out vertices of its arcs

/// The laps of one level, to find the nearest.
class Level {
 public:
  Level(const Region& region, std::size_t first) : index_(region) {
    std::size_t number = first;
    for_each_ring(region, [&](const Ring& ring) {
      lap_of_edge_.insert(lap_of_edge_.end(), ring.size(), number);
      ++number;
    });
  }
  std::size_t nearest(const Point& p) const { return lap_of_edge_[index_.nearest(p)->edge]; }

 private:
  EdgeIndex index_;
  std::vector<std::size_t> lap_of_edge_;
};

/// What of the region may hold a disc of the radius: nothing that is smaller or narrower does. Eroded by the radius,
/// both are the same.
Region with_room(Region region, double radius) {
  std::erase_if(region.polygons, [&](const Polygon& p) {
    return area(p) < kPi * radius * radius || bounding_box(p.outer).size().minCoeff() < 2 * radius;
  });
  return region;
}

/// Adds what the tool leaves uncovered on its laps around two levels, one inside the other.
void add_uncovered(Region& between, const Region& outer, const Region& inner, const Robot& robot) {
  const double half = robot.tool_width / 2, seam = covered_seam(robot);
  for (Polygon& p : between_offsets(with_room(outer, half), inner, half, seam).polygons)
    between.polygons.push_back(std::move(p));
}

/// Calls after_level(outer, inner) for the regions of each level but the last and of the next one.
template <class F>
Laps laps_level_by_level(const Problem& problem, double spacing, const Context& context, int levels, F after_level) {
  const double width = problem.robot().tool_width, chord = kChord * width, simplify = kSimplify * width;
  const double step = spacing - chord - simplify;
  Laps laps;
  std::optional<Level> outer;
  Region region = straightened_space(problem);
  for (int level = 0; !region.empty() && level < levels && !context.cancelled(); ++level) {
    const std::size_t first = laps.all.size();
    for_each_ring(region, [&](const Ring& ring) {
      if (outer) laps.all[outer->nearest(ring.front())].inner.push_back(laps.all.size());
      laps.all.push_back({ring});
    });
    if (!outer) laps.outermost = laps.all.size();
    laps.depth_m = level * step + width / 2;
    if (level + 1 == levels) break;
    Region next = with_coarser_arcs(
        simplify_inward(erode(with_room(region, step), step, chord, Bound::inside), simplify), simplify / 2);
    after_level(region, next);
    if (!next.empty()) outer.emplace(region, first);
    region = std::move(next);
  }
  return laps;
}

}  // namespace

Laps laps_of(const Problem& problem, double spacing, const Context& context, int levels) {
  Region between;
  Laps laps = laps_level_by_level(problem, spacing, context, levels, [&](const Region& outer, const Region& inner) {
    add_uncovered(between, outer, inner, problem.robot());
  });
  laps.between = std::move(between);
  return laps;
}

Laps laps_alone(const Problem& problem, double spacing, const Context& context) {
  return laps_level_by_level(problem, spacing, context, std::numeric_limits<int>::max(), [](auto&&...) {});
}

std::size_t nearest_vertex(const Ring& ring, const Point& p) {
  const auto nearer = [&](const Point& a, const Point& b) { return distance(a, p) < distance(b, p); };
  return static_cast<std::size_t>(std::ranges::min_element(ring, nearer) - ring.begin());
}

Polyline lap_from(const Ring& ring, std::size_t entry) {
  Polyline lap(ring.begin(), ring.end());
  std::ranges::rotate(lap, lap.begin() + static_cast<std::ptrdiff_t>(entry));
  lap.push_back(ring[entry]);
  return lap;
}

NearestRing::NearestRing(const std::vector<const Ring*>& rings)
    : vertices_([&] {
        std::vector<Point> all;
        for (std::size_t r = 0; r < rings.size(); ++r) {
          first_.push_back(all.size());
          all.insert(all.end(), rings[r]->begin(), rings[r]->end());
          ring_of_.resize(all.size(), r);
        }
        first_.push_back(all.size());
        return PointGrid(all);
      }()) {}

std::size_t NearestRing::take(const Point& p) {
  std::size_t ring = 0;
  vertices_.visit(p, [&](std::size_t vertex, double) {
    ring = ring_of_[vertex];
    return false;
  });
  for (std::size_t v = first_[ring]; v < first_[ring + 1]; ++v) vertices_.remove(v);
  return ring;
}

}  // namespace oxturn
