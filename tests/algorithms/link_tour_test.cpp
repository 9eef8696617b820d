// Tours over Dubins links: their costs, and a bound on what the search for them takes, counted.
#include "algorithms/smoothing/link_tour.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "algorithms/smoothing/link_costs.hpp"
#include "base/random.hpp"

namespace oxturn {
namespace {

double bound_of(PatternId from, PatternId to) { return 1 + std::fmod(from * 0.7 + to * 1.3, 17.0); }

// Oracle: a map of what was set. With a table, and with so many patterns that pairs share slots.
TEST(LinkCosts, AreTheBoundsUntilTheyAreSet) {
  for (const PatternId n : {PatternId{40}, PatternId{LinkCosts::kMostTabulated + 1}}) {
    LinkCosts costs(n, bound_of);
    EXPECT_TRUE(costs.none_known());
    std::map<std::pair<PatternId, PatternId>, double> set;
    Rng rng(n);
    for (int i = 0; i < 400'000; ++i) {
      const auto p = static_cast<PatternId>(rng.below(n)), q = static_cast<PatternId>(rng.below(n));
      if (rng.chance(0.02)) {
        costs.set(p, q, i);
        set[{p, q}] = i;
      }
      const auto known = set.find({p, q});
      ASSERT_EQ(costs(p, q), known == set.end() ? bound_of(p, q) : known->second) << p << " " << q;
      ASSERT_EQ(costs.known(p, q), known != set.end());
    }
  }
}

TEST(LinkCosts, CountWhatIsComputedOnce) {
  LinkCosts costs(LinkCosts::kMostTabulated + 1, bound_of);
  for (int i = 0; i < 5; ++i) costs(3, 8);
  EXPECT_EQ(costs.effort(), 5 + LinkCosts::kBoundEffort);
}

Problem yard(double side, const std::vector<Ring>& pillars) {
  Robot robot;
  robot.radius = 1, robot.tool_width = 2, robot.min_turn_radius = 3;
  return Problem(Map{"yard", {{{box_region({0, 0}, {side, side}).polygons[0].outer, pillars}}}, "test", "test"}, robot);
}

/// Short strokes wherever the robot can be, in random directions.
std::vector<Stroke> scattered(const CarSpace& space, std::size_t n, double side, Rng& rng) {
  std::vector<Stroke> strokes;
  while (strokes.size() < n) {
    const Pose from{{rng.between(1.0, side - 1), rng.between(1.0, side - 1)}, rng.between(-kPi, kPi)};
    Polyline line{from.at, ahead(from, rng.between(2.0, 8.0)).at};
    if (space.free(line)) strokes.push_back({std::move(line), false});
  }
  return strokes;
}

std::vector<Ring> pillars_in(double side) {
  std::vector<Ring> pillars;
  for (double x = 10; x < side - 5; x += 12)
    for (double y = 10; y < side - 5; y += 12) pillars.push_back({{x, y}, {x, y + 3}, {x + 3, y + 3}, {x + 3, y}});
  return pillars;
}

// Where links are blocked there are more rounds, each with a search of its own; with many strokes, bounds are dear.
TEST(LinkTour, TakesNoMoreThanItsEffort) {
  for (const auto& [n, with_pillars] : std::vector<std::pair<std::size_t, bool>>{{20, true}, {1010, false}}) {
    SCOPED_TRACE(n);
    const double side = 6 * std::sqrt(static_cast<double>(n));
    const Problem problem = yard(side, with_pillars ? pillars_in(side) : std::vector<Ring>{});
    const CarSpace space(problem);
    Rng rng(n);
    const std::vector<Stroke> strokes = scattered(space, n, side, rng);
    Context context;
    LinkTour tour(strokes, space, problem.start(), context);
    std::vector<int> driven(n, 0);
    for (const DrivenStroke& s : tour.order()) ++driven[s.stroke];
    EXPECT_EQ(driven, std::vector<int>(n, 1));
    EXPECT_EQ(tour.patterns(), 2 * n + 2);
    EXPECT_LT(static_cast<double>(tour.effort()), 1.1 * static_cast<double>(LinkTour::most_effort(tour.patterns())));
  }
}

TEST(LinkTour, TheBoundGrowsAsNLogN) {
  const auto most = [](double n) { return static_cast<double>(LinkTour::most_effort(static_cast<std::size_t>(n))); };
  for (double n = 10; n < 1e7; n *= 2) EXPECT_LE(most(2 * n), 2 * most(n) * std::log2(2 * n) / std::log2(n));
}

}  // namespace
}  // namespace oxturn
