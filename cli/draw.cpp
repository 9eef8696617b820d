// oxturn draw: from a drawing to a path for the robot that draws it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "base/files.hpp"
#include "base/text.hpp"
#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/plan.hpp"
#include "maps/svg_drawing.hpp"

namespace oxturn::cli {
namespace {

struct Options {
  std::string canvas;  // "20x15"
  PlanOptions plan;
};

bool is_svg(const std::string& file) { return lower_case(std::filesystem::path(file).extension().string()) == ".svg"; }

/// "20x15" as the reader's options.
void set_canvas(const std::string& text, ReaderOptions& read) {
  const std::vector<std::string> sides = split(text, 'x');
  const auto metres = [](const std::string& side) { return parse_number(side).value_or(0); };
  if (sides.size() != 2 || !(metres(sides[0]) > 0) || !(metres(sides[1]) > 0))
    throw std::invalid_argument(fmt::format("--canvas is '{}', expected WIDTHxHEIGHT in metres, such as 20x15", text));
  read["canvas_width"] = sides[0];
  read["canvas_height"] = sides[1];
}

/// A robot with a least turning radius needs room for its loops, or it could not leave strokes that end at the margin.
void set_margin(const Options& options, ReaderOptions& read) {
  constexpr double kTurns = 3;      // radii beyond the robot's own; a loop reaches (1 + sqrt 3) of them
  constexpr double kLeastRoom = 4;  // of the canvas's sides: no larger part of it stays empty
  const double radius = robot_with(options.plan.problem, Robot{}).min_turn_radius;
  if (read.contains("margin") || !(radius > 0) || !is_svg(options.plan.problem.map)) return;
  const DrawingOptions given;
  const auto side = [&](const char* name, double fallback) {
    return read.contains(name) ? parse_number(read.at(name)).value_or(fallback) : fallback;
  };
  const double least = std::min(side("canvas_width", given.canvas_width), side("canvas_height", given.canvas_height));
  const double margin = std::min(given.margin + kTurns * radius, std::max(given.margin, least / kLeastRoom));
  read["margin"] = fmt::format("{}", margin);
  say(fmt::format("margin: {:g} m, room to turn (set with --margin)", margin));
}

int draw(Options options, const Registry& registry) {
  PlanOptions& plan = options.plan;
  if (!options.canvas.empty()) set_canvas(options.canvas, plan.problem.read);
  set_margin(options, plan.problem.read);
  // The reader looks for the edits in the drawing's folder, so that path files stay valid where both are moved.
  if (std::string& edits = plan.problem.read["edits"]; edits.empty()) {
    plan.problem.read.erase("edits");
  } else {
    if (!plan.outputs.viewer.empty()) plan.outputs.edits = read_file(edits);
    edits =
        std::filesystem::proximate(edits, std::filesystem::absolute(plan.problem.map).parent_path()).generic_string();
  }
  return cli::plan(plan, registry);
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto options = std::make_shared<Options>();
  options->plan.planner = "beachbot";
  app.add_option("DRAWING", options->plan.problem.map, "a drawing, SVG (docs/drawings.md), or a map file with one")
      ->type_name("")
      ->required();
  app.add_option("--planner", options->plan.planner, "a planner (`oxturn list planners`); beachbot if not given")
      ->type_name("NAME");
  app.add_option("--canvas", options->canvas, "size of the canvas, metres; 20x15 if not given")->type_name("WxH");
  add_plan_options(app, registry, options->plan);
  return [options, &registry] { return draw(*options, registry); };
}

}  // namespace

Command draw_command() {
  return {"draw", "plan the path of a drawing robot",
          "  oxturn draw whale.svg --canvas 20x15 --viewer plan.html --text plan.txt\n"
          "  oxturn draw whale.svg --edits edits.json -o path.geojson\n"
          "\nExit code 0 for outcome ok or partial, 1 for any other.\n",
          attach};
}

}  // namespace oxturn::cli
