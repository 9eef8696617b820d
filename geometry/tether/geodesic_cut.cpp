// Pieces of the cut locus: in each triangle, for every two roots u and v, where their ways are equally long.
//
// Seen from u, with w = v - u and c = d(u) - d(v), that is at distance (|w|^2 - c^2) / (2 (e . w + c)) in direction e.
// Where this curve meets a line, or another curve about u, is linear in e, so all ends of pieces are in closed form. The
// later root takes the part of u: its side of the curve is convex and star-shaped about it.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/tether/geodesic_clip.hpp"
#include "geometry/tether/geodesic_curves.hpp"

namespace oxturn {
namespace {

struct Bisector {
  Point u, w;
  double before;  // of u
  double c, k;    // k = (|w|^2 - c^2) / 2
  Bisector(const GeodesicCones::Root& of, const GeodesicCones::Root& other)
      : u(of.at),
        w(other.at - of.at),
        before(of.before),
        c(of.before - other.before),
        k((w.norm() - c) * (w.norm() + c) / 2) {}
  /// Distance from u in direction e; infinite or negative if the curve is not met.
  double reach(const Point& e) const { return k / (e.dot(w) + c); }
  Point at(double angle) const {
    const Point e = direction_of(angle);
    return u + reach(e) * e;
  }
  /// Directions in which it meets the line through p along d.
  template <class F>
  void meet_line(const Point& p, const Point& d, F f) const {
    const Point n = perpendicular(d);
    const double h = n.dot(p - u);
    for_each_angle(k * n - h * w, h * c, f);
  }
  template <class F>
  void meet(const Bisector& o, F f) const {  // about the same u
    for_each_angle(k * o.w - o.k * w, o.k * c - k * o.c, f);
  }
};

class Pieces {
 public:
  explicit Pieces(const GeodesicCones& cones) : cones_(cones) {}

  /// Calls curve(bisector, begin, end) or straight(root, a, b) for every piece in triangle t.
  template <class Curve, class Straight>
  void each(std::int32_t t, Curve curve, Straight straight) {
    const auto all = [](const Facet&, std::span<const Cone> here) { return here.size() > 1; };
    cones_.for_each_part(t, all, [&](const Facet& part, std::span<const Cone> here) {
      here_ = here;
      for (const Cone& a : here) {
        Facet seen = part;
        cones_.clip(seen, a);
        if (seen.empty()) continue;
        for (const Cone& b : here) {
          const GeodesicCones::Root &u = cones_.root(a.root), &v = cones_.root(b.root);
          if (a.root == b.root || u.before < v.before || (u.before == v.before && a.root < b.root)) continue;
          const double slack = distance(u.at, v.at) - (u.before - v.before);
          if (slack < -cones_.tie()) continue;  // v does not see u, and is always nearer
          if (slack <= cones_.tie()) {
            behind(a, b, part, straight);
            continue;
          }
          Facet both = seen;
          cones_.clip(both, b);
          if (!both.empty()) between(a, b, both, curve);
        }
      }
    });
  }

 private:
  /// Is no other way than those of a and b clearly shorter?
  bool shortest(const Cone& a, const Cone& b, const Point& x) const {
    const double best = std::min(cones_.distance_by(a, x), cones_.distance_by(b, x)) - cones_.tie();
    return std::none_of(here_.begin(), here_.end(),
                        [&](const Cone& o) { return cones_.distance_by(o, x) < best && cones_.holds(o, x); });
  }
  template <class Curve>
  void between(const Cone& a, const Cone& b, const Facet& facet, Curve curve) {
    const Bisector line(cones_.root(a.root), cones_.root(b.root));
    const Point towards = facet.middle() - line.u;
    const double zero = std::atan2(towards.y(), towards.x());
    breaks_.clear();
    const auto add = [&](double angle) {
      const Point e = direction_of(angle);
      if (e.dot(line.w) + line.c > 0) breaks_.push_back(turned(angle - zero));
    };
    const auto corners = facet.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) line.meet_line(corners[i], facet.next(i) - corners[i], add);
    if (breaks_.size() < 2) return;
    // Does any stretch of it lie in the facet at all?
    const auto holds = [&](double from, double to) {
      return facet.holds(line.at(zero + (from + to) / 2), cones_.rounding());
    };
    std::sort(breaks_.begin(), breaks_.end());
    double first = 1, last = -1;
    for (std::size_t i = 1; i < breaks_.size(); ++i) {
      if (breaks_[i] - breaks_[i - 1] < 1e-15 || !holds(breaks_[i - 1], breaks_[i])) continue;
      if (first > last) first = breaks_[i - 1];
      last = breaks_[i];
    }
    if (first > last) return;
    for (const Cone& o : here_) {
      if (o.root == b.root || o.root == a.root) continue;
      const GeodesicCones::Root& third = cones_.root(o.root);
      line.meet(Bisector(cones_.root(a.root), third), add);
      if (o.whole) continue;
      line.meet_line(third.at, o.left, add);
      line.meet_line(third.at, o.right, add);
    }
    std::sort(breaks_.begin(), breaks_.end());
    double begin = 1, end = -1;  // the piece so far, if begin <= end
    for (std::size_t i = 1; i < breaks_.size(); ++i) {
      const double from = breaks_[i - 1], to = breaks_[i];
      if (from < first || to > last || to - from < 1e-15) continue;
      const Point x = line.at(zero + (from + to) / 2);
      if (facet.holds(x, cones_.rounding()) && shortest(a, b, x)) {
        if (begin > end) begin = from;
        end = to;
      } else if (begin <= end) {
        curve(line, zero + begin, zero + end);
        begin = 1;
        end = -1;
      }
    }
    if (begin <= end) curve(line, zero + begin, zero + end);
  }

