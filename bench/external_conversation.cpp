// Decisions  1. The clock starts when the problem is sent: Context::begin().
//            2. The answer ends the conversation; what comes after it is dropped. A program that does not end by itself
//               soon after is killed, which does not count against it.
//            3. A published path is handed on at once, so that it is there when the program is killed.
#include "bench/external_conversation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "bench/child_process.hpp"
#include "maps/formats.hpp"
#include "maps/formats/geojson.hpp"
#include "maps/formats/robot_json.hpp"

namespace oxturn {
namespace {

using Json = nlohmann::json;
using Next = ExternalProgram::Next;

constexpr double kFarewell = 1;  // seconds that a program has to end after its answer

std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// The line that asks for a path.
std::string question(const Problem& problem, const Settings& settings, const Context& context) {
  std::string feature = one_line(to_geojson(problem));
  feature.pop_back();  // its last brace: two members more
  return one_line(fmt::format(R"({{"problem": {}, "configuration_space": {}, "target": {}}}, )"
                              R"("settings": {}, "seed": {}, "wall_s": {}}})",
                              feature, to_geojson(problem.configuration_space()), to_geojson(problem.target()),
                              settings_text(settings), context.seed(), to_decimal(context.wall_s()))) +
         "\n";
}

class Conversation {
 public:
  Conversation(const ShellCommand& command, Context& context)
      : command_(command), context_(context), program_(command) {}

  void await_ready() {
    const Next next = program_.next_line(context_.seconds_left());
    if (next == Next::late)
      throw WorkEnded(Outcome::timeout, fmt::format("{} did not print {{\"ready\": true}} within {:.3g} s of its start",
                                                    quoted(command_), context_.wall_s()));
    if (next != Next::line) fail(next);
    if (parsed() != Json{{"ready", true}}) refuse("is not {\"ready\": true}");
  }

  Path ask(const std::string& line) {
    program_.send(line);
    while (!answer_) {
      const Next next = program_.next_line(-1);
      if (next != Next::line) fail(next);
      if (program_.line().find_first_not_of(" \t\r") != std::string::npos) take();
    }
    program_.wait(std::min(kFarewell, context_.seconds_left()));
    context_.peak_memory(program_.peak_bytes());
    return std::move(*answer_);
  }

 private:
  using Handler = void (Conversation::*)(const JsonAt&);
  struct Kind {
    const char* name;
    Handler handle;
  };
  static const std::array<Kind, 7>& kinds() {
    static const std::array<Kind, 7> all{{{"path", &Conversation::path},
                                          {"error", &Conversation::error},
                                          {"publish", &Conversation::publish},
                                          {"progress", &Conversation::progress},
                                          {"record", &Conversation::record},
                                          {"trace", &Conversation::trace},
                                          {"promise", &Conversation::promise}}};
    return all;
  }

  std::string where() const { return fmt::format("line {} of {}", program_.lines(), quoted(command_)); }

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::runtime_error(fmt::format("{} {}; it begins {}", where(), what, beginning_of(program_.line())));
  }

  Json parsed() const {
    try {
      return Json::parse(program_.line());
    } catch (const Json::exception&) { refuse("is not JSON"); }
  }

  /// The program gives no answer any more.
  [[noreturn]] void fail(Next next) {
    const std::string last = program_.line();
    if (next == Next::too_long)
      throw std::runtime_error(fmt::format("line {} of {} is longer than {} MB; it begins {}", program_.lines() + 1,
                                           quoted(command_), ExternalProgram::kLongestLine >> 20, beginning_of(last)));
    const ExternalProgram::End end = program_.wait(kFarewell);
    std::string reason = fmt::format("{} {}", quoted(command_), ending_of(program_, end));
    if (!last.empty()) reason += fmt::format("; its last line has no end and begins {}", beginning_of(last));
    throw WorkEnded(end.signal != 0 && !end.killed ? Outcome::crash : Outcome::error, reason, end.exit_code,
                    end.killed ? 0 : end.signal);
  }

