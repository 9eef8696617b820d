#include "algorithms/drawing/stroke_copies.hpp"

#include <gtest/gtest.h>

#include "coverage_oracle.hpp"
#include "tests/support/drawings.hpp"

namespace oxturn {
namespace {

DrawnStroke stroke(Polyline points) {
  DrawnStroke s;
  s.element = "s";
  s.points = std::move(points);
  s.width = 0.04;
  return s;
}

TEST(StrokeCopies, HaveTheSamePointsInEitherDirection) {
  const Polyline line{{1, 1}, {2, 1}, {2, 2}}, turned{{2, 2}, {2, 1}, {1, 1}}, other{{1, 1}, {2, 1}, {2, 3}};
  Drawing drawing;
  for (const Polyline& p : {other, turned, line, turned}) drawing.strokes.push_back(stroke(p));
  const auto groups = stroke_copies(stroke_elements(drawing));
  ASSERT_EQ(groups.size(), 2u);
  ASSERT_EQ(groups[0].size(), 1u);
  ASSERT_EQ(groups[1].size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(groups[1][k].element, k + 1);
    EXPECT_EQ(groups[1][k].turned, k == 1);
  }
}

// Open ones there and back, closed ones round and round.
TEST(StrokeCopies, AreDrawnOneAfterTheOther) {
  const Polyline line{{3, 3}, {5, 3}}, ring{{8, 3}, {9, 3}, {9, 4}, {8, 3}};
  for (const std::size_t copies : {3u, 4u, 300u}) {
    Drawing drawing;
    for (std::size_t k = 0; k < copies; ++k) {
      drawing.strokes.push_back(stroke(line));
      drawing.strokes.push_back(stroke(ring));
    }
    const Path path = plan("beachbot", canvas(drawing, beach_robot()));
    double up = 0, drawn = 0;
    for (const Leg& leg : path.legs) (leg.tool ? drawn : up) += length(leg.points);
    EXPECT_NEAR(drawn, static_cast<double>(copies) * (2 + length(ring)), 1e-6);
    // From the start to the line, from there to the ring: an odd number of lines ends where it is nearer.
    const double from_start = distance(path.legs.front().points.front(), path.legs.front().points.back());
    EXPECT_LT(up, from_start + (copies % 2 == 0 ? 5.1 : 3.1)) << copies;
  }
}

}  // namespace
}  // namespace oxturn
