// Method      A drive is divided into straight pieces at the corners that it passes. While the robot drives one piece,
//             the tether's last segment sweeps over a triangle and turns in one direction only. Bends that it gains
//             bend to that side and bends that it releases to the other, so first come releases, then gains.
// Complexity  A release costs the grid cells of the triangle that it opens. The first bend gained costs the cells of
//             the rest, and each further one looks again at the corners left in the shrinking triangle: k bends gained
//             in one piece among c corners take O(k c) at worst. A piece that begins at a corner which stops the tether
//             there, as all pieces of a taut path do, costs O(1).
// Decisions   1. A sweep is bounded by rays through given points: the path's points, corners and the anchor. The points
//                in which the turning tether meets the segment driven are computed only for reports and for the index.
//             2. A drive that comes within kNear of a corner goes through that corner. On a valid path that does not
//                change the homotopy class, since no obstacle lies between path and corner, and a path that rounding
//                has put on the wrong side of a corner is led around it. So only a robot exactly at a corner is a
//                special case: the corner stops the tether if its wedge lies between the tether and the path that
//                follows.
#include "geometry/tether/taut_tether.hpp"

#include <algorithm>

#include "base/throw_invalid.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Corner = TautSpace::Corner;

constexpr double kNear = TautSpace::kNear;

/// The ray from the tether's pivot, which is one of the two points, towards `through` or straight on from there.
struct PivotRay {
  Point from, through;
};

void expect_finite(const Point& p, const char* what) {
  if (!finite(p)) throw_invalid("{} ({}, {}) of a taut tether is not finite; give metres", what, p.x(), p.y());
}

}  // namespace

/// One drive.
class TautTether::Motion {
 public:
  Motion(TautTether& tether, const Point& to, const std::function<void(const Swing&)>& each)
      : tether_(tether), corners_(*tether.space_), start_(tether.robot_), to_(to), each_(each) {}

  void run() {
    tether_.kept_ = tether_.bends_.size();
    if (start_ == to_) return;
    for (const Via& v : corners_passed()) drive_piece(v.at, v.along);
    drive_piece(to_, 1);
    if (each_ && swinging_) {
      swing_.to = to_;
      each_(swing_);
    }
  }

