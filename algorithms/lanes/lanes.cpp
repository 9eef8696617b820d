#include "algorithms/lanes/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/math.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/minkowski.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kSlack = 1e-6;     // in slab widths: differences up to this are rounding
constexpr double kThinnest = 1e-3;  // in lane spacings: the least width of a slab
constexpr double kInfinity = std::numeric_limits<double>::infinity();

using YInterval = std::pair<double, double>;  // low, high

/// y of the edge at x, the same for both directions of the edge.
double height_at(const Segment& e, double x) {
  const Point& a = before(e.a, e.b) ? e.a : e.b;
  const Point& b = before(e.a, e.b) ? e.b : e.a;
  const double t = (x - a.x()) / (b.x() - a.x());
  const double y = a.y() + t * (b.y() - a.y());
  return std::clamp(y, std::min(a.y(), b.y()), std::max(a.y(), b.y()));
}

/// Index of the slab that contains x; the first or last slab for x outside of all.
std::size_t slab_of(const Slabs& slabs, double x) {
  const double about = std::floor((x - slabs.first) / slabs.width);
  auto k = static_cast<std::size_t>(std::clamp(about, 0.0, static_cast<double>(slabs.count - 1)));
  while (k + 1 < slabs.count && slabs.line(k + 1) <= x) ++k;
  while (k > 0 && slabs.line(k) > x) --k;
  return k;
}

/// x, or the slab line that differs from it by no more than rounding: a wall along a slab line must not ask for a lane
/// in a slab that it only touches. Equal x stay equal, so rings stay closed.
double snapped(const Slabs& slabs, double x) {
  const double k = std::round((x - slabs.first) / slabs.width);
  if (k < 0 || k > static_cast<double>(slabs.count)) return x;
  const double line = slabs.line(static_cast<std::size_t>(k));
  return std::abs(x - line) < kSlack * slabs.width ? line : x;
}

/// The inside of a section, by the even-odd rule, from the heights at which edges cross it.
std::vector<YInterval> inside_of(std::vector<double>& crossings) {
  std::sort(crossings.begin(), crossings.end());
  std::vector<YInterval> inside;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) inside.push_back({crossings[i], crossings[i + 1]});
  return inside;
}

/// Unites intervals that overlap or touch; leaves them sorted.
void merge(std::vector<YInterval>& intervals) {
  std::sort(intervals.begin(), intervals.end());
  std::size_t kept = 0;
  for (const YInterval& s : intervals) {
    if (kept > 0 && s.first <= intervals[kept - 1].second) {
      intervals[kept - 1].second = std::max(intervals[kept - 1].second, s.second);
    } else {
      intervals[kept++] = s;
    }
  }
  intervals.resize(kept);
}

/// Computes a projection. A horizontal chord of the region's part in a slab ends on the left either at an edge in the
/// slab or at the slab's left line. So the projection is the union of the heights of all edges in the slab and of the
/// section just right of its left line.
class Projector {
 public:
  Projector(const std::vector<Segment>& edges, const Slabs& slabs) : slabs_(slabs), edges_(edges) {
    double low = kInfinity, high = -low;
    for (Segment& e : edges_) {
      e.a.x() = snapped(slabs, e.a.x());
      e.b.x() = snapped(slabs, e.b.x());
      low = std::min({low, e.a.x(), e.b.x()});
      high = std::max({high, e.a.x(), e.b.x()});
    }
    // Only the slabs that the edges reach take memory: a small part of a wide map stays cheap.
    base_ = slab_of(slabs, low);
    const std::size_t count = slab_of(slabs, high) - base_ + 1;
    heights_.resize(count);
    right_crossings_.resize(count);
    left_crossings_.resize(count);
    right_sections_.resize(count);
    first_.assign(count + 1, 0);
  }

  Projection run() {
    for (const Segment& e : edges_) add(e);
    Projection result;
    for (std::size_t k = 0; k < heights_.size(); ++k) {
      right_sections_[k] = inside_of(right_crossings_[k]);
      heights_[k].insert(heights_[k].end(), right_sections_[k].begin(), right_sections_[k].end());
      merge(heights_[k]);
      first_[k + 1] = first_[k] + heights_[k].size();
      for (const YInterval& s : heights_[k]) result.intervals.push_back({base_ + k, s.first, s.second});
    }
    for (std::size_t k = 1; k < heights_.size(); ++k) add_links(k, result.links);
    std::sort(result.links.begin(), result.links.end());
    result.links.erase(std::unique(result.links.begin(), result.links.end()), result.links.end());
    return result;
  }

