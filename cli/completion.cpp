// oxturn completion: a script that makes a shell complete commands, options and names, from the descriptions.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "base/text.hpp"
#include "cli/commands.hpp"
#include "cli/suites.hpp"

namespace oxturn::cli {
namespace {

struct Flag {
  std::string name;  // "--set", "-j"
  std::string help;
  bool takes_value;
};
struct Described {
  std::string name, title;
  std::vector<Flag> flags;
  std::vector<std::string> words;  // for what stands after the command
};

std::vector<std::string> words_after(const std::string& command, const Registry& registry) {
  std::vector<std::string> names;
  if (command == "plan" || command == "check") return registry.planners.names();
  if (command == "map") return registry.generators.names();
  if (command == "list") {
    names = kinds_of_lists();
    std::ranges::copy(registry.planners.names(), std::back_inserter(names));
    std::ranges::copy(registry.generators.names(), std::back_inserter(names));
    return names;
  }
  if (command == "completion") return {"bash", "zsh", "fish"};
  if (command == "run")
    for (const SuiteFile& suite : suite_files()) names.push_back(suite.name);
  return names;
}

std::vector<Flag> flags_of(const CLI::App& app) {
  std::vector<Flag> flags;
  for (const CLI::Option* option : app.get_options()) {
    const std::string help = option->get_description();
    const bool takes_value = option->get_items_expected_max() > 0;
    for (const std::string& name : option->get_lnames())
      flags.push_back({"--" + name, help.substr(0, help.find('\n')), takes_value});
    for (const std::string& name : option->get_snames())
      flags.push_back({"-" + name, help.substr(0, help.find('\n')), takes_value});
  }
  return flags;
}

std::vector<Described> describe_all(const CLI::App& root, const Registry& registry) {
  std::vector<Described> all;
  for (const CLI::App* app : root.get_subcommands({}))
    all.push_back({app->get_name(), app->get_description(), flags_of(*app), words_after(app->get_name(), registry)});
  return all;
}

/// `text` with a backslash before each of the characters in `special`.
std::string escaped(const std::string& text, std::string_view special) {
  std::string out;
  for (const char c : text) {
    if (special.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

/// Between single quotes, for sh and zsh.
std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

std::string names_of(const std::vector<Described>& all) {
  std::string names;
  for (const Described& command : all) names += command.name + " ";
  return names + "help";
}

std::string for_bash(const std::vector<Described>& all) {
  std::string text = "_oxturn() {\n  local cur=${COMP_WORDS[COMP_CWORD]} words= options=\n  case ${COMP_WORDS[1]} in\n";
  for (const Described& command : all) {
    std::string flags;
    for (const Flag& flag : command.flags) flags += (flags.empty() ? "" : " ") + flag.name;
    text += fmt::format("    {}) options='{}' words='{}' ;;\n", command.name, flags, fmt::join(command.words, " "));
  }
  text += fmt::format("    help) words='{}' ;;\n  esac\n", names_of(all));
  text += fmt::format("  if ((COMP_CWORD == 1)); then options='--help --version' words='{}'; fi\n", names_of(all));
  return text +
         "  if [[ $cur == -* ]]; then COMPREPLY=($(compgen -W \"$options\" -- \"$cur\"))\n"
         "  elif ((COMP_CWORD == 1)) || [[ ${COMP_WORDS[1]} == help ]]; then COMPREPLY=($(compgen -W \"$words\" -- "
         "\"$cur\"))\n"
         "  else COMPREPLY=($(compgen -W \"$words\" -- \"$cur\") $(compgen -f -- \"$cur\")); fi\n"
         "}\ncomplete -o filenames -F _oxturn oxturn\n";
}

std::string for_zsh(const std::vector<Described>& all) {
  std::string text = "#compdef oxturn\n_oxturn() {\n  local -a commands=(\n";
  for (const Described& command : all)
    text += fmt::format("    {}\n", in_quotes(command.name + ":" + escaped(command.title, ":\\")));
  text += "  )\n  if ((CURRENT == 2)); then _describe command commands; return; fi\n  case $words[2] in\n";
  for (const Described& command : all) {
    text += fmt::format("    {}) _arguments", command.name);
    for (const Flag& flag : command.flags)
      text += " \\\n      " + in_quotes(flag.name + "[" + escaped(flag.help, "[]:\\") + "]" +
                                        (flag.takes_value ? ":value:_files" : ""));
    text += fmt::format(" \\\n      '*: :_alternative \"names:name:({})\" \"files:file:_files\"' ;;\n",
                        fmt::join(command.words, " "));
  }
  return text + fmt::format(
                    "    help) _arguments '2: :({})' ;;\n  esac\n}}\n"
                    "if [[ $funcstack[1] == _oxturn ]]; then _oxturn \"$@\"; else compdef _oxturn oxturn; fi\n",
                    names_of(all));  // loaded by the first completion, or sourced
}

std::string for_fish(const std::vector<Described>& all) {
  const auto quoted = [](const std::string& text) { return "'" + escaped(text, "'\\") + "'"; };
  std::string text;
  for (const Described& command : all) {
    text += fmt::format("complete -c oxturn -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                        quoted(command.title));
    const std::string when = fmt::format("complete -c oxturn -n '__fish_seen_subcommand_from {}'", command.name);
    for (const Flag& flag : command.flags)
      text += fmt::format("{} {} {}{} -d {}\n", when, flag.name.starts_with("--") ? "-l" : "-s",
                          flag.name.substr(flag.name.find_first_not_of('-')), flag.takes_value ? " -r" : "",
                          quoted(flag.help));
    if (!command.words.empty()) text += fmt::format("{} -a '{}'\n", when, fmt::join(command.words, " "));
  }
  return text + fmt::format(
                    "complete -c oxturn -n __fish_use_subcommand -f -a help\n"
                    "complete -c oxturn -n '__fish_seen_subcommand_from help' -f -a '{}'\n",
                    names_of(all));
}

std::function<int()> attach(CLI::App& app, const Registry& registry) {
  const auto shell = std::make_shared<std::string>();
  app.add_option("SHELL", *shell, "bash, zsh or fish")->required()->type_name("");
  return [shell, &app, &registry] {
    const std::vector<Described> all = describe_all(*app.get_parent(), registry);
    if (*shell == "bash")
      fmt::print("{}", for_bash(all));
    else if (*shell == "zsh")
      fmt::print("{}", for_zsh(all));
    else if (*shell == "fish")
      fmt::print("{}", for_fish(all));
    else
      throw std::invalid_argument(unknown_name("completion for the shell", *shell, {"bash", "zsh", "fish"}));
    return 0;
  };
}

}  // namespace

Command completion_command() {
  return {"completion", "print a script that makes a shell complete commands, options and names",
          "  source <(oxturn completion bash)                          in ~/.bashrc\n"
          "  source <(oxturn completion zsh)                           in ~/.zshrc\n"
          "  oxturn completion fish > ~/.config/fish/completions/oxturn.fish\n",
          attach};
}

}  // namespace oxturn::cli
