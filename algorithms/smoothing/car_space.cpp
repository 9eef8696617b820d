#include "algorithms/smoothing/car_space.hpp"

#include <algorithm>

#include "algorithms/smoothing/link_search.hpp"
#include "base/math.hpp"
#include "geometry/point_outside.hpp"

namespace oxturn {
namespace {

/// Of an arc: so long that it leaves the chord by the error.
double chord_length(double radius, double error) { return 2 * radius * math::acos(std::max(0.0, 1 - error / radius)); }

}  // namespace

CarSpace::CarSpace(const Problem& problem, DetourSearch search)
    : problem_(&problem),
      walls_(problem.walls()),
      bounds_(bounding_box(problem.configuration_space())),
      search_(search),
      radius_(problem.robot().min_turn_radius),
      chord_error_(kChordError * problem.robot().tool_width),
      chord_(chord_length(radius_, chord_error_)),
      tolerance_(problem.tolerance() / 2),
      stop_cost_(problem.robot().speed * problem.robot().speed / problem.robot().acceleration),
      reverse_(problem.robot().reverse) {}

CarSpace::CarSpace(const Problem& problem, const EdgeIndex& walls, const Box& bounds, double radius)
    : walls_(walls),
      bounds_(bounds),
      search_(DetourSearch::lattice),
      radius_(radius),
      chord_error_(kChordError * problem.robot().tool_width),
      chord_(chord_length(radius_, chord_error_)),
      tolerance_(problem.tolerance() / 2),
      stop_cost_(0),
      reverse_(false) {}

bool CarSpace::free(const Polyline& line) const {
  for (std::size_t i = 1; i < line.size(); ++i)
    if (!nearly_contains(walls_, line[i - 1], line[i], tolerance_)) return false;
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
  return reverse_ ? reeds_shepp_distance(from, to, radius_) : dubins_distance(from, to, radius_);
}

Polyline CarSpace::shortest_path(const Point& from, const Point& to) const {
  if (problem_ == nullptr) return {};
  return problem_->transit().path(from, to).value_or(Polyline{});
}

std::optional<Curve> CarSpace::simple_link(const Pose& from, const Pose& to, double most) const {
  return LinkSearch(*this, from, to).cheapest(most);
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
