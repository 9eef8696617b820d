#include "algorithms/improve/part.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/improve/completion.hpp"
#include "algorithms/improve/moves.hpp"
#include "coverage_oracle.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"

namespace oxturn {
namespace {

TEST(Part, NamesAreInOrder) {
  for (std::size_t k = 0; k < part_names().size(); ++k)
    EXPECT_EQ(static_cast<std::size_t>(part_named(part_names()[k])), k);
  EXPECT_EQ(part_named("none"), AnnealingPart::none);
  EXPECT_EQ(part_named("detours"), AnnealingPart::detours);
  EXPECT_THAT([] { part_named("wall"); },
              testing::ThrowsMessage<std::invalid_argument>(testing::StrEq("unknown part 'wall'")));
}

// Whatever is left out, the coverage is reached, and the path is another one. A small map has no windows, this one
// needs no detours, and the tool is no wider than the robot. Of its starts the best is one without repair.
TEST(Part, EachLeftOutChangesThePathButNotWhatItCovers) {
  const Problem room(generate("rooms", {{"width", 7.0}, {"height", 5.0}, {"rooms", std::int64_t{4}}}, 3),
                     disc(0.2, 0.4));
  const auto with = [&](const std::string& name) {
    return plan("shortest", room, {{"coverage", 0.9995}, {"moves", 20000}, {"without", name}});
  };
  const std::string whole = bytes(plan("shortest", room, {{"coverage", 0.9995}, {"moves", 20000}}));
  for (const std::string& name : part_names()) {
    if (name == "strokes" || name == "detours") continue;
    SCOPED_TRACE(name);
    const Path path = with(name);
    expect_valid(room, path);
    EXPECT_GE(*score(room, path).value("coverage"), 0.9995);
    EXPECT_EQ(bytes(path) == whole, name == "none" || name == "windows" || name == "laps" || name == "unrepaired");
  }
}

/// The sum over three fields, whose paths cover what is asked for.
double metres_on_fields(double radius, double coverage, int moves, const std::string& without) {
  double sum = 0;
  for (const std::uint64_t seed : {4, 5, 6}) {
    SCOPED_TRACE(without + " " + std::to_string(seed));
    const Problem field(generate("field", {{"width", 100.0}, {"height", 70.0}, {"ponds", std::int64_t{6}}}, seed),
                        disc(radius, 3.0));
    const Path path = plan("shortest", field, {{"coverage", coverage}, {"moves", moves}, {"without", without}});
    expect_valid(field, path);
    EXPECT_GE(*score(field, path).value("coverage"), coverage);
    sum += path.length();
  }
  return sum;
}

TEST(Part, LapsLeftOutMakePathsOfAWideToolLonger) {
  EXPECT_LT(metres_on_fields(0.5, 0.9995, 100000, "none"), 0.985 * metres_on_fields(0.5, 0.9995, 100000, "laps"));
}

TEST(Part, StartsWithTheirDetoursMakePathsOfFieldsLonger) {
  EXPECT_LT(metres_on_fields(1, 0.9999, 200000, "none"), metres_on_fields(1, 0.9999, 200000, "unrepaired"));
}

TEST(Part, DetoursLeftOutMakeCompletedPathsLonger) {
  const Problem room(generate("rooms", {{"width", 7.0}, {"height", 5.0}, {"rooms", std::int64_t{4}}}, 3),
                     disc(0.2, 0.4));
  const Polyline lanes = vertices_of(plan("shortest", room, {{"coverage", 0.98}, {"moves", 20000}}), room.start());
  const auto completed = [&](AnnealingPart without) {
    const Completion completion(room, 0.9995, without);
    Context context(1);
    const Polyline path = completion.completed(lanes, completion.uncovered(lanes), context);
    EXPECT_GE(*score(room, driven(path)).value("coverage"), 0.9995);
    return length(path);
  };
  const double all = completed(AnnealingPart::none), no_strokes = completed(AnnealingPart::strokes),
               none = completed(AnnealingPart::detours);
  EXPECT_GT(no_strokes, 1.005 * all);
  EXPECT_GT(none, 1.005 * all);
}

TEST(Part, MovesLeftOutAreNotMade) {
  const EdgeIndex walls(box_region({0, 0}, {6, 6}));
  Polyline line;
  for (int k = 0; k < 12; ++k) {
    line.emplace_back(0.05, 0.1 + 0.4 * k);
    line.emplace_back(5.95, 0.1 + 0.4 * k);
  }
  const VertexPath path(line, {0}, 1);
  struct Kinds {
    int reordered = 0, on_wall = 0, many = 0;
  };
  const auto proposed = [&](AnnealingPart without) {
    Moves moves({.width = 1, .without = without}, walls);
    moves.uncovered({{3, 5.7}});
    Rng rng(5);
    Kinds kinds;
    for (int k = 0; k < 5000; ++k) {
      const auto change = moves.propose(path, rng);
      if (!change) continue;
      kinds.reordered += change->kind != Change::Kind::replace;
      for (std::size_t i = 0; i < change->point_count; ++i) {
        const Point& p = change->points.at(i);
        kinds.on_wall += p.x() > 0 && p.x() < 1e-4;
      }
      kinds.many += change->kind == Change::Kind::replace && change->point_count == 3;  // spikes
    }
    return kinds;
  };
  const Kinds all = proposed(AnnealingPart::none);
  EXPECT_GT(all.reordered, 100);
  EXPECT_GT(all.on_wall, 20);
  EXPECT_GT(all.many, 20);
  EXPECT_EQ(proposed(AnnealingPart::reordering).reordered, 0);
  EXPECT_LT(proposed(AnnealingPart::walls).on_wall, all.on_wall / 4);
  EXPECT_EQ(proposed(AnnealingPart::covering).many, 0);
}

}  // namespace
}  // namespace oxturn
