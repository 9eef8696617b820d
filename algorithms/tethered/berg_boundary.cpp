#include "algorithms/tethered/berg_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include "algorithms/tethered/berg_sweep.hpp"
#include "base/math.hpp"
#include "base/sorting.hpp"
#include "geometry/paths/visibility.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

/// p itself if it is free and not on a wall; else the point with the most room among some points `by` metres away.
Point off_the_wall(const Point& p, const EdgeIndex& walls, double by) {
  if (walls.contains(p) && !walls.nearest(p, by)) return p;
  constexpr int kTries = 32;
  Point best = p;
  double widest = -1;
  for (int k = 0; k < kTries; ++k) {
    const double angle = 2 * kPi * k / kTries;
    const Point q = p + 2 * by * Point(math::cos(angle), math::sin(angle));
    if (!walls.contains(q)) continue;
    const auto wall = walls.nearest(q, 4 * by);
    if (const double room = wall ? wall->distance : 4 * by; room > widest) {
      widest = room;
      best = q;
    }
  }
  return best;
}

bool in_lower_half(const Point& eye, const Point& p) {
  return p.y() < eye.y() || (p.y() == eye.y() && p.x() < eye.x());
}

double angle_between(const Point& from, const Point& to) { return math::atan2(cross(from, to), from.dot(to)); }

/// 1 for left, -1 for right: turns orientations so that both sides can be treated alike.
int sign(HiddenSide side) { return side == HiddenSide::left ? 1 : -1; }

/// The side of the ray from the eye to the corner on which the corner hides something.
HiddenSide hidden_side(const Point& eye, const BergSight::Corner& c) {
  if (orientation(c.previous, c.at, c.next) >= 0) return HiddenSide::none;  // not a convex corner of an obstacle
  const int previous = orientation(eye, c.at, c.previous), next = orientation(eye, c.at, c.next);
  if (next < 0 && previous <= 0) return HiddenSide::right;
  if (previous > 0 && next >= 0) return HiddenSide::left;
  return HiddenSide::none;
}

/// Is p surely beyond an edge of the star-shaped polygon that the eye sees? Those of its edges that do not meet the eye
/// are parts of walls, but for rounding.
bool is_behind(const Ring& view, const Point& eye, const Point& p, double tolerance) {
  const Point d = p - eye;
  const double off = tolerance * d.norm();
  for (std::size_t i = 0; i < view.size(); ++i) {
    const Point &a = view[i], &b = view[i + 1 < view.size() ? i + 1 : 0];
    if (!(cross(a - eye, d) > off && cross(d, b - eye) > off && cross(a - eye, b - eye) > 0)) continue;
    return cross(b - a, p - a) < -tolerance * (b - a).norm();
  }
  return false;
}

}  // namespace

/// What a node sees: a polygon, and its vertices sorted.
struct BergBoundary::View {
  Ring polygon, vertices;
  explicit View(Ring seen) : polygon(std::move(seen)), vertices(polygon) { std::ranges::sort(vertices, before); }
};

/// Dijkstra's search over corners: each corner is looked at by the node that reaches it with the least tether.
class BergBoundary::NodeSearch {
 public:
  NodeSearch(BergBoundary& boundary, Mesh mesh, double longest)
      : b_(boundary),
        longest_(longest),
        visibility_(std::move(mesh)),
        corners_at_(b_.sight_.corners_at_points(visibility_.mesh())),
        looks_(b_.sight_.corners().size()) {}

  void run() {
    look_round(0);
    while (!open_.empty()) {
      const auto [length, k] = open_.top();
      open_.pop();
      Look& look = looks_[k];
      if (look.done || length > look.length) continue;
      look.done = true;
      const BergSight::Corner& corner = b_.sight_.corners()[k];
      const HiddenSide side = hidden_side(b_.nodes_[look.node].at, corner);
      if (side == HiddenSide::none) continue;
      b_.add_node(corner, side, look.node, length);
      look_round(b_.nodes_.size() - 1);
    }
  }

 private:
  struct Look {  // the best one at a corner
    double length = std::numeric_limits<double>::infinity();
    std::size_t node = 0;
    bool done = false;
  };
  using Candidate = std::pair<double, std::size_t>;  // length, corner

