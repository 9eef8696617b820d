#include "algorithms/tethered/berg_node_samples.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kFineTurn = 0.25;  // radians from sample to sample: what lies between two is then empty if both are

/// Makes intervals ascending and disjoint.
template <class Angles>
void unite(std::vector<Angles>& intervals) {
  std::ranges::sort(intervals, {}, &Angles::from);
  std::size_t last = 0;
  for (std::size_t i = 1; i < intervals.size(); ++i)
    if (intervals[i].from <= intervals[last].to)
      intervals[last].to = std::max(intervals[last].to, intervals[i].to);
    else
      intervals[++last] = intervals[i];
  intervals.resize(last + 1);
}

}  // namespace

BergNodeSamples::BergNodeSamples(const BergBoundary& boundary, std::size_t node, const BergSampling& sampling,
                                 std::size_t first)
    : b_(boundary),
      node_(boundary.nodes_[node]),
      events_(boundary.events_[node]),
      sampling_(sampling),
      lap_(first),
      arcs_{{kNone, static_cast<std::int32_t>(events_.size())}} {
  for (std::size_t e = 0; e < events_.size(); ++e)
    waiting_.push_back({b_.length_of(events_[e]), static_cast<std::int32_t>(e)});
  std::ranges::sort(waiting_, std::greater<>(), [](const Waiting& w) { return std::pair(w.length, w.event); });
  sample_laps();
}

void BergNodeSamples::sample_laps() {
  sampled_.clear();
  points_.clear();
  next_ = taken_points_ = 0;
  std::vector<std::int32_t> met;
  for (const std::size_t end = lap_ + kAtOnce; lap_ < end && !has_ended(); ++lap_) {
    length_ = sampling_.lengths[lap_];
    radius_ = length_ - node_.before;
    for (met.clear(); !waiting_.empty() && waiting_.back().length < length_; waiting_.pop_back())
      met.push_back(waiting_.back().event);
    if (!met.empty()) split_arcs(met);
    for (Arc& arc : arcs_) {
      if (arc.empty) continue;
      sample(arc);
      sampled_.push_back({lap_, arc.begin, arc.empty, points_.size()});
    }
    std::erase_if(arcs_, [](const Arc& arc) { return arc.empty && arc.end - arc.begin == 1; });
  }
}

bool BergNodeSamples::has_ended() const {
  return lap_ == sampling_.lengths.count || arcs_.empty() || sampling_.lengths[lap_] > b_.reach_of(node_);
}

BergNodeSamples::Taken BergNodeSamples::take(std::size_t lap, std::int32_t begin) {
  if (next_ == sampled_.size()) sample_laps();
  if (next_ == sampled_.size() || sampled_[next_].lap != lap || sampled_[next_].begin != begin)
    throw std::logic_error("arcs of one of Berg's nodes are not taken in their order");
  const Sampled& arc = sampled_[next_++];
  const std::size_t from = std::exchange(taken_points_, arc.end);
  return {{points_.data() + from, points_.data() + arc.end}, arc.empty};
}

void BergNodeSamples::split_arcs(std::vector<std::int32_t>& events) {
  std::ranges::sort(events);
  std::vector<Arc> parts;
  parts.reserve(arcs_.size() + events.size());
  auto event = events.cbegin();
  for (const Arc& arc : arcs_) {
    parts.push_back(arc);
    for (; event != events.cend() && *event < arc.end; ++event) {
      parts.back().end = *event;
      parts.push_back({*event, arc.end, arc.empty});
    }
  }
  arcs_ = std::move(parts);
}

BergNodeSamples::Steps BergNodeSamples::steps_of(const Arc& arc) const {
  const bool begins = arc.begin == kNone, ends = static_cast<std::size_t>(arc.end) == events_.size();
  const auto event = [&](std::int32_t i) -> const BergBoundary::Event& { return events_[static_cast<std::size_t>(i)]; };
  Steps steps{.from = begins ? 0 : event(arc.begin).angle, .to = ends ? node_.width : event(arc.end).angle};
  // The point straight behind a corner belongs to the side on which the line of sight passes the corner.
  const bool with_from = begins || event(arc.begin).side != HiddenSide::left;
  const bool with_to = ends || event(arc.end).side != HiddenSide::right;
  const double along = radius_ * (steps.to - steps.from);
  steps.count = std::max(1.0, std::ceil(along / sampling_.spacing));
  steps.first = with_from ? 0 : 1;
  steps.last = along <= b_.tolerance_ && !(with_from && with_to) ? -1 : with_to ? steps.count : steps.count - 1;
  return steps;
}

