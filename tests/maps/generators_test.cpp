// The guarantees of every generator, by measures that the generators do not use themselves: validity, erosion, hashes.
#include "maps/generators.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "base/sha256.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/overlay/validity.hpp"
#include "geometry/raster.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

struct Case {
  std::string name;
  Settings settings;
  bool random = true;  // different seeds, different maps
};

/// Small maps, two or three settings of each generator; every third one rotated.
std::vector<Case> cases() {
  const auto size = [](double w, double h) { return Settings{{"width", w}, {"height", h}}; };
  const auto with = [](Settings s, const Settings& more) {
    for (const auto& [k, v] : more) s[k] = v;
    return s;
  };
  return {
      {"rectangle", size(5, 3), false},
      {"rectangle", with(size(5, 3), {{"rotation", 30.0}}), false},
      {"polygon", with(size(12, 9), {{"corners", std::int64_t{24}}})},
      {"polygon",
       with(size(20, 20), {{"corners", std::int64_t{60}}, {"compactness", 0.0}, {"winding", 1.0}, {"rotation", 17.0}})},
      {"polygon", with(size(20, 10), {{"corners", std::int64_t{30}}, {"compactness", 0.8}, {"jitter", 1.0}})},
      {"clutter", size(10, 8)},
      {"clutter", with(size(10, 10), {{"discs", 1.0}, {"density", 0.2}, {"rotation", 45.0}})},
      {"clutter", with(size(8, 12), {{"discs", 0.0}, {"corners", std::int64_t{3}}, {"passage", 1.05}})},
      {"rooms", {}},
      {"rooms", with(size(24, 18), {{"rooms", std::int64_t{20}}, {"loops", 0.5}, {"rotation", -12.5}})},
      {"rooms", with(size(10, 10), {{"rooms", std::int64_t{5}}, {"corridors", false}, {"door", 0.6}, {"wall", 0.1}})},
      {"maze", size(12, 10)},
      {"maze", with(size(9, 9), {{"loops", 0.3}, {"branching", 1.0}, {"corridor", 0.6}, {"rotation", 33.0}})},
      {"cave", size(20, 15)},
      {"cave", with(size(15, 15), {{"rock", 0.5}, {"grain", 0.3}, {"rotation", 60.0}})},
      {"cave", with(size(15, 12), {{"smoothing", std::int64_t{0}}, {"rounds", std::int64_t{2}}})},
      {"comb", {}},
      {"comb", with(size(15, 20), {{"both_sides", true}, {"jitter", 1.0}, {"rotation", 5.0}})},
      {"spiral", with(size(10, 12), {{"jitter", 1.0}})},
      {"spiral", with(size(14, 12), {{"round", true}, {"jitter", 1.0}, {"rotation", 7.0}})},
      {"spiral", size(10, 10), false},
      {"field", size(30, 20)},
      {"field", with(size(30, 40), {{"roughness", 1.0}, {"corners", std::int64_t{12}}, {"rotation", 80.0}})},
      {"berg-rectangle", {}, false},
      {"berg-rectangle", with(size(9, 7), {{"jitter", 1.0}, {"obstacle_height", 2.5}, {"rotation", 40.0}})},
      {"berg-rooms", size(10, 8)},
      {"berg-rooms", with(size(18, 14), {{"branches", 1.0}, {"doors", std::int64_t{3}}, {"rotation", -21.0}})},
      {"berg-rooms", with(size(12, 12), {{"jitter", 1.0}, {"loops", 0.0}, {"wall", 0.1}, {"door", 0.52}})},
      {"divided-corridor", size(5, 14)},
      {"divided-corridor", with(size(4, 12), {{"jitter", 1.0}, {"obstacles", std::int64_t{3}}, {"rotation", 15.0}})},
      {"pillars", size(6, 6), false},
      {"pillars", with(size(8, 6), {{"jitter", 1.0}, {"spacing", 1.4}, {"rotation", -30.0}})},
      {"speckle", size(12, 9)},
      {"speckle", with(size(15, 15), {{"blocked", 0.3}, {"cell", 0.7}, {"rotation", 20.0}})},
  };
}

