// Method      In each triangle, for every two roots u and v: the curve on which their paths are equally long, a branch
//             of a hyperbola. Let w = v - u and c = before(u) - before(v). Seen from u in direction e, a unit vector,
//             the curve is at distance (|w|^2 - c^2) / (2 (e . w + c)). With p the cotangent of half the angle from -w
//             to e, changed in sign, its points are rational functions of p, and p where it meets a line, or another
//             such curve about u, is the root of a quadratic: all ends of pieces are known in closed form. No number
//             loses digits where the curve is nearly a ray from u away from v, as it is where u lies but little beside
//             the path by v. The later root, with the greater `before`, takes the part of u: its side of the curve is
//             convex and star-shaped about it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/throw_invalid.hpp"
#include "geometry/tether/geodesic_cones.hpp"

namespace oxturn {
namespace {

/// Calls f(x) for the solutions of a x^2 - 2 b x + c = 0; rounding does not lose a double one.
template <class F>
void for_each_root(double a, double b, double c, F f) {
  const double d = b * b - a * c;
  if (!(d >= -1e-13 * b * b)) return;
  const double q = b + std::copysign(std::sqrt(std::max(d, 0.0)), b);
  if (a != 0) f(q / a);
  if (q != 0) f(c / q);
}

/// Where the paths by roots u and v are equally long. Parameters: see Method; from -sqrt(sum / slack) to +sqrt(..).
struct Bisector {
  Point u, w;
  double before;  // of u
  double c;
  double slack, sum;  // |w| - c, |w| + c
  Point away, aside;  // unit vectors: -w, and to the left of it
  Bisector(const GeodesicCones::Root& of, const GeodesicCones::Root& other)
      : u(of.at),
        w(other.at - of.at),
        before(of.before),
        c(of.before - other.before),
        slack(w.norm() - c),
        sum(w.norm() + c),
        away(-w / w.norm()),
        aside(perpendicular(away)) {}
  double k() const { return slack * sum / 2; }
  /// Distance from u in direction e; infinite or negative if the curve is not met.
  double reach(const Point& e) const { return k() / (e.dot(w) + c); }
  bool has(double p) const { return sum > slack * p * p; }
  Point at(double p) const { return u + k() / (sum - slack * p * p) * ((p * p - 1) * away - 2 * p * aside); }
  /// Calls f(p) where it meets the line through a point along d.
  template <class F>
  void meet_line(const Point& on, const Point& d, F f) const {
    const Point n = perpendicular(d);
    const double h = n.dot(on - u), n0 = n.dot(away), n1 = n.dot(aside);
    for_each_root(slack * (sum * n0 + 2 * h), slack * sum * n1, -sum * (slack * n0 + 2 * h), f);
  }
  /// The same for another bisector about the same u.
  template <class F>
  void meet(const Bisector& o, F f) const {
    const double w0 = o.w.dot(away), w1 = o.w.dot(aside);
    for_each_root(slack * (sum * (w0 + o.c) + 2 * o.k()), slack * sum * w1, sum * (slack * (o.c - w0) - 2 * o.k()), f);
  }
};

/// The unit vector from v to u.
Point direction_away(const GeodesicCones::Root& u, const GeodesicCones::Root& v) { return (u.at - v.at).normalized(); }

/// Finds the pieces of the cut locus.
class CutLocus {
 public:
  explicit CutLocus(const GeodesicCones& cones) : cones_(cones) {}

  /// In the triangles that have points farther from the anchor than `beyond`, and possibly in others.
  std::vector<CutPiece> run(double beyond) {
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(cones_.mesh().triangles().size()); ++t)
      if (most_in(t) > beyond) find_pieces(t);
    pieces_.shrink_to_fit();
    return std::move(pieces_);
  }

 private:
  /// No point of the triangle is farther from the anchor: distances grow by no more than points move.
  double most_in(std::int32_t t) const {
    constexpr double kRounding = 1e-9;  // relative
    const Facet facet = cones_.facet(t);
    double most = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = facet.vertices()[k];
      double longest = 0;
      for (const Point& q : facet.vertices()) longest = std::max(longest, distance(p, q));
      most = std::min(most, cones_.to_vertex(t, k) + longest);
    }
    return most * (1 + kRounding);
  }

  void find_pieces(std::int32_t t) {
    const auto several = [](const Facet&, std::span<const Cone> here) { return here.size() > 1; };
    cones_.for_each_part(t, several, [&](const Facet& part, std::span<const Cone> here) {
      here_ = here;
      for (const Cone& a : here) {
        Facet seen = part;
        cones_.clip(seen, a);
        if (seen.empty()) continue;
        for (const Cone& b : here)
          if (a.root != b.root && is_later(a, b)) find_pieces(a, b, part, seen);
      }
    });
  }
  bool is_later(const Cone& a, const Cone& b) const {
    const double u = cones_.root(a.root).before, v = cones_.root(b.root).before;
    return u > v || (u == v && a.root > b.root);
  }

