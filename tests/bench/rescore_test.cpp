#include "bench/rescore.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/file.h>

#include <filesystem>
#include <map>
#include <set>

#include "base/files.hpp"
#include "bench/run_suite.hpp"
#include "bench/session_file.hpp"
#include "bench/wire.hpp"
#include "test_planners.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;
using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

/// `tied` minds the tether, which `test` can only ignore.
const Registry& registry() {
  static const Registry all = [] {
    Registry registry = testing::test_registry_copy();
    PlannerInfo tied = registry.planners.find("test");
    tied.name = "tied";
    tied.capabilities = {Capability::tether};
    tied.promise = Promise::target;
    registry.planners.add(tied);
    return registry;
  }();
  return all;
}

MapSpec rectangle(double width) {
  MapSpec map;
  map.generator = "rectangle";
  map.settings = {{"width", width}, {"height", 2.0}};
  return map;
}

/// Every outcome that has a path and some that have none, with and without a tether, which is too short for some.
Suite suite() {
  Suite suite;
  suite.name = "test";
  suite.limits = {.wall_s = 60, .memory_mb = 2000};
  suite.robots.resize(2);
  suite.robots[1].name = "tied";
  suite.robots[1].tether = Tether{1.2};
  suite.maps = {rectangle(3)};
  for (const char* how : {"good", "partial", "wall", "nan", "null", "throw", "promise"})
    suite.planners.push_back({"test", {{"how", how}}});
  suite.planners.push_back({"test", {{"how", "good"}}, true});
  // A value that looks like another setting.
  suite.planners.push_back({"tied", {{"how", "good"}}});
  suite.planners.push_back({"tied", {{"how", "not_ignore_tether=true"}}});
  suite.planners.push_back({"tied", {{"how", "partial"}}});
  return suite;
}

Suite two_runs() {
  Suite two = suite();
  two.robots.resize(1);
  two.planners.resize(2);
  return two;
}

Results ran(const Suite& suite, const std::string& folder, bool pictures = true) {
  SuiteRunOptions options;
  options.folder = folder;
  options.progress = false;
  options.pictures = pictures;
  return run_suite(suite, registry(), options);
}

/// Every file below the folder but runs.csv, with its content; links are not followed.
std::map<std::string, std::string> files_of(const std::string& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().filename() != "runs.csv")
      files[fs::relative(entry.path(), folder).string()] = read_file(entry.path().string());
  return files;
}

std::vector<std::map<std::string, std::string>> untimed(const Results& results) {
  std::vector<std::map<std::string, std::string>> rows;
  for (const Row& row : results.rows) {
    rows.push_back(row.cells.all());
    rows.back().erase("score_s");
  }
  return rows;
}

void replace_in(const std::string& file, const std::string& what, const std::string& with) {
  std::string text = read_file(file);
  ASSERT_NE(text.find(what), std::string::npos) << what;
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += with.size())
    text.replace(at, what.size(), with);
  write_file(file, text);
}

/// The sentence with which the folder is refused; nothing in it changes.
std::string refusal(const std::string& folder) {
  const auto files = files_of(folder);
  const std::string rows = read_file(folder + "/runs.csv");
  std::string sentence;
  try {
    rescore(folder, registry(), false);
  } catch (const std::invalid_argument& e) { sentence = e.what(); }
  EXPECT_EQ(files_of(folder), files);
  EXPECT_EQ(read_file(folder + "/runs.csv"), rows);
  EXPECT_FALSE(fs::exists(folder + "/.rescore"));
  return sentence;
}

TEST(Rescore, WithTheSameMetricsNothingChanges) {
  const Folder folder;
  const std::string out = folder.file("out");
  const Results before = ran(suite(), out);
  std::set<std::string> outcomes;
  for (const Row& row : before.rows) outcomes.insert(row.get("outcome"));
  EXPECT_THAT(outcomes, ::testing::IsSupersetOf({"ok", "partial", "invalid", "crash", "error", "unsupported"}));
  const auto files = files_of(out);
  EXPECT_TRUE(fs::exists(out + "/tethers"));
  const Results after = rescore(out, registry(), false);
  EXPECT_EQ(untimed(after), untimed(before));
  EXPECT_EQ(files_of(out), files);
  EXPECT_EQ(after.pictures, before.pictures);
}

