// Paths in any format, and the problems that they name.
#include "maps/path_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/files.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShownOfHash = 12;  // digits, in messages

bool is_csv(const std::string& file, const std::string& text) {
  const std::string suffix = suffix_of(file);
  if (suffix == ".csv") return true;
  if (suffix == ".geojson" || suffix == ".json") return false;
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == std::string::npos || text[first] != '{';
}

}  // namespace

PathFile read_path_file(const std::string& file) {
  const std::string text = read_file(file);
  return is_csv(file, text) ? PathFile{path_from_csv(text, file), {}} : path_from_geojson(text, file);
}

PathProblem path_problem(const Problem& problem, MapSource source) {
  return {std::move(source), content_hash(problem.map()), problem.robot(), problem.start(), problem.anchor()};
}

MapFile load_map(const PathProblem& problem, const std::string& path_file, const Generators& generators,
                 const MapFormats& formats) {
  MapSource source = problem.source;
  for (std::string* name : {&source.file, &source.target})
    if (!name->empty()) *name = (fs::path(path_file).parent_path() / *name).lexically_normal().string();
  const std::string name = source.file.empty() ? source.generator : source.file;
  MapFile file;
  try {
    file = load_map(source, generators, formats);
  } catch (const std::invalid_argument& e) {
    throw_invalid("{}: the map that it was made for cannot be loaded: {}; give MAP", path_file, e.what());
  }
  if (const std::string hash = content_hash(file.map); hash != problem.map_sha256)
    throw_invalid("{}: it was made for another map than '{}' is now (SHA-256 {}..., expected {}...); give MAP",
                  path_file, name, hash.substr(0, kShownOfHash), problem.map_sha256.substr(0, kShownOfHash));
  file.robot = problem.robot;
  file.start = problem.start;
  file.anchor = problem.anchor;
  return file;
}

}  // namespace oxturn
