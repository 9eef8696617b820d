/// The boundaries of Berg 2021: the points at one length of tether, as arcs about nodes, and their dividers.
///
///   const BergBoundary boundary(free, walls, barriers, anchor, 40, tolerance);
///   for (const BergBoundary::Piece& piece : boundary.at(3.5, 0.05)) draw(piece.points);
///
///         . - - - .
///       .     o     .        o  the anchor, the first node: its arc is the whole circle.
///      .        -    .       +  A corner that hides something from its parent node is a node as well. Its arc (*) runs
///      . ########+    .         from the corner's hidden edge to the straight continuation of the tether (closed
///        ########|  *           sector). Its radius is the tether length less the path to the corner.
///        ########| *
///
/// Source      Berg, "A Geometric Algorithm for Online Tethered Navigation", LTH 2021, section 3.1
/// Complexity  n corners: O(n log n), and for each node the triangles that it sees in its sector, with a test of sight
///             for feet on walls there; on real maps O(n log n). (Berg 2021 "scales poorly for large distances in
///             environments with many corners".) A boundary: one test of sight per sample, without those in directions
///             in which nothing so far away is seen (sight_range.hpp).
/// Decisions   1. A corner is looked at once, by the node that reaches it with the least tether ("when a corner is
///                passed but not included it is never considered for the algorithm again"). Without this rule the
///                tether would wind round obstacles as its length allows, in exponentially many classes. With the rule
///                each node lies on the true shortest path, and only behind an obstacle the last nodes' arcs
///                overlap.
///             2. Sight is exact: a corner that the line of sight touches does not hide what is behind it, so a corner
///                cannot hide itself (Berg 2021 removes the grid cells next to it).
///             3. Whether a corner lies in a sector is exact. Feet of perpendiculars are rounded: they count as inside
///                if they are outside by rounding only, and a foot that two nodes find divides once.
///             4. A divider is a point on a wall where the distance from the node has a local minimum along the wall,
///                and which the node sees in its sector. In the graph of distance over angle (figure 3.6) that is a
///                local minimum; a corner behind which the graph jumps up counts. The room's own walls count.
///             5. Dividers have a fixed order round the boundary, whatever the length: from right to left, a node's
///                sector contains the sectors of its children between the arcs on both sides of them.
///             6. Gaps that the robot cannot pass are closed by barriers, which act as walls: the tether's path is the
///                robot's path pulled taut. (Berg 2021 assumes robots smaller than all gaps.)
///             7. Of what is seen along a single line only, between walls that touch it on both sides, corners and
///                dividers count, but no samples.
///             8. An anchor on a wall is moved off it by the tolerance; the wall is its first divider.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/tethered/berg_sight.hpp"
#include "algorithms/tethered/sight_range.hpp"

namespace oxturn {

/// The side of a corner, as seen from a node along the tether, on which the corner hides a region. In counter-clockwise
/// order.
enum class HiddenSide { right, none, left };

struct BergNode {
  Point at{0, 0};
  double before = 0;                   // metres of tether from the anchor to the node
  std::optional<std::size_t> parent;   // nullopt: the node is the anchor
  HiddenSide side = HiddenSide::none;  // none: the anchor
  Point hidden{0, 0};                  // the other end of the hidden edge
  double begin = 0;                    // direction of the sector's right side, radians
  double width = 2 * kPi;              // of the sector, radians
  double reach = 0;                    // metres: no point of the sector that the node sees is farther away
  SightRange range;                    // the same by direction; angles count from `begin`
};

struct BergDivider {
  Point at{0, 0};
  std::size_t node = 0;
  double length = 0;  // of tether from which on it divides
};

class BergBoundary {
 public:
  /// `walls` are the edges of `free` and must outlive it; `barriers` are segments between walls that act as walls.
  /// Nodes and dividers up to `longest` metres of tether.
  BergBoundary(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers, const Point& anchor,
               double longest, double tolerance);

  /// By increasing `before`; the first is the anchor.
  const std::vector<BergNode>& nodes() const { return nodes_; }
  /// Counter-clockwise round the boundary.
  const std::vector<BergDivider>& dividers() const { return dividers_; }
  /// No boundary is visible at more tether than this, metres.
  double farthest() const;

  /// The part of a boundary between two dividers, counter-clockwise, sampled; without the points hidden from their
  /// node.
  struct Piece {
    std::optional<std::size_t> divider;  // where it begins; nullopt: no divider acts, the piece goes all the way round
    Polyline points;
  };
  /// In the order of their dividers; at least one piece, and pieces may be empty. Pieces are left out that are empty at
  /// all greater lengths, too. Ends of arcs are samples; samples of an arc are at most `spacing` metres apart.
  /// O(nodes + dividers); boundaries one after the other cost less by berg_sweep.hpp.
  std::vector<Piece> at(double length, double spacing) const;

 private:
  /// What one meets while the direction of sight from a node turns counter-clockwise through its sector.
  struct Event {
    Point at;
    bool is_divider = false;  // else a child node, whose sector is visited here
    std::size_t index = 0;    // of the divider or of the child
    HiddenSide side = HiddenSide::none;
    double distance = 0;  // from the node
    double angle = 0;     // from the sector's right side
  };
  struct View;
  class NodeSearch;
  friend class BergSweep;
  friend class BergNodeSamples;

  /// Of tether at which the event happens, metres.
  double length_of(const Event& event) const {
    return event.is_divider ? dividers_[event.index].length : nodes_[event.index].before;
  }
  /// Of tether up to which the node sees something, metres.
  double reach_of(const BergNode& node) const { return node.before + node.reach + tolerance_; }
  bool in_sector(const BergNode& node, const Point& p) const;
  bool nearly_in_sector(const BergNode& node, const Point& p) const;
  void add_node(const BergSight::Corner& corner, HiddenSide side, std::size_t parent, double before);
  void find_reach(BergNode& node, const Ring& seen) const;
  void add_children_events();
  bool sees_corner(const Point& eye, const BergSight::Corner& corner, const View& view) const;
  void add_dividers(std::size_t node, const std::vector<std::uint32_t>& corners, const View& view, double longest);
  static bool earlier_in_line(const Event& a, const Event& b);
  void sort_events();
  void number_dividers();
  void drop_repeated_dividers();

  double tolerance_;
  BergSight sight_;
  std::vector<BergNode> nodes_;
  std::vector<BergDivider> dividers_;
  std::vector<std::vector<Event>> events_;  // by node
};

}  // namespace oxturn
