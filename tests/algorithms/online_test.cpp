// Robots that know only what their lidar sees: the lidar, the belief, the driver, exploration and planning.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "algorithms/online/explore.hpp"
#include "algorithms/online/outline.hpp"
#include "algorithms/online/star.hpp"
#include "algorithms/online/survey_then_plan.hpp"
#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "maps/followed_path.hpp"
#include "metrics/score.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNothing = std::numeric_limits<double>::infinity();

Robot with_lidar(double range = 8, int rays = 360, double noise = 0, Robot robot = {}) {
  robot.lidar = Lidar{range, rays, noise};
  return robot;
}

double free_area(const Belief& belief) {
  return static_cast<double>(belief.cells(0).free.count()) * belief.cell() * belief.cell();
}

/// Small maps of many kinds.
std::vector<Problem> small_problems(std::uint64_t seed, const Robot& robot) {
  std::vector<Problem> all;
  for (const auto& [name, settings] : std::vector<std::pair<std::string, Settings>>{
           {"rooms", {{"width", 5.0}, {"height", 4.0}, {"rooms", std::int64_t{2}}}},
           {"cave", {{"width", 5.0}, {"height", 5.0}}},
           {"clutter", {{"width", 4.0}, {"height", 4.0}}},
           {"polygon", {{"width", 5.0}, {"height", 5.0}, {"corners", std::int64_t{12}}}},
           {"maze", {{"width", 4.0}, {"height", 4.0}}}})
    all.emplace_back(generate(name, settings, seed), robot);
  return all;
}

double lanes_needed(const Problem& p) { return area(p.target()) / p.robot().tool_width; }

Point random_point(const Problem& problem, Rng& rng) {
  const Box box = bounding_box(problem.configuration_space());
  for (;;) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    if (contains(problem.configuration_space(), p)) return p;
  }
}

// ------------------------------------------------------------------------------------------------------ lidar

/// Over all edges, in extended precision.
double cast_by_brute_force(const Region& free, const Point& eye, double angle, double range) {
  using Real = long double;
  const Real dx = std::cos(static_cast<Real>(angle)), dy = std::sin(static_cast<Real>(angle));
  Real best = std::numeric_limits<Real>::infinity();
  for_each_ring(free, [&](const Ring& ring) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point &a = ring[k], &b = ring[(k + 1) % ring.size()];
      const Real ex = Real{b.x()} - a.x(), ey = Real{b.y()} - a.y(), ax = Real{a.x()} - eye.x(),
                 ay = Real{a.y()} - eye.y();
      const Real across = dx * ey - dy * ex;
      if (across == 0) continue;
      const Real t = (ax * ey - ay * ex) / across, s = (ax * dy - ay * dx) / across;
      if (t >= 0 && s >= 0 && s <= 1 && t < best) best = t;
    }
  });
  return best <= range ? static_cast<double>(best) : kNothing;
}

TEST(Lidar, MeasuresARectangle) {
  const LidarSimulator lidar(box_region({0, 0}, {6, 4}), {10, 8, 0});
  Rng rng(1);
  const Scan scan = lidar.scan({2, 1}, rng);
  const double r2 = std::sqrt(2.0);
  const std::vector<double> expected{4, 3 * r2, 3, 2 * r2, 2, r2, 1, r2};
  ASSERT_EQ(scan.reading.size(), expected.size());
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(scan.reading[k], expected[k], 1e-12) << k;
}

TEST(Lidar, SeesNothingBeyondItsRange) {
  const LidarSimulator lidar(box_region({0, 0}, {6, 4}), {2.5, 4, 0});
  Rng rng(1);
  EXPECT_THAT(lidar.scan({2, 1}, rng).reading,
              testing::ElementsAre(kNothing, kNothing, testing::DoubleNear(2, 1e-12), testing::DoubleNear(1, 1e-12)));
}

