// Completion scripts, by the shells themselves where they are installed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// What bash proposes for the last of `words`.
std::string proposals(const std::string& words) {
  const Folder folder;
  folder.write("script", oxturn("completion bash").out);
  const std::string command = "cd '" + (folder / "") + "' && bash -c '. ./script; COMP_WORDS=(" + words +
                              "); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _oxturn; echo ${COMPREPLY[@]}' > said 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0);
  return content(folder / "said");
}

TEST(Completion, BashProposesCommandsOptionsAndNames) {
  EXPECT_EQ(proposals("oxturn re"), "report rescore\n");
  EXPECT_EQ(proposals("oxturn help sc"), "score\n");
  EXPECT_EQ(proposals("oxturn plan bous"), "boustrophedon\n");
  EXPECT_EQ(proposals("oxturn plan stc --ex"), "--exec\n");
  EXPECT_EQ(proposals("oxturn list form"), "formats\n");
  EXPECT_EQ(proposals("oxturn list planners zig"), "zigzag\n");
  EXPECT_EQ(proposals("oxturn run quic"), "quick\n");
  EXPECT_EQ(proposals("oxturn map scr"), "script\n");  // a file
}

TEST(Completion, OtherShellsHaveEveryCommand) {
  for (const std::string shell : {"zsh", "fish"}) {
    const Said said = oxturn("completion " + shell);
    EXPECT_EQ(said.code, 0);
    EXPECT_THAT(said.out, AllOf(HasSubstr("rescore"), HasSubstr("boustrophedon"), HasSubstr("exec")));
    const Folder folder;
    const std::string file = folder.write("script", said.out);
    if (std::system(("command -v " + shell + " >/dev/null").c_str()) == 0) {
      EXPECT_EQ(std::system((shell + " -n '" + file + "'").c_str()), 0);
    }
  }
  const Said said = oxturn("completion tcsh");
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr("no completion for the shell 'tcsh'"));
}

}  // namespace
}  // namespace oxturn
