// Level sets: in each triangle, for every root, the parts of its circle that no other root reaches before; then arcs of
// one circle are joined across triangles, and circles across the rays on which a way starts to bend about a corner.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "geometry/tether/geodesic_clip.hpp"
#include "geometry/tether/geodesic_curves.hpp"

namespace oxturn {
namespace {

using Arc = GeodesicField::Arc;

struct Piece {
  std::int32_t root;
  Arc arc;
  bool wall_begin, wall_end;  // does it end at a wall of its triangle?
};

class Level {
 public:
  Level(const GeodesicCones& cones, double l) : cones_(cones), l_(l) {}

  std::vector<std::vector<Arc>> chains() {
    const auto& triangles = cones_.mesh().triangles();
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(triangles.size()); ++t) {
      cones_.for_each_part(
          t, [&](const Facet& part, std::span<const Cone> here) { return crossed(part, here); },
          [&](const Facet& part, std::span<const Cone> here) { collect(t, part, here); });
    }
    merge();
    link();
    return ordered();
  }

 private:
  /// May the part have places at the distance? No distance changes faster than places do.
  bool crossed(const Facet& part, std::span<const Cone> here) const {
    const Point middle = part.middle();
    double radius = 0, least = std::numeric_limits<double>::infinity();
    for (const Point& p : part.corners()) radius = std::max(radius, distance(p, middle));
    for (const Cone& c : here) {
      if (const double d = cones_.distance_by(c, middle); d < least && cones_.holds(c, middle)) least = d;
    }
    return std::abs(least - l_) <= radius + cones_.tie();
  }

  /// The pieces in a part of triangle t.
  void collect(std::int32_t t, const Facet& part, std::span<const Cone> here) {
    for (const Cone& cone : here) {
      const GeodesicCones::Root& u = cones_.root(cone.root);
      const double radius = l_ - u.before;
      if (radius <= cones_.rounding()) continue;
      Facet facet = part;
      cones_.clip(facet, cone);
      if (facet.empty()) continue;
      double most = 0;
      for (const Point& p : facet.corners()) most = std::max(most, distance(u.at, p));
      if (radius > most + cones_.rounding()) continue;

      const Point towards = facet.middle() - u.at;
      const double zero = std::atan2(towards.y(), towards.x());
      breaks_.assign({-kPi, kPi});
      const auto add = [&](double angle) { breaks_.push_back(turned(angle - zero)); };
      const auto meet_line = [&](const Point& p, const Point& d) {
        const Point n = perpendicular(d);
        for_each_angle(n * radius, n.dot(p - u.at), add);
      };
      const auto corners = facet.corners();
      for (std::size_t i = 0; i < corners.size(); ++i) meet_line(corners[i], facet.next(i) - corners[i]);
      if (breaks_.size() == 2 && !facet.holds(u.at + radius * direction_of(zero), cones_.rounding())) continue;
      for (const Cone& o : here) {
        if (o.root == cone.root) continue;
        const GeodesicCones::Root& v = cones_.root(o.root);
        const double other = l_ - v.before;
        if (other <= 0) continue;
        const Point w = v.at - u.at;
        for_each_angle(w * (2 * radius), radius * radius + w.squaredNorm() - other * other, add);
        if (o.whole) continue;
        meet_line(v.at, o.left);
        meet_line(v.at, o.right);
      }
      std::sort(breaks_.begin(), breaks_.end());
      double begin = 1, end = -1;
      const auto flush = [&] {
        if (begin <= end) {
          const Arc arc{u.at, radius, zero + begin, zero + end};
          pieces_.push_back({cone.root, arc, at_wall(t, arc.at(arc.begin)), at_wall(t, arc.at(arc.end))});
        }
        begin = 1;
        end = -1;
      };
      for (std::size_t i = 1; i < breaks_.size(); ++i) {
        const double from = breaks_[i - 1], to = breaks_[i];
        if (to - from < 1e-15) continue;
        const Point x = u.at + radius * direction_of(zero + (from + to) / 2);
        const bool open =
            facet.holds(x, cones_.rounding()) && std::none_of(here.begin(), here.end(), [&](const Cone& o) {
              return cones_.distance_by(o, x) < l_ - cones_.tie() && cones_.holds(o, x);
            });
        if (!open) {
          flush();
          continue;
        }
        if (begin > end) begin = from;
        end = to;
      }
      flush();
    }
  }
  bool at_wall(std::int32_t t, const Point& x) const {
    const auto& neighbour = cones_.mesh().triangles()[static_cast<std::size_t>(t)].neighbour;
    for (std::size_t k = 0; k < 3; ++k) {
      if (neighbour[k] == Mesh::kWall &&
          distance_to_segment(x, cones_.corner(t, k + 1), cones_.corner(t, k + 2)) <= near())
        return true;
    }
    return false;
  }
  /// Ends of arcs as near as this are one place.
  double near() const { return 1e4 * cones_.rounding(); }

