/// The tree of Berg 2021: pieces of successive boundaries, each a child of the piece that it grew from.
///
///   const BergTree tree(boundary, {.step = 0.2, .longest = 40, .spacing = 0.05}, keep, stop);
///   for (const BergTree::Piece& piece : tree.pieces()) drive(piece.points);
///
/// Source      Berg 2021, section 3.1
/// Model       a lap is the boundary at k steps of tether, k = 1, 2, ...; a piece lies between two dividers of a lap; a
///             region is a chain of pieces up to the next divider (the "area" of Berg 2021)
/// Complexity  p pieces, d dividers, m samples: O(m + p log p + d) for the tree; the gates of one path O(dividers lower
///             than all before them, seen from either end)
/// Decisions   1. Berg 2021 lets the robot "come closer" to pass a divider (figures 3.4, 3.5), without saying where.
///                Here it passes the divider's gate: the point next to the divider, on the node's side, where the robot
///                fits.
///             2. On the path from one piece to another the robot passes the gate of the lowest divider in between, and
///                on both sides of it the gates of the dividers that are lower than all before them, seen from the end
///                of the path. It turns to the side where the lowest gate lies farther out.
#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/tethered/berg_sweep.hpp"

namespace oxturn {

class BergTree {
 public:
  struct Piece {
    std::size_t lap = 0;                 // from 1
    double length = 0;                   // of tether, metres
    std::optional<std::size_t> divider;  // as BergBoundary::Piece
    std::optional<std::size_t> parent;   // of an earlier lap: empty pieces in between are left out
    std::vector<std::size_t> children;   // without those that lead to no points
    Polyline points;
  };
  struct Region {
    std::vector<std::size_t> pieces;    // by lap
    std::vector<std::size_t> children;  // beyond the next dividers
  };
  struct Laps {          // all in metres
    double step = 0;     // of tether between two laps
    double longest = 0;  // tether
    double spacing = 0;  // of samples
    BergThinning thinning = {};
    BergTrim trim = {};
  };

  /// `keep(p)` says whether a sample is to be driven; `stop` is called once per lap.
  BergTree(const BergBoundary& boundary, const Laps& laps, const std::function<bool(const Point&)>& keep,
           const std::function<bool()>& stop);

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Region>& regions() const { return regions_; }
  /// Regions without a divider before them.
  const std::vector<std::size_t>& roots() const { return roots_; }
  /// The dividers whose gates lie on the path from one piece to another, in order; none if one grew from the other.
  std::vector<std::size_t> between(std::size_t from, std::size_t to) const;

 private:
  class OpenLap;
  void add_laps(const Laps& laps, const std::function<bool(const Point&)>& keep, const std::function<bool()>& stop);
  std::vector<bool> find_useful() const;
  void add_regions(const std::vector<bool>& useful);
  bool grew_from(std::size_t piece, std::size_t ancestor) const;
  enum class Turn { left, right };
  /// Where a path passes dividers, from one to another.
  struct Passage {
    std::vector<std::size_t> gates;  // dividers
    double lowest;                   // length at the lowest divider in between
  };
  Passage passage(Turn turn, std::size_t from, std::size_t to) const;
  void find_lower_dividers();
  void number_pieces();
  double length_at(std::size_t divider) const { return boundary_.dividers()[divider].length; }

  const BergBoundary& boundary_;
  std::vector<Piece> pieces_;
  std::vector<Region> regions_;
  std::vector<std::size_t> roots_;
  // By divider: the next one that is lower, to the left and to the right round the boundary; itself for the lowest.
  std::vector<std::size_t> lower_left_, lower_right_;
  std::vector<std::pair<std::size_t, std::size_t>> span_;  // by piece: a child's span is within its parent's
};

}  // namespace oxturn
