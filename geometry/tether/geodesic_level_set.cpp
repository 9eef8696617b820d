// Method      In each triangle, for every root, the parts of its circle that no other root's circle contains. Then arcs
//             of one circle are joined across triangles, and arcs of different circles where the tether begins to bend
//             about a corner.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "geometry/tether/geodesic_cones.hpp"

namespace oxturn {
namespace {

using Arc = GeodesicField::Arc;

constexpr double kNear = 1e4;  // roundings of the field: ends of arcs nearer than this are one point

/// An arc, and whether it ends at walls of its triangles.
struct ArcPiece {
  std::int32_t root;
  Arc arc;
  bool begins_at_wall, ends_at_wall;
};

/// Finds the arcs at all lengths, triangle by triangle: each is divided into parts once.
class ArcFinder {
 public:
  /// `lengths`: ascending.
  ArcFinder(const GeodesicCones& cones, const std::vector<double>& lengths)
      : cones_(cones), lengths_(lengths), pieces_(lengths.size()) {}

  /// By length.
  std::vector<std::vector<ArcPiece>> run() {
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(cones_.mesh().triangles().size()); ++t)
      cones_.for_each_part(
          t, [&](const Facet& part, std::span<const Cone> here) { return may_be_crossed(part, here); },
          [&](const Facet& part, std::span<const Cone> here) {
            for (at_ = first_; at_ < end_; ++at_)
              for (const Cone& cone : here) add_pieces(t, part, here, cone);
          });
    return std::move(pieces_);
  }

 private:
  double length() const { return lengths_[at_]; }

  /// May there be points at one of the lengths in the part? Distances change at most as much as points move. Those
  /// lengths become first_ to end_.
  bool may_be_crossed(const Facet& part, std::span<const Cone> here) {
    const Point middle = part.middle();
    double radius = 0, least = std::numeric_limits<double>::infinity();
    for (const Point& p : part.vertices()) radius = std::max(radius, distance(p, middle));
    for (const Cone& c : here)
      if (const double d = cones_.distance_by(c, middle); d < least && cones_.contains(c, middle)) least = d;
    const double reach = radius + cones_.tie();
    first_ = static_cast<std::size_t>(std::ranges::lower_bound(lengths_, least - reach) - lengths_.begin());
    end_ = first_;
    while (end_ < lengths_.size() && lengths_[end_] <= least + reach) ++end_;
    return first_ < end_;
  }