TEST(Lidar, AgreesWithBruteForceOnAllFamilies) {
  for (const auto seed : seeds(3))
    for (const Problem& p : small_problems(seed, with_lidar(4, 181))) {
      SCOPED_TRACE(p.map().source);
      const LidarSimulator lidar(p.map().free, *p.robot().lidar);
      Rng rng(seed), unused(1);
      for (int n = 0; n < 8; ++n) {
        const Point eye = random_point(p, rng);
        const Scan scan = lidar.scan(eye, unused);
        for (std::size_t k = 0; k < scan.reading.size(); ++k) {
          const double truth = cast_by_brute_force(p.map().free, eye, 2 * kPi * static_cast<double>(k) / 181, 4);
          if (!std::isfinite(truth) && !std::isfinite(scan.reading[k])) continue;
          EXPECT_NEAR(scan.reading[k], truth, 1e-9) << eye.x() << " " << eye.y() << " ray " << k;
        }
      }
    }
}

TEST(Lidar, NoiseIsGaussianAlongTheRayAndSeeded) {
  const Region hall = box_region({-5, -5}, {5, 5});
  const LidarSimulator exact(hall, {20, 360, 0}), noisy(hall, {20, 360, 0.02});
  Rng rng(3), same(3), unused(1);
  const std::vector<double> truth = exact.scan({0, 0}, unused).reading;
  double sum = 0, squares = 0, n = 0;
  for (int turn = 0; turn < 200; ++turn) {
    const auto a = noisy.scan({0, 0}, rng).reading, b = noisy.scan({0, 0}, same).reading;
    ASSERT_EQ(a, b);
    for (std::size_t k = 0; k < a.size(); ++k, ++n) {
      sum += a[k] - truth[k];
      squares += (a[k] - truth[k]) * (a[k] - truth[k]);
    }
  }
  EXPECT_NEAR(sum / n, 0, 5 * 0.02 / std::sqrt(n));
  EXPECT_NEAR(std::sqrt(squares / n), 0.02, 5 * 0.02 / std::sqrt(2 * n));
  Rng fresh(1);
  EXPECT_EQ(unused.bits(), fresh.bits());  // no noise, no draw
}

TEST(Lidar, BadInputIsOneSentence) {
  const Region hall = box_region({0, 0}, {1, 1});
  EXPECT_THAT(
      [&] {
        LidarSimulator(hall, {5, 0, 0});
      },
      ThrowsMessage<std::invalid_argument>("lidar.rays is 0, expected at least 1"));
  EXPECT_THAT(
      [&] {
        LidarSimulator(hall, {0, 8, 0});
      },
      ThrowsMessage<std::invalid_argument>("lidar.range is 0, expected metres above 0"));
  EXPECT_THAT(
      [&] {
        LidarSimulator(hall, {5, 8, -0.1});
      },
      ThrowsMessage<std::invalid_argument>("lidar.noise is -0.1, expected metres of at least 0"));
  Robot robot = with_lidar(5, 0);
  EXPECT_EQ(complaint([&] { check(robot); }),
            "parameter 'lidar_rays' of robot 'disc' is 0, expected a whole number from 1 to 1e+06");
  robot = with_lidar(5, 8, -1);
  EXPECT_EQ(complaint([&] { check(robot); }),
            "parameter 'lidar_noise' of robot 'disc' is -1, expected a number from 0 to 1e+09");
}

// ----------------------------------------------------------------------------------------------------- belief

double beyond_truth(const Belief& belief, const Problem& problem, int level) {
  return area(subtract(belief.region(level), problem.map().free));
}

/// Scans every 20 cm along paths to random points.
void wander(Belief& belief, const Problem& problem, std::uint64_t seed, int goals) {
  const LidarSimulator lidar(problem.map().free, *problem.robot().lidar);
  Rng rng(seed), noise(seed);
  Polyline path{problem.start()};
  for (int goal = 0; goal < goals; ++goal) {
    const auto leg = problem.transit().path(path.back(), random_point(problem, rng));
    path.insert(path.end(), leg->begin() + 1, leg->end());
  }
  for (std::size_t k = 1; k < path.size(); ++k) {
    const int steps = 1 + static_cast<int>(distance(path[k - 1], path[k]) / 0.2);
    for (int s = 1; s <= steps; ++s)
      belief.add(lidar.scan(lerp(path[k - 1], path[k], static_cast<double>(s) / steps), noise));
  }
}