  /// Looks at all corners in sight and in the node's sector.
  void look_round(std::size_t index) {
    BergNode& node = b_.nodes_[index];
    const View view(polygon_seen_by(node));
    b_.find_reach(node, view.polygon);
    node.range = SightRange(node.at, node.begin, node.width, view.polygon, b_.tolerance_);
    candidates_ = corners_at_.back();
    for (const std::int32_t point : near_) {
      const auto& here = corners_at_[static_cast<std::size_t>(point)];
      candidates_.insert(candidates_.end(), here.begin(), here.end());
    }
    sort_unique(candidates_);
    for (const std::uint32_t k : candidates_) {
      const BergSight::Corner& corner = b_.sight_.corners()[k];
      if (looks_[k].done || !BergSight::open_towards(corner, node.at)) continue;
      const double length = node.before + distance(node.at, corner.at);
      // Of two paths that differ by rounding alone the straighter one, which was found first, stays.
      if (length > longest_ || length >= looks_[k].length - b_.tolerance_ * 1e-3) continue;
      if (!b_.in_sector(node, corner.at) || !b_.sees_corner(node.at, corner, view)) continue;
      looks_[k] = {length, index};
      open_.push({length, k});
    }
    b_.add_dividers(index, candidates_, view, longest_);
  }

  /// What the node sees in its sector and a little beside it: more than rounding can add to the sector.
  Ring polygon_seen_by(const BergNode& node) {
    constexpr double kBeside = 0.05, kWidest = 3;  // radians
    if (node.width + 2 * kBeside > kWidest) return visibility_.from(node.at, b_.tolerance_, &near_);
    const double size = distance(node.at, node.hidden);
    const auto towards = [&](double angle) { return Point(size * Point(math::cos(angle), math::sin(angle))); };
    return visibility_.from(node.at, {towards(node.begin - kBeside), towards(node.begin + node.width + kBeside)},
                            b_.tolerance_, &near_);
  }

  BergBoundary& b_;
  double longest_;
  Visibility visibility_;
  std::vector<std::vector<std::uint32_t>> corners_at_;  // by point of the mesh
  std::vector<std::int32_t> near_;                      // points of the mesh, of one look round
  std::vector<std::uint32_t> candidates_;               // corners, likewise
  std::vector<Look> looks_;                             // by corner
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> open_;
};

BergBoundary::BergBoundary(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers,
                           const Point& anchor, double longest, double tolerance)
    : tolerance_(tolerance), sight_(free, walls, barriers, tolerance) {
  nodes_.emplace_back().at = off_the_wall(anchor, walls, tolerance);
  NodeSearch(*this, Mesh(free, barriers), longest).run();
  add_children_events();
  sort_events();
  number_dividers();
  drop_repeated_dividers();
}

/// Corners that are no vertices of the view may be seen along a single line, and those that share a point are not seen
/// from everywhere where that is.
bool BergBoundary::sees_corner(const Point& eye, const BergSight::Corner& corner, const View& view) const {
  if (!corner.shares_point && std::ranges::binary_search(view.vertices, corner.at, before)) return true;
  return !is_behind(view.polygon, eye, corner.at, tolerance_) && sight_.sees(eye, corner.at);
}

/// Closed, exact.
bool BergBoundary::in_sector(const BergNode& node, const Point& p) const {
  if (!node.parent) return true;
  const Point& parent = nodes_[*node.parent].at;
  const int s = sign(node.side);
  return s * orientation(parent, node.at, p) >= 0 && s * orientation(node.at, node.hidden, p) <= 0;
}

/// In the sector, or outside of it by no more than the tolerance.
bool BergBoundary::nearly_in_sector(const BergNode& node, const Point& p) const {
  if (!node.parent) return true;
  const Point along = (node.at - nodes_[*node.parent].at).normalized();
  const Point edge = (node.hidden - node.at).normalized(), d = p - node.at;
  const int s = sign(node.side);
  return s * cross(along, d) >= -tolerance_ && s * cross(edge, d) <= tolerance_;
}

