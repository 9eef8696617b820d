/// The medial axis as a tree over which a wave travels from its root to the boundary, and the spiral that it gives.
///
///   const MedialAxis axis = medial_axis(region, tool_width / 100);       // a region without holes
///   for (WaveTree& tree : wave_trees(axis)) {
///     tree.root_at_centre();
///     const WaveSpiral spiral = tree.spiral(std::ceil(tree.height() / tool_width), kRootAlone, start);
///     drive(spiral.spine), drive(spiral.laps);
///   }
///
/// The wave leaves the root (or the spine, a subtree about the root) at time 0, and on every branch travels at the
/// constant speed at which it reaches the end of the longest path beyond at time 1. So it arrives at all leaves, the
/// feet of spokes on the boundary, at time 1, and no branch is faster than the longest one. Lap i of n leaves has, for
/// each leaf j, the position of the wave on the path to it at time (i + j / n) / m: one continuous curve, which moves
/// outwards by at most a lap's distance, the height of the tree over m, in each turn. It ends at the leaf where time is
/// 1, and the last lap is the boundary from there. m need not be whole.
///
/// After Held and Spielberger 2009. O(l (d + m)) for l leaves at depth d and m laps.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "geometry/mesh/medial_axis.hpp"

namespace oxturn {

struct WaveSpiral {
  Polyline spine = {};     // a walk over the part where time is 0, to the spiral's beginning; one point: the root
  Polyline laps = {};      // from the end of the spine to the last lap, exclusive
  Polyline boundary = {};  // the last lap, closed
  double begin = 0;        // the time at which the laps begin: not 0 where there is no spine
};

struct WidePart;

constexpr double kRootAlone = std::numeric_limits<double>::infinity();  // a start height: no spine

class WaveTree {
 public:
  struct Node {
    Point at;
    double clearance;
  };

  /// Nodes and links form a tree; `leaves` are the nodes on the boundary, in its order.
  WaveTree(std::vector<Node> nodes, const std::vector<std::pair<std::size_t, std::size_t>>& links,
           std::vector<std::size_t> leaves);

  /// The middle of the longest path becomes the root (the default is node 0).
  void root_at_centre();
  /// The node nearest to a point becomes the root.
  void root_near(const Point& p);

  /// Laps end before narrow dead ends: where the clearance is at most `reach` (metres), the tool covers them from the
  /// last lap, the boundary. The wave waits where they begin for as long as it takes for `reach`; then it is on the
  /// boundary at once.
  void stop_before(double reach);

  /// Metres from the root to the farthest leaf.
  double height() const { return height_[root_]; }
  double greatest_clearance() const;
  /// When the wave reaches a leaf, if it leaves all that is higher above the boundary than `start_height` at time 0.
  std::vector<double> arrivals(double start_height);
  /// The greatest distance between laps over the least one, of the same wave. At least 1.
  double step_variation(double start_height);
  /// With so many laps (at least one) and the boundary. The spine is what is higher than `start_height`. Of the
  /// possible beginnings the one nearest to `near`.
  WaveSpiral spiral(double laps, double start_height, const Point& near);
  /// Closed laps in place of the spiral, each linked to the next: one fewer. The boundary is the last of
  /// `laps`, which need not be whole. No spine where it is within half a lap's distance of the first one.
  WaveSpiral closed_laps(double laps, double start_height, const Point& near);
  /// The wave leaves all that is higher than `start_height` at time 0, in what the functions up to leaf_nearest()
  /// return.
  void start_at(double start_height);
  /// By leaf: where the path to it leaves time 0. Joined in this order they are the wave's first lap: each connection
  /// lies in a face between two neighbouring branches.
  Polyline first_lap() const;
  /// Whole laps (one at least) from a leaf on, and back to it: a spiral or closed ones. The spine, if it is wanted, is
  /// walked from there and back, too.
  WaveSpiral laps_at(std::size_t leaf, double laps, bool closed, bool spine) const;
  /// The path from a leaf inwards, from `time` on, without the leaf.
  Polyline branch(std::size_t leaf, double time) const;
  /// The parts of the tree inside of the first lap, where the wave starts at `start_height`: wide parts, and points of
  /// narrow ones without spokes.
  std::vector<WidePart> wide_parts(double start_height) const;
  std::size_t leaf_nearest(const Point& p) const;

