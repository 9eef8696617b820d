// Random drawings, and a judge of tours that knows nothing but geometry.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "algorithms/tour/tour_shapes.hpp"
#include "base/random.hpp"

namespace oxturn {

/// Which features a random drawing has.
struct DrawingKind {
  bool lines = false, polygons = false, one_way = false, joined = false, contained = false;
};

inline std::vector<DrawingKind> drawing_kinds() {
  return {{},
          {.lines = true},
          {.polygons = true},
          {.lines = true, .polygons = true},
          {.lines = true, .one_way = true},
          {.lines = true, .polygons = true, .joined = true},
          {.lines = true, .polygons = true, .contained = true},
          {.lines = true, .polygons = true, .one_way = true, .joined = true, .contained = true}};
}

inline TourShape random_shape(const DrawingKind& kind, Rng& rng) {
  TourShape shape;
  const Point at(rng.between(0.0, 100.0), rng.between(0.0, 100.0));
  const auto near = [&] { return Point(at.x() + rng.between(-15.0, 15.0), at.y() + rng.between(-15.0, 15.0)); };
  shape.points = {at};
  shape.closed = kind.polygons && (!kind.lines || rng.chance(0.5));
  const int more = shape.closed ? rng.between(2, 4) : kind.lines ? rng.between(0, 2) : 0;
  for (int k = 0; k < more; ++k) shape.points.push_back(near());
  shape.one_way = kind.one_way && rng.chance(0.5);
  return shape;
}

/// n shapes; start and end are free or fixed, or the tour is closed.
inline ShapeTour random_drawing(const DrawingKind& kind, std::size_t n, Rng& rng) {
  ShapeTour drawing;
  for (std::size_t s = 0; s < n; ++s) drawing.shapes.push_back(random_shape(kind, rng));
  if (rng.chance(0.5)) drawing.start = Point(rng.between(0.0, 100.0), rng.between(0.0, 100.0));
  if (rng.chance(0.3)) drawing.end = Point(rng.between(0.0, 100.0), rng.between(0.0, 100.0));
  if (drawing.start && rng.chance(0.3)) drawing.end = drawing.start;
  // Joined in pairs, at last and first vertices, so that one-way shapes agree.
  const auto last = [&](std::size_t s) { return drawing.shapes[s].closed ? 0 : drawing.shapes[s].points.size() - 1; };
  for (std::size_t s = 0; kind.joined && s + 1 < n; s += 4) drawing.joined.push_back({{s, last(s)}, {s + 1, 0}});
  // The inner one has the lower number, so there is no cycle.
  for (std::size_t k = 0; kind.contained && k < n; ++k) {
    const std::size_t inner = rng.below(n), outer = rng.below(n);
    if (inner < outer) drawing.contained.push_back({outer, inner});
  }
  return drawing;
}

/// The cost of driving shapes in this order, by geometry alone; checks what the drawing demands.
inline double judged_cost(const ShapeTour& drawing, const std::vector<ShapeVisit>& visits) {
  const std::size_t n = drawing.shapes.size();
  std::vector<std::size_t> position(n, n), entry(n, 0), exit(n, 0);
  double sum = 0;
  EXPECT_EQ(visits.size(), n);
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const auto& [s, at] = visits[i];
    const Polyline& points = drawing.shapes[s].points;
    EXPECT_EQ(position[s], n) << "shape " << s << " is driven twice";
    position[s] = i;
    entry[s] = at;
    exit[s] = drawing.shapes[s].closed ? at : points.size() - 1 - at;
    if (drawing.shapes[s].closed) {
      EXPECT_LT(at, points.size());
      sum += distance(points.back(), points.front());
    } else {
      EXPECT_TRUE(at == 0 || (at + 1 == points.size() && !drawing.shapes[s].one_way)) << "shape " << s;
    }
    for (std::size_t k = 1; k < points.size(); ++k) sum += distance(points[k - 1], points[k]);
    if (i > 0) {
      const std::size_t before = visits[i - 1].shape;
      sum += distance(drawing.shapes[before].points[exit[before]], points[at]);
    }
  }
  const auto& first = visits.front();
  const auto& last = visits.back();
  if (drawing.start) sum += distance(*drawing.start, drawing.shapes[first.shape].points[first.entry]);
  if (drawing.end) sum += distance(drawing.shapes[last.shape].points[exit[last.shape]], *drawing.end);
  for (const auto& [outer, inner] : drawing.contained)
    EXPECT_LT(position[inner], position[outer]) << inner << " lies inside " << outer;
  for (const auto& [a, b] : drawing.joined) {
    const bool forwards = position[a.shape] + 1 == position[b.shape];
    EXPECT_TRUE(forwards || position[b.shape] + 1 == position[a.shape]) << a.shape << " joined to " << b.shape;
    const auto& [from, to] = forwards ? std::pair(a, b) : std::pair(b, a);
    EXPECT_EQ(exit[from.shape], from.vertex);
    EXPECT_EQ(entry[to.shape], to.vertex);
  }
  return sum;
}

}  // namespace oxturn
