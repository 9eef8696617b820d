// What an external planner says of itself: the members that `oxturn list planners --json` prints, checked one by one.
//
// Decisions  1. A member that is not known is refused: a typing error would silently change what the planner promises.
//            2. The files that determine what a program does cannot be known. Those that the command names are hashed,
//               and the description, whose `version` an author can change.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <vector>

#include "base/files.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "bench/child_process.hpp"
#include "bench/external_conversation.hpp"
#include "bench/external_program.hpp"
#include "bench/run_id.hpp"
#include "maps/formats/json.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr std::size_t kLongestDescription = 1 << 20;
constexpr double kFarewell = 1;  // seconds that a program has to end after its description
const Limits kLimits{.wall_s = 20, .cpu_s = 0, .memory_mb = 4096};

// --- asking --------------------------------------------------------------------------------------------------

/// In a child process.
void ask(const ShellCommand& command, int fd) {
  ExternalProgram program(command);
  program.close_input();
  std::string text;
  for (auto next = ExternalProgram::Next::line; next == ExternalProgram::Next::line;) {
    next = program.next_line(-1);
    text += program.line() + "\n";
    if (text.size() > kLongestDescription || next == ExternalProgram::Next::too_long)
      throw std::runtime_error("prints more than a megabyte, expected one JSON object");
  }
  const auto end = program.wait(kFarewell);
  if (end.killed) throw std::runtime_error("has closed its output but does not end");
  if (end.signal != 0 || end.exit_code != 0) throw std::runtime_error(ending_of(program, end));
  wire::send(fd, 'A', text);
}

std::string answer_of(const ShellCommand& command) {
  std::string text;
  ChildTask task;
  task.limits = kLimits;
  task.work = [&](int fd) { ask(command, fd); };
  task.receive = [&](char, std::string_view payload) { text = payload; };
  const ChildReport report = run_child(task);
  if (report.outcome == Outcome::timeout)
    throw_invalid("{} printed no description within {} s", quoted(command), kLimits.wall_s);
  if (report.outcome != Outcome::ok) throw_invalid("{} {}", quoted(command), report.reason);
  return text;
}

// --- reading -------------------------------------------------------------------------------------------------

/// The members of an object, taken one by one; those not taken are unknown.
class Members {
 public:
  explicit Members(JsonAt at) : at_(std::move(at)) {
    if (!at_.value.is_object()) at_.refuse("an object");
  }
  std::optional<JsonAt> find(const char* name) {
    names_.emplace_back(name);
    const Json* value = at_.find(name);
    if (value == nullptr) return std::nullopt;
    return JsonAt{*value, fmt::format("{}, member '{}'", at_.where, name)};
  }
  JsonAt need(const char* name, const char* expected) {
    const auto member = find(name);
    if (!member) throw_invalid("{} has no member '{}', expected {}", at_.where, name, expected);
    return *member;
  }
  std::string text(const char* name, const char* fallback = "") {
    const auto member = find(name);
    return member ? member->text() : fallback;
  }
  void end() const {
    for (const auto& [name, value] : at_.value.items())
      if (std::find(names_.begin(), names_.end(), name) == names_.end())
        throw_invalid("{} has an unknown member {}; expected: {}", at_.where, beginning_of(name),
                      fmt::join(names_, ", "));
  }

 private:
  JsonAt at_;
  std::vector<std::string> names_;
};

std::string name_of(const JsonAt& at, const char* more) {
  const std::string name = at.text();
  const auto good = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || std::string_view(more).find(c) != std::string_view::npos;
  };
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), good))
    at.refuse(fmt::format("at most 64 of the characters a-z, 0-9 and {}", more));
  return name;
}

/// The enumerator whose text the member is.
template <class E, std::size_t n>
E one_of(const JsonAt& at, const std::array<E, n>& all) {
  const std::string given = at.text();
  std::vector<std::string> names;
  for (const E e : all) {
    if (to_text(e) == given) return e;
    names.emplace_back(to_text(e));
  }
  at.refuse(fmt::format("one of: {}", fmt::join(names, ", ")));
}

