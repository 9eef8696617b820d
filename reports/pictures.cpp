// reports/pictures.cpp
// Cost: one erosion a problem (runs of one problem share it while they follow each other), then linear.
#include "reports/pictures.hpp"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "maps/formats.hpp"
#include "maps/problem.hpp"
#include "base/files.hpp"
#include "geometry/trace.hpp"
#include "maps/path_file.hpp"
#include "maps/picture.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// The path file's foreign member "problem": the problem's file, relative to the results folder.
std::string problem_of(const std::string& text, const std::string& source) {
  const Json path = Json::parse(text, nullptr, false);
  if (!path.is_object() || !path.contains("problem") || !path["problem"].is_string())
    throw std::invalid_argument(source +
                                ": no member 'problem' that names the problem's file, as `oxturn run` writes it");
  return path["problem"].get<std::string>();
}

Problem read_problem(const std::string& file) {
  MapFile map = read_map(file);
  return Problem(std::move(map.map), map.robot.value_or(Robot{}), map.start, map.anchor);
}

std::vector<Trace> read_traces(const std::string& file) {
  std::vector<Trace> traces;
  if (!fs::exists(file)) return traces;
  try {
    const Json json = Json::parse(read_file(file));
    for (const Json& item : json) {
      Trace trace{item.at("name").get<std::string>(), {}};
      for (const Json& line : item.at("lines")) {
        Polyline points;
        for (const Json& p : line) points.emplace_back(p.at(0).get<double>(), p.at(1).get<double>());
        trace.lines.push_back(std::move(points));
      }
      traces.push_back(std::move(trace));
    }
  } catch (const Json::exception&) {
    throw std::invalid_argument(file + ": not a list of {name, lines}, as `oxturn run` writes it");
  }
  return traces;
}

}  // namespace

Pictures draw_runs(const Results& results, const std::function<void(const std::string&, const std::string&)>& write) {
  const fs::path folder = results.folder;
  Pictures pictures;
  std::string problem_file;
  std::unique_ptr<const Problem> problem;
  for (const Row& row : results.rows) {
    if (row.get("path_file").empty()) continue;
    const std::string run = row.get("run_id"), path_file = (folder / row.get("path_file")).string();
    const std::string text = read_file(path_file);
    const Path path = path_from_geojson(text, path_file);
    const std::string wanted = (folder / problem_of(text, path_file)).string();
    if (!problem || wanted != problem_file) {
      problem = std::make_unique<const Problem>(read_problem(wanted));
      problem_file = wanted;
    }
    const std::vector<Trace> traces = read_traces((folder / "traces" / (run + ".json")).string());
    PictureOptions options;
    options.traces = &traces;
    const std::string name = "gallery/" + run + ".svg";
    write(name, to_svg(*problem, &path, options));
    pictures[run] = name;
  }
  return pictures;
}

}  // namespace oxturn