bool BergNodeSamples::is_trimmed(const Point& p) const {
  return sampling_.trim.shortest && std::abs(length_ - sampling_.trim.shortest(p)) > sampling_.trim.slack;
}

void BergNodeSamples::sample(Arc& arc) {
  const Steps steps = steps_of(arc);
  const double stride = longest_stride(steps.turn(1) - steps.turn(0));
  Walk walk{.steps = steps, .stride = stride, .longest_leap = stride, .empty = empty_.cbegin()};
  kept_.clear();
  first_point_ = points_.size();
  double k = steps.first;
  while (k <= steps.last) k = look_at(k, walk) + 1;
  if (sampling_.trim.shortest && steps.turn(1) - steps.turn(0) <= kFineTurn) remember_empty(arc, steps);
}

/// Returns the number of the last sample that is dealt with.
double BergNodeSamples::look_at(double k, Walk& walk) {
  const double turn = walk.steps.turn(k);
  while (walk.empty != empty_.cend() && walk.empty->to < turn) ++walk.empty;
  if (walk.empty != empty_.cend() && walk.empty->from <= turn)
    return std::max(k, walk.steps.last_up_to(walk.empty->to));
  if (const std::size_t slice = node_.range.slice_of(turn); node_.range.range(slice) < radius_)
    return std::max(k, walk.steps.last_up_to(node_.range.end_of(slice)) - 1);
  if (walk.driven && walk.previous == k - 1)
    if (const double next = leap(walk); next > walk.previous) return walk.previous = kept_.back().last = next;
  walk.longest_leap = walk.stride;
  const Point towards = direction(turn);
  const SightRange::Answer answer = node_.range.look(turn, towards, radius_);
  if (answer == SightRange::Answer::hidden) return k;
  const Point p = node_.at + radius_ * towards;
  walk.driven = is_driven(p);
  if (walk.driven) {
    if (is_trimmed(p) || (answer == SightRange::Answer::unknown && !b_.sight_.sees(node_.at, p))) return k;
    add(p);
  }
  if (walk.previous < 0 || walk.previous < k - 1) kept_.push_back({k, k});
  return walk.previous = kept_.back().last = k;
}

/// Adds a sample after the next one, if those in between may be left out, and returns its number; else the previous
/// one.
double BergNodeSamples::leap(Walk& walk) {
  while (walk.longest_leap >= 2) {
    const double next = std::min(walk.previous + walk.longest_leap, walk.steps.last);
    if (next <= walk.previous + 1) break;
    if (leap_to(next, walk)) return next;
    walk.longest_leap = std::floor(walk.longest_leap / 2);
  }
  return walk.previous;
}

bool BergNodeSamples::leap_to(double next, const Walk& walk) {
  if (!(radius_ < node_.range.sure(walk.steps.turn(walk.previous), walk.steps.turn(next)))) return false;
  const Point p = at(walk.steps.turn(next));
  if (is_trimmed(p) || !sampling_.thinning.is_free(points_.back(), p)) return false;
  add(p);
  return true;
}

/// What begins and ends with samples that were left out stays empty: farther out in the same direction points are
/// hidden, or nearer to the anchor by another path, as well.
void BergNodeSamples::remember_empty(Arc& arc, const Steps& steps) {
  if (kept_.empty()) {
    arc.empty = true;
    return;
  }
  const std::size_t before = empty_.size();
  const auto add = [&](double from, double to) {
    if (from < to) empty_.push_back({from, to});
  };
  add(steps.from, kept_.front().first > 0 ? steps.turn(kept_.front().first - 1) : steps.from);
  for (std::size_t i = 1; i < kept_.size(); ++i) add(steps.turn(kept_[i - 1].last + 1), steps.turn(kept_[i].first - 1));
  add(kept_.back().last < steps.count ? steps.turn(kept_.back().last + 1) : steps.to, steps.to);
  if (empty_.size() > before) unite(empty_);
}

/// In samples: 1, if none are to be left out.
double BergNodeSamples::longest_stride(double turn_per_step) const {
  if (sampling_.thinning.error <= 0) return 1;
  const double turn = 2 * math::acos(std::clamp(1 - sampling_.thinning.error / radius_, 0.0, 1.0));  // of a chord
  return std::max(1.0, std::floor(turn / turn_per_step));
}

void BergNodeSamples::add(const Point& p) {
  if (points_.size() == first_point_ || distance(points_.back(), p) > b_.tolerance_) points_.push_back(p);
}

}  // namespace oxturn
