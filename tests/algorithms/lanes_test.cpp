#include "algorithms/lanes/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/lanes/lane_direction.hpp"
#include "maps/generators.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/seeds.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

TEST(Frame, TurnsLanesUprightAndBack) {
  Rng rng(1);
  for (const double degrees : {0.0, 90.0, 180.0, 270.0, -90.0, 12.5, 133.0}) {
    const Frame frame(degrees);
    const double a = degrees * kPi / 180;
    const Point along = frame.to({std::cos(a), std::sin(a)});
    EXPECT_NEAR(along.x(), 0, 1e-12);
    EXPECT_NEAR(along.y(), 1, 1e-12);
    const Point p(rng.between(-9.0, 9.0), rng.between(-9.0, 9.0));
    EXPECT_LT(distance(frame.back(frame.to(p)), p), 1e-14);
    if (std::fmod(degrees, 90) == 0) { EXPECT_EQ(frame.back(frame.to(p)), p); }
  }
}

TEST(Slabs, AreTheFewestThatFit) {
  EXPECT_EQ(slabs_over(0, 4, 0.4).count, 10u);
  EXPECT_EQ(slabs_over(1e6, 1e6 + 3 * 0.1, 0.1).count, 3u);
  EXPECT_EQ(slabs_over(0, 4.01, 0.4).count, 11u);
  EXPECT_EQ(slabs_over(2, 2, 0.4).count, 1u);
  const Slabs s = slabs_over(1, 8, 0.3);
  EXPECT_NEAR(s.line(0), 1, 1e-12);
  EXPECT_NEAR(s.line(s.count), 8, 1e-12);
}

// Every point of the region is in a stretch of its slab; every stretch's height is a point's height (sampled).
TEST(Project, IsTheProjectionOfEachSlab) {
  for (const auto seed : seeds(6))
    for (const char* name : {"cave", "field", "polygon"}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(seed));
      const Region region = generate(name, {{"width", 10.0}, {"height", 10.0}}, seed).free;
      const Box box = bounding_box(region);
      const Slabs slabs = slabs_over(box.low.x(), box.high.x(), 0.7);
      const Projection all = project(edges_of(region), slabs);
      Rng rng(seed);
      for (int i = 0; i < 2000; ++i) {
        const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
        if (!contains(region, p)) continue;
        const auto k = static_cast<std::size_t>((p.x() - slabs.first) / slabs.width);
        EXPECT_TRUE(std::any_of(all.stretches.begin(), all.stretches.end(),
                                [&](const Stretch& s) { return s.slab == k && s.low <= p.y() && p.y() <= s.high; }));
      }
      for (const Stretch& s : all.stretches) {
        const double y = rng.between(s.low, s.high);
        bool met = s.high - s.low < 1e-3;  // too thin to be met by samples
        for (int i = 0; i <= 4000 && !met; ++i)
          met = contains(region, {slabs.line(s.slab) + slabs.width * i / 4000, y});
        EXPECT_TRUE(met) << s.slab << " " << y;
      }
      for (std::size_t i = 1; i < all.stretches.size(); ++i) {
        const Stretch &a = all.stretches[i - 1], &b = all.stretches[i];
        EXPECT_TRUE(a.slab < b.slab || (a.slab == b.slab && a.high < b.low));
      }
      for (const auto& [a, b] : all.links) EXPECT_EQ(all.stretches[a].slab + 1, all.stretches[b].slab);
    }
}

TEST(Project, LinksFollowTheRegionNotTheHeights) {
  // A wall with a gap at the bottom right on a slab line: lanes 0 and 1 join only through the gap.
  const Region region = drawn_region({"..#..", "..#..", "....."});
  const Projection all = project(edges_of(region), {0, 1, 5});
  ASSERT_EQ(all.stretches.size(), 5u);  // the wall's slab has the gap alone
  EXPECT_NEAR(all.stretches[2].high, 1, 1e-12);
  EXPECT_EQ(all.links.size(), 4u);
}

TEST(ClipVertical, AgreesWithSampling) {
  for (const auto seed : seeds(10)) {
    const Region region = generate("cave", {{"width", 10.0}, {"height", 10.0}}, seed).free;
    const EdgeIndex room(region);
    Rng rng(seed);
    for (int i = 0; i < 50; ++i) {
      const double x = rng.between(-0.5, 10.5), low = rng.between(-1.0, 6.0), high = low + rng.between(0.0, 6.0);
      const auto pieces = clip_vertical(room, x, low, high, 1e-9);
      for (int k = 0; k < 40; ++k) {
        const double y = rng.between(low, high);
        const bool in =
            std::any_of(pieces.begin(), pieces.end(), [&](const auto& s) { return s.first <= y && y <= s.second; });
        EXPECT_EQ(in, contains(region, {x, y})) << x << " " << y;
      }
      for (const auto& [a, b] : pieces) EXPECT_TRUE(room.contains({x, a}, {x, b}));
    }
  }
}

TEST(SweepDirection, FollowsALongHall) {
  for (const double degrees : {0.0, 17.0, 90.0, 141.5}) {
    const Region hall = transformed(box_region({0, 0}, {20, 3}), degrees * kPi / 180, {3, 4});
    EXPECT_NEAR(std::remainder(best_lane_direction(hall, 0.4) - degrees, 180), 0, 0.2) << degrees;
  }
}

}  // namespace
}  // namespace oxturn
