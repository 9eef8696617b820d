// JSON for the readers and writers of maps/formats/: values with a place to complain about. Not installed.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "geometry/point.hpp"

namespace oxturn {

/// Parses; throws std::invalid_argument "FILE:LINE: not JSON: ...".
nlohmann::json parse_json(const std::string& text, const std::string& source);

/// A JSON value and where it is ("grove.geojson: polygon 1, ring 2, point 3").
struct JsonAt {
  const nlohmann::json& value;
  std::string place;

  /// Throws "PLACE is VALUE, expected EXPECTED".
  [[noreturn]] void refuse(const std::string& expected) const;
  double number(const char* expected = "a finite number") const;
  std::string text() const;
  Point point() const;                                // [x, y]; further numbers (altitude) are ignored
  const nlohmann::json* find(const char* key) const;  // nullptr if absent or null
};

/// `"text"` with what JSON wants escaped; broken UTF-8 is replaced.
std::string json_text(const std::string& text);
/// to_decimal, or null for what JSON cannot say.
std::string json_number(double value);
std::string json_point(const Point& p);

}  // namespace oxturn
