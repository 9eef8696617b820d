// Figures of maps whose figures are known.
#include "maps/map_features.hpp"

#include <gtest/gtest.h>

#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

Map map_of(const Region& free) { return {"m", free, "file", ""}; }

TEST(MapFeatures, ARoomWithAPillar) {
  Region room = box_region({0, 0}, {6, 4});
  room.polygons[0].holes.push_back({{2, 1}, {2, 2}, {3, 2}, {3, 1}});
  const MapFeatures f = map_features(map_of(room));
  EXPECT_DOUBLE_EQ(f.area_m2, 23);
  EXPECT_DOUBLE_EQ(f.perimeter_m, 24);
  EXPECT_EQ(f.holes, 1u);
  EXPECT_EQ(f.reflex_vertices, 4u);
}

TEST(MapFeatures, TwoRoomsWithADoor) {
  for (const double door : {0.05, 0.3, 0.8}) {
    const Region rooms =
        unite({box_region({0, 0}, {3, 4}), box_region({3.2, 0}, {7, 4}), box_region({2.9, 1}, {3.3, 1 + door})});
    for (const double angle : {0.0, 0.7}) {
      const MapFeatures f = map_features(map_of(transformed(rooms, angle, {5, -2})));
      ASSERT_TRUE(f.narrowest_m) << door;
      EXPECT_GE(*f.narrowest_m, 0.99 * door);
      EXPECT_LE(*f.narrowest_m, 1.03 * door);
      EXPECT_EQ(f.reflex_vertices, 4u);
    }
  }
}

TEST(MapFeatures, ConvexMapsHaveNoPassage) {
  EXPECT_FALSE(map_features(map_of(box_region({0, 0}, {3, 4}))).narrowest_m);
  const Region corridor = box_region({0, 0}, {30, 0.2});
  EXPECT_FALSE(map_features(map_of(corridor)).narrowest_m);
}

}  // namespace
}  // namespace oxturn