  /// The curve has closed to a ray: the way by v runs through u. A cut only if the way that u has its length from
  /// comes from elsewhere.
  template <class Straight>
  void behind(const Cone& a, const Cone& b, const Facet& part, Straight straight) {
    const GeodesicCones::Root &u = cones_.root(a.root), &v = cones_.root(b.root);
    if (u.parent == b.root || u.at == v.at) return;
    const Point e = (u.at - v.at).normalized();
    breaks_.assign(1, 0);
    const auto line = [&](const Point& p, const Point& d) {
      const double across = cross(e, d);
      if (across != 0) breaks_.push_back(cross(p - u.at, d) / across);
    };
    const auto corners = part.corners();
    for (std::size_t i = 0; i < 3; ++i) line(corners[i], part.next(i) - corners[i]);
    for (const Cone& o : here_) {
      const GeodesicCones::Root& third = cones_.root(o.root);
      if (!o.whole) {
        line(third.at, o.left);
        line(third.at, o.right);
      }
      if (o.root != a.root && o.root != b.root) breaks_.push_back(Bisector(u, third).reach(e));
    }
    std::erase_if(breaks_, [](double s) { return !(s >= 0 && s < 1e300); });
    std::sort(breaks_.begin(), breaks_.end());
    for (std::size_t i = 1; i < breaks_.size(); ++i) {
      if (breaks_[i] - breaks_[i - 1] <= cones_.rounding()) continue;
      const Point x = u.at + (breaks_[i - 1] + breaks_[i]) / 2 * e;
      if (!part.holds(x, cones_.rounding()) || !cones_.holds(a, x) || !cones_.holds(b, x) || !shortest(a, b, x))
        continue;
      if (cones_.same_way(a.root, b.root, x)) continue;
      straight(u, Point(u.at + breaks_[i - 1] * e), Point(u.at + breaks_[i] * e));
    }
  }

  const GeodesicCones& cones_;
  std::span<const Cone> here_;
  std::vector<double> breaks_;
};

/// Appends points of the curve after `begin` up to `end`, so that chords stay within `chord` of it.
void trace(const Bisector& curve, double begin, double end, double chord, int depth, Polyline& out) {
  const Point a = out.back(), b = curve.at(end);
  const auto off = [&](double part) { return distance_to_segment(curve.at(begin + part * (end - begin)), a, b); };
  // Half of what is allowed: the worst place may lie between those tried.
  if (depth > 0 && std::max({off(0.25), off(0.5), off(0.75)}) > chord / 2) {
    const double middle = (begin + end) / 2;
    trace(curve, begin, middle, chord, depth - 1, out);
    trace(curve, middle, end, chord, depth - 1, out);
  } else {
    out.push_back(b);
  }
}

template <class Curve, class Straight>
void for_each_piece(const GeodesicCones& cones, Curve curve, Straight straight) {
  Pieces pieces(cones);
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(cones.mesh().triangles().size()); ++t)
    pieces.each(t, curve, straight);
}

}  // namespace

std::vector<Polyline> cut_of(const GeodesicCones& cones, double chord) {
  if (!(chord > 0)) throw std::invalid_argument("chord error of a cut must be above 0 metres");
  std::vector<Polyline> out;
  for_each_piece(
      cones,
      [&](const Bisector& curve, double begin, double end) {
        out.push_back({curve.at(begin)});
        trace(curve, begin, end, chord, 40, out.back());
      },
      [&](const GeodesicCones::Root&, const Point& a, const Point& b) {
        out.push_back({a, b});
      });
  return out;
}

double farthest_of(const GeodesicCones& cones) {
  double most = 0;
  for (std::int32_t t = 0; t < static_cast<std::int32_t>(cones.mesh().triangles().size()); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (const double d = cones.to_corner(t, k); std::isfinite(d)) most = std::max(most, d);
    }
  }
  for_each_piece(
      cones,
      [&](const Bisector& curve, double begin, double end) {
        for (const double angle : {begin, end})
          most = std::max(most, curve.before + distance(curve.u, curve.at(angle)));
      },
      [&](const GeodesicCones::Root& u, const Point&, const Point& b) {
        most = std::max(most, u.before + distance(u.at, b));
      });
  return most;
}

}  // namespace oxturn