TEST(Rescore, ATimeoutRemainsOne) {
  const Folder folder;
  Suite timeouts = two_runs();
  timeouts.limits.wall_s = 1;
  timeouts.planners = {{"test", {{"how", "publish"}}}};
  const Results before = ran(timeouts, folder.file("out"));
  EXPECT_EQ(before.rows[0].outcome(), Outcome::timeout);
  EXPECT_EQ(untimed(rescore(folder.file("out"), registry(), false)), untimed(before));
}

// It was scoring that broke the limit, not the planner: with a higher limit the run is what it should have been.
TEST(Rescore, ALimitThatScoringBrokeIsForgotten) {
  const Folder folder;
  const std::string out = folder.file("out");
  const Results before = ran(two_runs(), out);
  ASSERT_EQ(before.rows[0].outcome(), Outcome::ok);
  replace_in(out + "/runs.csv", ",ok,,", ",timeout,scoring: no result after 60 s,");
  EXPECT_EQ(untimed(rescore(out, registry(), false)), untimed(before));
}

TEST(Rescore, NewMetricsAndTargetsTakeEffect) {
  const Folder folder;
  const std::string out = folder.file("out");
  ran(two_runs(), out);
  Registry more = registry();
  more.metrics.add({"points", "count", Better::lower, "points of the path", [](const Scored& s) {
                      double points = 0;
                      for (const Leg& leg : s.path.legs) points += static_cast<double>(leg.points.size());
                      return std::optional<double>(points);
                    }});
  replace_in(out + "/session.json", "\"target_coverage\": 0.99", "\"target_coverage\": 0.01");
  const Results after = rescore(out, more, false);
  EXPECT_GT(after.rows[0].number("points"), 10);
  EXPECT_EQ(after.rows[1].number("points"), 2);
  EXPECT_EQ(after.rows[1].outcome(), Outcome::ok);  // was partial
  EXPECT_THAT(read_file(out + "/columns.json"), HasSubstr("points of the path"));
}

// The rows of a folder are scored by one build: another one may not add to them before it has scored them all.
TEST(Rescore, TheBuildThatScoredIsOnRecord) {
  const Folder folder;
  const std::string out = folder.file("out");
  ran(two_runs(), out);
  EXPECT_THAT(read_file(out + "/session.json"), Not(HasSubstr("rescored")));
  const std::string own = read_session_file(out).build_identity();
  replace_in(out + "/session.json", own, "another build");
  rescore(out, registry(), false);
  const SessionFile session = read_session_file(out);
  EXPECT_EQ(session.build_identity(), "another build");
  EXPECT_EQ(session.scoring_identity(), own);
  EXPECT_THAT(summary(session).back(), HasSubstr(own));

  replace_in(out + "/session.json", own, "a third build");
  replace_in(out + "/session.json", "another build", own);
  SuiteRunOptions options;
  options.folder = out;
  options.resume = true;
  options.progress = false;
  EXPECT_THAT(
      [&] { run_suite(two_runs(), registry(), options); },
      ThrowsMessage<std::invalid_argument>(HasSubstr("scored again by another build of oxturn (a third build")));
  rescore(out, registry(), false);
  EXPECT_NO_THROW(run_suite(two_runs(), registry(), options));
}

TEST(Rescore, UnknownColumnsAreDropped) {
  const Folder folder;
  const std::string out = folder.file("out");
  const Results before = ran(two_runs(), out);
  const std::string rows = read_file(out + "/runs.csv");
  std::string wider;
  for (std::size_t begin = 0, end; (end = rows.find('\n', begin)) != std::string::npos; begin = end + 1)
    wider += rows.substr(begin, end - begin) + (begin == 0 ? ",colour\n" : ",red\n");
  write_file(out + "/runs.csv", wider);
  EXPECT_EQ(untimed(rescore(out, registry(), false)), untimed(before));
  EXPECT_THAT(read_file(out + "/runs.csv"), Not(HasSubstr("colour")));
}

TEST(Rescore, DrawsOnlyIfTheFolderHasPictures) {
  const Folder folder;
  const std::string out = folder.file("out");
  ran(two_runs(), out, false);
  const auto files = files_of(out);
  rescore(out, registry(), false);
  EXPECT_EQ(files_of(out), files);
}

