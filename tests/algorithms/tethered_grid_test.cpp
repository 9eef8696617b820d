// Tethered grid planners: shnaps-rimon, shnaps-rimon-banded, tether-tree, tethered-stc.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algorithms/transit/tether_space.hpp"
#include "coverage_oracle.hpp"
#include "maps/path_file.hpp"
#include "metrics/score.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"
#include "tether_checks.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using Cell = std::pair<int, int>;

const double kSide = 0.4 / std::sqrt(2.0);

/// Cells about the start by definition, each with its depth: centres `side` apart, neighbours if the segment between
/// the centres lies in `space`.
std::map<Cell, int> flood(const Region& space, const Point& start, double side) {
  const EdgeIndex walls(space);
  std::map<Cell, int> depth{{{0, 0}, 0}};
  std::vector<Cell> queue{{0, 0}};
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (const Cell& step : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}}) {
      const auto [i, j] = queue[k];
      const Cell to{i + step.first, j + step.second};
      if (depth.count(to) > 0) continue;
      if (!walls.contains(start + side * Point(i, j), start + side * Point(to.first, to.second))) continue;
      depth[to] = depth[queue[k]] + 1;
      queue.push_back(to);
    }
  return depth;
}

/// The cells whose centres the tool-on path drives over.
std::set<Cell> cells_driven(const Path& path, const Point& start, double side) {
  std::set<Cell> cells;
  const auto visit = [&](const Point& a, const Point& b) {
    const Point from = (a - start) / side, to = (b - start) / side;
    for (int i = static_cast<int>(std::floor(std::min(from.x(), to.x()))); i <= std::ceil(std::max(from.x(), to.x()));
         ++i)
      for (int j = static_cast<int>(std::floor(std::min(from.y(), to.y()))); j <= std::ceil(std::max(from.y(), to.y()));
           ++j)
        if (distance_to_segment({i, j}, from, to) < 1e-9) cells.insert({i, j});
  };
  for (const Leg& leg : path.legs)
    for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k) visit(leg.points[k - 1], leg.points[k]);
  return cells;
}

Path expect_sound(const std::string& planner, const Problem& problem, const Settings& settings = {}) {
  Path path;
  try {
    path = plan(planner, problem, settings);
  } catch (const Infeasible&) { return path; }
  const Score result = score(problem, path);
  EXPECT_EQ(result.flaw, "");
  const TetherFigures figures = drive_tethered(problem, path, 0.5);
  EXPECT_LE(figures.longest, problem.robot().tether->length + problem.tolerance());
  return path;
}

// ----------------------------------------------------------------------------------------------- shnaps-rimon

/// Where the robot must have been: at the centres of the flood's cells; with `any`, for every other cell of the lattice
/// at the point of `space` nearest to its centre, if that lies in the cell. By a scan of all edges.
std::vector<Point> points_wanted(const Region& space, const Point& start, double side, bool any) {
  const std::map<Cell, int> joined = flood(space, start, side);
  std::vector<Point> points;
  for (const auto& [cell, depth] : joined) points.push_back(start + side * Point(cell.first, cell.second));
  const Box box = bounding_box(space);
  const auto index = [&](double from, double to, bool up) {
    return static_cast<int>(up ? std::ceil((to - from) / side) : std::floor((to - from) / side));
  };
  for (int i = index(start.x(), box.low.x(), false); any && i <= index(start.x(), box.high.x(), true); ++i)
    for (int j = index(start.y(), box.low.y(), false); j <= index(start.y(), box.high.y(), true); ++j) {
      if (joined.count({i, j}) > 0) continue;
      const Point centre = start + side * Point(i, j);
      Point nearest = centre;
      double least = contains(space, centre) ? 0 : 1e300;
      for_each_ring(space, [&](const Ring& ring) {
        for (std::size_t k = 0; k < ring.size(); ++k) {
          const Point candidate = nearest_on_segment(centre, ring[k], ring[(k + 1) % ring.size()]);
          if (distance(candidate, centre) >= least) continue;
          least = distance(candidate, centre);
          nearest = candidate;
        }
      });
      // A little less than the cell: at its border rounding decides.
      if ((nearest - centre).cwiseAbs().maxCoeff() < side * (0.5 - 1e-9)) points.push_back(nearest);
    }
  return points;
}

