#include "cli/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <map>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/plugins.hpp"

namespace oxturn::cli {
namespace {

constexpr int kBadInput = 2;

int refuse(std::string sentence) {
  for (char& c : sentence)
    if (c == '\n' || c == '\r') c = ' ';
  while (!sentence.empty() && sentence.back() == ' ') sentence.pop_back();
  fmt::print(stderr, "oxturn: {}\n", sentence);
  return kBadInput;
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Command& command : commands()) names.push_back(command.name);
  return names;
}

/// What CLI11 found wrong, with the nearest option's name if one is unknown.
std::string sentence_of(const CLI::ParseError& error, CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::string command = chosen.empty() ? "" : " " + chosen.front()->get_name();
  std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    // CLI11 lists them all, last first: the option among them is what went wrong, the rest followed from it.
    std::istringstream words(text.substr(text.find(": ") + 1));
    std::string word;
    for (std::string next; words >> next;)
      if (word.empty() || word.front() != '-' || next.front() == '-') word = next;
    text = fmt::format("unexpected argument '{}'", word);
    if (!word.empty() && word.front() == '-' && !chosen.empty()) {
      std::vector<std::string> options;
      for (const CLI::Option* option : chosen.front()->get_options())
        for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
      const std::string nearest = nearest_name(word.substr(0, word.find('=')), options);
      if (!nearest.empty()) text += fmt::format("; did you mean '{}'?", nearest);
    }
  }
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  return fmt::format("{}{} See `oxturn{} --help`", text, text.ends_with('?') ? "" : ".", command);
}

int run(int argc, const char* const* argv, const Registry& registry) {
  CLI::App app{"oxturn: plans, scores and compares coverage paths.", "oxturn"};
  app.set_help_flag("-h,--help", "print this help and exit");
  app.set_version_flag("-V,--version", std::string("oxturn ") + OXTURN_VERSION, "print the version and exit");
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.require_subcommand(0, 1);
  app.footer(
      "Examples:\n  oxturn list planners\n  oxturn plan boustrophedon rooms:7 --svg plan.svg\n"
      "  oxturn run quick -o out\n\n`oxturn help COMMAND` tells more of each.\n\n"
      "Exit codes: 0 done; 1 done, but the path is not valid or a run is not as required; 2 bad input.");
  std::map<const CLI::App*, std::function<int()>> actions;
  for (const Command& command : commands()) {
    CLI::App* sub = app.add_subcommand(command.name, command.title);
    sub->group("Commands");
    sub->footer("Examples:\n" + command.examples);
    actions[sub] = command.attach(*sub, registry);
    add_plugin_option(*sub);
  }
  if (argc < 2)
    return refuse(
        fmt::format("no command given; there are: {}. See `oxturn --help`", fmt::join(command_names(), ", ")));
  const std::string word = argv[1];
  if (!word.empty() && word.front() != '-') {
    const auto names = command_names();
    if (std::find(names.begin(), names.end(), word) == names.end()) return refuse(unknown_name("command", word, names));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    return app.exit(asked);
  } catch (const CLI::ParseError& error) { return refuse(sentence_of(error, app)); }
  const auto chosen = app.get_subcommands();
  if (chosen.empty()) return refuse("no command given. See `oxturn --help`");
  return actions.at(chosen.front())();
}

/// `oxturn help plan` is `oxturn plan --help`, and `oxturn help` is `oxturn --help`.
std::vector<const char*> without_help_command(int argc, const char* const* argv) {
  std::vector<const char*> words(argv, argv + argc);
  if (argc < 2 || std::string(argv[1]) != "help") return words;
  words.erase(words.begin() + 1);
  words.resize(std::min<std::size_t>(words.size(), 2));
  words.push_back("--help");
  return words;
}

}  // namespace

int run_program(int argc, const char* const* argv, const Registry& registry) {
  try {
    const std::vector<const char*> words = without_help_command(argc, argv);
    const auto count = static_cast<int>(words.size());
    const int code = run(count, words.data(), with_plugins(registry, count, words.data()));
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) return refuse("cannot write to standard output");
    return code;
  } catch (const std::bad_alloc&) { return refuse("out of memory"); } catch (const std::exception& error) {
    return refuse(error.what());
  }
}

}  // namespace oxturn::cli
