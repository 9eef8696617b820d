#include "algorithms/tethered/berg_sweep.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace oxturn {

namespace {

constexpr double kGrownEnough = 1.25;  // items, over those in order: then all are put in order
constexpr std::size_t kFewItems = 1000;

}  // namespace

BergSweep::BergSweep(const BergBoundary& boundary, BergSampling sampling)
    : b_(boundary),
      sampling_(std::move(sampling)),
      samples_(boundary.nodes_.size()),
      items_{{kNone, kNone, kNone}},
      first_arc_(boundary.nodes_.size(), kNone) {
  for (std::size_t v = 0; v < b_.events_.size(); ++v)
    for (std::size_t i = 0; i < b_.events_[v].size(); ++i)
      activations_.push_back(
          {b_.length_of(b_.events_[v][i]), static_cast<std::int32_t>(v), static_cast<std::int32_t>(i)});
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
  whole.reach = b_.reach_of(b_.nodes_[v]);
  items_.push_back(whole);
  return first_arc_[v] = arc;
}

/// Splits the node's arc at the event, and puts what is new in between. The arc is in the list: it has not ended before
/// its last event.
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

/// Stores the items in the order of the list, without those that have left it: each boundary walks the whole list, and
/// what is scattered in memory is slow to walk. A node's arcs follow one another in the list by event.
void BergSweep::put_in_order() {
  std::vector<Item> ordered;
  std::vector<std::int32_t> last_arc(first_arc_.size(), kNone);  // by node
  for (std::int32_t i = 0; i != kNone; i = item(i).next) {
    const auto number = static_cast<std::int32_t>(ordered.size());
    ordered.push_back(item(i));
    ordered.back().next = item(i).next == kNone ? kNone : number + 1;
    ordered.back().sibling = kNone;
    if (item(i).node == kNone) continue;
    const auto v = static_cast<std::size_t>(item(i).node);
    (last_arc[v] == kNone ? first_arc_[v] : ordered[static_cast<std::size_t>(last_arc[v])].sibling) = number;
    last_arc[v] = number;
  }
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

std::vector<BergBoundary::Piece> BergSweep::next() {
  length_ = sampling_.lengths[lap_];
  for (; active_ < activations_.size() && activations_[active_].length < length_; ++active_)
    activate(activations_[active_]);
  if (static_cast<double>(items_.size()) > kGrownEnough * static_cast<double>(in_order_ + kFewItems)) put_in_order();
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
      add_samples(item(i), pieces.back().points);
    }
    before = i;
  }
  close_round(pieces);
  ++lap_;
  return pieces;
}

void BergSweep::add_samples(Item& arc, Polyline& points) {
  const auto v = static_cast<std::size_t>(arc.node);
  if (!samples_[v]) samples_[v] = std::make_unique<BergNodeSamples>(b_, v, sampling_, lap_);
  const BergNodeSamples::Taken taken = samples_[v]->take(lap_, arc.begin);
  for (const Point& p : taken.points) add(p, points);
  arc.empty = taken.empty;
  if (samples_[v]->all_taken()) samples_[v].reset();
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

void BergSweep::add(const Point& p, Polyline& points) const {
  if (points.empty() || distance(points.back(), p) > b_.tolerance_) points.push_back(p);
}

}  // namespace oxturn
