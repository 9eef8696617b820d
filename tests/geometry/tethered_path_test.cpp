#include "geometry/tether/tethered_path.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/tether/branching_tether.hpp"
#include "geometry/tether/straightened.hpp"
#include "random_region.hpp"
#include "taut_paths.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The part of `space` within `longest` of the anchor... that holds `start`, cut open along the field's cut.
Region cut_open(const Region& space, const GeodesicField& field, const Point& start) {
  constexpr double kWidth = 1e-4;
  std::vector<Polyline> lines = field.cut_locus(kWidth / 8);
  std::erase_if(lines, [](const Polyline& line) { return line.size() < 2 || length(line) <= 0; });
  for (Polyline& line : lines) {
    const Point first = line[0] - line[1], last = line[line.size() - 1] - line[line.size() - 2];
    if (first.norm() > 0) line.insert(line.begin(), line.front() + first.normalized() * 2 * kWidth);
    if (last.norm() > 0) line.push_back(line.back() + last.normalized() * 2 * kWidth);
  }
  if (lines.empty()) return space;
  for (const Polygon& part : cut_along(space, lines, kWidth).polygons)
    if (EdgeIndex(Region{{part}}).contains(start)) return {{part}};
  return {};
}

struct World {
  World(const Region& free, const Region& space, const Point& anchor, const Point& start, double longest)
      : field(free, anchor, {}, 1e-9),
        cut(cut_open(space, field, start)),
        taut_free(free),
        walls(space),
        tethered(taut_free, walls, space, ShortestPaths(space, 1e-9), ShortestPaths(cut, 1e-9), field, longest, 1e-9),
        robot(tethered, start) {}
  GeodesicField field;
  Region cut;
  TautSpace taut_free;
  EdgeIndex walls;
  TetheredWorld tethered;
  TetheredRobot robot;
};

/// The homotopy class of a path: its signed crossings with one vertical ray for each hole; neighbours that undo
/// each other are gone.
using Word = std::vector<std::pair<std::size_t, int>>;

class Words {
 public:
  explicit Words(const Region& region) {
    for (const Ring& hole : region.polygons.front().holes) {
      Point centre{0, 0};
      for (const Point& p : hole) centre += p / static_cast<double>(hole.size());
      eyes_.push_back(centre);  // holes are convex
    }
  }
  Word of(const Polyline& line, Word word = {}) const {
    for (std::size_t k = 1; k < line.size(); ++k) {
      std::vector<std::pair<double, std::pair<std::size_t, int>>> crossed;
      const Point &a = line[k - 1], &b = line[k];
      for (std::size_t h = 0; h < eyes_.size(); ++h) {
        const double x = eyes_[h].x();
        if ((a.x() < x) == (b.x() < x)) continue;
        const double t = (x - a.x()) / (b.x() - a.x());
        if (lerp(a, b, t).y() > eyes_[h].y()) crossed.push_back({t, {h, a.x() < x ? 1 : -1}});
      }
      std::sort(crossed.begin(), crossed.end());
      for (const auto& [t, letter] : crossed) {
        if (!word.empty() && word.back().first == letter.first && word.back().second == -letter.second)
          word.pop_back();
        else
          word.push_back(letter);
      }
    }
    return word;
  }

 private:
  std::vector<Point> eyes_;
};

Point free_point(Rng& rng, const EdgeIndex& index, const Box& box) {
  while (true) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    if (index.contains(p)) return p;
  }
}

void expect_within(const Region& space, const TetheredRobot& robot, const Polyline& path, double longest) {
  const EdgeIndex walls(space);
  TautTether tether = robot.tether();
  ASSERT_EQ(path.front(), robot.at());
  for (std::size_t k = 1; k < path.size(); ++k) {
    EXPECT_TRUE(walls.contains(path[k - 1], path[k]) || walls.nearest(lerp(path[k - 1], path[k], 0.5), 1e-9));
    for (int i = 1; i <= 16; ++i) {
      tether.drive(i == 16 ? path[k] : lerp(path[k - 1], path[k], i / 16.0));
      EXPECT_LE(tether.length(), longest + 2e-9);
    }
  }
}