// Wherever the robot drives, nothing is believed free that is not. Nothing is withdrawn if rays are close; an obstacle
// between two rays is overlooked from afar, and withdrawn when it is hit.
TEST(Belief, IsAPartOfTheTruth) {
  for (const auto& [rays, most_lost] : {std::pair(360, 1u), std::pair(2880, 0u)})
    for (const auto seed : seeds(4))
      for (const Problem& p : small_problems(seed, with_lidar(6, rays))) {
        SCOPED_TRACE(p.map().source);
        Belief belief(p.robot(), p.start());
        wander(belief, p, seed, 2);
        for (const int level : {0, Belief::kCoarsest}) EXPECT_LT(beyond_truth(belief, p, level), 1e-6) << level;
        EXPECT_LE(belief.lost(), most_lost);
        EXPECT_GT(free_area(belief), 0.3 * area(p.target()));
      }
}

// Few rays overlook the tip of a wedge from afar; hits correct that when the robot comes near.
TEST(Belief, WithFewRaysOnlyDetailsFromAfarAreWrong) {
  for (const auto seed : seeds(2))
    for (const Problem& p : small_problems(seed, with_lidar(6, 90))) {
      SCOPED_TRACE(p.map().source);
      Belief belief(p.robot(), p.start());
      wander(belief, p, seed, 2);
      EXPECT_LT(beyond_truth(belief, p, 0), 1e-3);
    }
}

TEST(Belief, OneScanOfARoomIsTheWholeRoomLessACellAtItsWalls) {
  const Problem room(Map{"room", box_region({0, 0}, {3.1, 2.3}), "", ""}, with_lidar(), Point(1.234, 1.1));
  const LidarSimulator lidar(room.map().free, *room.robot().lidar);
  Belief belief(room.robot(), room.start());
  Rng unused(1);
  belief.add(lidar.scan(room.start(), unused));
  const double most = area(room.map().free), lost = 2 * (3.1 + 2.3) * belief.cell();
  EXPECT_LT(free_area(belief), most);
  EXPECT_GT(free_area(belief), most - lost - 4 * 0.03 * 0.03);  // a chord cuts each corner
}

TEST(Belief, KnowsNothingBehindAPillar) {
  const Problem hall = drawn({".......", ".......", "...#...", "S......", "......."}, {.robot = with_lidar(20)});
  const LidarSimulator lidar(hall.map().free, *hall.robot().lidar);
  Belief belief(hall.robot(), hall.start());
  Rng unused(1);
  belief.add(lidar.scan({3.5, 1.0}, unused));
  EXPECT_TRUE(belief.free_for({3.5, 1.0}, {3.5, 1.3}, 0.2));
  EXPECT_FALSE(belief.free_for({3.5, 1.0}, {3.5, 2.2}, 0.2));  // into the pillar
  EXPECT_FALSE(belief.free_for({3.5, 3.6}, {3.5, 3.7}, 0.2));  // behind it
  EXPECT_TRUE(belief.free_for({1.5, 1.0}, {1.5, 4.0}, 0.2));   // beside it
}

// A long hall and a tiny robot: the window grows, and becomes coarser rather than too large.
TEST(Belief, GrowsAndCoarsensWithoutForgetting) {
  const Problem hall(Map{"hall", box_region({0, 0}, {90, 4}), "", ""}, with_lidar(4, 720, 0, disc(0.02, 0.04)),
                     Point(2.01, 2.02));
  const LidarSimulator lidar(hall.map().free, *hall.robot().lidar);
  Belief belief(hall.robot(), hall.start());
  const double fine = belief.cell();
  Rng unused(1);
  for (double x = 2.01; x < 88; x += 0.9) belief.add(lidar.scan({x, 2.02}, unused));
  EXPECT_GT(belief.cell(), 1.5 * fine);
  EXPECT_TRUE(belief.free_for({2.5, 2.02}, {87, 2.02}, 0.02));
  EXPECT_FALSE(belief.free_for({2.5, 2.02}, {89.5, 2.02}, 0.02));
}

