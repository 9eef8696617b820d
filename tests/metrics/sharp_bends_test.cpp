#include "metrics/sharp_bends.hpp"

#include <gmock/gmock.h>

#include "maps/drawing.hpp"

namespace oxturn {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// A path that turns on the spot in the middle of the canvas, and near its edge.
TEST(SharpBends, NameTheStrokeItsLineAndTheMend) {
  Drawing drawing;
  drawing.strokes = {{"ear", {{10, 7}, {10, 8}}, 0.1, true, {}, {}, 12},
                     {"tail", {{19, 7}, {19.5, 7}}, 0.1, true, {}, {}}};
  Map map{"canvas", box_region({0, 0}, {20, 15}), "test", ""};
  map.drawing = std::make_shared<const Drawing>(drawing);
  Robot robot;
  robot.radius = 0.2;
  robot.tool_width = 0.4;
  robot.min_turn_radius = 0.5;
  const Path path{
      {{true, {{10, 7}, {10, 8}, {11, 8}}}, {false, {{11, 8}, {18, 8}}}, {true, {{18, 8}, {19.5, 8}, {19.5, 7}}}}};
  const Problem problem(map, robot, Point(10, 7));
  const std::vector<std::string> said = remarks_on_sharp_bends(problem, path);
  ASSERT_EQ(said.size(), 2u);
  EXPECT_THAT(said[0], AllOf(HasSubstr("at (10.00, 8.00), stroke 'ear' (line 12)"), Not(HasSubstr("--margin"))));
  EXPECT_THAT(said[1],
              AllOf(HasSubstr("stroke 'tail', the path"), HasSubstr("a margin of 1.7 m"), HasSubstr("--margin")));
  robot.min_turn_radius = 0;
  EXPECT_TRUE(remarks_on_sharp_bends(Problem(map, robot, Point(10, 7)), path).empty());
}

}  // namespace
}  // namespace oxturn