double distance_to(const Path& path, const Point& p) {
  double least = 1e300;
  for (const Leg& leg : path.legs)
    for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k)
      least = std::min(least, distance_to_segment(p, leg.points[k - 1], leg.points[k]));
  return least;
}

void expect_every_cell(const std::string& planner, const Problem& problem, const Settings& settings, double side,
                       bool any = true) {
  SCOPED_TRACE(planner);
  Settings all = settings;
  all["cell_size"] = side;
  all["cells"] = std::string(any ? "any" : "joined");
  const Path path = expect_sound(planner, problem, all);
  const std::vector<Point> points = points_wanted(problem.configuration_space(), problem.start(), side, any);
  if (path.legs.empty()) {
    EXPECT_EQ(points.size(), 1u);
    return;
  }
  for (const Point& point : points) EXPECT_LT(distance_to(path, point), 1e-9) << "misses " << point.transpose();
  EXPECT_LE(path.length(), 2 * problem.robot().tether->length * static_cast<double>(points.size()));
  EXPECT_EQ(path.legs.back().points.back(), problem.start());
  // At the end the tether is as it was at the start.
  TautTether tether(problem.tether()->taut_space(), problem.anchor());
  tether.drive(problem.tether()->geodesics().path(problem.start()));
  for (const Leg& leg : path.legs) tether.drive(leg.points);
  EXPECT_NEAR(tether.length(), problem.tether()->geodesics().distance(problem.start()), 1e-9);
}

TEST(ShnapsRimon, VisitsEveryCellWithinTheLengthBoundAndTheTether) {
  std::uint64_t n = 0;
  for (const auto seed : seeds(2))
    for (const Map& map : tether_maps(seed))
      for (const double reach : {0.5, 0.8, 1.3, 2.0}) {
        SCOPED_TRACE(fmt::format("{} reach {}", map.source, reach));
        const Problem problem(map, tethered_robot(reach));
        const std::string retraction = n % 2 == 0 ? "automatic" : "untangle";
        switch (n++ % 4) {
          case 0:
            expect_every_cell("shnaps-rimon", problem, {{"order", std::string("split")}}, 0.5);
            break;
          case 1:
            expect_every_cell("shnaps-rimon", problem, {{"order", std::string("distance")}, {"retraction", retraction}},
                              0.6, n % 8 != 0);
            break;
          case 2:
            expect_every_cell("shnaps-rimon-banded", problem,
                              {{"group", std::string(n % 8 < 4 ? "none" : "piece")}, {"band", 2.0}}, 0.5);
            break;
          default:
            expect_every_cell("shnaps-rimon-banded", problem,
                              {{"group", std::string("bend")}, {"retraction", retraction}}, 0.5);
        }
      }
}

TEST(ShnapsRimon, AnAnchorElsewhere) {
  for (const auto seed : seeds(4)) {
    const Map map = generate("clutter", {{"width", 8.0}, {"height", 6.0}}, seed);
    Robot robot = tethered_robot(0.7);
    const Point anchor = map.free.polygons.front().outer.front();
    const Point start = Problem(map, tethered_robot(1)).start();
    robot.tether = Tether{1.05 * GeodesicField(map.free, anchor, {}, 1e-6).distance(start) + 1};
    const Problem problem(map, robot, start, anchor);
    expect_every_cell("shnaps-rimon", problem, {{"order", std::string("distance")}}, 0.5);
    expect_every_cell("shnaps-rimon", problem, {}, 0.5);
    expect_sound("tether-tree", problem);
    expect_sound("tethered-stc", problem);
  }
}

