#include "python/convert.hpp"

#include <cmath>
#include <string>

namespace oxturn::python {
namespace {

Value value_from(const std::string& name, const py::handle& given) {
  if (py::isinstance<py::bool_>(given)) return given.cast<bool>();
  if (py::isinstance<py::int_>(given)) return given.cast<std::int64_t>();
  if (py::isinstance<py::float_>(given)) return given.cast<double>();
  if (py::isinstance<py::str>(given)) return given.cast<std::string>();
  // NumPy's numbers and the like.
  if (py::hasattr(given, "item")) return value_from(name, given.attr("item")());
  throw py::type_error("'" + name + "' is a " + std::string(py::str(py::type::of(given).attr("__name__"))) +
                       ", expected a bool, a number or a text");
}

}  // namespace

Settings settings_from(const py::dict& given) {
  Settings settings;
  for (const auto& [name, value] : given) {
    const auto key = name.cast<std::string>();
    settings[key] = value_from(key, value);
  }
  return settings;
}

py::dict to_dict(const Settings& settings) {
  py::dict all;
  for (const auto& [name, value] : settings)
    std::visit([&, key = py::str(name)](const auto& v) { all[key] = py::cast(v); }, value);
  return all;
}

py::array_t<double> to_array(const std::vector<Point>& points) {
  py::array_t<double> array({points.size(), std::size_t{2}});
  auto at = array.mutable_unchecked<2>();
  for (py::ssize_t i = 0; i < at.shape(0); ++i) {
    at(i, 0) = points[static_cast<std::size_t>(i)].x();
    at(i, 1) = points[static_cast<std::size_t>(i)].y();
  }
  return array;
}

std::vector<Point> points_from(const py::handle& given, const char* what) {
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!array || array.ndim() != 2 || array.shape(1) != 2) {
    PyErr_Clear();
    throw py::value_error(std::string(what) + ": expected an array of shape (n, 2)");
  }
  const auto at = array.unchecked<2>();
  std::vector<Point> points;
  for (py::ssize_t i = 0; i < at.shape(0); ++i) points.emplace_back(at(i, 0), at(i, 1));
  return points;
}

Point point_from(const py::handle& given, const char* what) {
  const auto pair = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(given);
  if (!pair || pair.ndim() != 1 || pair.shape(0) != 2) {
    PyErr_Clear();
    throw py::value_error(std::string(what) + ": expected two numbers (x, y)");
  }
  return {pair.at(0), pair.at(1)};
}

py::list to_list(const Region& region) {
  py::list all;
  for (const Polygon& polygon : region.polygons) {
    py::list holes;
    for (const Ring& hole : polygon.holes) holes.append(to_array(hole));
    all.append(py::make_tuple(to_array(polygon.outer), holes));
  }
  return all;
}

py::list to_list(const Path& path) {
  py::list all;
  for (const Leg& leg : path.legs)
    all.append(py::make_tuple(to_array(leg.points), leg.tool, leg.gear == Gear::reverse, leg.width));
  return all;
}

Path path_from(const py::handle& legs) {
  Path path;
  for (const py::handle leg : legs) {
    const auto parts = py::reinterpret_borrow<py::object>(leg).cast<py::sequence>();
    if (parts.size() < 2 || parts.size() > 4)
      throw py::value_error("a leg is (points, tool), (points, tool, reverse) or (points, tool, reverse, width)");
    const bool reverse = parts.size() > 2 && parts[2].cast<bool>();
    const double width = parts.size() > 3 ? parts[3].cast<double>() : 0;
    if (!(width >= 0) || !std::isfinite(width))
      throw py::value_error("a leg's width is " + std::to_string(width) + ", expected metres, or 0 for the whole tool");
    path.legs.push_back({parts[1].cast<bool>(), points_from(parts[0], "the points of a leg"),
                         reverse ? Gear::reverse : Gear::forward, width});
  }
  return path;
}

}  // namespace oxturn::python
