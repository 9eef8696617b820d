#include "algorithms/drawing/smooth_transits.hpp"

#include <algorithm>
#include <limits>

#include "algorithms/smoothing/link_search.hpp"
#include "geometry/bends.hpp"

namespace oxturn {
namespace {

constexpr double kCoarse = 8;  // times kChordError: for tests against finished work
constexpr int kHeadings = 8;   // tried at a start
constexpr double kMostCurvature = 1.01;
constexpr std::size_t kMostLinks = 6000;  // some hundredths of a second each

/// A curve as one line, without its gears.
Polyline line_of(const Curve& curve, double chord_error) {
  Polyline points{curve.from.at};
  for (const Leg& leg : sampled(curve, chord_error, false))
    points.insert(points.end(), leg.points.begin() + 1, leg.points.end());
  return points;
}

/// The direction of a path's bend at k: half way between those of its two segments.
double heading_at(const Polyline& path, std::size_t k) {
  const double before = heading(path[k - 1], path[k]), after = heading(path[k], path[k + 1]);
  return before + std::remainder(after - before, 2 * kPi) / 2;
}

}  // namespace

SmoothTransits::SmoothTransits(const Problem& problem, const FinishedWork& work, const Options& options)
    : problem_(problem), work_(work), options_(options), chord_error_(kChordError * problem.robot().tool_width) {}

bool SmoothTransits::stays_inside(const Polyline& path) const {
  for (std::size_t k = 1; k < path.size(); ++k)
    if (!problem_.walls().contains(path[k - 1], path[k])) return false;
  return true;
}

bool SmoothTransits::allowed(const SmoothCurve& curve, Clear clear) const {
  const double keep_off = clear == Clear::near_work ? options_.keep_off : 0;
  return (clear == Clear::walls || work_.clear(sampled(curve, kCoarse * chord_error_), keep_off)) &&
         stays_inside(sampled(curve, chord_error_));
}

/// Where the curves that it is made of meet, or nearly turn round.
bool SmoothTransits::bends_too_sharply(const Polyline& path) const {
  const std::vector<Bend> all = bends({{{false, path}}}, problem_.tolerance(), problem_.robot().tool_width);
  return std::ranges::any_of(all, [&](const Bend& bend) { return too_sharp(bend, options_.radius); });
}

std::optional<Polyline> SmoothTransits::one(const Pose& from, const Pose& to, Clear clear) const {
  if (from.at == to.at && std::remainder(from.heading - to.heading, 2 * kPi) == 0) return Polyline{from.at, to.at};
  ConnectionOptions options{.radius = options_.radius, .first = options_.first};
  if (from.at == to.at) options.first = ConnectionKind::dubins;  // the shortest loop
  options.allowed = [&](const SmoothCurve& curve) { return allowed(curve, clear); };
  const Connection c = smooth_connection(from, to, options);
  if (!c.allowed) return std::nullopt;
  return sampled(c.curve, chord_error_);
}

/// nullopt also if all links are spent.
std::optional<Polyline> SmoothTransits::least_crossing(const Pose& from, const Pose& to) const {
  if (links_ >= kMostLinks) return std::nullopt;
  ++links_;
  std::vector<Curve> all = link_curves(from, to, options_.radius, false);
  std::ranges::stable_sort(all, {}, &Curve::length);
  const Curve* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Curve& curve : all) {
    if (curve.length() >= least) break;
    const Polyline path = line_of(curve, kCoarse * chord_error_);
    const double price = curve.length() + kCrossingWeight * work_.crossing_m(path);
    if (price < least && stays_inside(line_of(curve, chord_error_))) least = price, best = &curve;
  }
  if (best == nullptr) return std::nullopt;
  return line_of(*best, chord_error_);
}

std::optional<Polyline> SmoothTransits::along(const Pose& from, const Pose& to, const Polyline& round) const {
  Polyline path{from.at};
  Pose at = from;
  for (std::size_t k = 1; k < round.size(); ++k) {
    const bool last = k + 1 == round.size();
    if (!last && distance(round[k], at.at) < options_.radius) continue;  // too near for a curve of its own
    const Pose next = last ? to : Pose{round[k], heading_at(round, k)};
    const Connection c = smooth_connection(at, next, {.radius = options_.radius, .first = options_.first});
    const Polyline piece = sampled(c.curve, chord_error_);
    if (!piece.empty()) path.insert(path.end(), piece.begin() + 1, piece.end());
    at = next;
  }
  if (!stays_inside(path) || !work_.clear(path, 0) || bends_too_sharply(path)) return std::nullopt;
  return path;
}

std::optional<Polyline> SmoothTransits::by_lattice(const Pose& from, const Pose& to) const {
  if (!(problem_.robot().min_turn_radius > 0)) return std::nullopt;
  const Key key{from.at.x(), from.at.y(), from.heading, to.at.x(), to.at.y(), to.heading};
  const auto known = by_lattice_.find(key);
  if (known != by_lattice_.end()) return known->second;
  std::optional<Polyline>& path = by_lattice_[key];
  const std::optional<Curve> curve = CarSpace(problem_).detour({from}, to, effort_, Context());
  if (curve && curve->cusps() == 0) path = line_of(*curve, chord_error_);
  return path;
}

SmoothTransit SmoothTransits::find(const Pose& from, const Pose& to, const Polyline& round) const {
  if (options_.literal) {
    const Connection c = smooth_connection(from, to, {.radius = options_.radius, .rule = SpiroRule::literal});
    return {sampled(c.curve, chord_error_), c.curvature <= kMostCurvature / options_.radius};
  }
  if (options_.avoid) {
    for (const Clear clear : {Clear::near_work, Clear::work})
      if (auto path = one(from, to, clear)) return {std::move(*path)};
    if (round.size() > 2)
      if (auto path = along(from, to, round)) return {std::move(*path)};
    if (auto path = least_crossing(from, to)) return {std::move(*path)};
  }
  if (auto path = one(from, to, Clear::walls)) return {std::move(*path)};
  if (auto path = by_lattice(from, to)) return {std::move(*path)};
  return {round, false};
}

SmoothTransit SmoothTransits::find(const Point& from, const Pose& to, const Polyline& round) const {
  std::optional<SmoothTransit> best;
  const double first = round.size() > 1 ? heading(round[0], round[1]) : to.heading;
  for (int k = 0; k < kHeadings; ++k) {
    SmoothTransit t = find(Pose{from, first + 2 * kPi * k / kHeadings}, to, round);
    const auto cost = [&](const SmoothTransit& s) {
      return std::pair(!s.keeps_radius, length(s.path) + kCrossingWeight * work_.crossing_m(s.path));
    };
    if (!best || cost(t) < cost(*best)) best = std::move(t);
  }
  return *best;
}

}  // namespace oxturn
