#include "geometry/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "geometry/edge_index.hpp"
#include "geometry/predicates.hpp"
#include "random_region.hpp"

namespace oxturn {
namespace {

const Point& corner(const Mesh& mesh, const Mesh::Triangle& t, int i) {
  return mesh.points()[static_cast<std::size_t>(t.vertex[static_cast<std::size_t>(i % 3)])];
}

double total_area(const Mesh& mesh) {
  double sum = 0;
  for (const Mesh::Triangle& t : mesh.triangles()) {
    sum += cross(corner(mesh, t, 1) - corner(mesh, t, 0), corner(mesh, t, 2) - corner(mesh, t, 0)) / 2;
  }
  return sum;
}

/// Corners where some ring turns away from free space, from the rings alone (no ring touches another here).
std::vector<Point> turning_corners(const Region& region) {
  std::vector<Point> out;
  for_each_ring(region, [&](const Ring& r) {
    for (std::size_t i = 0; i < r.size(); ++i) {
      if (orientation(r[(i + r.size() - 1) % r.size()], r[i], r[(i + 1) % r.size()]) < 0) out.push_back(r[i]);
    }
  });
  std::sort(out.begin(), out.end(), before);
  return out;
}

std::vector<Point> reflex_points(const Mesh& mesh) {
  std::vector<Point> out;
  for (std::size_t i = 0; i < mesh.points().size(); ++i) {
    if (mesh.is_reflex(static_cast<std::int32_t>(i))) out.push_back(mesh.points()[i]);
  }
  std::sort(out.begin(), out.end(), before);
  return out;
}

void check(const Region& region) {
  const Mesh mesh(region);
  EXPECT_NEAR(total_area(mesh), area(region), 1e-12 * area(region));
  std::size_t corners = 0;
  for_each_ring(region, [&](const Ring& r) {
    for (const Point& p : r) EXPECT_EQ(mesh.points()[corners++], p);  // input order
  });
  EXPECT_EQ(mesh.points().size(), corners);
  // Euler: a polygon with h holes and n corners has n + 2 h - 2 triangles.
  std::size_t expected = corners + 2 * hole_count(region) - 2 * region.polygons.size();
  EXPECT_EQ(mesh.triangles().size(), expected);
  std::size_t walls = 0;
  for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
    const Mesh::Triangle& t = mesh.triangles()[k];
    EXPECT_GT(orientation(corner(mesh, t, 0), corner(mesh, t, 1), corner(mesh, t, 2)), 0);
    for (std::size_t i = 0; i < 3; ++i) {
      if (t.neighbour[i] == Mesh::kWall) {
        ++walls;
        continue;
      }
      const Mesh::Triangle& n = mesh.triangles()[static_cast<std::size_t>(t.neighbour[i])];
      bool back = false;
      for (std::size_t j = 0; j < 3; ++j) {
        back =
            back || (n.neighbour[j] == static_cast<std::int32_t>(k) && n.vertex[(j + 1) % 3] == t.vertex[(i + 2) % 3] &&
                     n.vertex[(j + 2) % 3] == t.vertex[(i + 1) % 3]);
      }
      EXPECT_TRUE(back);
    }
  }
  EXPECT_EQ(walls, corners);
  EXPECT_EQ(reflex_points(mesh), turning_corners(region));
}

TEST(Mesh, TrianglesCoverTheRegionExactly) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    check(clutter_box(rng, rng.between(1, 8), rng.between(1, 8), false));
    check(clutter_box(rng, rng.between(1, 8), rng.between(1, 8), true));
    check(star_region(rng, rng.between(4, 60)));
  }
}

TEST(Mesh, LocatesEveryPointInsideAndNoneOutside) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    const Region region = clutter_box(rng, 5, 5, seed % 2 == 0);
    const Mesh mesh(region);
    const EdgeIndex index(region);
    for (int q = 0; q < 200; ++q) {
      Point p(rng.between(-1.0, 6.0), rng.between(-1.0, 6.0));
      if (q % 2 == 0) p = (p * 8).array().round() / 8;
      const std::int32_t t = mesh.locate(p, 0);
      EXPECT_EQ(t != Mesh::kWall, index.contains(p)) << p.transpose();
      if (t != Mesh::kWall) { EXPECT_EQ(mesh.nearest_in(t, p), p); }
      const auto wall = index.nearest(p);
      ASSERT_TRUE(wall);
      const double far = index.contains(p) ? 0 : wall->distance;
      const std::int32_t near = mesh.locate(p, far * 1.001 + 1e-12);
      ASSERT_NE(near, Mesh::kWall);
      EXPECT_NEAR(distance(mesh.nearest_in(near, p), p), far, 1e-12);
      if (far > 1e-6) { EXPECT_EQ(mesh.locate(p, far * 0.999), Mesh::kWall); }
    }
    for (const Point& p : mesh.points()) EXPECT_NE(mesh.locate(p, 0), Mesh::kWall);
  }
}

