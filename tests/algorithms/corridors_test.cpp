#include "algorithms/lanes/corridors.hpp"

#include <gtest/gtest.h>

#include "coverage_oracle.hpp"
#include "geometry/overlay/boolean.hpp"
#include "metrics/score.hpp"

namespace oxturn {
namespace {

using Chains = std::vector<std::vector<std::size_t>>;

TEST(Chains, EndWhereLinksBranchOrJoin) {
  EXPECT_EQ(chains(0, {}), Chains{});
  EXPECT_EQ(chains(2, {}), (Chains{{0}, {1}}));
  EXPECT_EQ(chains(4, {{0, 1}, {1, 2}, {2, 3}}), (Chains{{0, 1, 2, 3}}));
  // 0 - 1 divides into 2 - 4 and 3 - 5, which join in 6.
  EXPECT_EQ(chains(7, {{0, 1}, {1, 2}, {1, 3}, {2, 4}, {3, 5}, {4, 6}, {5, 6}}), (Chains{{0, 1}, {2, 4}, {3, 5}, {6}}));
}

// Parts make up the chain; corridors are low and long; no three lanes between them would be one.
TEST(Corridors, ArePartsOfTheChain) {
  Rng rng(1);
  for (int round = 0; round < 500; ++round) {
    std::vector<LaneInterval> chain;
    double low = 0;
    for (std::size_t k = 0; k < 40; ++k) {
      low += rng.between(-0.2, 0.2);
      chain.push_back({k, low, low + (rng.chance(0.1) ? 3 : 0.3)});
    }
    const auto height = [&](std::size_t from, std::size_t count) {
      double bottom = 1e9, top = -1e9;
      for (std::size_t i = from; i < from + count; ++i) {
        bottom = std::min(bottom, chain[i].low);
        top = std::max(top, chain[i].high);
      }
      return std::pair(bottom, top);
    };
    std::size_t at = 0;
    for (const ChainPart& part : corridors_in(chain, 1)) {
      EXPECT_EQ(part.from, at);
      at += part.count;
      if (part.corridor) {
        const auto [bottom, top] = height(part.from, part.count);
        EXPECT_GE(part.count, 3u);
        EXPECT_LE(top - bottom, 1);
        EXPECT_EQ(part.middle, (bottom + top) / 2);
      }
      for (std::size_t i = part.from; !part.corridor && i + 3 <= at; ++i) {
        const auto [bottom, top] = height(i, 3);
        EXPECT_GT(top - bottom, 1);
      }
    }
    EXPECT_EQ(at, chain.size());
  }
}

// Two rooms and a corridor between them. Lanes across the corridor would take two turns for each tool width of it.
TEST(Corridors, TakeOneLane) {
  const Region free =
      unite({box_region({0, 0}, {4, 8}), box_region({4, 3.5}, {24, 4.5}), box_region({24, 0}, {28, 8})});
  const Problem p(Map{"rooms", free, "", ""}, disc(0.2, 0.4), Point(2, 2));
  for (const char* name : {"boustrophedon", "zigzag", "trapezoid"}) {
    const Path path = plan(name, p, {{"sweep", std::string("given")}, {"angle", 90.0}});
    expect_valid(p, path);
    EXPECT_EQ(uncovered_share(p, path, 1500), 0);
    EXPECT_LT(score(p, path).value("turns").value_or(1e9), 120) << name;  // 50 for each room
  }
}

// What laps leave in the middle of a spiral of corridors is one piece, in which any lanes in one direction would be
// across half of the corridors.
TEST(Corridors, RepairDrivesAlongThem) {
  const Problem p(generate("spiral", {}, 1), disc(0.2, 0.4));
  for (const char* name : {"contour", "connected-fermat"}) {
    const Path path = plan(name, p);
    expect_valid(p, path);
    EXPECT_GE(score(p, path).value("coverage_lower").value_or(0), 0.9999);
    EXPECT_LT(score(p, path).value("turns").value_or(1e9), 400) << name;
  }
}

// The same with a tool wider than the robot's corridors: pieces reach out of configuration space.
TEST(Corridors, RepairDrivesAlongThemWithAWideTool) {
  const Problem p(generate("spiral", {{"width", 20.0}, {"height", 16.0}}, 1), disc(0.2, 1.5));
  const Path path = plan("completed", p, {{"planner", std::string("stc")}});
  expect_valid(p, path);
  EXPECT_LE(uncovered_share(p, path, 500), 2e-3);
  EXPECT_LT(score(p, path).value("turns").value_or(1e9), 250);
}

}  // namespace
}  // namespace oxturn
