// The cut space, in which any order of covering is safe for the tether, and its users: leashed, berg-complete.
#include "algorithms/transit/tether_space.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "algorithms/tethered/cut_passes.hpp"
#include "coverage_oracle.hpp"
#include "maps/path_file.hpp"
#include "metrics/score.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"
#include "tether_checks.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

/// The tether always equals the geodesic; on paths into components that the cut isolates it may be a little longer.
void expect_geodesic(const Problem& problem, const Path& path) {
  const TetherFigures figures = drive_tethered(problem, path, 0.5);
  const bool one_component = TetherSpace(problem, "test").components().size() == 1;
  EXPECT_LE(figures.longest, problem.robot().tether->length + problem.tolerance());
  EXPECT_LE(figures.excess_at_work, 1e-7);
  EXPECT_LE(figures.excess, one_component ? 1e-7 : 6.1 * problem.robot().radius);
  EXPECT_EQ(figures.crossings, 0);
  const Score result = score(problem, path);
  EXPECT_EQ(result.flaw, "");
}

// --------------------------------------------------------------------------------------------------- the cut

TEST(TetherSpace, ComponentsHaveNoHolesAndLoseOnlyTheCut) {
  for (const auto seed : seeds(3))
    for (const Map& map : tether_maps(seed)) {
      SCOPED_TRACE(map.source);
      const Problem problem(map, tethered_robot(1.1));
      const TetherSpace space(problem, "test");
      double lost = area(problem.configuration_space()) - area(space.unreached());
      for (const TetherSpace::Component& component : space.components()) {
        EXPECT_EQ(hole_count(component.problem.configuration_space()), 0u);
        EXPECT_EQ(component.problem.configuration_space().polygons.size(), 1u);
        lost -= area(component.problem.configuration_space());
      }
      double cut = 0;
      for (const Polyline& line : space.cut()) cut += length(line);
      EXPECT_GE(lost, -1e-6);
      EXPECT_LE(lost, (cut + 1) * space.cut_width() * 1.2);
      EXPECT_LE(area(space.unreached()), 0.001 * area(problem.configuration_space()));
    }
}

// Regression: on a map of kilometres, cutting space open moved vertices of its coarse arcs by more than the width of
// what counts as a corner; a path past such a corner was then on its wrong side, and pulled taut it led through a wall.
TEST(TetherSpace, CoarseSpaceKeepsItsVerticesWhenItIsCutOpen) {
  constexpr double kLarger = 300;
  std::size_t kept = 0;
  for (Map map : tether_maps(1)) {
    SCOPED_TRACE(map.source);
    for (Polygon& polygon : map.free.polygons) {
      for (Point& p : polygon.outer) p *= kLarger;
      for (Ring& hole : polygon.holes)
        for (Point& p : hole) p *= kLarger;
    }
    const Problem problem(map, tethered_robot(1.1, 0.2 * kLarger, 0.4 * kLarger));
    const Problem coarse = with_coarser_space(problem);
    EXPECT_LE(vertex_count(coarse.configuration_space()), vertex_count(problem.configuration_space()));
    EXPECT_TRUE(coarse.walls().contains(problem.start()));
    std::vector<Point> vertices;
    for_each_edge(coarse.configuration_space(), [&](const Point& a, const Point&) { vertices.push_back(a); });
    std::ranges::sort(vertices, before);
    const TetherSpace space(coarse, "test");
    for (const TetherSpace::Component& component : space.components())
      for_each_edge(component.problem.configuration_space(), [&](const Point& a, const Point&) {
        const auto vertex = coarse.walls().nearest(a, 1e-3);
        if (!vertex) return;
        const EdgeIndex::Edge& edge = coarse.walls().edges()[vertex->edge];
        for (const Point& end : {edge.a, edge.b})
          if (distance(a, end) < 1e-3) {
            EXPECT_TRUE(std::ranges::binary_search(vertices, a, before)) << distance(a, end);
            ++kept;
          }
      });
  }
  EXPECT_GT(kept, 100u);
}

