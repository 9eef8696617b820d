#include "geometry/tether/geodesic_cones.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
// Lengths that agree to this factor are taken as equal: far above the rounding of a sum of corners' distances.
constexpr double kTie = 1e-12;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

/// From a root through the point, or, if `behind`, straight away from it.
struct Ray {
  Point by{0, 0};
  bool behind = false;
};

/// A cone about to enter `triangle` through the edge opposite its corner `apex`.
struct Window {
  std::int32_t root, triangle, apex;
  Ray left, right;
};

}  // namespace

class ConeSearch {
 public:
  explicit ConeSearch(GeodesicCones& field) : f_(field), mesh_(field.mesh_) {}

  void run(const std::vector<std::int32_t>& home) {
    number_fans();
    labels_.resize(f_.label_.size());
    begin(home);
    while (!open_.empty()) {
      std::pop_heap(open_.begin(), open_.end());
      const Open next = open_.back();
      open_.pop_back();
      if (next.fan >= 0)
        settle(next.fan);
      else
        enter(next.window);
    }
    for (std::size_t i = 0; i < labels_.size(); ++i) f_.label_[i] = labels_[i].length;
    store();
  }

 private:
  /// The best way known to a fan's corner: straight from a root, by way of a triangle of the fan.
  struct Label {
    double length = kInf;
    std::int32_t root = -1, triangle = -1;
    bool settled = false;
  };
  struct Open {
    double key;
    std::int32_t fan, window;              // one of them
    bool operator<(const Open& o) const {  // for a heap with the least on top
      return key != o.key ? key > o.key : fan != o.fan ? fan > o.fan : window > o.window;
    }
  };
  struct Placed {
    std::int32_t triangle;
    Cone cone;
  };

  const Mesh::Triangle& triangle(std::int32_t t) const { return mesh_.triangles()[at(t)]; }
  const Point& corner(std::int32_t t, std::size_t k) const { return mesh_.points()[at(triangle(t).vertex[k % 3])]; }
  std::int32_t fan(std::int32_t t, std::size_t k) const { return f_.fan_[3 * at(t) + k % 3]; }
  Label& label(std::int32_t t, std::size_t k) { return labels_[at(fan(t, k))]; }
  const GeodesicCones::Root& root(std::int32_t i) const { return f_.roots_[at(i)]; }
  static int side(const Point& origin, const Ray& ray, const Point& x) {
    return ray.behind ? orientation(ray.by, origin, x) : orientation(origin, ray.by, x);
  }
  std::size_t place_in(std::int32_t t, std::int32_t point) const {
    std::size_t k = 0;
    while (triangle(t).vertex[k] != point) ++k;
    return k;
  }

