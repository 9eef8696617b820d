#include "metrics/capsules.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/math.hpp"
#include "base/sorting.hpp"
#include "geometry/point_count.hpp"

namespace oxturn {
namespace {

constexpr double kStraight = 1e-10;          // tile sides: rounding
constexpr std::size_t kWorthSearching = 32;  // chords; of fewer, each is tested

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

/// The directions in which a segment from a given point passes the points added so far within `width`.
class Funnel {
 public:
  Funnel(Vec from, double width) : from_(from), width_(width) {}

  /// Is the segment to `p` near to all points added so far, and does none of them lie beyond it?
  bool admits(Vec p) const {
    const Vec v = p - from_;
    if (dot(v, v) < least_ * least_) return false;
    return !narrow_ || (dot(v, ahead_) > 0 && cross(low_, v) >= 0 && cross(v, high_) >= 0);
  }
  void add(Vec p) {
    const Vec v = p - from_;
    const double length = std::sqrt(dot(v, v));
    least_ = std::max(least_, length - width_);
    if (length <= width_) return;
    const double sine = width_ / length, cosine = std::sqrt(1 - sine * sine);
    const Vec low{cosine * v.x + sine * v.y, cosine * v.y - sine * v.x};
    const Vec high{cosine * v.x - sine * v.y, cosine * v.y + sine * v.x};
    if (!narrow_) ahead_ = v;
    if (!narrow_ || cross(low_, low) > 0) low_ = low;
    if (!narrow_ || cross(high, high_) > 0) high_ = high;
    narrow_ = true;
  }

 private:
  Vec from_;
  double width_;
  bool narrow_ = false;
  Vec low_{0, 0}, high_{0, 0}, ahead_{0, 0};
  double least_ = 0;
};

/// Calls f(from, to) for the stretches of a chain that one segment each may stand for.
template <class F>
void for_each_stretch(const WorkChains::Station* first, const WorkChains::Station* last, double width, F f) {
  while (last - first > 1) {
    Funnel funnel(first->at, width);
    const WorkChains::Station* end = first + 1;
    for (funnel.add(end->at); end + 1 < last && funnel.admits((end + 1)->at); ++end) funnel.add((end + 1)->at);
    f(first, end);
    first = end;
  }
}

class Collector {
 public:
  Collector(const Box& room, double slack, CapsuleSet& set) : room_(room), slack_(slack), set_(set) {}

  void add_chain(const WorkChains::Station* first, const WorkChains::Station* last, double radius) {
    radius_ = radius;
    add_disc(*first, true);
    if (last - first == 1) return add_disc(*first, false);
    for_each_stretch(first, last, slack_ * radius_ / 2,
                     [this](const auto* from, const auto* to) { add_segment(from, to); });
  }

 private:
  void add_disc(const WorkChains::Station& at, bool switched_on) {
    if (!room_.contains({at.at.x, at.at.y})) return;
    Capsule k{at.at, at.at, {1, 0}, at.path_m, at.path_m};
    k.radius = radius_;
    k.disc = true;
    k.visits_only = switched_on;
    set_.all.push_back(k);
    if (switched_on) set_.begun += kPi * radius_ * radius_;
  }
  /// One segment in place of the chain from `from` to `to`.
  void add_segment(const WorkChains::Station* from, const WorkChains::Station* to) {
    Capsule k;
    k.radius = radius_;
    k.a = from->at;
    k.b = to->at;
    const Vec d = k.b - k.a;
    const double length = oxturn::length(d);
    k.disc = !(length > 0);
    k.along = k.disc ? Vec{1, 0} : (1 / length) * d;
    double off2 = 0;
    for (const WorkChains::Station* s = from + 1; s < to; ++s) off2 = std::max(off2, squared_distance(s->at, k));
    if (off2 > kStraight * kStraight) k.slack = std::sqrt(off2);
    if (!clip_to(room_, k.a, k.b)) return;
    const auto driven_at = [&](Vec p) {
      const double part = k.disc ? 0 : dot(p - from->at, k.along) / length;
      return from->path_m + part * (to->path_m - from->path_m);
    };
    k.path_m = driven_at(k.a);
    k.end_m = driven_at(k.b);
    set_.all.push_back(k);
    set_.begun += 2 * radius_ * oxturn::length(k.b - k.a);
  }
  const Box& room_;
  double slack_, radius_ = kToolRadius;
  CapsuleSet& set_;
};

/// The same for equal segments, whatever their direction, and hardly ever for others.
std::uint64_t segment_hash(const Capsule& k) {
  const auto mixed = [](Vec p) {
    const auto x = std::bit_cast<std::uint64_t>(p.x), y = std::bit_cast<std::uint64_t>(p.y);
    return (x * 0x9e3779b97f4a7c15u ^ std::rotl(y, 32)) * 0xbf58476d1ce4e5b9u;
  };
  const std::uint64_t sum = mixed(k.a) + mixed(k.b);
  return sum ^ sum >> 31;
}

bool equal(Vec p, Vec q) { return p.x == q.x && p.y == q.y; }

/// Keeps the first of equal segments, which counts the others. Where two others share a hash, some repetitions may be
/// left; they only cost time.
void merge_repeated(std::vector<Capsule>& all) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;  // hash, capsule
  order.reserve(all.size());
  for (std::uint32_t i = 0; i < all.size(); ++i)
    if (!all[i].disc) order.emplace_back(segment_hash(all[i]), i);
  spread_sort(
      order, [](const auto& item) { return item.first; }, std::less<>());
  std::vector<bool> repeated(all.size());
  for (std::size_t i = 1, first = 0; i < order.size(); ++i) {
    const Capsule& k = all[order[i].second];
    Capsule& kept = all[order[first].second];
    const bool same = order[i].first == order[first].first && k.slack == kept.slack && k.radius == kept.radius;
    const bool forth = equal(k.a, kept.a) && equal(k.b, kept.b), back = equal(k.a, kept.b) && equal(k.b, kept.a);
    if (!same || !(forth || back)) {
      first = i;
      continue;
    }
    ++(forth ? kept.forth : kept.back);
    repeated[order[i].second] = true;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (!repeated[i]) all[kept++] = all[i];
  all.resize(kept, all.empty() ? Capsule{} : all.front());
}

}  // namespace

WorkChains work_chains(const Path& path, const Point& origin, double side, double joint) {
  WorkChains chains;
  chains.stations.reserve(point_count(path.legs));
  const Point* before = nullptr;  // end of the previous leg, if it had the tool on
  double radius = kToolRadius;    // of that leg
  double driven = 0;
  const auto add = [&](const Point& p) {
    const Point q = (p - origin) / side;
    chains.stations.push_back({{q.x(), q.y()}, driven});
  };
  for (const Leg& leg : path.legs) {
    if (leg.points.empty()) continue;
    const double own = leg.width > 0 ? std::min(leg.width / 2 / side, kToolRadius) : kToolRadius;
    if (!leg.tool) {
      before = nullptr;
    } else if (before == nullptr || own != radius || distance(*before, leg.points.front()) > joint) {
      if (!chains.stations.empty()) chains.chains.push_back({chains.stations.size(), radius});
      radius = own;
      add(leg.points.front());
    } else if (*before != leg.points.front()) {
      add(leg.points.front());
    }
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const double step = distance(leg.points[i - 1], leg.points[i]);
      driven += step;
      if (leg.tool && step > 0) add(leg.points[i]);
    }
    if (leg.tool) before = &leg.points.back();
  }
  if (!chains.stations.empty()) chains.chains.push_back({chains.stations.size(), radius});
  return chains;
}