/// Of the type that `type` names, as `oxturn list` calls it.
Value fallback_of(const std::string& type, const JsonAt& type_at, const JsonAt& at) {
  if (type == "number") return at.number();
  if (type == "text") return at.text();
  if (type == "yes/no") {
    if (!at.value.is_boolean()) at.refuse("true or false");
    return at.value.get<bool>();
  }
  if (type == "whole number") {
    if (!at.value.is_number_integer()) at.refuse("a whole number");
    return at.value.get<std::int64_t>();
  }
  type_at.refuse("one of: yes/no, whole number, number, text");
}

double bound_of(const ParameterInfo& parameter, const std::optional<JsonAt>& at, double none) {
  if (!at) return none;
  const Value& value = parameter.fallback;
  if (!std::holds_alternative<double>(value) && !std::holds_alternative<std::int64_t>(value))
    at->refuse("none: only numbers have a range");
  return at->number();
}

ParameterInfo parameter_from(const JsonAt& at, const std::string& owner) {
  Members members(at);
  ParameterInfo parameter;
  const JsonAt name = members.need("name", "a name");
  parameter.name = name_of(name, "_");
  if (parameter.name == "name" || parameter.name == "exec" || parameter.name == "ignore_tether")
    name.refuse("another name: suites have a key of this one");
  const JsonAt type = members.need("type", "one of: yes/no, whole number, number, text");
  parameter.fallback = fallback_of(type.text(), type, members.need("default", "the default value"));
  parameter.range.least = bound_of(parameter, members.find("least"), parameter.range.least);
  parameter.range.most = bound_of(parameter, members.find("most"), parameter.range.most);
  if (const auto choices = members.find("choices")) {
    if (!std::holds_alternative<std::string>(parameter.fallback)) choices->refuse("none: only texts have choices");
    if (!choices->value.is_array()) choices->refuse("a list of texts");
    for (const Json& choice : choices->value) parameter.choices.push_back(JsonAt{choice, choices->where}.text());
  }
  parameter.help = members.text("help");
  members.end();
  try {
    (void)checked(owner, parameter, parameter.fallback);
  } catch (const std::invalid_argument& e) { throw_invalid("{}: the default of {}", at.where, e.what()); }
  return parameter;
}

std::vector<ParameterInfo> parameters_from(const JsonAt& at, const std::string& owner) {
  if (!at.value.is_array()) at.refuse("a list of parameters");
  std::vector<ParameterInfo> all;
  for (const Json& item : at.value) {
    all.push_back(parameter_from({item, fmt::format("{}, parameter {}", at.where, all.size() + 1)}, owner));
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
      if (all[i].name == all.back().name) throw_invalid("{} has two parameters '{}'", at.where, all[i].name);
  }
  return all;
}

std::vector<Capability> capabilities_from(const JsonAt& at) {
  constexpr std::array kAll{Capability::tether, Capability::holes, Capability::curvature, Capability::footprint};
  if (!at.value.is_array()) at.refuse("a list of texts");
  std::vector<Capability> all;
  for (const Json& item : at.value) {
    if (item == to_text(Capability::online))
      throw_invalid("{} has 'online', but an external planner is given the whole map; leave it out", at.where);
    all.push_back(one_of(JsonAt{item, at.where}, kAll));
  }
  return all;
}

std::vector<Symmetry> symmetries_from(const JsonAt& at) {
  constexpr std::array kAll{Symmetry::shift, Symmetry::quarter_turn, Symmetry::mirror, Symmetry::scale};
  if (!at.value.is_array()) at.refuse("a list of texts");
  std::vector<Symmetry> all;
  for (const Json& item : at.value) all.push_back(one_of(JsonAt{item, at.where}, kAll));
  return all;
}

