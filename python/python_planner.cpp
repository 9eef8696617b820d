#include "python/python_planner.hpp"

#include <algorithm>
#include <array>

#include "algorithms/coverage_planner.hpp"
#include "python/convert.hpp"

namespace oxturn::python {
namespace {

class PythonPlanner final : public CoveragePlanner {
 public:
  explicit PythonPlanner(py::object object) : object_(std::move(object)) {}
  ~PythonPlanner() override {
    const py::gil_scoped_acquire gil;
    object_ = py::object();
  }
  Path plan(const Problem& problem, Context& context) const override {
    const py::gil_scoped_acquire gil;
    try {
      Path path = path_from(object_.attr("plan")(problem, py::cast(&context, py::return_value_policy::reference)));
      // Runs of a suite end without Python's own farewell.
      py::module_::import("sys").attr("stdout").attr("flush")();
      return path;
    } catch (const py::error_already_set& raised) {
      const py::module_ types = py::module_::import("oxturn._oxturn");
      const std::string sentence = py::str(raised.value());
      if (raised.matches(types.attr("Infeasible"))) throw Infeasible(sentence);
      if (raised.matches(types.attr("Unsupported"))) throw Unsupported(sentence);
      throw;
    }
  }

 private:
  py::object object_;
};

std::string text_of(const py::object& type, const char* attribute) {
  return py::hasattr(type, attribute) ? type.attr(attribute).cast<std::string>() : "";
}

Capability capability_from(const std::string& text) {
  for (const Capability c :
       {Capability::tether, Capability::online, Capability::holes, Capability::curvature, Capability::footprint})
    if (to_text(c) == text) return c;
  throw py::value_error("unknown capability '" + text + "'; there are: tether, online, holes, curvature, footprint");
}

}  // namespace

PlannerInfo planner_from(const py::object& type, const std::string& origin, const std::string& identity) {
  PlannerInfo info;
  info.name = text_of(type, "name");
  if (info.name.empty() || !py::hasattr(type, "plan"))
    throw py::value_error("a planner is a class with the attribute 'name' and the method plan(problem, context)");
  info.family = "python";
  info.title = text_of(type, "title");
  info.citation = text_of(type, "citation");
  info.guarantee = text_of(type, "guarantee");
  info.origin = origin;
  info.identity = identity;
  if (py::hasattr(type, "capabilities"))
    for (const py::handle c : type.attr("capabilities"))
      info.capabilities.push_back(capability_from(c.cast<std::string>()));
  if (py::hasattr(type, "parameters"))
    for (const auto& [name, value] : settings_from(type.attr("parameters")))
      info.parameters.push_back({name, value, {}, {}, ""});
  info.make = [type, owner = "planner '" + info.name + "'", parameters = info.parameters](
                  const Settings& settings, const Planners&) -> std::unique_ptr<CoveragePlanner> {
    const py::gil_scoped_acquire gil;
    Settings all;
    for (const ParameterInfo& p : parameters) all[p.name] = p.fallback;
    for (const auto& [name, value] : checked(owner, parameters, settings)) all[name] = value;
    return std::make_unique<PythonPlanner>(type(**to_dict(all)));
  };
  return info;
}

void bind_context(py::module_& module) {
  py::class_<Context>(module, "Context", "What a run gives its planner besides the problem.")
      .def_property_readonly("seed", &Context::seed, "For the planner's own random generator: the only source of luck.")
      .def_property_readonly("seconds_left", &Context::seconds_left, "Until the deadline.")
      .def("cancelled", &Context::cancelled, "True once the deadline has passed: return the best path so far soon.")
      .def("progress", &Context::progress, py::arg("fraction"), "The share of the work that is done, 0 to 1.")
      .def("record", &Context::record, py::arg("name"), py::arg("value"), "A figure of the run: a row of metrics.csv.")
      .def(
          "publish", [](Context& context, const py::object& legs) { context.publish(path_from(legs)); },
          py::arg("legs"), "Hands out the best path so far; it is scored after a timeout.");
}

}  // namespace oxturn::python
