#include "algorithms/polygon/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/boolean.hpp"
#include "geometry/offset.hpp"

namespace oxturn {

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
  // the part that holds the start, and obeys a restricted C.
  return intersect(erode(problem.map().free, problem.robot().radius + inset, chord, Bound::outside),
                   problem.configuration_space());
}

void add_ring(std::vector<Segment>& edges, const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()]});
}

std::vector<Segment> edges_of(const Region& region) {
  std::vector<Segment> edges;
  edges.reserve(corner_count(region));
  for_each_ring(region, [&](const Ring& ring) { add_ring(edges, ring); });
  return edges;
}

Slabs slabs_over(double low, double high, double most) {
  // A hair of slack, so that a width of exactly n lanes does not become n + 1 by rounding.
  const double wanted = std::ceil((high - low) / most * (1 - 1e-12) - 1e-9);
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
  const double k = std::floor((x - slabs.first) / slabs.width);
  return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(slabs.count - 1)));
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

Projection project(const std::vector<Segment>& edges, const Slabs& slabs) {
  Projection result;
  if (edges.empty() || slabs.count == 0) return result;
  // Only the slabs that the edges reach are held: a small part of a wide map stays cheap.
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Segment& e : edges) {
    low = std::min({low, e.a.x(), e.b.x()});
    high = std::max({high, e.a.x(), e.b.x()});
  }
  const std::size_t base = slab_of(slabs, low);
  const std::size_t count = slab_of(slabs, high) - base + 1;

  std::vector<std::vector<Span>> reach(count);       // per slab
  std::vector<std::vector<double>> cuts(count + 1);  // crossings with the slab lines
  for (const Segment& e : edges) {
    const Point& a = e.a.x() <= e.b.x() ? e.a : e.b;
    const Point& b = e.a.x() <= e.b.x() ? e.b : e.a;
    const std::size_t from = slab_of(slabs, a.x()), to = slab_of(slabs, b.x());
    double y = a.y();
    for (std::size_t k = from; k <= to; ++k) {
      double next = b.y();
      const double right = slabs.line(k + 1);
      if (k < to && a.x() <= right && right < b.x()) next = height_at(e, right);
      reach[k - base].push_back({std::min(y, next), std::max(y, next)});
      y = next;
    }
    // Half-open crossings a.x <= line < b.x, by the lines themselves: agrees between edges that share an end.
    for (std::size_t k = from; k <= to + 1 && k <= base + count; ++k) {
      const double x = slabs.line(k);
      if (a.x() <= x && x < b.x()) cuts[k - base].push_back(height_at(e, x));
    }
  }
  std::vector<std::vector<Span>> across(count + 1);
  for (std::size_t k = 0; k <= count; ++k) {
    std::sort(cuts[k].begin(), cuts[k].end());
    for (std::size_t i = 0; i + 1 < cuts[k].size(); i += 2) {
      const Span span{cuts[k][i], cuts[k][i + 1]};
      across[k].push_back(span);
      if (k > 0) reach[k - 1].push_back(span);
      if (k < count) reach[k].push_back(span);
    }
  }
  std::vector<std::size_t> first(count + 1, 0);
  for (std::size_t k = 0; k < count; ++k) {
    merge(reach[k]);
    first[k + 1] = first[k] + reach[k].size();
    for (const Span& s : reach[k]) result.stretches.push_back({base + k, s.first, s.second});
  }
  const auto holder = [&](std::size_t k, double y) {  // every crossing span lies in one stretch on either side
    const auto at = std::upper_bound(reach[k].begin(), reach[k].end(), Span{y, 1e300});
    return first[k] + static_cast<std::size_t>(at - reach[k].begin()) - 1;
  };
  for (std::size_t k = 1; k < count; ++k)
    for (const Span& s : across[k]) result.links.push_back({holder(k - 1, s.first), holder(k, s.first)});
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
    const auto add = [&](double y) { if (y > low && y < high) stops.push_back(y); };
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
      if (!inside.empty() && inside.back().second == from) inside.back().second = to;
      else inside.push_back({from, to});
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
