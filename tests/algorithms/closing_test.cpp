// How `shortest` closes paths to full and nearly full coverage.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/improve/improve.hpp"
#include "coverage_oracle.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Problem crowded(const std::string& kind, std::uint64_t seed) {
  return {generate(kind, {{"width", 10.0}, {"height", 8.0}}, seed), disc(0.2, 0.4)};
}

// Nearly all of the target: certified, and not much more than asked for where the target is known well.
TEST(Shortest, CoversHardlyMoreThanItIsAskedFor) {
  for (const auto seed : seeds(3)) {
    SCOPED_TRACE(seed);
    const Problem problem = crowded("clutter", seed);
    const Score s = score(problem, plan("shortest", problem, {{"coverage", 0.9999}, {"moves", 20000}}));
    EXPECT_GE(*s.value("coverage_lower"), 0.9999);
    EXPECT_LE(*s.value("coverage_upper"), 1 - 2.5e-5);
  }
}

// Detours for all that the first runs leave uncovered would make the path longer, and annealing would not undo that.
TEST(Shortest, ClosesByAnnealingFirst) {
  double product = 1;
  const std::vector<std::pair<const char*, std::uint64_t>> maps{{"clutter", 101}, {"clutter", 102}, {"cave", 101}};
  for (const auto& [kind, seed] : maps) {
    const Problem problem = crowded(kind, seed);
    const Path path = plan("shortest", problem, {{"coverage", 0.9999}, {"moves", 150000}});
    expect_valid(problem, path);
    product *= *score(problem, path).value("length_ratio");
  }
  EXPECT_LT(std::pow(product, 1 / 3.0), 1.205);
}

// Detours for all that the first runs leave, of which annealing removed few, once made this path 11 % longer.
TEST(Shortest, CoveringEverythingCostsLittleMore) {
  const Problem clutter = crowded("clutter", 101);
  const Path nearly = plan("shortest", clutter, {{"coverage", 0.9999}, {"moves", 300000}});
  const Path whole = plan("shortest", clutter, {{"coverage", 1.0}, {"moves", 300000}});
  EXPECT_GE(*score(clutter, whole).value("coverage"), 0.9999);
  EXPECT_LT(whole.length(), 1.085 * nearly.length());
}

}  // namespace
}  // namespace oxturn