template <class T>
T setting(const Case& c, const std::string& name) {
  const auto found = c.settings.find(name);
  if (found != c.settings.end()) return std::get<T>(found->second);
  const GeneratorInfo& info = built_in_maps().find(c.name);
  return std::get<T>(find_parameter("test", info.parameters, name).fallback);
}

std::string source_of(const Case& c, std::uint64_t seed) {
  std::string text = fmt::format("{} --seed {}", c.name, seed);
  for (const auto& [k, v] : c.settings) text += fmt::format(" --set {}={}", k, to_text(v));
  return text;
}

constexpr std::uint64_t kSeeds = 20;

TEST(Generators, AreValidAndConnected) {
  for (const Case& c : cases())
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(source_of(c, seed));
      const Map map = oxturn::generate(c.name, c.settings, seed);
      const auto flaw = find_flaw(map.free);
      EXPECT_FALSE(flaw) << flaw->reason;
      ASSERT_EQ(map.free.polygons.size(), 1u);
      EXPECT_GT(signed_area(map.free.polygons[0].outer), 0);
      for (const Ring& hole : map.free.polygons[0].holes) EXPECT_LT(signed_area(hole), 0);
      EXPECT_EQ(map.name, fmt::format("{}-{}", c.name, seed));
      EXPECT_EQ(map.family, c.name);
      EXPECT_EQ(map.source, source_of(c, seed));
    }
}

TEST(Generators, KeepToTheirSize) {
  for (const Case& c : cases())
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(source_of(c, seed));
      const Map map = oxturn::generate(c.name, c.settings, seed);
      const double w = setting<double>(c, "width"), h = setting<double>(c, "height");
      const double turn = -setting<double>(c, "rotation") * kPi / 180;
      const double total = area(map.free);
      EXPECT_GT(total, 0.08 * w * h);
      EXPECT_LE(total, w * h + 1e-4 * (w + h));
      const Point centre(w / 2, h / 2);
      for_each_ring(map.free, [&](const Ring& ring) {
        for (const Point& p : ring) {
          const Point q = centre + rotated(p - centre, turn);
          ASSERT_GT(q.x(), -1e-4);
          ASSERT_GT(q.y(), -1e-4);
          ASSERT_LT(q.x(), w + 1e-4);
          ASSERT_LT(q.y(), h + 1e-4);
        }
      });
    }
}

/// Share of `region`'s area in its largest polygon.
double largest_share(const Region& region) {
  double most = 0;
  for (const Polygon& p : region.polygons) most = std::max(most, area(p));
  return region.empty() ? 0 : most / area(region);
}

TEST(Generators, AreConnectedForADiscAsWideAsTheNarrowestPassage) {
  for (const Case& c : cases())
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(source_of(c, seed));
      const Map map = oxturn::generate(c.name, c.settings, seed);
      const double robot = setting<double>(c, "robot"), passage = setting<double>(c, "passage");
      const Region for_robot = erode(map.free, robot, robot / 200, Bound::inside);
      EXPECT_GT(largest_share(for_robot), 0.999);
      const Region for_passage = erode(map.free, 0.98 * passage * robot, robot / 200, Bound::inside);
      EXPECT_GT(largest_share(for_passage), 0.999);
    }
}

TEST(Generators, GiveTheSameBytesForTheSameSeed) {
  for (const Case& c : cases()) {
    std::set<std::string> hashes;
    for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(source_of(c, seed));
      const std::string hash = content_hash(oxturn::generate(c.name, c.settings, seed));
      EXPECT_EQ(hash, content_hash(oxturn::generate(c.name, c.settings, seed)));
      hashes.insert(hash);
    }
    EXPECT_EQ(hashes.size(), c.random ? kSeeds : 1u) << c.name;
  }
}

