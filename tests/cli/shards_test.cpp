// run --shard, missing and merge as their users type them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "bench/results.hpp"
#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kSuite = R"(schema = 1
name = "shards"
repeats = REPEATS
[robots.disc]
radius = 0.2
tool_width = 0.4
[[maps]]
generator = "rectangle"
width = 3
height = [2, 3]
[[planners]]
name = ["zigzag", "random-walk"]
)";

class Shards : public testing::Test {
 protected:
  Shards() : suite(write_suite("suite.toml", "3")) {}  // 12 runs
  std::string write_suite(const std::string& name, const std::string& repeats) const {
    std::string text = kSuite;
    text.replace(text.find("REPEATS"), 7, repeats);
    return folder.write(name, text);
  }
  /// Runs a shard into the folder `name`.
  std::string done(const std::string& shard, const std::string& name) const {
    const Said said = oxturn("run " + suite + " -q --no-pictures --shard " + shard + " -o " + (folder / name));
    EXPECT_EQ(said.code, 0) << said.err;
    return folder / name;
  }
  static void refused(const std::string& arguments, const testing::Matcher<const std::string&>& sentence) {
    const Said said = oxturn(arguments);
    EXPECT_EQ(said.code, 2) << arguments;
    EXPECT_EQ(said.out, "") << arguments;
    EXPECT_EQ(said.err_lines(), 1) << said.err;
    EXPECT_THAT(said.err, sentence);
  }
  Folder folder;
  std::string suite;
};

/// Rows as text, without timing columns and the attempt.
std::string rows_of(const std::string& results) {
  std::string text;
  const Columns columns = run_columns(Metrics("metric"));
  for (const Row& row : read_results(results).rows) {
    for (const auto& [column, cell] : row.cells.all()) {
      bool varies = column == "attempt";
      for (const Column& c : columns) varies = varies || (c.name == column && c.timing);
      if (!varies) text += column + "=" + cell + " ";
    }
    text += "\n";
  }
  return text;
}

TEST_F(Shards, AreOneTableAfterTheMerge) {
  const std::string a = done("1/3", "1"), b = done("2/3", "2"), c = done("3/3", "3");
  EXPECT_EQ(shell("ls " + a + "/report.md").code, 2) << "the report is made by the merge";
  EXPECT_EQ(oxturn("missing " + suite + " " + a + " " + b + " " + c).code, 0);
  const Said said = oxturn("merge " + a + " " + b + " " + c + " -o " + (folder / "all"));
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(said.err, "");
  EXPECT_THAT(said.out, HasSubstr("report.md"));
  ASSERT_EQ(oxturn("run " + suite + " -q --no-pictures -o " + (folder / "whole")).code, 0);
  EXPECT_EQ(rows_of(folder / "all"), rows_of(folder / "whole"));
  EXPECT_EQ(content(folder / "all/trace.csv"), content(folder / "whole/trace.csv"));
  const Said no_report = oxturn("run " + suite + " -q --no-pictures --no-report -o " + (folder / "rows"));
  EXPECT_EQ(no_report.out, "rows      " + (folder / "rows") + "/runs.csv\n");
  EXPECT_EQ(content(folder / "rows/report.md"), "");
  EXPECT_EQ(rows_of(folder / "rows"), rows_of(folder / "whole"));
  const Said only_files = oxturn("merge " + a + " " + b + " " + c + " --no-report -o " + (folder / "files"));
  EXPECT_EQ(only_files.code, 0);
  EXPECT_EQ(only_files.out, "");
  EXPECT_EQ(content(folder / "files/report.md"), "");
  EXPECT_EQ(content(folder / "files/runs.csv"), content(folder / "all/runs.csv"));
}

TEST_F(Shards, MissingRunsAreNamed) {
  const std::string a = done("1/3", "1"), c = done("3/3", "3");
  const Said said = oxturn("missing " + suite + " " + a + " " + c);
  EXPECT_EQ(said.code, 1);
  EXPECT_EQ(said.err, "");
  EXPECT_EQ(std::count(said.out.begin(), said.out.end(), '\n'), 4);
  std::istringstream first(said.out);
  std::string map, robot, planner, repeat;
  first >> map >> robot >> planner >> repeat;
  EXPECT_THAT(map, HasSubstr("rectangle"));
  EXPECT_EQ(robot + " " + planner + " " + repeat, "disc random-walk 2");
  EXPECT_EQ(oxturn("missing " + suite + " " + a + " " + c + " --shards 3").out, "2\n");
  EXPECT_EQ(oxturn("missing " + suite + " " + a + " --shards 6").out, "3,4,5,6\n");
  // A merge of what is there says so, and is no failure.
  const Said merged = oxturn("merge " + a + " " + c + " --no-report -o " + (folder / "all"));
  EXPECT_EQ(merged.code, 0);
  EXPECT_THAT(merged.err, HasSubstr("4 of the suite's 12 runs are missing; `oxturn missing` names them"));
}

