#include "algorithms/lanes/ring_graph.hpp"
#include "algorithms/polygon/link_crossings.hpp"
#include "algorithms/polygon/strand.hpp"
#include "coverage_oracle.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kSeams = 2e-3;  // what repair leaves
constexpr int kSamples = 700;

Problem square(double side) {
  return Problem(Map{"square", box_region({0, 0}, {side + 0.4, side + 0.4}), "", ""}, disc(0.2, 0.4), Point(0.2, 0.3));
}

TEST(MeasuredRing, PiecesGoOnPastTheFirstVertex) {
  const MeasuredRing ring({{0, 0}, {2, 0}, {2, 1}, {0, 1}});
  EXPECT_EQ(ring.length(), 6);
  EXPECT_EQ(ring.at(-0.5), Point(0, 0.5));
  EXPECT_EQ(ring.at(8), Point(2, 0));
  EXPECT_EQ(ring.piece(4, 7), (Polyline{{1, 1}, {0, 1}, {0, 0}, {1, 0}}));
  EXPECT_EQ(length(ring.piece(1, 1 + 12.5)), 12.5);
  EXPECT_EQ(ring.piece(0.25, 0.5), (Polyline{{0.25, 0}, {0.5, 0}}));
}

// A line of 10 m on lap 0; what is spliced in replaces the piece between its ends, whichever comes first.
TEST(SplicedPath, TakesOutThePieceBetweenTheEnds) {
  Strand base;
  base.add({{0, 0}, {10, 0}}, 0);
  for (const bool backwards : {false, true}) {
    SplicedPath path(base, 2);
    Strand child;
    child.add({{3, 1}, {3, 5}, {4, 1}}, 1);
    if (backwards) child.reverse();
    const auto cut = path.cut(0, child.points.front(), child.points.back(), 1.5, 2);
    ASSERT_TRUE(cut);
    path.splice(*cut, child);
    EXPECT_EQ(path.points(), (Polyline{{0, 0}, {3, 0}, {3, 1}, {3, 5}, {4, 1}, {4, 0}, {10, 0}}));
    EXPECT_FALSE(path.cut(0, {2.5, 1}, {4.5, 1}, 1.5, 20));  // the splice lies between
    EXPECT_TRUE(path.cut(0, {5, 1}, {6, 1}, 1.5, 2));
    EXPECT_FALSE(path.cut(0, {5, 1}, {8, 1}, 1.5, 2));  // too long
    EXPECT_FALSE(path.cut(0, {5, 2}, {6, 2}, 1.5, 2));  // too far
  }
}

// By hand: laps of a square less a gap of one width each, links of about sqrt(1 + 4) widths inwards and outwards.
TEST(ConnectedFermat, DrivesEachLapOfASquareOnce) {
  const Problem p = square(8);
  const Path path = plan("connected-fermat", p, {{"repair", false}});
  expect_valid(p, path);
  const double step = 0.4 * (1 - 0.015);
  double laps = 0;
  int count = 0;
  for (double side = 8; side > 0; side -= 2 * step, ++count) laps += 4 * side - 0.4;
  const double links = (count - 1) * std::hypot(0.4, 2 * step);
  EXPECT_NEAR(path.length(true), laps + links, 1.0);
}

// One working leg without crossings that begins and ends side by side on the boundary, on convex and other polygons,
// with holes and without.
TEST(ConnectedFermat, IsOneCurveWithoutCrossings) {
  int without_detours = 0;
  for (const auto seed : seeds(10))
    for (const char* family : {"polygon", "clutter"}) {
      SCOPED_TRACE(fmt::format("{} {}", family, seed));
      const Problem p(generate(family, {{"width", 9.0}, {"height", 8.0}}, seed), Robot{});
      for (const char* tree : {"shortest", "longest"}) {
        double closed_laps = -1;
        Context::Sinks sinks;
        sinks.record = [&](const std::string&, double value) { closed_laps = value; };
        Context context(1, 1e9, sinks);
        const Settings settings{{"repair", false}, {"tree", std::string(tree)}};
        const Path path = built_in_planner("connected-fermat", settings)->plan(p, context);
        expect_valid(p, path);
        std::vector<Leg> work;
        for (const Leg& leg : path.legs)
          if (leg.tool) work.push_back(leg);
        EXPECT_EQ(work.size(), 1u);
        EXPECT_LE(distance(work[0].points.front(), work[0].points.back()), 2 * p.robot().tool_width);
        if (closed_laps == 0) { EXPECT_EQ(count_crossings({work[0].points}, {}).links, 0u); }
        without_detours += closed_laps == 0 ? 1 : 0;
        EXPECT_LE(uncovered_share(p, path, kSamples), 0.1);
      }
    }
  EXPECT_GT(without_detours, 10);
}

TEST(ConnectedFermat, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed))
      for (const double tool : {0.25, 0.4}) {
        SCOPED_TRACE(fmt::format("{} {}", p.map().source, tool));
        const Problem q(p.map(), disc(0.2, tool));
        const Path path = plan("connected-fermat", q);
        expect_valid(q, path);
        EXPECT_LE(uncovered_share(q, path, kSamples), kSeams);
      }
}

}  // namespace
}  // namespace oxturn