// Generators do not use libm, so one hash is valid for every compiler and preset. It proves determinism only: a
// deliberate change of a generator changes it.
TEST(Generators, GiveTheSameBytesOnEveryMachine) {
  std::string all;
  for (const Case& c : cases())
    for (std::uint64_t seed = 0; seed < 3; ++seed) all += content_hash(oxturn::generate(c.name, c.settings, seed));
  EXPECT_EQ(sha256(all), "a013ba3fa4b9c23b501adfdb09cbf32731e58ba40d3d98fb5259041f2382cf41");
}

/// Those made for a site of a given size. The size of others follows from what is to be covered.
std::vector<GeneratorInfo> site_generators() {
  std::vector<GeneratorInfo> all;
  for (const GeneratorInfo& g : built_in_maps())
    if (std::ranges::any_of(g.parameters, [](const ParameterInfo& p) { return p.name == "width"; })) all.push_back(g);
  return all;
}

TEST(Generators, RotationChangesNothingElse) {
  for (const GeneratorInfo& g : site_generators()) {
    SCOPED_TRACE(g.name);
    const Region straight = oxturn::generate(g.name, {}, 5).free,
                 turned = oxturn::generate(g.name, {{"rotation", 29.0}}, 5).free;
    EXPECT_EQ(hole_count(straight), hole_count(turned));
    EXPECT_NEAR(area(straight), area(turned), 1e-5 * area(straight));
    EXPECT_NEAR(perimeter(straight), perimeter(turned), 1e-4 * perimeter(straight));
    const Region quarter = oxturn::generate(g.name, {{"rotation", 90.0}}, 5).free;
    const Point a = bounding_box(straight).size(), b = bounding_box(quarter).size();
    EXPECT_NEAR(a.x(), b.y(), 1e-4);
    EXPECT_NEAR(a.y(), b.x(), 1e-4);
  }
}

TEST(Generators, ScaleWithTheRobot) {
  // Twice the size for a robot twice as large gives the same map twice as large, if every length is relative.
  for (const std::string name : {"polygon", "cave", "spiral"}) {
    Settings twice;
    const GeneratorInfo& g = built_in_maps().find(name);
    for (const std::string p : {"width", "height", "robot"})
      twice[p] = 2 * std::get<double>(find_parameter("test", g.parameters, p).fallback);
    if (name == "spiral") twice["wall"] = 0.6;
    const Region small = oxturn::generate(name, {}, 3).free, large = oxturn::generate(name, twice, 3).free;
    EXPECT_EQ(vertex_count(small), vertex_count(large)) << name;
    EXPECT_NEAR(area(large), 4 * area(small), 1e-3 * area(large)) << name;
  }
}

TEST(Generators, MakeImpassableMapsOnRequest) {
  // Doors of half a robot: valid, one polygon, but not for the robot.
  const Map map = oxturn::generate("rooms", {{"passage", 0.5}, {"door", 0.2}, {"wall", 0.1}}, 1);
  EXPECT_GT(erode(map.free, 0.2, 0.001, Bound::inside).polygons.size(), 3u);
}

TEST(Rectangle, IsARectangle) {
  const Region r = oxturn::generate("rectangle", {{"width", 4.0}, {"height", 3.0}}, 0).free;
  EXPECT_EQ(vertex_count(r), 4u);
  EXPECT_DOUBLE_EQ(area(r), 12);
}

TEST(Polygon, HasAsManyVerticesAsAskedFor) {
  for (const std::int64_t n : {3, 4, 17, 100}) {
    const Region r = oxturn::generate("polygon", {{"corners", n}}, 2).free;
    EXPECT_EQ(vertex_count(r), static_cast<std::size_t>(n));
  }
}

TEST(Polygon, IsStronglyNonConvexOnRequest) {
  // Isoperimetric quotient: 1 for a disc, 0.785 for a square.
  const Region r = oxturn::generate("polygon", {{"compactness", 0.0}, {"corners", std::int64_t{80}}}, 2).free;
  EXPECT_LT(4 * kPi * area(r) / (perimeter(r) * perimeter(r)), 0.12);
}

TEST(Clutter, ReachesItsDensity) {
  for (const double density : {0.0, 0.05, 0.25}) {
    const Region r = oxturn::generate("clutter", {{"density", density}}, 4).free;
    EXPECT_NEAR(area(r), (1 - density) * 400, 4);
  }
}

