// oxturn man: the manual page, from the descriptions of the commands.
//
// Source   man(7): the macros of manual pages
#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "cli/commands.hpp"

namespace oxturn::cli {
namespace {

/// Plain text as roff: special characters escaped, `quoted words` bold, no line that roff takes for a request.
std::string roff(const std::string& text) {
  std::string out;
  bool bold = false;
  for (const char c : text) {
    const bool line_begins = out.empty() || out.back() == '\n';
    if (c == '`') {
      bold = !bold;
      out += bold ? "\\fB" : "\\fR";
    } else if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";  // can be copied to a shell; a plain one may become a hyphen
    } else if (c == '\'') {
      out += "\\(aq";
    } else {
      if (c == '.' && line_begins) out += "\\&";
      out += c;
    }
  }
  return out;
}

/// Lines that begin with a blank are examples, set as they are; others are paragraphs.
std::string roff_footer(const std::string& text) {
  std::istringstream in(text);
  std::string out;
  bool example = false;
  for (std::string line; std::getline(in, line);) {
    const bool indented = line.starts_with(' ');
    if (indented && !example) out += ".PP\n.nf\n";
    if (!indented && example) out += ".fi\n";
    if (!line.empty() && !indented) out += ".PP\n";
    if (!line.empty()) out += roff(line.substr(indented ? line.find_first_not_of(' ') : 0)) + "\n";
    example = indented;
  }
  return out + (example ? ".fi\n" : "");
}

/// "PLANNER [MAP] [OPTIONS]".
std::string synopsis(const CLI::App& app) {
  std::string words;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_name(true) + (option->get_items_expected_max() > 1 ? " ..." : "");
    const std::string word = "\\fI" + roff(name) + "\\fR";
    words += option->get_required() ? " " + word : " [" + word + "]";
  }
  return words + " [\\fIOPTIONS\\fR]";
}

/// "-o, --output FILE" with its help.
std::string roff_option(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : option.get_snames())
    names += fmt::format("{}\\fB\\-{}\\fR", names.empty() ? "" : ", ", roff(name));
  for (const std::string& name : option.get_lnames())
    names += fmt::format("{}\\fB\\-\\-{}\\fR", names.empty() ? "" : ", ", roff(name));
  if (names.empty()) names = "\\fI" + roff(option.get_name(true)) + "\\fR";
  if (option.get_items_expected_max() > 0 && !option.get_type_name().empty())
    names += " \\fI" + roff(option.get_type_name()) + "\\fR";
  std::string help;
  std::istringstream lines(option.get_description());
  for (std::string line; std::getline(lines, line);)
    help +=
        (help.empty() ? "" : ".br\n") + roff(line.substr(std::min(line.size(), line.find_first_not_of(' ')))) + "\n";
  return fmt::format(".TP\n{}\n{}", names, help);
}

std::string roff_command(const CLI::App& app) {
  std::string text =
      fmt::format(".SS \\fBoxturn {}\\fR{}\n{}\n", app.get_name(), synopsis(app), roff(app.get_description()));
  for (const CLI::Option* option : app.get_options()) text += roff_option(*option);
  return text + roff_footer(app.get_footer());
}

std::string manual_page(const CLI::App& root) {
  std::string text = fmt::format(
      ".TH OXTURN 1 \"\" \"oxturn {}\" \"User Commands\"\n"
      ".SH NAME\noxturn \\- plan, score and compare coverage paths\n"
      ".SH SYNOPSIS\n.B oxturn\n\\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n"
      ".SH DESCRIPTION\n{}\nResults go to standard output, everything else to standard error.\n",
      OXTURN_VERSION, roff(root.get_description()));
  for (const CLI::Option* option : root.get_options()) text += roff_option(*option);
  text += roff_footer(root.get_footer()) + ".SH COMMANDS\n";
  for (const CLI::App* app : root.get_subcommands({})) text += roff_command(*app);
  return text +
         ".SH ENVIRONMENT\n.TP\n.B NO_COLOR\nIf set to anything but the empty text, nothing is printed in colour.\n";
}

std::function<int()> attach(CLI::App& app, const Registry&) {
  return [&app] {
    fmt::print("{}", manual_page(*app.get_parent()));
    return 0;
  };
}

}  // namespace

Command man_command() {
  return {"man", "print the manual page, made of what the commands' --help tells",
          "  oxturn man > oxturn.1\n  oxturn man | man -l -\n", attach};
}

}  // namespace oxturn::cli