// The outline has the true walls: straight, and in the right position.
TEST(Outline, ARoomSeenFromThreePointsIsTheRoom) {
  const Problem room(Map{"room", transformed(box_region({0, 0}, {3.1, 2.3}), 0.3, {5, 7}), "", ""}, with_lidar());
  const LidarSimulator lidar(room.map().free, *room.robot().lidar);
  Belief belief(room.robot(), room.start());
  Rng unused(1);
  for (const Point& aside : {Point(0, 0), Point(0.5, 0.3), Point(-0.5, 0.4)})
    belief.add(lidar.scan(room.start() + aside, unused));
  EXPECT_LT(beyond_truth(belief, room, 0), 1e-9);
  EXPECT_GT(area(belief.region(0)), area(room.map().free) - 5e-3);
  EXPECT_LT(vertex_count(belief.region(0)), 30u);
  // The robot may touch a wall.
  const auto wall = EdgeIndex(room.map().free).nearest(room.start());
  const Point by = wall->point + 0.2 * (room.start() - wall->point).normalized();
  EXPECT_TRUE(belief.free_for(room.start(), by, 0.2 - 1e-6));
  EXPECT_FALSE(belief.free_for(room.start(), wall->point + 0.19 * (by - wall->point) / 0.2, 0.2 - 1e-6));
}

Ring circle(double radius) {
  Ring ring;
  for (const Point& d : ray_directions(64)) ring.push_back(radius * d);
  return ring;
}

TEST(Outline, AWallPointRefutesEarlierAndLaterStars) {
  Outline outline(0.2);
  outline.add(circle(2), {0, 0}, 64);
  EXPECT_TRUE(outline.free_for({0, 0}, {1, 0}, 0.3));
  const Point pole(0.8, 0.1);
  EXPECT_TRUE(outline.add_walls({pole}, {}, {0.5, 0}));
  EXPECT_FALSE(outline.free_for({0, 0}, {1, 0}, 0.3));
  EXPECT_FALSE(contains(outline.region(), pole));
  EXPECT_TRUE(outline.free_for({0, 0}, {0, 1}, 0.3));
  outline.add(circle(2), {-0.1, 0}, 64);  // overlooks it once more
  EXPECT_FALSE(contains(outline.region(), pole));
  EXPECT_FALSE(outline.free_for({0, 0}, {1, 0}, 0.3));
  // A star that ends before the pole counts: there is free space close to it after all.
  outline.add(circle(0.2), {0.59, 0.1}, 64);
  EXPECT_TRUE(contains(outline.region(), pole - Point(0.015, 0)));
  EXPECT_FALSE(outline.add_walls({pole, {3, 3}}, {}, {0.5, 0}));  // nothing new
}

// No point that was ever hit is believed free, even with so few rays that every scan overlooks something.
TEST(Outline, ContainsNoWallPoint) {
  for (const auto seed : seeds(2))
    for (const Problem& p : small_problems(seed, with_lidar(6, 60))) {
      SCOPED_TRACE(p.map().source);
      const LidarSimulator lidar(p.map().free, *p.robot().lidar);
      const std::vector<Point> directions = ray_directions(60);
      Outline outline(0.2);
      Rng rng(seed), unused(1);
      std::vector<Point> all;
      for (int n = 0; n < 12; ++n) {
        const Scan scan = lidar.scan(random_point(p, rng), unused);
        std::vector<Point> hits, corners;
        for (std::size_t k = 0; k < 60; ++k)
          if (std::isfinite(scan.reading[k])) hits.push_back(scan.eye + scan.reading[k] * directions[k]);
        const Ring ring = star(scan, directions, {0.5, 2, 1e-9}, &corners);
        for (Point& c : corners) c += scan.eye;
        outline.add_walls(hits, {}, scan.eye);
        outline.add(ring, scan.eye, 60);
        // The outline keeps one hit of each lattice square.
        for (const Point& h : hits)
          if (std::none_of(all.begin(), all.end(), [&](const Point& q) { return distance(q, h) < 0.03; }))
            all.push_back(h);
      }
      const EdgeIndex free(outline.region());
      for (const Point& h : all) EXPECT_FALSE(free.contains(h)) << h.x() << " " << h.y();
    }
}

/// Four stars around a square hole, half of whose side is given.
Outline with_hole(double half) {
  Outline outline(0.2);
  const auto add_rectangle = [&](const Point& low, const Point& high) {
    const Point arm = (high - low) / 2;
    outline.add({arm, {-arm.x(), arm.y()}, -arm, {arm.x(), -arm.y()}}, lerp(low, high, 0.5), 360);
  };
  add_rectangle({-1, -1}, {-half, 1});
  add_rectangle({half, -1}, {1, 1});
  add_rectangle({-1, -1}, {1, -half});
  add_rectangle({-1, half}, {1, 1});
  return outline;
}