// Regression: the cut came in pieces, a few for each triangle of a mesh, whose strips left steps of nanometres to
// micrometres where they meet; laps and offsets turned about the corners of each.
TEST(TetherSpace, TheCutLeavesNoSteps) {
  for (const auto seed : seeds(3)) {
    std::vector<Map> maps = tether_maps(seed);
    maps.push_back(generate("speckle", {{"width", 14.0}, {"height", 14.0}}, seed));
    for (const Map& map : maps) {
      SCOPED_TRACE(map.source);
      const Problem problem(map, tethered_robot(1.1));
      const TetherSpace space(problem, "test");
      const auto short_edges = [&](const Region& region) {
        std::size_t count = 0;
        for_each_edge(region,
                      [&](const Point& a, const Point& b) { count += distance(a, b) < 1e-2 * space.cut_width(); });
        return count;
      };
      const Region& whole = problem.configuration_space();
      std::size_t pieces = 0, ends = 0, steps = 0, vertices = 0;
      for (const Polyline& line : space.cut()) pieces += line.size(), ends += 2;
      for (const TetherSpace::Component& component : space.components()) {
        steps += short_edges(component.problem.configuration_space());
        vertices += vertex_count(component.problem.configuration_space());
      }
      // Walls that the cut meets at a small angle may have one; walls alone have some, too.
      EXPECT_LE(steps, short_edges(whole) + ends);
      EXPECT_LE(vertices, vertex_count(whole) + 2 * pieces + 4 * ends);
    }
  }
}

// Among many obstacles there are components behind components. All are entered along their geodesics; a search over
// the classes of the whole map gave up on some.
TEST(TetherSpace, EveryComponentOfALargeClutterIsEntered) {
  const Problem problem(generate("clutter", {{"width", 51.0}, {"height", 51.0}}, 1), tethered_robot(2));
  const TetherSpace space(problem, "test");
  EXPECT_GE(space.components().size(), 10u);
  EXPECT_LE(area(space.unreached()), 1e-4 * area(problem.configuration_space()));
  for (const TetherSpace::Component& component : space.components()) {
    Path path;
    path.legs.push_back({false, component.entry_path});
    if (component.entry_path.size() < 2) continue;
    const TetherFigures figures = drive_tethered(problem, path, 0.5);
    EXPECT_LE(figures.excess, 6.1 * problem.robot().radius);
  }
}

TEST(TetherSpace, ComponentsBehindComponentsAreEnteredByShortPaths) {
  const Problem problem(generate("speckle", {{"width", 40.0}, {"height", 40.0}}, 1), tethered_robot(1.2));
  const TetherSpace space(problem, "test");
  EXPECT_GE(space.components().size(), 100u);
  double driven = 0, least = 0;
  for (const TetherSpace::Component& component : space.components()) {
    driven += length(component.entry_path);
    least += length(*problem.transit().path(problem.start(), component.problem.start()));
    EXPECT_EQ(space.component_at(component.problem.start()), &component);
  }
  EXPECT_LE(driven, 1.01 * least);
}

// A component is found when a path asks for it, with those on the way there; that must not depend on what was asked
// before.
TEST(TetherSpace, PathsOutAreTheSameInAnyOrder) {
  const Problem problem(generate("speckle", {{"width", 12.0}, {"height", 12.0}}, 1), tethered_robot(1.2));
  const TetherSpace all(problem, "test");
  ASSERT_GE(all.components().size(), 5u);
  const TetherSpace backwards(problem, "test");
  for (std::size_t k = all.components().size(); k-- > 0;) {
    const Problem& component = all.components()[k].problem;
    const Ring& ring = component.configuration_space().polygons[0].outer;
    for (const Point& p : {component.start(), ring[ring.size() / 2]}) {
      const auto path = all.world().path_out(p);
      ASSERT_TRUE(path);
      EXPECT_EQ(TetherSpace(problem, "test").world().path_out(p), path);
      EXPECT_EQ(backwards.world().path_out(p), path);
    }
  }
  EXPECT_EQ(backwards.components().size(), all.components().size());
}

