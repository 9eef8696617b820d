#include "algorithms/smoothing/car_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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

/// Between poses moved by `out` and `in`.
void add_curves(const Pose& from, double out, const Pose& to, double in, double radius, bool reverse,
                std::vector<Curve>& all) {
  const Curve first = straight(from, out, radius), last = straight(ahead(to, -in), in, radius);
  const auto add = [&](const Curve& middle) { all.push_back(joined(joined(first, middle), last)); };
  if (reverse) add(reeds_shepp_curve(first.to, last.from, radius));
  for (const Curve& word : dubins_words(first.to, last.from, radius)) add(word);
}

/// Metres out and in, none first.
std::vector<std::pair<double, double>> shifts(double radius, bool reverse) {
  std::vector<double> each;
  for (const double shift : kShifts) {
    each.push_back(shift * radius);
    if (reverse && shift > 0) each.push_back(-shift * radius);
  }
  std::vector<std::pair<double, double>> all;
  for (const double out : each)
    for (const double in : each) all.push_back({out, in});
  return all;
}

}  // namespace

std::vector<Curve> link_curves(const Pose& from, const Pose& to, double radius, bool reverse) {
  std::vector<Curve> all;
  for (const auto& [out, in] : shifts(radius, reverse)) add_curves(from, out, to, in, radius, reverse, all);
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
  return reverse_ ? reeds_shepp_curve(from, to, radius_).length() : dubins_distance(from, to, radius_);
}

Polyline CarSpace::shortest_path(const Point& from, const Point& to) const {
  if (problem_ == nullptr) return {};
  return problem_->transit().path(from, to).value_or(Polyline{});
}

double CarSpace::cost(const Curve& curve) const {
  return curve.length() + stop_cost_ * static_cast<double>(curve.cusps());
}

/// The cheapest free curve that costs less than `most`.
std::optional<Curve> CarSpace::cheapest_free(std::vector<Curve> curves, double most) const {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < curves.size(); ++i)
    if (const double metres = cost(curves[i]); metres < most) order.push_back({metres, i});
  std::ranges::sort(order);
  for (const auto& [metres, i] : order)
    if (free(curves[i])) return std::move(curves[i]);
  return std::nullopt;
}

std::optional<Curve> CarSpace::simple_link(const Pose& from, const Pose& to) const {
  std::vector<Curve> curves;
  add_curves(from, 0, to, 0, radius_, reverse_, curves);
  double least = std::numeric_limits<double>::infinity();
  for (const Curve& curve : curves) least = std::min(least, curve.length());
  std::optional<Curve> best = cheapest_free(std::move(curves), std::numeric_limits<double>::infinity());
  const double most = best ? cost(*best) : std::numeric_limits<double>::infinity();
  if (most <= least) return best;
  curves.clear();
  for (const auto& [out, in] : shifts(radius_, reverse_))
    if ((out != 0 || in != 0) && std::abs(out) + std::abs(in) < most)
      add_curves(from, out, to, in, radius_, reverse_, curves);
  if (auto shifted = cheapest_free(std::move(curves), most)) return shifted;
  return best;
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
