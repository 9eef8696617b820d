// Metrics of drawings: a square, a circle, crossing strokes and a filled box by hand; legs that use a part of the tool.
#include <gmock/gmock.h>

#include "metrics/over_finished.hpp"
#include "metrics/score.hpp"
#include "shapes.hpp"

namespace oxturn {
namespace {

constexpr double kTool = 0.42, kDisc = kPi * kTool * kTool / 4;

Problem canvas(Drawing drawing, double turn_radius = 0) {
  Map map{"canvas", box_region({0, 0}, {20, 20}), "file", "here"};
  map.drawing = std::make_shared<const Drawing>(std::move(drawing));
  Robot robot;
  robot.radius = 0.2;
  robot.tool_width = kTool;
  robot.min_turn_radius = turn_radius;
  return Problem(map, robot, Point(2, 2));
}
DrawnStroke stroke(Polyline points, double width) { return {"s", std::move(points), width, true, {}, {}}; }
Drawing drawing_of(std::vector<DrawnStroke> strokes, std::vector<FilledArea> areas = {}) {
  Drawing drawing;
  drawing.strokes = std::move(strokes);
  drawing.areas = std::move(areas);
  return drawing;
}
Leg up(Polyline points) { return {false, std::move(points)}; }
Leg down(Polyline points, double width = 0) { return {true, std::move(points), Gear::forward, width}; }
std::optional<double> value(const std::string& metric, const Problem& p, const Path& path) {
  return score(p, path).value(metric);
}
const Polyline kSquare{{2, 2}, {6, 2}, {6, 6}, {2, 6}, {2, 2}};

TEST(DrawingMetrics, EmptyWithoutADrawing) {
  const Problem p = problem_in(box_region({0, 0}, {20, 20}), {2, 2}, 0.2, kTool);
  for (const char* name : {"stroke_share", "stroke_error_m", "fill_share", "fill_share_reachable", "spill_m2",
                           "tool_up_m", "over_finished_m", "work_over_finished_m", "tangent_breaks"})
    EXPECT_FALSE(value(name, p, work({{2, 2}, {5, 2}}))) << name;
}

TEST(DrawingMetrics, StrokesCountWhereNearParallelAndOfTheirWidth) {
  const Problem p = canvas(drawing_of({stroke(kSquare, 0.16)}));
  EXPECT_NEAR(*value("stroke_share", p, {{down(kSquare, 0.16)}}), 1, 1e-12);
  EXPECT_NEAR(*value("stroke_error_m", p, {{down(kSquare, 0.16)}}), 0, 1e-12);
  EXPECT_NEAR(*value("stroke_share", p, {{down(kSquare)}}), 0, 1e-12);  // too wide
  EXPECT_NEAR(*value("stroke_share", p, {{up(kSquare)}}), 0, 1e-12);
  EXPECT_FALSE(value("stroke_error_m", p, {{up(kSquare)}}));
  // The first side only; the second counts within 1 cm of its end only if the heading agreed.
  EXPECT_NEAR(*value("stroke_share", p, {{down({{2, 2}, {6, 2}}, 0.16)}}), 0.25, 1e-12);
  EXPECT_NEAR(*value("stroke_error_m", p, {{down({{2, 2}, {6, 2}}, 0.16)}}), 4, 1e-12);
  EXPECT_NEAR(*value("stroke_share", p, {{down({{2, 2.009}, {6, 2.009}}, 0.16)}}), 0.25, 1e-12);
  EXPECT_NEAR(*value("stroke_share", p, {{down({{2, 2.011}, {6, 2.011}}, 0.16)}}), 0, 1e-12);
}

TEST(DrawingMetrics, SpillIsWhatLeavesAreasAndStrokesThoughTheRestOfTheLegDoesNot) {
  FilledArea area{"a", {{{2, 2}, {8, 2}, {8, 8}, {2, 8}}, {}}, {}};
  const Problem p = canvas(drawing_of({stroke({{12, 2}, {12, 8}}, 0.16)}, {area}));
  // Inside the area, out of it by 1 m, in again; and along the stroke, with 1 m after its end.
  const double round_end = kPi * 0.09 * 0.09 / 2;  // of the stroke, 1 cm wider
  EXPECT_NEAR(*value("spill_m2", p, {{down({{5, 4}, {5, 7}, {5, 9}})}}), kTool + kDisc / 2, 1e-3);
  EXPECT_NEAR(*value("spill_m2", p, {{down({{5, 4}, {5, 9}, {5, 6}, {4, 6}})}}), kTool + kDisc / 2, 1e-3);
  EXPECT_NEAR(*value("spill_m2", p, {{down({{12, 2}, {12, 5}, {12, 9}}, 0.16)}}),
              0.16 + kPi * 0.08 * 0.08 / 2 - round_end, 2e-3);
  EXPECT_EQ(*value("spill_m2", p, {{down({{5, 4}, {5, 7}})}}), 0);
}

TEST(TransitsOverFinished, AreNamedLongestFirst) {
  const Problem p = canvas(drawing_of({stroke(kSquare, 0.16)}));
  // Out of the square and in again: across its right side, and along its upper one.
  const Path path{
      {down(kSquare, 0.16), up({{2, 2}, {4, 4}, {8, 4}}), down({{8, 4}, {9, 4}}), up({{9, 4}, {9, 6}, {1, 6}})}};
  const auto over = transits_over_finished(p, path);
  ASSERT_EQ(over.size(), 2u);
  EXPECT_EQ(over[0].leg, 3u);
  EXPECT_NEAR(over[0].over_m, 4.16, 1e-3);
  EXPECT_NEAR(over[1].over_m, 0.16, 1e-3);
  EXPECT_NEAR(over[0].over_m + over[1].over_m, *value("over_finished_m", p, path), 1e-9);
  EXPECT_EQ(remarks_on(over, [](const TransitOver& t) { return t.leg == 1 ? ": so it is" : ""; })[1],
            "the transit from (2.00, 2.00) to (8.00, 4.00) drives 0.16 m over finished work: so it is");
  EXPECT_EQ(remarks_on(std::vector<TransitOver>(13), [](const auto&) { return ""; }).size(), 13u);
  EXPECT_TRUE(transits_over_finished(p, {{down(kSquare, 0.16)}}).empty());
}

// Vertices ten micrometres apart: thousands of them within the tolerance of each other.
TEST(DrawingMetrics, DenseStrokesAreScoredAsCoarseOnes) {
  Polyline dense, coarse{{3, 3}, {3.2, 3.1}}, other{{3.1, 3.2}, {3.1, 2.9}};
  for (int k = 0; k <= 20000; ++k) dense.push_back({3 + 1e-5 * k, 3 + 5e-6 * k});
  const Problem p = canvas(drawing_of({stroke(dense, 0.06)})), q = canvas(drawing_of({stroke(coarse, 0.06)}));
  const Path fine{{down(other, 0.06), up({other.back(), dense.front()}), down(dense, 0.06)}};
  const Path rough{{down(other, 0.06), up({other.back(), coarse.front()}), down(coarse, 0.06)}};
  for (const char* name : {"stroke_share", "stroke_error_m", "spill_m2", "over_finished_m", "work_over_finished_m"})
    EXPECT_NEAR(*value(name, p, fine), *value(name, q, rough), 1e-4) << name;
}

TEST(DrawingMetrics, FillsAndSpill) {
  const FilledArea box{"a", box_region({4, 4}, {8, 6}).polygons[0], {}};
  const Problem p = canvas(drawing_of({}, {box}));
  const Path lane{{up({{2, 2}, {4, 5}}), down({{4, 5}, {8, 5}})}};
  EXPECT_NEAR(*value("fill_share", p, lane), 4 * kTool / 8, 1e-3);
  EXPECT_NEAR(*value("spill_m2", p, lane), kDisc, 1e-3);  // half a disc at either end
  // The corners that the disc does not reach: (4 - pi) r^2 in all.
  const double reachable = 8 - (4 - kPi) * kTool * kTool / 4;
  const double covered = (4 - kTool) * kTool + kDisc;
  const Path inside{{up({{2, 2}, {4 + kTool / 2, 5}}), down({{4 + kTool / 2, 5}, {8 - kTool / 2, 5}})}};
  EXPECT_NEAR(*value("fill_share_reachable", p, inside), covered / reachable, 1e-3);
  EXPECT_NEAR(*value("spill_m2", p, inside), 0, 1e-3);
  // A stroke is allowed 1 cm.
  const Problem q = canvas(drawing_of({stroke({{4, 5}, {8, 5}}, 0.16)}));
  EXPECT_NEAR(*value("spill_m2", q, {{down({{4, 5}, {8, 5}}, 0.16)}}), 0, 1e-9);
  EXPECT_NEAR(*value("spill_m2", q, {{down({{4, 5}, {8, 5}}, 0.32)}}), 4 * 0.14 + kPi * (0.16 * 0.16 - 0.09 * 0.09),
              2e-3);
}

TEST(DrawingMetrics, DrivingOverFinishedWork) {
  const Problem p = canvas(drawing_of({stroke({{2, 4}, {10, 4}}, 0.16)}));
  // Across, at right angles: as long as the stroke is wide.
  const Path across{{down({{2, 4}, {10, 4}}, 0.16), up({{10, 4}, {10, 8}, {6, 8}, {6, 2}})}};
  EXPECT_NEAR(*value("over_finished_m", p, across), 0.16 * 0.999, 1e-9);
  EXPECT_NEAR(*value("tool_up_m", p, across), 4 + 4 + 6, 1e-9);
  EXPECT_NEAR(*value("work_over_finished_m", p, across), 0, 1e-12);
  const Path crossing{{down({{2, 4}, {10, 4}}, 0.16), up({{10, 4}, {10, 8}, {6, 8}}), down({{6, 8}, {6, 2}}, 0.16)}};
  EXPECT_NEAR(*value("work_over_finished_m", p, crossing), 0.16 * 0.999, 1e-9);
  EXPECT_NEAR(*value("over_finished_m", p, crossing), 0, 1e-12);
  // Back along the stroke, less the discs at both ends.
  const Path back{{down({{2, 4}, {10, 4}}, 0.16), up({{10, 4}, {2, 4}})}};
  EXPECT_NEAR(*value("over_finished_m", p, back), 8 - 2 * (kTool / 2 + 0.01), 1e-9);
  // Along its boundary, but for rounding.
  const Path along{{down({{2, 4}, {10, 4}}, 0.16), up({{10, 4}, {10, 4.08 - 1e-6}, {2, 4.08 - 1e-6}, {2, 8}})}};
  EXPECT_NEAR(*value("over_finished_m", p, along), 0, 1e-12);
  // What comes later is not finished yet.
  EXPECT_NEAR(*value("over_finished_m", p, {{up({{6, 2}, {6, 8}}), down({{2, 4}, {10, 4}}, 0.16)}}), 0, 1e-12);
}

TEST(DrawingMetrics, TangentBreaks) {
  const Problem p = canvas(drawing_of({stroke(kSquare, 0.16)}), 0.5);
  Polyline circle;
  for (int i = 0; i <= 200; ++i) circle.emplace_back(5 + std::cos(i * kPi / 100), 5 + std::sin(i * kPi / 100));
  EXPECT_EQ(*value("tangent_breaks", p, {{down(circle)}}), 0);
  EXPECT_EQ(*value("tangent_breaks", canvas(drawing_of({stroke(kSquare, 0.16)}), 1.2), {{down(circle)}}) > 0, true);
  // A square of sides 4: its corners allow fillets of radius 2.
  EXPECT_EQ(*value("tangent_breaks", canvas(drawing_of({stroke(kSquare, 0.16)}), 2.2), {{down(kSquare)}}), 3);
}

// The same path in narrow legs: figures by hand, and a leg as wide as the tool is a leg without a width.
TEST(PartOfTheTool, CoverageCountsTheWidthThatIsUsed) {
  const Problem p = problem_in(box_region({0, 0}, {20, 20}), {2, 2}, 0.2, kTool);
  const Polyline lane{{2, 10}, {18, 10}};
  const auto covered = [&](double width) {
    const Path path{{down(lane, width)}};
    return swept_area(p.target(), p.target_excess(), kTool, path);
  };
  EXPECT_NEAR(covered(0.1).union_m2, 16 * 0.1 + kPi * 0.05 * 0.05, 1e-4);
  EXPECT_NEAR(covered(0.1).work_m2, 1.6, 1e-9);
  EXPECT_NEAR(covered(0.1).visits_m2, 16 * 0.1 + kPi * 0.05 * 0.05, 1e-4);
  EXPECT_EQ(covered(0).coverage.lower, covered(kTool).coverage.lower);
  const Path mixed{{down({{2, 10}, {10, 10}}, 0.1), down({{10, 10}, {18, 10}}, 0.3)}};
  // The narrow leg, the wide one, their outer half discs, and of the wide one's inner half disc what the narrow leg
  // does not cover: the half disc less the strip |y| < 0.05 in it.
  const double r = 0.15, h = 0.05, strip = h * std::sqrt(r * r - h * h) + r * r * std::asin(h / r);
  EXPECT_NEAR(swept_area(p.target(), 0, kTool, mixed).union_m2,
              8 * 0.1 + 8 * 0.3 + kPi * (h * h + r * r) / 2 + kPi * r * r / 2 - strip, 1e-4);
}

}  // namespace
}  // namespace oxturn