  /// Joins pieces of one circle that meet away from walls.
  void merge() {
    for (Piece& p : pieces_) normalise(p.arc);
    std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
      return std::tie(a.root, a.arc.begin, a.arc.end) < std::tie(b.root, b.arc.begin, b.arc.end);
    });
    std::vector<Piece> out;
    std::size_t first = 0;  // of this root, in out
    const auto close_circle = [&] {
      if (first == out.size()) return;
      Piece &a = out[first], &b = out.back();
      if (b.wall_end || a.wall_begin || !meets(b, a.arc.begin + 2 * kPi)) return;
      if (first + 1 == out.size()) {
        a.arc.end = a.arc.begin + 2 * kPi;  // all round
        return;
      }
      a.arc.begin = b.arc.begin - 2 * kPi;
      a.wall_begin = b.wall_begin;
      out.pop_back();
    };
    for (const Piece& p : pieces_) {
      if (out.empty() || out.back().root != p.root) {
        close_circle();
        first = out.size();
      } else if (!out.back().wall_end && !p.wall_begin && meets(out.back(), p.arc.begin)) {
        if (p.arc.end > out.back().arc.end) {
          out.back().arc.end = p.arc.end;
          out.back().wall_end = p.wall_end;
        }
        continue;
      }
      out.push_back(p);
    }
    close_circle();
    pieces_.swap(out);
    for (Piece& p : pieces_) normalise(p.arc);
  }
  static void normalise(Arc& arc) {
    const double turn = turned(arc.begin) - arc.begin;
    arc.begin += turn;
    arc.end += turn;
  }
  bool meets(const Piece& p, double begin) const { return (begin - p.arc.end) * p.arc.radius <= near(); }

  /// Finds for each arc the one that goes on where it ends: of another root, by the same way.
  void link() {
    const std::size_t n = pieces_.size();
    next_.assign(n, n);
    first_.assign(n, true);
    std::vector<std::pair<double, std::size_t>> begins;
    for (std::size_t i = 0; i < n; ++i) {
      if (!pieces_[i].wall_begin && !all_round(i)) begins.emplace_back(begin_of(i).x(), i);
    }
    std::sort(begins.begin(), begins.end());
    for (std::size_t i = 0; i < n; ++i) {
      if (pieces_[i].wall_end || all_round(i)) continue;
      const Point end = pieces_[i].arc.at(pieces_[i].arc.end);
      std::size_t best = n;
      double least = 2 * near();
      for (auto b = std::lower_bound(begins.begin(), begins.end(), std::pair(end.x() - least, std::size_t{0}));
           b != begins.end() && b->first <= end.x() + 2 * near(); ++b) {
        const std::size_t j = b->second;
        const double d = distance(begin_of(j), end);
        if (j == i || pieces_[j].root == pieces_[i].root || !first_[j] || d > least) continue;
        if (!cones_.same_way(pieces_[i].root, pieces_[j].root, end)) continue;
        if (d < least || best == n) {
          least = d;
          best = j;
        }
      }
      if (best == n) continue;
      next_[i] = best;
      first_[best] = false;
    }
  }
  Point begin_of(std::size_t i) const { return pieces_[i].arc.at(pieces_[i].arc.begin); }
  bool all_round(std::size_t i) const { return pieces_[i].arc.end - pieces_[i].arc.begin >= 2 * kPi - 1e-12; }

  /// A way as it turns: places from the anchor on, and how far it turns left at each (at the anchor: its direction),
  /// rounded so that what lies in line but for rounding compares as equal.
  struct Way {
    std::vector<Point> places;
    std::vector<double> turns;
  };
  Way path_to(std::size_t i) const {
    Way way;
    const Arc& arc = pieces_[i].arc;
    way.places.push_back(arc.at((arc.begin + arc.end) / 2));
    for (std::int32_t r = pieces_[i].root; r >= 0; r = cones_.root(r).parent) way.places.push_back(cones_.root(r).at);
    std::reverse(way.places.begin(), way.places.end());
    double before = 0;
    for (std::size_t k = 1; k < way.places.size(); ++k) {
      const Point d = way.places[k] - way.places[k - 1];
      const double angle = std::atan2(d.y(), d.x());
      way.turns.push_back(std::round(turned(angle - before) * 0x1p36) * 0x1p-36);
      before = angle;
    }
    return way;
  }
  /// Order round the anchor: by the first place where the ways part. Where one bends about a corner on the other's
  /// straight stretch, it parts to the side to which it bends.
  static bool comes_before(const Way& a, const Way& b) {
    const std::size_t n = std::min(a.turns.size(), b.turns.size());
    std::size_t i = 0;
    while (i < n && a.turns[i] == b.turns[i] && a.places[i + 1] == b.places[i + 1]) ++i;
    if (i == n) return a.turns.size() < b.turns.size();
    if (a.turns[i] != b.turns[i]) return a.turns[i] < b.turns[i];
    const bool a_nearer = distance(a.places[i], a.places[i + 1]) < distance(b.places[i], b.places[i + 1]);
    const Way& near = a_nearer ? a : b;
    const bool left = i + 1 < near.turns.size() && near.turns[i + 1] > 0;
    return a_nearer != left;
  }

  std::vector<std::vector<Arc>> ordered() const {
    const std::size_t n = pieces_.size();
    std::vector<std::uint8_t> done(n, 0);
    std::vector<std::size_t> starts;
    const auto follow = [&](std::size_t i, auto f) {
      for (; i < n && !done[i]; i = next_[i]) {
        done[i] = 1;
        f(i);
      }
    };
    for (const bool open : {true, false}) {  // chains with a beginning, then rings
      for (std::size_t i = 0; i < n; ++i) {
        if (done[i] || (open && !first_[i])) continue;
        starts.push_back(i);
        follow(i, [](std::size_t) {});
      }
    }
    std::vector<std::pair<Way, std::size_t>> order;
    for (const std::size_t i : starts) order.emplace_back(path_to(i), i);
    std::stable_sort(order.begin(), order.end(),
                     [](const auto& a, const auto& b) { return comes_before(a.first, b.first); });
    std::fill(done.begin(), done.end(), std::uint8_t{0});
    std::vector<std::vector<Arc>> out;
    for (const auto& [way, start] : order) {
      out.emplace_back();
      follow(start, [&](std::size_t i) { out.back().push_back(pieces_[i].arc); });
    }
    return out;
  }

  const GeodesicCones& cones_;
  const double l_;
  std::vector<Piece> pieces_;
  std::vector<double> breaks_;
  std::vector<std::size_t> next_;  // by piece; their number: none
  std::vector<bool> first_;        // nothing leads to it
};

}  // namespace

std::vector<std::vector<Arc>> level_of(const GeodesicCones& cones, double l) { return Level(cones, l).chains(); }

}  // namespace oxturn