TEST(Maze, WithoutLoopsHasNoHoles) {
  for (std::uint64_t seed = 0; seed < 5; ++seed)
    EXPECT_EQ(hole_count(oxturn::generate("maze", {{"loops", 0.0}}, seed).free), 0u);
  EXPECT_GT(hole_count(oxturn::generate("maze", {{"loops", 0.5}}, 0).free), 10u);
}

TEST(Maze, ReachesEveryCell) {
  // 20 m with walls of 0.2 m and corridors of 1 m: 16 x 16 cells; sample their centres.
  const Region r = oxturn::generate("maze", {}, 8).free;
  const EdgeIndex index(r);
  const double pitch = 20.2 / 16;
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i) EXPECT_TRUE(index.contains(Point(i * pitch + 0.5, j * pitch + 0.5)));
}

TEST(Rooms, HasAllRooms) {
  // Eroding the map by a disc wider than any door leaves one component per room (without corridors).
  for (const std::int64_t n : {1, 2, 7, 16}) {
    const Region r =
        oxturn::generate("rooms", {{"rooms", n}, {"corridors", false}, {"door", 0.6}, {"width", 20.0}}, 6).free;
    EXPECT_EQ(erode(r, 0.36, 0.001, Bound::inside).polygons.size(), static_cast<std::size_t>(n));
  }
}

TEST(Rooms, LoopsAddDoors) {
  const Settings none{{"loops", 0.0}, {"rooms", std::int64_t{12}}};
  EXPECT_EQ(hole_count(oxturn::generate("rooms", none, 3).free), 0u);
  EXPECT_GT(hole_count(oxturn::generate("rooms", {{"loops", 1.0}, {"rooms", std::int64_t{12}}}, 3).free), 3u);
}

TEST(Comb, HasItsTeeth) {
  const Region r = oxturn::generate("comb", {{"aisles", std::int64_t{6}}, {"jitter", 0.0}}, 0).free;
  // The outer rectangle, and four vertices for each of the 5 walls between 6 aisles.
  EXPECT_EQ(vertex_count(r), 4u + 4u * 5u);
  EXPECT_NEAR(area(r), 20 * 1.2 + (20 - 5 * 0.6) * (12 - 1.2), 1e-3);
}

TEST(Field, HasTheHolesOfThePublishedExample) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const Polygon p = oxturn::generate("field", {}, seed).free.polygons.at(0);
    EXPECT_EQ(p.holes.size(), 15u);
    std::size_t vertices = 0;
    for (const Ring& hole : p.holes) vertices += hole.size();
    EXPECT_EQ(vertices, 71u);
  }
  const Polygon p = oxturn::generate("field", {{"ponds", std::int64_t{4}}, {"pond_corners", std::int64_t{30}}}, 1)
                        .free.polygons.at(0);
  std::size_t vertices = 0;
  for (const Ring& hole : p.holes) vertices += hole.size();
  EXPECT_EQ(p.holes.size(), 4u);
  EXPECT_EQ(vertices, 30u);
}

// 400 m x 400 m, 10^6 cells of a tool of 0.4 m. The limit is generous because of sanitizers; bench/micro/maps_bench.cpp
// measures the times.
TEST(Generators, MakeAMillionCellsInSeconds) {
  for (const GeneratorInfo& g : site_generators()) {
    SCOPED_TRACE(g.name);
    Settings settings{{"width", 400.0}, {"height", 400.0}};
    if (g.name == "rooms") settings["rooms"] = std::int64_t{3000};
    if (g.name == "polygon") settings["corners"] = std::int64_t{2000};
    if (g.name == "comb") settings["aisles"] = std::int64_t{200};
    if (g.name == "field") settings["ponds"] = std::int64_t{500};
    const auto start = std::chrono::steady_clock::now();
    const Map map = oxturn::generate(g.name, settings, 1);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_GT(area(map.free), 10000);
    EXPECT_LT(took.count(), 60);
  }
}