TEST(TetherSpace, PointsOfNoComponent) {
  const Problem problem(generate("clutter", {{"width", 20.0}, {"height", 20.0}}, 1), tethered_robot(0.4));
  const TetherSpace space(problem, "test");
  EXPECT_EQ(space.component_at({-5, -5}), nullptr);
  for (const Polygon& polygon : space.unreached().polygons)
    EXPECT_EQ(space.component_at(polygon.outer.front()), nullptr);
  const Polyline& line = space.cut().front();
  EXPECT_EQ(space.component_at(lerp(line[0], line[1], 0.5)), nullptr);
}

TEST(TetherSpace, RandomPathsInTheCutSpaceKeepTheTetherGeodesic) {
  for (const auto seed : seeds(4))
    for (const Map& map : tether_maps(seed)) {
      SCOPED_TRACE(map.source);
      const Problem problem(map, tethered_robot(0.8));
      const TetherSpace space(problem, "test");
      Rng rng(seed);
      const Box box = bounding_box(space.cut_space());
      PathBuilder path(problem.start());
      for (int n = 0; n < 40;) {
        const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
        if (!contains(space.cut_space(), p)) continue;
        ++n;
        const auto leg = space.cut_problem().transit().path(path.at(), p);
        ASSERT_TRUE(leg);
        path.drive(*leg, true);
      }
      expect_geodesic(problem, path.take());
    }
}

TEST(TetherSpace, ARobotWithoutTetherIsOneSentence) {
  const Problem problem(generate("rectangle", {}, 1), Robot{});
  for (const char* name : {"leashed", "berg-complete"}) {
    Context context;
    try {
      built_in_planner(name)->plan(problem, context);
      FAIL() << name;
    } catch (const Unsupported& e) { EXPECT_THAT(e.what(), HasSubstr("needs a robot with a tether")); }
  }
}

// --------------------------------------------------------------------------------------------------- leashed

TEST(Leashed, AnyPlannerStaysGeodesicAndComesHome) {
  for (const auto seed : seeds(2))
    for (const Map& map : tether_maps(seed))
      for (const double reach : {0.5, 1.2})
        for (const char* inner : {"boustrophedon", "zigzag", "stc"}) {
          SCOPED_TRACE(fmt::format("{} reach {} {}", map.source, reach, inner));
          const Problem problem(map, tethered_robot(reach));
          Path path;
          try {
            path = plan("leashed", problem, {{"planner", std::string(inner)}, {"cut", std::string("geodesic")}});
          } catch (const Infeasible&) {
            EXPECT_EQ(std::string(inner), "stc");  // no coarse cell fits
            continue;
          }
          expect_geodesic(problem, path);
          EXPECT_LE(distance(path.legs.back().points.back(), problem.start()), 1e-9);
        }
}

double metres(const std::vector<Polyline>& lines) {
  double sum = 0;
  for (const Polyline& line : lines) sum += length(line);
  return sum;
}

// A pillar a metre from a wall, the rest of the room behind it: the cut locus is metres long, the bridge one.
TEST(BridgeCut, IsTheGapBesideAPillarIfTheTetherIsLongEnough) {
  const Region free{{{{{0, 0}, {12, 0}, {12, 9}, {0, 9}}, {{{5, 1}, {5, 2}, {6, 2}, {6, 1}}}}}};
  Map map;
  map.name = "pillar";
  map.free = free;
  for (const double reach : {1.0, 1.5}) {
    const Problem problem(map, tethered_robot(reach), Point(1, 1.5), Point(1, 1.5));
    const double geodesic = metres(TetherSpace(problem, "test").cut());
    const double least = metres(TetherSpace(problem, "test", TetherCut::least).cut());
    EXPECT_GT(geodesic, 5);
    if (reach > 1)
      EXPECT_NEAR(least, 1, 0.1);
    else
      EXPECT_LE(least, geodesic);  // points beside the pillar may need the way around it
    const Path path = plan("leashed", problem);
    const TetherFigures figures = drive_tethered(problem, path, 0.5);
    EXPECT_LE(figures.longest, problem.robot().tether->length + problem.tolerance());
    EXPECT_EQ(figures.crossings, 0);
  }
}

