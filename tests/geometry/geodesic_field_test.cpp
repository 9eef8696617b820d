#include "geometry/tether/geodesic_field.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "geodesic_oracle.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/paths/shortest_path.hpp"
#include "random_region.hpp"
#include "samples.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using Arc = GeodesicField::Arc;
constexpr double kInf = std::numeric_limits<double>::infinity();

/// Blocks of half a metre, one in the middle of each square metre: equally long paths everywhere.
Region lattice(int n) {
  Polygon p{{{0, 0}, {1.0 * n, 0}, {1.0 * n, 1.0 * n}, {0, 1.0 * n}}, {}};
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i)
      p.holes.push_back({{i + .25, j + .25}, {i + .25, j + .75}, {i + .75, j + .75}, {i + .75, j + .25}});
  }
  return {{p}};
}

/// 0: convex holes, 1: the same on a lattice, 2: a star, 3: a star with star holes, 4: equal blocks.
Region some_region(int kind, Rng& rng) {
  if (kind == 2) return star_region(rng, rng.between(5, 40));
  if (kind == 3) return samples::holed_star(rng, {3, 4}, 8);
  if (kind == 4) return lattice(rng.between(1, 4));
  return clutter_box(rng, rng.between(1, 4), rng.between(1, 4), kind == 1);
}

struct Scene {
  Region region;
  EdgeIndex index;
  Box box;
  Scene(int kind, Rng& rng) : region(some_region(kind, rng)), index(region), box(bounding_box(region)) {}
  Point open(Rng& rng) const {
    while (true) {
      const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      if (index.contains(p)) return p;
    }
  }
  /// In the open, at a corner, or on a wall.
  Point anywhere(Rng& rng) const {
    while (true) {
      if (rng.chance(0.6)) return open(rng);
      const EdgeIndex::Edge& e = index.edges()[rng.below(index.edges().size())];
      const Point p = rng.chance(0.5) ? e.a : Point((e.a + e.b) / 2);
      if (index.contains(p)) return p;
    }
  }
};

/// Calls f(scene, rng) for `n` seeds of each kind of region.
template <class F>
void for_each_scene(std::uint64_t n, std::initializer_list<int> kinds, F f) {
  for (const int kind : kinds) {
    for (const std::uint64_t seed : seeds(n)) {
      SCOPED_TRACE(testing::Message() << "kind " << kind << " seed " << seed);
      Rng rng(mix(seed, "geodesic") + static_cast<std::uint64_t>(kind));
      const Scene scene(kind, rng);
      f(scene, rng);
      if (testing::Test::HasFatalFailure()) return;
    }
  }
}

// --- distances -------------------------------------------------------------------------------------------

TEST(GeodesicField, DistancesAgreeWithAVisibilityGraph) {
  for_each_scene(60, {0, 1, 2, 3, 4}, [](const Scene& scene, Rng& rng) {
    const Point anchor = scene.anywhere(rng);
    const GeodesicOracle oracle(scene.region, anchor);
    const GeodesicField field(scene.region, anchor, {}, 1e-9);
    for (int q = 0; q < 20; ++q) {
      const Point p = scene.anywhere(rng);
      const double expected = oracle.distance(p);
      ASSERT_NEAR(field.distance(p), expected, 1e-9 * (1 + expected)) << p.transpose();
      const Polyline path = field.path(p);
      ASSERT_GE(path.size(), 2u);
      EXPECT_EQ(path.front(), anchor);
      EXPECT_EQ(path.back(), p);
      EXPECT_NEAR(length(path), expected, 1e-9 * (1 + expected));
      for (std::size_t i = 1; i < path.size(); ++i) EXPECT_TRUE(scene.index.contains(path[i - 1], path[i]));
      const GeodesicField::Sight sight = field.sight(p);
      EXPECT_NEAR(sight.before + distance(sight.from, p), expected, 1e-9 * (1 + expected));
      EXPECT_TRUE(scene.index.contains(sight.from, p));
      EXPECT_EQ(sight.corners == 0, sight.from == anchor);
    }
    double most = 0;
    for (int q = 0; q < 40; ++q) most = std::max(most, field.distance(scene.open(rng)));
    EXPECT_GE(field.farthest(), most * (1 - 1e-12));
  });
}

