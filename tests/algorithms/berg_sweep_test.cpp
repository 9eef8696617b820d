// Berg's boundaries one after the other, how far nodes see, and the gates between pieces, against slow oracles.
#include "algorithms/tethered/berg_sweep.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "algorithms/tethered/berg_tree.hpp"
#include "maps/tether_model.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kTolerance = 4e-7;

/// A problem, and Berg's boundaries in it.
struct Scene {
  Problem problem;
  BergBoundary boundary;
  explicit Scene(const Map& map)
      : problem(map, robot()),
        boundary(problem.map().free, problem.map_edges(), problem.tether()->closed_gaps(), problem.anchor(), 1e9,
                 kTolerance) {}
  static Robot robot() {
    Robot r;
    r.tether = Tether{1e9};
    return r;
  }
};

Map floor(const char* generator, std::uint64_t seed) {
  return generate(generator, {{"width", 12.0}, {"height", 10.0}}, seed);
}

/// Up to the farthest point.
BergLengths lengths_from(double first, double step, const Scene& s) {
  BergLengths lengths{step, 0, first - step};
  while (lengths[lengths.count] < s.boundary.farthest()) ++lengths.count;
  return lengths;
}

using Pieces = std::vector<std::pair<std::optional<std::size_t>, Polyline>>;
Pieces with_points(const std::vector<BergBoundary::Piece>& pieces) {
  Pieces kept;
  for (const BergBoundary::Piece& piece : pieces)
    if (!piece.points.empty()) kept.emplace_back(piece.divider, piece.points);
  return kept;
}

TEST(BergSweep, FindsWhatEachBoundaryHasByItself) {
  std::size_t pieces = 0;
  for (const char* generator : {"clutter", "speckle", "rooms", "cave"})
    for (const auto seed : seeds(2)) {
      const Scene s(floor(generator, seed));
      const BergLengths lengths = lengths_from(0.05, 0.37, s);
      BergSweep sweep(s.boundary, {lengths, 0.1});
      for (std::size_t k = 0; k < lengths.count; ++k) {
        const double l = lengths[k];
        SCOPED_TRACE(fmt::format("{} --seed {} length {}", generator, seed, l));
        const Pieces found = with_points(sweep.next());
        pieces += found.size();
        EXPECT_EQ(found, with_points(s.boundary.at(l, 0.1)));
      }
    }
  EXPECT_GT(pieces, 500u);
}

// The oracle looks at every sample of every boundary. A sweep that forgets what was empty before may lose slivers
// between two samples.
TEST(BergSweep, TrimmedBoundariesAreThoseOfALookAtEverySample) {
  std::size_t kept = 0, left_out = 0, lost = 0;
  for (const char* generator : {"clutter", "speckle", "rooms", "cave", "maze", "spiral"})
    for (const auto seed : seeds(3)) {
      SCOPED_TRACE(fmt::format("{} --seed {}", generator, seed));
      const Scene s(floor(generator, seed));
      const auto shortest = [&](const Point& p) { return s.problem.tether()->geodesics().distance(p); };
      const BergLengths lengths = lengths_from(0.2, 0.2, s);
      BergSweep whole(s.boundary, {lengths, 0.05}), trimmed(s.boundary, {lengths, 0.05, {}, {shortest, 1e-5}});
      for (std::size_t k = 0; k < lengths.count; ++k) {
        const double l = lengths[k];
        std::vector<Point> expected, found;
        for (const auto& piece : whole.next())
          for (const Point& p : piece.points)
            if (std::abs(l - shortest(p)) <= 1e-5)
              expected.push_back(p);
            else
              ++left_out;
        for (const auto& piece : trimmed.next()) found.insert(found.end(), piece.points.begin(), piece.points.end());
        for (const Point& p : found) EXPECT_NEAR(shortest(p), l, 1e-5);
        for (std::vector<Point>* points : {&expected, &found}) std::ranges::sort(*points, before);
        kept += expected.size();
        std::vector<Point> missing;
        std::ranges::set_difference(expected, found, std::back_inserter(missing), before);
        lost += missing.size();
      }
    }
  RecordProperty("lost", static_cast<int>(lost));
  EXPECT_GT(kept, 50000u);
  EXPECT_GT(left_out, kept / 10);
  EXPECT_LT(lost, kept / 2000);
}