// Regression: of each run of vertices that the tether did not reach, one only was mended in a round, and its neighbour
// was in the next: the rounds ended without a cut.
TEST(BridgeCut, IsFoundThoughTheTetherIsHardlyLongerThanTheFarthestPointNeeds) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const Problem problem(generate("clutter", {}, seed), tethered_robot(1.1));
    found +=
        metres(TetherSpace(problem, "test", TetherCut::least).cut()) < 0.7 * metres(TetherSpace(problem, "test").cut())
            ? 1
            : 0;
  }
  EXPECT_GE(found, 7);
}

// Regression: among many obstacles some bridges have to cross paths that were asked for, and in each round these were
// the paths to the same few points.
TEST(BridgeCut, IsFoundAmongManyObstacles) {
  const Problem problem(generate("clutter", {{"width", 89.4}, {"height", 89.4}}, 1), tethered_robot(1.2));
  EXPECT_LT(metres(TetherSpace(problem, "test", TetherCut::least).cut()),
            0.7 * metres(TetherSpace(problem, "test").cut()));
}

// Whatever the map, the anchor, the tool and the length of the tether.
TEST(BridgeCut, TheTetherSufficesAndIsNeverDrivenOver) {
  int shorter = 0;
  for (const auto seed : seeds(2)) {
    std::vector<Map> maps = tether_maps(seed);
    for (const char* generator : {"speckle", "clutter", "cave", "maze"})
      maps.push_back(generate(generator, {{"width", 14.0}, {"height", 11.0}}, seed));
    for (const Map& map : maps)
      for (const double reach : {1.02, 1.2, 3.0}) {
        SCOPED_TRACE(fmt::format("{} reach {}", map.source, reach));
        const Problem problem(map, tethered_robot(reach));
        const Path path = plan("leashed", problem);
        const TetherFigures figures = drive_tethered(problem, path, 0.5);
        EXPECT_LE(figures.longest, problem.robot().tether->length + problem.tolerance());
        EXPECT_EQ(figures.crossings, 0);
        const Score result = score(problem, path);
        EXPECT_EQ(result.flaw, "");
        EXPECT_GE(result.value("coverage").value_or(0), 0.999);
        shorter += metres(TetherSpace(problem, "test", TetherCut::least).cut()) + 0.1 <
                           metres(TetherSpace(problem, "test").cut())
                       ? 1
                       : 0;
      }
  }
  EXPECT_GE(shorter, 12);
}

TEST(Leashed, TakesThePlannersOwnParameters) {
  const Problem problem(generate("clutter", {{"width", 8.0}, {"height", 6.0}}, 1), tethered_robot(1.1));
  const Path slab = plan("leashed", problem), exact = plan("leashed", problem, {{"cells", std::string("exact")}});
  EXPECT_NE(slab.length(), exact.length());
  EXPECT_THAT(
      [&] {
        plan("leashed", problem, {{"tree", std::string("bfs")}});
      },
      testing::ThrowsMessage<std::invalid_argument>(HasSubstr("unknown parameter 'tree' of planner 'leashed'")));
  EXPECT_NO_THROW(plan("leashed", problem, {{"planner", std::string("stc")}, {"tree", std::string("dfs")}}));
  EXPECT_THAT(
      [&] {
        plan("leashed", problem, {{"planner", std::string("leashed")}});
      },
      testing::ThrowsMessage<std::invalid_argument>(HasSubstr("handles the tether itself")));
  EXPECT_THAT(
      [&] {
        plan("leashed", problem, {{"planner", std::string("zigzac")}});
      },
      testing::ThrowsMessage<std::invalid_argument>(HasSubstr("did you mean 'zigzag'")));
}

/// Metres driven, tool on, nearer than `within` to the lines.
double driven_along(const std::vector<Polyline>& lines, const Path& path, double within) {
  double sum = 0;
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; leg.tool && i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      const double n = std::max(1.0, std::ceil(distance(a, b) / (within / 4)));
      for (double k = 0.5; k < n; ++k)
        if (std::ranges::any_of(lines, [&](const Polyline& line) {
              for (std::size_t j = 1; j < line.size(); ++j)
                if (distance_to_segment(lerp(a, b, k / n), line[j - 1], line[j]) < within) return true;
              return false;
            }))
          sum += distance(a, b) / n;
    }
  return sum;
}

