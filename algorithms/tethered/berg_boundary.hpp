// The boundary of Berg's thesis: what lies at one length of tether, as arcs about nodes, and the dividers that cut
// it.
//
// Source      Berg, "A Geometric Algorithm for Online Tethered Navigation", LTH 2021, section 3.1
// Model       the anchor is the first node, its arc a whole circle. A convex obstacle corner one side of which is
//             hidden from its parent node is a node; its arc runs from the corner's hidden edge to the straight
//             continuation of the tether (closed sectors). Radius: the tether's length less the way to the node.
// Complexity  n corners, k nodes: O(k n) tests of sight for nodes and as many for dividers, each O(cells crossed +
//             barriers): the thesis's "scales poorly for large distances in environments with many corners". A
//             boundary: one test of sight a sample.
// Decisions   1. A corner is looked at once, by the node that reaches it with the least tether (the thesis: "when a
//                corner is passed but not included it is never considered for the algorithm again"). Without this rule
//                the tether would wind round obstacles in every way that its length allows, exponentially many; with
//                it each node lies on the true shortest way, and behind an obstacle only the last nodes' arcs overlap.
//             2. Sight is exact: a corner that the line of sight touches does not hide what is behind it, so a corner
//                cannot hide itself (the thesis takes out the cells next to it).
//             3. Whether a corner lies in a sector is exact. Feet of perpendiculars are rounded: they count as inside
//                if they are outside by rounding only, and one that two nodes claim divides once.
//             4. A divider is a place on a wall where the distance from the node has a local minimum along the wall,
//                and which the node sees in its sector. In the graph of distance over angle (figure 3.6) that is the
//                local minimum: a corner past which the graph jumps up counts. The room's own walls count.
//             5. Dividers keep one place in the order round the boundary, whatever the length: from right to left, a
//                node's sector with the sectors of its children between the arcs to both sides of them.
//             6. Gaps that the robot cannot pass are closed by barriers, which act as walls: the tether's way is the
//                robot's way pulled taut. (The thesis takes robots small against all gaps.)
//             7. An anchor on a wall is moved off it by the tolerance; the wall is its first divider.
#pragma once

#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct BergNode {
  Point at{0, 0};
  double before = 0;       // metres of tether up to here
  int parent = -1;         // -1: the anchor itself
  int side = 0;            // of the tether, on which the hidden region lies: -1 right, +1 left; 0: the anchor
  Point hidden{0, 0};      // the other end of the hidden edge
  double begin = 0;        // radians: the sector's right side
  double width = 2 * kPi;  // radians
  double reach = 0;        // metres: nothing of the sector is farther in sight
};

struct BergDivider {
  Point at{0, 0};
  int node = 0;
  double length = 0;  // of tether, at which it begins to divide
};

class BergBoundary {
 public:
  /// `walls` are the edges of `free` and must outlive it; `barriers` are segments between walls that act as walls.
  /// Nodes and dividers up to a tether of `longest` metres.
  BergBoundary(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers, const Point& anchor,
               double longest, double tolerance);

  /// By growing `before`; the first is the anchor.
  const std::vector<BergNode>& nodes() const { return nodes_; }
  /// Counter-clockwise round the boundary.
  const std::vector<BergDivider>& dividers() const { return dividers_; }
  /// No boundary is seen at a longer tether than this.
  double farthest() const;

  /// What is between two dividers, counter-clockwise, sampled; what is hidden from its node is left out.
  struct Piece {
    int divider = -1;  // where it begins, an index into dividers(); -1: nothing divides, it goes all the way round
    Polyline points;
  };
  /// In the order of their dividers; at least one piece, and pieces may be empty. Ends of arcs are samples; between
  /// them at most `spacing` metres apart.
  std::vector<Piece> at(double length, double spacing) const;

 private:
  /// Free space lies counter-clockwise from `next` to `previous`. Where a barrier ends there is one on each side of it.
  struct Corner {
    Point at, previous, next;
    bool at_barrier = false;
  };
  struct Barrier {
    Point from, to;  // a little into the wall where they do not end at a corner
  };
  struct BarrierEnd {  // at a corner of a ring
    Point at, other, previous, next;
  };
  struct Event {  // on the way round a node's sector
    Point at;
    bool divides = false;
    int index = 0;  // of the divider or the child node
    int group = 0, rank = 0;
    double key = 0;
    double angle = 0;  // from `begin`
  };
  class Walk;

  void add_barrier(const Point& from, const Point& to);
  Point add_barrier_end(const Point& at, const Point& other);
  static bool in_wedge(const Corner& corner, const Point& p);
  bool sees(const Point& eye, const Point& p) const;
  bool in_sector(const BergNode& node, const Point& p) const;
  bool about_in_sector(const BergNode& node, const Point& p) const;
  int hidden_side(const Point& eye, const Corner& corner) const;
  void find_nodes(double longest);
  void find_dividers(double longest);
  void find_reach(const Region& free);
  void sort_events();
  void drop_repeated_dividers();

  const EdgeIndex& walls_;
  double tolerance_;
  std::vector<Corner> corners_;
  std::vector<Barrier> barriers_;
  std::vector<BarrierEnd> barrier_ends_;
  std::vector<BergNode> nodes_;
  std::vector<BergDivider> dividers_;
  std::vector<std::vector<Event>> events_;  // by node
};

}  // namespace oxturn