  /// The arcs about one cone's root in a part of triangle t. breaks_ are the angles at which such an arc may begin or
  /// end, relative to the direction of the facet's middle.
  void add_pieces(std::int32_t t, const Facet& part, std::span<const Cone> here, const Cone& cone) {
    const Point& centre = cones_.root(cone.root).at;
    const double radius = length() - cones_.root(cone.root).before;
    if (radius <= cones_.rounding()) return;
    Facet facet = part;
    cones_.clip(facet, cone);
    if (facet.empty()) return;
    double most = 0;
    for (const Point& p : facet.vertices()) most = std::max(most, distance(centre, p));
    if (radius > most + cones_.rounding()) return;

    const Point towards = facet.middle() - centre;
    const double zero = std::atan2(towards.y(), towards.x());
    find_breaks({centre, radius, zero, zero}, facet, here, cone.root);
    if (breaks_.empty()) return;
    const auto is_at_length = [&](double angle) {
      const Point x = centre + radius * direction_of(zero + angle);
      return facet.contains(x, cones_.rounding()) && !is_reached_before(x, here);
    };
    for_each_run(breaks_, is_at_length, [&](double begin, double end) {
      const Arc arc{centre, radius, zero + begin, zero + end};
      pieces_[at_].push_back({cone.root, arc, at_wall(t, arc.at(arc.begin)), at_wall(t, arc.at(arc.end))});
    });
  }
  /// Empty if the circle does not meet the facet.
  void find_breaks(const Arc& circle, const Facet& facet, std::span<const Cone> here, std::int32_t root) {
    const double zero = circle.begin;
    breaks_.assign({-kPi, kPi});
    const auto add = [&](double angle) { breaks_.push_back(wrapped(angle - zero)); };
    const auto meet_line = [&](const Point& p, const Point& d) {
      const Point n = perpendicular(d);
      for_each_angle(n * circle.radius, n.dot(p - circle.centre), add);
    };
    for (std::size_t i = 0; i < facet.vertices().size(); ++i)
      meet_line(facet.vertices()[i], facet.next(i) - facet.vertices()[i]);
    if (breaks_.size() == 2 && !facet.contains(circle.at(zero), cones_.rounding())) return breaks_.clear();
    for (const Cone& o : here) {
      if (o.root == root) continue;
      const GeodesicCones::Root& v = cones_.root(o.root);
      const double other = length() - v.before;
      if (other <= 0) continue;
      const Point w = v.at - circle.centre;
      for_each_angle(w * (2 * circle.radius), circle.radius * circle.radius + w.squaredNorm() - other * other, add);
      if (o.whole) continue;
      meet_line(v.at, o.left);
      meet_line(v.at, o.right);
    }
  }
  bool is_reached_before(const Point& x, std::span<const Cone> here) const {
    return std::ranges::any_of(here, [&](const Cone& o) {
      return cones_.distance_by(o, x) < length() - cones_.tie() && cones_.contains(o, x);
    });
  }
  bool at_wall(std::int32_t t, const Point& x) const {
    const Mesh& mesh = cones_.mesh();
    for (std::size_t k = 0; k < 3; ++k)
      if (mesh.triangle(t).neighbour[k] == Mesh::kWall &&
          distance_to_segment(x, mesh.vertex(t, k + 1), mesh.vertex(t, k + 2)) <= kNear * cones_.rounding())
        return true;
    return false;
  }

  const GeodesicCones& cones_;
  const std::vector<double>& lengths_;
  std::size_t first_ = 0, end_ = 0, at_ = 0;  // lengths in the present part
  std::vector<std::vector<ArcPiece>> pieces_;
  std::vector<double> breaks_;
};

/// Joins arcs of the same circle.
class CircleJoiner {
 public:
  /// Ends nearer than `near` are one point.
  explicit CircleJoiner(double near) : near_(near) {}

  std::vector<ArcPiece> run(std::vector<ArcPiece> pieces) {
    for (ArcPiece& p : pieces) normalise(p.arc);
    std::ranges::sort(pieces, [](const ArcPiece& a, const ArcPiece& b) {
      return std::tie(a.root, a.arc.begin, a.arc.end) < std::tie(b.root, b.arc.begin, b.arc.end);
    });
    for (const ArcPiece& p : pieces) {
      if (out_.empty() || out_.back().root != p.root) {
        close_circle();
        first_ = out_.size();
      } else if (!out_.back().ends_at_wall && !p.begins_at_wall && touches(out_.back(), p.arc.begin)) {
        if (p.arc.end > out_.back().arc.end) {
          out_.back().arc.end = p.arc.end;
          out_.back().ends_at_wall = p.ends_at_wall;
        }
        continue;
      }
      out_.push_back(p);
    }
    close_circle();
    for (ArcPiece& p : out_) normalise(p.arc);
    return std::move(out_);
  }

 private:
  /// Turns the arc so that it begins in [-pi, pi].
  static void normalise(Arc& arc) {
    const double turn = wrapped(arc.begin) - arc.begin;
    arc.begin += turn;
    arc.end += turn;
  }
  bool touches(const ArcPiece& p, double begin) const { return (begin - p.arc.end) * p.arc.radius <= near_; }
  /// Joins the last arc of the present circle with its first.
  void close_circle() {
    if (first_ == out_.size()) return;
    ArcPiece &a = out_[first_], &b = out_.back();
    if (b.ends_at_wall || a.begins_at_wall || !touches(b, a.arc.begin + 2 * kPi)) return;
    if (first_ + 1 == out_.size()) {
      a.arc.end = a.arc.begin + 2 * kPi;
      return;
    }
    a.arc.begin = b.arc.begin - 2 * kPi;
    a.begins_at_wall = b.begins_at_wall;
    out_.pop_back();
  }

