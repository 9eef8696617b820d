/// Between C++ and Python: settings and dictionaries, point lists and NumPy arrays. Private to python/.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "base/parameters.hpp"
#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn::python {

namespace py = pybind11;

/// Throws TypeError for a value that is not bool, int, float or str.
Settings settings_from(const py::dict& given);
py::dict to_dict(const Settings& settings);

/// An array of shape (n, 2), metres.
py::array_t<double> to_array(const std::vector<Point>& points);
/// From anything that NumPy makes an array of shape (n, 2) of. Throws ValueError that names `what`.
std::vector<Point> points_from(const py::handle& given, const char* what);
Point point_from(const py::handle& given, const char* what);

/// A list of polygons, each (outer, [hole, ...]).
py::list to_list(const Region& region);
/// A list of legs, each (points, tool, reverse, width).
py::list to_list(const Path& path);
/// From a list of legs: (points, tool), (points, tool, reverse) or (points, tool, reverse, width).
Path path_from(const py::handle& legs);

}  // namespace oxturn::python
