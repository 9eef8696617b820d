/// Parameters as data: a plain struct, and one line of description for each member. The command line, suites, files,
/// hashes, listings and error messages are all made from that description.
///
///   struct Params { double cell_size = 0; Order order = Order::nearest; };
///   const std::vector<Parameter<Params>> lines{
///       {"cell_size", &Params::cell_size, Range{0, 100}, "metres; 0: tool width / sqrt 2"},
///       {"order", &Params::order, Choices{"nearest", "improved"}, "of the cells"}};
///   const Params p = with_settings("planner 'stc'", lines, {{"cell_size", 0.2}});
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace oxturn {

using Value = std::variant<bool, std::int64_t, double, std::string>;
/// Values by parameter name, as a suite or `--set` gives them. Ordered, so that iteration is deterministic.
using Settings = std::map<std::string, Value>;

/// A bool, int, double or text as a value, and back.
template <class T>
Value value_of(const T& member) {
  if constexpr (std::is_same_v<T, int>)
    return std::int64_t{member};
  else
    return member;
}
template <class T>
T value_as(const Value& value) {
  if constexpr (std::is_same_v<T, int>)
    return static_cast<int>(std::get<std::int64_t>(value));
  else
    return std::get<T>(value);
}

/// The interval of values a number may take.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above = false;  // `least` itself is excluded
};
using Choices = std::vector<std::string>;

/// What users see of a parameter. Its type is that of the alternative in `fallback`.
struct ParameterInfo {
  std::string name;
  Value fallback;
  Range range;      // of a number
  Choices choices;  // of a text; empty: any text
  std::string help;
};

/// One line of a description: the member of P that it describes, and what users see of it.
template <class P>
struct Parameter {
  std::function<Value(const P&)> get;
  std::function<void(P&, const Value&)> set;  // expects a value of the parameter's type and within its range
  ParameterInfo info;                         // without `fallback`, which infos_of fills in

  Parameter(std::string name, bool P::*member, std::string help) : Parameter(member, {name, {}, {}, {}, help}) {}
  Parameter(std::string name, int P::*member, Range range, std::string help)
      : Parameter(member, {name, {}, range, {}, help}) {}
  Parameter(std::string name, double P::*member, Range range, std::string help)
      : Parameter(member, {name, {}, range, {}, help}) {}
  Parameter(std::string name, std::string P::*member, Choices choices, std::string help)
      : Parameter(member, {name, {}, {}, choices, help}) {}
  /// An enum class whose enumerators are 0, 1, ...; `choices` are their names in that order.
  template <class E, class Base, class = std::enable_if_t<std::is_enum_v<E> && std::is_base_of_v<Base, P>>>
  Parameter(std::string name, E Base::*member, Choices choices, std::string help) {
    get = [member, choices](const P& p) -> Value { return choices.at(static_cast<std::size_t>(p.*member)); };
    set = [member, choices](P& p, const Value& v) {
      for (std::size_t i = 0; i < choices.size(); ++i)
        if (choices[i] == std::get<std::string>(v)) p.*member = static_cast<E>(i);
    };
    info = {std::move(name), {}, {}, std::move(choices), std::move(help)};
  }
  /// A member of any other type, converted by `getter` and `setter` to and from a Value of the parameter's type.
  Parameter(ParameterInfo about, std::function<Value(const P&)> getter, std::function<void(P&, const Value&)> setter)
      : get(std::move(getter)), set(std::move(setter)), info(std::move(about)) {}

 private:
  template <class T>
  Parameter(T P::*member, ParameterInfo about)
      : get([member](const P& p) { return value_of(p.*member); }),
        set([member](P& p, const Value& v) { p.*member = value_as<T>(v); }),
        info(std::move(about)) {}
};

/// Shortest round-trip text: "0.35", "true", "3", "convex".
std::string to_text(const Value& value);
/// "name=value;name=value" in the order of names.
std::string to_text(const Settings& settings);
/// Reads `text` as a value of the parameter's type. Throws std::invalid_argument with a sentence that names the
/// `owner`, for instance "planner 'stc'".
Value parse_value(const std::string& owner, const ParameterInfo& parameter, std::string_view text);
/// The value in the parameter's type (whole numbers are accepted for reals), if its type, range and choice are right
/// and it is finite. Throws std::invalid_argument "parameter 'cell_size' of planner 'stc' is -1, expected a number from
/// 0 to 100".
Value checked(const std::string& owner, const ParameterInfo& parameter, const Value& value);
/// The parameter called `name`. Throws std::invalid_argument "unknown parameter 'lane_width' of planner 'stc'; it has:
/// ...".
const ParameterInfo& find_parameter(const std::string& owner, const std::vector<ParameterInfo>& all,
                                    const std::string& name);
/// All settings, checked and in their parameters' types. Throws as find_parameter() and checked() do.
Settings checked(const std::string& owner, const std::vector<ParameterInfo>& parameters, const Settings& settings);

/// The descriptions, with the struct's own defaults as `fallback`.
template <class P>
std::vector<ParameterInfo> infos_of(const std::vector<Parameter<P>>& lines) {
  const P defaults{};
  std::vector<ParameterInfo> infos;
  for (const Parameter<P>& line : lines) {
    infos.push_back(line.info);
    infos.back().fallback = line.get(defaults);
  }
  return infos;
}

/// Checks the settings and assigns them to the members of `target`.
template <class P>
void apply_settings(const std::string& owner, const std::vector<Parameter<P>>& lines, const Settings& settings,
                    P& target) {
  const Settings all = checked(owner, infos_of(lines), settings);
  for (const Parameter<P>& line : lines)
    if (const auto given = all.find(line.info.name); given != all.end()) line.set(target, given->second);
}

/// The struct with its defaults, overwritten by `settings`.
template <class P>
P with_settings(const std::string& owner, const std::vector<Parameter<P>>& lines, const Settings& settings) {
  P result{};
  apply_settings(owner, lines, settings, result);
  return result;
}

}  // namespace oxturn
