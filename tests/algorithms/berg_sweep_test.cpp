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
      BergSweep sweep(s.boundary, 0.1);
      for (double l = 0.05; l < s.boundary.farthest(); l += 0.37) {
        SCOPED_TRACE(fmt::format("{} --seed {} length {}", generator, seed, l));
        const Pieces found = with_points(sweep.at(l));
        pieces += found.size();
        EXPECT_EQ(found, with_points(s.boundary.at(l, 0.1)));
      }
    }
  EXPECT_GT(pieces, 500u);
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
          const SightRange::Answer answer = node.range.look(turn, radius);
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

// What is dropped later is not tested for sight: the rest is the same.
TEST(BergSweep, OnlyUnwantedSamplesAreLeftOut) {
  std::size_t all = 0, kept = 0;
  for (const char* generator : {"clutter", "rooms", "cave"}) {
    const Scene s(floor(generator, 1));
    const auto unwanted = [&](const Point& p) { return !s.problem.walls().contains(p); };
    BergThinning thinning;
    thinning.is_wanted = [&](const Point& p) { return !unwanted(p); };
    BergSweep plain(s.boundary, 0.1), filtered(s.boundary, 0.1, thinning);
    for (double l = 0.05; l < s.boundary.farthest(); l += 0.37) {
      SCOPED_TRACE(fmt::format("{} length {}", generator, l));
      std::vector<BergBoundary::Piece> from = plain.at(l), to = filtered.at(l);
      ASSERT_EQ(from.size(), to.size());
      for (std::size_t i = 0; i < from.size(); ++i) {
        all += from[i].points.size();
        kept += to[i].points.size();
        std::erase_if(from[i].points, unwanted);
        std::erase_if(to[i].points, unwanted);
      }
      EXPECT_EQ(with_points(from), with_points(to));
    }
  }
  EXPECT_LT(kept, all);
}

TEST(BergSweep, WithoutNeedlessSamplesTheLapsAreTheSame) {
  constexpr double kError = 0.002;
  std::size_t all = 0, kept = 0;
  for (const char* generator : {"clutter", "speckle", "rooms", "cave"}) {
    const Scene s(floor(generator, 1));
    const EdgeIndex& walls = s.problem.walls();
    const auto is_free = [&](const Point& a, const Point& b) { return walls.contains(a, b); };
    BergSweep plain(s.boundary, 0.05), thinned(s.boundary, 0.05, {kError, is_free});
    for (double l = 0.1; l < s.boundary.farthest(); l += 0.41) {
      SCOPED_TRACE(fmt::format("{} length {}", generator, l));
      const Pieces from = with_points(plain.at(l)), to = with_points(thinned.at(l));
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
  BergSweep sweep(s.boundary, 0.1);
  for (double l = 0.05; l < s.boundary.farthest(); l += 0.2) sweep.at(l);
  EXPECT_GT(s.boundary.dividers().size(), 10u);
  EXPECT_LE(sweep.at(2 * s.boundary.farthest()).size(), 1u);
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
        s.boundary, {0.3, 1e9, 0.1}, [](const Point&, double) { return true; }, [] { return false; });
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
