#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/polygon/link_crossings.hpp"
#include "algorithms/polygon/tracking_points.hpp"
#include "algorithms/transit/tlppa.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using Records = std::map<std::string, double>;

Path plan_with(const char* planner, const Problem& problem, const Settings& settings = {}, Records* records = nullptr) {
  Context::Sinks sinks;
  if (records != nullptr) sinks.record = [records](const std::string& name, double v) { (*records)[name] = v; };
  Context context(1, 1e9, std::move(sinks));
  return built_in_planner(planner, settings)->plan(problem, context);
}

Path plan_hyun(const Problem& problem, const Settings& settings = {}, Records* records = nullptr) {
  return plan_with("hyun", problem, settings, records);
}

Settings setting(const std::string& name, const std::string& value) { return {{name, value}}; }

/// A convex polygon about the origin.
Ring random_footprint(Rng& rng, double radius) {
  Ring ring;
  const int corners = rng.between(3, 8);
  const double turn = rng.between(0.0, 2 * kPi);
  for (int k = 0; k < corners; ++k)
    ring.push_back(rotated({radius, 0}, turn + 2 * kPi * (k + 0.4 * rng.unit()) / corners));
  return ring;
}

/// Small maps: caves of squares, and rooms with random polygons; configuration space is often disconnected.
Problem small_map(std::uint64_t seed) {
  Rng rng(mix(seed, "hyun"));
  Robot robot;
  if (rng.chance(0.5)) robot.footprint = random_footprint(rng, rng.between(0.15, 0.4));
  robot.tool_width = rng.between(0.3, 0.7);
  if (rng.chance(0.5)) {
    const int n = rng.between(4, 7);
    std::vector<std::string> rows(static_cast<std::size_t>(n), std::string(static_cast<std::size_t>(n), '.'));
    for (std::string& row : rows)
      for (char& c : row) c = rng.chance(0.25) ? '#' : '.';
    rows[0][0] = '.';
    return drawn(rows, {1, robot, {}, {}, "cave"});
  }
  Region free = box_region({0, 0}, {6, 5});
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      if (rng.chance(0.2)) continue;
      Ring hole = random_footprint(rng, rng.between(0.2, 0.9));
      std::reverse(hole.begin(), hole.end());
      for (Point& p : hole) p += Point(1.5 + 3 * i, 1.25 + 2.5 * j);
      free.polygons[0].holes.push_back(std::move(hole));
    }
  return Problem({"triangles", std::move(free), "test", ""}, robot);
}

/// nullopt if the robot fits nowhere.
std::optional<Problem> small_problem(std::uint64_t seed) {
  try {
    return small_map(seed);
  } catch (const std::invalid_argument&) { return std::nullopt; }
}

/// As in the source: lanes sized by the robot, no outline.
Settings as_in_source(Settings more = {}) {
  more.insert({"separation_by", std::string("robot")});
  more.insert({"outline", false});
  return more;
}
double source_separation(const Problem& problem) {
  return std::min(height(problem.robot()), problem.robot().tool_width) / 2;
}

TEST(Hyun, EveryPathIsValidAndEveryPointIsVisitedOnce) {
  int polygonal = 0;
  for (const std::uint64_t seed : seeds(1000)) {
    SCOPED_TRACE(fmt::format("small map {}", seed));
    const std::optional<Problem> made = small_problem(seed);
    if (!made) continue;
    const Problem& problem = *made;
    polygonal += problem.robot().footprint.empty() ? 0 : 1;
    Records records;
    const Path path =
        plan_hyun(problem, as_in_source(setting("transit", seed % 2 == 0 ? "tlppa" : "visibility")), &records);
    ASSERT_EQ(find_flaw(problem, path), "");

    const double keep_off = 1e-6 * problem.robot().tool_width;
    const TrackingLines lines = tracking_lines(problem.configuration_space(), source_separation(problem), keep_off, 0);
    EXPECT_EQ(records["tracking_points"], static_cast<double>(lines.points.size()));
    std::map<std::pair<double, double>, int> unvisited;
    for (const TrackingPoint& t : lines.points)
      unvisited[{t.at.x(), t.at.y()}] = 1;  // an interval without length is one point
    Polyline points;
    for (const Leg& leg : path.legs)
      for (const Point& p : leg.points)
        if (points.empty() || points.back() != p) points.push_back(p);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto found = unvisited.find({points[i].x(), points[i].y()});
      if (found == unvisited.end() || --found->second >= 0) continue;
      // A second time only in passing, where a step turns from horizontal to vertical.
      ASSERT_TRUE(i > 0 && i + 1 < points.size()) << "twice at " << points[i].transpose();
      EXPECT_EQ(points[i - 1].y(), points[i].y()) << "twice at " << points[i].transpose();
      EXPECT_EQ(points[i + 1].x(), points[i].x()) << "twice at " << points[i].transpose();
    }
    for (const auto& [at, count] : unvisited) EXPECT_LE(count, 0) << "never at " << at.first << " " << at.second;
  }
  EXPECT_GT(polygonal, 300);
}