// The barriers become thin real walls for the oracle.
TEST(GeodesicField, DistancesWithBarriersAgreeWithAVisibilityGraph) {
  for_each_scene(40, {0, 1, 3}, [](const Scene& scene, Rng& rng) {
    const std::vector<Polyline> lines = barriers(scene.region, rng.between(0.1, 0.6));
    const Point anchor = scene.open(rng);
    const Region walled = cut_along(scene.region, lines, 1e-5);
    const GeodesicOracle oracle(walled, anchor);
    const GeodesicField field(scene.region, anchor, lines, 1e-9);
    if (!oracle.index().contains(anchor)) return;
    for (int q = 0; q < 20; ++q) {
      const Point p = scene.open(rng);
      if (!oracle.index().contains(p)) continue;
      const double expected = oracle.distance(p);
      const double d = field.distance(p);
      EXPECT_TRUE(d == expected || std::abs(d - expected) < 1e-3) << p.transpose() << " " << d << " " << expected;
    }
  });
}

// Turned maps, so that no point on a wall is exact: a rounded point must not fall out of its cone.
TEST(GeodesicField, PointsOnWallsAreAsFarAsPointsBesideThem) {
  for_each_scene(25, {0, 1, 2, 3, 4}, [](const Scene& scene, Rng& rng) {
    const double angle = rng.between(0.0, 6.0);
    const Point shift(rng.between(-1000.0, 1000.0), rng.between(-1000.0, 1000.0));
    const Region region = transformed(scene.region, angle, shift);
    const GeodesicField field(region, rotated(scene.anywhere(rng), angle) + shift, {}, 1e-9);
    const EdgeIndex index(region);
    for (const EdgeIndex::Edge& e : index.edges()) {
      const Point inwards = perpendicular((e.b - e.a).normalized());
      for (const double t : {0.0, 1e-6, rng.unit(), 1.0}) {
        const Point p = lerp(e.a, e.b, t), beside = lerp(e.a, e.b, std::clamp(t, 1e-5, 1 - 1e-5)) + 1e-7 * inwards;
        if (!index.contains(beside)) continue;
        EXPECT_NEAR(field.distance(p), field.distance(beside), 1e-6 + 2e-5 * distance(e.a, e.b)) << p.transpose();
      }
    }
  });
}

TEST(GeodesicField, FarthestIsReached) {
  for_each_scene(6, {0, 1, 3, 4}, [](const Scene& scene, Rng& rng) {
    const GeodesicField field(scene.region, scene.anywhere(rng), {}, 1e-9);
    const double step = scene.box.size().maxCoeff() / 150;
    double most = 0;
    for (double x = scene.box.low.x(); x <= scene.box.high.x(); x += step) {
      for (double y = scene.box.low.y(); y <= scene.box.high.y(); y += step) {
        if (const double d = field.distance({x, y}); d < kInf) most = std::max(most, d);
      }
    }
    for (const EdgeIndex::Edge& e : scene.index.edges()) {
      for (const double t : {0.0, 0.25, 0.5, 0.75})
        if (const double d = field.distance(lerp(e.a, e.b, t)); d < kInf) most = std::max(most, d);
    }
    EXPECT_LE(most, field.farthest() + 1e-9);
    EXPECT_GE(most, field.farthest() - 1.5 * step);
  });
}