void BergBoundary::add_node(const BergSight::Corner& corner, HiddenSide side, std::size_t parent, double before) {
  const bool on_right = side == HiddenSide::right;
  BergNode node;
  node.at = corner.at;
  node.before = before;
  node.parent = parent;
  node.side = side;
  node.hidden = on_right ? corner.next : corner.previous;
  const Point along = corner.at - nodes_[parent].at, edge = node.hidden - corner.at;
  const Point right = on_right ? edge : along;
  node.begin = math::atan2(right.y(), right.x());
  node.width = std::abs(angle_between(edge, along));
  nodes_.push_back(node);
}

void BergBoundary::find_reach(BergNode& node, const Ring& seen) const {
  // A point on each side of the sector.
  const Point along = node.parent ? Point(2 * node.at - nodes_[*node.parent].at) : node.at;
  const bool on_left = node.side == HiddenSide::left;
  const Point &right = on_left ? along : node.hidden, &left = on_left ? node.hidden : along;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Point &a = seen[i], &b = seen[(i + 1) % seen.size()];
    if (node.parent) {
      if (distance(node.at, a) <= tolerance_ || distance(node.at, b) <= tolerance_) continue;  // a side of what is seen
      const bool spans = cross(a - node.at, right - node.at) >= 0 && cross(left - node.at, b - node.at) >= 0 &&
                         cross(a - node.at, b - node.at) > 0;
      if (!nearly_in_sector(node, a) && !nearly_in_sector(node, b) && !spans) continue;
    }
    node.reach = std::max({node.reach, distance(node.at, a), distance(node.at, b)});
  }
}

void BergBoundary::add_children_events() {
  for (std::size_t v = 1; v < nodes_.size(); ++v) {
    const BergNode& node = nodes_[v];
    events_[*node.parent].push_back({node.at, false, v, node.side, distance(nodes_[*node.parent].at, node.at)});
  }
  for (std::size_t v = 0; v < nodes_.size(); ++v)  // also what is seen along a single line
    for (const Event& e : events_[v]) nodes_[v].reach = std::max(nodes_[v].reach, e.distance);
}

void BergBoundary::add_dividers(std::size_t v, const std::vector<std::uint32_t>& corners, const View& view,
                                double longest) {
  const BergNode& node = nodes_[v];
  events_.resize(std::max(events_.size(), v + 1));
  /// `sees`: is what must be seen for `at` to count?
  const auto offer = [&](const Point& at, HiddenSide side, auto sees) {
    const double rho = distance(node.at, at);
    if (rho == 0 || node.before + rho >= longest || !sees()) return;
    events_[v].push_back({at, true, dividers_.size(), side, rho});
    dividers_.push_back({at, v, node.before + rho});
  };
  const auto offer_foot = [&](const Point& a, const Point& b) {
    const Point foot = nearest_on_segment(node.at, a, b);
    const double rho = distance(node.at, foot);
    if (rho > 0 && nearly_in_sector(node, foot))
      offer(foot, HiddenSide::none,
            [&] { return sight_.sees(node.at, lerp(foot, node.at, std::min(1.0, tolerance_ / rho))); });
  };
  for (const std::uint32_t k : corners) {
    const BergSight::Corner& c = sight_.corners()[k];
    // Does the wall come nearer to the node from the corner towards its neighbour?
    const bool nearer_at_next = (c.next - c.at).dot(node.at - c.at) > 0;
    const bool nearer_at_previous = (c.previous - c.at).dot(node.at - c.at) > 0;
    if (!nearer_at_next && !nearer_at_previous && in_sector(node, c.at) && BergSight::open_towards(c, node.at))
      offer(c.at, hidden_side(node.at, c), [&] { return sees_corner(node.at, c, view); });
    if (nearer_at_next && (c.at - c.next).dot(node.at - c.next) > 0) offer_foot(c.at, c.next);
  }
}

