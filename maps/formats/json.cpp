#include "maps/formats/json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "maps/formats.hpp"

namespace oxturn {

nlohmann::json parse_json(const std::string& text, const std::string& source) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& e) {
    const std::size_t end = std::min(e.byte, text.size());
    // e.byte is one past the last byte read: a newline there belongs to the line that it ends.
    const auto line =
        1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end > 0 ? end - 1 : 0), '\n');
    std::string why = e.what();
    if (const std::size_t colon = why.find(": "); colon != std::string::npos) why = why.substr(colon + 2);
    throw_invalid("{}:{}: not JSON: {}", source, line, why);
  } catch (const nlohmann::json::exception& e) { throw_invalid("{}: not JSON: {}", source, e.what()); }
}

void JsonAt::refuse(const std::string& expected) const {
  std::string given = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (given.size() > 60) given = given.substr(0, 57) + "...";
  throw_invalid("{} is {}, expected {}", where, given, expected);
}

double JsonAt::number(const char* expected) const {
  if (!value.is_number()) refuse(expected);
  const double d = value.get<double>();
  if (!std::isfinite(d)) refuse(expected);
  return d;
}

std::string JsonAt::text() const {
  if (!value.is_string()) refuse("a string");
  return value.get<std::string>();
}

namespace {

bool is_point(const nlohmann::json& value) {
  return value.is_array() && value.size() >= 2 && value[0].is_number() && value[1].is_number();
}
Point as_point(const nlohmann::json& value) { return {value[0].get<double>(), value[1].get<double>()}; }

}  // namespace

Point JsonAt::point() const {
  if (!is_point(value)) refuse("[x, y], two numbers in metres");
  const Point p = as_point(value);
  if (!finite(p)) refuse("[x, y], two finite numbers in metres");
  return p;
}

Polyline JsonAt::points(const std::string& named) const {
  Polyline points;
  points.reserve(value.size());
  for (const nlohmann::json& v : value) {
    if (!is_point(v) || !finite(as_point(v))) JsonAt{v, fmt::format("{}, point {}", named, points.size() + 1)}.point();
    points.push_back(as_point(v));
  }
  return points;
}

const nlohmann::json* JsonAt::find(const char* key) const {
  const auto it = value.find(key);
  return it == value.end() || it->is_null() ? nullptr : &*it;
}

std::string json_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

namespace {

std::string number(double value) { return std::isfinite(value) ? to_decimal(value) : "null"; }

/// No text of its own for each point: paths have millions.
void append_point(std::string& text, const Point& p) {
  text += '[';
  text += number(p.x());
  text += ", ";
  text += number(p.y());
  text += ']';
}

}  // namespace

std::string json_point(const Point& p) {
  std::string text;
  append_point(text, p);
  return text;
}

std::string json_points(const Polyline& points) {
  std::string text = "[";
  for (const Point& p : points) {
    if (text.size() > 1) text += ", ";
    append_point(text, p);
  }
  text += ']';
  return text;
}

}  // namespace oxturn