  double near_;
  std::vector<ArcPiece> out_;
  std::size_t first_ = 0;  // piece of the present circle, in out_
};

/// By how much the path to each root turns left at the root before it (at the anchor: its direction), rounded so that
/// what is collinear up to rounding compares as equal.
class RootTurns {
 public:
  explicit RootTurns(const GeodesicCones& cones) : cones_(cones) {
    for (std::size_t i = 0; i < cones.roots().size(); ++i) {
      const GeodesicCones::Root& r = cones.roots()[i];
      last_.push_back(r.parent == GeodesicCones::kNone ? Turn{} : towards(r.parent, r.at));
    }
  }
  /// Of the path to p whose last bend is at `root`.
  double left(std::int32_t root, const Point& p) const { return towards(root, p).left; }
  /// Of the path to a root other than the anchor, at its parent.
  double left(std::int32_t root) const { return last_[static_cast<std::size_t>(root)].left; }

 private:
  struct Turn {
    double heading = 0, left = 0;
  };
  Turn towards(std::int32_t root, const Point& p) const {
    constexpr double kSteps = 0x1p36;  // per radian
    const Point d = p - cones_.root(root).at;
    const double heading = std::atan2(d.y(), d.x());
    const double turn = wrapped(heading - last_[static_cast<std::size_t>(root)].heading);
    return {heading, std::round(turn * kSteps) / kSteps};
  }
  const GeodesicCones& cones_;
  std::vector<Turn> last_;  // by root: parents come before children
};

/// Links arcs to chains and sorts these.
class ChainBuilder {
 public:
  ChainBuilder(const GeodesicCones& cones, const RootTurns& turns, std::vector<ArcPiece> pieces, double near)
      : cones_(cones), turns_(turns), near_(near), pieces_(std::move(pieces)) {}

  std::vector<std::vector<Arc>> run() {
    link();
    std::vector<std::pair<Turns, std::size_t>> order;
    for (const std::size_t i : first_pieces()) order.emplace_back(turns_to(i), i);
    std::ranges::stable_sort(order, [](const auto& a, const auto& b) { return comes_before(a.first, b.first); });
    std::vector<std::vector<Arc>> out;
    std::vector<bool> done(pieces_.size(), false);
    for (const auto& [turns, first] : order) {
      out.emplace_back();
      follow(first, done, [&](std::size_t i) { out.back().push_back(pieces_[i].arc); });
    }
    return out;
  }

 private:
  /// Finds for each arc the one that continues it: of another root, by the same path.
  void link() {
    const std::size_t n = pieces_.size();
    next_.assign(n, n);
    is_first_.assign(n, true);
    std::vector<std::pair<double, std::size_t>> begins;  // by x
    for (std::size_t i = 0; i < n; ++i)
      if (!pieces_[i].begins_at_wall && !is_circle(i)) begins.emplace_back(begin_of(i).x(), i);
    std::sort(begins.begin(), begins.end());
    for (std::size_t i = 0; i < n; ++i) {
      if (pieces_[i].ends_at_wall || is_circle(i)) continue;
      const Point end = pieces_[i].arc.at(pieces_[i].arc.end);
      std::size_t best = n;
      double least = 2 * near_;
      for (auto b = std::lower_bound(begins.begin(), begins.end(), std::pair(end.x() - least, std::size_t{0}));
           b != begins.end() && b->first <= end.x() + 2 * near_; ++b) {
        const std::size_t j = b->second;
        const double d = distance(begin_of(j), end);
        if (j == i || pieces_[j].root == pieces_[i].root || !is_first_[j] || d > least) continue;
        if (!cones_.same_path(pieces_[i].root, pieces_[j].root, end)) continue;
        if (d < least || best == n) {
          least = d;
          best = j;
        }
      }
      if (best == n) continue;
      next_[i] = best;
      is_first_[best] = false;
    }
  }
  Point begin_of(std::size_t i) const { return pieces_[i].arc.at(pieces_[i].arc.begin); }
  bool is_circle(std::size_t i) const { return pieces_[i].arc.end - pieces_[i].arc.begin >= 2 * kPi - 1e-12; }

