// The trace along a path: its rows, and that they say what the metrics say.
#include "metrics/tether_trace.hpp"

#include <gmock/gmock.h>

#include "metrics/mission.hpp"
#include "metrics/score.hpp"
#include "tests/support/files.hpp"
#include "tests/support/seeds.hpp"
#include "tethered.hpp"

namespace oxturn {
namespace {

using Event = TetherRow::Event;

// Round the pillar from the left and over the own line at (3, 5 - 2/3).
const Polyline kLevelSet{{1, 5}, {3, 5}, {3, 3}, {7, 3}, {7, 7}, {3, 7}, {3, 3}};

TEST(TetherTrace, EventsOfALap) {
  const Problem p = leashed(pillar_room(), {1, 5});
  std::vector<Event> events;
  std::vector<std::size_t> bends;
  for (const TetherRow& row : tether_trace(p, work(kLevelSet), 100)) {
    events.push_back(row.event);
    bends.push_back(row.bends);
  }
  // (4, 4) is gained where (1, 5), (4, 4) and the robot are in line: that is the vertex (7, 3).
  EXPECT_THAT(events, testing::ElementsAre(Event::start, Event::waypoint, Event::waypoint, Event::waypoint,
                                           Event::bend_gained, Event::bend_gained, Event::waypoint, Event::bend_gained,
                                           Event::waypoint, Event::bend_gained, Event::crossing, Event::waypoint));
  EXPECT_THAT(bends, testing::ElementsAre(0, 0, 0, 0, 1, 2, 2, 3, 3, 4, 4, 4));
}

TEST(TetherTrace, RowsByHand) {
  const Problem p = leashed(pillar_room(), {1, 5});
  const std::vector<TetherRow> rows = tether_trace(p, work(kLevelSet), 100);
  EXPECT_FALSE(rows[0].angle_rad);
  EXPECT_EQ(rows[1].angle_rad, 0);
  EXPECT_EQ(rows[2].at, Point(3, 3));
  EXPECT_NEAR(rows[2].length_m, std::sqrt(8), 1e-12);
  EXPECT_NEAR(*rows[2].angle_rad, kPi / 4, 1e-12) << "the heading with which it is reached";
  EXPECT_NEAR(distance(rows[5].at, {7, 4}), 0, 1e-12) << "in line with (4, 4) and (6, 4)";
  const TetherRow& crossing = rows[10];
  EXPECT_NEAR(crossing.at.x(), 3, 1e-12);
  EXPECT_NEAR(crossing.at.y(), 5 - 2.0 / 3, 1e-12);
  EXPECT_NEAR(crossing.path_m, 18 + 2.0 / 3, 1e-12);
  EXPECT_NEAR(crossing.length_m, std::sqrt(10) + 6 + std::hypot(1, 1 + 2.0 / 3), 1e-12);
  EXPECT_NEAR(rows.back().path_m, 20, 1e-12);
}

TEST(TetherTrace, DenseEnoughInOrderAndConsistentWithTheMetrics) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Problem p = leashed(pillars(rng, 6), {0.5, 0.5});
    const Path path = work(free_walk(p, rng, 40, 4));
    const double step = 0.01;
    const std::vector<TetherRow> rows = tether_trace(p, path, step);
    const Score s = score(p, path);
    double longest = 0, angle = 0;
    std::size_t bends = 0, crossings = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      longest = std::max(longest, rows[i].length_m);
      bends = std::max(bends, rows[i].bends);
      crossings += rows[i].event == Event::crossing;
      if (i == 0) continue;
      const double metres = rows[i].path_m - rows[i - 1].path_m;
      EXPECT_GE(metres, -1e-12);
      EXPECT_LE(metres, step + 1e-12);
      EXPECT_GE(rows[i].mission_s, rows[i - 1].mission_s - 1e-9);
      EXPECT_LE(distance(rows[i].at, rows[i - 1].at), metres + 1e-12);
      // The heading changes at a vertex, so the row before it says nothing of it.
      const bool turned = rows[i - 1].event == Event::waypoint || !rows[i - 1].angle_rad;
      angle += metres * (turned ? *rows[i].angle_rad : (*rows[i].angle_rad + *rows[i - 1].angle_rad) / 2);
    }
    EXPECT_NEAR(longest, *s.value("tether_max_m"), 1e-12);
    EXPECT_EQ(static_cast<double>(bends), s.value("tether_bends_max"));
    EXPECT_EQ(static_cast<double>(crossings), s.value("tether_crossings"));
    EXPECT_NEAR(angle / rows.back().path_m, *s.value("tether_angle_mean_rad"), 0.01);
    EXPECT_NEAR(rows.back().path_m, *s.value("path_m"), 1e-9);
    EXPECT_NEAR(rows.back().mission_s, *s.value("mission_s"), 1e-6);
  }
}

TEST(TetherTrace, EndsWhereNoStringFollows) {
  const Problem p = leashed(pillar_room(), {1, 5});
  const std::vector<TetherRow> rows = tether_trace(p, work({{1, 5}, {3, 5}, {9, 5}}), 100);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows.back().at, Point(3, 5));
}

TEST(TetherTrace, Csv) {
  const Problem p = leashed(pillar_room(), {1, 5});
  std::vector<TetherRow> rows = tether_trace(p, work({{1, 5}, {2, 5}}), 0.5);
  EXPECT_NEAR(rows.back().mission_s, 3, 1e-12);
  for (TetherRow& row : rows) row.mission_s = std::round(1e9 * row.mission_s) / 1e9;
  EXPECT_EQ(to_csv(rows),
            "path_m,mission_s,x,y,length_m,bends,angle_rad,event\n"
            "0,0,1,5,0,0,,start\n"
            "0.5,1.5,1.5,5,0.5,0,0,sample\n"
            "1,3,2,5,1,0,0,waypoint\n");
}

TEST(TetherTrace, BadStepIsOneSentence) {
  const Problem p = leashed(pillar_room(), {1, 5});
  for (const double step : {0.0, -1.0, std::nan("")})
    EXPECT_THAT(complaint([&] { tether_trace(p, work(kLevelSet), step); }),
                testing::StartsWith("tether trace: step is "));
}

// A metre: 0.5 m/s^2 up to 0.5 m/s takes 1 s and 0.25 m, the same down, 0.5 m in between.
TEST(MissionClock, TrapezoidByHand) {
  const Problem p = problem_in(box_region({-10, -10}, {10, 10}), {0, 0});
  const MissionClock clock(p, work({{0, 0}, {1, 0}}));
  EXPECT_EQ(clock.at(-1), 0);
  EXPECT_EQ(clock.at(0), 0);
  EXPECT_NEAR(clock.at(0.0625), 0.5, 1e-12);
  EXPECT_NEAR(clock.at(0.25), 1, 1e-12);
  EXPECT_NEAR(clock.at(0.5), 1.5, 1e-12);
  EXPECT_NEAR(clock.at(0.9375), 2.5, 1e-12);
  EXPECT_NEAR(clock.total(), 3, 1e-12);
  EXPECT_EQ(clock.at(1), clock.total());
  EXPECT_EQ(MissionClock(p, work({{0, 0}, {0, 0}})).at(1), 0);
}

}  // namespace
}  // namespace oxturn
