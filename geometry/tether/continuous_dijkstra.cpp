// The search that finds the cones of a geodesic field: see geodesic_cones.hpp. graph_search.hpp would not do: its
// nodes, windows and fans, are made during the search, and a fan is settled a little later than its label says.
#include <algorithm>
#include <limits>
#include <queue>

#include "geometry/predicates.hpp"
#include "geometry/tether/geodesic_cones.hpp"

namespace oxturn {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr std::int32_t kNone = GeodesicCones::kNone;
// Lengths that agree to this factor count as equal: far above the rounding of a sum of distances.
constexpr double kTie = 1e-12;

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
bool clearly_shorter(double length, double than) { return length < than * (1 - kTie); }

/// From a root through the point, or straight away from it.
struct SightRay {
  Point by{0, 0};
  bool away = false;

  Point vector_from(const Point& root) const { return away ? Point(root - by) : Point(by - root); }
  /// On which side of the ray is x? +1: left.
  int side(const Point& root, const Point& x) const {
    return away ? orientation(by, root, x) : orientation(root, by, x);
  }
  /// Where the ray meets the edge from left to right; rounded.
  Point hit(const Point& root, const Point& left, const Point& right) const {
    if (!away && by == left) return left;
    if (!away && by == right) return right;
    const Point d = vector_from(root);
    const double a = std::max(0.0, cross(d, left - root)), b = std::max(0.0, -cross(d, right - root));
    return a + b > 0 ? lerp(left, right, a / (a + b)) : left;
  }
};

/// A cone about to enter `triangle` through the edge opposite its vertex `apex`.
struct Window {
  std::int32_t root, triangle, apex;
  SightRay left, right;
};

/// Vertex k of a triangle.
struct FanVertex {
  std::int32_t triangle;
  std::size_t k;
};

/// The best path known to a fan's corner: straight from a root, through a triangle of the fan.
struct FanLabel {
  double length = kInf;
  std::int32_t root = kNone, triangle = kNone;
  bool settled = false;
};

/// To which side a path turns about a corner.
enum class Turn { left = 1, right = -1, none = 0 };
int sign(Turn turn) { return static_cast<int>(turn); }
/// Walking around a vertex in this direction, the next triangle is across the edge k + step.
std::size_t step(Turn turn) { return turn == Turn::left ? 1 : 2; }

struct Event {
  enum class Kind { enter_window, settle_fan };  // in the order in which those of equal keys are handled
  double key;
  Kind kind;
  std::int32_t index;                     // of the window or fan
  bool operator<(const Event& o) const {  // the queue's top is the least
    return key != o.key ? key > o.key : kind != o.kind ? kind > o.kind : index > o.index;
  }
};

}  // namespace

class ContinuousDijkstra {
 public:
  explicit ContinuousDijkstra(GeodesicCones& cones) : cones_(cones), mesh_(cones.mesh_) {}

  /// From the last of the first roots, which the triangles `home` (ascending) contain.
  void run(const std::vector<std::int32_t>& home) {
    number_fans();
    leave_root(static_cast<std::int32_t>(cones_.roots_.size()) - 1, home);
    while (!events_.empty()) {
      const Event next = events_.top();
      events_.pop();
      if (next.kind == Event::Kind::settle_fan)
        settle(next.index);
      else
        enter(next.index);
    }
    cones_.label_.clear();
    for (const FanLabel& l : labels_) cones_.label_.push_back(l.length);
    store();
  }

 private:
  struct PlacedCone {
    std::int32_t triangle;
    Cone cone;
  };

  const GeodesicCones::Root& root(std::int32_t i) const { return cones_.root(i); }
  const Point& point(const FanVertex& v) const { return mesh_.vertex(v.triangle, v.k); }
  std::int32_t point_number(const FanVertex& v) const { return mesh_.triangle(v.triangle).vertex[v.k]; }
  std::int32_t& fan(const FanVertex& v) const { return cones_.fan_[3 * at(v.triangle) + v.k]; }
  FanLabel& label(std::int32_t t, std::size_t k) { return labels_[at(fan({t, k % 3}))]; }
  /// The same point in the next triangle of its fan; that is Mesh::kWall after the last one.
  FanVertex around(const FanVertex& v, Turn turn) const {
    const std::int32_t next = mesh_.triangle(v.triangle).neighbour[(v.k + step(turn)) % 3];
    return {next, next == Mesh::kWall ? 0 : mesh_.index_in(next, point_number(v))};
  }