/// The tether's greatest length at the points of a path.
double longest_along(const TetheredRobot& robot, const Polyline& path) {
  TautTether tether = robot.tether();
  double most = tether.length();
  for (const Point& p : path) {
    tether.drive(p);
    most = std::max(most, tether.length());
  }
  return most;
}

TEST(TetheredPath, ShortestOfAllClassesThatTheTetherAllows) {
  std::size_t other_class = 0, geodesic = 0;
  for (const auto seed : seeds(120)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const Region free = clutter_box(rng, rng.between(1, 2), rng.between(1, 2), false);
    const EdgeIndex index(free);
    const Box box = bounding_box(free);
    const Point anchor = free_point(rng, index, box), start = free_point(rng, index, box);
    const double reach = GeodesicField(free, anchor, {}, 0).farthest();
    const double longest =
        std::max(rng.between(0.6, 1.4) * reach, GeodesicField(free, anchor, {}, 0).distance(start) * 1.01);
    World world(free, free, anchor, start, longest);
    const Words words(free);
    TautPaths oracle(free);
    Word word = words.of(world.field.path(start));
    for (int k = 0; k < 6; ++k) {
      const Point goal = free_point(rng, index, box);
      SCOPED_TRACE(fmt::format("goal {} at ({}, {})", k, goal.x(), goal.y()));
      const auto path = world.robot.path_to(goal, Retraction::automatic, 100000);
      std::vector<std::pair<Word, double>> states;
      for (const Polyline& line : oracle.from(anchor, goal, longest)) states.push_back({words.of(line), length(line)});
      ASSERT_EQ(path.has_value(), !states.empty());
      if (!path) continue;
      EXPECT_TRUE(path->shortest);
      expect_within(free, world.robot, path->points, longest);
      // The first class by length that ends in one of the goal's states.
      double best = kInf, best_end = 0, plain = kInf;
      for (const Polyline& line : oracle.from(world.robot.at(), goal, length(path->points) * (1 + 1e-9))) {
        plain = std::min(plain, length(line));
        for (const auto& [state, end] : states)
          if (state == words.of(line, word) && length(line) < best) {
            best = length(line);
            best_end = end;
          }
      }
      EXPECT_NEAR(length(path->points), best, 1e-9);
      word = words.of(path->points, word);
      world.robot.drive(path->points);
      EXPECT_NEAR(world.robot.tether().length(), best_end, 1e-9);
      other_class += best > plain;
      geodesic += std::abs(world.robot.tether().length() - world.field.distance(goal)) < 1e-9;
    }
  }
  EXPECT_GT(other_class, 50u);
  EXPECT_GT(geodesic, 300u);
}

TEST(TetheredPath, AnEndlessTetherLeavesThePlainShortestPath) {
  for (const auto seed : seeds(40)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const Region free = clutter_box(rng, 3, 3, seed % 2 == 0);
    const EdgeIndex index(free);
    const ShortestPaths paths(free, 1e-9);
    const Point start = free_point(rng, index, bounding_box(free));
    World world(free, free, start, start, kInf);
    for (int k = 0; k < 10; ++k) {
      const Point goal = free_point(rng, index, bounding_box(free));
      const auto path = world.robot.path_to(goal);
      ASSERT_TRUE(path);
      EXPECT_EQ(path->points, *paths.path(world.robot.at(), goal));
      world.robot.drive(path->points);
    }
  }
}