TEST(Polyomino, IsASimplePolygonOfTheArea) {
  for (const std::string kind : {"polyomino", "orthogonal", "octagonal"})
    for (const std::int64_t squares : {10, 50, 400}) {
      std::set<std::string> hashes;
      for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(fmt::format("{} {} {}", kind, squares, seed));
        const Settings settings{{"kind", kind}, {"squares", squares}, {"tool", 0.5}, {"margin", 2.0}};
        const Map map = oxturn::generate("polyomino", settings, seed);
        ASSERT_TRUE(map.target_area);
        EXPECT_FALSE(find_flaw(*map.target_area));
        ASSERT_EQ(map.target_area->polygons.size(), 1u);
        EXPECT_EQ(hole_count(*map.target_area), 0u);
        EXPECT_NEAR(area(*map.target_area), 0.25 * static_cast<double>(squares), 1e-3 * static_cast<double>(squares));
        const Box target = bounding_box(*map.target_area), free = bounding_box(map.free);
        EXPECT_EQ(target.low, Point(1, 1));
        EXPECT_EQ(free.high - target.high, Point(1, 1));
        hashes.insert(content_hash(map));
      }
      EXPECT_GE(hashes.size(), kSeeds - 1);  // small ones may be alike
    }
}

TEST(Polyomino, IsTheWholeMapWithoutAMargin) {
  const Map lawn = oxturn::generate("polyomino", {}, 3), mill = oxturn::generate("polyomino", {{"margin", 0.0}}, 3);
  EXPECT_FALSE(mill.target_area);
  EXPECT_NEAR(area(mill.free), area(*lawn.target_area), 1e-4);
}

TEST(HyunMap, HasFiveObstaclesThatTheRobotPasses) {
  const Region fixed = oxturn::generate("hyun", {}, 1).free;
  EXPECT_EQ(hole_count(fixed), 5u);
  EXPECT_EQ(bounding_box(fixed).size(), Point(50, 50));
  EXPECT_EQ(content_hash(oxturn::generate("hyun", {}, 1)), content_hash(oxturn::generate("hyun", {}, 2)));
  std::set<std::string> hashes;
  for (std::uint64_t seed = 0; seed < kSeeds; ++seed) {
    const Map map = oxturn::generate("hyun", {{"jitter", 1.0}}, seed);
    hashes.insert(content_hash(map));
    // Still five obstacles after erosion: nowhere narrower than the narrowest passage.
    const Region space = erode(map.free, 0.98 * 1.25 * 0.5, 0.001, Bound::inside);
    ASSERT_EQ(space.polygons.size(), 1u);
    EXPECT_EQ(hole_count(space), 5u);
  }
  EXPECT_EQ(hashes.size(), kSeeds);
  EXPECT_THROW(oxturn::generate("hyun", {{"robot", 3.0}}, 1), std::invalid_argument);
}

TEST(BergRectangle, HasItsObstacleWhereAskedFor) {
  const Settings sized{{"width", 10.0}, {"height", 8.0}, {"obstacle_width", 3.0}, {"obstacle_height", 2.0}};
  const auto obstacle = [&](double across, double up) {
    Settings all = sized;
    all["across"] = across, all["up"] = up;
    const Polygon room = oxturn::generate("berg-rectangle", all, 1).free.polygons.at(0);
    EXPECT_DOUBLE_EQ(signed_area(room.outer), 80);
    Box box;
    for (const Point& p : room.holes.at(0)) box.add(p);
    EXPECT_EQ(room.holes.at(0).size(), 4u);
    EXPECT_NEAR(box.size().x(), 3, 1e-4);
    EXPECT_NEAR(box.size().y(), 2, 1e-4);
    return box;
  };
  // A passage is 1.25 x 0.4 m.
  EXPECT_NEAR(distance(obstacle(0.5, 0.5).centre(), {5, 4}), 0, 1e-4);
  EXPECT_NEAR(distance(obstacle(0, 0).low, {0.5, 0.5}), 0, 2e-3);
  EXPECT_NEAR(distance(obstacle(1, 1).high, {9.5, 7.5}), 0, 2e-3);
}