  void number_fans() {
    cones_.fan_.assign(3 * mesh_.triangles().size(), kNone);
    std::int32_t count = 0;
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh_.triangles().size()); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const FanVertex first{t, k};
        if (fan(first) != kNone) continue;
        fan(first) = count;
        for (const Turn turn : {Turn::left, Turn::right})
          for (FanVertex v = around(first, turn); v.triangle != Mesh::kWall && fan(v) == kNone; v = around(v, turn))
            fan(v) = count;
        ++count;
      }
    }
    labels_.resize(at(count));
  }

  void leave_root(std::int32_t first, const std::vector<std::int32_t>& home) {
    const Point& from = root(first).at;
    for (const std::int32_t t : home) {
      placed_.push_back({t, {first, true, {0, 0}, {0, 0}}});
      for (std::size_t k = 0; k < 3; ++k) reach({t, k}, first);
    }
    for (const std::int32_t t : home) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t n = mesh_.triangle(t).neighbour[k];
        if (n == Mesh::kWall || std::binary_search(home.begin(), home.end(), n)) continue;
        const Point &right = mesh_.vertex(t, k + 1), &left = mesh_.vertex(t, k + 2);
        if (orientation(right, left, from) > 0) leave(t, k, {first, 0, 0, {left}, {right}});
      }
    }
  }

  /// Walks around the fan of v to the first triangle in which it is hidden from `from`, which sees the point through
  /// v's triangle. False if there is none.
  bool first_hidden(const Point& from, FanVertex& v, Turn turn) const {
    const std::int32_t start = v.triangle;
    while (true) {
      if (v.triangle != start &&
          sign(turn) * orientation(from, point(v), mesh_.vertex(v.triangle, v.k + 3 - step(turn))) > 0)
        return true;
      v = around(v, turn);
      if (v.triangle == Mesh::kWall || v.triangle == start) return false;
    }
  }
  /// To which side can a path from `from`, through v's triangle, turn about v?
  Turn turning_side(const Point& from, const FanVertex& v) const {
    if (!mesh_.is_reflex(point_number(v))) return Turn::none;
    for (const Turn turn : {Turn::left, Turn::right}) {
      FanVertex w = v;
      if (first_hidden(from, w, turn)) return turn;
    }
    return Turn::none;
  }

  /// Root r sees v through v's triangle.
  void reach(const FanVertex& v, std::int32_t r) {
    FanLabel& l = labels_[at(fan(v))];
    if (l.settled) return;
    const double length = root(r).before + distance(root(r).at, point(v));
    if (length > l.length * (1 + kTie)) return;
    const bool equal = length >= l.length * (1 - kTie);
    if (equal && !better_of_equal(l, v, r)) {
      l.length = std::min(l.length, length);
      return;
    }
    l = {std::min(l.length, length), r, v.triangle, false};
    // Settled a little late, when all equal paths are known.
    if (!equal && mesh_.is_reflex(point_number(v)))
      events_.push({length * (1 + 4 * kTie), Event::Kind::settle_fan, fan(v)});
  }
  /// Of two equal paths to a corner, the one that needs the corner less is better: then the area beyond the corner is
  /// connected with the area that this path passes. Otherwise it would be separated from both.
  bool better_of_equal(const FanLabel& old, const FanVertex& v, std::int32_t r) const {
    const Point &was = root(old.root).at, &is = root(r).at;
    const Turn old_side = turning_side(was, {old.triangle, mesh_.index_in(old.triangle, point_number(v))});
    const Turn new_side = turning_side(is, v);
    if (old_side == Turn::none) return false;
    if (new_side == Turn::none) return true;
    if (old_side != new_side) return false;
    const int turn = sign(new_side) * orientation(point(v), was, is);
    return turn != 0 ? turn > 0 : root(r).corners < root(old.root).corners;
  }

  void settle(std::int32_t number) {
    FanLabel& l = labels_[at(number)];
    if (l.settled) return;
    l.settled = true;
    const std::int32_t from = l.root;
    FanVertex corner{l.triangle, 0};
    while (fan(corner) != number) ++corner.k;
    const Point predecessor = root(from).at;
    std::int32_t self = kNone;
    for (const Turn turn : {Turn::left, Turn::right}) {
      FanVertex hidden = corner;
      if (!first_hidden(predecessor, hidden, turn)) continue;
      if (self == kNone) {
        self = static_cast<std::int32_t>(cones_.roots_.size());
        cones_.roots_.push_back({point(corner), l.length, from, root(from).corners + 1});
      }
      open_behind(hidden, turn, predecessor, self);
    }
  }
  /// The new root `self` sees its fan from v on, as far as that is hidden from its predecessor.
  void open_behind(FanVertex v, Turn turn, const Point& predecessor, std::int32_t self) {
    for (bool first = true; v.triangle != Mesh::kWall; first = false, v = around(v, turn)) {
      const FanVertex far{v.triangle, (v.k + 3 - step(turn)) % 3}, near{v.triangle, (v.k + step(turn)) % 3};
      SightRay limit{point(near)};
      if (first && sign(turn) * orientation(predecessor, point(v), point(near)) < 0)
        limit = {predecessor, true};
      else
        reach(near, self);
      reach(far, self);
      const SightRay edge{point(far)};
      const Window w = turn == Turn::left ? Window{self, 0, 0, edge, limit} : Window{self, 0, 0, limit, edge};
      placed_.push_back({v.triangle, cone(w)});
      leave(v.triangle, v.k, w);
    }
  }

  Cone cone(const Window& w) const {
    const auto unit = [](const Point& d) { return Point(d / d.norm()); };
    const Point& r = root(w.root).at;
    return {w.root, false, unit(w.left.vector_from(r)), unit(w.right.vector_from(r))};
  }

  /// Length of the path to the nearest point of the interval by which the window enters its triangle from triangle
  /// `from`; infinity if the cone is shortest nowhere. That is so if a labelled vertex beside the interval, or the
  /// vertex of `from` opposite it, is nearer to the interval's far end by a path that crosses the whole cone.
  double useful_from(const Window& w, std::int32_t from) {
    const auto k = at(w.apex);
    const Point &left = mesh_.vertex(w.triangle, k + 1), &right = mesh_.vertex(w.triangle, k + 2);
    const Point& r = root(w.root).at;
    const double before = root(w.root).before;
    const Point a = w.left.hit(r, left, right), b = w.right.hit(r, left, right);
    const double to_a = before + distance(r, a), to_b = before + distance(r, b);
    if (clearly_shorter(label(w.triangle, k + 1).length + distance(left, b), to_b)) return kInf;
    if (clearly_shorter(label(w.triangle, k + 2).length + distance(right, a), to_a)) return kInf;
    const std::size_t back = mesh_.edge_towards(from, w.triangle);
    const Point& third = mesh_.vertex(from, back);
    if (third != r) {
      const double length = label(from, back).length;
      const auto passes_root = [&](const Point& end) { return cross(end - third, r - third); };  // > 0: on its left
      if (w.right.side(r, third) <= 0 && passes_root(a) > 0 && clearly_shorter(length + distance(third, a), to_a))
        return kInf;
      if (w.left.side(r, third) >= 0 && passes_root(b) < 0 && clearly_shorter(length + distance(third, b), to_b))
        return kInf;
    }
    return before + distance_to_segment(r, a, b);
  }

  /// The cone w leaves triangle t by edge k.
  void leave(std::int32_t t, std::size_t k, Window w) {
    w.triangle = mesh_.triangle(t).neighbour[k];
    if (w.triangle == Mesh::kWall) return;
    w.apex = static_cast<std::int32_t>(mesh_.edge_towards(w.triangle, t));
    const double key = useful_from(w, t);
    if (key == kInf) return;
    events_.push({key, Event::Kind::enter_window, static_cast<std::int32_t>(windows_.size())});
    windows_.push_back(w);
  }

  void enter(std::int32_t index) {
    const Window w = windows_[at(index)];
    const auto k = at(w.apex);
    if (useful_from(w, mesh_.triangle(w.triangle).neighbour[k]) == kInf) return;
    entered_.push_back(index);
    const Point &r = root(w.root).at, &apex = mesh_.vertex(w.triangle, k);
    const int sl = w.left.side(r, apex), sr = w.right.side(r, apex);
    const std::size_t to_left = (k + 2) % 3, to_right = (k + 1) % 3;  // the edges left-apex and apex-right
    if (sl <= 0 && sr >= 0) reach({w.triangle, k}, w.root);
    if (sl == 0 && sr == 0) return;
    if (sl >= 0) {
      leave(w.triangle, to_right, {w.root, 0, 0, sl == 0 ? SightRay{apex} : w.left, w.right});
    } else if (sr <= 0) {
      leave(w.triangle, to_left, {w.root, 0, 0, w.left, sr == 0 ? SightRay{apex} : w.right});
    } else {
      leave(w.triangle, to_left, {w.root, 0, 0, w.left, {apex}});
      leave(w.triangle, to_right, {w.root, 0, 0, {apex}, w.right});
    }
  }

  /// Prunes the windows once more, now that all labels are final, and sorts the cones by triangles.
  void store() {
    for (const std::int32_t i : entered_) {
      const Window& w = windows_[at(i)];
      if (useful_from(w, mesh_.triangle(w.triangle).neighbour[at(w.apex)]) < kInf)
        placed_.push_back({w.triangle, cone(w)});
    }
    std::vector<std::size_t>& first = cones_.first_;
    first.assign(mesh_.triangles().size() + 1, 0);
    for (const PlacedCone& p : placed_) ++first[at(p.triangle) + 1];
    for (std::size_t t = 1; t < first.size(); ++t) first[t] += first[t - 1];
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    cones_.cones_.resize(placed_.size());
    for (const PlacedCone& p : placed_) cones_.cones_[next[at(p.triangle)]++] = p.cone;
  }

  GeodesicCones& cones_;
  const Mesh& mesh_;
  std::vector<FanLabel> labels_;  // by fan
  std::vector<Window> windows_;
  std::vector<std::int32_t> entered_;  // windows
  std::priority_queue<Event> events_;
  std::vector<PlacedCone> placed_;
};

void GeodesicCones::search(const std::vector<std::int32_t>& home) { ContinuousDijkstra(*this).run(home); }

}  // namespace oxturn
