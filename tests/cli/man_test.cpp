// The manual page, and colour.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::Not;

bool there_is(const std::string& program) { return shell("command -v " + program).code == 0; }

/// "--set", "-j", ... that a help or a manual names.
std::set<std::string> options_in(const std::string& text) {
  std::set<std::string> options;
  std::istringstream words(text);
  for (std::string word; words >> word;)
    if (word.size() > 1 && word[0] == '-') options.insert(word.substr(0, word.find_first_of("`,.;:=)[]")));
  return options;
}

TEST(Man, NamesEveryCommandAndOption) {
  std::string page = oxturn("man").out;
  for (const std::string mark : {"\\fB", "\\fI", "\\fR", "\\&", "\\"})
    for (std::size_t at = 0; (at = page.find(mark, at)) != std::string::npos;) page.erase(at, mark.size());
  const std::set<std::string> there = options_in(page);
  for (const std::string command : {"list", "map", "plan", "draw", "score", "run", "check", "report", "rescore",
                                    "merge", "missing", "completion", "man"}) {
    EXPECT_THAT(page, HasSubstr(".SS oxturn " + command));
    for (const std::string& option : options_in(oxturn(command + " --help").out))
      EXPECT_TRUE(there.contains(option)) << command << " " << option;
  }
}

TEST(Man, IsSetWithoutWarnings) {
  if (there_is("groff")) {
    const Said said = shell("oxturn man | groff -man -ww -z -K utf8 2>&1");
    EXPECT_EQ(said.out, "");
  }
  if (there_is("mandoc")) {
    EXPECT_EQ(shell("oxturn man | mandoc -T lint -W warning | grep -v 'missing date'").out, "");
  }
  if (!there_is("man")) GTEST_SKIP() << "there is no man";
  const Said said = shell("oxturn man | MANWIDTH=100 MANROFFOPT=-c man -l - | col -b");
  EXPECT_THAT(said.out, HasSubstr("oxturn plan boustrophedon rooms:7 --svg plan.svg"));
}

/// What `oxturn ARGUMENTS` prints on a terminal.
std::string on_terminal(const std::string& environment, const std::string& arguments) {
  return shell("env -u NO_COLOR TERM=xterm " + environment + " script -qec \"'" + OXTURN_PROGRAM + "' " + arguments +
               "\" /dev/null")
      .out;
}

TEST(Colour, OnlyOnATerminalAndNeverWithNoColor) {
  const std::string plan = "plan zigzag rectangle";
  const std::string green = "\033[32mok\033[0m", any = "\033[3";
  EXPECT_THAT(shell("env -u NO_COLOR '" OXTURN_PROGRAM "' " + plan).out, Not(HasSubstr("\033")));
  if (!there_is("script")) GTEST_SKIP() << "there is no script, which would be the terminal";
  EXPECT_THAT(on_terminal("", plan), HasSubstr(green));
  EXPECT_THAT(on_terminal("NO_COLOR=", plan), HasSubstr(green));
  EXPECT_THAT(on_terminal("NO_COLOR=1", plan), Not(HasSubstr(any)));
  EXPECT_THAT(on_terminal("TERM=dumb", plan), Not(HasSubstr(any)));
}

}  // namespace
}  // namespace oxturn
