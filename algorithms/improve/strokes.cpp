#include "algorithms/improve/strokes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace oxturn {
namespace {

constexpr std::size_t kMostTried = 3;                     // segments of the path from which a stroke is tried
constexpr double kLeastSamples = 25, kMostSamples = 100;  // of points on the outline
constexpr int kMostInserted = 12;                         // positions besides the two outermost
// In parts of the reach.
constexpr double kSpacing = 0.04;  // of points on the outline
constexpr double kTouch = 2e-6;    // from walls
constexpr double kError = 1e-6;

/// A point of the outline, and a position that covers it.
struct Demand {
  Point p, position;
  double within;  // of p
};

Polyline samples(const Polyline& outline, double reach) {
  const double around = length(outline);
  const double spacing = std::clamp(kSpacing * reach, around / kMostSamples, around / kLeastSamples);
  Polyline all{outline.front()};
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Point &a = outline[i - 1], &b = outline[i];
    const int parts = static_cast<int>(distance(a, b) / spacing) + 1;
    for (int k = 1; k < parts; ++k) all.push_back(lerp(a, b, static_cast<double>(k) / parts));
    if (distance(all.back(), b) > spacing / 2) all.push_back(b);
  }
  return all;
}

/// The nearest position of configuration space, or, where the tool reaches farther, one towards `from`.
std::optional<Demand> demand(const Point& p, const Point& from, double reach, const EdgeIndex& walls) {
  Point nearest = p;
  if (!walls.contains(p)) {
    const auto wall = walls.nearest(p, 2 * reach);
    if (!wall) return std::nullopt;
    const double far = std::max(wall->distance, 1e-12);
    nearest = wall->point + kTouch * reach / far * (wall->point - p);
    if (!walls.contains(nearest)) nearest = wall->point;
    if (!walls.contains(nearest)) return std::nullopt;
  }
  const double within = std::max(reach, distance(p, nearest));
  // |nearest + t * d - p| = within
  const Point d = from - nearest, e = nearest - p;
  const double a = d.squaredNorm(), b = e.dot(d), c = e.squaredNorm() - within * within;
  const double t = a > 0 ? std::clamp((-b + std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0) : 0;
  const Point towards = lerp(nearest, from, t);
  const bool legal = t > 0 && walls.contains(towards) && walls.contains(nearest, towards);
  return Demand{p, legal ? towards : nearest, within + kError * reach};
}

double distance_to(const Point& p, const Polyline& line) {
  double least = distance(p, line.front());
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

/// Where it makes the line longer by least.
void insert(const Point& p, Polyline& line) {
  double least = distance(p, line.front());
  std::size_t where = 0;
  for (std::size_t i = 1; i <= line.size(); ++i) {
    double more = distance(p, line[i - 1]);
    if (i < line.size()) more += distance(p, line[i]) - distance(line[i - 1], line[i]);
    if (more < least) {
      least = more;
      where = i;
    }
  }
  line.insert(line.begin() + static_cast<std::ptrdiff_t>(where), p);
}

/// Its edges as shortest paths, as round a corner.
Polyline connected(const Polyline& line, const Connector& connector) {
  Polyline all{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Polyline part = connector.path(line[i - 1], line[i]);
    all.insert(all.end(), part.begin() + 1, part.end());
  }
  return all;
}

/// From a position far from all others to the one farthest from it, over more where it is needed.
Polyline line_through(const std::vector<Demand>& demands, const Connector& connector) {
  const auto farthest = [&](const Point& p) {
    return std::ranges::max_element(demands, {}, [&](const Demand& d) { return distance(d.position, p); })->position;
  };
  const Point end = farthest(demands.front().position);
  Polyline visited{end, farthest(end)}, line = connected(visited, connector);
  for (int k = 0; k < kMostInserted; ++k) {
    const auto excess = [&](const Demand& d) { return distance_to(d.p, line) - d.within; };
    const Demand& worst = *std::ranges::max_element(demands, {}, excess);
    if (excess(worst) <= 0) break;
    insert(worst.position, visited);
    line = connected(visited, connector);
  }
  return line;
}

}  // namespace

std::optional<Detour> stroke(const NearbySegments& path, const Polyline& outline, double reach,
                             const Connector& connector, const EdgeIndex& walls) {
  const Box box = bounding_box(outline);
  const double far = 2 * reach + (box.high - box.centre()).norm();
  std::optional<Detour> best;
  for (const NearbySegments::Near& near : path.near(box.centre(), far, kMostTried)) {
    std::vector<Demand> demands;
    for (const Point& p : samples(outline, reach))
      if (const auto d = demand(p, near.at, reach, walls)) demands.push_back(*d);
    if (demands.empty()) continue;
    const Polyline line = line_through(demands, connector);
    for (const Point& end : {line.front(), line.back()}) {
      for (const NearbySegments::Near& from : path.near(end, far, kMostTried)) {
        const double least = distance(from.at, line.front()) + length(line) + distance(line.back(), from.at);
        if ((best && best->length <= least) || !walls.contains(from.at)) continue;
        Polyline points{from.at};
        points.insert(points.end(), line.begin(), line.end());
        points.push_back(from.at);
        points = connected(points, connector);
        if (const double around = length(points); !best || around < best->length)
          best = Detour{from.segment, path.along(from), std::move(points), around};
      }
    }
  }
  return best;
}

}  // namespace oxturn
