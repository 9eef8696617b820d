/// The cones of sight of a geodesic field, triangle by triangle. Private to geometry, not installed.
///
/// Source      Mitchell 1996 (continuous Dijkstra); windows are pruned as by Xin and Wang 2009
/// Method      A cone leaves its root (the anchor, or a corner about which shortest paths bend) through edges of the
///             mesh, nearest first. Its sides are rays through given points, so all topological decisions are exact. A
///             corner in sight gets a label, the length of a path to it. When no nearer cone is left, the label is
///             final: the corner is settled, becomes a root, and opens the part of its surroundings that its
///             predecessor does not see. Cones that are shortest nowhere are pruned.
/// Corners     are counted by fans: where rings touch or barriers end, each fan of triangles about the point is one
///             corner.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <vector>

#include "geometry/tether/geodesic_clip.hpp"
#include "geometry/tether/geodesic_field.hpp"

namespace oxturn {

/// What one root sees of one triangle: the part between two rays, `right` to `left` counter-clockwise, or all of it.
struct Cone {
  std::int32_t root;
  bool whole;
  Point left, right;  // unit directions of the rays
};

/// A piece of the cut locus: where the paths by two roots are equally long.
struct CutPiece {
  std::int32_t root, other;  // the root with the greater distance from the anchor first
  bool straight;             // along the ray from `root` away from `other`; else a hyperbola
  double begin, end;         // straight: distances from `root`; else parameters (geodesic_cut_locus.cpp)
};

class GeodesicCones {
 public:
  /// All paths begin with `stem`, one or more points of the mesh from the anchor on, and leave its last point into the
  /// triangles `home` (ascending), which contain that. Points of queries may be outside the mesh by at most
  /// `tolerance`.
  GeodesicCones(Mesh mesh, const Polyline& stem, const std::vector<std::int32_t>& home, double tolerance);

  static constexpr std::int32_t kNone = -1;
  struct Root {
    Point at;
    double before;         // length of the shortest path from the anchor
    std::int32_t parent;   // the previous root on that path; kNone for the anchor
    std::int32_t corners;  // on that path, itself included
  };
  const Mesh& mesh() const { return mesh_; }
  /// The anchor first (moved into the mesh), parents before children.
  const std::vector<Root>& roots() const { return roots_; }
  const Root& root(std::int32_t i) const { return roots_[static_cast<std::size_t>(i)]; }
  std::span<const Cone> cones(std::int32_t triangle) const {
    const auto t = static_cast<std::size_t>(triangle);
    return {cones_.data() + first_[t], cones_.data() + first_[t + 1]};
  }
  /// Length of the shortest path to vertex k of a triangle; infinity if there is none.
  double to_vertex(std::int32_t triangle, std::size_t k) const;
  Facet facet(std::int32_t t) const { return {mesh_.vertex(t, 0), mesh_.vertex(t, 1), mesh_.vertex(t, 2)}; }

  /// Does the cone contain p, a point of its triangle? Points outside by rounding count as inside.
  bool contains(const Cone& cone, const Point& p) const {
    if (cone.whole) return true;
    const Point d = p - root(cone.root).at;
    return cross(cone.left, d) <= rounding_ && cross(cone.right, d) >= -rounding_;
  }
  /// Removes from the facet what is outside the cone.
  void clip(Facet& facet, const Cone& cone) const {
    if (cone.whole) return;
    facet.clip(root(cone.root).at, cone.left, KeptSide::right, rounding_);
    if (!facet.empty()) facet.clip(root(cone.root).at, cone.right, KeptSide::left, rounding_);
  }
  /// Divides the triangle into parts so small that only a few of its cones can be shortest in each, and calls
  /// f(facet, cones) for them. Parts for which wanted(facet, cones) is false are left out.
  template <class Wanted, class F>
  void for_each_part(std::int32_t triangle, Wanted wanted, F f) const {
    divide(facet(triangle), cones(triangle), 0, wanted, f);
  }
  /// Length of the path to p by the cone's root.
  double distance_by(const Cone& cone, const Point& p) const {
    const Root& r = root(cone.root);
    return r.before + (p - r.at).norm();
  }
  /// Length of the shortest path to p; infinity if there is none.
  double distance(Point p) const;
  /// The root of the shortest path to p, which is moved into the mesh; of equal paths the one with fewest corners.
  /// kNone if there is none.
  std::int32_t last_root(Point& p) const;
  /// Are the shortest paths to p by roots a and b the same curve? They are if one of them only has additional corners
  /// that it passes without a bend.
  bool same_path(std::int32_t a, std::int32_t b, const Point& p) const;

  /// By triangle. Found at the first call (thread-safe).
  const std::vector<CutPiece>& cut_pieces() const;

  /// Metres by which computed points may be off.
  double rounding() const { return rounding_; }
  /// Metres by which equal lengths of paths may differ by rounding.
  double tie() const { return tie_; }

 private:
  friend class ContinuousDijkstra;
  static constexpr std::size_t kFew = 14;  // cones of a part
  static constexpr int kDeepestDivision = 24;

  void search(const std::vector<std::int32_t>& home);
  void prune();
  /// Those cones of `from` that may be shortest somewhere in the part of the triangle.
  std::vector<Cone> needed(const Facet& part, std::span<const Cone> from) const;
  /// May the cone contain a point of the facet?
  bool meets(const Cone& cone, const Facet& facet) const;
  bool beaten(const Cone& cone, const Facet& part, std::span<const Cone> others) const;
  template <class Wanted, class F>
  void divide(const Facet& part, std::span<const Cone> here, int depth, Wanted& wanted, F& f) const {
    if (here.empty() || !wanted(part, here)) return;
    if (here.size() <= kFew || depth == kDeepestDivision) return f(part, here);
    const auto [a, b] = part.halves();
    divide(a, needed(a, here), depth + 1, wanted, f);
    divide(b, needed(b, here), depth + 1, wanted, f);
  }

  Mesh mesh_;
  double tolerance_, rounding_ = 0, tie_ = 0;
  std::vector<std::int32_t> fan_;  // of vertex k of triangle t, at 3 t + k
  std::vector<double> label_;      // by fan: length of the shortest path
  std::vector<Root> roots_;
  std::vector<Cone> cones_;         // triangle by triangle
  std::vector<std::size_t> first_;  // cones of triangle t: cones_[first_[t] .. first_[t + 1])
  mutable std::once_flag cut_once_;
  mutable std::vector<CutPiece> cut_;
};

/// See GeodesicField::level_sets, cut_locus and farthest. From the cones, triangle by triangle.
std::vector<std::vector<std::vector<GeodesicField::Arc>>> level_sets_of(const GeodesicCones& cones,
                                                                        const std::vector<double>& lengths);
std::vector<Polyline> cut_locus_of(const GeodesicCones& cones, double chord_error, double beyond);
double farthest_of(const GeodesicCones& cones);

}  // namespace oxturn
