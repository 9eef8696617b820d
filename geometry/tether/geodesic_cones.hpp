// The cones of sight of a geodesic field, triangle by triangle. Private to geometry: not installed.
//
// Source      Mitchell 1996 (continuous Dijkstra); windows filtered as by Xin & Wang 2009
// Method      A cone leaves its root (the anchor, or a corner that a shortest way bends about) through edges of the
//             mesh, nearest first, bounded by rays through given points only, so all questions of topology are exact.
//             A corner in sight gets a label, and when no nearer cone is left, the corner is settled and opens the
//             part of its surroundings that its predecessor does not see. A cone that is nowhere shortest is dropped.
// Corners     are counted by fans: where rings touch or barriers end, each fan of triangles about the point is one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/tether/geodesic_clip.hpp"
#include "geometry/mesh/mesh.hpp"

namespace oxturn {

/// What one root sees of one triangle: the part between two rays (or all), `right` to `left` counter-clockwise.
struct Cone {
  std::int32_t root;
  bool whole;
  Point left, right;  // unit directions of the rays
};

class GeodesicCones {
 public:
  /// Throws std::invalid_argument if the anchor is outside.
  GeodesicCones(const Region& free, const Point& anchor, const std::vector<Polyline>& barriers, double tolerance);

  struct Root {
    Point at;
    double before;         // length of the shortest way from the anchor
    std::int32_t parent;   // root that it comes from; -1 for the anchor
    std::int32_t corners;  // on the way, itself included
  };
  const Mesh& mesh() const { return mesh_; }
  /// The anchor first (moved into the mesh), parents before children.
  const std::vector<Root>& roots() const { return roots_; }
  const Root& root(std::int32_t i) const { return roots_[static_cast<std::size_t>(i)]; }
  std::span<const Cone> cones(std::int32_t triangle) const {
    const auto t = static_cast<std::size_t>(triangle);
    return {cones_.data() + first_[t], cones_.data() + first_[t + 1]};
  }
  /// Length of the shortest way to a triangle's corner, infinity if there is none.
  double to_corner(std::int32_t triangle, std::size_t k) const;
  Point corner(std::int32_t triangle, std::size_t k) const;
  Facet facet(std::int32_t triangle) const { return {corner(triangle, 0), corner(triangle, 1), corner(triangle, 2)}; }

  /// Does the cone hold p, a point of its triangle? What lies outside by rounding counts as inside.
  bool holds(const Cone& cone, const Point& p) const {
    if (cone.whole) return true;
    const Point d = p - root(cone.root).at;
    return cross(cone.left, d) <= rounding_ && cross(cone.right, d) >= -rounding_;
  }
  /// The facet less what is outside of the cone.
  void clip(Facet& facet, const Cone& cone) const {
    if (cone.whole) return;
    facet.keep(root(cone.root).at, cone.left, -1, rounding_);
    if (!facet.empty()) facet.keep(root(cone.root).at, cone.right, 1, rounding_);
  }
  /// Calls f(facet, cones) for parts of the triangle, so small that only a few of its cones can be shortest in each.
  /// Parts for which wanted(facet, cones) is false are left out.
  template <class Wanted, class F>
  void for_each_part(std::int32_t triangle, Wanted wanted, F f) const {
    split(facet(triangle), cones(triangle), 0, wanted, f);
  }
  double distance_by(const Cone& cone, const Point& p) const {
    const Root& r = root(cone.root);
    return r.before + (p - r.at).norm();
  }
  /// Are the shortest ways to p by roots a and b one curve: a straight stretch that one of them breaks off by corners
  /// that it passes without a bend?
  bool same_way(std::int32_t a, std::int32_t b, const Point& p) const;

  /// Moves p into the mesh (by no more than the tolerance) and lists the triangles that hold it, those included that
  /// hold it but for rounding. False if it is outside.
  bool place(Point& p, std::vector<std::int32_t>& found) const;
  /// Metres by which computed points may be off.
  double rounding() const { return rounding_; }
  /// Metres by which equal lengths of ways may differ by rounding.
  double tie() const { return tie_; }

 private:
  friend class ConeSearch;
  static constexpr std::size_t kFew = 14;
  static constexpr int kDeep = 24;
  /// The cones that may be shortest somewhere in the triangle `part`, of `from`.
  std::vector<Cone> needed(const Facet& part, std::span<const Cone> from) const;
  /// Does the cone hold any of the facet? (May say yes in vain.)
  bool meets(const Cone& cone, const Facet& facet) const;
  bool beaten(const Cone& cone, const Facet& part, std::span<const Cone> others) const;
  template <class Wanted, class F>
  void split(const Facet& part, std::span<const Cone> here, int depth, Wanted& wanted, F& f) const {
    if (here.empty() || !wanted(part, here)) return;
    if (here.size() <= kFew || depth == kDeep) return f(part, here);
    const auto [a, b] = part.halves();
    split(a, needed(a, here), depth + 1, wanted, f);
    split(b, needed(b, here), depth + 1, wanted, f);
  }

  Mesh mesh_;
  double tolerance_, rounding_ = 0, tie_ = 0;
  std::vector<std::int32_t> fan_;  // of corner k of triangle t at 3 t + k
  std::vector<double> label_;      // by fan
  std::vector<Root> roots_;
  std::vector<Cone> cones_;  // by triangles
  std::vector<std::size_t> first_;
};

}  // namespace oxturn
