#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "algorithms/drawing/containment.hpp"
#include "algorithms/drawing/priced_order.hpp"
#include "coverage_oracle.hpp"
#include "geometry/bends.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "tests/support/drawings.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

DrawnStroke line(const std::string& element, Polyline points, double width = 0.16) {
  DrawnStroke stroke;
  stroke.element = element;
  stroke.points = std::move(points);
  stroke.width = width;
  return stroke;
}
DrawnStroke square(const std::string& element, const Point& low, double side) {
  return line(element, {low, low + Point(side, 0), low + Point(side, side), low + Point(0, side), low});
}

void expect_no_jump(const Problem& problem, const Path& path) {
  Point at = problem.start();
  for (const Leg& leg : path.legs) {
    ASSERT_GE(leg.points.size(), 2u);
    EXPECT_LE(distance(at, leg.points.front()), 1e-9);
    for (const Point& p : leg.points) EXPECT_TRUE(finite(p));
    at = leg.points.back();
  }
}

/// The order in which strokes of these end points are begun: the index of the first leg that draws the point.
std::size_t first_drawn(const Path& path, const Point& p) {
  for (std::size_t k = 0; k < path.legs.size(); ++k)
    if (path.legs[k].tool)
      for (std::size_t i = 1; i < path.legs[k].points.size(); ++i)
        if (distance_to_segment(p, path.legs[k].points[i - 1], path.legs[k].points[i]) < 1e-9) return k;
  return path.legs.size();
}

/// Metres driven with the tool at this width.
double drawn_m(const Path& path, double width) {
  double sum = 0;
  for (const Leg& leg : path.legs)
    if (leg.tool && leg.width == width) sum += length(leg.points);
  return sum;
}

double covered_share(const FilledArea& area, const Path& path, const Robot& robot) {
  std::vector<Polyline> lines;
  for (const Leg& leg : path.legs)
    if (leg.tool && leg.width == robot.tool_width) lines.push_back(leg.points);
  const double w = robot.tool_width;
  const Region all{{area.area}};
  const Region reachable = dilate(erode(all, w / 2, 1e-3 * w, Bound::inside), w / 2, 1e-3 * w, Bound::inside);
  if (oxturn::area(reachable) <= 0) return 1;
  const Region missed = subtract(reachable, swath_parts(lines, w / 2, 1e-3 * w, Bound::outside));
  return 1 - oxturn::area(missed) / oxturn::area(reachable);
}

// Strokes are drawn once, with their widths; fills are covered; nothing jumps.
TEST(Beachbot, DrawsEveryStrokeOnceAndCoversEveryFill) {
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(seed);
    DrawingKind kind{.polylines = 4, .closed = 2, .nested = 2, .letters = 2, .areas = static_cast<int>(seed % 3)};
    const Drawing drawing = DrawingGenerator(seed, kind).drawing();
    const Robot robot = beach_robot();
    const Problem problem = canvas(drawing, robot, kind);
    const Path path = plan("beachbot", problem);
    expect_no_jump(problem, path);
    double fills_m = 0;
    for (const double width : {0.04, 0.16, 0.32, 0.42}) {
      double strokes_m = 0;
      for (const DrawnStroke& s : drawing.strokes)
        if (s.width == width) strokes_m += length(s.points);
      const double drawn = drawn_m(path, width);
      if (width < 0.42)
        EXPECT_NEAR(drawn, strokes_m, 1e-6);
      else
        fills_m = drawn - strokes_m;
    }
    EXPECT_GE(fills_m, -1e-6);
    for (const DrawnStroke& s : drawing.strokes)
      for (std::size_t k = 1; k < s.points.size(); ++k)
        EXPECT_LT(first_drawn(path, lerp(s.points[k - 1], s.points[k], 0.5)), path.legs.size());
    for (const FilledArea& area : drawing.areas) EXPECT_GE(covered_share(area, path, robot), 0.98);
  }
}

