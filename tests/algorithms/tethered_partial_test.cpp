// Partly occupied cells of tethered planners, on many small random problems: which cells are visited, how long the path
// and the tether may be, and what is left uncovered, each by brute force.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algorithms/transit/tether_space.hpp"
#include "metrics/score.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"
#include "tether_checks.hpp"

namespace oxturn {
namespace {

using Cell = std::pair<int, int>;
constexpr int kProblems = 100;
constexpr int kDriven = 5;  // of so many problems the tether is simulated in one

/// Random blocks, or narrow rooms; nullopt if the robot does not fit or the tether does not allow it to start.
std::optional<Problem> random_problem(Rng& rng) {
  std::vector<std::string> rows(3 + rng.below(4), std::string(3 + rng.below(5), '.'));
  const double walls = rng.between(0.0, 0.4);
  for (std::string& row : rows)
    for (char& letter : row)
      if (rng.unit() < walls) letter = '#';
  Robot robot;
  robot.radius = rng.between(0.1, 0.3);
  robot.tool_width = 2 * robot.radius * rng.between(0.6, 3.0);
  robot.tether = Tether{0, rng.between(0.3, 1.5)};
  const Region free = transformed(drawn_region(rows, rng.between(0.5, 1.0)),
                                  rng.below(2) == 0 ? 0 : rng.between(0.0, 6.0), Point(rng.between(-9.0, 9.0), 3));
  try {
    const Map map{"random", free, "drawn", "drawn"};
    std::optional<Point> anchor;
    if (rng.below(3) == 0) {
      Robot untethered = robot;
      untethered.tether.reset();
      const Problem whole(map, untethered);
      const Ring& ring = whole.configuration_space().polygons[0].outer;  // some vertex
      anchor = ring[rng.below(ring.size())];
    }
    return Problem(map, robot, {}, anchor);
  } catch (const std::invalid_argument&) { return std::nullopt; }
}

struct Planned {
  Path path;
  std::function<Region()> promised;
};
/// nullopt: infeasible.
std::optional<Planned> plan_promised(const std::string& planner, const Settings& settings, const Problem& problem) {
  Planned result;
  Context::Sinks sinks;
  sinks.promise = [&](std::function<Region()> region) { result.promised = std::move(region); };
  Context context(1, 1e9, sinks);
  try {
    result.path = built_in_planner(planner, settings)->plan(problem, context);
  } catch (const Infeasible&) { return std::nullopt; }
  return result;
}

/// Valid, back at the start, the tether within its length, and the promise is kept.
void expect_sound(const Problem& problem, const Planned& planned) {
  ScoreOptions options;
  ASSERT_TRUE(planned.promised);
  const Region promised = planned.promised();
  options.promise = Promise::cells;
  options.promised = &promised;
  const Score result = score(problem, planned.path, options);
  EXPECT_EQ(result.flaw, "");
  EXPECT_GE(result.value("promise_coverage").value_or(1), 0.999);
  ASSERT_FALSE(planned.path.legs.empty());
  EXPECT_LE(distance(planned.path.legs.back().points.back(), problem.start()), problem.tolerance());
}

double distance_to(const Path& path, const Point& p) {
  double least = 1e300;
  for (const Leg& leg : path.legs)
    for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k)
      least = std::min(least, distance_to_segment(p, leg.points[k - 1], leg.points[k]));
  return least;
}

/// Every sample of the space is within the tool's reach of the path, by brute force.
void expect_all_covered(const Problem& problem, const TetherSpace& space, const Path& path, Rng& rng) {
  const Box box = bounding_box(problem.configuration_space());
  const EdgeIndex& walls = problem.walls();
  const double reach = problem.robot().tool_width / 2 + space.cut_width() + problem.tolerance();
  for (int k = 0; k < 60; ++k) {
    Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    if (k % 2 == 0) p = walls.nearest(p)->point;
    if (!walls.contains(p) || (!space.unreached().empty() && contains(space.unreached(), p))) continue;
    EXPECT_LE(distance_to(path, p), reach) << p.transpose();
  }
}

struct Lattice {
  Point start;
  double side;
  Point centre(const Cell& c) const { return start + side * Point(c.first, c.second); }
};
const std::vector<Cell> kSteps{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

/// The cells whose centres lie in the space: 1; those that rounding may decide either way: 0.
std::map<Cell, int> free_cells(const Lattice& lattice, const Region& space, const EdgeIndex& walls) {
  const Box box = bounding_box(space);
  std::map<Cell, int> cells;
  const auto index = [&](double v) { return static_cast<int>(std::floor(v / lattice.side)); };
  for (int i = index(box.low.x() - lattice.start.x()); i <= index(box.high.x() - lattice.start.x()) + 1; ++i)
    for (int j = index(box.low.y() - lattice.start.y()); j <= index(box.high.y() - lattice.start.y()) + 1; ++j) {
      const Point c = lattice.centre({i, j});
      if (walls.nearest(c, 1e-9))
        cells[{i, j}] = 0;
      else if (walls.contains(c))
        cells[{i, j}] = 1;
    }
  return cells;
}

/// Steps over free segments between centres from the start's cell.
std::map<Cell, int> flood(const Lattice& lattice, const std::map<Cell, int>& cells, const EdgeIndex& walls) {
  std::map<Cell, int> steps{{{0, 0}, 0}};
  std::vector<Cell> queue{{0, 0}};
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (const Cell& step : kSteps) {
      const Cell to{queue[k].first + step.first, queue[k].second + step.second};
      const Point a = lattice.centre(queue[k]), b = lattice.centre(to);
      if (!cells.count(to) || steps.count(to) || !walls.contains(a, b) || walls.nearest(a, b, 1e-9)) continue;
      steps[to] = steps[queue[k]] + 1;
      queue.push_back(to);
    }
  return steps;
}

TEST(TetheredPartial, TetherTreeVisitsCellsAndDrivesWalls) {
  int judged = 0;
  for (const auto seed : seeds(kProblems)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const auto problem = random_problem(rng);
    if (!problem) continue;
    const bool geodesic = rng.below(3) > 0;
    const auto planned = plan_promised(
        "tether-tree", {{"partial", true}, {"reach", std::string(geodesic ? "geodesic" : "depth")}}, *problem);
    if (!planned) continue;
    ++judged;
    expect_sound(*problem, *planned);
    const TetherSpace space(*problem, "test");
    if (geodesic) expect_all_covered(*problem, space, planned->path, rng);

    // Cells of the start's component that steps over the lattice lead to.
    const Lattice lattice{problem->start(), problem->robot().tool_width / std::sqrt(2.0)};
    const Region& cut = space.cut_space();
    const EdgeIndex& walls = space.cut_problem().walls();
    const std::map<Cell, int> cells = free_cells(lattice, cut, walls);
    const double home = space.field().distance(problem->start()), limit = problem->robot().tether->length;
    for (const auto& [cell, steps] : flood(lattice, cells, walls))
      if (geodesic || home + steps * lattice.side <= limit * (1 - 1e-9)) {
        EXPECT_LT(distance_to(planned->path, lattice.centre(cell)), 1e-9);
      }
    if (space.components().size() > 1) continue;
    int ends = 0;
    for (const auto& [cell, certain] : cells)
      for (const Cell& step : kSteps) {
        const Point a = lattice.centre(cell), b = lattice.centre({cell.first + step.first, cell.second + step.second});
        if (!walls.contains(a, b) || walls.nearest(a, b, 1e-9)) ++ends;
      }
    EXPECT_LE(planned->path.length(),
              2 * (static_cast<double>(cells.size()) * lattice.side + perimeter(cut) + ends * lattice.side));
    if (judged % kDriven != 0) continue;
    const TetherFigures figures = drive_tethered(*problem, planned->path, 0.5);
    EXPECT_LE(figures.excess, 1e-6);
    EXPECT_EQ(figures.crossings, 0);
  }
  EXPECT_GT(judged, kProblems / 2);
}

// With reach = depth no point is farther from the start along the path's own tree than the tether is long. As the path
// goes there and back, the tree's distance is the length of the path driven, with what was driven back taken off.
TEST(TetheredPartial, TetherTreeIsNoDeeperThanTheTether) {
  for (const auto seed : seeds(kProblems / 4)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const auto problem = random_problem(rng);
    if (!problem) continue;
    const auto planned = plan_promised("tether-tree", {{"partial", true}}, *problem);
    if (!planned || planned->path.legs.size() != 1) continue;
    Polyline out;
    const double limit = problem->robot().tether->length - problem->tether()->geodesics().distance(problem->start());
    for (const Point& p : planned->path.legs[0].points) {
      if (out.size() > 1 && distance(out[out.size() - 2], p) < 1e-9)
        out.pop_back();
      else
        out.push_back(p);
      EXPECT_LE(length(out), limit + 1e-6);
    }
    EXPECT_LE(length(out), 1e-6);
  }
}

TEST(TetheredPartial, StcVisitsEveryFreeSubCellOnAShortPath) {
  int judged = 0, bounded = 0;
  for (const auto seed : seeds(kProblems)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const auto problem = random_problem(rng);
    if (!problem) continue;
    const bool geodesic = rng.below(3) > 0;
    const auto planned = plan_promised(
        "tethered-stc", {{"partial", true}, {"reach", std::string(geodesic ? "geodesic" : "depth")}}, *problem);
    if (!planned) continue;
    ++judged;
    if (planned->path.legs.empty()) continue;
    expect_sound(*problem, *planned);
    const TetherSpace space(*problem, "test");
    const Lattice lattice{problem->start(), problem->robot().tool_width / std::sqrt(2.0)};
    const EdgeIndex& walls = space.cut_problem().walls();
    const std::map<Cell, int> cells = free_cells(lattice, space.cut_space(), walls);
    const std::map<Cell, int> steps = flood(lattice, cells, walls);
    const double home = space.field().distance(problem->start()), limit = problem->robot().tether->length;
    const auto wanted = [&](const Cell& c) {
      return geodesic || (steps.count(c) && home + steps.at(c) * lattice.side <= limit * (1 - 1e-9));
    };
    int visited = 0, at_walls = 0;
    for (const auto& [cell, certain] : cells) {
      if (!wanted(cell)) continue;
      ++visited;
      const auto [i, j] = cell;
      if (certain == 1) { EXPECT_LT(distance_to(planned->path, lattice.centre(cell)), 1e-9) << i << " " << j; }
      bool at_wall = false;
      for (int a = i - 1; a <= i + 1; ++a)
        for (int b = j - 1; b <= j + 1; ++b) {
          at_wall |= !cells.count({a, b}) || cells.at({a, b}) == 0 || !wanted({a, b});
          for (const Cell& step : kSteps) {
            const Cell to{a + step.first, b + step.second};
            if (std::abs(to.first - i) > 1 || std::abs(to.second - j) > 1) continue;
            const Point p = lattice.centre({a, b}), q = lattice.centre(to);
            at_wall |= !walls.contains(p, q) || walls.nearest(p, q, 1e-9).has_value();
          }
        }
      at_walls += at_wall;
    }
    // Paths between sets of sub-cells come on top; so do those from a start on the boundary to the first sub-cell.
    const bool one_set = !geodesic || steps.size() == cells.size();
    if (space.components().size() > 1 || !one_set || walls.nearest(problem->start(), 1e-6)) continue;
    ++bounded;
    EXPECT_LE(planned->path.length(true), (visited + at_walls) * lattice.side + 1e-6);
    if (judged % kDriven != 0) continue;
    const TetherFigures figures = drive_tethered(*problem, planned->path, 0.5);
    EXPECT_LE(figures.excess, 1e-6);
    EXPECT_EQ(figures.crossings, 0);
  }
  EXPECT_GT(judged, kProblems / 2);
  EXPECT_GT(bounded, kProblems / 4);
}

TEST(TetheredPartial, ShnapsRimonLeavesNothingUncovered) {
  int judged = 0;
  for (const auto seed : seeds(kProblems / 4)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const auto problem = random_problem(rng);
    if (!problem) continue;
    Settings settings{{"cells", std::string("partial")}};
    const bool banded = rng.below(3) == 0;
    if (!banded && rng.below(2) == 0) settings["order"] = std::string("split");
    const auto planned = plan_promised(banded ? "shnaps-rimon-banded" : "shnaps-rimon", settings, *problem);
    if (!planned) continue;
    ++judged;
    expect_sound(*problem, *planned);
    const TetherSpace space(*problem, "test");
    expect_all_covered(*problem, space, planned->path, rng);
    EXPECT_LE(drive_tethered(*problem, planned->path, 0.5).longest,
              problem->robot().tether->length + problem->tolerance());
  }
  EXPECT_GT(judged, kProblems / 8);
}

}  // namespace
}  // namespace oxturn
