#include "algorithms/lanes/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/minkowski.hpp"
#include "geometry/overlay/offset.hpp"

namespace oxturn {

namespace {
constexpr double kSlack = 1e-6;  // of a lane's width: what is no more than rounding
}

Frame::Frame(double lane_degrees) {
  const double turn = std::remainder(90 - lane_degrees, 360.0);
  if (std::fmod(turn, 90.0) == 0) {
    const int quarter = (static_cast<int>(turn / 90) + 4) % 4;
    c_ = quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
    s_ = quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
  } else {
    c_ = std::cos(turn * kPi / 180);
    s_ = std::sin(turn * kPi / 180);
  }
}

Region Frame::to(const Region& region) const {
  Region turned = region;
  for (Polygon& polygon : turned.polygons) {
    for (Point& p : polygon.outer) p = to(p);
    for (Ring& hole : polygon.holes)
      for (Point& p : hole) p = to(p);
  }
  return turned;
}

Region lane_region(const Problem& problem, double inset, double chord) {
  // A point at least `inset` from the boundary of C is at least radius + inset from every wall. The intersection keeps
  // the part that holds the start, and obeys a restricted C. The C of a polygonal robot has no arcs: nothing is lost there.
  const Region &space = problem.configuration_space(), &free = problem.map().free;
  const Robot& robot = problem.robot();
  const Region inner = robot.footprint.empty()
                           ? erode(free, robot.radius + inset, chord, Bound::outside)
                           : erode(erode(free, robot.footprint, Bound::outside), inset, chord, Bound::outside);
  // A border that is no wall (a leash, a cut) is known to C alone.
  return problem.limited() ? intersect(inner, erode(space, inset, chord, Bound::outside)) : intersect(inner, space);
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
  // A width of exactly n lanes must not become n + 1 by rounding (offsets are snapped to a grid).
  const double wanted = std::ceil((high - low) / most * (1 - kSlack));
  const double count = std::max(1.0, wanted);
  const double width = std::max((high - low) / count, most * 1e-3);
  return {(low + high) / 2 - count * width / 2, width, static_cast<std::size_t>(count)};
}

namespace {

using Span = std::pair<double, double>;

double height_at(const Segment& e, double x) {
  const Point& a = before(e.a, e.b) ? e.a : e.b;  // the same answer whichever way the edge runs
  const Point& b = before(e.a, e.b) ? e.b : e.a;
  const double t = (x - a.x()) / (b.x() - a.x());
  const double y = a.y() + t * (b.y() - a.y());
  return std::clamp(y, std::min(a.y(), b.y()), std::max(a.y(), b.y()));
}

// Index of the slab that holds x, kept in range.
std::size_t slab_of(const Slabs& slabs, double x) {
  const double about = std::floor((x - slabs.first) / slabs.width);
  auto k = static_cast<std::size_t>(std::clamp(about, 0.0, static_cast<double>(slabs.count - 1)));
  while (k + 1 < slabs.count && slabs.line(k + 1) <= x) ++k;
  while (k > 0 && slabs.line(k) > x) --k;
  return k;
}

// A wall that runs along a slab line but for rounding is put on it: it must not ask for a lane in a slab that it only
// touches. The same x becomes the same x, so rings stay closed.
double on_line(const Slabs& slabs, double x) {
  const double k = std::round((x - slabs.first) / slabs.width);
  if (k < 0 || k > static_cast<double>(slabs.count)) return x;
  const double line = slabs.line(static_cast<std::size_t>(k));
  return std::abs(x - line) < kSlack * slabs.width ? line : x;
}

std::vector<Span> pairs_of(std::vector<double>& cuts) {
  std::sort(cuts.begin(), cuts.end());
  std::vector<Span> spans;
  for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) spans.push_back({cuts[i], cuts[i + 1]});
  return spans;
}

void merge(std::vector<Span>& spans) {
  std::sort(spans.begin(), spans.end());
  std::size_t kept = 0;
  for (const Span& s : spans) {
    if (kept > 0 && s.first <= spans[kept - 1].second) {
      spans[kept - 1].second = std::max(spans[kept - 1].second, s.second);
    } else {
      spans[kept++] = s;
    }
  }
  spans.resize(kept);
}

}  // namespace