// A planner that drives along walls drove along both sides of the cut itself, and covered one strip twice.
TEST(Leashed, PassesAlongTheCutLieAToolWidthApart) {
  const Region free{{{{{0, 0}, {12, 0}, {12, 9}, {0, 9}}, {{{4, 4}, {4, 5}, {5, 5}, {5, 4}}}}}};
  const Problem problem({"pillar", free, "file", "pillar"}, tethered_robot(1.1),
                        Point(1, 4.5));  // the cut leads from the pillar to the right: 6.6 m
  const double w = problem.robot().tool_width;
  for (const char* inner : {"boustrophedon", "contour", "oarp"}) {
    const Path path = plan("leashed", problem, {{"planner", std::string(inner)}, {"cut", std::string("geodesic")}});
    EXPECT_LE(driven_along(TetherSpace(problem, "test").cut(), path, w / 4), 4 * w) << inner;
    EXPECT_GE(score(problem, path).value("coverage").value_or(0), 0.9999) << inner;
  }
}

TEST(Leashed, ThePassesAndTheirPocketsMissNothing) {
  int pockets = 0;
  for (const auto seed : seeds(3)) {
    std::vector<Map> maps = tether_maps(seed);
    maps.push_back(generate("speckle", {{"width", 30.0}, {"height", 30.0}}, seed));
    for (const Map& map : maps)
      for (const double w : {0.2, 0.4, 1.5}) {
        SCOPED_TRACE(fmt::format("{} tool {}", map.source, w));
        const Problem problem(map, tethered_robot(1.1, 0.2, w));
        const TetherSpace tether(problem, "test");
        for (const TetherSpace::Component& component : tether.components()) {
          const PassSpace passes = CutPasses(problem, tether.cut()).beside(component.problem);
          ASSERT_EQ(passes.problem.configuration_space().polygons.size(), 1u);
          const EdgeIndex space(passes.problem.configuration_space()), whole(component.problem.configuration_space());
          EXPECT_TRUE(space.contains(component.problem.start()) ||
                      space.nearest(component.problem.start(), problem.tolerance()));
          const EdgeIndex missed(passes.pockets), all(problem.configuration_space()), target(problem.target());
          // In the component, or where the tool reaches beyond its walls.
          const auto is_for_passes = [&](const Point& p) {
            if (whole.contains(p)) return true;
            if (all.contains(p) || !target.contains(p)) return false;
            const auto here = whole.nearest(p, 0.49 * w), anywhere = all.nearest(p);
            return here && here->distance <= anywhere->distance + problem.tolerance();
          };
          pockets += static_cast<int>(passes.pockets.polygons.size());
          Box box = bounding_box(component.problem.configuration_space());
          box.grow(w / 2);
          Rng rng(seed);
          const auto in_box = [&] {
            return Point(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
          };
          const auto by_cut = [&]() -> Point {  // most of what passes may miss is there
            const Polyline& line = tether.cut()[rng.below(tether.cut().size())];
            const std::size_t s = rng.below(line.size() - 1);
            return lerp(line[s], line[s + 1], rng.unit()) + w * Point(rng.unit() - 0.5, rng.unit() - 0.5);
          };
          for (int k = 0; k < 4000; ++k) {
            const Point p = k % 4 == 0 || tether.cut().empty() ? in_box() : by_cut();
            if (!is_for_passes(p) || space.contains(p) || space.nearest(p, 0.502 * w)) continue;
            EXPECT_TRUE(!passes.pockets.empty() && missed.contains(p)) << p.x() << ' ' << p.y();
          }
        }
      }
  }
  EXPECT_GT(pockets, 0);
}

// --------------------------------------------------------------------------------------------- berg-complete

TEST(BergComplete, CoversWhatTheTetherReachesAndStaysGeodesic) {
  for (const auto seed : seeds(2))
    for (const Map& map : tether_maps(seed))
      for (const double reach : {0.6, 1.2}) {
        SCOPED_TRACE(fmt::format("{} reach {}", map.source, reach));
        const Problem problem(map, tethered_robot(reach));
        const Path path = plan("berg-complete", problem);
        expect_geodesic(problem, path);
        EXPECT_GE(score(problem, path).value("coverage_upper").value_or(0), 0.995);
      }
}

// Regression: level sets ended up to an eighth of the tool's width before a cut that is not driven, and lanes along the
// tether kept off it besides: 0.9975 in a maze of 176 pillars.
TEST(BergComplete, LanesBesideACutThatIsNotDrivenLeaveNoStrip) {
  for (const auto seed : seeds(2)) {
    const Map maze = oxturn::generate(
        "maze", {{"width", 9.0}, {"height", 7.0}, {"corridor", 1.14}, {"loops", 0.98}, {"robot", 0.133}}, seed);
    const Problem problem(maze, tethered_robot(1.4, 0.133, 0.19));
    const Path path = plan("berg-complete", problem, {{"laps", 0}});
    expect_geodesic(problem, path);
    EXPECT_GE(score(problem, path).value("coverage_lower").value_or(0), 0.9995);
  }
}

// Along corridors laps are shorter and turn less; where they are not chosen, the path is that of the level sets.
TEST(BergComplete, LapsAreDrivenWhereTheyAreBetter) {
  const Problem spiral(oxturn::generate("spiral", {{"width", 10.0}, {"height", 7.0}}, 1), tethered_robot(1.1),
                       Point(6.3373, 0.4));
  const Path with = plan("berg-complete", spiral), without = plan("berg-complete", spiral, {{"laps", 0}});
  expect_geodesic(spiral, with);
  EXPECT_GE(score(spiral, with).value("coverage_lower").value_or(0), 0.9995);
  EXPECT_LT(with.length(), 0.9 * without.length());
  EXPECT_LT(score(spiral, with).value("turns").value_or(0), score(spiral, without).value("turns").value_or(0));

  const Problem clutter(oxturn::generate("clutter", {{"width", 10.0}, {"height", 7.0}}, 3), tethered_robot(1.1));
  double least = std::numeric_limits<double>::infinity();
  for (const char* objective : {"time", "both", "length"}) {  // the last one is the shortest
    const Path path = plan("berg-complete", clutter, {{"objective", std::string(objective)}});
    expect_geodesic(clutter, path);
    EXPECT_GE(score(clutter, path).value("coverage_lower").value_or(0), 0.9995);
    EXPECT_LE(path.length(), least + 1e-9);
    least = path.length();
  }
}

// Level sets take time for the whole map. In aisles and where obstacles lie densely laps are shorter and quicker, and
// nothing else is planned; with many components a few slivers among them change nothing.
TEST(BergComplete, OnlyLapsArePlannedWhereWallsLieDensely) {
  const Map comb = oxturn::generate("comb", {}, 1), open = oxturn::generate("rectangle", {{"width", 12.0}}, 1),
            speckle = oxturn::generate("speckle", {{"width", 46.0}, {"height", 46.0}}, 1);
  const Problem in_open(open, tethered_robot(1.1));
  EXPECT_TRUE(plan_recorded("berg-complete", in_open).traces.contains("level sets"));
  for (const Map* map : {&comb, &speckle}) {
    SCOPED_TRACE(map->source);
    const Problem problem(*map, tethered_robot(1.1));
    const RecordedPlan laps = plan_recorded("berg-complete", problem),
                       sets = plan_recorded("berg-complete", problem, {{"laps", std::int64_t{0}}});
    EXPECT_FALSE(laps.traces.contains("level sets"));
    EXPECT_TRUE(sets.traces.contains("level sets"));
    expect_geodesic(problem, laps.path);
    EXPECT_GE(score(problem, laps.path).value("coverage_lower").value_or(0), 0.9995);
    EXPECT_LT(laps.path.length(), 0.95 * sets.path.length());
  }
}

TEST(BergComplete, EveryOrderAndWindingCoversTheSame) {
  for (const char* name : {"clutter", "field"}) {
    const Problem problem(oxturn::generate(name, {{"width", 10.0}, {"height", 7.0}}, 3), tethered_robot(1.1));
    for (const char* order : {"tour", "dfs", "bfs"})
      for (const char* winding : {"any", "left", "right"}) {
        SCOPED_TRACE(fmt::format("{} {} {}", name, order, winding));
        const Path path =
            plan("berg-complete", problem, {{"order", std::string(order)}, {"winding", std::string(winding)}});
        expect_geodesic(problem, path);
        EXPECT_GE(score(problem, path).value("coverage_upper").value_or(0), 0.995);
      }
  }
}

// In an empty round room level sets are circles: the tether stays on the side asked for on all of them.
TEST(BergComplete, WindingKeepsTheTetherOnOneSide) {
  Ring wall;
  for (int k = 0; k < 200; ++k) wall.push_back(4 * Point(std::cos(k * kPi / 100), std::sin(k * kPi / 100)));
  const Problem problem(Map{"disc", Region{{{wall, {}}}}, "", ""}, tethered_robot(1.1), Point(0, 0));
  for (const char* winding : {"left", "right"}) {
    const Path path = plan("berg-complete", problem, {{"winding", std::string(winding)}});
    double wrong = 0, right = 0;
    for (const Leg& leg : path.legs)
      for (std::size_t i = 1; leg.tool && i < leg.points.size(); ++i) {
        const Point &a = leg.points[i - 1], &b = leg.points[i];
        const double turn = cross(a, b) * (std::string(winding) == "left" ? 1 : -1);
        (turn > 0 ? right : wrong) += std::abs(cross(a, b)) > 1e-6 ? distance(a, b) : 0;
      }
    EXPECT_GT(right, 90);  // about pi 3.8^2 / 0.4 metres
    EXPECT_LT(wrong, 0.02 * right) << winding;
  }
}

/// Share of the path with a heading nearer than `angle` to the pull of a taut tether driven along.
double share_near_pull(const Problem& problem, const Path& path, double angle) {
  TautTether tether(problem.tether()->taut_space(), problem.anchor());
  tether.drive(problem.tether()->geodesics().path(problem.start()));
  double sum = 0;
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point heading = (leg.points[i] - leg.points[i - 1]) * (leg.gear == Gear::forward ? 1 : -1);
      tether.drive(leg.points[i], [&](const TautTether::Swing& swing) {
        const Point pull = swing.pivot - (swing.from + swing.to) / 2;
        if (heading.dot(pull) > std::cos(angle) * heading.norm() * pull.norm()) sum += distance(swing.from, swing.to);
      });
    }
  return sum / path.length();
}