TEST(BergSweep, OfWhatIsNotToBeKeptNothingIsLostBeside) {
  std::size_t all = 0, left = 0;
  for (const char* generator : {"clutter", "speckle", "rooms", "cave"}) {
    const Scene s(floor(generator, 3));
    const auto shortest = [&](const Point& p) { return s.problem.tether()->geodesics().distance(p); };
    const auto keep = [&](const Point& p) { return s.problem.walls().contains(p); };
    for (const bool trims : {false, true}) {
      const BergTrim trim = trims ? BergTrim{shortest, 1e-5} : BergTrim{};
      const BergLengths lengths = lengths_from(0.2, 0.2, s);
      BergSweep whole(s.boundary, {lengths, 0.05, {}, trim}), kept(s.boundary, {lengths, 0.05, {}, trim, keep});
      for (std::size_t k = 0; k < lengths.count; ++k) {
        const double l = lengths[k];
        SCOPED_TRACE(fmt::format("{} length {} trims {}", generator, l, trims));
        std::vector<Point> expected, found;
        for (const auto& piece : whole.next()) {
          all += piece.points.size();
          std::ranges::copy_if(piece.points, std::back_inserter(expected), keep);
        }
        for (const auto& piece : kept.next()) found.insert(found.end(), piece.points.begin(), piece.points.end());
        left += found.size();
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) ASSERT_LT(distance(found[i], expected[i]), 1e-12);
      }
    }
  }
  EXPECT_LT(10 * left, 9 * all);
}

// Two blocks touch at (5, 5): one sees past them on both sides, but not between them.
TEST(BergSight, DoesNotPassBetweenObstaclesThatTouchInAPoint) {
  Region room = box_region({0, 0}, {10, 10});
  room.polygons[0].holes = {{{4, 4}, {4, 5}, {5, 5}, {5, 6}, {6, 6}, {6, 5}, {5, 5}, {5, 4}}};
  for (const bool one_ring : {true, false}) {
    SCOPED_TRACE(one_ring);
    if (!one_ring) room.polygons[0].holes = {{{4, 4}, {4, 5}, {5, 5}, {5, 4}}, {{5, 5}, {5, 6}, {6, 6}, {6, 5}}};
    const EdgeIndex walls(room);
    const BergSight sight(room, walls, {}, kTolerance);
    for (const Point& d : {Point(-1, 1), Point(-0.3, 2), Point(-2, 0.3), Point(0, 2), Point(-2, 0)})
      EXPECT_FALSE(sight.sees(Point(5, 5) + d, Point(5, 5) - d)) << d.transpose();
    EXPECT_TRUE(sight.sees({4, 7}, {5, 5}));
    EXPECT_TRUE(sight.sees({5, 6}, {5, 5}));
    EXPECT_TRUE(sight.sees({3, 4}, {9, 4}));
    const BergBoundary boundary(room, walls, {}, {3, 8}, 1e9, kTolerance);
    const GeodesicField field(room, {3, 8}, {}, kTolerance);
    ASSERT_GT(boundary.nodes().size(), 3u);
    for (const BergNode& node : boundary.nodes()) EXPECT_NEAR(node.before, field.distance(node.at), 1e-9);
  }
}

