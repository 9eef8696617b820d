// oxturn and Shapely score the same files: independent_scorer.py shares no code with us.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "maps/formats.hpp"
#include "maps/path_file.hpp"
#include "metrics/score.hpp"
#include "shapes.hpp"

namespace oxturn {
namespace {

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  char buffer[4096];
  while (const std::size_t n = std::fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  pclose(pipe);
  return text;
}

TEST(Agreement, WithShapely) {
  const auto folder = std::filesystem::temp_directory_path() / ("oxturn-agreement-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string map = (folder / "map.geojson").string(), line = (folder / "path.geojson").string();
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Path path = random_walk(rng, Box{{0.6, 0.6}, {9.4, 1.4}}, 3, 30, 2);
    const double tool = seed % 2 ? 0.4 : 1.5;  // the second reaches over walls
    const Problem p = problem_in(two_holes(), path.legs[0].points[0], seed % 3 == 0 ? 0.0 : 0.2, tool);
    write_file(map, to_geojson(p));
    write_file(line, to_geojson(path));
    const std::string said = output_of(std::string("/usr/bin/python3 ") + OXTURN_SOURCE_DIR +
                                       "/tests/metrics/independent_scorer.py --path " + line + " --problem " + map);
    const auto theirs = nlohmann::json::parse(said, nullptr, false);
    ASSERT_TRUE(theirs.is_object()) << "needs python3-shapely; it said: " << said;
    const Score ours = score(p, path);
    EXPECT_GE(theirs["coverage"].get<double>(), *ours.value("coverage_lower") - 2e-4);
    EXPECT_LE(theirs["coverage"].get<double>(), *ours.value("coverage_upper") + 2e-4);
    EXPECT_NEAR(theirs["path_m"].get<double>(), *ours.value("path_m"), 1e-9 * *ours.value("path_m"));
    EXPECT_NEAR(theirs["target_m2"].get<double>(), *ours.value("target_m2"), p.target_excess() + 2e-4 * 70);
    EXPECT_NEAR(theirs["clearance_m"].get<double>(), *ours.value("clearance_m"), 1e-9);
    EXPECT_EQ(ours.flaw, "");
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace oxturn
