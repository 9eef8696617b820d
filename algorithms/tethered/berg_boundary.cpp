#include "algorithms/tethered/berg_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>

#include "geometry/predicates.hpp"
#include "geometry/paths/visibility.hpp"

namespace oxturn {
namespace {

/// Free space next to p: p itself, or the best of a few places `by` away.
Point off_the_wall(const Point& p, const EdgeIndex& walls, double by) {
  if (walls.contains(p) && !walls.nearest(p, by)) return p;
  constexpr int kTries = 32;
  Point best = p;
  double widest = -1;
  for (int k = 0; k < kTries; ++k) {
    const double angle = 2 * kPi * k / kTries;
    const Point q = p + 2 * by * Point(std::cos(angle), std::sin(angle));
    if (!walls.contains(q)) continue;
    const auto wall = walls.nearest(q, 4 * by);
    if (const double room = wall ? wall->distance : 4 * by; room > widest) {
      widest = room;
      best = q;
    }
  }
  return best;
}

bool lower_half(const Point& eye, const Point& p) { return p.y() < eye.y() || (p.y() == eye.y() && p.x() < eye.x()); }

double angle_between(const Point& from, const Point& to) { return std::atan2(cross(from, to), from.dot(to)); }

}  // namespace

BergBoundary::BergBoundary(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers,
                           const Point& anchor, double longest, double tolerance)
    : walls_(walls), tolerance_(tolerance) {
  for_each_ring(free, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) corners_.push_back({ring[i], ring[(i + n - 1) % n], ring[(i + 1) % n]});
  });
  for (const Polyline& barrier : barriers) add_barrier(barrier.front(), barrier.back());
  BergNode first;
  first.at = off_the_wall(anchor, walls, tolerance);
  nodes_.push_back(first);
  find_nodes(longest);
  find_reach(free);
  find_dividers(longest);
  sort_events();
  drop_repeated_dividers();
}

void BergBoundary::add_barrier(const Point& from, const Point& to) {
  const Point a = add_barrier_end(from, to), b = add_barrier_end(to, from);
  barriers_.push_back({a, b});
}

/// Splits the corner there in two, or makes two on the wall. Returns where the barrier is to end for tests of sight.
Point BergBoundary::add_barrier_end(const Point& at, const Point& other) {
  const auto split = [&](std::size_t k) {
    Corner second = corners_[k];
    corners_[k].next = second.previous = other;
    corners_[k].at_barrier = second.at_barrier = true;
    corners_.push_back(second);
  };
  for (std::size_t k = 0; k < corners_.size(); ++k)
    if (corners_[k].at == at && in_wedge(corners_[k], other)) {
      const Corner& c = corners_[k];
      barrier_ends_.push_back({at, other, c.previous, c.next});
      split(k);
      return at;
    }
  const auto wall = walls_.nearest(at);
  if (!wall) return at;
  const EdgeIndex::Edge& edge = walls_.edges()[wall->edge];
  corners_.push_back({at, edge.a, edge.b, false});
  split(corners_.size() - 1);
  return at + 2 * tolerance_ * (at - other).normalized();
}

/// Closed; a place at the corner itself is in no wedge.
bool BergBoundary::in_wedge(const Corner& c, const Point& p) {
  if (p == c.at) return false;
  const bool left_of_next = orientation(c.at, c.next, p) >= 0,
             right_of_previous = orientation(c.at, c.previous, p) <= 0;
  const int turn = orientation(c.at, c.next, c.previous);
  const bool wide = turn < 0 || (turn == 0 && (c.next - c.at).dot(c.previous - c.at) > 0);  // more than half a turn
  return wide ? left_of_next || right_of_previous : left_of_next && right_of_previous;
}

/// Exact; touching a corner does not block, unless the way leads between it and a barrier that ends there.
bool BergBoundary::sees(const Point& eye, const Point& p) const {
  if (!walls_.contains(eye, p)) return false;
  for (const Barrier& b : barriers_)
    if (crossing(eye, p, b.from, b.to) == Crossing::proper) return false;
  for (const BarrierEnd& end : barrier_ends_) {
    if (end.at == eye || end.at == p || !on_segment(end.at, eye, p)) continue;
    const int previous = orientation(eye, p, end.previous), next = orientation(eye, p, end.next);
    const int wall = previous != 0 ? previous : next != 0 ? next : (end.next - end.at).dot(p - eye) > 0 ? -1 : 1;
    if (orientation(eye, p, end.other) * wall < 0) return false;
  }
  return true;
}

