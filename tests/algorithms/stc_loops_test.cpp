// Loops around obstacles: each step against analytic cases or brute force, the planner on thousands of drawn maps.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/branch_tree.hpp"
#include "algorithms/grid/wall_loops.hpp"
#include "base/disjoint_sets.hpp"
#include "base/random.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

std::vector<std::string> random_drawing(Rng& rng, int columns, int rows, double blocked) {
  std::vector<std::string> drawing(static_cast<std::size_t>(rows), std::string(static_cast<std::size_t>(columns), '.'));
  for (std::string& row : drawing)
    for (char& c : row)
      if (rng.unit() < blocked) c = '#';
  drawing[rng.below(drawing.size())][rng.below(static_cast<std::size_t>(columns))] = 'S';
  return drawing;
}

// --- bisectors ---

TEST(BisectorNodes, SquareAndLShape) {
  const auto square = bisector_nodes({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0.5, 4);
  ASSERT_EQ(square.size(), 4u);
  const Point outside[] = {{-0.5, -0.5}, {2.5, -0.5}, {2.5, 2.5}, {-0.5, 2.5}};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(distance(square[k].at, outside[k]), 1e-12);
  // The boundary of a room, clockwise: every vertex is reflex, nodes are inside.
  const auto room = bisector_nodes({{0, 0}, {0, 2}, {2, 2}, {2, 0}}, 0.5, 4);
  ASSERT_EQ(room.size(), 4u);
  const Point inside[] = {{0.5, 0.5}, {0.5, 1.5}, {1.5, 1.5}, {1.5, 0.5}};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_LT(distance(room[k].at, inside[k]), 1e-12);
  // An L's inner vertex, where the arccos of the source would lead into the obstacle.
  const auto ell = bisector_nodes({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 4}, {0, 4}}, 0.25, 4);
  ASSERT_EQ(ell.size(), 6u);
  EXPECT_LT(distance(ell[3].at, {1.25, 1.25}), 1e-12);
}

TEST(BisectorNodes, OffBothEdgesByTheOffset) {
  Rng rng(7);
  for (int n = 0; n < 2000; ++n) {
    const Point a(rng.unit() * 4, rng.unit() * 4), b(rng.unit() * 4, rng.unit() * 4), c(rng.unit() * 4, rng.unit() * 4);
    if (std::abs(cross(b - a, c - a)) < 0.1) continue;
    for (const Ring& ring : {Ring{a, b, c}, Ring{a, c, b}}) {  // once as an obstacle, once as a room
      const double offset = 0.05, limit = 3;
      for (const BisectorNode& node : bisector_nodes(ring, offset, limit)) {
        const auto k = static_cast<std::size_t>(std::find(ring.begin(), ring.end(), node.vertex) - ring.begin());
        const Point &v = ring[k], &next = ring[(k + 1) % 3], &previous = ring[(k + 2) % 3];
        // Free space is on the right of previous -> v -> next.
        const double d1 = cross((v - previous).normalized(), node.at - v),
                     d2 = cross((next - v).normalized(), node.at - v);
        const double far = distance(node.at, v);
        if (far > std::max(distance(v, next), distance(v, previous)) + 2 * offset - 1e-9) continue;  // a cleft
        if (far < limit * offset * (1 - 1e-9) || cross(v - previous, next - v) < 0) {
          EXPECT_NEAR(d1, -offset, 1e-9);
          EXPECT_NEAR(d2, -offset, 1e-9);
        } else {  // one of the two that cut the vertex: off one edge by the offset, off the vertex by no less
          EXPECT_NEAR(std::max(std::abs(d1 + offset) < std::abs(d2 + offset) ? d1 : d2, -1.0), -offset, 1e-9);
          EXPECT_GE(far, offset);
          const Point bisector = ((v - previous).normalized() + (v - next).normalized()).normalized();
          EXPECT_NEAR((node.at - v).dot(bisector), limit * offset, 1e-9);
        }
      }
    }
  }
}

