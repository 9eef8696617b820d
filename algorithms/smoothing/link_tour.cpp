#include "algorithms/smoothing/link_tour.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kBlocked = 1e6;  // metres; dearer than any detour, so that a tour with few blocked links is preferred
constexpr int kRounds = 12, kLeastRounds = 2;
constexpr std::uint64_t kStrokesOfRounds = 12000;    // strokes times rounds: a round is a tour and its links
constexpr std::uint64_t kLeastEffort = 100'000'000;  // connections looked at, 20 to 30 ns each
constexpr double kEffort = 2000;                     // more for each n log n
constexpr std::uint64_t kKicks = 20000;  // a fifth of a millisecond each; more do not pay where there are many strokes
constexpr std::size_t kReports = 8;      // in the first round
constexpr double kEntrySpacing = 2;      // radii, between points where a closed stroke may be entered
constexpr double kMostEntries = 12;
constexpr double kLeastCut = 1.6;  // radii
constexpr std::size_t kStartHeadings = 24;

/// A closed stroke from another point, a lap on. Short edges may belong to a sampled curve and are not cut.
Polyline rotated_lap(const Polyline& lap, double from, double radius) {
  std::size_t i = 1;
  while (i + 1 < lap.size() && distance(lap[i - 1], lap[i]) <= from) from -= distance(lap[i - 1], lap[i]), ++i;
  const double edge = distance(lap[i - 1], lap[i]);
  const bool cut = edge > kLeastCut * radius;
  const Point begin = cut ? lerp(lap[i - 1], lap[i], std::clamp(from / edge, 0.25, 0.75)) : lap[i];
  Polyline result{begin};
  const std::size_t n = lap.size() - 1;
  for (std::size_t k = 0; k < n; ++k)
    if (const Point& p = lap[(i + k) % n]; p != result.back()) result.push_back(p);
  if (result.back() != begin) result.push_back(begin);
  return result;
}

}  // namespace

LinkTour::LinkTour(const std::vector<Stroke>& strokes, const CarSpace& space, const Point& start, Context& context)
    : strokes_(strokes), space_(space), start_(start), context_(context), effort_(strokes.size()) {
  for (std::size_t s = 0; s < strokes.size(); ++s) add_passes(s);
  costs_.emplace(patterns(), [this](PatternId from, PatternId to) { return bound(from, to); });
}

std::uint64_t LinkTour::most_effort(std::size_t patterns) {
  const double n = static_cast<double>(patterns);
  return kLeastEffort + static_cast<std::uint64_t>(kEffort * n * math::log2(n + 1));
}

void LinkTour::add_passes(std::size_t stroke) {
  const Stroke& s = strokes_[stroke];
  const double whole = length(s.points);
  const double entries =
      s.closed ? std::clamp(std::round(whole / (kEntrySpacing * space_.radius())), 1.0, kMostEntries) : 1;
  for (double k = 0; k < entries; ++k)
    for (const bool backwards : {false, true}) {
      Pass pass{stroke, k / entries * whole, backwards, {}, {}};
      const Polyline line = points(pass);
      pass.entry = first_pose(line), pass.exit = last_pose(line);
      const auto p = static_cast<PatternId>(passes_.size() + 2);
      reverse_.push_back(backwards ? p - 1 : p + 1);
      passes_.push_back(pass);
    }
  counts_.push_back(static_cast<std::size_t>(2 * entries));
}

Polyline LinkTour::points(const Pass& pass) const {
  const Stroke& s = strokes_[pass.stroke];
  Polyline line = s.closed ? rotated_lap(s.points, pass.from, space_.radius()) : s.points;
  if (pass.backwards) std::ranges::reverse(line);
  return line;
}

double LinkTour::bound(PatternId from, PatternId to) const {
  if (from < 2 && to < 2) return 0;
  // Patterns 0 and 1: the tour begins at the start in the direction of pattern 0; it ends anywhere.
  if (to < 2) return to == 0 ? 0 : distance(start_, passes_[reverse_[from] - 2].entry.at);
  if (from < 2) return from == 1 ? 0 : distance(start_, passes_[to - 2].entry.at);
  if (passes_[from - 2].stroke == passes_[to - 2].stroke) return 0;
  return space_.least_length(passes_[from - 2].exit, passes_[to - 2].entry);
}

/// Curves grow with the distance of their ends: with many strokes, those near by are found by that.
std::vector<ConnectionCost::Ends> LinkTour::ends() const {
  std::vector<ConnectionCost::Ends> all(2, {start_, start_});
  for (const Pass& pass : passes_) all.push_back({pass.entry.at, pass.exit.at});
  return all;
}