TEST(GeodesicField, OtherPartsAreInfinitelyFar) {
  Region region = box_region({0, 0}, {1, 1});
  region.polygons.push_back(box_region({1, 1}, {2, 2}).polygons.front());  // touching in a corner
  region.polygons.push_back(box_region({3, 0}, {4, 1}).polygons.front());
  const GeodesicField field(region, {0.5, 0.5}, {}, 1e-6);
  EXPECT_EQ(field.distance({1.5, 1.5}), kInf);
  EXPECT_EQ(field.distance({3.5, 0.5}), kInf);
  EXPECT_EQ(field.distance({2.5, 0.5}), kInf);
  EXPECT_EQ(field.distance({std::nan(""), 0.5}), kInf);
  EXPECT_TRUE(field.path({3.5, 0.5}).empty());
  EXPECT_EQ(field.sight({3.5, 0.5}).before, kInf);
  EXPECT_NEAR(field.distance({1, 1}), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(field.farthest(), std::sqrt(0.5), 1e-15);
  const GeodesicField at_touch(region, {1, 1}, {}, 1e-6);  // sees both
  EXPECT_NEAR(at_touch.distance({1.5, 1.5}), std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(at_touch.distance({0.5, 0.5}), std::sqrt(0.5), 1e-15);
}

TEST(GeodesicField, NoWayLeadsThroughAPointWhereRingsTouch) {
  // Two blocks that touch in (2, 2) close a diagonal from wall to wall but for gaps at the far ends.
  const Region region{
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{0.5, 2}, {2, 2}, {2, 0.5}}, {{2, 2}, {2, 3.5}, {3.5, 2}}}}}};
  const GeodesicField field(region, {1.5, 2.5}, {}, 1e-9);
  EXPECT_EQ(field.sight({1.5, 2.5}).corners, 0u);
  EXPECT_GT(field.distance({2.5, 1.5}), 3);
  const GeodesicOracle oracle(cut_along(region, {{{2, 2}, {2.001, 2.001}}}, 1e-5), {1.5, 2.5});
  EXPECT_NEAR(field.distance({2.5, 1.5}), oracle.distance({2.5, 1.5}), 1e-3);
}

TEST(GeodesicField, LevelsAndCutOfACutRoomStayOnTheirSideOfTheBarrier) {
  const Region box = box_region({0, 0}, {4, 4});
  const GeodesicField field(box, {1, 1}, {{{2, 0}, {2, 4}}}, 1e-9);
  EXPECT_EQ(field.distance({3, 1}), kInf);
  EXPECT_NEAR(field.farthest(), std::sqrt(10.0), 1e-12);
  for (const auto& chain : field.level_set(1.5)) {
    for (const Arc& a : chain) EXPECT_LE(a.at((a.begin + a.end) / 2).x(), 2);
  }
}

// The circle about (2, 0.5), seen edge on: one chain on each side of the wall of no thickness.
TEST(GeodesicField, AnArcEndsAtABarrierThatPointsAtItsCentre) {
  const GeodesicField field(box_region({0, 0}, {4, 4}), {2, 0.5}, {{{2, 1}, {2, 4}}}, 1e-9);
  const auto chains = field.level_set(1.5);
  ASSERT_EQ(chains.size(), 2u);
  EXPECT_NEAR(chains[0].front().end, kPi / 2, 1e-9);
  EXPECT_NEAR(chains[1].front().begin, kPi / 2, 1e-9);
  EXPECT_EQ(field.level_set(0.4).size(), 1u);
  EXPECT_NEAR(field.level_set(0.4)[0][0].end - field.level_set(0.4)[0][0].begin, 2 * kPi, 1e-12);
}

TEST(GeodesicField, TenThousandCornersInLineAreCheap) {
  Polygon p;
  for (int i = 0; i < 10000; ++i) p.outer.push_back({0.001 * i, 0});
  p.outer.push_back({10, 0});
  p.outer.push_back({10, 4});
  p.outer.push_back({0, 4});
  Ring hole;
  for (int i = 0; i <= 2000; ++i) hole.push_back({4 + 0.001 * i, 2});
  hole.push_back({6, 1});
  hole.push_back({4, 1});
  p.holes.push_back(hole);
  const GeodesicField field({{p}}, {0.5, 2}, {}, 1e-9);
  EXPECT_NEAR(field.distance({9.5, 2}), 9, 1e-12);  // along the flush wall
  EXPECT_NEAR(field.distance({5, 0.9}), distance({0.5, 2}, {4, 1}) + distance({4, 1}, {5, 0.9}), 1e-12);
  EXPECT_LE(field.path({9.5, 2}).size(), 4u);
  EXPECT_FALSE(field.level_set(6).empty());
}

