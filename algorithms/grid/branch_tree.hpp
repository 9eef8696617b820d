// A tree of pieces in configuration space and the way round it: closed rounds and chains of nodes, each hung by a
// branch on the nearest visible vertex of those before it.
//
// Source      slides "Improving Coverage" (seed improving-spanning-tree-coverage), "Merged Spanning Tree"
// Guarantee   always a tree: a piece adds its vertices, the edges between them, and one branch
// Complexity  hanging O(vertices within 24 spacings), usually O(1), and a way if none of these is visible: O(lattice nodes
//             nearer than the answer); the way round O(vertices)
// Decisions   1. "Closest" is the nearest vertex from which the straight way is free. If none within 24 spacings is, the
//                piece hangs by a way to a vertex; the corners on it become vertices.
//             2. That way is the one of fewest steps over the lattice, pulled straight, to a vertex that is a node of it;
//                where the lattice leads to none, the shortest among the walls to any vertex (nearest_part.hpp).
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
  /// `spacing`: about how far neighbouring vertices are from one another. `problem` and `ways` must outlive it.
  BranchTree(const Problem& problem, double spacing, LatticePaths& ways);

  enum class Kind {
    chain,  // driven there and back
    round,  // driven once; its last point repeats its first and is the same vertex
    loop    // the slides' loop: the same, but the last point is a vertex of its own, and it is driven there and back
  };
  /// The piece that the tree begins with.
  void begin(const Polyline& piece, Kind kind);
  enum class Hung { straight, by_path, not_at_all };
  /// Hangs the piece by its first point. Not at all: no vertex can be reached from there.
  Hung hang(const Polyline& piece, Kind kind);

  const std::vector<Point>& vertices() const { return vertices_; }
  /// Pairs of vertices. The closing edges of rounds are left out.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges() const;
  /// Round the tree from its first vertex and back to it. Every branch is left for where the vertex it hangs on is
  /// first come to. Straight-on points are left out. Nothing can be hung afterwards: what that takes is given back first.
  Polyline way_round();
  /// Calls f(a, b) for every straight run that way_round() drives and that was hung since the last call.
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
      if (piece.once) f(vertices_[piece.end - 1], vertices_[piece.first]);
    }
  }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  struct Piece {
    std::uint32_t first, end;  // its vertices
    std::uint32_t parent;      // the vertex it hangs on
    bool once;                 // ends where it began; else back the same way
    std::uint32_t next;        // piece on the same vertex
  };
  static bool straight_on(const Point& a, const Point& b, const Point& c);
  std::uint32_t add(const Polyline& piece, Kind kind, std::uint32_t parent);
  std::uint32_t nearest_visible(const Point& p) const;
  std::uint32_t vertex_at(const Point& p) const;
  struct Way {
    std::uint32_t vertex;
    Polyline from;  // from the asking point to the vertex
  };
  std::optional<Way> path_over_lattice(const Point& p);
  std::optional<Way> path_among_walls(const Point& p);
  std::size_t bucket(const Point& p) const;
  std::size_t bucket(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }

  const Problem& problem_;
  LatticePaths& ways_;
  std::vector<Point> vertices_;
  std::vector<std::uint32_t> first_attached_;  // on each vertex, newest first
  std::vector<Piece> pieces_;
  std::size_t seen_ = 0;
  Point low_;
  double side_;
  int columns_, rows_;
  std::vector<std::uint32_t> newest_, older_;  // vertex in each bucket, and the one before each vertex in its bucket
  std::unique_ptr<NearestComponent> by_path_;        // made at the first question; then it knows the first `known_` vertices
  std::uint32_t known_ = 0;
};

}  // namespace oxturn
