#include "metrics/drive_times.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr std::size_t kLeastRoom = 1024;  // samples: they stay in the processor's cache
constexpr double kSurely = 1 - 1e-9;      // of the braking distance, for rounding

/// Seconds over `length` from speed u to speed v (both reachable), never above `top`.
double seconds(double length, double u, double v, double top, double acceleration) {
  const double peak2 = (u * u + v * v) / 2 + acceleration * length;
  if (peak2 <= top * top) return (2 * std::sqrt(peak2) - u - v) / acceleration;
  const double ramps = (2 * top * top - u * u - v * v) / (2 * acceleration);
  return (2 * top - u - v) / acceleration + std::max(0.0, length - ramps) / top;
}

/// Seconds over the first `part` metres of the same drive.
double seconds_of_part(double part, double length, double u, double v, double top, double acceleration) {
  const double peak = std::min(top, std::sqrt((u * u + v * v) / 2 + acceleration * length));
  const double up = (peak * peak - u * u) / (2 * acceleration), down = (peak * peak - v * v) / (2 * acceleration);
  if (part <= up) return (std::sqrt(u * u + 2 * acceleration * part) - u) / acceleration;
  const double rest = std::max(0.0, length - part);
  if (rest >= down) return (peak - u) / acceleration + (part - up) / peak;
  const double all = seconds(length, u, v, top, acceleration);
  return all - (std::sqrt(v * v + 2 * acceleration * rest) - v) / acceleration;
}

/// Over the first `part` of a drive from speed u to speed v at a constant acceleration.
double share_of_time(double part, double u, double v) {
  const double speed = std::sqrt(u * u + part * (v * v - u * u));
  return u + v > 0 ? part * (u + v) / (speed + u) : part;
}

}  // namespace

DriveTimes::DriveTimes(const Robot& robot, double step)
    : acceleration_(robot.acceleration),
      turn_rate_(robot.turn_rate),
      min_turn_radius_(robot.min_turn_radius),
      step_(step),
      room_(kLeastRoom) {
  pending_.reserve(room_);
}

void DriveTimes::add(const Sample& sample) {
  double speed = sample.at_rest ? 0 : sample.limit;
  if (!pending_.empty()) {
    Pending& before = pending_.back();
    before.top = std::max(before.top, sample.limit);
    speed = std::min(speed, std::sqrt(before.speed * before.speed + 2 * acceleration_ * before.length));
  }
  pending_.push_back({sample.path_m, sample.length, sample.turn, speed, sample.limit});
  if (pending_.size() < room_) return;
  brake();
  pass_until(last_settled());
  room_ = std::max(kLeastRoom, 2 * pending_.size());
}

void DriveTimes::finish() {
  if (pending_.empty()) return;
  brake();
  pass_until(pending_.size() - 1);
  stretches_.push_back({pending_.back().path_m, total_, 0, 0, 0, 0});
  pending_.clear();
}

/// Limits the speed at each sample by those ahead.
void DriveTimes::brake() {
  for (std::size_t i = pending_.size() - 1; i-- > 0;) {
    const double v = pending_[i + 1].speed;
    pending_[i].speed = std::min(pending_[i].speed, std::sqrt(v * v + 2 * acceleration_ * pending_[i].length));
  }
}

/// The last sample whose speed no later ones can lower, even if the robot must stop at once; 0 if there is none.
std::size_t DriveTimes::last_settled() const {
  double ahead = 0;  // metres
  for (std::size_t i = pending_.size() - 1; i-- > 0;) {
    ahead += pending_[i].length;
    const double v = pending_[i].speed;
    if (v * v <= kSurely * 2 * acceleration_ * ahead) return i;
  }
  return 0;
}

/// Times from the first pending sample to that of index `end`, which stays.
void DriveTimes::pass_until(std::size_t end) {
  for (std::size_t i = 0; i < end; ++i) {
    const Pending &here = pending_[i], &next = pending_[i + 1];
    keep(here, next);
    const double drive = seconds(here.length, here.speed, next.speed, here.top, acceleration_);
    double driving = here.turn;  // turned while driving
    if (min_turn_radius_ > 0) driving = std::min(driving, here.length / min_turn_radius_);
    total_ += std::max(drive, driving / turn_rate_) + (here.turn - driving) / turn_rate_;
  }
  pending_.erase(pending_.begin(), pending_.begin() + static_cast<std::ptrdiff_t>(end));
}

/// Adds what lies between two samples to the stretches: to the last one, if both are short.
void DriveTimes::keep(const Pending& here, const Pending& next) {
  const double driven = next.path_m - here.path_m;
  if (joins_ && driven > 0 && driven < step_ && here.path_m - stretches_.back().path_m < step_) {
    stretches_.back().to = next.speed;
    stretches_.back().length = 0;
    return;
  }
  stretches_.push_back({here.path_m, total_, here.length, here.speed, next.speed, here.top});
  joins_ = driven > 0 && driven < step_;
}

double DriveTimes::at(double path_m) const {
  if (stretches_.empty() || path_m <= 0) return 0;
  const auto after = std::lower_bound(stretches_.begin(), stretches_.end(), path_m,
                                      [](const Stretch& s, double m) { return s.path_m < m; });
  if (after == stretches_.end()) return total_;
  const Stretch &here = *std::prev(after), &next = *after;  // the first begins at 0, so there is one before
  const double part = (path_m - here.path_m) / (next.path_m - here.path_m), whole_s = next.begin_s - here.begin_s;
  if (!(here.length > 0)) return here.begin_s + share_of_time(part, here.from, here.to) * whole_s;
  const double drive = seconds(here.length, here.from, here.to, here.top, acceleration_);
  const double driven = seconds_of_part(part * here.length, here.length, here.from, here.to, here.top, acceleration_);
  return here.begin_s + (drive > 0 ? std::min(1.0, driven / drive) : part) * whole_s;  // 0: too short for a double
}

}  // namespace oxturn
