#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "coverage_oracle.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/brief_planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Whatever the planner leaves: every one that does not mind a tether, even those that promise nothing.
TEST(Completed, AnyPlannerCoversTheTarget) {
  const auto problems = sample_problems(2);
  std::size_t next = 0;
  for (const PlannerInfo& planner : brief_built_in()) {
    if (planner.has(Capability::tether) || planner.more_parameters) continue;
    for (int k = 0; k < 2; ++k) {
      const Problem& p = problems[next++ % problems.size()];
      SCOPED_TRACE(planner.name + " on " + p.map().source);
      Context context(1);
      const auto completed = brief_built_in().find("completed").make({{"planner", planner.name}}, brief_built_in());
      const Path path = completed->plan(p, context);
      expect_valid(p, path);
      EXPECT_LE(uncovered_share(p, path, 500), 2e-3);
    }
  }
}

TEST(Completed, SettingsReachThePlanner) {
  const Problem p(Map{"hall", box_region({0, 0}, {8, 6}), "", ""}, Robot{}, Point(1, 1));
  const double fine = plan("completed", p, {{"planner", std::string("stc")}, {"cell_size", 0.2}}).length();
  EXPECT_GT(fine, 1.3 * plan("completed", p, {{"planner", std::string("stc")}, {"cell_size", 0.4}}).length());
}

TEST(Completed, APlannerThatFindsNoCellIsNoReasonToGiveUp) {
  const Problem corridor(Map{"corridor", box_region({0, 0}, {6, 0.5}), "", ""}, disc(0.2, 0.4), Point(0.3, 0.25));
  EXPECT_THROW(plan("stc", corridor), Infeasible);
  const Path path = plan("completed", corridor, {{"planner", std::string("stc")}});
  expect_valid(corridor, path);
  EXPECT_LE(uncovered_share(corridor, path, 500), 2e-3);
}

// In a spiral whose corridors are narrower than the tool, what is next to a piece is mostly behind a wall.
TEST(Completed, DetoursDoNotLeadAllTheWayRound) {
  for (const double corridors : {8, 16}) {
    const Map spiral = generate("spiral", {{"width", corridors * 5}, {"height", corridors * 4}, {"robot", 0.6}}, 1);
    const Problem p(spiral, disc(0.6, 7.0));
    const double least = plan("boustrophedon", p).length();
    EXPECT_LE(plan("completed", p, {{"planner", std::string("stc")}}).length(), 2 * least);
  }
}

// A tool much wider than the corridors: each piece has hundreds of others behind walls next to it. To remember a
// connection for each pair would take gigabytes, and a shortest path each would take minutes.
TEST(Completed, PiecesBehindManyWallsDoNotTakeAllMemory) {
  const Map spiral = generate("spiral", {{"width", 80.0}, {"height", 40.0}, {"robot", 0.075}}, 3);
  const Problem p(spiral, disc(0.075, 1.709), Point(0.5, 0.15));
  const Path path = plan("completed", p, {{"planner", std::string("stc")}});
  expect_valid(p, path);
  EXPECT_LE(uncovered_share(p, path, 500), 2e-3);
  EXPECT_LE(path.length(), 2 * plan("boustrophedon", p).length());
}

// A band along the walls of a room is covered by one lap, not by lanes across it.
TEST(Completed, BandsAlongWallsAreDrivenAlong) {
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(seed);
    const Problem p(generate("rooms", {{"width", 10.0}, {"height", 8.0}, {"rooms", 6}}, seed), disc(0.2, 0.4));
    const Path path = plan("completed", p, {{"planner", std::string("bsa")}});
    EXPECT_LE(uncovered_share(p, path, 500), 2e-3);
    EXPECT_LT(*score(p, path).value("length_ratio"), 1.82);
  }
}

// Aisles that hold no cell: the walls are driven once, and one lane between them, instead of rungs from wall to wall.
TEST(Completed, AislesAreDrivenAlong) {
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(seed);
    const Problem p(generate("comb", {{"width", 12.0}, {"height", 9.0}}, seed), disc(0.2, 0.4));
    const Path path = plan("completed", p, {{"planner", std::string("stc")}, {"cell_size", 0.55}});
    expect_valid(p, path);
    EXPECT_LE(uncovered_share(p, path, 500), 2e-3);
    EXPECT_LT(*score(p, path).value("turns"), 150);
  }
}

TEST(Wrapper, RefusesPlannersThatItCannotRun) {
  const Planners planners = built_in_planners();
  const auto make = [&](const char* outer, const char* inner) {
    return planners.find(outer).make({{"planner", std::string(inner)}}, planners);
  };
  EXPECT_THAT([&] { make("completed", "berg"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("'berg' handles the tether itself")));
  EXPECT_THAT([&] { make("leashed", "completed"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("'completed' runs another planner itself")));
  EXPECT_THAT([&] { make("completed", "bss"); }, ThrowsMessage<std::invalid_argument>(HasSubstr("did you mean 'bsa'")));
  EXPECT_THAT(
      [&] {
        planners.find("completed").make({{"planner", std::string("bsa")}, {"tree", std::string("bfs")}}, planners);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("planner 'completed'")));
}

}  // namespace
}  // namespace oxturn