TEST(GeodesicField, RefusesAnAnchorOutsideAndBadNumbers) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  const Region box = box_region({0, 0}, {1, 1});
  EXPECT_THAT(
      [&] {
        GeodesicField(box, {2, 0.5}, {}, 1e-3);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("anchor (2, 0.5) is outside")));
  EXPECT_THAT(
      [&] {
        GeodesicField(box, {std::nan(""), 0.5}, {}, 1e-3);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("is outside")));
  EXPECT_THROW(GeodesicField(Region{}, {0, 0}, {}, 1), std::invalid_argument);
  EXPECT_THROW(GeodesicField(box, {0.5, 0.5}, {}, -1), std::invalid_argument);
  const GeodesicField field(box, {-0.0005, 0.5}, {}, 1e-3);
  EXPECT_EQ(field.anchor(), Point(-0.0005, 0.5));
  EXPECT_NEAR(field.distance({1.0005, 0.5}), 1, 1e-9);
  EXPECT_EQ(field.distance({1.01, 0.5}), kInf);
  EXPECT_THROW(field.cut_locus(0), std::invalid_argument);
  EXPECT_THROW(sampled({{{0, 0}, 1, 0, 1}}, 0), std::invalid_argument);
}

// --- levels ----------------------------------------------------------------------------------------------

std::vector<Arc> arcs_of(const std::vector<std::vector<Arc>>& chains) {
  std::vector<Arc> all;
  for (const auto& chain : chains) all.insert(all.end(), chain.begin(), chain.end());
  return all;
}
double total_length(const std::vector<Arc>& arcs) {
  double sum = 0;
  for (const Arc& a : arcs) sum += a.radius * (a.end - a.begin);
  return sum;
}

/// How often the segment from p to q crosses the arcs.
int crossings(const std::vector<Arc>& arcs, const Point& p, const Point& q) {
  int n = 0;
  for (const Arc& a : arcs) {
    const Point d = q - p, f = p - a.centre;
    const double A = d.squaredNorm(), B = f.dot(d), C = f.squaredNorm() - a.radius * a.radius, disc = B * B - A * C;
    if (disc < 0) continue;
    for (const double root : {-1.0, 1.0}) {
      const double s = (-B + root * std::sqrt(disc)) / A;
      if (s < 0 || s > 1) continue;
      const Point x = p + s * d - a.centre;
      double angle = std::atan2(x.y(), x.x());
      angle -= 2 * kPi * std::floor((angle - a.begin + 1e-9) / (2 * kPi));  // from begin on
      if (angle <= a.end + 1e-9) ++n;
    }
  }
  return n;
}

TEST(GeodesicField, LevelsAreAtTheirDistance) {
  for_each_scene(25, {0, 1, 2, 3, 4}, [](const Scene& scene, Rng& rng) {
    const Point anchor = scene.anywhere(rng);
    const GeodesicOracle oracle(scene.region, anchor);
    const GeodesicField field(scene.region, anchor, {}, 1e-9);
    for (int k = 0; k < 3; ++k) {
      const double l = field.farthest() * rng.between(0.05, 1.0);
      for (const Arc& a : arcs_of(field.level_set(l))) {
        EXPECT_LT(a.begin, a.end);
        EXPECT_LE(std::abs(a.begin), kPi + 1e-9);
        EXPECT_LE(a.end, a.begin + 2 * kPi + 1e-9);
        const double t = rng.between(0.01, 0.99);
        const Point p = a.at(a.begin + t * (a.end - a.begin));
        if (!scene.index.contains(p)) continue;  // on a wall, but for rounding
        EXPECT_NEAR(oracle.distance(p), l, 1e-9 * (1 + l)) << p.transpose();
      }
    }
  });
}