 private:
  void add(const Segment& e) {
    const Point& a = e.a.x() <= e.b.x() ? e.a : e.b;
    const Point& b = e.a.x() <= e.b.x() ? e.b : e.a;
    const std::size_t from = slab_of(slabs_, a.x()), to = slab_of(slabs_, b.x());
    if (a.x() == b.x() && a.x() == slabs_.line(from)) return;  // on a slab line: chords end at the edge on the far side
    double y = a.y();
    for (std::size_t k = from; k <= to; ++k) {
      const double left = slabs_.line(k);
      if (k > from && b.x() <= left) break;  // only touches this slab
      const double next = k < to && slabs_.line(k + 1) < b.x() ? height_at(e, slabs_.line(k + 1)) : b.y();
      heights_[k - base_].push_back({std::min(y, next), std::max(y, next)});
      y = next;
    }
    for (std::size_t k = from; k <= to; ++k) {
      const double x = slabs_.line(k);
      if (a.x() <= x && x < b.x()) right_crossings_[k - base_].push_back(height_at(e, x));
      if (a.x() < x && x <= b.x()) left_crossings_[k - base_].push_back(height_at(e, x));
    }
  }

  /// The region connects two slabs where its sections on both sides of the line between them overlap.
  void add_links(std::size_t k, std::vector<std::pair<std::size_t, std::size_t>>& links) {
    const std::vector<YInterval> left = inside_of(left_crossings_[k]);
    const std::vector<YInterval>& right = right_sections_[k];
    for (std::size_t i = 0, j = 0; i < left.size() && j < right.size();) {
      const double lower = std::max(left[i].first, right[j].first), upper = std::min(left[i].second, right[j].second);
      if (lower < upper) {
        const double middle = (lower + upper) / 2;
        if (begins_below(k - 1, middle) && begins_below(k, middle))
          links.push_back({interval_at(k - 1, middle), interval_at(k, middle)});
      }
      if (left[i].second < right[j].second)
        ++i;
      else
        ++j;
    }
  }
  bool begins_below(std::size_t k, double y) const { return !heights_[k].empty() && heights_[k].front().first <= y; }
  /// Index of the interval of slab k that contains y.
  std::size_t interval_at(std::size_t k, double y) const {
    const auto after = std::upper_bound(heights_[k].begin(), heights_[k].end(), YInterval{y, kInfinity});
    return first_[k] + static_cast<std::size_t>(after - heights_[k].begin()) - 1;
  }

  const Slabs& slabs_;
  std::vector<Segment> edges_;
  // All by slab, counted from slab `base_`.
  std::size_t base_ = 0;
  std::vector<std::vector<YInterval>> heights_;  // that edges reach; at the end: the slab's projection
  // Heights at which edges cross the slab's left line: just right of it, just left of it.
  std::vector<std::vector<double>> right_crossings_, left_crossings_;
  std::vector<std::vector<YInterval>> right_sections_;
  std::vector<std::size_t> first_;  // index of the slab's first interval in the result
};

/// Heights between low and high at which an edge of `space` meets the vertical line at x, sorted; then `high`.
std::vector<double> stops_on(const EdgeIndex& space, double x, double low, double high) {
  std::vector<double> stops;
  const auto add = [&](double y) {
    if (y > low && y < high) stops.push_back(y);
  };
  space.for_each_near(Box{{x, low}, {x, high}}, [&](std::size_t i) {
    const EdgeIndex::Edge& e = space.edges()[i];
    if (std::min(e.a.x(), e.b.x()) > x || std::max(e.a.x(), e.b.x()) < x) return;
    if (e.a.x() == e.b.x()) {
      add(e.a.y());
      add(e.b.y());
    } else {
      add(height_at({e.a, e.b}, x));
    }
  });
  std::sort(stops.begin(), stops.end());
  stops.push_back(high);
  return stops;
}

}  // namespace

