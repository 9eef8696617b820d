/// JSON values that know where they are, for precise error messages. Internal: not installed.
///
///   const nlohmann::json root = parse_json(text, "yard.geojson");
///   const JsonAt at{root["start"], "yard.geojson: start"};
///   const Point start = at.point();                     // else: "yard.geojson: start is [1], expected [x, y], ..."
#pragma once

#include <nlohmann/json.hpp>

#include "base/throw_invalid.hpp"
#include "geometry/point.hpp"

namespace oxturn {

/// Throws std::invalid_argument "FILE:LINE: not JSON: ...".
nlohmann::json parse_json(const std::string& text, const std::string& source);

/// A JSON value and where it is ("grove.geojson: polygon 1, ring 2").
struct JsonAt {
  const nlohmann::json& value;
  std::string where;

  /// Throws "WHERE is VALUE, expected EXPECTED".
  [[noreturn]] void refuse(const std::string& expected) const;
  double number(const char* expected = "a finite number") const;
  std::string text() const;
  Point point() const;  // [x, y]; further numbers (altitude) are ignored
  /// Of a list of points. A bad one is called "NAMED, point 3".
  Polyline points(const std::string& named) const;
  const nlohmann::json* find(const char* key) const;  // nullptr if absent or null
};

/// `"text"`, escaped for JSON; invalid UTF-8 is replaced.
std::string json_text(const std::string& text);
/// "[2.5, 1]"; the shortest decimals, or null for infinities and NaN.
std::string json_point(const Point& p);
/// "[[2.5, 1], [3, 1]]"
std::string json_points(const Polyline& points);

}  // namespace oxturn