  /// Numbers the fans; a fan of more than 180 degrees can bend a way.
  void number_fans() {
    f_.fan_.assign(3 * mesh_.triangles().size(), -1);
    std::int32_t count = 0;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh_.triangles().size()); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (fan(t, k) >= 0) continue;
        const std::int32_t point = triangle(t).vertex[k];
        for (const std::size_t turn : {std::size_t{1}, std::size_t{2}}) {  // counter-clockwise, then clockwise
          std::int32_t n = t;
          while (n != Mesh::kWall) {
            const std::size_t i = place_in(n, point);
            if (n != t && fan(n, i) >= 0) break;  // all round
            f_.fan_[3 * at(n) + i] = count;
            n = triangle(n).neighbour[(i + turn) % 3];
          }
        }
        ++count;
      }
    }
    f_.label_.assign(at(count), kInf);
  }

  void begin(const std::vector<std::int32_t>& home) {
    const Point& anchor = root(0).at;
    for (const std::int32_t t : home) {
      placed_.push_back({t, {0, true, {0, 0}, {0, 0}}});
      for (std::size_t k = 0; k < 3; ++k) reach(t, k, 0);
    }
    for (const std::int32_t t : home) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t n = triangle(t).neighbour[k];
        if (n == Mesh::kWall || std::binary_search(home.begin(), home.end(), n)) continue;
        const Point &right = corner(t, k + 1), &left = corner(t, k + 2);
        if (orientation(right, left, anchor) > 0) leave(t, k, {0, 0, 0, {left}, {right}});
      }
    }
  }

  /// Walks round the fan of corner i of triangle t, counter-clockwise for turn > 0, to where the fan is hidden from
  /// `from`, which sees the corner through t. False if it is not hidden.
  bool first_hidden(const Point& from, std::int32_t& t, std::size_t& i, int turn) const {
    const std::int32_t start = t, point = triangle(t).vertex[i];
    const std::size_t step = turn > 0 ? 1 : 2;
    while (true) {
      if (t != start && turn * orientation(from, corner(t, i), corner(t, i + 3 - step)) > 0) return true;
      t = triangle(t).neighbour[(i + step) % 3];
      if (t == Mesh::kWall || t == start) return false;
      i = place_in(t, point);
    }
  }
  /// To which side a way from `from` by triangle t can turn about corner i: +1 left, -1 right, 0 to none.
  int turning_side(const Point& from, std::int32_t t, std::size_t i) const {
    if (!mesh_.is_reflex(triangle(t).vertex[i])) return 0;
    for (const int turn : {1, -1}) {
      std::int32_t n = t;
      std::size_t k = i;
      if (first_hidden(from, n, k, turn)) return turn;
    }
    return 0;
  }

  /// Root r sees corner k of triangle t, through t.
  void reach(std::int32_t t, std::size_t k, std::int32_t r) {
    Label& l = label(t, k);
    if (l.settled) return;
    const Point& v = corner(t, k);
    const double length = root(r).before + distance(root(r).at, v);
    if (length > l.length * (1 + kTie)) return;
    if (length >= l.length * (1 - kTie) && !better_tie(l, t, k, r)) {
      l.length = std::min(l.length, length);
      return;
    }
    const bool later = l.length < kInf && length >= l.length * (1 - kTie);
    l = {std::min(l.length, length), r, t, false};
    // Settled a little late, so that all equal ways are known by then.
    if (!later && mesh_.is_reflex(triangle(t).vertex[k])) push({length * (1 + 4 * kTie), fan(t, k), -1});
  }
  /// Of two equal ways to a corner the one that needs the corner less is taken: then what lies beyond the corner hangs
  /// together with what that way passes. (Between the two, the corner's ground would be cut off from both.)
  bool better_tie(const Label& old, std::int32_t t, std::size_t k, std::int32_t r) const {
    const Point& v = corner(t, k);
    const Point &was = root(old.root).at, &is = root(r).at;
    const int old_side = turning_side(was, old.triangle, place_in(old.triangle, triangle(t).vertex[k]));
    const int new_side = turning_side(is, t, k);
    if (old_side == 0) return false;
    if (new_side == 0) return true;
    if (old_side != new_side) return false;
    const int turn = new_side * orientation(v, was, is);
    return turn != 0 ? turn > 0 : root(r).corners < root(old.root).corners;
  }

  void push(const Open& o) {
    open_.push_back(o);
    std::push_heap(open_.begin(), open_.end());
  }

  void settle(std::int32_t fan) {
    Label& l = labels_[at(fan)];
    if (l.settled) return;
    l.settled = true;
    const std::int32_t from = l.root, by = l.triangle;
    std::size_t in_by = 0;
    while (this->fan(by, in_by) != fan) ++in_by;
    std::int32_t self = -1;
    for (const int turn : {1, -1}) {
      std::int32_t t = by;
      std::size_t i = in_by;
      const Point behind = root(from).at;
      if (!first_hidden(behind, t, i, turn)) continue;
      if (self < 0) {
        self = static_cast<std::int32_t>(f_.roots_.size());
        f_.roots_.push_back({corner(by, in_by), l.length, from, root(from).corners + 1});
      }
      const std::int32_t point = triangle(t).vertex[i];
      const std::size_t step = turn > 0 ? 1 : 2;
      for (bool first = true; t != Mesh::kWall; first = false) {
        i = place_in(t, point);
        const std::size_t far = (i + 3 - step) % 3, near = (i + step) % 3;
        Ray limit{corner(t, near)};
        if (first && turn * orientation(behind, corner(t, i), corner(t, near)) < 0)
          limit = {behind, true};
        else
          reach(t, near, self);
        reach(t, far, self);
        const Ray edge{corner(t, far)};
        const Window w = turn > 0 ? Window{self, 0, 0, edge, limit} : Window{self, 0, 0, limit, edge};
        placed_.push_back({t, cone(w)});
        leave(t, i, w);
        t = triangle(t).neighbour[(i + step) % 3];
      }
    }
  }

  Point direction(const Point& origin, const Ray& ray) const {
    const Point d = ray.behind ? Point(origin - ray.by) : Point(ray.by - origin);
    return d / d.norm();
  }
  Cone cone(const Window& w) const {
    const Point& r = root(w.root).at;
    return {w.root, false, direction(r, w.left), direction(r, w.right)};
  }

  /// Where the ray from r meets the edge from left to right.
  static Point hit(const Point& r, const Ray& ray, const Point& left, const Point& right) {
    if (!ray.behind && ray.by == left) return left;
    if (!ray.behind && ray.by == right) return right;
    const Point d = ray.behind ? Point(r - ray.by) : Point(ray.by - r);
    const double a = std::max(0.0, cross(d, left - r)), b = std::max(0.0, -cross(d, right - r));
    return a + b > 0 ? lerp(left, right, a / (a + b)) : left;
  }

  /// Length of the way to the nearest place where the window enters its triangle, or infinity if it is nowhere
  /// shortest: a labelled corner beside it (or behind it, in the triangle `from` that it leaves) is nearer to the far
  /// end of the window by a way that crosses all of the cone.
  double useful(const Window& w, std::int32_t from) {
    const auto k = at(w.apex);
    const Point &left = corner(w.triangle, k + 1), &right = corner(w.triangle, k + 2);
    const Point& r = root(w.root).at;
    const double before = root(w.root).before;
    const Point a = hit(r, w.left, left, right), b = hit(r, w.right, left, right);
    const double to_a = before + distance(r, a), to_b = before + distance(r, b);
    const auto beats = [](double other, double mine) { return other < mine * (1 - kTie); };
    if (beats(label(w.triangle, k + 1).length + distance(left, b), to_b)) return kInf;
    if (beats(label(w.triangle, k + 2).length + distance(right, a), to_a)) return kInf;
    std::size_t back = 0;
    while (triangle(from).neighbour[back] != w.triangle) ++back;
    const Point& third = corner(from, back);
    if (third != r) {
      const double length = label(from, back).length;
      const auto before_root = [&](const Point& end) { return cross(end - third, r - third); };  // > 0: at its left
      if (side(r, w.right, third) <= 0 && before_root(a) > 0 && beats(length + distance(third, a), to_a)) return kInf;
      if (side(r, w.left, third) >= 0 && before_root(b) < 0 && beats(length + distance(third, b), to_b)) return kInf;
    }
    return before + distance_to_segment(r, a, b);
  }

  /// The cone w leaves triangle t by the edge opposite corner k.
  void leave(std::int32_t t, std::size_t k, Window w) {
    w.triangle = triangle(t).neighbour[k];
    if (w.triangle == Mesh::kWall) return;
    w.apex = 0;
    while (triangle(w.triangle).neighbour[at(w.apex)] != t) ++w.apex;
    const double key = useful(w, t);
    if (key == kInf) return;
    push({key, -1, static_cast<std::int32_t>(windows_.size())});
    windows_.push_back(w);
  }

  void enter(std::int32_t index) {
    const Window w = windows_[at(index)];
    const auto k = at(w.apex);
    if (useful(w, triangle(w.triangle).neighbour[k]) == kInf) return;
    entered_.push_back(index);
    const Point &r = root(w.root).at, &apex = corner(w.triangle, k);
    const int sl = side(r, w.left, apex), sr = side(r, w.right, apex);
    const std::size_t to_left = (k + 2) % 3, to_right = (k + 1) % 3;  // the edges left-apex and apex-right
    if (sl <= 0 && sr >= 0) reach(w.triangle, k, w.root);
    if (sl == 0 && sr == 0) return;
    if (sl >= 0) {
      leave(w.triangle, to_right, {w.root, 0, 0, sl == 0 ? Ray{apex} : w.left, w.right});
    } else if (sr <= 0) {
      leave(w.triangle, to_left, {w.root, 0, 0, w.left, sr == 0 ? Ray{apex} : w.right});
    } else {
      leave(w.triangle, to_left, {w.root, 0, 0, w.left, {apex}});
      leave(w.triangle, to_right, {w.root, 0, 0, {apex}, w.right});
    }
  }

  /// Filters the windows once more, now that all labels are known, and sorts the cones by triangles.
  void store() {
    for (const std::int32_t i : entered_) {
      const Window& w = windows_[at(i)];
      if (useful(w, triangle(w.triangle).neighbour[at(w.apex)]) < kInf) placed_.push_back({w.triangle, cone(w)});
    }
    f_.first_.assign(mesh_.triangles().size() + 1, 0);
    for (const Placed& p : placed_) ++f_.first_[at(p.triangle) + 1];
    for (std::size_t t = 1; t < f_.first_.size(); ++t) f_.first_[t] += f_.first_[t - 1];
    std::vector<std::size_t> next(f_.first_.begin(), f_.first_.end() - 1);
    f_.cones_.resize(placed_.size());
    for (const Placed& p : placed_) f_.cones_[next[at(p.triangle)]++] = p.cone;
  }

  GeodesicCones& f_;
  const Mesh& mesh_;
  std::vector<Label> labels_;  // by fan
  std::vector<Window> windows_;
  std::vector<std::int32_t> entered_;
  std::vector<Open> open_;
  std::vector<Placed> placed_;
};