TEST(BergComplete, TackingKeepsTheHeadingFromThePullAndCoversTheSame) {
  for (const char* name : {"cave", "polygon", "rooms"}) {
    SCOPED_TRACE(name);
    const Problem problem(oxturn::generate(name, {{"width", 10.0}, {"height", 8.0}}, 2), tethered_robot(1.1));
    // Level sets both: laps, which keep no angle, may be a quarter shorter.
    const Path free = plan("berg-complete", problem, {{"laps", std::int64_t{0}}}),
               kept = plan("berg-complete", problem, {{"min_tether_angle", 0.8}});
    expect_geodesic(problem, kept);
    EXPECT_GE(score(problem, kept).value("coverage_lower").value_or(0), 0.999);
    EXPECT_LT(share_near_pull(problem, kept, 0.78), 0.3 * share_near_pull(problem, free, 0.78));
    EXPECT_LT(kept.length(), 2 * free.length());
  }
}

// Each component of the cut space by itself.
TEST(BergComplete, TackingWhereTheCutIsolatesComponents) {
  for (const auto& [name, seed] : {std::pair("cave", 1), {"cave", 3}, {"clutter", 1}, {"clutter", 2}}) {
    SCOPED_TRACE(fmt::format("{}:{}", name, seed));
    const Problem problem(oxturn::generate(name, {}, seed), tethered_robot(1.1));
    EXPECT_GE(TetherSpace(problem, "test").components().size(), 2u);
    const Path path = plan("berg-complete", problem, {{"min_tether_angle", 0.8}});
    const Score result = score(problem, path);
    EXPECT_EQ(result.flaw, "");
    EXPECT_GE(result.value("coverage_lower").value_or(0), 0.999);
  }
}