/// Closed, exact.
bool BergBoundary::in_sector(const BergNode& node, const Point& p) const {
  if (node.parent < 0) return true;
  const Point& parent = nodes_[static_cast<std::size_t>(node.parent)].at;
  return node.side * orientation(parent, node.at, p) >= 0 && node.side * orientation(node.at, node.hidden, p) <= 0;
}

/// Outside by no more than the tolerance.
bool BergBoundary::about_in_sector(const BergNode& node, const Point& p) const {
  if (node.parent < 0) return true;
  const Point along = (node.at - nodes_[static_cast<std::size_t>(node.parent)].at).normalized();
  const Point edge = (node.hidden - node.at).normalized(), d = p - node.at;
  return node.side * cross(along, d) >= -tolerance_ && node.side * cross(edge, d) <= tolerance_;
}

/// On which side of the ray eye -> corner the corner hides something: -1 right, +1 left, 0 nothing.
int BergBoundary::hidden_side(const Point& eye, const Corner& c) const {
  if (orientation(c.previous, c.at, c.next) >= 0) return 0;  // not a convex corner of an obstacle
  const int previous = orientation(eye, c.at, c.previous), next = orientation(eye, c.at, c.next);
  if (next < 0 && previous <= 0) return -1;
  if (previous > 0 && next >= 0) return 1;
  return 0;
}

void BergBoundary::find_nodes(double longest) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  struct First {  // to look at a corner
    double length = kNever;
    int node = -1;
    bool done = false;
  };
  std::vector<First> first(corners_.size());
  using Open = std::tuple<double, std::size_t>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto look_round = [&](int index) {
    const BergNode node = nodes_[static_cast<std::size_t>(index)];
    for (std::size_t k = 0; k < corners_.size(); ++k) {
      const Point& c = corners_[k].at;
      if (first[k].done || (corners_[k].at_barrier && !in_wedge(corners_[k], node.at))) continue;
      const double length = node.before + distance(node.at, c);
      // Of two ways equal but for rounding the straighter one, which was found first, stays.
      if (length > longest || length >= first[k].length - tolerance_ * 1e-3) continue;
      if (!in_sector(node, c) || !sees(node.at, c)) continue;
      first[k].length = length;
      first[k].node = index;
      open.push({length, k});
    }
  };
  look_round(0);
  while (!open.empty()) {
    const auto [length, k] = open.top();
    open.pop();
    if (first[k].done || length > first[k].length) continue;
    first[k].done = true;
    const Corner& corner = corners_[k];
    const Point parent = nodes_[static_cast<std::size_t>(first[k].node)].at;
    const int side = hidden_side(parent, corner);
    if (side == 0) continue;
    BergNode node;
    node.at = corner.at;
    node.before = length;
    node.parent = first[k].node;
    node.side = side;
    node.hidden = side < 0 ? corner.next : corner.previous;
    const Point along = corner.at - parent, edge = node.hidden - corner.at;
    const Point right = side < 0 ? edge : along;
    node.begin = std::atan2(right.y(), right.x());
    node.width = std::abs(angle_between(edge, along));
    nodes_.push_back(node);
    look_round(static_cast<int>(nodes_.size()) - 1);
  }
}

void BergBoundary::find_reach(const Region& free) {
  const Visibility visibility(free);
  for (BergNode& node : nodes_) {
    const Ring seen = visibility.from(node.at, tolerance_);
    // Ends of the sector, as places on its sides.
    const Point along =
        node.parent < 0 ? node.at : Point(2 * node.at - nodes_[static_cast<std::size_t>(node.parent)].at);
    const Point &right = node.side < 0 ? node.hidden : along, &left = node.side < 0 ? along : node.hidden;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      const Point &a = seen[i], &b = seen[(i + 1) % seen.size()];
      if (node.parent >= 0) {
        const bool overlaps = about_in_sector(node, a) || about_in_sector(node, b) ||
                              (cross(a - node.at, right - node.at) >= 0 && cross(left - node.at, b - node.at) >= 0 &&
                               cross(a - node.at, b - node.at) > 0);
        if (!overlaps) continue;
      }
      node.reach = std::max({node.reach, distance(node.at, a), distance(node.at, b)});
    }
  }
}