  /// Metres of the spiral's spine, of its laps and of the boundary, and the area within the boundary. Where there are
  /// thousands of leaves, those of the laps are estimated from an eighth of them.
  struct Measures {
    double spine, laps, boundary, area;
  };
  Measures spiral_measures(double laps, double start_height, const Point& near);
  /// The same of closed laps.
  Measures closed_measures(double laps, double start_height, const Point& near);
  /// The same of closed laps that begin with the wave's first lap, which counts as spine; and the area inside that.
  struct NestedMeasures {
    Measures of;
    double inside;
  };
  NestedMeasures nested_measures(std::size_t laps, double start_height) const;

 private:
  using Index = std::uint32_t;
  struct Crossing {
    double time;
    Point at;
  };
  std::size_t add(const Node& node, std::size_t a, std::size_t b);  // on the link ab
  void renumber();
  void orient();
  std::vector<double> distances(std::size_t from, double latest) const;
  void cut_at(double height);
  void split_dead_ends(double reach);
  void interpolate_clearances();
  void set_times(double start_height);
  std::size_t spine_end(std::size_t from) const;
  Polyline walk_spine(std::size_t from, std::size_t to) const;
  std::vector<Index> starts() const;
  template <class F>
  void walk_round_spine(const std::vector<Index>& start, F f) const;
  void path_to(std::size_t leaf, std::vector<Crossing>& path) const;
  /// The same if the wave starts at a height, which may be another one than that of start_at().
  void path_from(double start_height, std::size_t leaf, std::vector<Crossing>& path) const;
  static void add_dead_end(const std::vector<Crossing>& path, Polyline& line);
  void add_spiral(WaveSpiral& spiral, std::size_t first, double laps) const;
  void add_closed_laps(WaveSpiral& spiral, std::size_t first, double laps) const;
  /// At a time not before the last one, whose crossing is `passed` (0 at first).
  Point wave_at(const std::vector<Crossing>& path, double time, std::size_t& passed) const;
  /// Arrivals; the spine to the first leaf, whose index is returned.
  std::size_t begin_spiral(WaveSpiral& spiral, double start_height, const Point& near);
  Polyline boundary_from(std::size_t leaf) const;
  Measures begin_measures(const WaveSpiral& begun, std::size_t first) const;
  template <class PathTo, class Times, class Add>
  double sample_laps(std::size_t first, std::size_t laps, PathTo path_to, Times time, Add add) const;
  template <class Times>
  double sampled_length(std::size_t first, std::size_t laps, Times time) const;

  /// The nodes linked with a node.
  std::span<const Index> links(std::size_t node) const {
    return {links_.data() + first_link_[node], links_.data() + first_link_[node + 1]};
  }

  std::vector<Node> nodes_;
  std::vector<Index> links_, first_link_;  // by node, one after the other; where those of each begin, and the end
  std::vector<std::size_t> leaves_;
  std::size_t root_ = 0;
  std::vector<bool> dead_end_;  // by node: those in dead ends, with their leaves
  double reach_ = 0;            // from where dead ends begin to the boundary
  // Of the rooted tree: nodes, parents first; and by node.
  std::vector<Index> order_, parent_;
  std::vector<double> height_, time_;
};

/// A part of a tree inside of the wave's first lap, on which its leaves are. Clearances are those to the first lap.
struct WidePart {
  static constexpr std::size_t kGate = static_cast<std::size_t>(-1);
  WaveTree tree;
  /// By leaf of `tree`: the leaf of the whole tree whose branch begins there; kGate: none does, a narrow part does.
  std::vector<std::size_t> leaf;
};

/// One tree for each connected component of the axis. Links that would close a cycle are left out.
std::vector<WaveTree> wave_trees(const MedialAxis& axis);

}  // namespace oxturn