TEST(GeodesicField, LevelsAreWhollyThere) {
  for_each_scene(25, {0, 1, 2, 3, 4}, [](const Scene& scene, Rng& rng) {
    const GeodesicField field(scene.region, scene.anywhere(rng), {}, 1e-9);
    const double l = field.farthest() * rng.between(0.1, 0.95);
    const std::vector<Arc> arcs = arcs_of(field.level_set(l));
    for (int q = 0; q < 200; ++q) {
      const Point p = scene.open(rng);
      const double angle = rng.between(0.0, 2 * kPi), step = 0.05 * scene.box.size().norm();
      const Point r = p + step * Point(std::cos(angle), std::sin(angle));
      if (!scene.index.contains(p, r)) continue;
      const double below = field.distance(p) - l, above = field.distance(r) - l;
      if (std::abs(below) < 1e-7 || std::abs(above) < 1e-7) continue;
      if ((below < 0) != (above < 0)) {
        EXPECT_GT(crossings(arcs, p, r), 0) << p.transpose() << " to " << r.transpose();
      } else if (std::min(below, above) > step) {
        EXPECT_EQ(crossings(arcs, p, r), 0) << p.transpose() << " to " << r.transpose();
      }
    }
  });
}

TEST(GeodesicField, ChainsAreConnectedAndEndWhereTheyMay) {
  int chains_seen = 0, joints_seen = 0, meetings = 0;
  for_each_scene(25, {0, 1, 2, 3, 4}, [&](const Scene& scene, Rng& rng) {
    const GeodesicField field(scene.region, scene.anywhere(rng), {}, 1e-9);
    const auto chains = field.level_set(field.farthest() * rng.between(0.1, 0.95));
    const double near = 1e-7;
    const auto first = [](const auto& c) { return c.front().at(c.front().begin); };
    const auto last = [](const auto& c) { return c.back().at(c.back().end); };
    const auto on_wall = [&](const Point& p) { return samples::distance_to_boundary(scene.region, p) < near; };
    for (const auto& chain : chains) {
      ++chains_seen;
      ASSERT_FALSE(chain.empty());
      for (std::size_t i = 1; i < chain.size(); ++i) {
        ++joints_seen;
        const Point end = chain[i - 1].at(chain[i - 1].end);
        EXPECT_LT(distance(end, chain[i].at(chain[i].begin)), near);
        // Both centres lie on one ray with the joint: the string only starts or stops to bend there.
        const Point a = (end - chain[i - 1].centre).normalized(), b = (end - chain[i].centre).normalized();
        EXPECT_LT((a - b).norm(), 1e-4) << end.transpose();
      }
      if (distance(first(chain), last(chain)) < near) continue;  // closed
      // An open end lies on a wall, or a path around another side meets there, and its chain continues the boundary.
      const auto met = [&](const Point& p, auto end_of) {
        return std::any_of(chains.begin(), chains.end(), [&](const auto& c) { return distance(end_of(c), p) < near; });
      };
      if (!on_wall(last(chain))) {
        EXPECT_TRUE(met(last(chain), first)) << last(chain).transpose();
        ++meetings;
      }
      EXPECT_TRUE(on_wall(first(chain)) || met(first(chain), last)) << first(chain).transpose();
    }
  });
  EXPECT_GT(chains_seen, 300);
  EXPECT_GT(joints_seen, 100);
  EXPECT_GT(meetings, 50);
}

TEST(GeodesicField, LevelsInTheOpenAreRoundAndSampledWithinTheChord) {
  const GeodesicField field(box_region({0, 0}, {4, 4}), {2, 1}, {}, 1e-9);
  const auto whole = field.level_set(0.5);
  ASSERT_EQ(whole.size(), 1u);
  ASSERT_EQ(whole[0].size(), 1u);
  EXPECT_NEAR(whole[0][0].end - whole[0][0].begin, 2 * kPi, 1e-12);
  const Polyline line = sampled(whole[0], 1e-3);
  EXPECT_LT(distance(line.front(), line.back()), 1e-12);
  EXPECT_LT(line.size(), 60u);
  for (std::size_t i = 1; i < line.size(); ++i)
    EXPECT_GE(distance((line[i] + line[i - 1]) / 2, {2, 1}), 0.5 - 1.0001e-3);
  EXPECT_EQ(field.level_set(1.5).size(), 1u);  // open below
  EXPECT_TRUE(field.level_set(0).empty());
  EXPECT_TRUE(field.level_set(-1).empty());
  EXPECT_TRUE(field.level_set(field.farthest() + 1e-6).empty());
}

