// cli/suites.cpp
#include "cli/suites.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "base/files.hpp"
#include "base/parameters.hpp"
#include "base/text.hpp"
#include "maps/formats.hpp"

namespace oxturn::cli {
namespace {

namespace fs = std::filesystem;

fs::path suites_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path().parent_path() / "share" / "oxturn" / "suites";
    if (fs::is_directory(installed, error)) return installed;
  }
  const fs::path source = fs::path(OXTURN_SOURCE_DIR) / "bench" / "suites";
  return fs::is_directory(source, error) ? source : fs::path();
}

std::string first_comment(const std::string& text) {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line.front() != '#') break;
    const std::size_t at = line.find_first_not_of("# ");
    if (at != std::string::npos) return line.substr(at);
  }
  return "";
}

}  // namespace

std::vector<SuiteFile> suite_files() {
  std::vector<SuiteFile> all;
  const fs::path folder = suites_folder();
  if (folder.empty()) return all;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml")
      all.push_back(
          {entry.path().stem().string(), entry.path().string(), first_comment(read_file(entry.path().string()))});
  std::sort(all.begin(), all.end(), [](const SuiteFile& a, const SuiteFile& b) { return a.name < b.name; });
  return all;
}

std::string find_suite(const std::string& name) {
  std::error_code error;
  if (name == kStandardStream || fs::exists(name, error) || name.find_first_of("./") != std::string::npos) return name;
  std::vector<std::string> names;
  for (const SuiteFile& suite : suite_files()) {
    if (suite.name == name) return suite.file;
    names.push_back(suite.name);
  }
  if (names.empty()) return name;
  throw std::invalid_argument(unknown_name("file and no suite", name, names));
}

}  // namespace oxturn::cli
