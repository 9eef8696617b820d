/// A tree of pieces in configuration space and the path around it: closed rounds and chains of nodes, each attached by
/// a branch to the nearest visible vertex of those before it.
///
///   BranchTree tree(problem, side, lattice_paths);
///   tree.begin(round, BranchTree::Kind::round);
///   tree.attach(chain, BranchTree::Kind::chain);
///   path.drive(tree.path_around(), true);
///
/// Source      "Improving Spanning Tree Coverage" (lecture slides), "Merged Spanning Tree"
/// Guarantee   always a tree: a piece adds its vertices, the edges between them, and one branch
/// Complexity  attaching O(vertices within 24 spacings), usually O(1), and a path if none of them is visible: O(lattice
///             nodes nearer than the answer); the path around O(vertices)
/// Decisions   1. The closest vertex is the nearest one that can be reached straight. If there is none within 24
///                spacings, the piece is attached by a path to a vertex; the path's own vertices join the tree.
///             2. That path takes the fewest steps over the lattice, pulled straight, to a vertex that is a node of it.
///                Where the lattice leads to none, it is the shortest path among the walls to any vertex
///                (nearest_component.hpp).
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "algorithms/lattice/lattice_paths.hpp"
#include "algorithms/transit/nearest_component.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class BranchTree {
 public:
  /// `spacing`: approximate distance between neighbouring vertices. `problem` and `paths` must outlive the tree.
  BranchTree(const Problem& problem, double spacing, LatticePaths& paths);

  enum class Kind {
    chain,  // driven there and back
    round,  // driven once; its last point repeats its first and is the same vertex
    loop    // as in the source: the last point repeats the first but is a vertex of its own; driven there and back
  };
  /// The piece that the tree begins with.
  void begin(const Polyline& piece, Kind kind);
  enum class Attached { straight, by_path, not_at_all };
  /// Attaches the piece by its first point. Not at all: no vertex can be reached from there.
  Attached attach(const Polyline& piece, Kind kind);
  /// The same where a path from a vertex of the tree to the piece's first point is known, for want of a visible vertex.
  Attached attach(const Polyline& piece, Kind kind, const Polyline& path);

  const std::vector<Point>& vertices() const { return vertices_; }
  /// Pairs of vertices, without the closing edges of rounds.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges() const;
  /// Around the tree, from its first vertex and back to it. A branch is driven when the vertex that it is attached to
  /// is first reached. Vertices on straight runs are left out. Frees the lookup tables; do not call attach()
  /// afterwards.
  Polyline path_around();
  /// Calls f(a, b) for every straight run that path_around() will drive and that was attached since the last call.
  template <class F>
  void for_each_new_segment(F f) {
    for (; seen_ < pieces_.size(); ++seen_) {
      const Piece& piece = pieces_[seen_];
      if (piece.parent != kNone) f(vertices_[piece.parent], vertices_[piece.first]);
      std::uint32_t run = piece.first;
      for (std::uint32_t v = run + 1; v < piece.end; ++v) {
        if (v + 1 < piece.end && straight_on(vertices_[run], vertices_[v], vertices_[v + 1])) continue;
        f(vertices_[run], vertices_[v]);
        run = v;
      }
      if (piece.closed) f(vertices_[piece.end - 1], vertices_[piece.first]);
    }
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Piece {
    std::uint32_t first, end;  // its vertices
    std::uint32_t parent;      // the vertex that it is attached to
    bool closed;               // driven once, ends where it began; else back the same way
    std::uint32_t next;        // piece attached to the same vertex
  };
  struct Connection {
    std::uint32_t vertex;
    Polyline path;  // from the query point to the vertex
  };
  class Around;
  static bool straight_on(const Point& a, const Point& b, const Point& c);
  std::uint32_t add(const Polyline& piece, Kind kind, std::uint32_t parent);
  void attach_by(const Polyline& path, std::uint32_t vertex, const Polyline& piece, Kind kind);
  std::uint32_t nearest_visible(const Point& p) const;
  std::uint32_t vertex_at(const Point& p) const;
  std::optional<Connection> path_over_lattice(const Point& p);
  std::optional<Connection> path_among_walls(const Point& p);
  int bucket_column(const Point& p) const;
  int bucket_row(const Point& p) const;
  std::size_t bucket(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  std::size_t bucket(const Point& p) const { return bucket(bucket_column(p), bucket_row(p)); }

  const Problem& problem_;
  LatticePaths& paths_;
  std::vector<Point> vertices_;
  std::vector<std::uint32_t> first_attached_;  // to each vertex, newest first
  std::vector<Piece> pieces_;
  std::size_t seen_ = 0;
  // A grid of buckets, to which vertices are added one at a time; geometry/uniform_grid.hpp is filled once.
  Point low_;
  double side_;
  int columns_, rows_;
  std::vector<std::uint32_t> newest_, older_;  // the newest vertex in each bucket; for each vertex the next older one
  std::unique_ptr<NearestComponent> among_walls_;  // built at the first query; then it has the first `known_` vertices
  std::uint32_t known_ = 0;
};

}  // namespace oxturn
