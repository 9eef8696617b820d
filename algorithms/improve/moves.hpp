/// Small random changes of a path, for annealing.
///
///   Moves moves({.width = tool_width}, problem.walls());
///   moves.focus(centres_of_uncovered_pieces);
///   if (const auto change = moves.propose(path, rng)) { ... change->apply(path); }
///
/// Shifts of a vertex or an edge, also to the wall beside it; vertices deleted, alone or several in a row, added and
/// merged; 2-opt and Or-opt with a vertex near by; vertices shifted or added, and spikes, that cover a point which
/// nothing covers. Fixed vertices and edges stay (vertex_path.hpp). Each O(1), but for what apply() costs.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "algorithms/improve/part.hpp"
#include "algorithms/improve/vertex_path.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {

struct Edge {
  Point a, b;
};

/// Up to kMost edges.
class Edges {
 public:
  static constexpr std::size_t kMost = 16;
  void add(const Point& a, const Point& b) { edges_[size_++] = {a, b}; }
  std::size_t size() const { return size_; }
  const Edge* begin() const { return edges_.data(); }
  const Edge* end() const { return edges_.data() + size_; }
  const Edge& operator[](std::size_t i) const { return edges_[i]; }
  double length() const;

 private:
  std::array<Edge, kMost> edges_;
  std::size_t size_ = 0;
};

/// What a move does: edges that leave the path and edges that come, and how to carry it out.
struct Change {
  enum class Kind { replace, reverse, relocate } kind = Kind::replace;
  std::size_t first = 0, last = 0;  // positions; last = first + count of replaced ones
  std::size_t after = 0;            // of relocate
  bool turned = false;              // of relocate
  std::array<Point, 3> points{};    // of replace
  std::size_t point_count = 0;
  Edges removed, added;

  void apply(VertexPath& path) const;
  /// By how much the sum of the path's changes of direction grows, radians.
  double turning(const VertexPath& path) const;

 private:
  double turning_of_replaced(const VertexPath& path) const;
};

/// Change of direction at b, driving from a to c, radians; 0 if it has no direction there.
double turn_at(const Point& a, const Point& b, const Point& c);
/// Their sum.
double turning(const Polyline& path);

/// The point of the wall beside p, or with `vertex` the nearer end of its edge, if it is within a tenth of the tool's
/// width; nullopt if p is there already. Inside by more than rounding, so that edges along the wall are inside, too.
std::optional<Point> on_wall(const Point& p, const EdgeIndex& walls, double width, bool vertex);

class Moves {
 public:
  struct Sizes {
    double width = 0;                 // of the tool, metres
    double least = 0.01, most = 0.3;  // standard deviations of shifts, in tool widths; log-uniform in between
    bool cut_short = false;           // are several vertices in a row deleted, too
    AnnealingPart without = AnnealingPart::none;  // moves of this part are shifts of vertices instead
  };
  /// `walls`: the edges of configuration space, to which vertices may snap; must outlive it.
  Moves(const Sizes& sizes, const EdgeIndex& walls) : sizes_(sizes), width_(sizes.width), walls_(walls) {}
  /// Four moves of five are made within a tool's width of one of these points.
  void focus(std::vector<Point> points) { focus_ = std::move(points); }
  /// One move of ten covers one of these points.
  void uncovered(std::vector<Point> points) { uncovered_ = std::move(points); }
  /// nullopt: none of the few moves drawn exists where it was drawn.
  std::optional<Change> propose(const VertexPath& path, Rng& rng) const;

 private:
  std::optional<Change> drawn(const VertexPath& path, Rng& rng) const;
  static bool movable(const VertexPath& path, std::size_t i) { return i < path.size() && !path.fixed(i); }
  double spread(Rng& rng) const;
  Point cloud(Rng& rng) const;
  Change replaced(const VertexPath& path, std::size_t first, std::size_t count, std::span<const Point> points) const;
  std::optional<Change> shift_vertex(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<Change> shift_edge(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<Change> snap(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<Change> remove(const VertexPath& path, std::size_t i) const;
  std::optional<Change> cut_short(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<Change> split(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<Change> merge(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<Change> two_opt(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<Change> cover(const VertexPath& path, Rng& rng) const;
  std::optional<Change> spike(const VertexPath& path, const Point& at, Rng& rng) const;
  std::optional<Point> covering(const Point& at, const Point& from, Rng& rng) const;
  std::optional<std::size_t> nearest_edge(const VertexPath& path, const Point& p, Rng& rng) const;
  Point free(const Point& p) const;
  std::optional<Change> or_opt(const VertexPath& path, std::size_t i, Rng& rng) const;
  std::optional<std::size_t> partner(const VertexPath& path, std::size_t i, Rng& rng) const;

  std::size_t vertex(const VertexPath& path, Rng& rng) const;

  Sizes sizes_;
  double width_;
  const EdgeIndex& walls_;
  std::vector<Point> focus_, uncovered_;
};

}  // namespace oxturn