 private:
  struct Via {
    double along;  // the drive, 0 to 1
    Point at;
  };
  std::vector<Via> corners_passed() const {
    std::vector<Via> via;
    corners_.for_each_near(std::array{start_, to_}, kNear, [&](const Corner& c) {
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
    return via;
  }

  /// Straight from the robot to q; `along` is the position of q on the whole drive.
  void drive_piece(const Point& q, double along) {
    p_ = tether_.robot_;
    q_ = q;
    piece_begin_ = piece_end_;
    piece_end_ = along;
    t_ = 0;
    turn_ = orientation(tether_.pivot(), p_, q_);
    if (turn_ != 0) sweep();
    swing_until(1);
    tether_.robot_ = q;
    while (!tether_.bends_.empty() && tether_.pivot() == q) release();
  }

  void sweep() {
    first_ray_ = {tether_.pivot(), p_};
    while (true) {
      const Point b = tether_.pivot();
      const Point previous = tether_.bends_.size() > 1 ? tether_.bends_[tether_.bends_.size() - 2].at : tether_.anchor_;
      const bool releases =
          !tether_.bends_.empty() && tether_.bends_.back().side == -turn_ && turn_ * orientation(previous, b, q_) >= 0;
      const double end = releases ? meeting(previous, b) : 1;
      const Corner* first = nullptr;
      const auto offer = [&](const Corner& c) {
        if (!swept(c) || (releases ? turn_ * orientation(previous, b, c.at) >= 0 : !before_end(c))) return;
        if (stops(c) && (first == nullptr || sooner(c, *first))) first = &c;
      };
      // A corner that stops the tether where the piece begins comes before all others: along a taut path that is all.
      if (t_ == 0)
        corners_.for_each_near(std::array{p_}, 0, [&](const Corner& c) {
          if (c.at == p_) offer(c);
        });
      if (first == nullptr) corners_.for_each_near(std::array{b, lerp(p_, q_, t_), lerp(p_, q_, end)}, kNear, offer);
      if (first != nullptr) return gain_from(*first);
      if (!releases) return;
      swing_until(end);
      first_ray_ = {previous, b};
      release();
    }
  }

  /// Gains `first` and all further bends of the piece.
  void gain_from(const Corner& first) {
    gain(first);
    if (first.at == p_) return;  // the rest of the tether is the path itself
    std::vector<const Corner*> left;
    const std::array triangle{first.at, lerp(p_, q_, t_), q_};
    corners_.for_each_near(triangle, kNear, [&](const Corner& c) { left.push_back(&c); });
    while (true) {
      std::erase_if(left, [&](const Corner* c) { return !swept(*c) || !before_end(*c); });
      const Corner* next = nullptr;
      for (const Corner* c : left)
        if (stops(*c) && (next == nullptr || sooner(*c, *next))) next = c;
      if (next == nullptr) return;
      gain(*next);
    }
  }

  /// Is the corner not before the sweep's first ray, and on the pivot's side of the piece (or where the piece begins)?
  bool swept(const Corner& c) const {
    return turn_ * orientation(first_ray_.from, first_ray_.through, c.at) >= 0 &&
           (c.at == p_ || turn_ * orientation(p_, q_, c.at) > 0);
  }
  /// Does the tether meet the corner before the robot is at the end of the piece?
  bool before_end(const Corner& c) const { return turn_ * orientation(tether_.pivot(), c.at, q_) > 0; }
  bool stops(const Corner& c) const {
    return turn_ * orientation(tether_.pivot(), c.at, c.inside) > 0 &&
           (c.at != p_ || turn_ * orientation(p_, q_, c.inside) > 0);
  }
  /// Does the tether meet a before b? Of two that are collinear with the pivot, the farther one counts as first.
  bool sooner(const Corner& a, const Corner& b) const {
    const Point& pivot = tether_.pivot();
    const int order = turn_ * orientation(pivot, b.at, a.at);
    return order != 0 ? order < 0 : a.at != b.at && on_segment(b.at, pivot, a.at);
  }

  void gain(const Corner& c) {
    const Point b = tether_.pivot();
    swing_until(meeting(b, c.at));
    tether_.before_.push_back(tether_.before_.back() + distance(b, c.at));
    tether_.bends_.push_back({c.at, turn_});
    first_ray_ = {b, c.at};
  }
  void release() {
    tether_.bends_.pop_back();
    tether_.before_.pop_back();
    tether_.kept_ = std::min(tether_.kept_, tether_.bends_.size());
  }

  /// Where the line through a and b meets the piece: 0 at p, 1 at q, not before t_. Rounded.
  double meeting(const Point& a, const Point& b) const {
    const Point d = q_ - p_, line = b - a;
    const double across = cross(d, line), t = across != 0 ? cross(a - p_, line) / across : t_;
    return t > t_ ? std::min(t, 1.0) : t_;
  }

  /// The tether has turned about its pivot until the robot was at t of the piece.
  void swing_until(double t) {
    t_ = t;
    const double along = piece_begin_ + t * (piece_end_ - piece_begin_);
    if (!each_ || along <= swung_to_) return;
    const bool same = swinging_ && swing_.pivot == tether_.pivot() && swing_.bends == tether_.bends_.size();
    if (!same) {
      if (swinging_) {
        swing_.to = lerp(start_, to_, swung_to_);
        each_(swing_);
      }
      swing_ = {tether_.pivot(), tether_.before_.back(), tether_.bends_.size(), swinging_ ? swing_.to : start_, to_};
      swinging_ = true;
    }
    swung_to_ = along;
  }

  TautTether& tether_;
  const TautSpace& corners_;
  const Point start_, to_;
  const std::function<void(const Swing&)>& each_;

  Point p_{0, 0}, q_{0, 0};                 // the present piece
  int turn_ = 0;                            // of the tether in it: +1 left
  PivotRay first_ray_;                      // where the present sweep begins
  double t_ = 0;                            // how far the piece is driven, 0 to 1
  double piece_begin_ = 0, piece_end_ = 0;  // on the whole drive, 0 to 1
  Swing swing_;                             // not reported yet
  bool swinging_ = false;
  double swung_to_ = 0;  // on the whole drive
};

TautTether::TautTether(const TautSpace& space, const Point& anchor) : space_(&space), anchor_(anchor), robot_(anchor) {
  expect_finite(anchor, "anchor");
}

void TautTether::drive(const Point& to, const std::function<void(const Swing&)>& each) {
  expect_finite(to, "path point");
  Motion(*this, to, each).run();
}

Polyline TautTether::polyline() const {
  Polyline line{anchor_};
  for (const Bend& bend : bends_) line.push_back(bend.at);
  line.push_back(robot_);
  return line;
}

}  // namespace oxturn
