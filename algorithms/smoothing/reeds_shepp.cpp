// The shortest Reeds-Shepp curves, by OMPL's state space. (Its Dubins curves abort the program in Debian 12's build: an
// assertion fails for about one in 10^5 pairs of poses of which one heads straight for the other, as lanes do.)
#include <ompl/base/ScopedState.h>
#include <ompl/base/spaces/ReedsSheppStateSpace.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "algorithms/smoothing/curve.hpp"

namespace oxturn {
namespace {

namespace ob = ompl::base;

using Space = ob::ReedsSheppStateSpace;

/// A state space of unit radius with two states to work with. OMPL computes in units of the radius anyway.
class UnitSpace {
 public:
  UnitSpace() : space_(std::make_shared<Space>(1.0)), from_(space_), to_(space_) {}
  Space::ReedsSheppPath shortest(const Pose& from, const Pose& to, double radius) {
    // Relative to the first pose: large coordinates would cost digits.
    set(from_, {{0, 0}, from.heading});
    set(to_, {(to.at - from.at) / radius, to.heading});
    return space_->reedsShepp(from_.get(), to_.get());
  }

 private:
  static void set(ob::ScopedState<Space>& state, const Pose& pose) {
    state->setXY(pose.at.x(), pose.at.y());
    state->setYaw(std::remainder(pose.heading, 2 * kPi));
  }
  std::shared_ptr<Space> space_;
  ob::ScopedState<Space> from_, to_;
};

Curve by_ompl(const Pose& from, const Pose& to, double radius) {
  thread_local UnitSpace space;
  const auto path = space.shortest(from, to, radius);
  Curve curve{from, to, radius, {}};
  for (std::size_t i = 0; i < 5; ++i) {
    const auto type = path.type_[i];
    if (type == Space::RS_NOP || path.length_[i] == 0) continue;
    const Steering steering = type == Space::RS_LEFT       ? Steering::left
                              : type == Space::RS_STRAIGHT ? Steering::straight
                                                           : Steering::right;
    curve.pieces.push_back(
        {steering, std::abs(path.length_[i]) * radius, path.length_[i] > 0 ? Gear::forward : Gear::reverse});
  }
  return curve;
}

/// The same curve driven with the robot turned round: in the other gear, so that it steers to the other side.
Curve in_reverse(Curve curve) {
  curve.from = turned_round(curve.from), curve.to = turned_round(curve.to);
  for (CurvePiece& piece : curve.pieces) {
    piece.gear = Gear::reverse;
    if (piece.steering != Steering::straight)
      piece.steering = piece.steering == Steering::left ? Steering::right : Steering::left;
  }
  return curve;
}

}  // namespace

Curve reeds_shepp_curve(const Pose& from, const Pose& to, double radius) {
  // OMPL misses some curves without cusps between aligned poses.
  Curve best = by_ompl(from, to, radius);
  const double rounding = 1e-9 * radius;
  if (Curve forward = dubins_curve(from, to, radius); forward.length() < best.length() - rounding)
    best = std::move(forward);
  if (Curve back = dubins_curve(turned_round(from), turned_round(to), radius); back.length() < best.length() - rounding)
    best = in_reverse(std::move(back));
  return best;
}

}  // namespace oxturn