PlannerInfo info_from(const JsonAt& at) {
  constexpr std::array kPromises{Promise::target, Promise::cells, Promise::nothing};
  Members members(at);
  const JsonAt protocol = members.need("oxturn", "1, the version of the protocol");
  if (protocol.value != 1) protocol.refuse("1, the version of the protocol");
  PlannerInfo info;
  info.name = name_of(members.need("name", "the planner's name"), "_-");
  info.family = members.text("family", "external");
  info.title = members.text("title");
  info.citation = members.text("citation");
  info.guarantee = members.text("guarantee", "none");
  if (const auto promise = members.find("promise")) info.promise = one_of(*promise, kPromises);
  if (const auto capabilities = members.find("capabilities")) info.capabilities = capabilities_from(*capabilities);
  if (const auto symmetries = members.find("symmetries")) info.symmetries = symmetries_from(*symmetries);
  if (const auto parameters = members.find("parameters"))
    info.parameters = parameters_from(*parameters, "planner '" + info.name + "'");
  members.text("version");
  members.end();
  return info;
}

// --- identity ------------------------------------------------------------------------------------------------

struct Word {
  std::string text;
  bool first;  // of a simple command
};

/// The words of a shell command as they stand, without their quotes. Nothing is expanded.
std::vector<Word> words_of(const std::string& command) {
  std::vector<Word> words;
  std::string word;
  char quote = 0;
  bool first = true;
  const auto finish = [&] {
    if (word.empty()) return;
    words.push_back({std::move(word), first});
    word.clear();
    first = false;
  };
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (quote == 0 && std::string_view(" \t\n|&;<>()").find(c) != std::string_view::npos) {
      finish();
      first = first || std::string_view("|&;(\n").find(c) != std::string_view::npos;
    } else if (c == quote) {
      quote = 0;
    } else if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == '\\' && quote != '\'' && i + 1 < command.size()) {
      word += command[++i];
    } else {
      word += c;
    }
  }
  finish();
  return words;
}

/// The program that the shell would start, if it is looked up in PATH; "" if there is none.
std::string found_in_path(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path != nullptr ? path : "";
  while (name.find('/') == std::string::npos && !rest.empty()) {
    const std::size_t colon = rest.find(':');
    const std::string file = std::string(rest.substr(0, colon)) + "/" + name;
    std::error_code error;
    if (fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0) return file;
    rest = colon == std::string_view::npos ? std::string_view() : rest.substr(colon + 1);
  }
  return {};
}

std::string identity_of(const ShellCommand& command, const std::string& description) {
  std::string text = fmt::format("command {}\ndescription {}\n", command.text, description);
  for (const Word& word : words_of(command.text)) {
    std::error_code error;
    std::string file = (fs::path(command.folder) / word.text).string();
    if (!fs::is_regular_file(file, error)) file = word.first ? found_in_path(word.text) : "";
    if (!file.empty()) text += fmt::format("file {} {}\n", word.text, sha256(read_file(file)));
  }
  return sha256(text);
}

}  // namespace

PlannerInfo external_planner(const ShellCommand& command) {
  const ShellCommand describe{command.text + " --describe", command.folder};
  std::string answer = answer_of(describe);
  while (!answer.empty() && std::isspace(static_cast<unsigned char>(answer.back())) != 0) answer.pop_back();
  Json json;
  try {
    json = Json::parse(answer);
  } catch (const Json::exception&) {
    throw_invalid("{} printed {}, expected one JSON object that describes the planner", quoted(describe),
                  beginning_of(answer));
  }
  PlannerInfo info = info_from({json, quoted(describe)});
  info.origin = command.text;
  info.is_program = true;
  info.identity = identity_of(command, json.dump());
  info.make = [command, own = info](const Settings& settings, const Planners& planners) {
    const Settings given = checked("planner '" + own.name + "'", own.parameters, settings);
    return converse_with(command, full_settings(own, given, planners));
  };
  return info;
}

std::string add_external_planner(Planners& planners, const ShellCommand& command) {
  PlannerInfo info = external_planner(command);
  const std::string name = info.name;
  if (const PlannerInfo* known = planners.get(name); known == nullptr)
    planners.add(std::move(info));
  else if (known->identity != info.identity)
    throw_invalid("{} describes itself as '{}', but there is another planner of that name{}; change one of the names",
                  quoted(command), name, known->origin.empty() ? "" : ", " + quoted({known->origin}));
  return name;
}

}  // namespace oxturn