// Two dead ends left and right of the anchor, 4 cells wide: the split order finishes one before the other.
TEST(ShnapsRimon, SplitFinishesOneSideFirst) {
  const std::vector<std::string> rows{"...........", "...........", "...##S##...", "...........",
                                      "...........", "...#####...", "...#####...", "...#####..."};
  DrawnMap drawing;
  drawing.robot = tethered_robot(1.1);
  const Problem problem = drawn(rows, drawing);
  const auto changes = [&](const std::string& order) {
    int count = 0, side = 0;
    for (const Leg& leg : plan("shnaps-rimon", problem, {{"order", order}, {"return_home", false}}).legs)
      for (const Point& p : leg.points) {
        const int now = p.y() > 2.8 ? 0 : p.x() < 5 ? -1 : 1;
        if (now != 0 && side != 0 && now != side) ++count;
        if (now != 0) side = now;
      }
    return count;
  };
  EXPECT_GT(changes("distance"), 10);
  EXPECT_EQ(changes("split"), 1);
}

// Behind an obstacle the next cell at the same distance is on its other side. The published orders go there.
TEST(ShnapsRimon, DefaultOrdersStayOnOneSideOfAnObstacle) {
  for (const char* planner : {"shnaps-rimon", "shnaps-rimon-banded"})
    for (const char* generator : {"clutter", "cave"}) {
      SCOPED_TRACE(fmt::format("{} on {}", planner, generator));
      const Problem problem(generate(generator, {{"width", 12.0}, {"height", 10.0}}, 1), tethered_robot(1.2));
      const Settings published{{"variant", std::string("published")}, {"cells", std::string("any")}};
      EXPECT_LT(3 * plan(planner, problem).length(), plan(planner, problem, published).length());
    }
}

TEST(ShnapsRimonBanded, BandsComeInOrderAndTheAngleIncreasesInEach) {
  const Problem problem(generate("rectangle", {{"width", 6.0}, {"height", 5.0}}, 1), tethered_robot(1.1));
  const Path path =
      plan("shnaps-rimon-banded", problem, {{"return_home", false}, {"variant", std::string("published")}});
  long long band = 0;
  double angle = -1;
  for (const Point& p : path.legs.front().points) {  // without obstacles: straight from cell to cell
    const Point arm = p - problem.anchor();
    const auto now = static_cast<long long>(arm.norm() / kSide + 1e-6);
    const double turn = arm.norm() > 0 ? std::fmod(std::atan2(arm.y(), arm.x()) + 2 * kPi, 2 * kPi) : 0;
    EXPECT_GE(now, band);
    if (now == band && now > 0) { EXPECT_GT(turn, angle); }
    band = now;
    angle = turn;
  }
}

/// The longest that the path, pulled taut in the robot's space, becomes on the way.
double longest_trail(const Problem& problem, const Path& path) {
  const TautSpace space(problem.configuration_space());
  TautTether trail(space, problem.start());
  double longest = 0;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points) {
      trail.drive(p);
      longest = std::max(longest, trail.length());
    }
  return longest;
}

// Around a pillar of two millimetres each band is a lap more, and the tether gets hardly longer: memory and time of the
// paths that follow grew with every lap.
TEST(ShnapsRimonBanded, WindingsAboutATinyPillarAreUndoneAtThreeTetherLengths) {
  Region room = box_region({0, 0}, {10, 10});
  room.polygons[0].holes.push_back({{5, 5}, {5, 5.002}, {5.002, 5.002}, {5.002, 5}});
  const Problem problem(Map{"pillar", room, "drawn", "drawn"}, tethered_robot(1.1), Point(5.3, 5.1));
  const Path path =
      plan("shnaps-rimon-banded", problem, {{"variant", std::string("published")}, {"cells", std::string("any")}});
  const double tether = problem.robot().tether->length;
  EXPECT_EQ(find_flaw(problem, path), "");
  EXPECT_LE(longest_trail(problem, path), 3 * tether + 2);  // one path to a cell more
  EXPECT_GT(*score(problem, path).value("coverage_lower"), 0.97);
}