TEST(BergRooms, HasManyLoopsUnlessToldOtherwise) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto holes = [&](double loops, std::int64_t doors) {
      return hole_count(
          oxturn::generate("berg-rooms", {{"loops", loops}, {"doors", doors}, {"branches", 0.0}}, seed).free);
    };
    // 4 x 3 rooms have 17 walls between them, of which a tree opens 11. Each further open wall makes a hole.
    EXPECT_EQ(holes(0, 1), 0u);
    EXPECT_EQ(holes(1, 1), 6u);
    EXPECT_GT(holes(1, 2), 8u);
  }
}

TEST(BergRooms, SmallRoomsAreDeadEnds) {
  // Erosion by a disc wider than any door separates the rooms: 12 large ones, and the small ones besides.
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const auto made = [&](double branches) {
      return oxturn::generate("berg-rooms",
                              {{"width", 24.0},
                               {"height", 18.0},
                               {"branches", branches},
                               {"loops", 0.5},
                               {"doors", std::int64_t{1}},
                               {"door", 0.75},
                               {"jitter", 0.0}},
                              seed)
          .free;
    };
    const Region with = made(1), none = made(0);
    const auto rooms = [](const Region& r) { return erode(r, 0.39, 0.001, Bound::inside).polygons.size(); };
    EXPECT_EQ(rooms(none), 12u);
    // Up to four in each of the 12 rooms; those not much wider than a door vanish.
    EXPECT_GT(rooms(with), 12u + 24u);
    EXPECT_LT(area(with), area(none));
  }
}

std::string refusal(const std::string& name, const Settings& settings) {
  try {
    oxturn::generate(name, settings, 1);
  } catch (const std::invalid_argument& e) { return e.what(); }
  return "accepted";
}

TEST(Generators, RefuseInOneSentence) {
  using I = std::int64_t;
  const std::vector<std::tuple<std::string, Settings, std::string>> all{
      {"room", {}, "did you mean 'rooms'"},
      {"rooms", {{"room", I{3}}}, "rooms"},
      {"rectangle", {{"height", 0.0}}, "height"},
      {"rectangle", {{"height", 0.3}}, "height is 0.3 m, expected at least 0.5"},
      {"rectangle", {{"width", std::numeric_limits<double>::quiet_NaN()}}, "width"},
      {"rectangle", {{"width", std::string("wide")}}, "width"},
      {"rooms", {{"door", 40.0}}, "do not fit"},
      {"rooms", {{"door", 0.3}}, "door is 0.3 m, expected at least 0.5"},
      {"rooms", {{"rooms", I{1000}}}, "1000 rooms"},
      {"rooms", {{"rooms", I{0}}}, "rooms"},
      {"rooms", {{"wall", 0.001}, {"width", 400.0}, {"height", 400.0}}, "wall is 0.001 m"},
      {"rooms", {{"wall", 20.0}}, "wall is 20 m"},
      {"maze", {{"corridor", 30.0}}, "corridor is 30 m"},
      {"maze", {{"corridor", 0.1}}, "corridor is 0.1 m"},
      {"maze", {{"width", 100000.0}, {"height", 100000.0}}, "4000000"},
      {"cave", {{"rock", 0.9}}, "rock 0.9"},
      {"cave", {{"grain", 15.0}}, "grain is 15 m"},
      {"cave", {{"width", 100000.0}, {"height", 100000.0}}, "10^8"},
      {"clutter", {{"density", 0.8}}, "density 0.8 cannot be reached"},
      {"clutter", {{"least", 2.0}}, "least is 2 m"},
      {"clutter", {{"least", 50.0}, {"most", 60.0}}, "lower least"},
      {"comb", {{"aisles", I{100}}}, "100 aisles"},
      {"comb", {{"corridor", 13.0}}, "corridor is 13 m"},
      {"spiral", {{"corridor", 11.0}}, "arms"},
      {"spiral", {{"arms", I{500}}}, "arms"},
      {"spiral", {{"round", true}, {"corridor", 9.0}}, "quarter rounds"},
      {"polygon", {{"corners", I{50000}}}, "50000 vertices do not fit"},
      {"polygon", {{"robot", 9.0}}, "width"},
      {"field", {{"pond_corners", I{20}}}, "pond_corners is 20"},
      {"field", {{"ponds", I{5000}}}, "ponds fit"},
      {"field", {{"width", 5.0}}, "width is 5 m"},
      {"berg-rectangle", {{"width", 0.8}}, "width is 0.8 m, expected at least 1.001 m"},
      {"berg-rectangle", {{"obstacle_width", 11.5}}, "obstacle_width is 11.5 m, expected from 0.001 m to 11 m"},
      {"berg-rooms", {{"columns", I{20}}}, "columns is 20, but only"},
      {"berg-rooms", {{"rows", I{9}}}, "rows is 9, but only"},
      {"berg-rooms", {{"door", 0.3}}, "door is 0.3 m, expected at least 0.5"},
      {"berg-rooms", {{"wall", 30.0}}, "wall is 30 m"},
      {"divided-corridor", {{"width", 1.0}}, "leave no passages of"},
      {"divided-corridor", {{"obstacles", I{100}}}, "100 obstacles on each side"},
      {"pillars", {{"spacing", 0.3}}, "spacing is 0.3 m, expected at least"},
      {"pillars", {{"width", 100000.0}, {"height", 100000.0}}, "larger spacing"},
      {"speckle", {{"cell", 0.4}}, "cell is 0.4 m, expected at least 0.5"},
      {"speckle", {{"cell", 30.0}}, "cell is 30 m"},
      {"speckle", {{"width", 100000.0}, {"height", 100000.0}}, "larger cells"},
  };
  for (const auto& [name, settings, words] : all) {
    const std::string message = refusal(name, settings);
    EXPECT_THAT(message, HasSubstr(words));
    EXPECT_EQ(message.find('\n'), std::string::npos);
    EXPECT_GT(message.size(), 25u);
  }
}