  /// One piece of every chain: the first of an open one, any of a closed one.
  std::vector<std::size_t> first_pieces() const {
    std::vector<bool> done(pieces_.size(), false);
    std::vector<std::size_t> first;
    for (const bool open : {true, false})
      for (std::size_t i = 0; i < pieces_.size(); ++i) {
        if (done[i] || (open && !is_first_[i])) continue;
        first.push_back(i);
        follow(i, done, [](std::size_t) {});
      }
    return first;
  }
  template <class F>
  void follow(std::size_t i, std::vector<bool>& done, F f) const {
    for (; i < pieces_.size() && !done[i]; i = next_[i]) {
      done[i] = true;
      f(i);
    }
  }

  /// A path from the anchor by its points, and by how much it turns left at each (RootTurns).
  struct Turns {
    std::vector<Point> points;
    std::vector<double> left;
  };
  /// To the middle of an arc.
  Turns turns_to(std::size_t i) const {
    const Arc& arc = pieces_[i].arc;
    std::int32_t root = pieces_[i].root;
    Turns path{{arc.at((arc.begin + arc.end) / 2)}, {}};
    path.left.push_back(turns_.left(root, path.points.front()));
    for (; root != GeodesicCones::kNone; root = cones_.root(root).parent) {
      path.points.push_back(cones_.root(root).at);
      if (cones_.root(root).parent != GeodesicCones::kNone) path.left.push_back(turns_.left(root));
    }
    std::reverse(path.points.begin(), path.points.end());
    std::reverse(path.left.begin(), path.left.end());
    return path;
  }
  /// Order around the anchor, by the first point at which the paths part. Where one bends about a corner on a straight
  /// segment of the other, it parts to the side to which it bends.
  static bool comes_before(const Turns& a, const Turns& b) {
    const std::size_t n = std::min(a.left.size(), b.left.size());
    std::size_t i = 0;
    while (i < n && a.left[i] == b.left[i] && a.points[i + 1] == b.points[i + 1]) ++i;
    if (i == n) return a.left.size() < b.left.size();
    if (a.left[i] != b.left[i]) return a.left[i] < b.left[i];
    const bool a_bends_first = distance(a.points[i], a.points[i + 1]) < distance(b.points[i], b.points[i + 1]);
    const Turns& near = a_bends_first ? a : b;
    const bool bends_left = i + 1 < near.left.size() && near.left[i + 1] > 0;
    return a_bends_first != bends_left;
  }

  const GeodesicCones& cones_;
  const RootTurns& turns_;
  double near_;
  std::vector<ArcPiece> pieces_;
  std::vector<std::size_t> next_;  // by piece; the number of pieces: none
  std::vector<bool> is_first_;     // no piece leads to it
};

}  // namespace

std::vector<std::vector<std::vector<Arc>>> level_sets_of(const GeodesicCones& cones,
                                                         const std::vector<double>& lengths) {
  const double near = kNear * cones.rounding();
  const RootTurns turns(cones);
  std::vector<std::vector<std::vector<Arc>>> sets;
  for (std::vector<ArcPiece>& pieces : ArcFinder(cones, lengths).run())
    sets.push_back(ChainBuilder(cones, turns, CircleJoiner(near).run(std::move(pieces)), near).run());
  return sets;
}

}  // namespace oxturn