TEST(Outline, ASpeckInWhichNoWallWasSeenIsNoObstacle) {
  EXPECT_TRUE(contains(with_hole(0.02).region(), {0, 0}));
  EXPECT_FALSE(contains(with_hole(0.1).region(), {0, 0}));  // large enough to hide something
  Outline pole = with_hole(0.02);
  pole.add_walls({{0.01, 0}}, {}, {0.5, 0});
  EXPECT_FALSE(contains(pole.region(), {0, 0}));
  EXPECT_FALSE(with_hole(0.02).free_for({-0.5, 0}, {0.5, 0}, 0.2));  // a plan may cross it, the robot looks first
}

// A pole that lies between the rays from afar is seen in time.
TEST(Belief, APoleBetweenTheRaysIsNotHit) {
  Region hall = box_region({0, 0}, {9, 3});
  for (const Point& at : {Point(6.03, 1.52), Point(7.51, 0.9), Point(5.2, 2.31)}) {
    Ring pole = box_region(at, at + Point(0.03, 0.03)).polygons[0].outer;
    std::reverse(pole.begin(), pole.end());
    hall.polygons[0].holes.push_back(pole);
  }
  const Problem p(Map{"poles", hall, "", ""}, with_lidar(8, 180), Point(0.5, 1.5));
  Context context(1);
  const Path path = plan_online(p, context, [](const Problem& believed, Context& c) {
    return built_in_planner("boustrophedon")->plan(believed, c);
  });
  expect_valid(p, path);
  EXPECT_GT(*score(p, path).value("coverage_lower"), 0.97);
}

TEST(Belief, AFewWrongHitsDoNotCloseACorridor) {
  const Problem corridor(Map{"corridor", box_region({0, 0}, {6, 1}), "", ""}, with_lidar(8, 360, 0.01),
                         Point(0.5, 0.5));
  const LidarSimulator lidar(corridor.map().free, *corridor.robot().lidar);
  Belief belief(corridor.robot(), corridor.start());
  Rng noise(1);
  for (double x = 0.5; x < 5.5; x += 0.2) belief.add(lidar.scan({x, 0.5}, noise));
  ASSERT_TRUE(belief.free_for({0.5, 0.5}, {5.4, 0.5}, 0.2));
  Scan wrong = lidar.scan({3, 0.5}, noise);
  for (std::size_t k = 0; k < wrong.reading.size(); k += 40) wrong.reading[k] = 0.25;  // as by flies
  belief.add(wrong);
  EXPECT_TRUE(belief.free_for({0.5, 0.5}, {5.4, 0.5}, 0.2));
}

// ----------------------------------------------------------------------------------------------------- driver

/// Drives the motions; keeps whether each arrived.
Path drive_motions(const Problem& p, const std::vector<Motion>& motions, std::vector<bool>& arrived) {
  Context context(1);
  return drive_online(
      p,
      [&](OnlineRobot& robot, Context&) {
        for (const Motion& motion : motions) {
          arrived.push_back(robot.go(motion));
          EXPECT_DOUBLE_EQ(robot.view().driven, robot.view().path.length());
        }
        EXPECT_EQ(robot.view().pose, motions.back().points.back());
      },
      context);
}

TEST(DriveOnline, StopsBeforeAWallThatTheProgramIgnores) {
  const Problem p = drawn({"S...#...", "....#..."}, {.robot = with_lidar()});
  std::vector<bool> arrived;
  const Path path = drive_motions(p, {{{{7.5, 1.5}}, true}, {{{0.5, 0.5}}, false}}, arrived);
  expect_valid(p, path);
  EXPECT_THAT(arrived, testing::ElementsAre(false, true));
  ASSERT_EQ(path.legs.size(), 2u);
  EXPECT_GT(path.legs[0].points.back().x(), 3.3);
  EXPECT_LE(path.legs[0].points.back().x(), 3.8);
  EXPECT_FALSE(path.legs[1].tool);
  EXPECT_EQ(path.legs[1].points.back(), Point(0.5, 0.5));
}

