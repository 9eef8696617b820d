#include "algorithms/smoothing/car_space.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point_outside.hpp"

namespace oxturn {
namespace {

constexpr double kShifts[] = {0, 0.5, 1, 2};  // radii that a pose is moved along its lane's line

/// One curve after the other.
Curve joined(Curve first, const Curve& second) {
  first.pieces.insert(first.pieces.end(), second.pieces.begin(), second.pieces.end());
  first.to = second.to;
  return first;
}

/// Straight ahead by `shift` metres; backwards if it is negative.
Curve straight(const Pose& from, double shift, double radius) {
  return {from,
          ahead(from, shift),
          radius,
          {{Steering::straight, std::abs(shift), shift < 0 ? Gear::reverse : Gear::forward}}};
}

void add_curves(const Pose& from, const Pose& to, double radius, bool reverse, std::vector<Curve>& out) {
  if (reverse) out.push_back(reeds_shepp_curve(from, to, radius));
  for (Curve& word : dubins_words(from, to, radius)) out.push_back(std::move(word));
}

}  // namespace

std::vector<Curve> link_curves(const Pose& from, const Pose& to, double radius, bool reverse) {
  std::vector<double> shifts;
  for (const double shift : kShifts) {
    shifts.push_back(shift * radius);
    if (reverse && shift > 0) shifts.push_back(-shift * radius);
  }
  std::vector<Curve> all;
  for (const double out : shifts)
    for (const double in : shifts) {
      const Curve first = straight(from, out, radius), last = straight(ahead(to, -in), in, radius);
      std::vector<Curve> middle;
      add_curves(first.to, last.from, radius, reverse, middle);
      for (const Curve& curve : middle) all.push_back(joined(joined(first, curve), last));
    }
  return all;
}

CarSpace::CarSpace(const Problem& problem, DetourSearch search)
    : problem_(&problem),
      walls_(problem.walls()),
      bounds_(bounding_box(problem.configuration_space())),
      search_(search),
      radius_(problem.robot().min_turn_radius),
      chord_error_(kChordError * problem.robot().tool_width),
      tolerance_(problem.tolerance() / 2),
      stop_cost_(problem.robot().speed * problem.robot().speed / problem.robot().acceleration),
      reverse_(problem.robot().reverse) {}

CarSpace::CarSpace(const Problem& problem, const EdgeIndex& walls, const Box& bounds, double radius)
    : walls_(walls),
      bounds_(bounds),
      search_(DetourSearch::lattice),
      radius_(radius),
      chord_error_(kChordError * problem.robot().tool_width),
      tolerance_(problem.tolerance() / 2),
      stop_cost_(0),
      reverse_(false) {}

bool CarSpace::free(const Polyline& line) const {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (point_outside(walls_, line[i - 1], line[i], tolerance_)) return false;
  return true;
}

bool CarSpace::free(const Curve& curve) const {
  for (const Leg& leg : sampled(curve, chord_error_, false))
    if (!free(leg.points)) return false;
  return true;
}

bool CarSpace::free(const Pose& from, const CurvePiece& piece) const {
  return free(Curve{from, after(from, piece, radius_), radius_, {piece}});
}

Curve CarSpace::shortest(const Pose& from, const Pose& to) const {
  return reverse_ ? reeds_shepp_curve(from, to, radius_) : dubins_curve(from, to, radius_);
}

double CarSpace::least_length(const Pose& from, const Pose& to) const {
  return reverse_ ? reeds_shepp_curve(from, to, radius_).length() : dubins_distance(from, to, radius_);
}

Polyline CarSpace::shortest_path(const Point& from, const Point& to) const {
  if (problem_ == nullptr) return {};
  return problem_->transit().path(from, to).value_or(Polyline{});
}

double CarSpace::cost(const Curve& curve) const {
  return curve.length() + stop_cost_ * static_cast<double>(curve.cusps());
}

std::optional<Curve> CarSpace::simple_link(const Pose& from, const Pose& to) const {
  std::vector<Curve> all = link_curves(from, to, radius_, reverse_);
  std::ranges::stable_sort(all, {}, [&](const Curve& curve) { return cost(curve); });
  for (const Curve& curve : all)
    if (free(curve)) return curve;
  return std::nullopt;
}

std::optional<Curve> CarSpace::detour(const std::vector<Pose>& from, const Pose& to, DetourEffort& effort,
                                      const Context& context) const {
  return search_ == DetourSearch::ompl ? ompl_search(*this, from, to, effort, context)
                                       : lattice_search(*this, from, to, effort, context);
}

bool CarSpace::can_go_on(const Pose& from, double metres) const {
  if (reverse_ || metres <= 0) return true;  // in reverse: it came from somewhere
  const double length = kPi / 2 * radius_;
  for (const Steering steering : {Steering::straight, Steering::left, Steering::right}) {
    const CurvePiece piece{steering, length};
    if (free(from, piece) && can_go_on(after(from, piece, radius_), metres - length)) return true;
  }
  return false;
}

}  // namespace oxturn