/// The order of two events that lie on one ray from the node. The boundary is walked counter-clockwise, that is from
/// the right of the ray to its left:
///
///         left        right      1. Corners that hide something on the right, from near to far: the boundary passes
///         :::::|::::::::            c1, then the region hidden behind c1, then c2, and so on. The divider at such a
///         :::::c2#######            corner comes before the corner's child: it separates what lies in front of the
///         :::::|::::::::            obstacle from the hidden region.
///         #####c3:::::::         2. Corners and feet of perpendiculars that hide nothing.
///              c1#######         3. Corners that hide something on the left, from far to near, each with its child
///              |                    before its divider: the mirror image of 1.
///              node
///                                #: obstacles; ":": hidden regions, on the left behind c3, on the right behind c1, c2
bool BergBoundary::earlier_in_line(const Event& a, const Event& b) {
  if (a.side != b.side) return a.side < b.side;
  switch (a.side) {
    case HiddenSide::right:
      return std::tuple(a.distance, !a.is_divider, a.index) < std::tuple(b.distance, !b.is_divider, b.index);
    case HiddenSide::none:
      break;
    case HiddenSide::left:
      return std::tuple(-a.distance, a.is_divider, a.index) < std::tuple(-b.distance, b.is_divider, b.index);
  }
  return a.index < b.index;
}

void BergBoundary::sort_events() {
  for (std::size_t v = 0; v < nodes_.size(); ++v) {
    const BergNode& node = nodes_[v];
    std::vector<Event>& events = events_[v];
    std::sort(events.begin(), events.end(), [&](const Event& a, const Event& b) {
      if (!node.parent)  // the whole circle, from the east on
        if (const bool la = in_lower_half(node.at, a.at), lb = in_lower_half(node.at, b.at); la != lb) return lb;
      if (const int turn = orientation(node.at, a.at, b.at); turn != 0) return turn > 0;
      return earlier_in_line(a, b);
    });
    const Point right(math::cos(node.begin), math::sin(node.begin));
    double last = 0;
    for (Event& e : events) {
      double angle = angle_between(right, e.at - node.at);
      if (!node.parent && angle < 0) angle += 2 * kPi;
      last = e.angle = std::clamp(angle, last, std::max(last, node.width));
      nodes_[v].range.add(e.angle, e.distance);  // also what is seen along a single line
    }
  }
}

/// Numbers dividers in the order in which they are met round the boundary.
void BergBoundary::number_dividers() {
  struct Visit {
    std::size_t node, next_event = 0;
  };
  std::vector<BergDivider> ordered;
  std::vector<Visit> stack{{0}};
  while (!stack.empty()) {
    Visit& visit = stack.back();
    std::vector<Event>& events = events_[visit.node];
    if (visit.next_event == events.size()) {
      stack.pop_back();
      continue;
    }
    Event& e = events[visit.next_event++];
    if (e.is_divider) {
      ordered.push_back(dividers_[e.index]);
      e.index = ordered.size() - 1;
    } else {
      stack.push_back({e.index});
    }
  }
  dividers_ = std::move(ordered);
}

/// A foot on the common side of two sectors is found by both nodes, one on a barrier from both ends: the second is
/// dropped.
void BergBoundary::drop_repeated_dividers() {
  std::vector<std::optional<std::size_t>> number(dividers_.size());  // nullopt: dropped
  std::vector<BergDivider> kept;
  for (std::size_t i = 0; i < dividers_.size(); ++i) {
    if (!kept.empty() && distance(kept.back().at, dividers_[i].at) <= tolerance_) continue;
    number[i] = kept.size();
    kept.push_back(dividers_[i]);
  }
  for (std::vector<Event>& events : events_) {
    std::erase_if(events, [&](const Event& e) { return e.is_divider && !number[e.index]; });
    for (Event& e : events)
      if (e.is_divider) e.index = *number[e.index];
  }
  dividers_ = std::move(kept);
}

double BergBoundary::farthest() const {
  double most = 0;
  for (const BergNode& node : nodes_) most = std::max(most, node.before + node.reach);
  return most;
}

std::vector<BergBoundary::Piece> BergBoundary::at(double length, double spacing) const {
  return BergSweep(*this, {.lengths = {.step = length, .count = 1}, .spacing = spacing}).next();
}

}  // namespace oxturn
