// Shards of a suite, put together again.
#include "bench/merge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/files.hpp"
#include "bench/run_suite.hpp"
#include "bench/shard.hpp"
#include "reports/built_in_registry.hpp"
#include "test_planners.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Shard, RangesAreConsecutiveAndCoverAll) {
  for (const std::size_t runs : {0U, 1U, 7U, 100U, 100000U})
    for (const std::size_t count : {1U, 2U, 3U, 16U, 200U}) {
      std::size_t next = 0;
      for (std::size_t k = 1; k <= count; ++k) {
        const auto [first, last] = Shard{k, count}.range(runs);
        EXPECT_EQ(first, next);
        EXPECT_LE(last - first, runs / count + 1);
        next = last;
      }
      EXPECT_EQ(next, runs);
    }
}

TEST(Shard, MistakesAreRefused) {
  EXPECT_EQ(parse_shard("3/16"), (Shard{3, 16}));
  for (const char* text : {"", "3", "0/4", "5/4", "1/0", "a/b", "1/2/3", "-1/2"})
    EXPECT_THAT([&] { parse_shard(text); }, ThrowsMessage<std::invalid_argument>(HasSubstr("expected K/N"))) << text;
}

constexpr const char* kSuite = R"(schema = 1
name = "many"
repeats = REPEATS
[robots.disc]
radius = 0.2
tool_width = 0.4
[[maps]]
generator = "rectangle"
width = 3
height = [2, 3]
[[planners]]
name = ["zigzag", "random-walk", "berg"]
)";

/// The suite, its parts and where they lie.
class Parts {
 public:
  explicit Parts(int repeats = 5) {
    std::string text = kSuite;
    text.replace(text.find("REPEATS"), 7, std::to_string(repeats));
    write_file(folder_.file("suite.toml"), text);
    suite = read_suite(folder_.file("suite.toml"), registry);
  }
  std::string file(const std::string& name) const { return folder_.file(name); }
  std::string run(const Shard& shard, const std::string& name) const {
    SuiteRunOptions options;
    options.folder = file(name);
    options.shard = shard;
    options.pictures = options.progress = false;
    run_suite_into_folder(suite, registry, options);
    return options.folder;
  }
  Registry registry = built_in_registry();
  Suite suite;

 private:
  Folder folder_;
};

/// runs.csv without the columns that differ from run to run.
std::string rows_of(const std::string& folder, const Registry& registry) {
  Columns columns;
  for (const Column& column : run_columns(registry.metrics))
    if (!column.timing) columns.push_back(column);
  std::string text;
  for (const Row& row : read_results(folder).rows) text += csv_line(row, columns);
  return text;
}

TEST(Merge, ShardsGiveTheTableOfOneRun) {
  const Parts parts;
  const std::string whole = parts.run({}, "whole");
  std::vector<std::string> folders;
  for (const std::size_t k : {2U, 3U, 1U})  // in any order
    folders.push_back(parts.run({k, 3}, "part" + std::to_string(k)));
  const Merged merged = merge(folders, parts.file("all"));
  EXPECT_EQ(merged.runs, 30u);
  EXPECT_EQ(merged.wanted, 30u);
  EXPECT_EQ(merged.duplicates, 0u);
  EXPECT_EQ(rows_of(parts.file("all"), parts.registry), rows_of(whole, parts.registry));
  for (const char* name : {"trace.csv", "columns.json"})
    EXPECT_EQ(read_file(parts.file("all/") + name), read_file(whole + "/" + name)) << name;
  for (const Row& row : read_results(parts.file("all")).rows)
    if (!row.get("path_file").empty()) { EXPECT_TRUE(fs::exists(parts.file("all/") + row.get("path_file"))); }
  EXPECT_TRUE(missing_runs(parts.suite, parts.registry.planners, {parts.file("all")}).empty());
}

TEST(Merge, MissingRunsAreNamedAndDuplicatesDropped) {
  const Parts parts;
  const std::string first = parts.run({1, 3}, "first"), again = parts.run({1, 3}, "again");
  const auto missing = missing_runs(parts.suite, parts.registry.planners, {first, again});
  ASSERT_EQ(missing.size(), 20u);
  EXPECT_EQ(missing[0].index, 10u);
  EXPECT_EQ(missing[0].variant, "berg");
  const Merged merged = merge({first, again}, parts.file("all"));
  EXPECT_EQ(merged.runs, 10u);
  EXPECT_EQ(merged.wanted, 30u);
  EXPECT_EQ(merged.duplicates, 10u);
}

TEST(Merge, OtherSuitesAndAttemptsThatDisagreeAreRefused) {
  const Parts parts(1), others(2);
  const std::string first = parts.run({1, 2}, "first"), second = parts.run({1, 2}, "second");
  const auto refused = [&](const std::string& sentence) {
    EXPECT_THAT(
        [&] {
          merge({first, second}, parts.file("all"));
        },
        ThrowsMessage<std::invalid_argument>(HasSubstr(sentence)));
    EXPECT_FALSE(fs::exists(parts.file("all/runs.csv")));
  };
  std::string rows = read_file(second + "/runs.csv");
  const std::string before = rows;
  const std::size_t at = rows.find(",target,");  // the promise of the first row
  rows.replace(at, 8, ",cells,");
  write_file(second + "/runs.csv", rows);
  refused("has promise 'target' in '");
  write_file(second + "/runs.csv", before);
  std::string session = read_file(second + "/session.json");
  const std::string identity = session;
  session.replace(session.find("\"identity\": \"") + 13, 4, "beef");
  write_file(second + "/session.json", session);
  refused("have different builds of oxturn");
  write_file(second + "/session.json", identity);
  const std::string other = others.run({1, 2}, "first");
  EXPECT_THAT(
      [&] {
        merge({first, other}, parts.file("all"));
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("have different contents of the suite")));
  EXPECT_THAT([&] { missing_runs(parts.suite, parts.registry.planners, {other}); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("holds results of another suite")));
  EXPECT_THAT([&] { merge({first}, second); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("already holds results")));
}

TEST(Merge, AnotherShardIsNotResumed) {
  const Parts parts(1);
  parts.run({1, 2}, "part");
  SuiteRunOptions options;
  options.folder = parts.file("part");
  options.shard = {2, 2};
  options.resume = true;
  options.progress = false;
  EXPECT_THAT([&] { run_suite_into_folder(parts.suite, parts.registry, options); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("holds shard 1/2 of the suite, not 2/2")));
}

}  // namespace
}  // namespace oxturn