  void take() {
    const Json json = parsed();
    const auto kind = std::find_if(kinds().begin(), kinds().end(),
                                   [&](const Kind& k) { return json.is_object() && json.contains(k.name); });
    std::vector<std::string> names;
    for (const Kind& k : kinds()) names.emplace_back(k.name);
    if (kind == kinds().end()) refuse(fmt::format("has none of the members {}", fmt::join(names, ", ")));
    if (json.size() > (std::string_view(kind->name) == "error" ? 2U : 1U)) refuse("has more than one member");
    object_ = &json;
    try {
      (this->*kind->handle)({json[kind->name], fmt::format("{}: {}", where(), kind->name)});
    } catch (const std::invalid_argument& e) {
      const std::string why = e.what();
      throw std::runtime_error(fmt::format("{}{}; the line begins {}", why.starts_with(where()) ? "" : where() + ": ",
                                           why, beginning_of(program_.line())));
    }
  }

  void path(const JsonAt& at) { answer_ = path_from(at); }
  void publish(const JsonAt& at) { context_.publish(path_from(at)); }
  void promise(const JsonAt& at) {
    context_.promise([region = region_from(at)] { return region; });
  }
  void progress(const JsonAt& at) {
    const double fraction = at.number("a number from 0 to 1");
    if (fraction < 0 || fraction > 1) at.refuse("a number from 0 to 1");
    context_.progress(fraction);
  }
  void record(const JsonAt& at) {
    if (!at.value.is_object()) at.refuse("an object {\"name\": number}");
    for (const auto& [name, value] : at.value.items())
      context_.record(name, JsonAt{value, at.where + ", " + name}.number());
  }
  void trace(const JsonAt& at) {
    if (!at.value.is_object() || at.find("name") == nullptr || at.find("lines") == nullptr)
      at.refuse("an object {\"name\": text, \"lines\": [[[x, y], ...], ...]}");
    const JsonAt lines{*at.find("lines"), at.where + ", lines"};
    if (!lines.value.is_array()) lines.refuse("a list of lines");
    std::vector<Polyline> all;
    for (const Json& line : lines.value) {
      const JsonAt one{line, fmt::format("{}, line {}", lines.where, all.size() + 1)};
      if (!line.is_array()) one.refuse("a list of points");
      all.push_back(one.points(one.where));
    }
    context_.trace(JsonAt{*at.find("name"), at.where + ", name"}.text(), std::move(all));
  }
  void error(const JsonAt& at) {
    const Json* given = JsonAt{*object_, where()}.find("reason");
    if (given == nullptr && object_->size() > 1) refuse("has a member beside error that is not reason");
    const std::string reason =
        given != nullptr ? printable(JsonAt{*given, where() + ": reason"}.text()) : "it gave no reason";
    const std::string kind = at.text();
    if (kind != "infeasible" && kind != "unsupported" && kind != "failed")
      at.refuse("one of: infeasible, unsupported, failed");
    program_.wait(std::min(kFarewell, context_.seconds_left()));
    context_.peak_memory(program_.peak_bytes());
    if (kind == "infeasible") throw Infeasible(reason);
    if (kind == "unsupported") throw Unsupported(reason);
    throw std::runtime_error(fmt::format("{} failed: {}", quoted(command_), reason));
  }

  const ShellCommand& command_;
  Context& context_;
  ExternalProgram program_;
  const Json* object_ = nullptr;  // the line at hand
  std::optional<Path> answer_;
};

class ExternalPlanner final : public CoveragePlanner {
 public:
  ExternalPlanner(ShellCommand command, Settings settings)
      : command_(std::move(command)), settings_(std::move(settings)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const std::string line = question(problem, settings_, context);
    Conversation conversation(command_, context);
    conversation.await_ready();
    context.begin();
    return conversation.ask(line);
  }

 private:
  ShellCommand command_;
  Settings settings_;
};

}  // namespace

std::string ending_of(const ExternalProgram& program, const ExternalProgram::End& end) {
  std::string text;
  if (end.killed)
    text = "closed its output without an answer, and did not end";
  else if (end.signal != 0)
    text = fmt::format("was {}", signal_text(end.signal));
  else if (end.exit_code != 0)
    text = fmt::format("exited with code {}", end.exit_code);
  else
    text = "ended without an answer";
  if (const std::string words = program.last_words(); !words.empty())
    text += fmt::format("; it printed last {}", beginning_of(words));
  return text;
}

std::unique_ptr<CoveragePlanner> converse_with(const ShellCommand& command, Settings settings) {
  return std::make_unique<ExternalPlanner>(command, std::move(settings));
}

}  // namespace oxturn
