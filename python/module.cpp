// The Python module oxturn._oxturn: maps, problems, planners, scores and suites. python/oxturn/__init__.py is its face.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "algorithms/coverage_planner.hpp"
#include "base/files.hpp"
#include "bench/plugin.hpp"
#include "bench/run_suite.hpp"
#include "maps/path_file.hpp"
#include "maps/picture.hpp"
#include "metrics/score.hpp"
#include "python/convert.hpp"
#include "python/python_planner.hpp"
#include "reports/built_in_registry.hpp"

namespace oxturn::python {
namespace {

// --- what there is ------------------------------------------------------------------------------------------

/// Everything that comes with oxturn, and what plug-ins and Python classes have added. One for the interpreter, because
/// a module is one.
Registry& registry() {
  static Registry all = built_in_registry();
  return all;
}

/// Defining a class again, as in a notebook, replaces the planner.
void add_planner(const py::object& type, const std::string& origin, const std::string& identity) {
  PlannerInfo info = planner_from(type, origin, identity);
  Planners others("planner");
  for (const PlannerInfo& known : registry().planners)
    if (known.name != info.name || known.family != "python") others.add(known);
  others.add(std::move(info));
  registry().planners = std::move(others);
}

py::list planners() {
  py::list all;
  for (const PlannerInfo& p : registry().planners) {
    py::dict parameters, about;
    for (const ParameterInfo& parameter : p.parameters) {
      py::dict one = to_dict({{"default", parameter.fallback}});
      one["help"] = parameter.help;
      if (!parameter.choices.empty()) one["choices"] = parameter.choices;
      parameters[py::str(parameter.name)] = one;
    }
    std::vector<std::string> capabilities;
    for (const Capability c : p.capabilities) capabilities.push_back(to_text(c));
    about["name"] = p.name, about["family"] = p.family, about["title"] = p.title, about["citation"] = p.citation;
    about["capabilities"] = capabilities, about["guarantee"] = p.guarantee, about["promise"] = to_text(p.promise);
    about["parameters"] = parameters;
    all.append(about);
  }
  return all;
}

// --- maps and problems --------------------------------------------------------------------------------------

MapFile generated(const std::string& generator, std::uint64_t seed, const py::dict& settings) {
  return {generate(generator, settings_from(settings), seed, registry().generators), {}, {}, {}, {}};
}

/// `robot`: settings over those of the file.
Problem make_problem(const MapFile& file, const py::object& start, const py::object& anchor, const py::dict& robot) {
  Robot changed = file.robot.value_or(Robot{});
  change(changed, settings_from(robot));
  const auto position = [](const py::object& given, const std::optional<Point>& fallback, const char* what) {
    return given.is_none() ? fallback : std::optional(point_from(given, what));
  };
  return {file.map, changed, position(start, file.start, "start"), position(anchor, file.anchor, "anchor")};
}

void bind_maps(py::module_& m) {
  py::class_<MapFile>(m, "Map", "The free space that a robot is to cover, and what else its file says.")
      .def_static(
          "read",
          [](const std::string& file, const py::kwargs& settings) {
            return read_map(file, settings_from(settings), registry().formats);
          },
          py::arg("file"), "Reads GeoJSON, ROS YAML, PNG or PGM. Further arguments are the reader's settings.")
      .def_static(
          "generate",
          [](const std::string& g, std::uint64_t seed, const py::kwargs& s) { return generated(g, seed, s); },
          py::arg("generator"), py::arg("seed") = 1, "Makes a map; further arguments are the generator's settings.")
      .def_property_readonly("name", [](const MapFile& f) { return f.map.name; })
      .def_property_readonly(
          "free", [](const MapFile& f) { return to_list(f.map.free); }, "Polygons (outer, [hole, ...]), metres.")
      .def_property_readonly("remarks", [](const MapFile& f) { return f.remarks; })
      .def("svg", [](const MapFile& f) { return to_svg(f.map); })
      .def(
          "write", [](const MapFile& f, const std::string& file) { write_map(file, f, registry().formats); },
          py::arg("file"));
  py::class_<Problem>(m, "Problem", "A map, a robot and its start.")
      .def(py::init([](const MapFile& map, const py::object& start, const py::object& anchor, const py::kwargs& robot) {
             return make_problem(map, start, anchor, robot);
           }),
           py::arg("map"), py::arg("start") = py::none(), py::arg("anchor") = py::none())
      .def_static(
          "read",
          [](const std::string& file, const py::object& start, const py::object& anchor, const py::kwargs& robot) {
            return make_problem(read_map(file, {}, registry().formats), start, anchor, robot);
          },
          py::arg("file"), py::arg("start") = py::none(), py::arg("anchor") = py::none(),
          "Reads a map and makes its problem; further arguments describe the robot (`oxturn list robot`).")
      .def_property_readonly("name", [](const Problem& p) { return p.map().name; })
      .def_property_readonly("robot", [](const Problem& p) { return to_dict(settings_of(p.robot())); })
      .def_property_readonly("start", [](const Problem& p) { return py::make_tuple(p.start().x(), p.start().y()); })
      .def_property_readonly("anchor", [](const Problem& p) { return py::make_tuple(p.anchor().x(), p.anchor().y()); })
      .def_property_readonly("free", [](const Problem& p) { return to_list(p.map().free); })
      .def_property_readonly(
          "configuration_space", [](const Problem& p) { return to_list(p.configuration_space()); },
          "Where the robot's centre may be: polygons (outer, [hole, ...]), metres.")
      .def_property_readonly(
          "target", [](const Problem& p) { return to_list(p.target()); }, "What can be covered.")
      .def(
          "transit",
          [](const Problem& p, const py::object& from, const py::object& to) {
            const auto path = p.transit().path(point_from(from, "from"), point_from(to, "to"));
            if (!path) throw py::value_error("no path between these points inside configuration space");
            return to_array(*path);
          },
          py::arg("start"), py::arg("goal"), "The shortest path in configuration space, an array (n, 2).");
}

// --- planning and scoring -----------------------------------------------------------------------------------

/// A path with the problem that it is for.
struct Plan {
  Problem problem;
  Path path;
  ScoreOptions scoring = {};
  std::shared_ptr<const Region> promised = {};  // to which `scoring` points
};

Plan plan(const std::string& name, const Problem& problem, std::uint64_t seed, double wall_s, const py::kwargs& given) {
  const PlannerInfo& info = registry().planners.find(name);
  const Settings settings = settings_from(given);
  if (const std::string missing = missing_capability(info, problem); !missing.empty()) throw Unsupported(missing);
  const auto planner = info.make(settings, registry().planners);
  Plan result{problem, {}};
  std::function<Region()> region;
  Context::Sinks sinks;
  sinks.promise = [&](std::function<Region()> promised) { region = std::move(promised); };
  Context context(seed, wall_s, std::move(sinks));
  {
    const py::gil_scoped_release others_may_run;
    result.path = planner->plan(problem, context);
    if (region) result.promised = std::make_shared<const Region>(region());
  }
  const Promise promise = info.promised(settings, problem.robot());
  if (promise == Promise::target) result.scoring.promise = promise;
  if (result.promised) {
    result.scoring.promise = Promise::cells;
    result.scoring.promised = result.promised.get();
  }
  return result;
}

py::dict score_of(const Plan& plan) {
  Score result;
  {
    const py::gil_scoped_release others_may_run;
    result = score(plan.problem, plan.path, registry().metrics, plan.scoring);
  }
  py::dict all;
  all["flaw"] = result.flaw;
  for (const MetricValue& metric : result.values) all[py::str(metric.name)] = metric.value;
  return all;
}

void bind_plans(py::module_& m) {
  py::class_<Plan>(m, "Plan", "A path with the problem that it is for.")
      .def(py::init([](const Problem& problem, const py::object& legs) {
             return Plan{problem, path_from(legs)};
           }),
           py::arg("problem"), py::arg("legs"),
           "From legs (points, tool), (points, tool, reverse) or "
           "(points, tool, reverse, width).")
      .def_static(
          "read",
          [](const std::string& file, const Problem& problem) {
            return Plan{problem, read_path(file)};
          },
          py::arg("file"), py::arg("problem"), "Reads a path, GeoJSON or CSV.")
      .def_readonly("problem", &Plan::problem)
      .def_property_readonly(
          "legs", [](const Plan& p) { return to_list(p.path); },
          "In driving order: (points, tool, reverse, width), points an array (n, 2) in metres, width 0: the whole "
          "tool.")
      .def_property_readonly(
          "length", [](const Plan& p) { return p.path.length(); }, "Metres.")
      .def("score", &score_of, "Every metric by name, None where it does not apply; `flaw` says why a path is invalid.")
      .def(
          "svg", [](const Plan& p) { return to_svg(p.problem, &p.path); }, "A picture.")
      .def("_repr_svg_", [](const Plan& p) { return to_svg(p.problem, &p.path); })
      .def(
          "write", [](const Plan& p, const std::string& file) { write_file(file, to_geojson(p.path)); },
          py::arg("file"), "As GeoJSON.");
  m.def("plan", &plan, py::arg("planner"), py::arg("problem"), py::arg("seed") = 1, py::arg("wall_s") = 1e9,
        "Plans in this process; further arguments are the planner's parameters. Raises Infeasible or Unsupported.");
}

// --- suites -------------------------------------------------------------------------------------------------

/// Numbers as numbers, empty cells as None.
py::list to_list(const Results& results) {
  std::map<std::string, std::string> types;
  for (const Column& column : run_columns(registry().metrics)) types[column.name] = column.type;
  py::list rows;
  for (const Row& row : results.rows) {
    py::dict one;
    for (const std::string& column : results.columns) {
      const std::string& cell = row.get(column);
      const bool text = !types.contains(column) || types[column] == "text";
      one[py::str(column)] = cell.empty() ? py::none().cast<py::object>()
                             : text       ? py::str(cell).cast<py::object>()
                                          : py::float_(row.number(column).value_or(0)).cast<py::object>();
    }
    rows.append(one);
  }
  return rows;
}

py::list run(const std::string& suite, const std::string& folder, int jobs, bool resume, bool progress) {
  SuiteRunOptions options;
  options.folder = folder;
  options.jobs = jobs;
  options.resume = resume;
  options.progress = progress;
  return to_list(run_suite(read_suite(suite, registry()), registry(), options));
}

}  // namespace

PYBIND11_MODULE(_oxturn, m) {
  py::register_exception<Infeasible>(m, "Infeasible", PyExc_RuntimeError);
  py::register_exception<Unsupported>(m, "Unsupported", PyExc_RuntimeError);
  bind_context(m);
  bind_maps(m);
  bind_plans(m);
  m.def("planners", &planners, "Every planner, as a dictionary.");
  m.def("generators", [] { return registry().generators.names(); });
  m.def("add_planner", &add_planner, py::arg("type"), py::arg("origin"), py::arg("identity"));
  m.def(
      "load_plugin", [](const std::string& file) { load_plugin(registry(), file); }, py::arg("file"));
  m.def("run", &run, py::arg("suite"), py::arg("output"), py::arg("jobs"), py::arg("resume"), py::arg("progress"));
  m.def(
      "read_results", [](const std::string& folder) { return to_list(read_results(folder)); }, py::arg("folder"));
}

}  // namespace oxturn::python
