#include "metrics/capsules.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr double kStraight = 1e-10;  // tile sides: points this near to a merged segment are on it

/// Clips the segment ab to `room` (Liang and Barsky); false if nothing is left.
bool clip_to(const Box& room, Vec& a, Vec& b) {
  const Vec d = b - a;
  double from = 0, to = 1;
  const auto cut = [&](double step, double space) {  // space - t * step >= 0
    if (step == 0) return space >= 0;
    const double t = space / step;
    if (step > 0)
      to = std::min(to, t);
    else
      from = std::max(from, t);
    return from <= to;
  };
  if (!cut(-d.x, a.x - room.low.x()) || !cut(d.x, room.high.x() - a.x) || !cut(-d.y, a.y - room.low.y()) ||
      !cut(d.y, room.high.y() - a.y))
    return false;
  const Vec start = a;
  if (to < 1) b = start + to * d;
  if (from > 0) a = start + from * d;
  return true;
}

class Collector {
 public:
  Collector(const Box& room, CapsuleSet& set) : room_(room), set_(set) {}

  void switch_on(Vec at, std::uint32_t leg) {
    if (!room_.contains({at.x, at.y})) return;
    set_.all.push_back({at, at, {1, 0}, leg, true, true});
    ++set_.discs;
  }

  /// The segments of a leg, merged where they run straight on.
  void add_leg(const std::vector<Vec>& points, std::uint32_t leg) {
    bool any = false;
    Vec a = points.front(), b = a;  // the merged segment
    double bend = 0;                // how far points between a and b may be off it
    for (const Vec c : points) {
      const Vec step = c - b;
      if (step.x == 0 && step.y == 0) continue;
      const Vec so_far = b - a, whole = c - a;
      if (any && dot(so_far, step) > 0) {
        const double off = std::abs(cross(so_far, step)) / std::hypot(whole.x, whole.y);
        if (bend + off <= kStraight) {
          bend += off;
          b = c;
          continue;
        }
      }
      if (any) add_segment(a, b, leg);
      a = b;
      b = c;
      bend = 0;
      any = true;
    }
    if (any)
      add_segment(a, b, leg);
    else if (room_.contains({a.x, a.y}))  // a leg without length covers a disc
      set_.all.push_back({a, a, {1, 0}, leg, true, false});
  }

 private:
  void add_segment(Vec a, Vec b, std::uint32_t leg) {
    const Vec d = b - a;
    const Vec along = (1 / std::hypot(d.x, d.y)) * d;
    if (!clip_to(room_, a, b)) return;
    set_.all.push_back({a, b, along, leg, false, false});
    set_.work += std::hypot(b.x - a.x, b.y - a.y);
  }
  const Box& room_;
  CapsuleSet& set_;
};

}  // namespace

CapsuleSet capsules(const Path& path, const Point& origin, double side, const Box& room, double joint) {
  CapsuleSet set;
  Collector collector(room, set);
  const Point* before = nullptr;  // end of the previous leg, if it had the tool on
  std::vector<Vec> points;
  std::uint32_t index = 0;
  for (const Leg& leg : path.legs) {
    const std::uint32_t number = index++;
    if (!leg.tool || leg.points.empty()) {
      if (!leg.tool) before = nullptr;
      continue;
    }
    points.clear();
    for (const Point& p : leg.points) {
      const Point q = (p - origin) / side;
      points.push_back({q.x(), q.y()});
    }
    if (before == nullptr || distance(*before, leg.points.front()) > joint) collector.switch_on(points.front(), number);
    collector.add_leg(points, number);
    before = &leg.points.back();
  }
  return set;
}

Chords::Chords(int n) {
  const double part = kPi / n;
  for (int k = 0; k < n; ++k) {
    const double angle = -kPi / 2 + (k + 0.5) * part;
    directions_.push_back({std::cos(angle), std::sin(angle)});
  }
  inscribed_ = std::cos(part / 2);
  equal_area_ = std::sqrt(part / 2 / std::tan(part / 2));
}

namespace {

/// How far `where` extends beyond its centre in direction `normal`.
double reach_of(const Extent& where, Vec normal) {
  return std::abs(normal.x) * where.half.x + std::abs(normal.y) * where.half.y;
}

/// Adds the half-plane with this normal at `distance` from `at`, if it does not contain all of `where`. `at` is
/// relative to the extent's centre.
void add_if_it_cuts(const Extent& where, Vec at, Vec normal, double distance, std::vector<HalfPlane>& out) {
  const double reach = dot(normal, at) + distance;
  if (reach_of(where, normal) > reach) out.push_back({normal, reach + dot(normal, where.centre)});
}

void half_disc(const Extent& where, Vec at, Vec forward, const Chords& chords, double cap,
               std::vector<HalfPlane>& out) {
  const Vec left{-forward.y, forward.x};
  for (const Vec d : chords.directions()) add_if_it_cuts(where, at, d.x * forward + d.y * left, cap, out);
}

}  // namespace

void polygon_of(const Capsule& k, Vec centre, const Extent& where, const Chords& chords, double side, double cap,
                std::vector<HalfPlane>& out) {
  out.clear();
  const Vec origin = centre + where.centre;
  const Vec a = k.a - origin, b = k.b - origin, left{-k.along.y, k.along.x}, right{k.along.y, -k.along.x};
  const double reach = reach_of(where, k.along);
  add_if_it_cuts(where, a, left, side, out);
  add_if_it_cuts(where, a, right, side, out);
  // A cap is needed only if part of `where` lies beyond the segment's end.
  if (dot(k.along, b) < reach) half_disc(where, b, k.along, chords, cap, out);
  if (-dot(k.along, a) < reach) half_disc(where, a, -1.0 * k.along, chords, cap, out);
}

void disc_of(const Capsule& k, Vec centre, const Extent& where, const Chords& chords, double cap,
             std::vector<HalfPlane>& out) {
  out.clear();
  const Vec a = k.a - (centre + where.centre);
  half_disc(where, a, k.along, chords, cap, out);
  half_disc(where, a, -1.0 * k.along, chords, cap, out);
}

}  // namespace oxturn