TEST(TetheredPath, ADiscKeepsTheTetherLengthAndStaysInItsSpace) {
  std::size_t paths = 0, cheap = 0;
  for (const auto seed : seeds(40)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const Region free = clutter_box(rng, 3, 3, seed % 2 == 0, 0.6);
    const Region space = erode(free, 0.04, 1e-3, Bound::inside);
    const Region part{{space.polygons.front()}};
    const EdgeIndex index(part);
    const Box box = bounding_box(part);
    const Point anchor = free_point(rng, index, box), start = free_point(rng, index, box);
    const GeodesicField field(free, anchor, {}, 0);
    const double longest = std::max(rng.between(0.5, 1.2) * field.farthest(), field.distance(start) * 1.01);
    World world(free, part, anchor, start, longest);
    for (int k = 0; k < 8; ++k) {
      const Point goal = free_point(rng, index, box);
      const auto path = world.robot.path_to(goal, k % 3 == 2 ? Retraction::untangle : Retraction::automatic, 500);
      EXPECT_EQ(path.has_value(), world.field.distance(goal) <= longest) << "goal " << k;
      if (!path) continue;
      EXPECT_EQ(path->points.back(), goal);
      expect_within(part, world.robot, path->points, longest);
      world.robot.drive(path->points);
      ++paths;
      cheap += path->shortest;
    }
  }
  EXPECT_GT(paths, 150u);
  EXPECT_GT(cheap, 100u);
}

// By the end of the geodesic alone, against the whole tether.
TEST(TetheredPath, WithinTheTetherAsTheWholeTetherSays) {
  std::size_t within = 0, beyond = 0;
  for (const auto seed : seeds(12)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const Region free = clutter_box(rng, 7, 7, seed % 2 == 0, 0.6);
    const EdgeIndex index(free);
    const Box box = bounding_box(free);
    const Point anchor = free_point(rng, index, box);
    const GeodesicField field(free, anchor, {}, 0);
    const World world(free, free, anchor, anchor, rng.between(0.6, 0.9) * field.farthest());
    for (int k = 0; k < 60; ++k) {
      const Point from = free_point(rng, index, box), to = free_point(rng, index, box);
      if (field.distance(from) > world.tethered.longest) continue;
      auto path = world.tethered.paths.path(from, to);
      ASSERT_TRUE(path.has_value());
      TetheredRobot robot(world.tethered, from);
      const double most = longest_along(robot, *path);
      if (std::abs(most - world.tethered.longest) < 1e-8) continue;
      EXPECT_EQ(within_tether(world.tethered, *path), most < world.tethered.longest) << "path " << k;
      ++(most < world.tethered.longest ? within : beyond);
    }
  }
  EXPECT_GT(within, 100u);
  EXPECT_GT(beyond, 100u);
}

/// A room 10 m square with a pillar 2 m square in its middle.
Region pillar() { return {{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}}}}; }

TEST(TetheredPath, AroundTheOtherSideIfTheTetherIsTooShort) {
  const Point anchor(1, 5);
  World world(pillar(), pillar(), anchor, anchor, 9.5);
  world.robot.drive({{5, 2}, {8, 4.9}});  // below the pillar
  EXPECT_NEAR(world.robot.tether().length(), std::sqrt(10.0) + 2 + distance({6, 4}, {8, 4.9}), 1e-12);
  // Up past the pillar's right side the tether would be 9.66 m long.
  const Point goal(6, 8.5);
  const auto path = world.robot.path_to(goal);
  ASSERT_TRUE(path);
  EXPECT_TRUE(path->shortest);
  EXPECT_EQ(path->points, (Polyline{{8, 4.9}, {6, 4}, {4, 4}, {4, 6}, goal}));
  EXPECT_NEAR(longest_along(world.robot, path->points), world.robot.tether().length(), 1e-12);
  world.robot.drive(path->points);
  EXPECT_NEAR(world.robot.tether().length(), distance(anchor, goal), 1e-12);
  // With a little more tether, the short path.
  World longer(pillar(), pillar(), anchor, anchor, 10.7);
  longer.robot.drive({{5, 2}, {8, 4.9}});
  EXPECT_EQ(longer.robot.path_to(goal)->points, (Polyline{{8, 4.9}, goal}));
}