GeodesicCones::GeodesicCones(const Region& free, const Point& anchor, const std::vector<Polyline>& barriers,
                             double tolerance)
    : mesh_(free, barriers), tolerance_(tolerance) {
  if (!(tolerance >= 0)) throw std::invalid_argument("tolerance of a geodesic field must be 0 or more metres");
  Box box;
  for (const Point& p : mesh_.points()) box.add(p);
  if (!box.empty()) { rounding_ = 1e-13 * box.size().norm() + 1e-15 * std::max(box.low.norm(), box.high.norm()); }
  Point start = anchor;
  std::vector<std::int32_t> home;
  if (!finite(anchor) || !place(start, home)) {
    throw std::invalid_argument(
        fmt::format("anchor ({}, {}) is outside free space; move it inside", anchor.x(), anchor.y()));
  }
  roots_.push_back({start, 0, -1, 0});
  ConeSearch(*this).run(home);
  double longest = 0;
  for (const double l : label_) {
    if (l < kInf) longest = std::max(longest, l);
  }
  tie_ = 4 * kTie * longest + 4 * rounding_;

  std::vector<Cone> kept;
  std::vector<std::size_t> first(1, 0);
  for (std::size_t t = 0; t < mesh_.triangles().size(); ++t) {
    const auto triangle = static_cast<std::int32_t>(t);
    const std::vector<Cone> here = needed(facet(triangle), cones(triangle));
    kept.insert(kept.end(), here.begin(), here.end());
    first.push_back(kept.size());
  }
  cones_.swap(kept);
  first_.swap(first);
}