// The same points in the same order; the rules hold everywhere, transit included.
TEST(BergComplete, ReverseFulfilsTheRulesWithoutADetour) {
  for (const auto seed : seeds(2))
    for (const Map& map : tether_maps(seed)) {
      SCOPED_TRACE(map.source);
      const Problem problem(map, tethered_robot(1.1));
      const Path free = plan("berg-complete", problem);
      const Path kept = plan("berg-complete", problem, {{"min_tether_angle", 1.2}, {"reverse", true}});
      EXPECT_NEAR(kept.length(), free.length(), 1e-9 * free.length());
      EXPECT_NEAR(kept.length(true), free.length(true), 1e-9 * free.length());
      EXPECT_LT(share_near_pull(problem, kept, 1.2 - 1e-6), 1e-6);
      EXPECT_GT(share_near_pull(problem, free, 1.2), 0.05);
      EXPECT_EQ(score(problem, kept).flaw, "");
    }
}

TEST(BergComplete, ReverseKeepsTheTetherOnOneSide) {
  for (const char* name : {"rooms", "clutter"})
    for (const double sign : {1.0, -1.0}) {
      const Problem problem(oxturn::generate(name, {{"width", 10.0}, {"height", 8.0}}, 2), tethered_robot(1.1));
      const Path path =
          plan("berg-complete", problem, {{"winding", std::string(sign > 0 ? "left" : "right")}, {"reverse", true}});
      EXPECT_NEAR(path.length(), plan("berg-complete", problem).length(), 1e-9 * path.length());
      TautTether tether(problem.tether()->taut_space(), problem.anchor());
      tether.drive(problem.tether()->geodesics().path(problem.start()));
      double wrong = 0;
      for (const Leg& leg : path.legs)
        for (std::size_t i = 1; i < leg.points.size(); ++i) {
          const Point heading = (leg.points[i] - leg.points[i - 1]) * (leg.gear == Gear::forward ? 1 : -1);
          tether.drive(leg.points[i], [&](const TautTether::Swing& swing) {
            const Point pull = swing.pivot - (swing.from + swing.to) / 2;
            if (sign * cross(heading.normalized(), pull) < -0.03 * pull.norm()) wrong += distance(swing.from, swing.to);
          });
        }
      EXPECT_LT(wrong, 1e-3 * path.length()) << name;
    }
}