void BergBoundary::find_dividers(double longest) {
  events_.resize(nodes_.size());
  for (std::size_t v = 1; v < nodes_.size(); ++v) {
    const BergNode& node = nodes_[v];
    const double d = distance(nodes_[static_cast<std::size_t>(node.parent)].at, node.at);
    Event event;
    event.at = node.at;
    event.index = static_cast<int>(v);
    event.group = node.side < 0 ? 0 : 2;
    event.key = node.side < 0 ? d : -d;
    event.rank = node.side < 0 ? 1 : 0;
    events_[static_cast<std::size_t>(node.parent)].push_back(event);
  }
  for (std::size_t v = 0; v < nodes_.size(); ++v) {
    const BergNode& node = nodes_[v];
    const auto offer = [&](const Point& at, const Point& seen_at, int side) {
      const double rho = distance(node.at, at);
      if (rho == 0 || node.before + rho >= longest || !sees(node.at, seen_at)) return;
      Event event;
      event.at = at;
      event.divides = true;
      event.index = static_cast<int>(dividers_.size());
      event.group = 1 + side;
      event.key = -side * rho;
      event.rank = side > 0 ? 1 : 0;
      events_[v].push_back(event);
      dividers_.push_back({at, static_cast<int>(v), node.before + rho});
    };
    const auto offer_foot = [&](const Point& a, const Point& b) {
      const Point foot = nearest_on_segment(node.at, a, b);
      const double rho = distance(node.at, foot);
      if (rho > 0 && about_in_sector(node, foot)) offer(foot, lerp(foot, node.at, std::min(1.0, tolerance_ / rho)), 0);
    };
    for (const Corner& c : corners_) {
      const bool from_next = (c.next - c.at).dot(node.at - c.at) > 0;  // the wall comes closer that way
      const bool from_previous = (c.previous - c.at).dot(node.at - c.at) > 0;
      if (!from_next && !from_previous && in_sector(node, c.at) && (!c.at_barrier || in_wedge(c, node.at)))
        offer(c.at, c.at, hidden_side(node.at, c));
      if (from_next && (c.at - c.next).dot(node.at - c.next) > 0) offer_foot(c.at, c.next);
    }
  }
}

void BergBoundary::sort_events() {
  for (std::size_t v = 0; v < nodes_.size(); ++v) {
    const BergNode& node = nodes_[v];
    std::vector<Event>& events = events_[v];
    std::sort(events.begin(), events.end(), [&](const Event& a, const Event& b) {
      if (node.parent < 0)
        if (const bool la = lower_half(node.at, a.at), lb = lower_half(node.at, b.at); la != lb) return lb;
      if (const int turn = orientation(node.at, a.at, b.at); turn != 0) return turn > 0;
      return std::tuple(a.group, a.key, a.rank, a.index) < std::tuple(b.group, b.key, b.rank, b.index);
    });
    const Point right(std::cos(node.begin), std::sin(node.begin));
    double last = 0;
    for (Event& e : events) {
      double angle = angle_between(right, e.at - node.at);
      if (node.parent < 0 && angle < 0) angle += 2 * kPi;
      last = e.angle = std::clamp(angle, last, std::max(last, node.width));
    }
  }
  // Dividers are numbered as they come round the boundary.
  std::vector<BergDivider> ordered;
  struct Visit {
    std::size_t node, next;
  };
  std::vector<Visit> stack{{0, 0}};
  while (!stack.empty()) {
    Visit& visit = stack.back();
    std::vector<Event>& events = events_[visit.node];
    if (visit.next == events.size()) {
      stack.pop_back();
      continue;
    }
    Event& e = events[visit.next++];
    if (e.divides) {
      ordered.push_back(dividers_[static_cast<std::size_t>(e.index)]);
      e.index = static_cast<int>(ordered.size()) - 1;
    } else {
      stack.push_back({static_cast<std::size_t>(e.index), 0});
    }
  }
  dividers_ = std::move(ordered);
}

