// Method      In each triangle, for every root, the parts of its circle that no other root's circle contains. Then arcs
//             of one circle are joined across triangles, and arcs of different circles where the tether begins to bend
//             about a corner.
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/math.hpp"
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
    for (triangle_ = 0; triangle_ < static_cast<std::int32_t>(cones_.mesh().triangles().size()); ++triangle_)
      cones_.for_each_part(
          triangle_, [&](const Facet& part, std::span<const Cone> here) { return may_be_crossed(part, here); },
          [&](const Facet& part, std::span<const Cone> here) { search(part, here); });
    return std::move(pieces_);
  }

 private:
  /// What one cone sees of the present part, and the lengths of its paths there.
  struct View {
    const Cone* cone;
    Point root;
    double before;
    Facet facet;
    double least, most;
    double by(const Point& p) const { return before + (p - root).norm(); }
  };

  /// May there be points at one of the lengths in the part? Distances change at most as much as points move.
  bool may_be_crossed(const Facet& part, std::span<const Cone> here) const {
    const Point middle = part.middle();
    double radius = 0, least = std::numeric_limits<double>::infinity();
    for (const Point& p : part.vertices()) radius = std::max(radius, distance(p, middle));
    for (const Cone& c : here)
      if (const double d = cones_.distance_by(c, middle); d < least && cones_.contains(c, middle)) least = d;
    const double reach = radius + cones_.tie();
    const auto first = std::ranges::lower_bound(lengths_, least - reach);
    return first != lengths_.end() && *first <= least + reach;
  }

  void search(const Facet& part, std::span<const Cone> here) {
    const double slack = cones_.tie() + 4 * cones_.rounding();
    const double most = find_views(part, here) + slack;  // no point of the part is farther away
    double least = most;
    for (const View& view : views_) least = std::min(least, view.least - slack);
    const auto first = std::ranges::lower_bound(lengths_, least) - lengths_.begin();
    for (at_ = static_cast<std::size_t>(first); at_ < lengths_.size() && length() <= most; ++at_) {
      met_.clear();  // the others reach nothing of the part with less
      for (const View& view : views_)
        if (view.least <= length() + slack) met_.push_back(&view);
      for (const View* view : met_)
        if (length() <= view->most + cones_.rounding()) add_pieces(*view);
    }
  }
  /// Returns the largest distance of any point of the part, or more.
  double find_views(const Facet& part, std::span<const Cone> here) {
    views_.clear();
    double most = 0, most_by_one = std::numeric_limits<double>::infinity();
    for (const Cone& cone : here) {
      const GeodesicCones::Root& root = cones_.root(cone.root);
      View view{&cone, root.at, root.before, part, 0, 0};
      cones_.clip(view.facet, cone);
      if (view.facet.empty()) continue;
      double near = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < view.facet.vertices().size(); ++i) {
        const Point& p = view.facet.vertices()[i];
        near = std::min(near, distance_to_segment(root.at, p, view.facet.next(i)));
        view.most = std::max(view.most, view.by(p));
      }
      view.least = root.before + (view.facet.contains(root.at, 0) ? 0 : near);
      if (std::ranges::all_of(part.vertices(), [&](const Point& p) { return cones_.contains(cone, p); }))
        most_by_one = std::min(most_by_one, view.most);
      most = std::max(most, view.most);
      views_.push_back(view);
    }
    return std::min(most, most_by_one);
  }

  /// The arcs about one cone's root in the present part. breaks_ are the angles at which such an arc may begin or end,
  /// relative to the direction of the facet's middle.
  void add_pieces(const View& view) {
    const double radius = length() - view.before;
    if (radius <= cones_.rounding() || is_hidden(view)) return;
    const Point towards = view.facet.middle() - view.root;
    const double zero = math::atan2(towards.y(), towards.x());
    find_breaks({view.root, radius, zero, zero}, view);
    if (breaks_.empty()) return;
    const auto is_at_length = [&](double angle) {
      const Point x = view.root + radius * direction_of(zero + angle);
      return view.facet.contains(x, cones_.rounding()) && !is_reached_before(x);
    };
    for_each_run(breaks_, is_at_length, [&](double begin, double end) {
      const Arc arc{view.root, radius, zero + begin, zero + end};
      pieces_[at_].push_back({view.cone->root, arc, at_wall(arc.at(arc.begin)), at_wall(arc.at(arc.end))});
    });
  }
  /// Does another cone reach all that this one sees with less? Distances are convex, so vertices tell.
  bool is_hidden(const View& view) const {
    const double enough = length() - cones_.tie() - cones_.rounding();
    return std::ranges::any_of(met_, [&](const View* o) {
      return o->least < enough && o->cone->root != view.cone->root &&
             std::ranges::all_of(view.facet.vertices(),
                                 [&](const Point& p) { return o->by(p) < enough && cones_.contains(*o->cone, p); });
    });
  }
  /// Empty if the circle does not meet the facet.
  void find_breaks(const Arc& circle, const View& view) {
    const double zero = circle.begin;
    const Facet& facet = view.facet;
    breaks_.assign({-kPi, kPi});
    const auto add = [&](double angle) { breaks_.push_back(wrapped(angle - zero)); };
    const auto meet_line = [&](const Point& p, const Point& d) {
      const Point n = perpendicular(d);
      for_each_angle(n * circle.radius, n.dot(p - circle.centre), add);
    };
    for (std::size_t i = 0; i < facet.vertices().size(); ++i) {
      const Point &a = facet.vertices()[i], &b = facet.next(i);
      const bool inside = std::max(view.by(a), view.by(b)) < length() - cones_.tie();
      if (!inside) meet_line(a, b - a);
    }
    if (breaks_.size() == 2 && !facet.contains(circle.at(zero), cones_.rounding())) return breaks_.clear();
    for (const View* o : met_) {
      if (o->cone->root == view.cone->root) continue;
      const double other = length() - o->before;
      if (other <= 0) continue;
      const Point w = o->root - circle.centre;
      for_each_angle(w * (2 * circle.radius), circle.radius * circle.radius + w.squaredNorm() - other * other, add);
      if (o->cone->whole) continue;
      for (const Point& ray : {o->cone->left, o->cone->right})
        if (divides(o->root, ray, facet)) meet_line(o->root, ray);
    }
  }
  /// Does the line from p along the unit vector d meet the facet?
  bool divides(const Point& p, const Point& d, const Facet& facet) const {
    double left = -std::numeric_limits<double>::infinity(), right = left;
    for (const Point& v : facet.vertices()) {
      const double side = cross(d, v - p);
      left = std::max(left, side);
      right = std::max(right, -side);
    }
    return std::min(left, right) >= -2 * cones_.rounding();
  }
  bool is_reached_before(const Point& x) const {
    return std::ranges::any_of(
        met_, [&](const View* o) { return o->by(x) < length() - cones_.tie() && cones_.contains(*o->cone, x); });
  }
  bool at_wall(const Point& x) const {
    const Mesh& mesh = cones_.mesh();
    for (std::size_t k = 0; k < 3; ++k)
      if (mesh.triangle(triangle_).neighbour[k] == Mesh::kWall &&
          distance_to_segment(x, mesh.vertex(triangle_, k + 1), mesh.vertex(triangle_, k + 2)) <=
              kNear * cones_.rounding())
        return true;
    return false;
  }
  double length() const { return lengths_[at_]; }

  const GeodesicCones& cones_;
  const std::vector<double>& lengths_;
  std::vector<std::vector<ArcPiece>> pieces_;
  std::int32_t triangle_ = 0;  // the present one
  std::vector<View> views_;    // of its present part
  std::size_t at_ = 0;         // the present length
  std::vector<const View*> met_;
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
    const double heading = math::atan2(d.y(), d.x());
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