// Directions within the sector: on its sides one may see along a line of no width.
TEST(SightRange, IsNeverLessThanWhatIsSeenAndOftenLessThanWhatIsHidden) {
  std::size_t seen = 0, hidden = 0, known = 0;
  for (const char* generator : {"clutter", "cave", "rooms"}) {
    SCOPED_TRACE(generator);
    const Scene s(floor(generator, 1));
    const EdgeIndex& walls = s.problem.map_edges();
    for (const BergNode& node : s.boundary.nodes())
      for (double share = 0.03; share < 1; share += 0.0937)
        for (double radius = 0.1; radius < 12; radius *= 1.7) {
          const double turn = share * node.width, angle = node.begin + turn;
          const double range = node.range.range(node.range.slice_of(turn));
          if (walls.contains(node.at, node.at + radius * Point(std::cos(angle), std::sin(angle)))) {
            ++seen;
            ASSERT_GE(range, radius) << "node at " << node.at.transpose() << ", turn " << turn;
          } else {
            ++hidden;
            known += range < radius;
          }
        }
  }
  EXPECT_GT(seen, 1000u);
  EXPECT_GT(3 * known, 2 * hidden);
}

TEST(SightRange, WhatIsSurelySeenIsSeenAndThatIsMost) {
  std::size_t seen = 0, sure = 0, all = 0, unknown = 0;
  for (const char* generator : {"clutter", "cave", "rooms", "speckle"}) {
    SCOPED_TRACE(generator);
    const Scene s(floor(generator, 2));
    const bool no_gaps = s.problem.tether()->closed_gaps().empty();
    const EdgeIndex& walls = s.problem.map_edges();
    for (const BergNode& node : s.boundary.nodes())
      for (double share = 0.0013; share < 1; share += 0.0371)
        for (double radius = 0.05; radius < 12; radius *= 1.4) {
          const double turn = share * node.width, angle = node.begin + turn;
          const bool free = walls.contains(node.at, node.at + radius * Point(std::cos(angle), std::sin(angle)));
          const bool claimed = radius < node.range.sure(turn, turn);
          const SightRange::Answer answer = node.range.look(turn, Point(std::cos(angle), std::sin(angle)), radius);
          ++all;
          unknown += answer == SightRange::Answer::unknown;
          const bool wrong = answer == SightRange::Answer::seen     ? !free
                             : answer == SightRange::Answer::hidden ? free && no_gaps
                                                                    : false;
          ASSERT_FALSE(wrong) << "node at " << node.at.transpose() << ", turn " << turn << ", " << radius;
          seen += free;
          sure += claimed;
          ASSERT_TRUE(free || !claimed) << "node at " << node.at.transpose() << ", turn " << turn << ", " << radius;
        }
  }
  EXPECT_GT(seen, 10000u);
  EXPECT_GT(10 * sure, 7 * seen);
  EXPECT_LT(20 * unknown, all);
}

/// The distance of p to a polyline.
double distance_to(const Polyline& line, const Point& p) {
  double least = distance(line.front(), p);
  for (std::size_t i = 1; i < line.size(); ++i) least = std::min(least, distance_to_segment(p, line[i - 1], line[i]));
  return least;
}

TEST(BergSweep, WithoutNeedlessSamplesTheLapsAreTheSame) {
  constexpr double kError = 0.002;
  std::size_t all = 0, kept = 0;
  for (const char* generator : {"clutter", "speckle", "rooms", "cave"}) {
    const Scene s(floor(generator, 1));
    const EdgeIndex& walls = s.problem.walls();
    const auto is_free = [&](const Point& a, const Point& b) { return walls.contains(a, b); };
    const BergLengths lengths = lengths_from(0.1, 0.41, s);
    BergSweep plain(s.boundary, {lengths, 0.05}), thinned(s.boundary, {lengths, 0.05, {kError, is_free}});
    for (std::size_t k = 0; k < lengths.count; ++k) {
      const double l = lengths[k];
      SCOPED_TRACE(fmt::format("{} length {}", generator, l));
      const Pieces from = with_points(plain.next()), to = with_points(thinned.next());
      ASSERT_EQ(from.size(), to.size());
      for (std::size_t i = 0; i < from.size(); ++i) {
        ASSERT_EQ(from[i].first, to[i].first);
        const Polyline &samples = from[i].second, &left = to[i].second;
        all += samples.size();
        kept += left.size();
        std::size_t next = 0;  // of the samples: those left are some of them, in their order
        for (const Point& p : left) {
          while (next < samples.size() && samples[next] != p)
            EXPECT_LE(distance_to(left, samples[next++]), kError * 1.001);
          ASSERT_LT(next++, samples.size());
        }
        if (from[i].first) {  // else it is closed, and its end is where it begins
          EXPECT_EQ(samples.back(), left.back());
        }
      }
    }
  }
  EXPECT_LT(3 * kept, 2 * all);
}

