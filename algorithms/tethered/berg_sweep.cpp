#include "algorithms/tethered/berg_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/math.hpp"

namespace oxturn {

namespace {

constexpr double kGrownEnough = 1.25;  // items, over those in order: then all are put in order
constexpr double kFineTurn = 0.25;     // radians from sample to sample: what lies between two is then empty if both are

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

BergSweep::BergSweep(const BergBoundary& boundary, double spacing, BergThinning thinning, BergTrim trim,
                     std::function<bool(const Point&)> keep)
    : b_(boundary),
      spacing_(spacing),
      thinning_(std::move(thinning)),
      trim_(std::move(trim)),
      keep_(std::move(keep)),
      empty_(boundary.nodes_.size()),
      items_{{kNone, kNone, kNone}},
      first_arc_(boundary.nodes_.size(), kNone) {
  for (std::size_t v = 0; v < b_.events_.size(); ++v)
    for (std::size_t i = 0; i < b_.events_[v].size(); ++i) {
      const BergBoundary::Event& e = b_.events_[v][i];
      activations_.push_back({e.is_divider ? b_.dividers_[e.index].length : b_.nodes_[e.index].before,
                              static_cast<std::int32_t>(v), static_cast<std::int32_t>(i)});
    }
  std::sort(activations_.begin(), activations_.end(), [](const Activation& a, const Activation& b) {
    return std::tuple(a.length, a.node, a.event) < std::tuple(b.length, b.node, b.event);
  });
  items_.front().next = add_arcs_of(0);
}

/// The node's whole sector.
std::int32_t BergSweep::add_arcs_of(std::int32_t node) {
  const auto v = static_cast<std::size_t>(node);
  const auto arc = static_cast<std::int32_t>(items_.size());
  Item whole{node, kNone, static_cast<std::int32_t>(b_.events_[v].size())};
  whole.reach = b_.nodes_[v].before + b_.nodes_[v].reach + b_.tolerance_;
  items_.push_back(whole);
  return first_arc_[v] = arc;
}

/// Splits the node's arc at the event, and puts what is new in between.
void BergSweep::activate(const Activation& a) {
  std::int32_t arc = first_arc_[static_cast<std::size_t>(a.node)];
  while (item(arc).end < a.event) arc = item(arc).sibling;
  const BergBoundary::Event& e = b_.events_[static_cast<std::size_t>(a.node)][static_cast<std::size_t>(a.event)];
  const auto rest = static_cast<std::int32_t>(items_.size());
  items_.push_back(
      {a.node, a.event, item(arc).end, item(arc).next, item(arc).sibling, item(arc).empty, item(arc).reach});
  std::int32_t between = rest + 1;
  if (e.is_divider)
    items_.push_back({kNone, static_cast<std::int32_t>(e.index), kNone});
  else
    between = add_arcs_of(static_cast<std::int32_t>(e.index));
  item(between).next = rest;
  item(arc).end = a.event;
  item(arc).sibling = rest;
  item(arc).next = between;
}

/// In the order of the list, those that have left it behind: each boundary walks the whole list, and what is scattered
/// in memory is slow to walk.
void BergSweep::renumber_items() {
  std::vector<std::int32_t> number(items_.size(), kNone);
  std::vector<Item> ordered;
  ordered.reserve(items_.size());
  const auto take = [&](std::int32_t i) {
    number[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(ordered.size());
    ordered.push_back(item(i));
  };
  for (std::int32_t i = 0; i != kNone; i = item(i).next) take(i);
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(items_.size()); ++i)
    if (number[static_cast<std::size_t>(i)] == kNone) take(i);
  const auto renumber = [&](std::int32_t& i) {
    if (i != kNone) i = number[static_cast<std::size_t>(i)];
  };
  for (Item& i : ordered) {
    renumber(i.next);
    renumber(i.sibling);
  }
  std::ranges::for_each(first_arc_, renumber);
  items_ = std::move(ordered);
  in_order_ = items_.size();
}

bool BergSweep::has_ended(const Item& arc) const {
  if (arc.node == kNone) return false;
  if (arc.empty && arc.end - arc.begin == 1) return true;  // and nothing will begin there
  return length_ > arc.reach;
}

void BergSweep::drop_ended_after(std::int32_t i) {
  while (item(i).next != kNone && has_ended(item(item(i).next))) item(i).next = item(item(i).next).next;
}

std::vector<BergBoundary::Piece> BergSweep::at(double length) {
  length_ = length;
  for (; active_ < activations_.size() && activations_[active_].length < length; ++active_)
    activate(activations_[active_]);
  if (static_cast<double>(items_.size()) > kGrownEnough * static_cast<double>(in_order_)) renumber_items();
  std::vector<BergBoundary::Piece> pieces(1);
  drop_ended_after(0);
  for (std::int32_t before = 0; item(before).next != kNone;) {
    const std::int32_t i = item(before).next;
    drop_ended_after(i);
    const Item here = item(i);
    if (here.node == kNone) {
      if (here.next != kNone && item(here.next).node == kNone) {  // nothing is between two dividers, nor will be
        item(before).next = here.next;
        continue;
      }
      pieces.push_back({static_cast<std::size_t>(here.begin), {}});
    } else if (!here.empty) {
      sample(item(i), pieces.back().points);
    }
    before = i;
  }
  close_round(pieces);
  return pieces;
}

/// The walk begins east of the anchor, not at a divider: what comes before the first divider belongs to the last piece.
void BergSweep::close_round(std::vector<BergBoundary::Piece>& pieces) const {
  if (pieces.size() > 1) {
    for (const Point& p : pieces.front().points) add(p, pieces.back().points);
    pieces.erase(pieces.begin());
  } else if (Polyline& round = pieces.front().points;
             round.size() > 1 && distance(round.front(), round.back()) <= b_.tolerance_) {
    round.pop_back();
  }
}

BergSweep::Steps BergSweep::steps_of(const Item& arc) const {
  const auto v = static_cast<std::size_t>(arc.node);
  const BergNode& node = b_.nodes_[v];
  const std::vector<BergBoundary::Event>& events = b_.events_[v];
  const bool begins = arc.begin == kNone, ends = static_cast<std::size_t>(arc.end) == events.size();
  const auto event = [&](std::int32_t i) -> const BergBoundary::Event& { return events[static_cast<std::size_t>(i)]; };
  Steps steps{.from = begins ? 0 : event(arc.begin).angle, .to = ends ? node.width : event(arc.end).angle};
  // The point straight behind a corner belongs to the side on which the line of sight passes the corner.
  const bool with_from = begins || event(arc.begin).side != HiddenSide::left;
  const bool with_to = ends || event(arc.end).side != HiddenSide::right;
  const double along = (length_ - node.before) * (steps.to - steps.from);
  steps.count = std::max(1.0, std::ceil(along / spacing_));
  steps.first = with_from ? 0 : 1;
  steps.last = along <= b_.tolerance_ && !(with_from && with_to) ? -1 : with_to ? steps.count : steps.count - 1;
  return steps;
}

void BergSweep::sample(Item& arc, Polyline& points) {
  const auto v = static_cast<std::size_t>(arc.node);
  const BergNode& node = b_.nodes_[v];
  const Steps steps = steps_of(arc);
  const double radius = length_ - node.before;
  const auto turn = [&](double k) { return steps.turn(k); };
  const auto at = [&](double k) -> Point {
    const double angle = node.begin + turn(k);
    return node.at + radius * Point(math::cos(angle), math::sin(angle));
  };
  const double stride = longest_stride(radius, turn(1) - turn(0));
  double attempt = 0;   // the first sample that may be reached by leaving others out
  bool driven = false;  // is the previous sample to be driven? Of others nothing more is asked, and they are not empty
  auto empty = empty_[v].cbegin();
  kept_.clear();
  for (double k = steps.first, previous = -1; k <= steps.last; ++k) {
    while (empty != empty_[v].cend() && empty->to < turn(k)) ++empty;
    if (empty != empty_[v].cend() && empty->from <= turn(k)) {
      k = std::max(k, steps.last_up_to(empty->to));
      continue;
    }
    if (const std::size_t slice = node.range.slice_of(turn(k)); node.range.range(slice) < radius) {
      k = std::max(k, steps.last_up_to(node.range.end_of(slice)) - 1);
      continue;
    }
    if (const double next = std::min(previous + stride, steps.last);
        driven && previous >= attempt && previous == k - 1 && next > k) {
      const Point p = at(next);
      if (radius < node.range.sure(turn(previous), turn(next)) && !is_trimmed(p) &&
          thinning_.is_free(points.back(), p)) {
        add(p, points);
        previous = k = kept_.back().last = next;
        continue;
      }
      attempt = next;
    }
    const SightRange::Answer answer = node.range.look(turn(k), radius);
    if (answer == SightRange::Answer::hidden) continue;
    const Point p = at(k);
    driven = !keep_ || keep_(p);
    if (driven && (is_trimmed(p) || (answer == SightRange::Answer::unknown && !b_.sight_.sees(node.at, p)))) continue;
    if (driven) add(p, points);
    if (previous < 0 || previous < k - 1) kept_.push_back({k, k});
    previous = kept_.back().last = k;
  }
  if (trim_.shortest && turn(1) - turn(0) <= kFineTurn) remember_empty(arc, steps);
}

/// What begins and ends with samples that were left out stays empty: farther out in the same direction points are
/// hidden, or nearer to the anchor by another path, as well.
void BergSweep::remember_empty(Item& arc, const Steps& steps) {
  if (kept_.empty()) {
    arc.empty = true;
    return;
  }
  std::vector<Angles>& known = empty_[static_cast<std::size_t>(arc.node)];
  const std::size_t before = known.size();
  const auto add = [&](double from, double to) {
    if (from < to) known.push_back({from, to});
  };
  add(steps.from, kept_.front().first > 0 ? steps.turn(kept_.front().first - 1) : steps.from);
  for (std::size_t i = 1; i < kept_.size(); ++i) add(steps.turn(kept_[i - 1].last + 1), steps.turn(kept_[i].first - 1));
  add(kept_.back().last < steps.count ? steps.turn(kept_.back().last + 1) : steps.to, steps.to);
  if (known.size() > before) unite(known);
}

/// In samples: 1, if none are to be left out.
double BergSweep::longest_stride(double radius, double turn_per_step) const {
  if (thinning_.error <= 0) return 1;
  const double turn = 2 * math::acos(std::clamp(1 - thinning_.error / radius, 0.0, 1.0));  // of a chord
  return std::max(1.0, std::floor(turn / turn_per_step));
}

void BergSweep::add(const Point& p, Polyline& points) const {
  if (points.empty() || distance(points.back(), p) > b_.tolerance_) points.push_back(p);
}

}  // namespace oxturn