TEST(Mesh, TakesRingsThatTouch) {
  // Two holes that meet in a corner, one that meets the border, two polygons that meet in a corner.
  const Region region{{{{{0, 0}, {8, 0}, {8, 8}, {0, 8}},
                        {{{1, 1}, {1, 3}, {3, 3}, {3, 1}}, {{3, 3}, {3, 5}, {5, 5}, {5, 3}}, {{6, 6}, {8, 7}, {7, 5}}}},
                       {{{8, 8}, {9, 8}, {9, 9}, {8, 9}}, {}}}};
  const Mesh mesh(region);
  EXPECT_NEAR(total_area(mesh), area(region), 1e-12);
  for (std::size_t i = 0; i < mesh.points().size(); ++i) {
    const Point& p = mesh.points()[i];
    if (p == Point(3, 3)) {
      EXPECT_FALSE(mesh.is_reflex(static_cast<std::int32_t>(i)));  // two fans of 90 degrees
    }
    if (p == Point(8, 8)) { EXPECT_FALSE(mesh.is_reflex(static_cast<std::int32_t>(i))); }
    if (p == Point(5, 5)) { EXPECT_TRUE(mesh.is_reflex(static_cast<std::int32_t>(i))); }
  }
}

TEST(Mesh, SurvivesWhatNoRegionShouldHold) {
  EXPECT_TRUE(Mesh(Region{}).triangles().empty());
  EXPECT_EQ(Mesh(Region{}).locate({0, 0}, 1), Mesh::kWall);
  const Mesh flat(Region{{{{{0, 0}, {1, 1}, {2, 2}}, {}}}});
  EXPECT_TRUE(flat.triangles().empty());
  const Mesh bow(Region{{{{{0, 0}, {2, 2}, {2, 0}, {0, 2}}, {}}}});  // crosses itself
  EXPECT_NEAR(total_area(bow), 2, 1e-12);
  const Mesh overlap(Region{{{{{0, 0}, {4, 0}, {4, 1}, {0, 1}}, {}}, {{{1, 1}, {2, 1}, {2, 2}, {1, 2}}, {}}}});
  EXPECT_NEAR(total_area(overlap), 5, 1e-12);  // edges that overlap in part
  EXPECT_THROW(Mesh(Region{{{{{0, 0}, {1, 0}, {std::nan(""), 1}}, {}}}}), std::invalid_argument);
}

TEST(Mesh, IsTheSameEveryTime) {
  Rng rng(5);
  const Region region = clutter_box(rng, 10, 10, true);
  const Mesh a(region), b(region);
  ASSERT_EQ(a.triangles().size(), b.triangles().size());
  for (std::size_t i = 0; i < a.triangles().size(); ++i) EXPECT_EQ(a.triangles()[i].vertex, b.triangles()[i].vertex);
}

/// By the angle bisectors, from half of the angles at two corners.
Point incentre(const Point& a, const Point& b, const Point& c) {
  const Point at_a = (b - a).normalized() + (c - a).normalized(), at_b = (a - b).normalized() + (c - b).normalized();
  return a + at_a * (cross(b - a, at_b) / cross(at_a, at_b));
}

TEST(Mesh, TheRoomiestPointIsTheCentreOfTheLargestIncircle) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Rng rng(seed);
    const Region region = seed % 2 ? clutter_box(rng, 8, 6, seed % 4 == 1) : star_region(rng, 20);
    const Mesh mesh(region);
    const EdgeIndex walls(region);
    const double limit = bounding_box(region).centre().x();
    const auto right = [&](const Point& p) { return p.x() > limit; };
    double widest = 0, widest_right = 0;
    for (const Mesh::Triangle& t : mesh.triangles()) {
      const Point &a = corner(mesh, t, 0), &b = corner(mesh, t, 1), &c = corner(mesh, t, 2);
      const Point centre = incentre(a, b, c);
      const double radius = distance_to_segment(centre, a, b);
      if (radius > 1e-6) { EXPECT_GT(walls.nearest(centre)->distance, radius * (1 - 1e-6)); }
      widest = std::max(widest, radius);
      if (right(centre)) widest_right = std::max(widest_right, radius);
    }
    const auto clear = [&](const std::optional<Point>& p) { return p ? walls.nearest(*p)->distance : 0; };
    const auto best = mesh.roomiest_point(), best_right = mesh.roomiest_point(right);
    EXPECT_GE(clear(best), widest * (1 - 1e-6)) << seed;
    EXPECT_GE(clear(best_right), widest_right * (1 - 1e-6)) << seed;
    if (best_right) { EXPECT_TRUE(right(*best_right) && walls.contains(*best_right)) << seed; }
    EXPECT_FALSE(mesh.roomiest_point([](const Point&) { return false; }));
  }
  EXPECT_FALSE(Mesh(Region{}).roomiest_point());
}

}  // namespace
}  // namespace oxturn