namespace {

/// Calls f(first station, behind the last one, radius) for each chain.
template <class F>
void for_each_chain(const WorkChains& chains, F f) {
  const WorkChains::Station *all = chains.stations.data(), *first = all;
  for (const auto& [end, radius] : chains.chains) {
    f(first, all + end, radius);
    first = all + end;
  }
}

}  // namespace

double work_in(const WorkChains& chains, const Box& room) {
  double work = 0;
  for_each_chain(chains, [&](const auto* first, const auto* last, double radius) {
    for (const auto* station = first + 1; station < last; ++station) {
      Vec a = station[-1].at, b = station->at;
      if (clip_to(room, a, b)) work += 2 * radius * oxturn::length(b - a);
    }
  });
  return work;
}

CapsuleSet capsules(WorkChains chains, const Box& room, double slack) {
  CapsuleSet set;
  slack = std::max(slack, kStraight);
  std::size_t count = 0;  // millions: counting them costs less than moving them as the list grows
  for_each_chain(chains, [&](const auto* first, const auto* last, double radius) {
    count += 2;  // discs
    for_each_stretch(first, last, slack * radius / 2, [&](auto&&...) { ++count; });
  });
  set.all.reserve(count);
  Collector collector(room, slack, set);
  for_each_chain(chains,
                 [&](const auto* first, const auto* last, double radius) { collector.add_chain(first, last, radius); });
  chains = {};  // a large part of the memory, as is what comes now
  merge_repeated(set.all);
  for (const Capsule& k : set.all) set.slack = std::max(set.slack, k.slack);
  return set;
}

Chords::Chords(int n) {
  const double part = kPi / n;
  for (int k = 0; k < n; ++k) {
    const double angle = -kPi / 2 + (k + 0.5) * part;
    directions_.push_back({math::cos(angle), math::sin(angle)});
  }
  inscribed_ = math::cos(part / 2);
  equal_area_ = std::sqrt(part / 2 / math::tan(part / 2));
}

std::span<const Vec> Chords::between(double x, double y, double near) const {
  const std::span<const Vec> all = directions_;
  if (all.size() <= kWorthSearching) return all;
  const double length = std::sqrt(x * x + y * y);
  if (near <= -length) return all;
  if (near >= length) return {};
  const double middle = math::atan2(y, x), half = math::acos(near / length);
  if (std::abs(middle) + half >= 1.5 * kPi) return all;  // reaches around the back
  const auto n = static_cast<double>(all.size());
  const auto index = [&](double angle) {
    return static_cast<std::size_t>(std::clamp((angle + kPi / 2) / kPi * n, 0.0, n));
  };
  const std::size_t from = index(middle - half - kPi / n), to = index(middle + half + kPi / n);
  return all.subspan(from, to - from);
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
  const double ahead = -dot(forward, at), across = -dot(left, at);  // of the extent's centre, from `at`
  const double near = cap - std::sqrt(dot(where.half, where.half)) - kStraight;
  for (const Vec d : chords.between(ahead, across, near))
    if (d.x * ahead + d.y * across > near) add_if_it_cuts(where, at, d.x * forward + d.y * left, cap, out);
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

void disc_of(Vec at, Vec along, Vec centre, const Extent& where, const Chords& chords, double cap,
             std::vector<HalfPlane>& out) {
  out.clear();
  const Vec a = at - (centre + where.centre);
  half_disc(where, a, along, chords, cap, out);
  half_disc(where, a, -1.0 * along, chords, cap, out);
}

}  // namespace oxturn