// Round one block: the chains follow one another counter-clockwise as seen from the anchor.
TEST(GeodesicField, ChainsAreInOrderRoundTheAnchor) {
  const Region region{
      {{{{0, 0}, {8, 0}, {8, 8}, {0, 8}}, {{{3, 3}, {3, 5}, {5, 5}, {5, 3}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}}};
  for (const double l : {1.0, 2.5, 3.5, 4.5, 6.0}) {
    const GeodesicField field(region, {2.5, 4}, {}, 1e-9);
    double before = -kPi;
    for (const auto& chain : field.level_set(l)) {
      const Arc& a = chain.front();
      const Polyline path = field.path(a.at((a.begin + a.end) / 2));
      const Point d = path[1] - path[0];
      const double angle = std::atan2(d.y(), d.x());
      EXPECT_GE(angle, before - 1e-9) << l;
      before = angle;
    }
  }
}

TEST(GeodesicField, TurningTheMapTurnsLevelsAndCut) {
  for_each_scene(12, {0, 1, 3, 4}, [](const Scene& scene, Rng& rng) {
    const Point anchor = scene.open(rng);
    const double angle = rng.between(0.0, 6.0);
    const Point shift(rng.between(-50.0, 50.0), rng.between(-50.0, 50.0));
    const Region turned = transformed(scene.region, angle, shift);
    const GeodesicField a(scene.region, anchor, {}, 1e-9), b(turned, rotated(anchor, angle) + shift, {}, 1e-9);
    EXPECT_NEAR(a.farthest(), b.farthest(), 1e-9);
    for (int q = 0; q < 20; ++q) {
      const Point p = scene.open(rng);
      EXPECT_NEAR(a.distance(p), b.distance(rotated(p, angle) + shift), 1e-9);
    }
    const double l = a.farthest() * rng.between(0.2, 0.9);
    EXPECT_NEAR(total_length(arcs_of(a.level_set(l))), total_length(arcs_of(b.level_set(l))), 1e-5);
  });
}

TEST(GeodesicField, FarFromTheOriginAndInMillimetres) {
  for_each_scene(10, {0, 1, 3, 4}, [](const Scene& scene, Rng& rng) {
    const Point anchor = scene.open(rng);
    const GeodesicField field(scene.region, anchor, {}, 1e-9);
    for (const auto& [scale, shift] : {std::pair(1.0, 1e6), std::pair(1e-3, 0.0), std::pair(1e3, -1e6)}) {
      const auto moved = [&, k = scale, by = Point(shift, 0.5 * shift)](const Point& p) { return Point(k * p + by); };
      Region region = scene.region;
      for (Polygon& p : region.polygons) {
        for (Point& v : p.outer) v = moved(v);
        for (Ring& h : p.holes) {
          for (Point& v : h) v = moved(v);
        }
      }
      const GeodesicField other(region, moved(anchor), {}, 1e-6 * scale);
      const double slack = 1e-9 * scale + 1e-14 * std::abs(shift);
      for (int q = 0; q < 10; ++q) {
        const Point p = scene.open(rng);
        EXPECT_NEAR(other.distance(moved(p)), scale * field.distance(p), slack);
      }
      const double l = rng.between(0.2, 0.9) * field.farthest(), width = 1e-5 * scale * scene.box.size().norm();
      EXPECT_NEAR(total_length(arcs_of(other.level_set(scale * l))), scale * total_length(arcs_of(field.level_set(l))),
                  1e-4 * scale);
      EXPECT_EQ(hole_count(cut_along(region, other.cut_locus(width), width)), 0u);
    }
  });
}

// --- the cut ---------------------------------------------------------------------------------------------

/// Does the closed line wind around the middle of some (convex) hole?
bool goes_round_a_hole(const Region& region, const Polyline& loop) {
  for (const Polygon& polygon : region.polygons) {
    for (const Ring& hole : polygon.holes) {
      Point middle(0, 0);
      for (const Point& p : hole) middle += p / static_cast<double>(hole.size());
      double turn = 0;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Point a = loop[i] - middle, b = loop[(i + 1) % loop.size()] - middle;
        turn += std::atan2(cross(a, b), a.dot(b));
      }
      if (std::abs(turn) > kPi) return true;
    }
  }
  return false;
}

TEST(GeodesicField, AtTheCutTwoEquallyLongPathsEncloseAnObstacle) {
  int tried = 0;
  for_each_scene(30, {0, 1}, [&](const Scene& scene, Rng& rng) {
    const Point anchor = scene.anywhere(rng);
    const GeodesicOracle oracle(scene.region, anchor);
    const GeodesicField field(scene.region, anchor, {}, 1e-9);
    for (const Polyline& piece : field.cut_locus(1e-6)) {
      if (length(piece) < 1e-3) continue;
      const std::size_t i = piece.size() / 2;  // a point of the curve; of a straight piece its middle
      const bool straight = piece.size() == 2;
      const Point x = straight ? Point((piece[0] + piece[1]) / 2) : piece[i];
      const Point side = perpendicular(piece[i] - piece[i - 1]).normalized() * 1e-5;
      if (!scene.index.contains(x + side, x - side)) continue;
      Polyline left = field.path(x + side), right = field.path(x - side);
      ASSERT_FALSE(left.empty() || right.empty());
      ++tried;
      left.back() = x;
      right.back() = x;
      const double slack = straight ? 2.1e-6 : 1e-9;
      EXPECT_NEAR(length(left), length(right), slack) << x.transpose();
      EXPECT_NEAR(length(left), oracle.distance(x), slack);
      left.insert(left.end(), right.rbegin(), right.rend());
      EXPECT_TRUE(goes_round_a_hole(scene.region, left)) << x.transpose();
    }
  });
  EXPECT_GT(tried, 300);
}

// Pieces are left out only if no point of theirs is farther than asked for.
TEST(GeodesicField, TheCutBeyondADistance) {
  for_each_scene(40, {0, 1, 3, 4}, [](const Scene& scene, Rng& rng) {
    const GeodesicField field(scene.region, scene.open(rng), {}, 1e-9);
    const double beyond = rng.between(0.3, 1.0) * field.farthest();
    std::vector<Polyline> far = field.cut_locus(1e-3);
    std::erase_if(far, [&](const Polyline& piece) {
      return std::ranges::all_of(piece, [&](const Point& p) { return field.distance(p) <= beyond; });
    });
    EXPECT_EQ(field.cut_locus(1e-3, beyond), far);
    EXPECT_TRUE(field.cut_locus(1e-3, field.farthest() * (1 + 1e-9)).empty());
  });
}

// The theorem: cut open, free space is simply connected, and its shortest paths from the anchor are the geodesics.
TEST(GeodesicField, SpaceCutOpenHasNoHolesAndTheSameDistances) {
  for_each_scene(50, {0, 1, 3, 4}, [](const Scene& scene, Rng& rng) {
    const Point anchor = scene.open(rng);
    const GeodesicField field(scene.region, anchor, {}, 1e-9);
    const double width = 1e-5 * scene.box.size().norm();
    const Region open = cut_along(scene.region, field.cut_locus(width), width);
    EXPECT_EQ(hole_count(open), 0u);
    const ShortestPaths paths(open, 2 * width);
    const EdgeIndex index(open);
    for (int q = 0; q < 15; ++q) {
      const Point p = scene.open(rng);
      if (!index.contains(p)) continue;
      const auto path = paths.path(anchor, p);
      ASSERT_TRUE(path) << p.transpose();
      EXPECT_NEAR(length(*path), field.distance(p), 20 * width) << p.transpose();
    }
  });
}

TEST(GeodesicField, TheCutRespectsBarriers) {
  for_each_scene(30, {0, 1, 3}, [](const Scene& scene, Rng& rng) {
    const Point anchor = scene.open(rng);
    std::vector<Polyline> lines = barriers(scene.region, rng.between(0.1, 0.4));
    const GeodesicField field(scene.region, anchor, lines, 1e-9);
    const double width = 1e-5 * scene.box.size().norm();
    std::vector<Polyline> cut = field.cut_locus(width);
    cut.insert(cut.end(), lines.begin(), lines.end());
    const Region open = cut_along(scene.region, cut, width);
    const ShortestPaths paths(open, 2 * width);
    const EdgeIndex index(open);
    if (!index.contains(anchor)) return;
    for (const Polygon& part : open.polygons) {
      if (!contains({{part}}, anchor)) continue;
      EXPECT_EQ(part.holes.size(), 0u);
    }
    for (int q = 0; q < 15; ++q) {
      const Point p = scene.open(rng);
      if (!index.contains(p)) continue;
      const auto path = paths.path(anchor, p);
      const double expected = field.distance(p);
      ASSERT_EQ(path.has_value(), expected < kInf) << p.transpose();
      EXPECT_NEAR(path ? length(*path) : 0, path ? expected : 0, 40 * width) << p.transpose();
    }
  });
}

TEST(GeodesicField, BehindASquarePillarTheCutIsStraight) {
  const Region region{{{{{0, 0}, {8, 0}, {8, 4}, {0, 4}}, {{{3, 1.5}, {3, 2.5}, {4, 2.5}, {4, 1.5}}}}}};
  const GeodesicField field(region, {1, 2}, {}, 1e-9);
  double sum = 0;
  Box box;
  for (const Polyline& piece : field.cut_locus(1e-3)) {
    sum += length(piece);
    for (const Point& p : piece) {
      EXPECT_NEAR(p.y(), 2, 1e-9);
      box.add(p);
    }
  }
  EXPECT_NEAR(box.low.x(), 4, 1e-6);
  EXPECT_NEAR(box.high.x(), 8, 1e-6);
  EXPECT_GE(sum, 4 - 1e-6);  // pieces on an edge of the mesh may be there twice
}

// The tip of the wedge lies beside the line on which both paths round the pillar are equally long. The nearer it is,
// the more the curve of equal length by the tip and by a corner of the pillar resembles a ray.
TEST(GeodesicField, BehindATipBesideTheCutItGoesOnToTheWall) {
  for (double off = 1e-3; off > 1e-14; off /= 1.7)
    for (const double side : {-off, off})
      for (const double tip : {4.1, 5.3, 7.2}) {
        const Ring wedge{{tip, 2 + side}, {7.5, 2.3}, {7.5, 1.7}};
        const Ring pillar{{3, 1.5}, {3, 2.5}, {4, 2.5}, {4, 1.5}};
        const Region region{{{{{0, 0}, {8, 0}, {8, 4}, {0, 4}}, {pillar, wedge}}}};
        const GeodesicField field(region, {1, 2}, {}, 1e-9);
        const std::vector<Polyline> cut = field.cut_locus(1e-3);
        for (const Polyline& piece : cut)
          for (const Point& p : piece) EXPECT_TRUE((Box{{-1e-9, -1e-9}, {8 + 1e-9, 4 + 1e-9}}.contains(p))) << off;
        EXPECT_EQ(hole_count(cut_along(region, cut, 1e-3)), 0u) << side << " " << tip;
      }
}

TEST(GeodesicField, WithoutHolesNothingIsCut) {
  for_each_scene(40, {2}, [](const Scene& scene, Rng& rng) {
    EXPECT_TRUE(GeodesicField(scene.region, scene.anywhere(rng), {}, 1e-9).cut_locus(0.1).empty());
  });
}

TEST(GeodesicField, CutCurvesKeepTheChord) {
  for_each_scene(10, {0, 3}, [](const Scene& scene, Rng& rng) {
    const GeodesicField field(scene.region, scene.open(rng), {}, 1e-9);
    const auto fine = field.cut_locus(1e-6), coarse = field.cut_locus(1e-2);
    ASSERT_EQ(fine.size(), coarse.size());
    for (std::size_t k = 0; k < fine.size(); ++k) {
      EXPECT_EQ(fine[k].front(), coarse[k].front());
      EXPECT_EQ(fine[k].back(), coarse[k].back());
      EXPECT_LE(coarse[k].size(), fine[k].size());
      for (const Point& p : fine[k]) {
        double off = kInf;
        for (std::size_t i = 1; i < coarse[k].size(); ++i)
          off = std::min(off, distance_to_segment(p, coarse[k][i - 1], coarse[k][i]));
        EXPECT_LE(off, 1.0001e-2);
      }
    }
  });
}

}  // namespace
}  // namespace oxturn