// A horizontal chord of (region n slab) ends on the left at an edge in the slab or at the slab's left line. So the
// projection is the union of the heights of edges in the slab and of the section just right of its left line.
Projection project(const std::vector<Segment>& given, const Slabs& slabs) {
  Projection result;
  if (given.empty() || slabs.count == 0) return result;
  std::vector<Segment> edges = given;
  // Only the slabs that the edges reach are held: a small part of a wide map stays cheap.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (Segment& e : edges) {
    e.a.x() = on_line(slabs, e.a.x());
    e.b.x() = on_line(slabs, e.b.x());
    low = std::min({low, e.a.x(), e.b.x()});
    high = std::max({high, e.a.x(), e.b.x()});
  }
  const std::size_t base = slab_of(slabs, low);
  const std::size_t count = slab_of(slabs, high) - base + 1;

  std::vector<std::vector<Span>> reach(count);                           // per slab
  std::vector<std::vector<double>> right_cuts(count), left_cuts(count);  // just right, just left of line base + k
  for (const Segment& e : edges) {
    const Point& a = e.a.x() <= e.b.x() ? e.a : e.b;
    const Point& b = e.a.x() <= e.b.x() ? e.b : e.a;
    const std::size_t from = slab_of(slabs, a.x()), to = slab_of(slabs, b.x());
    if (a.x() == b.x() && a.x() == slabs.line(from)) continue;  // on a line: chords end at the other side
    double y = a.y();
    for (std::size_t k = from; k <= to; ++k) {
      const double left = slabs.line(k);
      if (k > from && b.x() <= left) break;  // only touches this slab
      const double next = k < to && slabs.line(k + 1) < b.x() ? height_at(e, slabs.line(k + 1)) : b.y();
      reach[k - base].push_back({std::min(y, next), std::max(y, next)});
      y = next;
    }
    for (std::size_t k = from; k <= to; ++k) {
      const double x = slabs.line(k);
      if (a.x() <= x && x < b.x()) right_cuts[k - base].push_back(height_at(e, x));
      if (a.x() < x && x <= b.x()) left_cuts[k - base].push_back(height_at(e, x));
    }
  }
  std::vector<std::vector<Span>> right(count);
  std::vector<std::size_t> first(count + 1, 0);
  for (std::size_t k = 0; k < count; ++k) {
    right[k] = pairs_of(right_cuts[k]);
    reach[k].insert(reach[k].end(), right[k].begin(), right[k].end());
    merge(reach[k]);
    first[k + 1] = first[k] + reach[k].size();
    for (const Span& s : reach[k]) result.stretches.push_back({base + k, s.first, s.second});
  }
  const auto holder = [&](std::size_t k, double y) {
    const auto at = std::upper_bound(reach[k].begin(), reach[k].end(), Span{y, 1e300});
    return first[k] + static_cast<std::size_t>(at - reach[k].begin()) - 1;
  };
  // The region joins two slabs where the sections on both sides of the line overlap.
  for (std::size_t k = 1; k < count; ++k) {
    const std::vector<Span> left = pairs_of(left_cuts[k]);
    for (std::size_t i = 0, j = 0; i < left.size() && j < right[k].size();) {
      const double lower = std::max(left[i].first, right[k][j].first),
                   upper = std::min(left[i].second, right[k][j].second);
      if (lower < upper) {
        const double middle = (lower + upper) / 2;
        if (!reach[k - 1].empty() && !reach[k].empty() && reach[k - 1].front().first <= middle &&
            reach[k].front().first <= middle)
          result.links.push_back({holder(k - 1, middle), holder(k, middle)});
      }
      if (left[i].second < right[k][j].second)
        ++i;
      else
        ++j;
    }
  }
  std::sort(result.links.begin(), result.links.end());
  result.links.erase(std::unique(result.links.begin(), result.links.end()), result.links.end());
  return result;
}

std::vector<std::pair<double, double>> clip_vertical(const EdgeIndex& room, double x, double low, double high,
                                                     double margin) {
  std::vector<double> stops;
  Box box;
  box.add({x, low});
  box.add({x, high});
  room.for_each_near(box, [&](std::size_t i) {
    const EdgeIndex::Edge& e = room.edges()[i];
    if (std::min(e.a.x(), e.b.x()) > x || std::max(e.a.x(), e.b.x()) < x) return;
    const auto add = [&](double y) {
      if (y > low && y < high) stops.push_back(y);
    };
    if (e.a.x() == e.b.x()) {
      add(e.a.y());
      add(e.b.y());
    } else {
      add(height_at({e.a, e.b}, x));
    }
  });
  std::sort(stops.begin(), stops.end());
  stops.push_back(high);
  std::vector<std::pair<double, double>> inside;
  double from = low;
  for (const double to : stops) {
    if (to - from > 2 * margin && room.contains({x, (from + to) / 2})) {
      if (!inside.empty() && inside.back().second == from)
        inside.back().second = to;
      else
        inside.push_back({from, to});
    }
    from = to;
  }
  // Where a wall stops it the end is a rounded crossing: pull it in, so that it is inside for certain.
  std::vector<std::pair<double, double>> kept;
  for (auto [a, b] : inside) {
    if (a != low || !room.contains({x, a})) a += margin;
    if (b != high || !room.contains({x, b})) b -= margin;
    if (a <= b) kept.push_back({a, b});
  }
  return kept;
}

Clipped clip(const std::vector<Stretch>& stretches, const Slabs& slabs, const EdgeIndex& room, double join,
             double margin) {
  Clipped result;
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    const Stretch& s = stretches[i];
    const double x = slabs.centre(s.slab);
    result.piece_of.push_back(Clipped::kNone);
    for (const auto& [low, high] : clip_vertical(room, x, s.low, s.high, margin)) {
      if (!result.pieces.empty() && result.pieces.back().slab == s.slab) {
        Stretch& last = result.pieces.back();
        if (low - last.high <= join && room.contains({x, last.high}, {x, low})) {
          last.high = high;
          if (result.piece_of[i] == Clipped::kNone) result.piece_of[i] = result.pieces.size() - 1;
          continue;
        }
      }
      if (result.piece_of[i] == Clipped::kNone) result.piece_of[i] = result.pieces.size();
      result.pieces.push_back({s.slab, low, high});
      result.source.push_back(i);
    }
  }
  return result;
}

}  // namespace oxturn