double GeodesicCones::to_corner(std::int32_t triangle, std::size_t k) const {
  return label_[at(fan_[3 * at(triangle) + k])];
}
Point GeodesicCones::corner(std::int32_t triangle, std::size_t k) const {
  return mesh_.points()[at(mesh_.triangles()[at(triangle)].vertex[k % 3])];
}

bool GeodesicCones::meets(const Cone& cone, const Facet& facet) const {
  if (cone.whole) return true;
  const Point& r = root(cone.root).at;
  const auto outside = [&](const Point& ray, int side) {
    return std::all_of(facet.corners().begin(), facet.corners().end(),
                       [&](const Point& p) { return side * cross(ray, p - r) > rounding_; });
  };
  return !outside(cone.left, 1) && !outside(cone.right, -1);
}

/// Is the cone longer than one other, all over its share of `part`?
bool GeodesicCones::beaten(const Cone& cone, const Facet& part, std::span<const Cone> others) const {
  Facet share = part;
  clip(share, cone);
  if (share.empty()) return false;
  const Point middle = share.middle();
  const Cone* best = &cone;
  double least = distance_by(cone, middle);
  const double mine = least;
  for (const Cone& c : others) {
    if (const double d = distance_by(c, middle); d < least && holds(c, middle)) {
      least = d;
      best = &c;
    }
  }
  if (mine - least <= tie_) return false;
  double radius = 0;
  for (const Point& p : share.corners()) radius = std::max(radius, distance(p, middle));
  if (mine - least > 2 * radius + tie_) return true;  // no distance changes faster than places do
  const auto corners = share.corners();
  if (!std::all_of(corners.begin(), corners.end(), [&](const Point& p) { return holds(*best, p); })) return false;
  if (root(best->root).before >= root(cone.root).before) {  // the later root is nearer in a convex set
    return std::all_of(corners.begin(), corners.end(),
                       [&](const Point& p) { return distance_by(cone, p) - distance_by(*best, p) > tie_; });
  }
  // Both distances are convex: mine lies above its tangent plane, the other's bends up from its own by no more than its
  // curvature allows.
  const Point to_mine = middle - root(cone.root).at, to_best = middle - root(best->root).at;
  const double far = to_best.norm() - radius;
  if (!(far > 0)) return false;
  const double tilt = (to_mine.normalized() - to_best.normalized()).norm();
  return mine - least - radius * tilt - radius * radius / (2 * far) > tie_;
}