  /// `seen`: what of the part is in cone a.
  void find_pieces(const Cone& a, const Cone& b, const Facet& part, const Facet& seen) {
    const GeodesicCones::Root &u = cones_.root(a.root), &v = cones_.root(b.root);
    const double slack = distance(u.at, v.at) - (u.before - v.before);
    if (slack < -cones_.tie()) return;  // the path by v is shorter everywhere
    if (slack <= cones_.tie()) return find_straight_pieces(a, b, part);
    Facet both = seen;
    cones_.clip(both, b);
    if (!both.empty() && !is_one_sided(a, b, both)) find_curved_pieces(a, b, both);
  }

  /// Is the path by one of the two clearly shorter to every point of the facet? A quick test that notices most such
  /// facets. The points to which the path by a is shorter are a convex set: if it has all vertices, it has the facet.
  /// Nor does the curve, which is endless, meet a facet none of whose edges it crosses.
  bool is_one_sided(const Cone& a, const Cone& b, const Facet& facet) {
    ends_.clear();
    for (const Point& p : facet.vertices()) {
      const Point from_root = p - cones_.root(a.root).at;
      const double away = from_root.norm(), by_b = cones_.distance_by(b, p);
      const Point direction =
          away > 0 ? Point(from_root / away) : Point(0, 0);  // at the root itself the length is least
      ends_.push_back({direction, cones_.root(a.root).before + away - by_b, by_b});
    }
    if (std::ranges::all_of(ends_, [&](const End& e) { return e.longer < -cones_.tie(); })) return true;
    if (!std::ranges::all_of(ends_, [&](const End& e) { return e.longer > cones_.tie(); })) return false;
    for (std::size_t i = 0; i < ends_.size(); ++i)
      if (least_between(ends_[i], ends_[(i + 1) % ends_.size()], facet.next(i) - facet.vertices()[i]) <= cones_.tie())
        return false;
    return true;
  }
  /// At a vertex of a facet: the direction from the root of a, and how much longer the path by a is than that by b.
  struct End {
    Point direction;
    double longer, by_b;
  };
  /// The path by a is at least so much longer on the edge between two vertices: its length is convex along the edge,
  /// and so above its tangents at both; that of the path by b is below its chord.
  static double least_between(const End& from, const End& to, const Point& edge) {
    const double chord = to.by_b - from.by_b;
    const double fall = chord - from.direction.dot(edge), rise = to.direction.dot(edge) - chord;
    if (fall <= 0) return from.longer;
    if (rise <= 0) return to.longer;
    return from.longer - fall * std::clamp((from.longer - to.longer + rise) / (fall + rise), 0.0, 1.0);
  }

  /// Is no other path clearly shorter than those by a and b?
  bool is_shortest(const Cone& a, const Cone& b, const Point& x) const {
    const double best = std::min(cones_.distance_by(a, x), cones_.distance_by(b, x)) - cones_.tie();
    return std::none_of(here_.begin(), here_.end(),
                        [&](const Cone& o) { return cones_.distance_by(o, x) < best && cones_.contains(o, x); });
  }

  /// breaks_ are parameters of the curve.
  void find_curved_pieces(const Cone& a, const Cone& b, const Facet& facet) {
    const Bisector line(cones_.root(a.root), cones_.root(b.root));
    breaks_.clear();
    const auto add = [&](double p) {
      if (line.has(p)) breaks_.push_back(p);
    };
    for (std::size_t i = 0; i < facet.vertices().size(); ++i)
      line.meet_line(facet.vertices()[i], facet.next(i) - facet.vertices()[i], add);
    if (breaks_.size() < 2) return;
    const auto is_in_facet = [&](double p) { return facet.contains(line.at(p), cones_.rounding()); };
    // The part of the curve in the facet.
    double inside_from = std::numeric_limits<double>::infinity(), inside_to = -inside_from;
    for_each_run(breaks_, is_in_facet, [&](double begin, double end) {
      inside_from = std::min(inside_from, begin);
      inside_to = end;
    });
    if (inside_from >= inside_to) return;
    for (const Cone& o : here_)
      if (o.root != a.root && o.root != b.root) add_breaks(line, a, o, add);
    const auto is_piece = [&](double p) {
      return p >= inside_from && p <= inside_to && is_in_facet(p) && is_shortest(a, b, line.at(p));
    };
    for_each_run(breaks_, is_piece, [&](double begin, double end) {
      pieces_.push_back({a.root, b.root, false, begin, end});
    });
  }
  /// Where a third cone may become shorter, or may begin or end.
  template <class Add>
  void add_breaks(const Bisector& line, const Cone& a, const Cone& o, Add add) const {
    const GeodesicCones::Root& third = cones_.root(o.root);
    line.meet(Bisector(cones_.root(a.root), third), add);
    if (o.whole) return;
    line.meet_line(third.at, o.left, add);
    line.meet_line(third.at, o.right, add);
  }