TEST(Beachbot, WhatIsInsideComesFirst) {
  for (const auto seed : seeds(3)) {
    SCOPED_TRACE(seed);
    DrawingKind kind{.polylines = 3, .closed = 4, .nested = 3, .letters = 2, .areas = 0};
    const Drawing drawing = DrawingGenerator(seed, kind).drawing();
    const std::vector<DrawingElement> elements = stroke_elements(drawing);
    const Path path = plan("beachbot", canvas(drawing, beach_robot(), kind));
    for (const auto& [outer, inner] : contained_elements(elements, ContainmentTest::overlay)) {
      const Polyline &o = elements[outer].legs[0].points, &i = elements[inner].legs[0].points;
      EXPECT_LT(first_drawn(path, lerp(i[0], i[1], 0.37)), first_drawn(path, lerp(o[0], o[1], 0.37)));
    }
  }
}

TEST(Beachbot, ContainmentIsThatOfTheShapes) {
  Drawing drawing;
  drawing.strokes = {square("outer", {1, 1}, 8), square("middle", {2, 2}, 3), square("inner", {2.5, 2.5}, 1),
                     line("crossing", {{0.5, 3}, {4, 3}}), line("touching", {{2, 2}, {4, 4}})};
  const auto pairs = contained_elements(stroke_elements(drawing), ContainmentTest::overlay);
  EXPECT_EQ(pairs, (std::vector<std::pair<std::size_t, std::size_t>>{{0, 1}, {1, 2}, {1, 4}}));
}

TEST(Beachbot, EnforcedConnectionsAreDriven) {
  Drawing drawing;
  drawing.strokes = {line("a", {{1, 1}, {3, 1}}), line("b", {{8, 6}, {10, 6}}), line("c", {{3.5, 1}, {5, 1}})};
  drawing.connections = {{.from = {"a", -1}, .to = {"b", 0}, .enforced = true}};
  const Path path = plan("beachbot", canvas(drawing, beach_robot()));
  bool found = false;
  for (const Leg& leg : path.legs)
    if (!leg.tool) {
      const Point &p = leg.points.front(), &q = leg.points.back();
      found = found || (p == Point(3, 1) && q == Point(8, 6)) || (q == Point(3, 1) && p == Point(8, 6));
    }
  EXPECT_TRUE(found);
  drawing.connections[0] = {.from = {"a", -1}, .to = {"c", 0}, .enforced = false};
  for (const Leg& leg : plan("beachbot", canvas(drawing, beach_robot())).legs) {
    const Point &p = leg.points.front(), &q = leg.points.back();
    EXPECT_FALSE(!leg.tool && std::min(distance(p, {3, 1}), distance(q, {3, 1})) < 1e-9 &&
                 std::min(distance(p, {3.5, 1}), distance(q, {3.5, 1})) < 1e-9);
  }
}

// A person names the same vertex of an area twice: one connection is at each end of its fill.
TEST(Beachbot, TwoEnforcedConnectionsOfAnAreaHaveOneEndEach) {
  Drawing drawing;
  drawing.areas.push_back({.element = "box", .area = {{{3, 2}, {6, 2}, {6, 5}, {3, 5}}, {}}, .choice = {}});
  drawing.strokes = {line("a", {{1, 1}, {2, 1}}), line("b", {{8, 6}, {9, 6}}), line("c", {{8, 1}, {9, 1}})};
  drawing.connections = {{{"a", -1}, {"box", 0}, true}, {{"b", 0}, {"box", 0}, true}};
  const Path path = plan("beachbot", canvas(drawing, beach_robot(), {.width = 12, .height = 8}));
  std::string order;  // of what is driven with the tool on; lower case as above, F for the fill
  for (const Leg& leg : path.legs) {
    if (!leg.tool) continue;
    const Point p = leg.points.front();
    const char element = p.x() < 2.5 ? 'a' : p.y() > 5.5 ? 'b' : p.x() > 7 ? 'c' : 'F';
    if (order.empty() || order.back() != element) order += element;
  }
  EXPECT_THAT(order, ::testing::AnyOf(HasSubstr("aFb"), HasSubstr("bFa")));
}

