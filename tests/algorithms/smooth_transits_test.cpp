#include "algorithms/drawing/smooth_transits.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"
#include "geometry/bends.hpp"

namespace oxturn {
namespace {

/// Where nothing is in the way, as for the drawing robot.
TEST(SmoothTransits, NoBendIsSharperThanTheRadius) {
  Robot robot;
  robot.radius = 0.2, robot.tool_width = 0.42;
  const Problem problem(Map{"canvas", Region{{{{{0, 0}, {30, 0}, {30, 30}, {0, 30}}, {}}}}, "test", ""}, robot,
                        Point(1, 1));
  const FinishedWork work({}, 0);
  Rng rng(1);
  for (const double radius : {0.3, 0.5, 1.0}) {
    const SmoothTransits smooth(problem, work, {.radius = radius});
    for (int k = 0; k < 100; ++k) {
      const auto pose = [&] {
        return Pose{{rng.between(10.0, 16.0), rng.between(10.0, 16.0)}, rng.between(0.0, 6.28)};
      };
      const Pose from = pose(), to = pose();
      const SmoothTransit t = smooth.find(from, to, {from.at, to.at});
      ASSERT_TRUE(t.keeps_radius);
      for (const Bend& bend : bends({{{false, t.path}}}, problem.tolerance(), robot.tool_width))
        ASSERT_FALSE(too_sharp(bend, radius)) << radius << ", pair " << k;
    }
  }
}

}  // namespace
}  // namespace oxturn