// What was computed before the defect is found is not written.
TEST(Rescore, RefusesWithoutWritingAnything) {
  const Folder folder;
  const std::string out = folder.file("out");
  const Results results = ran(two_runs(), out);
  const std::string id = results.rows[1].get("run_id"), hash = results.rows[1].get("problem_sha256");
  const std::string path = out + "/paths/" + id + ".geojson", problem = out + "/maps/" + hash + ".geojson";
  const std::string rows = read_file(out + "/runs.csv"), legs = read_file(path), map = read_file(problem);
  write_file(folder.file("x.geojson"), legs);

  fs::remove(path);
  EXPECT_THAT(refusal(out), HasSubstr("no such file: '" + path + "', which run " + id + " needs"));
  fs::create_symlink(folder.file("x.geojson"), path);
  EXPECT_THAT(refusal(out), HasSubstr(path + "' is a symbolic link that leads out of the folder"));
  fs::remove(path);
  write_file(path, "{\"type\": \"Feature");
  EXPECT_THAT(refusal(out), HasSubstr(path));
  write_file(path, legs);
  replace_in(path, "\"tool\": true", "\"tool\": false");
  EXPECT_THAT(refusal(out), HasSubstr(path + ": not the path that run " + id + " left"));
  write_file(path, legs);

  replace_in(problem, "\"radius\": 0.2", "\"radius\": 0.19");
  EXPECT_THAT(refusal(out), HasSubstr(problem + ": not the problem of run "));
  fs::remove(problem);
  EXPECT_THAT(refusal(out), HasSubstr("no such file: '" + problem));
  write_file(problem, map);

  replace_in(out + "/runs.csv", id, "../../x");
  EXPECT_THAT(refusal(out), HasSubstr("run_id '../../x' is not made of"));
  write_file(out + "/runs.csv", rows);
  replace_in(out + "/runs.csv", hash, "../../x");
  EXPECT_THAT(refusal(out), HasSubstr("problem_sha256 '../../x' is not made of"));
  write_file(out + "/runs.csv", rows);
  EXPECT_EQ(untimed(rescore(out, registry(), false)), untimed(results));
}

TEST(Rescore, FollowsNoLinkOutOfTheFolder) {
  for (const char* kind : {"maps", "paths", "pictures"}) {
    const Folder folder;
    const std::string out = folder.file("out");
    ran(two_runs(), out);
    fs::rename(out + "/" + kind, folder.file("elsewhere"));
    fs::create_directory_symlink(folder.file("elsewhere"), out + "/" + kind);
    const auto files = files_of(folder.file("elsewhere"));
    EXPECT_THAT(refusal(out), HasSubstr("is a symbolic link that leads out of the folder")) << kind;
    EXPECT_EQ(files_of(folder.file("elsewhere")), files) << kind;
  }
}

// The column path_file is for readers of the table; what is read and written follows from run_id.
TEST(Rescore, ThePathFileOfARowIsNotFollowed) {
  const Folder folder;
  const std::string out = folder.file("out");
  const Results before = ran(two_runs(), out);
  write_file(folder.file("x.geojson"), "precious");
  replace_in(out + "/runs.csv", before.rows[0].get("path_file"), "../x.geojson");
  EXPECT_EQ(untimed(rescore(out, registry(), false)), untimed(before));
  EXPECT_EQ(read_file(folder.file("x.geojson")), "precious");
}

TEST(Rescore, WaitsForNobody) {
  const Folder folder;
  const std::string out = folder.file("out");
  ran(two_runs(), out);
  const wire::Descriptor other(::open((out + "/runs.csv").c_str(), O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(::flock(other.number(), LOCK_EX), 0);
  EXPECT_THAT(refusal(out), HasSubstr("another process is writing to"));
}

std::string removed_folder;  // by a metric, which runs before the pictures are drawn

TEST(Rescore, SaysWhatCouldNotBeDrawn) {
  const Folder folder;
  const std::string out = folder.file("out");
  ran(two_runs(), out);
  removed_folder = out + "/.rescore/pictures";
  Registry broken = registry();
  broken.metrics.add({"none", "1", Better::neither, "removes a folder", [](const Scored&) {
                        fs::remove_all(removed_folder);
                        return std::optional<double>();
                      }});
  ::testing::internal::CaptureStderr();
  try {
    rescore(out, broken);
  } catch (const std::exception&) {  // the folder is missing to the end
  }
  EXPECT_THAT(::testing::internal::GetCapturedStderr(), HasSubstr("drawing: cannot write"));
}

}  // namespace
}  // namespace oxturn