std::vector<Cone> GeodesicCones::needed(const Facet& part, std::span<const Cone> from) const {
  std::vector<Cone> near, out;
  std::copy_if(from.begin(), from.end(), std::back_inserter(near), [&](const Cone& c) { return meets(c, part); });
  std::copy_if(near.begin(), near.end(), std::back_inserter(out),
               [&](const Cone& c) { return !beaten(c, part, near); });
  return out;
}

bool GeodesicCones::same_way(std::int32_t a, std::int32_t b, const Point& p) const {
  const double to_a = root(a).before + distance(root(a).at, p), to_b = root(b).before + distance(root(b).at, p);
  // Up both ways, the later root first, as long as the way from there to p is straight.
  const auto straight = [&](std::int32_t i, double length) {
    return i >= 0 && length - (root(i).before + distance(root(i).at, p)) <= tie_;
  };
  while (a != b) {
    const bool up_a = a > b;
    std::int32_t& later = up_a ? a : b;
    later = root(later).parent;
    if (!straight(later, up_a ? to_a : to_b)) return false;
  }
  return true;
}

bool GeodesicCones::place(Point& p, std::vector<std::int32_t>& found) const {
  found.clear();
  const std::int32_t home = mesh_.locate(p, tolerance_);
  if (home == Mesh::kWall) return false;
  p = mesh_.nearest_in(home, p);
  mesh_.locate_all(p, found);
  if (std::find(found.begin(), found.end(), home) == found.end()) found.push_back(home);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Mesh::Triangle& t = mesh_.triangles()[at(found[i])];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t n = t.neighbour[k];
      if (n == Mesh::kWall || std::find(found.begin(), found.end(), n) != found.end()) continue;
      if (orientation(corner(found[i], k + 1), corner(found[i], k + 2), p) <= 0) found.push_back(n);
    }
  }
  std::sort(found.begin(), found.end());
  return true;
}

}  // namespace oxturn
