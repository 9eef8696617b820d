#include "base/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

const char* type_name(const Value& value) {
  constexpr std::array kNames{"true or false", "a whole number", "a number", "a text"};
  return kNames[value.index()];
}

[[noreturn]] void refuse(const std::string& owner, const ParameterInfo& parameter, const std::string& given,
                         const std::string& expected) {
  throw_invalid("parameter '{}' of {} is {}, expected {}", parameter.name, owner, given, expected);
}

std::string range_text(const ParameterInfo& parameter) {
  const Range& range = parameter.range;
  std::string type = type_name(parameter.fallback);
  const std::string least = to_decimal(range.least), most = to_decimal(range.most);
  const bool low = std::isfinite(range.least), high = std::isfinite(range.most);
  if (low && high)
    return fmt::format("{} {} {}{} {}", type, range.above ? "above" : "from", least, range.above ? ", at most" : " to",
                       most);
  if (low) return fmt::format("{} {} {}", type, range.above ? "above" : "of at least", least);
  if (high) return fmt::format("{} of at most {}", type, most);
  return type;
}

std::optional<bool> yes_or_no(std::string_view text) {
  if (text == "true" || text == "yes" || text == "on" || text == "1") return true;
  if (text == "false" || text == "no" || text == "off" || text == "0") return false;
  return std::nullopt;
}

bool has_choice(const ParameterInfo& parameter, const std::string& text) {
  return std::find(parameter.choices.begin(), parameter.choices.end(), text) != parameter.choices.end();
}

bool within(const Range& range, double value) {
  return value <= range.most && (range.above ? value > range.least : value >= range.least);
}

}  // namespace

std::string to_text(const Value& value) {
  if (const bool* b = std::get_if<bool>(&value)) return *b ? "true" : "false";
  if (const std::int64_t* i = std::get_if<std::int64_t>(&value)) return std::to_string(*i);
  if (const std::string* s = std::get_if<std::string>(&value)) return *s;
  return to_decimal(std::get<double>(value));
}

std::string to_text(const Settings& settings) {
  std::string out;
  for (const auto& [name, value] : settings)
    out += fmt::format("{}{}={}", out.empty() ? "" : ";", name, to_text(value));
  return out;
}

Value parse_value(const std::string& owner, const ParameterInfo& parameter, std::string_view text) {
  const std::string given = fmt::format("'{}'", text);
  const auto number = [&]<class T>(T) -> Value {
    if (const auto value = parse_all<T>(text)) return checked(owner, parameter, *value);
    refuse(owner, parameter, given, range_text(parameter));
  };
  const std::optional<bool> flag = yes_or_no(text);
  if (std::holds_alternative<bool>(parameter.fallback)) {
    if (flag) return *flag;
    refuse(owner, parameter, given, "true or false");
  }
  if (flag && has_choice(parameter, to_text(*flag))) return to_text(*flag);
  if (std::holds_alternative<std::int64_t>(parameter.fallback)) return number(std::int64_t{});
  if (std::holds_alternative<double>(parameter.fallback)) return number(double{});
  return checked(owner, parameter, std::string(text));
}

Value checked(const std::string& owner, const ParameterInfo& parameter, const Value& value) {
  const std::string given =
      std::holds_alternative<std::string>(value) ? fmt::format("'{}'", to_text(value)) : to_text(value);
  Value result = value;
  if (std::holds_alternative<double>(parameter.fallback) && std::holds_alternative<std::int64_t>(value))
    result = static_cast<double>(std::get<std::int64_t>(value));
  // A yes or no among other choices, as suites write it.
  if (std::holds_alternative<bool>(value) && has_choice(parameter, to_text(value))) result = to_text(value);
  if (result.index() != parameter.fallback.index()) {
    const bool like_whole = std::holds_alternative<double>(value) && given.find_first_of(".en") == std::string::npos;
    refuse(owner, parameter, like_whole ? given + ".0" : given, range_text(parameter));
  }

  if (const double* real = std::get_if<double>(&result)) {
    if (!std::isfinite(*real)) refuse(owner, parameter, given, "a finite number");
    if (!within(parameter.range, *real)) refuse(owner, parameter, given, range_text(parameter));
  } else if (const std::int64_t* whole = std::get_if<std::int64_t>(&result)) {
    if (!within(parameter.range, static_cast<double>(*whole))) refuse(owner, parameter, given, range_text(parameter));
    // The members are of type int: refuse what does not fit rather than truncate it.
    if (*whole < std::numeric_limits<int>::min() || *whole > std::numeric_limits<int>::max())
      refuse(owner, parameter, given, "a whole number of at most 2147483647 in size");
  } else if (const std::string* text = std::get_if<std::string>(&result); text && !parameter.choices.empty()) {
    if (!has_choice(parameter, *text))
      refuse(owner, parameter, given, fmt::format("one of: {}", fmt::join(parameter.choices, ", ")));
  }
  return result;
}

const ParameterInfo& find_parameter(const std::string& owner, const std::vector<ParameterInfo>& all,
                                    const std::string& name) {
  std::vector<std::string> names;
  for (const ParameterInfo& parameter : all) {
    if (parameter.name == name) return parameter;
    names.push_back(parameter.name);
  }
  if (names.empty()) throw_invalid("unknown parameter '{}' of {}; it has no parameters", name, owner);
  throw_invalid("unknown parameter '{}' of {}; it has: {}", name, owner, fmt::join(names, ", "));
}

Settings checked(const std::string& owner, const std::vector<ParameterInfo>& parameters, const Settings& settings) {
  Settings all;
  for (const auto& [name, value] : settings) all[name] = checked(owner, find_parameter(owner, parameters, name), value);
  return all;
}

}  // namespace oxturn
