// The same bytes on every machine: the C library has several versions of its mathematical functions and takes the
// fastest one that the processor knows, with or without fused multiplication and addition. Their last bits differ;
// paths must not.
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

constexpr const char* kPlainFunctions = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX2_Usable,-FMA_Usable ";

constexpr const char* kMaps = R"([[maps]]
generator = ["clutter", "cave", "polygon"]
width = 8
height = 6
)";

std::string suite_of(const std::string& robot, const std::string& planners) {
  return "schema = 1\nname = \"bytes\"\n[robots.robot]\nradius = 0.2\ntool_width = 0.4\n" + robot + kMaps +
         "[[planners]]\nname = [" + planners + "]\n";
}

/// `paths` of them.
void expect_same_paths(const std::string& suite_text, std::size_t paths) {
  const Folder folder;
  const std::string suite = folder.write("suite.toml", suite_text);
  const std::string run = " run " + suite + " -q --no-pictures -o ";
  ASSERT_EQ(shell("oxturn" + run + (folder / "fast")).code, 0);
  ASSERT_EQ(shell(kPlainFunctions + ("'" OXTURN_PROGRAM "'" + run) + (folder / "plain")).code, 0);
  const Said listed =
      shell("cd " + (folder / "fast/paths") + " && ls | wc -l && diff -rq . " + (folder / "plain/paths"));
  EXPECT_EQ(listed.code, 0) << listed.out;
  EXPECT_EQ(listed.out, std::to_string(paths) + "\n");
}

TEST(MathLibrary, PathsDoNotDependOnItsVersion) {
  expect_same_paths(
      suite_of("", R"("contour", "stc-loops", "hyun", "completed", "connected-fermat", "oarp", "random-walk",
                                    "smooth-spiral", "skeleton-spiral", "field", "field-predictive", "vacuum-mix")"),
      36);
}

TEST(MathLibrary, PathsOfCarsDoNotDependOnItsVersion) {
  expect_same_paths(suite_of("min_turn_radius = 0.3\nreverse = true\n", R"("boustrophedon")"), 3);
}

TEST(MathLibrary, PathsOfTetheredRobotsDoNotDependOnItsVersion) {
  expect_same_paths(suite_of("tether = { reach = 1.1 }\n", R"("leashed", "berg", "berg-complete", "shnaps-rimon")"),
                    12);
}

TEST(MathLibrary, AnnealedPathsDoNotDependOnItsVersion) {
  expect_same_paths(suite_of("", R"("shortest"]
moves = 50000
objective = ["length", "time")"),
                    6);
}

}  // namespace
}  // namespace oxturn