bool crosses(const Point& a, const Point& b, const Point& c, const Point& d) {
  const auto side = [](const Point& p, const Point& q, const Point& r) {
    const double s = cross(q - p, r - p);
    return s > 1e-12 ? 1 : s < -1e-12 ? -1 : 0;
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

TEST(Hyun, LinksNeverCross) {
  for (const std::uint64_t seed : seeds(600)) {
    SCOPED_TRACE(fmt::format("small map {}", seed));
    const std::optional<Problem> made = small_problem(seed);
    if (!made) continue;
    Records records;
    const Path path = plan_hyun(*made, as_in_source(setting("nearest", seed % 2 == 0 ? "air" : "path")), &records);
    EXPECT_EQ(records["links_crossing"], 0);
    std::vector<std::pair<Point, Point>> on;
    for (const Leg& leg : path.legs)
      for (std::size_t i = 1; leg.tool && i < leg.points.size(); ++i) on.emplace_back(leg.points[i - 1], leg.points[i]);
    for (std::size_t i = 0; i < on.size(); ++i)
      for (std::size_t j = i + 2; j < on.size(); ++j)
        ASSERT_FALSE(crosses(on[i].first, on[i].second, on[j].first, on[j].second))
            << on[i].first.transpose() << " - " << on[i].second.transpose() << " and " << on[j].first.transpose();
  }
}

TEST(LinkCrossings, AreCountedByTheDefinition) {
  for (const std::uint64_t seed : seeds(300)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const auto lines = [&] {
      std::vector<Polyline> all;
      for (int k = rng.between(0, 8); k > 0; --k) {
        Polyline line;
        for (int i = rng.between(2, 5); i > 0; --i) line.emplace_back(rng.between(0, 12), rng.between(0, 12));
        all.push_back(line);
      }
      return all;
    };
    const std::vector<Polyline> links = lines(), transits = lines();
    std::vector<std::pair<Point, Point>> segments;
    for (const auto& all : {links, transits})
      for (const Polyline& line : all)
        for (std::size_t i = 1; i < line.size(); ++i) segments.emplace_back(line[i - 1], line[i]);
    std::size_t of_links = 0;
    for (const Polyline& line : links) of_links += line.size() - 1;
    std::size_t among = 0, others = 0;
    for (std::size_t j = 0; j < segments.size(); ++j)
      for (std::size_t i = 0; i < j; ++i)
        if (crosses(segments[i].first, segments[i].second, segments[j].first, segments[j].second))
          ++(j < of_links ? among : others);
    const LinkCrossings count = count_crossings(links, transits);
    EXPECT_EQ(count.links, among);
    EXPECT_EQ(count.transits, others);
  }
}

// By point location alone: an interval is free inside and not beyond its ends; its ends touch the obstacle they name.
TEST(TrackingPoints, AreTheEndsOfFreeIntervals) {
  for (const std::uint64_t seed : seeds(500)) {
    SCOPED_TRACE(fmt::format("small map {}", seed));
    const std::optional<Problem> made = small_problem(seed);
    if (!made) continue;
    const Region& space = made->configuration_space();
    const Box box = bounding_box(space);
    const double keep_off = 1e-7;
    const TrackingLines lines = tracking_lines(space, 0.17, keep_off, 0);
    EXPECT_EQ(lines.first.back(), lines.points.size());
    Rng rng(seed);
    for (std::size_t k = 0; k + 1 < lines.first.size(); ++k) {
      const double y = lines.points.empty() ? 0 : lines.points[lines.first[k]].at.y();
      if (lines.first[k] == lines.first[k + 1]) continue;
      if (k + 2 < lines.first.size()) { EXPECT_NEAR(y, box.high.y() - keep_off - static_cast<double>(k) * 0.17, 1e-9); }
      for (int n = 0; n < 12; ++n) {
        const double x = rng.between(box.low.x() - 0.1, box.high.x() + 0.1);
        bool in = false, near = false;
        for (std::size_t i = lines.first[k]; i < lines.first[k + 1]; i += 2) {
          const Point &a = lines.points[i].at, &b = lines.points[i + 1].at;
          in = in || (x > a.x() && x < b.x());
          near = near || std::abs(x - a.x()) < 1e-5 || std::abs(x - b.x()) < 1e-5;
        }
        if (!near) { EXPECT_EQ(in, contains(space, {x, y})) << x << " " << y; }
      }
      for (std::size_t i = lines.first[k]; i < lines.first[k + 1]; ++i) {
        const TrackingPoint& t = lines.points[i];
        EXPECT_EQ(is_left(t.status), i % 2 == 0);
        EXPECT_EQ(t.obstacle == 0, t.status == Contact::left_wall || t.status == Contact::right_wall);
        const Ring& touched = t.obstacle == 0 ? space.polygons[0].outer
                                              : space.polygons[0].holes[static_cast<std::size_t>(t.obstacle - 1)];
        double away = 1e300;
        for (std::size_t e = 0; e < touched.size(); ++e)
          away = std::min(away, distance_to_segment(t.at, touched[e], touched[(e + 1) % touched.size()]));
        EXPECT_LE(away, 2 * keep_off);
      }
    }
  }
}

TEST(TrackingPoints, OnARasterStayInside) {
  const Region space = box_region({0.03, 0}, {9.97, 1});
  const TrackingLines lines = tracking_lines(space, 0.5, 1e-7, 0.25);
  ASSERT_EQ(lines.points.size(), 6u);
  EXPECT_NEAR(lines.points[0].at.x(), 0.28, 1e-12);
  EXPECT_NEAR(lines.points[1].at.x(), 9.78, 1e-12);
}

TEST(Tlppa, EveryPathIsFree) {
  int found = 0;
  for (const std::uint64_t seed : seeds(400)) {
    SCOPED_TRACE(fmt::format("small map {}", seed));
    const std::optional<Problem> made = small_problem(seed);
    if (!made) continue;
    Tlppa tlppa(*made, 0.06);
    Rng rng(seed);
    const Box box = bounding_box(made->configuration_space());
    for (int k = 0; k < 5; ++k) {
      const Point a(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      if (!made->walls().contains(a)) continue;
      const auto path = tlppa.path(a, made->start());
      const auto shortest = made->transit().path(a, made->start());
      ASSERT_TRUE(shortest);
      if (!path) continue;
      ++found;
      EXPECT_EQ(path->front(), a);
      EXPECT_EQ(path->back(), made->start());
      for (std::size_t i = 1; i < path->size(); ++i) EXPECT_TRUE(made->walls().contains((*path)[i - 1], (*path)[i]));
      EXPECT_GE(length(*path), length(*shortest) - 1e-9);
    }
  }
  EXPECT_GT(found, 900);
}

// Without obstacles, eight directions cost at most 1 / cos(22.5 degrees) more, and the ends a few cells.
TEST(Tlppa, IsAsShortAsEightDirectionsAllow) {
  const Problem problem({"hall", box_region({0, 0}, {20, 10}), "test", ""}, Robot{}, Point(1, 1));
  Tlppa tlppa(problem, 0.1);
  for (const Point& to : {Point(19, 1), Point(19, 9), Point(7, 8.5), Point(0.3, 9.7)}) {
    const auto path = tlppa.path({1, 1}, to);
    ASSERT_TRUE(path);
    EXPECT_LE(length(*path), distance({1, 1}, to) / std::cos(kPi / 8) + 0.4);
  }
}

TEST(Tlppa, APassageNarrowerThanItsCellsIsNotSeen) {
  const Problem problem = drawn({"S....#....", "..........", ".....#...."}, {1, [] {
                                                                               Robot r;
                                                                               r.radius = 0.48;
                                                                               return r;
                                                                             }()});
  EXPECT_FALSE(Tlppa(problem, 0.1).path(problem.start(), {9.5, 1.5}));
  EXPECT_TRUE(Tlppa(problem, 0.01).path(problem.start(), {9.5, 1.5}));
  EXPECT_TRUE(problem.transit().path(problem.start(), {9.5, 1.5}));
  Records records;  // the planner records it, and gets there nevertheless
  const Path path = plan_hyun(problem, {{"cell_size", 0.1}}, &records);
  EXPECT_EQ(find_flaw(problem, path), "");
}

TEST(Hyun, AnEmptyRoomTakesLanesOnly) {
  Robot robot;
  robot.footprint = parse_footprint("octagon:1");
  robot.tool_width = 1;
  const Problem problem({"hall", box_region({0, 0}, {11, 8}), "test", ""}, robot, Point(5, 4));
  Records records;
  const Path path = plan_hyun(problem, as_in_source(), &records);
  EXPECT_EQ(records["links_planned"], 0);
  EXPECT_EQ(records["transits_crossing"], 0);
  EXPECT_EQ(records["tracking_points"], 30);  // 7 m, lines half a metre apart, both ends
  EXPECT_NEAR(path.length(true), 15 * 10 + 7, 1e-4);
  const Score s = score(problem, path);
  EXPECT_EQ(s.flaw, "");
  EXPECT_GT(*s.value("coverage"), 0.998);
}

Robot octagonal() {
  Robot robot;
  robot.name = "octagon";
  robot.footprint = parse_footprint("octagon:1");
  robot.tool_width = 1;
  return robot;
}

TEST(Hyun, TheMapOfThePaper) {
  for (const std::uint64_t seed : seeds(8)) {
    SCOPED_TRACE(seed);
    const Problem problem(generate("hyun", {{"jitter", seed == 1 ? 0.0 : 1.0}}, seed), octagonal());
    Records records;
    const Path path = plan_hyun(problem, as_in_source(), &records);
    const Score s = score(problem, path);
    EXPECT_EQ(s.flaw, "");
    EXPECT_GT(*s.value("coverage"), 0.99);
    EXPECT_EQ(records["links_crossing"], 0);
    EXPECT_EQ(records["tlppa_failed"], 0);
    EXPECT_GE(records["links_planned"], 1);
    EXPECT_LE(records["links_planned"], 8);
    // Back and forth: with the tool on the robot drives along lines, or to the next line along a wall.
    for (const Leg& leg : path.legs)
      for (std::size_t i = 1; leg.tool && i < leg.points.size(); ++i) {
        const Point d = leg.points[i] - leg.points[i - 1];
        EXPECT_TRUE(d.y() == 0 || d.norm() < 10)
            << leg.points[i - 1].transpose() << " to " << leg.points[i].transpose();
        EXPECT_LE(std::abs(d.y()), 0.5 + 1e-6);
      }
  }
}

TEST(Hyun, ThePublishedRulesEndToo) {
  for (const std::uint64_t seed : seeds(150)) {
    SCOPED_TRACE(fmt::format("small map {}", seed));
    const std::optional<Problem> made = small_problem(seed);
    if (!made) continue;
    for (const char* passes : {"both", "alternate"}) {
      const Path path =
          plan_hyun(*made, as_in_source({{"rules", std::string("published")}, {"passes", std::string(passes)}}));
      EXPECT_EQ(find_flaw(*made, path), "") << passes;
    }
  }
  // On the paper's map they leave much uncovered: contacts at walls are linked across, those at obstacles on one side.
  const Problem problem(generate("hyun", {}, 1), octagonal());
  Records improved, published;
  const Path ours = plan_hyun(problem, as_in_source(), &improved);
  const Path printed = plan_hyun(problem, as_in_source(setting("rules", "published")), &published);
  EXPECT_EQ(published["tracking_points"], improved["tracking_points"]);
  EXPECT_GT(published["links_planned"], improved["links_planned"]);
  EXPECT_LT(*score(problem, printed).value("coverage"), *score(problem, ours).value("coverage") - 0.1);
}

// The arms of a spiral: the nearest point by straight distance is behind the wall, and the path to it goes round.
TEST(Hyun, ByPathLengthItDoesNotGoBackAndForthBetweenArms) {
  const Problem problem(generate("spiral", {{"width", 12.0}, {"height", 12.0}}, 3), Robot{});
  const Path by_air = plan_hyun(problem, as_in_source()),
             by_path = plan_hyun(problem, as_in_source(setting("nearest", "path")));
  EXPECT_EQ(find_flaw(problem, by_air), "");
  EXPECT_EQ(find_flaw(problem, by_path), "");
  EXPECT_LT(by_path.length(false), 0.5 * by_air.length(false));
}

TEST(Hyun, OutlineRaisesCoverage) {
  const Problem problem(generate("cave", {{"width", 12.0}, {"height", 10.0}}, 3), Robot{});
  const Path plain = plan_hyun(problem, {{"outline", false}}), outlined = plan_hyun(problem);
  const Score a = score(problem, plain), b = score(problem, outlined);
  EXPECT_EQ(a.flaw, "");
  EXPECT_EQ(b.flaw, "");
  EXPECT_GT(*b.value("coverage"), *a.value("coverage"));
  EXPECT_GT(*b.value("coverage"), 0.995);
}

// Lanes follow the tool, however narrow the robot: the path is not many times longer than the tool needs, and nothing
// is lost.
TEST(Hyun, CoversTheTargetOnceWithAnyTool) {
  for (const double tool : {0.05, 0.1, 0.4, 1.0, 3.0})
    for (const char* generator : {"rooms", "field", "cave"}) {
      SCOPED_TRACE(fmt::format("{} with a tool of {} m", generator, tool));
      Robot robot;
      robot.radius = 0.1;
      robot.tool_width = tool;
      const Problem problem(generate(generator, {{"width", 14.0}, {"height", 11.0}}, 5), robot);
      const Score covering = score(problem, plan_hyun(problem));
      EXPECT_EQ(covering.flaw, "");
      EXPECT_GT(*covering.value("coverage"), 0.9999);
      const double open_floor = 14.0 * 11.0 / tool;  // its lanes, without doors and walls
      EXPECT_LT(*covering.value("path_m"), 1.3 * open_floor + 2.5 * perimeter(problem.configuration_space()));
      const Score source = score(problem, plan_hyun(problem, as_in_source()));
      if (tool > 0.4) { EXPECT_GT(*source.value("path_m"), 2 * *covering.value("path_m")); }
    }
}

TEST(Hyun, NoTrackingPointIsOneSentence) {
  const Problem problem({"hall", box_region({0, 0}, {3, 2}), "test", ""}, Robot{}, Point(1, 1));
  EXPECT_THAT(complaint([&] {
                plan_hyun(problem, {{"delta_x", 50.0}, {"separation", 0.2}});
              }),
              testing::HasSubstr("no line has a tracking point"));
  EXPECT_THAT(complaint([&] {
                plan_hyun(problem, {{"separation", 1e-9}});
              }),
              testing::HasSubstr("lines, expected at most"));
  const Path path = plan_hyun(problem, {{"delta_x", 0.1}});
  EXPECT_EQ(find_flaw(problem, path), "");
}

// Planners with the capability `footprint` keep polygonal robots in configuration space.
TEST(Footprints, EveryPlannerWithTheCapabilityIsValid) {
  for (const PlannerInfo& planner : brief_built_in()) {
    if (!planner.has(Capability::footprint) || planner.has(Capability::tether)) continue;
    for (const char* generator : {"hyun", "polygon", "clutter", "rooms", "cave", "comb", "field"}) {
      SCOPED_TRACE(fmt::format("{} on {}", planner.name, generator));
      Settings size{{"width", 14.0}, {"height", 11.0}};
      if (std::string(generator) == "hyun") size["robot"] = 0.2;
      Robot robot;
      robot.footprint = {{0.2, -0.15}, {0.25, 0.1}, {-0.1, 0.2}, {-0.25, 0}, {-0.1, -0.2}};
      robot.tool_width = 0.3;
      const Problem problem(generate(generator, size, 2), robot);
      EXPECT_EQ(missing_capability(planner, problem), "");
      Context context(1);
      const Score s = score(problem, planner.make({}, brief_built_in())->plan(problem, context));
      EXPECT_EQ(s.flaw, "");
      EXPECT_GT(*s.value("coverage"), 0.5);
    }
  }
}

TEST(Footprints, OthersAreUnsupported) {
  const Problem problem({"hall", box_region({0, 0}, {11, 8}), "test", ""}, octagonal());
  EXPECT_EQ(missing_capability(built_in().find("berg"), problem),
            "planner 'berg' has no capability 'footprint', which a robot that is no disc asks for");
}

// The outline covers passages that are no wider than the tool, and half a tool's width beside it elsewhere.
TEST(Hyun, WithTheOutlineLinesCoverOnlyTheRest) {
  const auto problem = [](const char* generator, const Settings& settings, double radius, double tool) {
    Robot robot;
    robot.radius = radius;
    robot.tool_width = tool;
    return Problem(generate(generator, settings, 1), robot);
  };
  const auto lines = [](const Problem& p) { return plan_recorded("hyun", p).figures.at("tracking_points") / 2; };
  EXPECT_EQ(lines(problem("rectangle", {{"width", 10.0}, {"height", 8.0}}, 0.2, 0.4)), 18) << "7.2 m / 0.4 m";
  const Problem narrow =
      problem("spiral", {{"width", 20.0}, {"height", 15.0}, {"robot", 0.1}, {"corridor", 1.0}}, 0.1, 3);
  const Path path = plan_hyun(narrow);
  const Score result = score(narrow, path);
  EXPECT_EQ(result.flaw, "");
  EXPECT_GT(*result.value("coverage"), 0.999);
  EXPECT_LT(path.length(), 1.02 * plan_with("boustrophedon", narrow).length());
}

}  // namespace
}  // namespace oxturn
