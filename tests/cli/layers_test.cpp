// Folders depend downwards only, told by reading the includes.
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

const std::vector<std::string> kRooms{"geometry", "maps", "algorithms", "metrics", "bench", "reports", "cli"};

struct Include {
  std::string file, name;  // "maps/problem.cpp", "geometry/region.hpp"
  bool quoted = false;
  std::string room() const { return file.substr(0, file.find('/')); }
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

long rank(const std::string& room) { return std::find(kRooms.begin(), kRooms.end(), room) - kRooms.begin(); }
long unknown() { return static_cast<long>(kRooms.size()); }

TEST(Layers, FindTheSources) { EXPECT_GT(includes().size(), 200u); }

TEST(Layers, AFolderIncludesOnlyItselfAndThoseBeforeIt) {
  for (const Include& include : includes()) {
    if (!include.quoted) continue;
    const std::string room = include.name.substr(0, include.name.find('/'));
    EXPECT_LT(rank(room), unknown()) << include.file << " includes \"" << include.name
                                     << "\": write it from the project's root";
    EXPECT_LE(rank(room), rank(include.room())) << include.file << " includes " << include.name;
    EXPECT_TRUE(fs::exists(fs::path(OXTURN_SOURCE_DIR) / include.name)) << include.file << " includes " << include.name;
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
    if (!foreign(include)) continue;
    EXPECT_TRUE(include.room() == "geometry" && include.file.ends_with(".cpp"))
        << include.file << " includes <" << include.name << ">";
  }
}

// Two types of one name share their templates' code as far as the linker sees: vectors of one would run on the other's size.
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
    const std::size_t from = text.find("HEADERS"), to = text.find("SOURCES");
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
