/// Planners written in Python, as classes. Private to python/.
#pragma once

#include <pybind11/pybind11.h>

#include "algorithms/planner_info.hpp"

namespace oxturn::python {

namespace py = pybind11;

/// A class with the attributes that docs/python.md lists and the method plan(problem, context) -> legs. `origin` and
/// `identity`: as PlannerInfo has them. Throws ValueError that names the class and what is missing.
PlannerInfo planner_from(const py::object& type, const std::string& origin, const std::string& identity);

/// The class Context of the module.
void bind_context(py::module_& module);

}  // namespace oxturn::python