TEST(TetheredPath, WoundTwiceItUnwindsAsFarAsItMust) {
  const Point anchor(1, 5);
  World world(pillar(), pillar(), anchor, anchor, 30);
  const Polyline lap{{5, 2}, {8, 5}, {5, 8}, {2, 5}};
  world.robot.drive(lap);
  world.robot.drive(lap);
  EXPECT_NEAR(world.robot.tether().length(), std::sqrt(10.0) + 14 + std::sqrt(5.0), 1e-9);
  EXPECT_EQ(world.robot.path_to({4, 2})->points, (Polyline{{2, 5}, {4, 2}}));
  world.robot.drive({{5, 2}, {8, 5}, {5, 8}});
  EXPECT_NEAR(world.robot.tether().length(), std::sqrt(10.0) + 20 + std::sqrt(5.0), 1e-9);
  const auto path = world.robot.path_to({1.5, 3});
  ASSERT_TRUE(path);
  EXPECT_GT(longest_along(world.robot, path->points), 24);
  EXPECT_LE(longest_along(world.robot, path->points), 30);
  World shorter(pillar(), pillar(), anchor, anchor, 27);
  shorter.robot.drive(lap);
  shorter.robot.drive(lap);
  shorter.robot.drive({{5, 2}, {8, 5}, {5, 8}});
  // Onwards by the left side would take sqrt(10) + 22 m up to (4, 6), 29.1 m in all: back by the right side.
  const auto back = shorter.robot.path_to({1.5, 3});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->points, (Polyline{{5, 8}, {6, 6}, {6, 4}, {1.5, 3}}));
}

TEST(TetheredPath, UntangledIsBackUntilStraightInReach) {
  const Point anchor(1, 5), goal(6, 8.5);
  World world(pillar(), pillar(), anchor, anchor, 9.5);
  world.robot.drive({{5, 2}, {8, 4.9}});
  const auto path = world.robot.path_to(goal, Retraction::untangle);
  ASSERT_TRUE(path);
  // Back along (8, 4.9), (6, 4), (4, 4), (1, 5): from the last stretch, where (4, 6) no longer hides the goal.
  ASSERT_EQ(path->points.size(), 5u);
  EXPECT_EQ(path->points[2], Point(4, 4));
  const double slope = 2.5 / 2;  // the line from the goal through (4, 6)
  const Point left = path->points[3];
  EXPECT_NEAR(6 + slope * (left.x() - 4), left.y(), 0.01);
  EXPECT_LT(distance_to_segment(left, {4, 4}, anchor), 1e-12);
  EXPECT_EQ(path->points.back(), goal);
  world.robot.drive(path->points);
  EXPECT_NEAR(world.robot.tether().length(), distance(anchor, goal), 1e-9);
  // In straight reach at once.
  World longer(pillar(), pillar(), anchor, anchor, 10.7);
  longer.robot.drive({{5, 2}, {8, 4.9}});
  EXPECT_EQ(longer.robot.path_to(goal, Retraction::untangle)->points, (Polyline{{8, 4.9}, goal}));
}

// Regression: back to the start each time.
TEST(TetheredPath, UntangledWithoutStraightReachLeavesTheTrailWhereThePathToTheGoalDoes) {
  const Region serpentine{
      {{{{0, 0}, {10, 0}, {10, 3}, {1, 3}, {1, 4}, {10, 4}, {10, 5}, {0, 5}, {0, 2}, {9, 2}, {9, 1}, {0, 1}}, {}}}};
  const Point start(0.5, 0.5), goal(5, 4.5);
  World world(serpentine, serpentine, start, start, 40);
  world.robot.drive({{9, 1}, {9, 2}, {5, 2.5}});
  const auto path = world.robot.path_to(goal, Retraction::untangle);
  ASSERT_TRUE(path);
  EXPECT_EQ(path->points, (Polyline{{5, 2.5}, {9, 2}, {1, 3}, {1, 4}, goal}));
}

