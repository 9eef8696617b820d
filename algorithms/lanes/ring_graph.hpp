/// Which laps lie beside each other, and a tree of them.
///
///   const RingGraph graph(laps, spacing);
///   const LapTree tree = graph.tree(0, LinkLaps::shortest_shared);
///   for (const std::size_t lap : tree.children[0]) ...
///
/// The shared part of two laps are the points of the inner one that are nearer to the other than to any lap of its
/// level, about a spacing away. Two laps whose shared part is longer than 1.1 spacings are neighbours; so are laps of
/// one level with no lap between them (across a ridge). After Zhao et al. 2016. O(m) for laps with m vertices and
/// metres in all, as long as few laps are near each other.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/lanes/laps.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

/// A ring with lengths: positions along it are metres from its first vertex, of any sign and size.
class MeasuredRing {
 public:
  explicit MeasuredRing(const Ring& ring);
  double length() const { return begin_.back(); }
  /// Metres from the first vertex to vertex `k`.
  double to_vertex(std::size_t k) const { return begin_[k]; }
  Point at(double along) const;
  /// From one position onwards to another, ends included; once around and more is possible.
  Polyline piece(double from, double to) const;

 private:
  std::size_t edge_at(double along) const;  // of a position in [0, length)
  double wrapped(double along) const;

  Ring ring_;
  std::vector<double> begin_;  // of each edge; a last entry: the length
};

/// A position on a lap, and how far it is from what was asked for.
struct RingPosition {
  double along = 0;  // metres from the lap's first vertex
  Point at{0, 0};
  double distance = 0;
};

struct LapTree {
  std::vector<std::optional<std::size_t>> parent;  // none: the root, and laps not connected with it
  std::vector<std::vector<std::size_t>> children;
  std::vector<std::size_t> order;  // of all connected laps, parents first
};

/// By which edges the tree connects laps: those with short shared parts first, or those with long ones.
enum class LinkLaps { shortest_shared, longest_shared };

class RingGraph {
 public:
  /// `spacing`: metres between laps.
  RingGraph(const Laps& laps, double spacing);

  std::size_t size() const { return rings_.size(); }
  const MeasuredRing& ring(std::size_t lap) const { return rings_[lap]; }
  /// The position on a lap nearest to p, if it is nearer than `within`.
  std::optional<RingPosition> nearest(std::size_t lap, const Point& p, double within) const;
  /// Does the segment ab cross the lap more than `gap` metres (along the lap) from the position `around`?
  bool crosses(std::size_t lap, const Point& a, const Point& b, double around, double gap) const;
  /// The positions on a lap, about `step` metres apart, that lie within `reach` of another lap.
  std::vector<double> beside(std::size_t lap, std::size_t other, double reach, double step) const;
  /// The laps that a lap shares a part with, ascending.
  const std::vector<std::size_t>& neighbours(std::size_t lap) const { return neighbours_[lap]; }
  /// A spanning tree of the laps connected with `root`.
  LapTree tree(std::size_t root, LinkLaps by) const;
  /// Neighbours are at most so many metres from each other.
  double reach(std::size_t lap, std::size_t other) const;

 private:
  struct Link {
    std::size_t outer, inner;
    double shared;  // metres
    bool ridge;     // both of one level
  };
  struct Edge {
    std::size_t lap, vertex;
    Point a, b;
  };
  void find_links();
  void add_samples(std::size_t lap);
  template <class F>
  void for_each_near(const Point& a, const Point& b, double within, F f) const;

  double spacing_;
  std::vector<int> level_;
  std::vector<MeasuredRing> rings_;
  std::vector<Edge> edges_;
  UniformGrid grid_;
  std::vector<Link> links_;
  std::vector<std::vector<std::size_t>> neighbours_;
};

}  // namespace oxturn