// Every setting that a description allows gives a map or an error message, never a crash or an invalid map (for which
// generate() throws std::logic_error, failing here).
TEST(Generators, AnySettingIsAMapOrASentence) {
  Rng rng(99);
  int maps = 0, sentences = 0;
  for (const GeneratorInfo& g : site_generators())
    for (int k = 0; k < 60; ++k) {
      Settings settings;
      for (const ParameterInfo& p : g.parameters) {
        if (rng.chance(0.5)) continue;
        if (std::holds_alternative<bool>(p.fallback)) {
          settings[p.name] = rng.chance(0.5);
        } else if (const auto* d = std::get_if<double>(&p.fallback)) {
          const double around = *d > 0 ? *d : 0.7;
          settings[p.name] = std::clamp(around * rng.between(0.3, 2.5), p.range.least, p.range.most);
        } else if (const auto* i = std::get_if<std::int64_t>(&p.fallback)) {
          const double around = *i > 0 ? static_cast<double>(*i) : 6;
          settings[p.name] =
              static_cast<std::int64_t>(std::clamp(around * rng.between(0.3, 2.5), p.range.least, p.range.most));
        }
      }
      SCOPED_TRACE(source_of({g.name, settings}, static_cast<std::uint64_t>(k)));
      try {
        const Map map = oxturn::generate(g.name, settings, static_cast<std::uint64_t>(k));
        ++maps;
        EXPECT_EQ(map.free.polygons.size(), 1u);
        const auto value = [&](const std::string& name) { return setting<double>({g.name, settings}, name); };
        const double radius = value("robot") * value("passage");
        EXPECT_GT(largest_share(erode(map.free, 0.97 * radius, radius / 200, Bound::inside)), 0.995);
      } catch (const std::invalid_argument& e) {
        ++sentences;
        EXPECT_THAT(std::string(e.what()), HasSubstr(g.name));
      }
    }
  EXPECT_GT(maps, 250);
  EXPECT_GT(sentences, 10);
}

}  // namespace
}  // namespace oxturn