bool LinkTour::learn(const TourProblem& problem, const Tour& tour) {
  bool new_one = false;
  const bool first = costs_->none_known();
  const std::size_t each = tour.size() / kReports + 1;
  for (std::size_t i = 0; i + 1 < tour.size() && !context_.cancelled(); ++i) {
    if (report_ && first && i > 0 && i % each == 0) report_(driven(problem, tour));
    const PatternId from = problem.pattern_of(tour[i]), to = problem.pattern_of(tour[i + 1]);
    if (costs_->known(from, to)) continue;
    const std::optional<Curve>& found = find(from, to);
    const double metres = found ? space_.cost(*found) : kBlocked;
    costs_->set(from, to, metres);
    costs_->set(reverse_[to], reverse_[from], metres);
    new_one = true;
  }
  if (report_ && new_one) report_(driven(problem, tour));
  return new_one;
}

std::vector<DrivenStroke> LinkTour::order() {
  if (strokes_.empty()) return {};
  const FunctionCost costs([this](PatternId from, PatternId to) { return (*costs_)(from, to); }, true,
                           costs_->tabulated() ? std::vector<ConnectionCost::Ends>{} : ends());
  const TourProblem problem(costs, counts_, reverse_);
  const std::uint64_t n = strokes_.size(), most = most_effort(patterns());
  std::uint64_t until = most / 2;  // the rest is for the rounds, in equal shares
  TourEffort effort{.kicks = std::max(kKicks, std::min(20 * n, kKicks + n))};
  effort.enough = [&] { return costs_->effort() >= until; };
  Tour tour = from_start(problem, solve_tour(problem, context_, effort));
  const int rounds = std::clamp(static_cast<int>(kStrokesOfRounds / n), kLeastRounds, kRounds);
  effort.kicks = std::min(20 * n, kKicks);
  for (int round = 0; round < rounds && learn(problem, tour) && costs_->effort() < most; ++round) {
    until = costs_->effort() + (most - costs_->effort()) / static_cast<std::uint64_t>(rounds - round);
    tour = from_start(problem, improved_tour(problem, tour, context_, effort));
  }
  return driven(problem, tour);
}

std::vector<DrivenStroke> LinkTour::driven(const TourProblem& problem, const Tour& tour) const {
  std::vector<DrivenStroke> result;
  for (std::size_t i = 1; i < tour.size(); ++i) {
    const PatternId pattern = problem.pattern_of(tour[i]);
    const Pass& pass = passes_[pattern - 2];
    result.push_back({pass.stroke, pattern, points(pass)});
  }
  return result;
}

/// A tour may come out the other direction: then it leaves from the start's second pattern.
Tour LinkTour::from_start(const TourProblem& problem, Tour tour) const {
  if (problem.pattern_of(tour.front()) == 0) return tour;
  for (TourStop& stop : tour) stop = problem.stop_of(reverse_[problem.pattern_of(stop)]);
  std::reverse(tour.begin() + 1, tour.end());
  return tour;
}

const std::optional<Curve>& LinkTour::link(const DrivenStroke* from, const DrivenStroke& to) {
  return find(from == nullptr ? 0 : from->pattern, to.pattern);
}

std::optional<Curve> LinkTour::known_link(const DrivenStroke* from, const DrivenStroke& to) const {
  const auto known = links_.find({from == nullptr ? 0 : from->pattern, to.pattern});
  return known == links_.end() ? std::nullopt : known->second;
}

const std::optional<Curve>& LinkTour::find(PatternId from, PatternId to) {
  const auto [known, fresh] = links_.try_emplace({from, to});
  const Pose& entry = passes_[to - 2].entry;
  if (fresh) known->second = from < 2 ? link_from_start(entry) : link_between(passes_[from - 2].exit, entry);
  return known->second;
}

std::optional<Curve> LinkTour::link_between(const Pose& from, const Pose& to) {
  if (auto simple = space_.simple_link(from, to)) return simple;
  return space_.detour({from}, to, effort_, context_);
}

std::optional<Curve> LinkTour::link_from_start(const Pose& to) {
  std::vector<Pose> poses;
  for (std::size_t k = 0; k < kStartHeadings; ++k)
    poses.push_back({start_, 2 * kPi * static_cast<double>(k) / static_cast<double>(kStartHeadings)});
  std::optional<Curve> best;
  for (const Pose& pose : poses)
    if (const Curve curve = dubins_curve(pose, to, space_.radius());
        (!best || curve.length() < best->length()) && space_.free(curve))
      best = curve;
  return best ? best : space_.detour(poses, to, effort_, context_);
}

}  // namespace oxturn