TEST_F(Shards, AreResumedAndDuplicatesDropped) {
  const std::string a = done("1/2", "1");
  const std::string rows = content(a + "/runs.csv");
  folder.write("1/runs.csv", rows.substr(0, rows.rfind('\n', rows.size() - 2) + 1));  // the last row is lost
  EXPECT_EQ(oxturn("missing " + suite + " " + a + " --shards 2").out, "1,2\n");
  const Said resumed = oxturn("run " + suite + " -q --no-pictures --resume --shard 1/2 -o " + a);
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_EQ(oxturn("missing " + suite + " " + a + " --shards 2").out, "2\n");
  const std::string again = done("1/2", "again"), b = done("2/2", "2");
  const Said merged = oxturn("merge " + b + " " + again + " " + a + " --no-report -o " + (folder / "all"));
  EXPECT_EQ(merged.code, 0);
  EXPECT_THAT(merged.err, HasSubstr("dropped 6 rows of runs that are there already"));
  EXPECT_EQ(read_results(folder / "all").rows.size(), 12u);
}

TEST_F(Shards, BadShardsAreRefused) {
  for (const std::string text : {"3", "0/4", "5/4", "1/0", "a/b", "1/2/3", "1/1000001"})
    refused("run " + suite + " -o " + (folder / "x") + " --shard " + text,
            AllOf(HasSubstr("'" + text + "'"), HasSubstr("expected K/N with K from 1 to N, at most 1000000")));
  refused("run " + suite + " -o " + (folder / "x") + " --shard", HasSubstr("--shard"));
  EXPECT_EQ(folder.files(), 1u) << "nothing was made";
  const std::string a = done("1/2", "1");
  refused("run " + suite + " -o " + a + " --shard 2/2", HasSubstr("already holds results"));
  refused("run " + suite + " -o " + a + " --shard 2/2 --resume", HasSubstr("holds shard 1/2 of the suite, not 2/2"));
  refused("run " + suite + " -o " + a + " --resume", HasSubstr("holds shard 1/2 of the suite, not 1/1"));
}

TEST_F(Shards, MissingRefuses) {
  const std::string a = done("1/2", "1"), other = write_suite("other.toml", "4");
  refused("missing", HasSubstr("SUITE"));
  refused("missing " + suite, HasSubstr("DIR"));
  refused("missing nothing.toml " + a, HasSubstr("no such file: 'nothing.toml'"));
  refused("missing quik " + a, HasSubstr("did you mean 'quick'"));
  refused("missing " + suite + " " + (folder / "none"),
          AllOf(HasSubstr("none/session.json"), HasSubstr("no such file")));
  refused("missing " + other + " " + a, HasSubstr("holds results of another suite, or of other contents of this one"));
  for (const std::string count : {"0", "-1", "x", "1000001"})
    refused("missing " + suite + " " + a + " --shards " + count, HasSubstr("--shards"));
  refused("missing " + suite + " " + a + " --exec true", HasSubstr("`true --describe` printed ''"));
  refused("missing " + suite + " " + a + " --plugin none.so", HasSubstr("no such file: 'none.so'"));
}

TEST_F(Shards, MergeRefuses) {
  const std::string a = done("1/2", "1"), b = done("1/2", "2"), to = " -o " + (folder / "all");
  refused("merge" + to, HasSubstr("DIR"));
  refused("merge " + a, HasSubstr("--output"));
  refused("merge " + (folder / "none") + to, HasSubstr("none/session.json"));
  refused("merge " + a + " -o " + a, HasSubstr("already holds results"));
  refused("merge " + a + " -o /proc/nowhere", HasSubstr("/proc/nowhere"));
  const auto changed = [&](const std::string& file, const std::string& from, const std::string& to_text,
                           const std::string& sentence) {
    const std::string before = content(folder / file);
    std::string text = before;
    ASSERT_NE(text.find(from), std::string::npos) << file;
    text.replace(text.find(from), from.size(), to_text);
    folder.write(file, text);
    refused("merge " + a + " " + b + to, HasSubstr(sentence));
    folder.write(file, before);
  };
  changed("2/session.json", "\"suite\": \"shards\"", "\"suite\": \"others\"", "have different suites (shards, others)");
  changed("2/session.json", "\"suite_identity\": \"", "\"suite_identity\": \"x",
          "have different contents of the suite");
  changed("2/session.json", "\"identity\": \"", "\"identity\": \"x", "have different builds of oxturn");
  changed("2/session.json", "{", "[", "not what this version of `oxturn run` writes");
  changed("2/runs.csv", ",target,", ",cells,", "the planner is not deterministic");
  changed("2/runs.csv", "schema,", "scheme,", "its columns are not those of '");
  changed("2/runs.csv", ",ok,", ",fine,", "has outcome 'fine', which is none");
  const Said said = oxturn("merge " + a + " " + b + " --no-report" + to);
  EXPECT_EQ(said.code, 0) << "as it was, it can be merged: " << said.err;
}

}  // namespace
}  // namespace oxturn