TEST(DriveOnline, GoesOnAfterAMotionThatWasStopped) {
  const Problem p = drawn({"S...#...", "....#..."}, {.robot = with_lidar()});
  std::vector<bool> arrived;
  expect_valid(
      p, drive_motions(p, {{{{2.5, 0.5}, {2.5, 1.5}}, true}, {{{7.5, 1.5}}, true}, {{{0.5, 0.5}}, false}}, arrived));
  EXPECT_THAT(arrived, testing::ElementsAre(true, false, true));
}

// A path of very many small motions is not published at each of them.
TEST(DriveOnline, PublishesSeldomButNearlyAll) {
  const Problem p = drawn({"....", "S..."}, {.robot = with_lidar()});
  Context::Sinks sinks;
  std::size_t times = 0;
  double published = 0;
  sinks.publish = [&](const Path& path) {
    ++times;
    published = path.length();
  };
  Context context(1, 1e9, sinks);
  const Path path = drive_online(
      p,
      [&](OnlineRobot& robot, Context&) {
        for (int k = 0; k < 5000; ++k) {
          ASSERT_TRUE(robot.go({{Point(k % 2 == 0 ? 0.7 : 0.5, 0.5)}, true}));
          ASSERT_GE(published, 0.98 * robot.view().driven);
        }
      },
      context);
  EXPECT_EQ(published, path.length());
  EXPECT_LT(times, 500u);
}

TEST(DriveOnline, ACancelledRobotDoesNotMove) {
  const Problem p = drawn({"....", "S..."}, {.robot = with_lidar()});
  Context context(1);
  const Path path = drive_online(
      p,
      [&](OnlineRobot& robot, Context& inner) {
        EXPECT_TRUE(robot.go({{Point(1.5, 0.5)}, true}));
        inner.cancel();
        EXPECT_FALSE(robot.go({{Point(2.5, 0.5)}, true}));
      },
      context);
  EXPECT_DOUBLE_EQ(path.length(), 1);
}

TEST(DriveOnline, NoLidarAndAUselessLidarAreOneSentence) {
  const auto boustrophedon = [](const Problem& believed, Context& c) {
    return built_in_planner("boustrophedon")->plan(believed, c);
  };
  Context context(1);
  EXPECT_THAT(
      [&] {
        plan_online(drawn({"..", "S."}), context, boustrophedon);
      },
      ThrowsMessage<Unsupported>(HasSubstr("robot 'disc' has no lidar")));
  for (const Robot& blind : {with_lidar(0.05), with_lidar(8, 1), with_lidar(8, 4)}) {
    const Problem p = drawn({"..", "S."}, {.robot = blind});
    EXPECT_THAT([&] { plan_online(p, context, boustrophedon); },
                ThrowsMessage<Infeasible>(HasSubstr("shows robot 'disc' nowhere to go from its start (0.5, 0.5)")));
  }
}

TEST(DriveOnline, ARecordedFigureHasAPlainName) {
  std::vector<std::string> recorded;
  Context::Sinks sinks;
  sinks.record = [&](const std::string& name, double) { recorded.push_back(name); };
  Context context(1, 1e9, sinks);
  context.record("explored_share", 1);
  EXPECT_THAT(recorded, testing::ElementsAre("explored_share"));
  for (const char* bad : {"", "a,b", "Share", "a b", "x\n"})
    EXPECT_THAT([&] { context.record(bad, 1); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("small letters, digits and underscores")));
}

// --------------------------------------------------------------------------------------------------- exploring

/// Only explores; `believed` gets what is believed free at the end.
Path explore(const Problem& p, Region& believed) {
  Context context(1);
  return drive_online(
      p,
      [&](OnlineRobot& robot, Context&) {
        Explorer explorer;
        while (const auto motion = explorer.next(robot.view())) robot.go(*motion);
        believed = robot.view().belief.region(0);
      },
      context);
}