TEST(TetheredPath, OutOfReachIsNoWay) {
  World world(pillar(), pillar(), {1, 5}, {1, 5}, 5);
  EXPECT_FALSE(world.robot.path_to({9, 5}));
  EXPECT_FALSE(world.robot.path_to({9, 5}, Retraction::untangle));
  EXPECT_FALSE(world.robot.path_to({5, 5}));
  EXPECT_TRUE(world.robot.path_to({1, 9.9}));
  EXPECT_THROW(World(pillar(), pillar(), {1, 5}, {1, 5}, -1), std::invalid_argument);
}

/// Many short steps, which turn little by little, and anew where a wall is in the way.
Polyline winding_walk(Rng& rng, const EdgeIndex& walls, const Point& from, int steps) {
  constexpr double kStep = 0.03;
  Polyline walk{from};
  double heading = rng.between(0.0, 2 * kPi), turn = 0;
  while (steps > 0) {
    if (rng.chance(0.1)) turn = rng.between(-0.2, 0.2);
    heading += turn;
    const Point to = walk.back() + kStep * Point(std::cos(heading), std::sin(heading));
    if (walls.contains(walk.back(), to))
      walk.push_back(to);
    else
      heading = rng.between(0.0, 2 * kPi);
    --steps;
  }
  return walk;
}

/// A tether that is driven straight past points lies as one that is driven to each of them.
TEST(TetheredRobot, DrivesManyPointsAsOneByOne) {
  std::size_t skipped = 0;
  for (const auto seed : seeds(200)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const Region free = clutter_box(rng, 8, 6, seed % 2 == 0, 0.5);
    const EdgeIndex index(free);
    const Point start = free_point(rng, index, bounding_box(free));
    World world(free, free, start, start, kInf);
    TautTether alone = world.robot.tether();
    for (int k = 0; k < 6; ++k) {
      const Polyline walk = winding_walk(rng, index, world.robot.at(), 60);
      for (const Point& p : walk) alone.drive(p);
      for (std::size_t i = 1; i < walk.size(); ++i) {
        const std::size_t n = points_to_skip(world.taut_free, walk[i - 1], walk, i);
        EXPECT_LE(n, std::min(kMostSkipped, walk.size() - 1 - i));
        EXPECT_TRUE(n == 0 || index.contains(walk[i - 1], walk[i + n]));
        skipped += n;
      }
      world.robot.drive(walk);
      EXPECT_EQ(world.robot.tether().polyline(), alone.polyline());
      EXPECT_EQ(world.robot.tether().length(), alone.length());
      EXPECT_EQ(world.robot.trail().polyline(), alone.polyline());
    }
  }
  EXPECT_GT(skipped, 100'000u);
}

/// Random paths that begin alike, and more of them than tethers are kept.
TEST(BranchingTether, SaysOfEachPathWhatDrivingItSays) {
  std::size_t within = 0, beyond = 0;
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const Region free = clutter_box(rng, 6, 5, seed % 2 == 0, 0.6);
    const EdgeIndex index(free);
    const TautSpace corners(free);
    TautTether from(corners, free_point(rng, index, bounding_box(free)));
    from.drive(winding_walk(rng, index, from.anchor(), 100));
    const double longest = from.length() + rng.between(0.0, 3.0);
    BranchingTether branches(from, longest);
    std::vector<Polyline> paths{{from.robot()}};
    for (int k = 0; k < (seed == 1 ? 3000 : 150); ++k) {
      Polyline path = paths[static_cast<std::size_t>(rng.between(0, static_cast<int>(paths.size()) - 1))];
      for (int tries = 0; tries < 4; ++tries)
        if (const Point next = free_point(rng, index, bounding_box(free)); index.contains(path.back(), next))
          path.push_back(next);
      TautTether tether = from;
      bool stays = true;
      for (const Point& p : path) {
        tether.drive(p);
        stays = stays && tether.length() <= longest;
      }
      EXPECT_EQ(branches.stays_within(path), stays);
      (stays ? within : beyond) += 1;
      paths.push_back(std::move(path));
    }
  }
  EXPECT_GT(within, 500u);
  EXPECT_GT(beyond, 500u);
}

}  // namespace
}  // namespace oxturn
