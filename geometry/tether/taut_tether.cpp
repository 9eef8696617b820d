// Decisions   1. A sweep is bounded by rays through given points: the robot's way points, corners and the anchor. The
//                places where the turning string meets the driven segment are computed for reports and for the index
//                only.
//             2. A drive that comes within kNear of a corner goes through that corner. It changes no class where the way
//                is valid (no obstacle lies between the way and the corner), and a way that rounding has put on the
//                wrong side of a corner is led round it. So only a robot that stands exactly at a corner is a special
//                case: the corner holds the string if its wedge lies between the string and the way that follows.
//             3. In one straight piece the string turns in one direction only. Bends gained bend to this side and
//                bends released to the other: first come releases, then gains.
// Complexity  a release costs the cells of the triangle that it opens; of the first bend gained the cells of the rest,
//             and each further one looks again at the corners left in the shrinking triangle. k bends gained in one
//             straight piece among c corners: O(k c) at worst.
#include "geometry/tether/taut_tether.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "geometry/tether/corner_index.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Corner = CornerIndex::Corner;

/// Metres. Way points may lie so far inside a wall.
constexpr double kNear = 2e-6;

/// Leaves the pivot, which is one of its two points: towards `through`, or straight on from there.
struct Ray {
  Point from, through;
};

void expect_finite(const Point& p, const char* what) {
  if (!finite(p))
    throw std::invalid_argument(
        fmt::format("{} ({}, {}) of a taut string is not finite; give metres", what, p.x(), p.y()));
}

}  // namespace

struct TautSpace::Impl {
  CornerIndex corners;
};

TautSpace::TautSpace(const Region& free) : impl_(new Impl{CornerIndex(free)}) {}
TautSpace::~TautSpace() = default;
TautSpace::TautSpace(TautSpace&&) noexcept = default;

/// One drive.
class TautTether::Motion {
 public:
  Motion(TautTether& string, const Point& to, const std::function<void(const Swing&)>& each)
      : string_(string), corners_(string.space_->impl().corners), start_(string.robot_), to_(to), each_(each) {}

  void run() {
    string_.kept_ = string_.bends_.size();
    if (start_ == to_) return;
    struct Via {
      double along;
      Point at;
    };
    std::vector<Via> via;
    const Point ends[2] = {start_, to_};
    corners_.for_each_near(ends, 2, kNear, [&](const Corner& c) {
      if (c.at == start_ || c.at == to_) return;
      const Point d = to_ - start_;
      const double along = std::clamp((c.at - start_).dot(d) / d.squaredNorm(), 0.0, 1.0);
      if (distance(lerp(start_, to_, along), c.at) <= kNear) via.push_back({along, c.at});
    });
    if (via.size() > 1) {
      std::sort(via.begin(), via.end(),
                [](const Via& a, const Via& b) { return a.along != b.along ? a.along < b.along : before(a.at, b.at); });
      via.erase(std::unique(via.begin(), via.end(), [](const Via& a, const Via& b) { return a.at == b.at; }),
                via.end());
    }
    for (const Via& v : via) go(v.at, v.along);
    go(to_, 1);
    if (each_ && begun_) {
      swing_.to = to_;
      each_(swing_);
    }
  }

 private:
  /// Straight from the robot to q; `along` is q's place on the whole drive.
  void go(const Point& q, double along) {
    p_ = string_.robot_;
    q_ = q;
    part_from_ = part_to_;
    part_to_ = along;
    t_ = 0;
    turn_ = orientation(string_.pivot(), p_, q_);
    if (turn_ != 0) sweep();
    stretch(1);
    string_.robot_ = q;
    while (!string_.bends_.empty() && string_.pivot() == q) pop();
  }

  void sweep() {
    start_ray_ = {string_.pivot(), p_};
    while (true) {
      const Point b = string_.pivot();
      const Point previous = string_.bends_.size() > 1 ? string_.bends_[string_.bends_.size() - 2].at : string_.anchor_;
      const bool releases =
          !string_.bends_.empty() && string_.bends_.back().side == -turn_ && turn_ * orientation(previous, b, q_) >= 0;
      const double end = releases ? meeting(previous, b) : 1;
      const Corner* first = nullptr;
      const Point triangle[3] = {b, lerp(p_, q_, t_), lerp(p_, q_, end)};
      corners_.for_each_near(triangle, 3, kNear, [&](const Corner& c) {
        if (!swept(c) || (releases ? turn_ * orientation(previous, b, c.at) >= 0 : !before_end(c))) return;
        if (blocks(c) && (first == nullptr || sooner(c, *first))) first = &c;
      });
      if (first != nullptr) return gain_from(*first);
      if (!releases) return;
      stretch(end);
      start_ray_ = {previous, b};
      pop();
    }
  }

