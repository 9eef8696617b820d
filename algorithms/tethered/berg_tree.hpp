// The tree of Berg's thesis: pieces of successive boundaries, each the child of the piece that it grew from. It
// branches at dividers.
//
// Source      Berg, LTH 2021, section 3.1
// Model       a lap is a boundary at k steps of tether, k = 1, 2, ...; a piece is what lies between two dividers of a
//             lap; a region is a chain of pieces up to the next divider: the thesis's "area"
// Complexity  p pieces, d dividers: O(p times pieces of a lap) for the tree, O(d) for the gates of one way
// Decisions   1. The thesis lets the robot "come closer" to pass a divider (figures 3.4, 3.5), and does not say where.
//                Here it goes through the gate of the divider: the place next to it, on the node's side, where the
//                robot fits.
//             2. On the way from one piece to another the gates of those dividers are passed that no other one between
//                has to be passed farther in: the lowest one, and to both sides those that fall towards it. Of the two
//                ways round, that whose lowest gate lies farther out.
#pragma once

#include <functional>
#include <vector>

#include "algorithms/tethered/berg_boundary.hpp"

namespace oxturn {

class BergTree {
 public:
  struct Piece {
    int lap = 0;  // from 1
    double length = 0;
    int divider = -1;
    int parent = -1;
    std::vector<int> children;  // those that lead to anything
    Polyline points;
  };
  struct Region {
    std::vector<int> pieces;    // in the order of their laps
    std::vector<int> children;  // beyond the next dividers
  };

  /// Laps `step` apart up to `longest`. `keep(p, length)` says whether a sample is to be driven; `stop` is asked once a
  /// lap.
  BergTree(const BergBoundary& boundary, double step, double longest, double spacing,
           const std::function<bool(const Point&, double)>& keep, const std::function<bool()>& stop);

  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Region>& regions() const { return regions_; }
  /// Regions that no divider comes before.
  const std::vector<int>& roots() const { return roots_; }
  int laps() const { return laps_; }
  /// Indices of dividers whose gates lie on the way from one piece to another, in order; none if one of them grew from
  /// the other.
  std::vector<int> between(int from, int to) const;

 private:
  std::vector<int> run(int from, int to, bool left) const;
  bool grew_from(int piece, int ancestor) const;

  const BergBoundary& boundary_;
  std::vector<Piece> pieces_;
  std::vector<Region> regions_;
  std::vector<int> roots_;
  int laps_ = 0;
};

}  // namespace oxturn