// The map by lidar only.
TEST(BergComplete, CoversByLidar) {
  for (const char* name : {"rectangle", "clutter"}) {
    SCOPED_TRACE(name);
    Robot robot = tethered_robot(1.2);
    robot.lidar = Lidar{6, 180};
    const Problem problem(oxturn::generate(name, {{"width", 4.0}, {"height", 3.5}}, 2), robot);
    const Path path = plan("berg-complete", problem, {{"sensing", std::string("lidar")}});
    const TetherFigures figures = drive_tethered(problem, path, 0.5);
    EXPECT_LE(figures.longest, problem.robot().tether->length + problem.tolerance());
    const Score result = score(problem, path);
    EXPECT_EQ(result.flaw, "");
    EXPECT_GE(result.value("coverage_upper").value_or(0), 0.99);
    EXPECT_LE(path.length(), 2 * plan("berg-complete", problem).length());
  }
}

// A vertex next to another one stays only where the straight segment past it is not free, as at the ends of the cut.
TEST(BergComplete, FewSegmentsAreShorterThanAHundredthOfTheRobot) {
  for (const char* name : {"cave", "rooms"}) {
    const Problem problem(generate(name, {}, 2), tethered_robot(1.1));
    std::size_t all = 0, tiny = 0;
    for (const Leg& leg : plan("berg-complete", problem).legs)
      for (std::size_t i = 1; i < leg.points.size(); ++i, ++all)
        tiny += distance(leg.points[i - 1], leg.points[i]) < 0.99 * problem.robot().radius / 100;
    EXPECT_LT(static_cast<double>(tiny), 0.01 * static_cast<double>(all)) << name;
  }
}

TEST(BergComplete, SameBytesTwice) {
  const Problem problem(generate("rooms", {}, 5), tethered_robot(0.9));
  EXPECT_EQ(to_geojson(plan("berg-complete", problem)), to_geojson(plan("berg-complete", problem)));
}

}  // namespace
}  // namespace oxturn