  /// Takes up `first` and what follows until the drive's end.
  void gain_from(const Corner& first) {
    gain(first);
    if (first.at == p_) return;  // the rest of the string is the way itself
    std::vector<const Corner*> left;
    const Point triangle[3] = {first.at, lerp(p_, q_, t_), q_};
    corners_.for_each_near(triangle, 3, kNear, [&](const Corner& c) { left.push_back(&c); });
    while (true) {
      std::erase_if(left, [&](const Corner* c) { return !swept(*c) || !before_end(*c); });
      const Corner* next = nullptr;
      for (const Corner* c : left)
        if (blocks(*c) && (next == nullptr || sooner(*c, *next))) next = c;
      if (next == nullptr) return;
      gain(*next);
    }
  }

  /// Not before the sweep's first ray, and nearer than the robot (or where it starts).
  bool swept(const Corner& c) const {
    return turn_ * orientation(start_ray_.from, start_ray_.through, c.at) >= 0 &&
           (c.at == p_ || turn_ * orientation(p_, q_, c.at) > 0);
  }
  /// A turn is left about a corner that the string meets before the robot is at its goal.
  bool before_end(const Corner& c) const { return turn_ * orientation(string_.pivot(), c.at, q_) > 0; }
  bool blocks(const Corner& c) const {
    return turn_ * orientation(string_.pivot(), c.at, c.inside) > 0 &&
           (c.at != p_ || turn_ * orientation(p_, q_, c.inside) > 0);
  }
  /// Does the string meet a before b? Of two in line, the farther one counts as the first.
  bool sooner(const Corner& a, const Corner& b) const {
    const Point& pivot = string_.pivot();
    const int order = turn_ * orientation(pivot, b.at, a.at);
    return order != 0 ? order < 0 : a.at != b.at && on_segment(b.at, pivot, a.at);
  }

  void gain(const Corner& c) {
    const Point b = string_.pivot();
    stretch(meeting(b, c.at));
    string_.before_.push_back(string_.before_.back() + distance(b, c.at));
    string_.bends_.push_back({c.at, turn_});
    start_ray_ = {b, c.at};
  }
  void pop() {
    string_.bends_.pop_back();
    string_.before_.pop_back();
    string_.kept_ = std::min(string_.kept_, string_.bends_.size());
  }

  /// Where the line through a and b meets the straight piece, rounded, not before t_: 0 at p, 1 at q.
  double meeting(const Point& a, const Point& b) const {
    const Point d = q_ - p_, line = b - a;
    const double across = cross(d, line), t = across != 0 ? cross(a - p_, line) / across : t_;
    return t > t_ ? std::min(t, 1.0) : t_;
  }

  /// The string has turned about its pivot until the robot was at t of the straight piece.
  void stretch(double t) {
    t_ = t;
    const double along = part_from_ + t * (part_to_ - part_from_);
    if (!each_ || along <= swung_to_) return;
    const bool same = begun_ && swing_.pivot == string_.pivot() && swing_.bends == string_.bends_.size();
    if (!same) {
      if (begun_) {
        swing_.to = lerp(start_, to_, swung_to_);
        each_(swing_);
      }
      swing_ = {string_.pivot(), string_.before_.back(), string_.bends_.size(), begun_ ? swing_.to : start_, to_};
      begun_ = true;
    }
    swung_to_ = along;
  }

  TautTether& string_;
  const CornerIndex& corners_;
  const Point start_, to_;
  const std::function<void(const Swing&)>& each_;

  Point p_{0, 0}, q_{0, 0};  // the straight piece under way
  int turn_ = 0;             // of the string in it: +1 to the left
  Ray start_ray_;
  double t_ = 0;                        // place on the piece
  double part_from_ = 0, part_to_ = 0;  // the piece's place on the whole drive, 0 to 1
  Swing swing_;                         // not yet reported
  bool begun_ = false;
  double swung_to_ = 0;
};

TautTether::TautTether(const TautSpace& space, const Point& anchor) : space_(&space), anchor_(anchor), robot_(anchor) {
  expect_finite(anchor, "anchor");
}

void TautTether::drive(const Point& to, const std::function<void(const Swing&)>& each) {
  expect_finite(to, "way point");
  Motion(*this, to, each).run();
}

Polyline TautTether::polyline() const {
  Polyline line{anchor_};
  for (const Bend& bend : bends_) line.push_back(bend.at);
  line.push_back(robot_);
  return line;
}

}  // namespace oxturn