LaneFrame::LaneFrame(double lane_degrees) {
  const double turn = std::remainder(90 - lane_degrees, 360.0);
  if (std::fmod(turn, 90.0) == 0) {
    const int quarter = (static_cast<int>(turn / 90) + 4) % 4;
    c_ = quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
    s_ = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
  } else {
    c_ = math::cos(turn * kPi / 180);
    s_ = math::sin(turn * kPi / 180);
  }
}

Region LaneFrame::to_frame(const Region& region) const {
  Region rotated = region;
  for (Polygon& polygon : rotated.polygons) {
    for (Point& p : polygon.outer) p = to_frame(p);
    for (Ring& hole : polygon.holes)
      for (Point& p : hole) p = to_frame(p);
  }
  return rotated;
}

Region lane_region(const Problem& problem, double inset, double chord) {
  const Region &space = problem.configuration_space(), &free = problem.map().free;
  // Only C knows the boundaries that are no walls (the tether's reach, a cut). It may be a small part of the map.
  if (problem.limited()) return erode(space, inset, chord, Bound::outside);
  // A point at least `inset` from the boundary of C is at least radius + inset from every wall. Intersecting with C
  // keeps the component of the start. The C of a polygonal robot has no arcs, so eroding in two steps loses nothing
  // there.
  const Robot& robot = problem.robot();
  const Region inner = robot.footprint.empty()
                           ? erode(free, robot.radius + inset, chord, Bound::outside)
                           : erode(erode(free, robot.footprint, Bound::outside), inset, chord, Bound::outside);
  return intersect(inner, space);
}

void add_ring(std::vector<Segment>& edges, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<Segment> edges_of(const Region& region) {
  std::vector<Segment> edges;
  edges.reserve(vertex_count(region));
  for_each_ring(region, [&](const Ring& ring) { add_ring(edges, ring); });
  return edges;
}

Slabs slabs_over(double low, double high, double most) {
  // Offsets are snapped to a grid: a width of exactly n lanes must not become n + 1 by rounding.
  const double wanted = std::ceil((high - low) / most * (1 - kSlack));
  const double count = std::max(1.0, wanted);
  const double width = std::max((high - low) / count, most * kThinnest);
  return {(low + high) / 2 - count * width / 2, width, static_cast<std::size_t>(count)};
}

Projection project(const std::vector<Segment>& edges, const Slabs& slabs) {
  if (edges.empty() || slabs.count == 0) return {};
  return Projector(edges, slabs).run();
}

std::vector<std::pair<double, double>> clip_vertical(const EdgeIndex& space, double x, double low, double high,
                                                     double margin) {
  std::vector<YInterval> inside;
  double from = low;
  for (const double to : stops_on(space, x, low, high)) {
    if (to - from > 2 * margin && space.contains({x, (from + to) / 2})) {
      if (!inside.empty() && inside.back().second == from)
        inside.back().second = to;
      else
        inside.push_back({from, to});
    }
    from = to;
  }
  // At a wall the end is a rounded crossing: pulled in, so that it is certainly inside.
  std::vector<YInterval> kept;
  for (auto [a, b] : inside) {
    if (a != low || !space.contains({x, a})) a += margin;
    if (b != high || !space.contains({x, b})) b -= margin;
    if (a <= b) kept.push_back({a, b});
  }
  return kept;
}

ClippedLanes clip_lanes(const std::vector<LaneInterval>& intervals, const Slabs& slabs, const EdgeIndex& space,
                        double join, double margin) {
  ClippedLanes result;
  for (const LaneInterval& s : intervals) {
    const double x = slabs.centre(s.slab);
    std::size_t first = ClippedLanes::kNone;
    for (const auto& [low, high] : clip_vertical(space, x, s.low, s.high, margin)) {
      LaneInterval* const last = result.pieces.empty() ? nullptr : &result.pieces.back();
      if (last != nullptr && last->slab == s.slab && low - last->high <= join &&
          space.contains({x, last->high}, {x, low}))
        last->high = high;
      else
        result.pieces.push_back({s.slab, low, high});
      if (first == ClippedLanes::kNone) first = result.pieces.size() - 1;
    }
    result.piece_of.push_back(first);
  }
  return result;
}

}  // namespace oxturn