TEST(Explorer, SeesWhatCanBeSeen) {
  for (const auto seed : seeds(2))
    for (const Problem& p : small_problems(seed, with_lidar())) {
      SCOPED_TRACE(p.map().source);
      Region free;
      const Path path = explore(p, free);
      expect_valid(p, path);
      // Points that the tool can reach, 3 cm off the walls: each can be seen from where the robot would be.
      const EdgeIndex walls(p.map().free), believed(free);
      const Box box = bounding_box(p.target());
      Rng rng(seed);
      int all = 0, seen = 0;
      while (all < 4000) {
        const Point q(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
        if (!contains(p.target(), q) || walls.nearest(q, 0.03)) continue;
        ++all;
        seen += believed.contains(q) ? 1 : 0;
      }
      EXPECT_GT(seen, 0.999 * all);
      EXPECT_LT(path.length(), 0.6 * lanes_needed(p));
    }
}

// The tether, simulated in the true map, never exceeds its length while the robot explores.
TEST(Explorer, KeepsTheTetherLength) {
  int explored = 0;
  for (const auto seed : seeds(1))
    for (const double length : {1.5, 4.0}) {
      Robot robot = with_lidar();
      robot.tether = Tether{length};
      for (const Problem& p : small_problems(seed, robot)) {
        SCOPED_TRACE(fmt::format("{} tether {}", p.map().source, length));
        Region free;
        Path path;
        try {
          path = explore(p, free);
        } catch (const Infeasible&) {
          continue;  // all that the tether reaches is seen from the start
        }
        ++explored;
        expect_valid(p, path);
        TautTether tether = tether_at_start(p);
        for (const Leg& leg : path.legs)
          for (const Point& q : leg.points) {
            tether.drive(q);
            ASSERT_LE(tether.length(), length + p.tolerance());
          }
      }
    }
  EXPECT_GE(explored, 5);
}

// -------------------------------------------------------------------------------------------- survey, then plan

Path boustrophedon_online(const Problem& problem, Context& context) {
  return plan_online(problem, context, [](const Problem& believed, Context& c) {
    return built_in_planner("boustrophedon")->plan(believed, c);
  });
}

TEST(SurveyThenPlan, CoversAsMuchAsWithTheMapOnAPathHalfAsLongAgain) {
  std::vector<double> ratios;
  for (const auto seed : seeds(2))
    for (const Problem& p : small_problems(seed, with_lidar())) {
      SCOPED_TRACE(p.map().source);
      Context context(1);
      const Path online = boustrophedon_online(p, context), offline = plan("boustrophedon", p);
      expect_valid(p, online);
      EXPECT_EQ(find_flaw(p, online), "");
      EXPECT_GT(*score(p, online).value("coverage_lower"), *score(p, offline).value("coverage_lower") - 0.005);
      ratios.push_back(online.length() / offline.length());
      EXPECT_LT(ratios.back(), 1.8);
    }
  std::sort(ratios.begin(), ratios.end());
  EXPECT_LT(ratios[ratios.size() / 2], 1.5);
}

// With a tether: survey, back to the start along the tether, then a plan on what is believed, for all such planners.
TEST(SurveyThenPlan, TetheredPlannersKeepTheTetherLengthAndTheirCoverage) {
  std::size_t planners = 0;
  for (const PlannerInfo& info : built_in()) {
    if (!info.has(Capability::online) || !info.has(Capability::tether)) continue;
    ++planners;
    std::vector<double> ratios;
    for (const auto& [generator, size, reach] :
         {std::tuple{"rectangle", 5.0, 1.1}, std::tuple{"clutter", 4.0, 0.6}, std::tuple{"cave", 5.0, 0.8}}) {
      Robot robot = with_lidar(6, 720);
      robot.tether = Tether{};
      robot.tether->reach = reach;
      const Problem p(generate(generator, {{"width", size}, {"height", size}}, 3), robot);
      SCOPED_TRACE(fmt::format("{} {} reach {}", info.name, p.map().source, reach));
      Context context(1);
      const Path path = info.make({{"sensing", std::string("lidar")}}, built_in())->plan(p, context);
      const Path known = plan(info.name, p);
      const Score online = score(p, path), offline = score(p, known);
      if (offline.flaw.empty()) { EXPECT_EQ(online.flaw, ""); }
      EXPECT_GT(*online.value("coverage_lower"), *offline.value("coverage_lower") - 0.005);
      ratios.push_back(path.length() / known.length());
    }
    std::sort(ratios.begin(), ratios.end());
    EXPECT_LT(ratios[ratios.size() / 2], 1.5) << info.name;
  }
  EXPECT_EQ(planners, 5u);
}

// Regression: the outline has edges of nanometres, which confused the tether, and cells were given up (clutter: 0.43).
TEST(SurveyThenPlan, CellsByLidarAreThoseWithTheMap) {
  for (const auto& [generator, size] :
       {std::pair{"cave", 9.0}, std::pair{"clutter", 8.0}, std::pair{"rooms", 8.0}, std::pair{"maze", 7.0}}) {
    Robot robot = with_lidar(6, 360);
    robot.tether = Tether{0, 1.1};
    const Problem p(generate(generator, {{"width", size}, {"height", size}}, 2), robot);
    SCOPED_TRACE(p.map().source);
    const auto coverage = [&](const std::string& sensing) {
      return *score(p, plan("shnaps-rimon", p, {{"sensing", sensing}})).value("coverage_lower");
    };
    EXPECT_GT(coverage("lidar"), coverage("map") - 0.01);
  }
}

TEST(SurveyThenPlan, NoiseCostsAStripAlongTheWallsButNoCollision) {
  for (const double noise : {0.002, 0.02}) {
    for (const Problem& p : small_problems(1, with_lidar(8, 360, noise))) {
      SCOPED_TRACE(fmt::format("{} noise {}", p.map().source, noise));
      Context context(1);
      const Path path = boustrophedon_online(p, context);
      expect_valid(p, path);
      EXPECT_GT(*score(p, path).value("coverage_lower"), noise < 0.01 ? 0.9 : 0.8);
    }
  }
}

TEST(SurveyThenPlan, SameSeedSamePathAndFigures) {
  const Problem p(generate("rooms", {{"width", 5.0}, {"height", 5.0}, {"rooms", std::int64_t{2}}}, 4),
                  with_lidar(8, 360, 0.005));
  std::map<std::string, double> figures[2];
  Path paths[2];
  for (int k = 0; k < 2; ++k) {
    Context::Sinks sinks;
    sinks.record = [&](const std::string& name, double value) { figures[k][name] = value; };
    Context context(7, 1e9, sinks);
    paths[k] = boustrophedon_online(p, context);
  }
  ASSERT_EQ(paths[0].legs.size(), paths[1].legs.size());
  for (std::size_t i = 0; i < paths[0].legs.size(); ++i) EXPECT_EQ(paths[0].legs[i].points, paths[1].legs[i].points);
  EXPECT_EQ(figures[0], figures[1]);
  ASSERT_TRUE(figures[0].contains("explored_share") && figures[0].contains("replans"));
  EXPECT_GT(figures[0]["explored_share"], 0.9);
  EXPECT_LE(figures[0]["explored_share"], 1);
}

TEST(SurveyThenPlan, ACancelledRunReturnsWhatItDrove) {
  const Problem p(generate("maze", {{"width", 6.0}, {"height", 6.0}}, 4), with_lidar());
  Context::Sinks sinks;
  Context* running = nullptr;
  Path published;
  sinks.publish = [&](const Path& path) {
    published = path;
    if (path.length() > 5) running->cancel();
  };
  Context context(1, 1e9, sinks);
  running = &context;
  const Path path = boustrophedon_online(p, context);
  expect_valid(p, path);
  EXPECT_GT(path.length(), 5);
  EXPECT_EQ(path.length(), published.length());
}

// Starts in corners and at a wall.
TEST(SurveyThenPlan, TightStarts) {
  for (const Point& start : {Point(0.2, 0.2), Point(0.2, 1.7), Point(3.8, 0.2)}) {
    const Problem p(Map{"room", box_region({0, 0}, {4, 3}), "", ""}, with_lidar(), start);
    Context context(1);
    const Path path = boustrophedon_online(p, context);
    expect_valid(p, path);
    EXPECT_GT(*score(p, path).value("coverage_lower"), 0.99);
  }
}

TEST(SurveyThenPlan, FarAndTinyCoordinates) {
  for (const double scale : {1e-3, 1e3}) {
    const Region region = drawn_region({"....", ".#..", "..#.", "...."}, scale);
    const Problem p(Map{"far", transformed(region, 0, 1e5 * scale * Point(1, -1)), "", ""},
                    with_lidar(8 * scale, 360, 0, disc(0.2 * scale, 0.4 * scale)));
    Context context(1);
    const Path path = boustrophedon_online(p, context);
    expect_valid(p, path);
    EXPECT_GT(*score(p, path).value("coverage_lower"), 0.99);
  }
}

}  // namespace
}  // namespace oxturn