// ------------------------------------------------------------------------------------------------- tether-tree

TEST(TetherTree, ThereAndBackOverEveryEdgeAndNoDeeperThanTheTether) {
  for (const auto seed : seeds(2))
    for (const Map& map : tether_maps(seed))
      for (const double reach : {0.5, 1.0, 2.0}) {
        SCOPED_TRACE(fmt::format("{} reach {}", map.source, reach));
        const Problem problem(map, tethered_robot(reach));
        const double longest = problem.robot().tether->length;
        for (const bool geodesic : {false, true}) {
          const TetherSpace space(problem, "test");
          const std::map<Cell, int> depth =
              flood(geodesic ? space.cut_space() : problem.configuration_space(), problem.start(), kSide);
          std::set<Cell> wanted;
          for (const auto& [cell, d] : depth)
            if (geodesic || d * kSide <= longest * (1 + 1e-12)) wanted.insert(cell);
          if (wanted.size() == 1) continue;
          const Path path =
              expect_sound("tether-tree", problem, {{"reach", std::string(geodesic ? "geodesic" : "depth")}});
          EXPECT_EQ(cells_driven(path, problem.start(), kSide), wanted);
          EXPECT_NEAR(path.length(), 2 * kSide * static_cast<double>(wanted.size() - 1), 1e-6);
          EXPECT_EQ(path.legs.back().points.back(), problem.start());
          TautTether tether(problem.tether()->taut_space(), problem.anchor());
          for (const Leg& leg : path.legs)
            for (const Point& p : leg.points) {
              tether.drive(p);
              const Point cell = (p - problem.start()) / kSide;
              const int d =
                  depth.at({static_cast<int>(std::lround(cell.x())), static_cast<int>(std::lround(cell.y()))});
              EXPECT_LE(tether.length(), d * kSide + 1e-9);
            }
          EXPECT_TRUE(tether.bends().empty());
        }
      }
}

// ------------------------------------------------------------------------------------------------ tethered-stc

