// What it costs to cover everything, and not nearly everything.
#include <gtest/gtest.h>

#include "algorithms/improve/improve.hpp"
#include "coverage_oracle.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"

namespace oxturn {
namespace {

// Detours for all that the first runs leave, of which annealing removed few, once made this path 11 % longer.
TEST(Shortest, CoveringEverythingCostsLittleMore) {
  const Problem clutter(generate("clutter", {{"width", 10.0}, {"height", 8.0}}, 101), disc(0.2, 0.4));
  const Path nearly = plan("shortest", clutter, {{"coverage", 0.9999}, {"moves", 300000}});
  const Path whole = plan("shortest", clutter, {{"coverage", 1.0}, {"moves", 300000}});
  EXPECT_GE(*score(clutter, whole).value("coverage"), 0.9999);
  EXPECT_LT(whole.length(), 1.085 * nearly.length());
}

}  // namespace
}  // namespace oxturn