/// A foot on the common side of two sectors is found by both nodes, one on a barrier from both ends: the second goes.
void BergBoundary::drop_repeated_dividers() {
  std::vector<int> number(dividers_.size());
  std::vector<BergDivider> kept;
  for (std::size_t i = 0; i < dividers_.size(); ++i) {
    const bool repeated = !kept.empty() && distance(kept.back().at, dividers_[i].at) <= tolerance_;
    number[i] = repeated ? -1 : static_cast<int>(kept.size());
    if (!repeated) kept.push_back(dividers_[i]);
  }
  for (std::vector<Event>& events : events_) {
    std::erase_if(events, [&](const Event& e) { return e.divides && number[static_cast<std::size_t>(e.index)] < 0; });
    for (Event& e : events)
      if (e.divides) e.index = number[static_cast<std::size_t>(e.index)];
  }
  dividers_ = std::move(kept);
}

double BergBoundary::farthest() const {
  double most = 0;
  for (const BergNode& node : nodes_) most = std::max(most, node.before + node.reach);
  return most;
}

/// One round, from right to left.
class BergBoundary::Walk {
 public:
  Walk(const BergBoundary& boundary, double length, double spacing)
      : b_(boundary), length_(length), spacing_(spacing), pieces_(1) {}

  std::vector<Piece> run() {
    struct Visit {
      std::size_t node, next;
      double angle;
      bool closed;  // the arc may begin at `angle` itself
    };
    std::vector<Visit> stack{{0, 0, 0, true}};
    while (!stack.empty()) {
      Visit& visit = stack.back();
      const BergNode& node = b_.nodes_[visit.node];
      const std::vector<Event>& events = b_.events_[visit.node];
      if (visit.next == events.size()) {
        arc(node, visit.angle, node.width, visit.closed, true);
        stack.pop_back();
        continue;
      }
      const Event& e = events[visit.next++];
      const auto index = static_cast<std::size_t>(e.index);
      if (e.divides ? b_.dividers_[index].length >= length_ : b_.nodes_[index].before >= length_) continue;
      // The place straight behind a corner lies on that side of it where the line of sight passes.
      arc(node, visit.angle, e.angle, visit.closed, e.group != 0);
      visit.angle = e.angle;
      visit.closed = e.group != 2;
      if (e.divides)
        pieces_.push_back({e.index, {}});
      else
        stack.push_back({index, 0, 0, true});  // `visit` is void from here on
    }
    // The round begins east of the anchor, not at a divider.
    if (pieces_.size() > 1) {
      for (const Point& p : pieces_.front().points) add(p);
      pieces_.erase(pieces_.begin());
    } else if (Polyline& round = pieces_.front().points;
               round.size() > 1 && distance(round.front(), round.back()) <= b_.tolerance_) {
      round.pop_back();
    }
    return std::move(pieces_);
  }

 private:
  void arc(const BergNode& node, double from, double to, bool with_from, bool with_to) {
    const double radius = length_ - node.before;
    if (radius > node.reach + b_.tolerance_) return;
    const bool one_point = radius * (to - from) <= b_.tolerance_;
    if (one_point && !(with_from && with_to)) return;
    const double steps = std::max(1.0, std::ceil(radius * (to - from) / spacing_));
    for (double k = with_from ? 0 : 1; k <= (with_to ? steps : steps - 1); ++k) {
      const double angle = node.begin + from + (to - from) * (k / steps);
      const Point p = node.at + radius * Point(std::cos(angle), std::sin(angle));
      if (b_.sees(node.at, p)) add(p);
    }
  }
  void add(const Point& p) {
    Polyline& points = pieces_.back().points;
    if (points.empty() || distance(points.back(), p) > b_.tolerance_) points.push_back(p);
  }

  const BergBoundary& b_;
  double length_, spacing_;
  std::vector<Piece> pieces_;
};

std::vector<BergBoundary::Piece> BergBoundary::at(double length, double spacing) const {
  return Walk(*this, length, spacing).run();
}

}  // namespace oxturn
