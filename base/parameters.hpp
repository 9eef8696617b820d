// Parameters as data: a plain struct, and one line of description for each member. From that one description
// come listing, help, suites, checks and error sentences, for planners and generators alike.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace oxturn {

using Value = std::variant<bool, std::int64_t, double, std::string>;
/// name -> value, as a suite or `--set` gives them. Ordered, so that iteration is deterministic.
using Settings = std::map<std::string, Value>;

struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
};
using Choices = std::vector<std::string>;

/// What the outside sees of a parameter. The alternative held by `fallback` is its type.
struct ParameterInfo {
  std::string name;
  Value fallback;
  Range range;      // numbers
  Choices choices;  // texts; empty: any text
  std::string help;
};

/// One line of a description.
template <class P>
struct Parameter {
  using Member = std::variant<bool P::*, int P::*, double P::*, std::string P::*>;
  Parameter(std::string n, bool P::*m, std::string h) : name(std::move(n)), member(m), help(std::move(h)) {}
  Parameter(std::string n, int P::*m, Range r, std::string h)
      : name(std::move(n)), member(m), range(r), help(std::move(h)) {}
  Parameter(std::string n, double P::*m, Range r, std::string h)
      : name(std::move(n)), member(m), range(r), help(std::move(h)) {}
  Parameter(std::string n, std::string P::*m, Choices c, std::string h)
      : name(std::move(n)), member(m), choices(std::move(c)), help(std::move(h)) {}
  std::string name;
  Member member;
  Range range;
  Choices choices;
  std::string help;
};

/// Shortest round-trip text: "0.35", "true", "3", "convex".
std::string to_text(const Value& value);
/// Reads `text` as the parameter's type. Throws std::invalid_argument in one sentence; `owner` is for instance
/// "planner 'stc'".
Value parse_value(const std::string& owner, const ParameterInfo& parameter, std::string_view text);
/// Checks type (whole numbers pass as reals), range, choice and NaN; returns the value in the parameter's type.
Value checked(const std::string& owner, const ParameterInfo& parameter, const Value& value);
/// The parameter called `name`; throws "unknown parameter 'lane_width' of planner 'stc'; it has: ...".
const ParameterInfo& find_parameter(const std::string& owner, const std::vector<ParameterInfo>& all,
                                    const std::string& name);

template <class P>
std::vector<ParameterInfo> to_infos(const std::vector<Parameter<P>>& lines) {
  const P defaults{};
  std::vector<ParameterInfo> infos;
  for (const Parameter<P>& line : lines) {
    Value fallback = std::visit(
        [&](auto member) -> Value {
          using T = std::decay_t<decltype(defaults.*member)>;
          if constexpr (std::is_same_v<T, int>)
            return static_cast<std::int64_t>(defaults.*member);
          else
            return defaults.*member;
        },
        line.member);
    infos.push_back({line.name, std::move(fallback), line.range, line.choices, line.help});
  }
  return infos;
}

/// The struct with `settings` written over its defaults. Throws one sentence for an unknown name, a wrong type,
/// a value out of range or not among the choices.
template <class P>
P with_settings(const std::string& owner, const std::vector<Parameter<P>>& lines, const Settings& settings) {
  const std::vector<ParameterInfo> infos = to_infos(lines);
  P result{};
  for (const auto& [name, given] : settings) {
    const ParameterInfo& info = find_parameter(owner, infos, name);
    const Value value = checked(owner, info, given);
    const Parameter<P>& line = lines[static_cast<std::size_t>(&info - infos.data())];
    std::visit(
        [&](auto member) {
          using T = std::decay_t<decltype(result.*member)>;
          if constexpr (std::is_same_v<T, int>)
            result.*member = static_cast<int>(std::get<std::int64_t>(value));
          else
            result.*member = std::get<T>(value);
        },
        line.member);
  }
  return result;
}

}  // namespace oxturn