  /// The curve has degenerated to a ray: the path by v passes through u. It belongs to the cut locus only if u has its
  /// length from another path. breaks_ are distances from u along the ray.
  void find_straight_pieces(const Cone& a, const Cone& b, const Facet& part) {
    const GeodesicCones::Root &u = cones_.root(a.root), &v = cones_.root(b.root);
    if (u.parent == b.root || u.at == v.at) return;
    const Point e = direction_away(u, v);
    breaks_.assign(1, 0);
    const auto add_line = [&](const Point& p, const Point& d) {
      const double across = cross(e, d);
      if (across != 0) breaks_.push_back(cross(p - u.at, d) / across);
    };
    for (std::size_t i = 0; i < 3; ++i) add_line(part.vertices()[i], part.next(i) - part.vertices()[i]);
    for (const Cone& o : here_) {
      const GeodesicCones::Root& third = cones_.root(o.root);
      if (!o.whole) {
        add_line(third.at, o.left);
        add_line(third.at, o.right);
      }
      if (o.root != a.root && o.root != b.root) breaks_.push_back(Bisector(u, third).reach(e));
    }
    std::erase_if(breaks_, [](double s) { return !(s >= 0 && s < 1e300); });
    std::sort(breaks_.begin(), breaks_.end());
    for (std::size_t i = 1; i < breaks_.size(); ++i) {
      if (breaks_[i] - breaks_[i - 1] <= cones_.rounding()) continue;
      const Point x = u.at + (breaks_[i - 1] + breaks_[i]) / 2 * e;
      if (!part.contains(x, cones_.rounding()) || !cones_.contains(a, x) || !cones_.contains(b, x) ||
          !is_shortest(a, b, x) || cones_.same_path(a.root, b.root, x))
        continue;
      pieces_.push_back({a.root, b.root, true, breaks_[i - 1], breaks_[i]});
    }
  }

  const GeodesicCones& cones_;
  std::span<const Cone> here_;
  std::vector<double> breaks_;
  std::vector<End> ends_;  // of the facet looked at
  std::vector<CutPiece> pieces_;
};

/// Appends points of the curve after `begin` up to `end`, at most `depth` halvings deep, so that chords stay within the
/// error.
void append_points(const Bisector& curve, double begin, double end, double chord_error, int depth, Polyline& out) {
  const Point a = out.back(), b = curve.at(end);
  const auto off = [&](double part) { return distance_to_segment(curve.at(begin + part * (end - begin)), a, b); };
  // Half of what is allowed: the largest error may be between the points tried.
  if (depth > 0 && std::max({off(0.25), off(0.5), off(0.75)}) > chord_error / 2) {
    const double middle = (begin + end) / 2;
    append_points(curve, begin, middle, chord_error, depth - 1, out);
    append_points(curve, middle, end, chord_error, depth - 1, out);
  } else {
    out.push_back(b);
  }
}

/// The greatest distance of any point of the piece. It is that of an end: a hyperbola is nearest to its focus at its
/// vertex, and farther away on both sides.
double farthest_of(const GeodesicCones& cones, const CutPiece& piece) {
  const GeodesicCones::Root& u = cones.root(piece.root);
  if (piece.straight) return u.before + piece.end;
  const Bisector curve(u, cones.root(piece.other));
  return u.before + std::max(distance(u.at, curve.at(piece.begin)), distance(u.at, curve.at(piece.end)));
}

}  // namespace

const std::vector<CutPiece>& GeodesicCones::cut_pieces() const {
  std::call_once(cut_once_, [this] { cut_ = CutLocus(*this).run(0); });
  return cut_;
}

std::vector<Polyline> cut_locus_of(const GeodesicCones& cones, double chord_error, double beyond) {
  constexpr int kMostHalvings = 40;
  if (!(chord_error > 0)) throw_invalid("chord error of a cut locus must be above 0 metres");
  std::vector<Polyline> out;
  std::vector<CutPiece> far;  // far fewer than all, which are not found for them
  if (beyond > 0) far = CutLocus(cones).run(beyond);
  for (const CutPiece& piece : beyond > 0 ? far : cones.cut_pieces()) {
    if (farthest_of(cones, piece) <= beyond) continue;
    const GeodesicCones::Root &u = cones.root(piece.root), &v = cones.root(piece.other);
    if (piece.straight) {
      const Point e = direction_away(u, v);
      out.push_back({Point(u.at + piece.begin * e), Point(u.at + piece.end * e)});
      continue;
    }
    const Bisector curve(u, v);
    out.push_back({curve.at(piece.begin)});
    append_points(curve, piece.begin, piece.end, chord_error, kMostHalvings, out.back());
  }
  return out;
}

/// The distance is convex where one root's paths are shortest, so it is largest at a vertex of the mesh or at the
/// end of a piece of the cut locus.
double farthest_of(const GeodesicCones& cones) {
  double most = 0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(cones.mesh().triangles().size()); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      if (const double d = cones.to_vertex(t, k); std::isfinite(d)) most = std::max(most, d);
  for (const CutPiece& piece : CutLocus(cones).run(most)) most = std::max(most, farthest_of(cones, piece));
  return most;
}

}  // namespace oxturn