TEST(BergSweep, DropsPiecesThatStayEmpty) {
  const Scene s(floor("clutter", 1));
  BergLengths lengths = lengths_from(0.05, 0.2, s);
  while (lengths[lengths.count - 1] < 2 * s.boundary.farthest()) ++lengths.count;
  BergSweep sweep(s.boundary, {lengths, 0.1});
  for (std::size_t k = 1; k < lengths.count; ++k) sweep.next();
  EXPECT_GT(s.boundary.dividers().size(), 10u);
  EXPECT_LE(sweep.next().size(), 1u);
}

/// The gates between two pieces as berg_tree.hpp says, decision 2, over all dividers.
std::vector<std::size_t> gates_by_search(const BergBoundary& boundary, const BergTree::Piece& from,
                                         const BergTree::Piece& to) {
  const std::size_t n = boundary.dividers().size();
  const auto length = [&](std::size_t d) { return boundary.dividers()[d].length; };
  std::vector<std::size_t> best;
  double farthest = -1;
  for (const bool left : {true, false}) {
    std::vector<std::size_t> all;
    const std::size_t last = left ? *to.divider : (*to.divider + 1) % n;
    for (std::size_t d = left ? (*from.divider + 1) % n : *from.divider;; d = (d + (left ? 1 : n - 1)) % n) {
      all.push_back(d);
      if (d == last) break;
    }
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (length(all[i]) < length(all[lowest])) lowest = i;
    if (length(all[lowest]) <= farthest) continue;
    farthest = length(all[lowest]);
    best.clear();
    double limit = from.length;
    for (std::size_t i = 0; i <= lowest; ++i)
      if (length(all[i]) < limit) {
        best.push_back(all[i]);
        limit = length(all[i]);
      }
    const std::size_t end = best.size();
    limit = to.length;
    for (std::size_t i = all.size(); --i > lowest;)
      if (length(all[i]) < limit) {
        best.insert(best.begin() + static_cast<std::ptrdiff_t>(end), all[i]);
        limit = length(all[i]);
      }
  }
  return best;
}

TEST(BergTree, GatesAreThoseOfASearchOverAllDividers) {
  std::size_t gates = 0;
  for (const auto seed : seeds(2)) {
    const Scene s(floor("clutter", seed));
    const BergTree tree(
        s.boundary, {0.3, 1e9, 0.1}, [](const Point&) { return true; }, [] { return false; });
    const auto grew_from = [&](std::size_t piece, std::size_t ancestor) {
      while (tree.pieces()[piece].lap > tree.pieces()[ancestor].lap && tree.pieces()[piece].parent)
        piece = *tree.pieces()[piece].parent;
      return piece == ancestor;
    };
    std::vector<std::size_t> driven;
    for (std::size_t i = 0; i < tree.pieces().size(); ++i)
      if (!tree.pieces()[i].points.empty()) driven.push_back(i);
    ASSERT_GT(driven.size(), 50u);
    for (std::size_t i = 0; i < driven.size(); i += 9)
      for (std::size_t k = 0; k < driven.size(); k += 11) {
        const std::size_t from = driven[i], to = driven[k];
        SCOPED_TRACE(fmt::format("clutter --seed {}: from piece {} to {}", seed, from, to));
        const bool related = grew_from(from, to) || grew_from(to, from);
        const auto expected =
            related ? std::vector<std::size_t>{} : gates_by_search(s.boundary, tree.pieces()[from], tree.pieces()[to]);
        gates += expected.size();
        ASSERT_EQ(tree.between(from, to), expected);
      }
  }
  EXPECT_GT(gates, 100u);
}

}  // namespace
}  // namespace oxturn