// Whichever vertex of an area a person names: which end of its fill is nearest to that changes with the plan.
TEST(Beachbot, DeletedConnectionsWithFillsAreNotDriven) {
  Ring disc;
  for (int k = 0; k < 40; ++k) disc.push_back(Point(4, 3) + rotated({1.5, 0}, 2 * kPi * k / 40));
  Drawing drawing;
  drawing.areas.push_back({.element = "disc", .area = {disc, {}}, .choice = {}});
  drawing.strokes.push_back(line("a", {{6, 3}, {7, 3}}, 0.16));
  drawing.strokes.push_back(line("b", {{8, 6}, {9, 6}}, 0.04));
  for (const int vertex : {-1, 0, 10, 20, 30}) {
    SCOPED_TRACE(vertex);
    drawing.connections.clear();
    if (vertex >= 0)
      for (const int end : {0, -1})
        drawing.connections.push_back({.from = {"a", end}, .to = {"disc", vertex}, .enforced = false});
    const Path path = plan_recorded("beachbot", canvas(drawing, beach_robot(), {.width = 12, .height = 8})).path;
    bool beside = false;
    double before = 0;
    for (const Leg& leg : path.legs) {
      if (!leg.tool) continue;
      beside = beside || (before == 0.16 && leg.width > 0.16) || (before > 0.16 && leg.width == 0.16);
      before = leg.width;
    }
    EXPECT_EQ(beside, vertex < 0);
  }
}

TEST(Beachbot, ContradictionsNameBothElements) {
  Drawing drawing;
  drawing.strokes = {line("eye", {{1, 1}, {3, 1}}), line("ear", {{8, 6}, {10, 6}}), line("tail", {{3.5, 1}, {5, 1}})};
  const auto message = [&](std::vector<DrawnConnection> connections) {
    drawing.connections = std::move(connections);
    try {
      plan("beachbot", canvas(drawing, beach_robot()));
    } catch (const std::invalid_argument& e) { return std::string(e.what()); }
    return std::string("no message");
  };
  EXPECT_THAT(message({{{"eye", -1}, {"ear", 0}, true}, {{"tail", 0}, {"eye", -1}, true}}),
              ::testing::AllOf(HasSubstr("'ear'"), HasSubstr("'tail'")));
  EXPECT_THAT(message({{{"eye", -1}, {"ear", 0}, true}, {{"eye", 0}, {"ear", -1}, true}}),
              ::testing::AllOf(HasSubstr("'eye'"), HasSubstr("'ear'"), HasSubstr("cycle")));
  EXPECT_THAT(message({{{"eye", -1}, {"ear", 0}, true}, {{"ear", 0}, {"eye", -1}, false}}),
              HasSubstr("both enforced and deleted"));
  EXPECT_THAT(message({{{"nose", 0}, {"ear", 0}, true}}), HasSubstr("'nose'"));
  EXPECT_THAT(message({{{"eye", 7}, {"ear", 0}, true}}), HasSubstr("node 7 of element 'eye', which has 2 nodes"));
}

// A wall that is drawn between two strokes is gone round, not over.
TEST(Beachbot, TransitsGoRoundWhatIsDrawn) {
  Drawing drawing;
  drawing.strokes = {line("near", {{1, 2}, {1, 4}}), line("wall", {{4, 1}, {4, 9}}, 0.42),
                     line("far", {{6, 4}, {9, 4}})};
  drawing.connections = {{{"near", 0}, {"wall", 0}, true}, {{"wall", -1}, {"far", 0}, true}};
  const RecordedPlan around = plan_recorded("beachbot", canvas(drawing, beach_robot()));
  EXPECT_EQ(around.figures.at("over_finished_m"), 0);

  const Problem problem = canvas(drawing, beach_robot());
  FinishedWork work(pieces_of(stroke_elements(drawing)).pieces, 0.22);
  TransitRouter router(problem, work, 0.3, nullptr);
  EXPECT_NEAR(router.route(Pose{{3, 5}}, Pose{{5, 5}}).length_m, 2, 1e-9);
  work.finish(1);
  const Transit round = router.route(Pose{{3, 5}}, Pose{{5, 5}});
  EXPECT_NEAR(router.direct(Pose{{3, 5}}, Pose{{5, 5}}).crossing_m, 0.42, 1e-3);
  EXPECT_EQ(round.crossing_m, 0);
  // Tangents to the discs of 0.21 + 0.3 about an end of the wall, and the arc between them.
  const double tangent = std::sqrt(1 + 16 - 0.51 * 0.51),
               turn = 2 * (std::atan2(1, 4) + std::acos(0.51 / std::sqrt(17)));
  EXPECT_NEAR(round.length_m, 2 * tangent + 0.51 * (2 * kPi - turn), 0.02);
  work.undo(1);
  EXPECT_NEAR(router.route(Pose{{3, 5}}, Pose{{5, 5}}).length_m, 2, 1e-9);
}

