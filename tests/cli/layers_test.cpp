// Folders depend downwards only: the includes are read.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kRooms{"base", "geometry", "maps", "algorithms", "metrics", "bench", "reports", "cli"};

/// Every folder of sources, in the order in which data flow: a folder includes only itself and those before it.
const std::vector<std::string> kFolders{"base",
                                        "geometry",
                                        "geometry/overlay",
                                        "geometry/mesh",
                                        "geometry/paths",
                                        "geometry/tether",
                                        "maps",
                                        "maps/formats",
                                        "maps/drawings",
                                        "maps/generators",
                                        "algorithms",
                                        "algorithms/transit",
                                        "algorithms/tour",
                                        "algorithms/lanes",
                                        "algorithms/improve",
                                        "algorithms/lattice",
                                        "algorithms/smoothing",
                                        "algorithms/online",
                                        "algorithms/grid",
                                        "algorithms/polygon",
                                        "algorithms/tethered",
                                        "algorithms/drawing",
                                        "algorithms/baseline",
                                        "metrics",
                                        "bench",
                                        "bench/check",
                                        "reports",
                                        "reports/tables",
                                        "reports/viewer",
                                        "bench/micro",
                                        "cli"};
/// They stand side by side: none includes another.
const std::vector<std::vector<std::string>> kSiblings{
    {"algorithms/grid", "algorithms/polygon", "algorithms/tethered", "algorithms/drawing", "algorithms/baseline"},
    {"maps/formats", "maps/generators"}};

struct Include {
  std::string file, name;  // "maps/problem.cpp", "geometry/region.hpp"
  bool quoted = false;
  std::string room() const { return file.substr(0, file.find('/')); }
  std::string folder() const { return fs::path(file).parent_path().generic_string(); }
  std::string included_folder() const { return fs::path(name).parent_path().generic_string(); }
};

/// f(file, line) for every line of every source.
template <class F>
void for_each_line(F f) {
  const fs::path root = OXTURN_SOURCE_DIR;
  for (const std::string& room : kRooms)
    for (const auto& entry : fs::recursive_directory_iterator(root / room)) {
      const std::string suffix = entry.path().extension().string();
      if (suffix != ".hpp" && suffix != ".cpp") continue;
      const std::string file = fs::relative(entry.path(), root).generic_string();
      std::ifstream in(entry.path());
      for (std::string line; std::getline(in, line);) f(file, line);
    }
}

std::vector<Include> includes() {
  static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
  std::vector<Include> all;
  for_each_line([&](const std::string& file, const std::string& line) {
    if (std::smatch found; std::regex_search(line, found, pattern)) all.push_back({file, found[2], found[1] == "\""});
  });
  return all;
}

std::size_t rank(const std::string& folder) {
  return static_cast<std::size_t>(std::find(kFolders.begin(), kFolders.end(), folder) - kFolders.begin());
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(Layers, FindTheSources) { EXPECT_GT(includes().size(), 200u); }

TEST(Layers, AFolderIncludesOnlyItselfAndThoseBeforeIt) {
  for (const Include& include : includes()) {
    if (!include.quoted || include.name.starts_with("tests/")) continue;
    if (include.name == "build_revision.hpp" || include.name == "bench/plugin_headers.hpp")
      continue;  // made by the build
    const std::string said = include.file + " includes \"" + include.name + "\"";
    EXPECT_LT(rank(include.folder()), kFolders.size()) << include.file << ": list its folder in kFolders";
    EXPECT_LT(rank(include.included_folder()), kFolders.size()) << said << ": write it from the project's root";
    EXPECT_LE(rank(include.included_folder()), rank(include.folder())) << said;
    EXPECT_TRUE(fs::exists(fs::path(OXTURN_SOURCE_DIR) / include.name)) << said;
  }
}

TEST(Layers, FamiliesDoNotIncludeEachOther) {
  for (const Include& include : includes())
    for (const auto& siblings : kSiblings)
      if (holds(siblings, include.folder()) && holds(siblings, include.included_folder())) {
        EXPECT_EQ(include.folder(), include.included_folder()) << include.file << " includes " << include.name;
      }
}

TEST(Layers, MetricsKnowNothingOfAlgorithms) {
  for (const Include& include : includes())
    if (include.room() == "metrics") { EXPECT_NE(include.name.rfind("algorithms/", 0), 0u) << include.file; }
}

bool foreign(const Include& include) {
  return include.name.rfind("CGAL/", 0) == 0 || include.name.rfind("polyclipping/", 0) == 0 ||
         include.name.find("clipper") != std::string::npos;
}

TEST(Layers, CgalAndClipperStayInGeometrysSources) {
  for (const Include& include : includes()) {
    if (!foreign(include) || include.file == "bench/micro/alternatives_bench.cpp") continue;  // compares with them
    EXPECT_TRUE(include.room() == "geometry" && include.file.ends_with(".cpp"))
        << include.file << " includes <" << include.name << ">";
  }
}

TEST(Layers, OmplStaysInSourcesOfSmoothing) {
  for (const Include& include : includes()) {
    if (include.name.rfind("ompl/", 0) != 0) continue;
    EXPECT_TRUE(include.folder() == "algorithms/smoothing" && include.file.ends_with(".cpp"))
        << include.file << " includes <" << include.name << ">";
  }
}

// Two types of one name share their templates' code as far as the linker sees: vectors of one would run on the other's
// size.
TEST(Layers, NoTypeNameIsTakenTwice) {
  static const std::regex type(R"(^(struct|class|enum class|enum) (\w+)( final)?( :[^:].*)?( \{.*)?$)");
  std::map<std::string, std::string> taken;
  bool anonymous = false;  // its end is at the end of the file at the latest
  for_each_line([&](const std::string& file, const std::string& line) {
    if (line == "namespace {") anonymous = true;
    if (line == "}  // namespace" || line == "namespace oxturn {") anonymous = false;
    std::smatch found;
    if (anonymous || !std::regex_search(line, found, type)) return;
    const auto [other, first] = taken.emplace(found[2], file);
    EXPECT_TRUE(first) << found[2] << " in " << file << " and in " << other->second;
  });
  EXPECT_GT(taken.size(), 150u);
}

// What is installed: the headers that each room's CMakeLists names. Internal headers may know more.
TEST(Layers, PublicHeadersShowOnlyStandardAndEigenTypes) {
  const fs::path root = OXTURN_SOURCE_DIR;
  std::size_t headers = 0;
  for (const std::string& room : kRooms) {
    const std::string text = content((root / room / "CMakeLists.txt").string());
    const std::size_t from = text.find("HEADERS"), to = std::min(text.find("USES", from), text.find("PRIVATE", from));
    if (from == std::string::npos || to == std::string::npos) continue;  // the program itself
    const std::string names = text.substr(from, to - from);
    for (const Include& include : includes()) {
      if (include.room() != room || !include.file.ends_with(".hpp")) continue;
      const std::string name = include.file.substr(room.size() + 1);
      if (!std::regex_search(names, std::regex("\\s" + std::regex_replace(name, std::regex(R"(\.)"), "\\.") + "\\s")))
        continue;
      ++headers;
      const bool standard =
          !include.quoted && include.name.find('/') == std::string::npos && include.name.find('.') == std::string::npos;
      EXPECT_TRUE(include.quoted || standard || include.name.rfind("Eigen/", 0) == 0)
          << include.file << " includes <" << include.name << ">";
    }
  }
  EXPECT_GT(headers, 20u);
}

}  // namespace
}  // namespace oxturn