TEST(TetheredStc, EachSubCellOnceAndTheTetherIsTheGeodesic) {
  std::size_t rounds = 0;
  for (const auto seed : seeds(2))
    for (const Map& map : tether_maps(seed))
      for (const double reach : {0.5, 1.0, 2.0})
        for (const char* measure : {"depth", "geodesic"}) {
          SCOPED_TRACE(fmt::format("{} reach {} by {}", map.source, reach, measure));
          const Problem problem(map, tethered_robot(reach, 0.1, 0.2));
          const double side = kSide / 2;
          const Path path = expect_sound("tethered-stc", problem, {{"reach", std::string(measure)}});
          if (path.legs.empty()) continue;
          ++rounds;
          ASSERT_EQ(path.legs.size(), 1u);
          EXPECT_EQ(path.legs.front().points.back(), problem.start());
          const std::set<Cell> driven = cells_driven(path, problem.start(), side);
          EXPECT_NEAR(path.length(), side * static_cast<double>(driven.size()), 1e-6);
          const TetherFigures figures = drive_tethered(problem, path, 0.1);
          EXPECT_LE(figures.excess, 1e-7);
          EXPECT_EQ(figures.crossings, 0);

          // For one of the four positions of the start in its coarse cell all coarse cells are whole. Depth by a flood.
          int fits = 0;
          for (const Cell& corner : {Cell{0, 0}, Cell{-1, 0}, Cell{0, -1}, Cell{-1, -1}}) {
            std::map<Cell, int> quarters;
            for (const Cell& c : driven) ++quarters[{(c.first - corner.first) >> 1, (c.second - corner.second) >> 1}];
            if (std::any_of(quarters.begin(), quarters.end(), [](const auto& q) { return q.second != 4; })) continue;
            ++fits;
            const Point root = problem.start() + side * Point(corner.first + 0.5, corner.second + 0.5);
            TautTether tether(problem.tether()->taut_space(), problem.anchor());
            std::map<Cell, int> depth = flood(TetherSpace(problem, "test").cut_space(), root, 2 * side);
            for (const Point& p : path.legs.front().points) {
              tether.drive(p);
              const Point at = (p - root) / (2 * side);
              const Cell cell{static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
              // The flood tests centre lines only, so it contains every tree edge: its depth is at most the tree's.
              ASSERT_TRUE(depth.count(cell));
              EXPECT_LE(tether.length(), problem.robot().tether->length);
              if (std::string(measure) == "depth") {
                EXPECT_LE(2 * depth.at(cell) * side + std::sqrt(2.0) * side,
                          problem.robot().tether->length * (1 + 1e-9));
              }
            }
          }
          EXPECT_GE(fits, 1);
        }
  EXPECT_GT(rounds, 50u);
}

// In the open depth is |i| + |j|, so the bound follows from the robot's position.
TEST(TetheredStc, TetherIsAtMostDepthTimesTwoCellsAndADiagonal) {
  const Problem problem(Map{"square", box_region({0, 0}, {8, 8}), "", ""}, tethered_robot(0.6), Point(4, 4));
  const double longest = problem.robot().tether->length;
  const Path path = plan("tethered-stc", problem);
  // All four positions of the start in its coarse cell are equal here, so the first is taken.
  std::set<Cell> coarse;
  TautTether tether(problem.tether()->taut_space(), problem.anchor());
  for (const Cell& c : cells_driven(path, problem.start(), kSide)) coarse.insert({c.first >> 1, c.second >> 1});
  for (const Point& p : path.legs.front().points) {
    tether.drive(p);
    const Point at = (p - problem.start()) / kSide;
    const int i = static_cast<int>(std::lround(at.x())) >> 1, j = static_cast<int>(std::lround(at.y())) >> 1;
    EXPECT_LE(tether.length(), (std::abs(i) + std::abs(j)) * 2 * kSide + std::sqrt(2.0) * kSide + 1e-9);
  }
  std::set<Cell> wanted;
  const auto deepest = static_cast<int>((longest - std::sqrt(2.0) * kSide) / (2 * kSide));
  for (int i = -deepest; i <= deepest; ++i)
    for (int j = -deepest; j <= deepest; ++j)
      if (std::abs(i) + std::abs(j) <= deepest) wanted.insert({i, j});
  EXPECT_EQ(coarse, wanted);
}

// ---------------------------------------------------------------------------------------------------- all four

TEST(TetheredGrid, SameBytesTwiceAndARobotWithoutTetherIsOneSentence) {
  const Map map = generate("clutter", {{"width", 8.0}, {"height", 6.0}}, 5);
  const Problem problem(map, tethered_robot(0.9)), loose(map, Robot{});
  for (const char* planner : {"shnaps-rimon", "shnaps-rimon-banded", "tether-tree", "tethered-stc"}) {
    SCOPED_TRACE(planner);
    EXPECT_EQ(to_geojson(plan(planner, problem)), to_geojson(plan(planner, problem)));
    EXPECT_THAT([&] { plan(planner, loose); },
                testing::ThrowsMessage<Unsupported>(HasSubstr("needs a robot with a tether")));
  }
}

TEST(TetheredGrid, NoRoomForASecondCellIsInfeasible) {
  const Problem problem(Map{"closet", box_region({0, 0}, {0.5, 0.5}), "", ""}, tethered_robot(1.2));
  for (const char* planner : {"shnaps-rimon", "shnaps-rimon-banded", "tether-tree", "tethered-stc"})
    EXPECT_THAT([&] { plan(planner, problem); }, testing::ThrowsMessage<Infeasible>(HasSubstr("smaller cell_size")))
        << planner;
}

}  // namespace
}  // namespace oxturn