// The round end of a stroke as wide as the tool must not enclose the robot.
TEST(Beachbot, LeavesAStrokeAsWideAsTheTool) {
  for (const double width : {0.04, 0.16, 0.32, 0.42}) {
    Drawing drawing;
    drawing.strokes = {line("near", {{1, 2}, {1, 4}}), line("wall", {{4, 1}, {4, 9}}, width),
                       line("far", {{6, 4}, {9, 4}})};
    EXPECT_EQ(plan_recorded("beachbot", canvas(drawing, beach_robot())).figures.at("over_finished_m"), 0);
  }
}

// All orders of up to six strokes, each priced with the same transits.
TEST(Beachbot, FindsTheBestOrderOfFewElements) {
  for (const auto seed : seeds(12)) {
    SCOPED_TRACE(seed);
    DrawingKind kind{.polylines = 5, .closed = 0, .nested = 0, .letters = 0, .areas = 0, .width = 9, .height = 7};
    const Drawing drawing = DrawingGenerator(seed, kind).drawing();
    const Problem problem = canvas(drawing, beach_robot(), kind);
    const std::vector<DrawingElement> elements = stroke_elements(drawing);
    FinishedWork work(pieces_of(elements).pieces, 0.52 * 0.42);
    TransitRouter router(problem, work, 0.3, nullptr);
    PricedOrder priced(elements, problem.start(), FinishedRule::around, router, work);
    DrawingTour tour(elements, {}, problem.start(), 0);
    Context context;
    const auto price = [](const DrivenOrder& o) { return o.length_m + Transit::kCrossingWeight * o.crossing_m; };
    const double found = price(priced.search(tour, context));
    double best = found;
    std::vector<std::size_t> order(elements.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do
      for (unsigned turned = 0; turned < (1u << order.size()); ++turned) {
        std::vector<ElementVisit> visits;
        double straight = 0;
        Point at = problem.start();
        for (const std::size_t e : order) {
          visits.push_back({e, 0, (turned >> e & 1) != 0});
          straight += distance(at, entry_of(elements[e], visits.back()));
          at = exit_of(elements[e], visits.back());
        }
        if (straight < best) best = std::min(best, price(priced.driven(visits)));
      }
    while (std::next_permutation(order.begin(), order.end()));
    EXPECT_LE(found, 1.001 * best + 1e-9);
  }
}

// The lap along the boundary comes last: a robot that leaves a disc crosses nothing, nor one that leaves its corners.
TEST(Beachbot, LeavesFillsWithoutCrossingThem) {
  Ring disc;
  for (int k = 0; k < 40; ++k) disc.push_back(Point(3, 4) + rotated({1.5, 0}, 2 * kPi * k / 40));
  Drawing drawing;
  drawing.areas.push_back({.element = "disc", .area = {disc, {}}, .choice = {}});
  drawing.areas.push_back({.element = "box", .area = {{{6, 2}, {9, 2}, {9, 5}, {6, 5}}, {}}, .choice = {}});
  drawing.strokes.push_back(line("stroke", {{10, 7}, {11, 7}}));
  const DrawingKind kind{.width = 12, .height = 8};
  const Problem problem = canvas(drawing, beach_robot(), kind);
  for (const char* fill : {"spiral", "zigzag"}) {
    SCOPED_TRACE(fill);
    const RecordedPlan planned = plan_recorded("beachbot", problem, {{"fill", std::string(fill)}});
    EXPECT_NEAR(planned.figures.at("over_finished_m"), 0, 1e-3);
    for (const FilledArea& area : drawing.areas) EXPECT_GE(covered_share(area, planned.path, problem.robot()), 0.99);
  }
}

// Narrow parts of the tool fill the corners of an area before the whole tool covers what lies between them.
TEST(Beachbot, CornersComeBeforeTheFill) {
  Drawing drawing;
  drawing.areas.push_back({.element = "box", .area = {{{2, 2}, {3, 2}, {3, 3}, {2, 3}}, {}}, .choice = {}});
  const DrawingKind kind{.width = 6, .height = 6};
  const Problem problem = canvas(drawing, beach_robot(), kind);
  const RecordedPlan planned = plan_recorded("beachbot", problem);
  bool whole = false;
  std::size_t narrow = 0;
  for (const Leg& leg : planned.path.legs) {
    if (!leg.tool) continue;
    const bool wide = leg.width == problem.robot().tool_width;
    EXPECT_FALSE(whole && !wide);
    whole = whole || wide;
    narrow += wide ? 0 : 1;
  }
  EXPECT_TRUE(whole);
  EXPECT_GE(narrow, 4u);
  EXPECT_LE(planned.figures.at("over_finished_m"), 1e-9);
}

TEST(Beachbot, TheSameBytesAgain) {
  for (const auto seed : seeds(1)) {
    SCOPED_TRACE(seed);
    const Drawing drawing = DrawingGenerator(seed, {}).drawing();
    const Path one = plan("beachbot", canvas(drawing, beach_robot())),
               two = plan("beachbot", canvas(drawing, beach_robot()));
    ASSERT_EQ(one.legs.size(), two.legs.size());
    for (std::size_t k = 0; k < one.legs.size(); ++k) EXPECT_EQ(one.legs[k].points, two.legs[k].points);
  }
}

// Every bend of the path is one that the radius allows, or was reported.
TEST(Beachbot, KeepsTheLeastTurningRadius) {
  for (const auto seed : seeds(3)) {
    SCOPED_TRACE(seed);
    DrawingKind kind{.polylines = 4, .closed = 2, .nested = 1, .letters = 2, .areas = 0};
    const Drawing drawing = DrawingGenerator(seed, kind).drawing();
    const Problem problem = canvas(drawing, beach_robot(0.3), kind);
    const RecordedPlan planned = plan_recorded("beachbot", problem);
    expect_no_jump(problem, planned.path);
    if (planned.figures.at("sharp_bends") > 0) continue;
    Polyline all;
    for (const Leg& leg : planned.path.legs)
      for (const Point& p : leg.points)
        if (all.empty() || distance(p, all.back()) > 1e-9) all.push_back(p);
    for (std::size_t k = 1; k + 1 < all.size(); ++k) {
      const Point a = all[k] - all[k - 1], b = all[k + 1] - all[k];
      const double turn = std::abs(std::atan2(cross(a, b), a.dot(b)));
      EXPECT_LE(turn, 0.35) << to_text(all[k]);  // radians: chords of curves only
    }
  }
}

/// Sharper than the robot can drive.
double sharp_bends(const Problem& problem, const Path& path) {
  double count = 0;
  for (const Bend& bend : bends(path, problem.tolerance(), problem.robot().tool_width))
    count += too_sharp(bend, problem.robot().min_turn_radius);
  return count;
}

// Wherever it is: between strokes, inside one, inside a fill.
TEST(Beachbot, EachBendThatIsTooSharpIsNamed) {
  for (const auto seed : seeds(2)) {
    SCOPED_TRACE(seed);
    DrawingKind kind{.polylines = 2, .closed = 1, .nested = 2, .letters = 1, .areas = 2};
    const Problem problem = canvas(DrawingGenerator(seed, kind).drawing(), beach_robot(0.4), kind);
    const RecordedPlan planned = plan_recorded("beachbot", problem);
    EXPECT_EQ(planned.figures.at("sharp_bends"), sharp_bends(problem, planned.path));
    EXPECT_EQ(planned.traces.count("sharp bends"), 1u);
  }
}

TEST(Beachbot, FillsKeepTheLeastTurningRadius) {
  for (const auto seed : seeds(2))
    for (const double radius : {0.1, 0.5}) {
      SCOPED_TRACE(fmt::format("seed {}, radius {}", seed, radius));
      DrawingKind kind{.polylines = 0, .closed = 0, .nested = 0, .letters = 0, .areas = 2};
      const Drawing drawing = DrawingGenerator(seed, kind).drawing();
      const Problem problem = canvas(drawing, beach_robot(radius), kind);
      const RecordedPlan planned = plan_recorded("beachbot", problem);
      expect_no_jump(problem, planned.path);
      EXPECT_EQ(sharp_bends(problem, planned.path), 0);
      for (const FilledArea& area : drawing.areas)
        EXPECT_GE(covered_share(area, planned.path, problem.robot()), radius < 0.2 ? 0.95 : 0.8);
    }
}

TEST(Beachbot, AMapWithoutADrawingIsFilled) {
  const Problem hall(Map{"hall", box_region({0, 0}, {6, 4}), "", ""}, Robot{}, Point(1, 1));
  const Path path = plan("beachbot", hall);
  expect_valid(hall, path);
  EXPECT_LE(uncovered_share(hall, path, 500), 2e-3);
}

TEST(Beachbot, AStrokeWithoutLengthIsOneSentence) {
  Drawing drawing;
  drawing.strokes = {line("dot", {{1, 1}, {1, 1}})};
  EXPECT_THAT([&] { plan("beachbot", canvas(drawing, beach_robot())); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("stroke 0 ('dot') has no length")));
}

// Nothing that a person asks for is left out in silence.
TEST(Beachbot, WhatCannotBeDrawnIsNamed) {
  Drawing drawing;
  drawing.strokes = {line("eye", {{1, 1}, {3, 1}}), line("ear", {{8, 6}, {10, 6}})};
  const auto draw = [&] { plan("beachbot", canvas(drawing, beach_robot())); };
  drawing.curves = {{.from = {"eye", -1}, .to = {"ear", 0}, .kind = DrawnCurve::Kind::bezier, .points = {{-30, 4}}}};
  EXPECT_THAT(draw, ThrowsMessage<std::invalid_argument>(::testing::AllOf(
                        HasSubstr("the curve between elements '"), HasSubstr("leaves configuration space at ("))));
  drawing.curves[0].points = {{1e300, 4}};
  EXPECT_THAT(draw, ThrowsMessage<std::invalid_argument>(HasSubstr("which is far off the map")));
  drawing.curves.clear();
  drawing.strokes.push_back(line("tail", {{5, 5}, {5, 0.1}}));
  EXPECT_THAT(draw, ThrowsMessage<Infeasible>(HasSubstr("stroke 'tail' leaves configuration space at (5, ")));
  drawing.strokes.back().line = 7;
  EXPECT_THAT(draw, ThrowsMessage<Infeasible>(
                        ::testing::AllOf(HasSubstr("stroke 'tail' (line 7) leaves"), HasSubstr("--margin"))));
  drawing.strokes.pop_back();
  drawing.start = Point(40, 1);
  EXPECT_THAT(draw, ThrowsMessage<Infeasible>(HasSubstr("start (40, 1) is outside")));
}

// A curve is a demand for its connection.
TEST(Beachbot, CurvesAreDriven) {
  Drawing drawing;
  drawing.strokes = {line("a", {{1, 1}, {3, 1}}), line("b", {{8, 6}, {10, 6}}), line("c", {{3.5, 1}, {5, 1}})};
  drawing.curves = {{.from = {"a", -1}, .to = {"b", 0}, .kind = DrawnCurve::Kind::spiro, .points = {{4, 5}}}};
  const RecordedPlan planned = plan_recorded("beachbot", canvas(drawing, beach_robot()));
  EXPECT_EQ(planned.figures.at("curves_obeyed"), 1);
  double nearest = 1;
  for (const Leg& leg : planned.path.legs)
    for (std::size_t k = 1; k < leg.points.size() && !leg.tool; ++k)
      nearest = std::min(nearest, distance_to_segment({4, 5}, leg.points[k - 1], leg.points[k]));
  EXPECT_LT(nearest, 1e-3);
}

TEST(Beachbot, NarrowAreasAreFilledWithAPartOfTheTool) {
  for (const auto& [wide, width] : {std::pair(0.4, 0.32), std::pair(0.2, 0.16), std::pair(0.08, 0.04)}) {
    Drawing drawing;
    drawing.areas = {{.element = "bar", .area = box_region({2, 2}, {6, 2 + wide}).polygons[0], .choice = {}}};
    const RecordedPlan planned = plan_recorded("beachbot", canvas(drawing, beach_robot()));
    EXPECT_EQ(planned.figures.count("areas_too_narrow"), 0u);
    EXPECT_GT(drawn_m(planned.path, planned.path.legs.back().width), 3.5);
    EXPECT_NEAR(planned.path.legs.back().width, width, 1e-12);
  }
  Drawing drawing;
  drawing.strokes = {line("eye", {{1, 1}, {3, 1}})};
  drawing.areas = {{.element = "sliver", .area = box_region({2, 2}, {6, 2.03}).polygons[0], .choice = {}}};
  EXPECT_EQ(plan_recorded("beachbot", canvas(drawing, beach_robot()), {{"thin_areas", std::string("skip")}})
                .figures.at("areas_too_narrow"),
            1);
  for (const double radius : {0.0, 0.5}) {
    Robot robot = beach_robot();
    robot.min_turn_radius = radius;
    const RecordedPlan thin = plan_recorded("beachbot", canvas(drawing, robot));
    EXPECT_EQ(thin.figures.count("areas_too_narrow"), 0u);
    EXPECT_EQ(thin.figures.at("areas_with_thin_lines"), 1);
    EXPECT_NEAR(drawn_m(thin.path, 0.04), 3.97, 0.01);
  }
}

// Round areas in which hardly more than a point is left for the centre of what fits of the tool.
TEST(Beachbot, DotsAreFilledByALap) {
  for (const double radius : {0.13, 0.2, 0.28}) {
    Ring dot;
    for (int k = 0; k < 48; ++k) dot.push_back(Point(3, 3) + rotated({radius, 0}, 2 * kPi * k / 48));
    Drawing drawing;
    drawing.areas = {{.element = "dot", .area = {dot, {}}, .choice = {}}};
    const Path path = plan("beachbot", canvas(drawing, beach_robot()));
    std::vector<Region> drawn;
    for (const Leg& leg : path.legs)
      if (leg.tool) drawn.push_back(swath({leg.points}, leg.width / 2, 1e-4, Bound::inside));
    EXPECT_GT(oxturn::area(intersect(unite(drawn), {{{dot, {}}}})), 0.98 * oxturn::area(Region{{{dot, {}}}})) << radius;
    EXPECT_LT(oxturn::area(subtract(unite(drawn), Region{{{dot, {}}}})), 1e-6) << radius;
    EXPECT_LT(length(path.legs.back().points), 2 * kPi * radius) << radius;
  }
}

// A narrow part of the tool fills the points of a star; the wide part's area about them is not its concern.
TEST(Beachbot, NarrowPartsDriveNoFartherThanTheyReach) {
  Ring star;
  for (int k = 0; k < 16; ++k) star.push_back(Point(3, 3) + rotated({k % 2 == 0 ? 0.78 : 0.213, 0}, kPi / 8 * k));
  Drawing drawing;
  drawing.areas = {{.element = "star", .area = {star, {}}, .choice = {}}};
  const Path path = plan("beachbot", canvas(drawing, beach_robot()));
  double worked = 0;
  for (const Leg& leg : path.legs)
    if (leg.tool) worked += leg.width * length(leg.points);
  EXPECT_LT(worked, 2.5 * oxturn::area(Region{{{star, {}}}})) << worked;
}

// The serifs of a letter, a little longer than the narrowest part of the tool is wide.
TEST(Beachbot, ShortThinTipsAreDrawnWhereTheyAreMuchOfAnArea) {
  const Region letter = unite(
      {box_region({3, 3}, {3.1, 3.5}), box_region({2.955, 3}, {3.145, 3.02}), box_region({2.955, 3.48}, {3.145, 3.5})});
  Drawing drawing;
  drawing.areas = {{.element = "I", .area = letter.polygons[0], .choice = {}}};
  std::vector<Region> drawn;
  for (const Leg& leg : plan("beachbot", canvas(drawing, beach_robot())).legs)
    if (leg.tool) drawn.push_back(swath({leg.points}, leg.width / 2, 1e-4, Bound::inside));
  EXPECT_GT(oxturn::area(intersect(unite(drawn), letter)), 0.98 * oxturn::area(letter));
}

}  // namespace
}  // namespace oxturn