TEST(BisectorNodes, DegenerateWalls) {
  EXPECT_TRUE(bisector_nodes({}, 0.2, 2).empty());
  EXPECT_TRUE(bisector_nodes({{1, 1}, {1, 1}}, 0.2, 2).empty());
  // A wall without area: both tips are cut with two nodes each.
  EXPECT_EQ(bisector_nodes({{0, 0}, {1, 0}}, 0.2, 2).size(), 4u);
  // A cleft that closes to almost no width: no node lies far away.
  for (const BisectorNode& node : bisector_nodes({{0, 0}, {-1e-9, 3}, {1e-9, 3}, {1, 0}, {1, 5}, {-1, 5}}, 0.2, 2))
    EXPECT_LT(distance(node.at, node.vertex), 6);
}

// --- nodes ---

TEST(NodeLoops, CountAndGapAsPublished) {
  for (const auto& [d_node, count] : {std::pair{1.0, 3}, {1.1, 3}, {0.9, 4}, {4.0, 0}, {9.0, 0}}) {
    const auto loops = node_loops({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, d_node);
    ASSERT_EQ(loops.size(), 1u);
    const Polyline& loop = loops[0];
    EXPECT_EQ(loop.size(), static_cast<std::size_t>(4 * (count + 1) + 1));
    EXPECT_EQ(loop.front(), loop.back());
    for (std::size_t k = 0; k + 1 < loop.size(); ++k)
      EXPECT_NEAR(distance(loop[k], loop[k + 1]), 4.0 / (count + 1), 1e-12);
  }
  // Two squares that touch at the start are two loops.
  EXPECT_EQ(node_loops({{0, 0}, {1, 0}, {1, 1}, {0, 0}, {-1, 0}, {-1, -1}}, 0.6).size(), 2u);
  EXPECT_TRUE(node_loops({{1, 1}}, 1).empty());
  EXPECT_TRUE(node_loops({{1, 1}, {1, 1}}, 1).empty());
}

TEST(NodeLoops, ChainsAreWhatRemainsBetweenInvalidNodes) {
  Rng rng(3);
  for (int n = 0; n < 3000; ++n) {
    std::vector<Point> vertices;
    const std::size_t size = 3 + rng.below(6);
    for (std::size_t k = 0; k < size; ++k) {
      const double angle = 2 * kPi * static_cast<double>(k) / static_cast<double>(size);
      vertices.emplace_back(std::cos(angle), std::sin(angle));
    }
    const auto loops = node_loops(vertices, 0.2 + rng.unit());
    ASSERT_EQ(loops.size(), 1u);
    const Polyline& loop = loops[0];
    std::vector<bool> out(loop.size());
    const double share = rng.unit();
    for (std::size_t k = 0; k + 1 < out.size(); ++k) out[k] = rng.unit() < share;
    out.back() = out.front();
    // As many chains as there are valid nodes after an invalid one, with the same nodes, each from a free end.
    const std::vector<NodeChain> chains = chains_of(loop, out);
    const std::size_t ring = loop.size() - 1;
    std::size_t starts = 0, left = 0;
    for (std::size_t k = 0; k < ring; ++k) {
      left += !out[k];
      starts += !out[k] && out[(k + ring - 1) % ring];
    }
    if (left == ring) {
      ASSERT_EQ(chains.size(), 1u);
      EXPECT_TRUE(chains[0].closed);
      EXPECT_EQ(chains[0].nodes.front(), chains[0].nodes.back());
      continue;
    }
    EXPECT_EQ(chains.size(), starts);
    std::size_t nodes = 0;
    for (const NodeChain& chain : chains) {
      EXPECT_FALSE(chain.closed);
      nodes += chain.nodes.size();
      const auto first =
          static_cast<std::size_t>(std::find(loop.begin(), loop.end(), chain.nodes.front()) - loop.begin());
      EXPECT_TRUE(out[(first + ring - 1) % ring]) << "does not start at a free end";
      for (std::size_t k = 0; k < chain.nodes.size(); ++k) EXPECT_EQ(chain.nodes[k], loop[(first + k) % ring]);
    }
    EXPECT_EQ(nodes, left);
  }
}

// --- the tree ---

void expect_acyclic(const BranchTree& tree) {
  const auto edges = tree.edges();
  ASSERT_EQ(edges.size() + 1, tree.vertices().size());
  DisjointSets sets(tree.vertices().size());
  for (const auto& [a, b] : edges) EXPECT_TRUE(sets.unite(a, b)) << "a cycle in the tree";
}

/// The path around: closed, in free space, over every vertex; each branch and chain twice, each round once.
void expect_drive_around(BranchTree& tree, const EdgeIndex& space, double once, double twice) {
  const Polyline path = tree.path_around();
  EXPECT_EQ(path.front(), path.back());
  double most = once;
  for (const auto& [a, b] : tree.edges()) most += 2 * distance(tree.vertices()[a], tree.vertices()[b]);
  for (std::size_t k = 1; k < path.size(); ++k) EXPECT_TRUE(space.contains(path[k - 1], path[k]));
  EXPECT_LE(length(path), most + 1e-9);
  EXPECT_GE(length(path), once + 2 * twice - 1e-9);
  for (const Point& p : tree.vertices()) {
    double nearest = 1e9;
    for (std::size_t k = 1; k < path.size(); ++k)
      nearest = std::min(nearest, distance_to_segment(p, path[k - 1], path[k]));
    EXPECT_LT(nearest, 1e-9) << "a vertex is left out";
  }
}

TEST(BranchTree, IsATreeWhateverIsAttachedAndIsDrivenAround) {
  for (const auto seed : seeds(1500)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const auto drawing = random_drawing(rng, 6, 5, 0.35);
    const Problem problem = drawn(drawing);
    const EdgeIndex& space = problem.walls();
    const auto random_point = [&] {
      for (;;)
        if (const Point p(6 * rng.unit(), 5 * rng.unit()); space.contains(p)) return p;
    };
    // Paths over a lattice so coarse that on many maps it leads to no vertex.
    const GridGraph lattice = make_grid_graph_at(problem.configuration_space(), "drawn", problem.start(), 0.5);
    LatticePaths paths(lattice, problem.walls());
    BranchTree tree(problem, 0.5, paths);
    tree.begin({problem.start()}, BranchTree::Kind::chain);
    double once = 0, twice = 0;
    for (int n = 0; n < 12; ++n) {
      Polyline piece{random_point()};
      for (int k = 0; k < 3; ++k)
        if (const Point p = random_point(); space.contains(piece.back(), p)) piece.push_back(p);
      auto kind = BranchTree::Kind::chain;
      if (piece.size() > 2 && space.contains(piece.back(), piece.front())) {
        piece.push_back(piece.front());
        kind = rng.unit() < 0.5 ? BranchTree::Kind::round : BranchTree::Kind::loop;
      }
      // The nearest visible vertex, by brute force.
      double least = std::numeric_limits<double>::infinity();
      for (const Point& v : tree.vertices())
        if (space.contains(v, piece.front())) least = std::min(least, distance(v, piece.front()));
      const std::size_t before = tree.vertices().size(), edges_before = tree.edges().size();
      const auto attached = tree.attach(piece, kind);
      EXPECT_EQ(attached, std::isfinite(least) ? BranchTree::Attached::straight : BranchTree::Attached::by_path);
      (kind == BranchTree::Kind::round ? once : twice) += length(piece);
      const auto edges = tree.edges();
      for (std::size_t e = edges_before; e < edges.size(); ++e) {  // the branch: between old and new, or along the path
        const Point &a = tree.vertices()[edges[e].first], &b = tree.vertices()[edges[e].second];
        EXPECT_TRUE(space.contains(a, b));
        if (edges[e].first < before || attached == BranchTree::Attached::by_path) {
          const bool branch = edges[e].first < before || edges[e].second != edges[e].first + 1;
          if (branch && attached == BranchTree::Attached::straight) { EXPECT_DOUBLE_EQ(distance(a, b), least); }
        }
      }
    }
    expect_acyclic(tree);
    expect_drive_around(tree, space, once, twice);
  }
}

// --- the planner ---

TEST(StcLoops, ValidOnThousandsOfDrawnMaps) {
  for (const auto seed : seeds(1500)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    // Corridors of 0.45 to 1.3 m: some are too narrow for a coarse cell, some hardly wide enough for the robot.
    const double cell = 0.45 + 0.85 * rng.unit();
    const auto drawing = random_drawing(rng, 7, 6, 0.4 * rng.unit());
    const Problem problem = drawn(drawing, {.cell = cell});
    for (const char* fill : {"none", "spots"}) {
      RecordedPlan run;
      try {
        run = plan_recorded("stc-loops", problem, {{"fill", std::string(fill)}, {"close_loops", seed % 2 == 0}});
      } catch (const Infeasible&) { continue; }
      EXPECT_EQ(find_flaw(problem, run.path), "");
      EXPECT_EQ(run.figures["branches_lost"], 0);
    }
  }
}

TEST(StcLoops, CoversMoreThanStcWhereStcMissesSomething) {
  for (const char* generator : {"rectangle", "polygon", "clutter", "rooms", "maze", "cave", "comb", "spiral"})
    for (const auto seed : seeds(3)) {
      SCOPED_TRACE(fmt::format("{} --seed {}", generator, seed));
      Settings size{{"width", 10.0}, {"height", 8.0}};
      if (generator == std::string("polygon")) size["corners"] = std::int64_t{30};
      const Problem problem(generate(generator, size, seed), Robot{});
      double before = 0;
      try {
        before = score(problem, plan_recorded("stc", problem).path).value("coverage_upper").value();
      } catch (const Infeasible&) {}
      const Settings as_published{{"fill", std::string("none")}, {"epsilon", 0.05}, {"close_loops", false}};
      const Score published = score(problem, plan_recorded("stc-loops", problem, as_published).path);
      const Score whole = score(problem, plan_recorded("stc-loops", problem).path);
      EXPECT_EQ(published.flaw, "");
      EXPECT_EQ(whole.flaw, "");
      if (before < 0.97) { EXPECT_GT(published.value("coverage_lower").value(), before); }
      EXPECT_GE(whole.value("coverage_lower").value(), std::max(0.99, published.value("coverage_lower").value()));
    }
}

TEST(StcLoops, ASquarePillarHasOneUnbrokenLoop) {
  Polygon room = box_region({0, 0}, {8, 8}).polygons.front();
  room.holes.push_back({{3.5, 3.5}, {3.5, 4.5}, {4.5, 4.5}, {4.5, 3.5}});
  const Problem problem({"pillar", {{room}}, "test", ""}, Robot{}, Point(1, 1));
  const Settings published{{"fill", std::string("none")}};
  Settings walked = published;
  walked["close_loops"] = false;
  const RecordedPlan once = plan_recorded("stc-loops", problem, published),
                     twice = plan_recorded("stc-loops", problem, walked);
  EXPECT_EQ(once.figures.at("loops"), 2);
  EXPECT_EQ(once.figures.at("broken_loops"), 0);
  EXPECT_EQ(once.figures.at("chains"), 2);
  // There and back: the two loops once more. Offsets of 0.202 m: sides of 1.404 m and 7.596 m.
  EXPECT_NEAR(twice.path.length() - once.path.length(), 4 * 1.404 + 4 * 7.596, 1e-6);
  EXPECT_THAT(once.traces,
              testing::IsSupersetOf({"spanning tree", "bisectors", "nodes", "broken loops", "merged tree"}));
}

TEST(StcLoops, LoopsBrokenManyTimes) {
  // A row of pillars along a wall, too near to it and to each other for the robot: every loop is broken.
  Polygon room = box_region({0, 0}, {10, 4}).polygons.front();
  for (int k = 0; k < 6; ++k) {
    const double x = 1.5 + 1.2 * k;
    room.holes.push_back({{x, 0.3}, {x, 1.2}, {x + 0.9, 1.2}, {x + 0.9, 0.3}});
  }
  const Problem problem({"pillars", {{room}}, "test", ""}, Robot{}, Point(1, 3));
  const RecordedPlan run = plan_recorded("stc-loops", problem);
  EXPECT_EQ(run.figures.at("loops"), 7);
  EXPECT_EQ(run.figures.at("broken_loops"), 7);
  EXPECT_GE(run.figures.at("chains"), 7);
  const Score result = score(problem, run.path);
  EXPECT_EQ(result.flaw, "");
  EXPECT_GE(result.value("coverage_lower").value(), 0.99);
}

/// How often the path turns round on the spot.
int reversals(const Path& path) {
  int count = 0;
  for (const Leg& leg : path.legs)
    for (std::size_t k = 2; k < leg.points.size(); ++k) {
      const Point a = leg.points[k - 1] - leg.points[k - 2], b = leg.points[k] - leg.points[k - 1];
      count += a.dot(b) < -0.99 * a.norm() * b.norm();
    }
  return count;
}

// However the map is turned: nodes along a wall are not exactly on a straight line.
TEST(StcLoops, StraightRunsAreOneSegment) {
  for (const double angle : {0.0, 0.3, 1.1}) {
    SCOPED_TRACE(angle);
    const Problem problem({"room", transformed(box_region({0, 0}, {9.1, 7.3}), angle, {2, 1}), "test", ""}, Robot{});
    for (const Leg& leg : plan_recorded("stc-loops", problem).path.legs)
      for (std::size_t k = 2; k < leg.points.size(); ++k) {
        const Point a = leg.points[k - 1] - leg.points[k - 2], b = leg.points[k] - leg.points[k - 1];
        EXPECT_FALSE(a.dot(b) > 0 && std::abs(cross(a, b)) < 1e-10 * a.norm() * b.norm());
      }
  }
}

// What is left between the loops and the coarse cells is driven along, not cell by cell from the loop and back.
TEST(StcLoops, FillsAlongChainsNotBySpikes) {
  double turned = 0, points = 0;
  for (int k = 0; k < 12; ++k) {
    const double width = 5 + 0.11 * k, height = 6 - 0.07 * k;
    SCOPED_TRACE(fmt::format("{} x {}", width, height));
    const Problem problem({"room", box_region({0, 0}, {width, height}), "test", ""}, Robot{}, Point(1, 1));
    const RecordedPlan without = plan_recorded("stc-loops", problem, {{"fill", std::string("none")}}),
                       with = plan_recorded("stc-loops", problem);
    turned += reversals(with.path) - reversals(without.path);
    points += with.figures.at("fill_points");
    EXPECT_GE(score(problem, with.path).value("coverage_lower").value(), 0.99);
  }
  EXPECT_GT(points, 80);
  EXPECT_LT(turned, points / 4);
}

TEST(StcLoops, WithoutACoarseCellLoopsAreAttachedToTheStart) {
  const Problem problem({"corridor", box_region({0, 0}, {6, 0.6}), "test", ""}, Robot{}, Point(3, 0.3));
  EXPECT_THROW(plan_recorded("stc", problem), Infeasible);
  const Score result = score(problem, plan_recorded("stc-loops", problem).path);
  EXPECT_EQ(result.flaw, "");
  EXPECT_GE(result.value("coverage_lower").value(), 0.99);
}

}  // namespace
}  // namespace oxturn
