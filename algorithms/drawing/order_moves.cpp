#include "algorithms/drawing/order_moves.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "algorithms/drawing/priced_order.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kReach = 50;            // positions
constexpr std::size_t kTransitsEach = 40;     // priced for each element of the drawing, and at least
constexpr std::size_t kLeastTransits = 4000;  // so many
constexpr std::size_t kNext = 3;              // positions after a curve that what it crosses may move to
constexpr int kMostRounds = 20;
constexpr double kSmoothCost = 2;  // times as much as a transit with bends
constexpr double kGain = 1e-9;     // metres
constexpr double kDear = 1.25;     // of its bound: what a smooth transit costs at least to be looked at

}  // namespace

OrderMoves::OrderMoves(const std::vector<DrawingElement>& elements, const Point& start, const DrawingTour& tour,
                       double radius, TransitRouter& router, FinishedWork& work,
                       const std::vector<std::size_t>& first_piece)
    : elements_(elements),
      start_(start),
      tour_(tour),
      radius_(radius),
      router_(router),
      work_(work),
      first_piece_(first_piece) {}

Point OrderMoves::exit_before(const Order& order, std::size_t k) const {
  return k == 0 ? start_ : exit_of(elements_[order[k - 1].element], order[k - 1]);
}

Transit OrderMoves::transit_to(const Order& order, std::size_t k) {
  const Pose entry = entry_pose(elements_[order[k].element], order[k]);
  if (k == 0) return router_.route(start_, entry);
  return router_.route(exit_pose(elements_[order[k - 1].element], order[k - 1]), entry);
}

double OrderMoves::bound(const Order& order, std::size_t k) const {
  const DrawingElement& to = elements_[order[k].element];
  if (k == 0 || !(radius_ > 0)) return distance(exit_before(order, k), entry_of(to, order[k]));
  return dubins_curve(exit_pose(elements_[order[k - 1].element], order[k - 1]), entry_pose(to, order[k]), radius_)
      .length();
}

void OrderMoves::set_finished(const ElementVisit& visit, bool finished) {
  for (std::size_t p = first_piece_[visit.element]; p < first_piece_[visit.element + 1]; ++p)
    finished ? work_.finish(p) : work_.undo(p);
}

void OrderMoves::finish_before(std::size_t k) {
  while (finished_ > k) set_finished(order_[--finished_], false);
  while (finished_ < k) set_finished(order_[finished_++], true);
}

ElementVisit OrderMoves::turned(ElementVisit visit) const {
  if (!elements_[visit.element].closed) visit.backwards = !visit.backwards;
  return visit;
}

double OrderMoves::price(const Order& order, std::size_t low, std::size_t high, double most,
                         std::vector<double>& prices) {
  const std::size_t end = std::min(high + 2, order.size());
  double sum = 0;
  for (std::size_t k = low; k < end; ++k) sum += bound(order, k);
  finish_before(low);
  prices.clear();
  std::size_t k = low;
  for (; k < end && sum < most; ++k) {
    const double least = bound(order, k);
    prices.push_back(transit_to(order, k).price());
    sum += prices.back() - least;
    budget_ = router_.exhausted() ? 0 : budget_ - (budget_ > 0);
    set_finished(order[k], true);
  }
  for (std::size_t done = low; done < k; ++done) set_finished(order[done], false);
  return sum < most ? sum : std::numeric_limits<double>::infinity();
}

bool OrderMoves::accept(const Move& move) {
  const std::size_t end = std::min(move.high + 2, order_.size());
  const double old = std::accumulate(prices_.begin() + static_cast<std::ptrdiff_t>(move.low),
                                     prices_.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
  Order order = order_;
  std::copy(move.block.begin(), move.block.end(), order.begin() + static_cast<std::ptrdiff_t>(move.low));
  double least = 0;
  for (std::size_t k = move.low; k < end; ++k) least += bound(order, k);
  if (least >= old - kGain || !tour_.allows(order)) return false;
  std::vector<double> prices;
  finish_before(move.low);
  if (!(price(order, move.low, move.high, old - kGain, prices) < old - kGain)) return false;
  order_ = std::move(order);
  std::copy(prices.begin(), prices.end(), prices_.begin() + static_cast<std::ptrdiff_t>(move.low));
  return true;
}

/// The element at k goes there, in either direction.
bool OrderMoves::try_moving(std::size_t k, std::size_t to) {
  for (const bool turn : {false, true}) {
    const ElementVisit moved = turn ? turned(order_[k]) : order_[k];
    if (moved == order_[k] && (to == k || turn)) continue;
    Move move{std::min(k, to), std::max(k, to), {}};
    move.block.assign(order_.begin() + static_cast<std::ptrdiff_t>(move.low),
                      order_.begin() + static_cast<std::ptrdiff_t>(move.high) + 1);
    move.block.erase(move.block.begin() + static_cast<std::ptrdiff_t>(k - move.low));
    move.block.insert(move.block.begin() + static_cast<std::ptrdiff_t>(to - move.low), moved);
    if (accept(move)) return true;
    if (budget_ == 0) return false;
  }
  return false;
}

/// The element at k goes elsewhere.
bool OrderMoves::try_moving(std::size_t k) {
  const std::size_t first = k - std::min(k, kReach), last = std::min(k + kReach, order_.size() - 1);
  for (std::size_t to = first; to <= last; ++to) {
    if (try_moving(k, to)) return true;
    if (budget_ == 0) return false;
  }
  // A closed stroke may be entered elsewhere.
  for (const std::size_t entry : elements_[order_[k].element].entries) {
    ElementVisit visit = order_[k];
    visit.entry = entry;
    if (visit != order_[k] && accept({k, k, {visit}})) return true;
    if (budget_ == 0) return false;
  }
  return false;
}

/// The elements from k on, or those before k, are driven in the opposite order.
bool OrderMoves::try_turning(std::size_t k) {
  const auto turn = [&](std::size_t low, std::size_t high) {
    Move move{low, high, {}};
    for (std::size_t i = high + 1; i-- > low;) move.block.push_back(turned(order_[i]));
    return accept(move);
  };
  for (std::size_t n = 1; n < kReach && budget_ > 0; ++n) {
    if (k + n < order_.size() && turn(k, k + n)) return true;
    if (k > n && turn(k - 1 - n, k - 1)) return true;
  }
  return false;
}

/// What the curve to position k crosses is drawn after it, or the element on either side before it.
bool OrderMoves::try_passing(std::size_t k) {
  for (const std::size_t obstacle : obstacles(k)) {
    for (std::size_t to = k; to < std::min(k + kNext, order_.size()); ++to)
      if (budget_ == 0 || try_moving(obstacle, to)) return budget_ > 0;
    if (try_moving(k, obstacle) || (k > 0 && try_moving(k - 1, obstacle))) return true;
  }
  return false;
}

bool OrderMoves::improve_at(std::size_t k, const Context& context) {
  if (context.cancelled() || budget_ == 0) return false;
  if (radius_ > 0 && try_passing(k)) return true;
  if (try_moving(k) || (k > 0 && try_moving(k - 1)) || try_turning(k)) return true;
  for (const std::size_t obstacle : obstacles(k))
    if (budget_ > 0 && try_moving(obstacle)) return true;
  return false;
}

/// Positions of the elements that are in the way of the straight line to position k, or of a curve: they might be drawn
/// later.
std::vector<std::size_t> OrderMoves::obstacles(std::size_t k) {
  finish_before(k);
  std::vector<bool> in_the_way(elements_.size(), false);
  const Polyline line = radius_ > 0
                            ? transit_to(order_, k).path
                            : Polyline{exit_before(order_, k), entry_of(elements_[order_[k].element], order_[k])};
  for (const std::size_t piece : work_.crossed(line, 0)) {
    const auto after = std::upper_bound(first_piece_.begin(), first_piece_.end(), piece);
    in_the_way[static_cast<std::size_t>(after - first_piece_.begin()) - 1] = true;
  }
  std::vector<std::size_t> positions;
  for (std::size_t p = 0; p < k; ++p)
    if (in_the_way[order_[p].element]) positions.push_back(p);
  return positions;
}

std::vector<ElementVisit> OrderMoves::improved(const DrivenOrder& from, const Context& context) {
  order_ = from.order;
  budget_ = std::max(kLeastTransits, kTransitsEach * order_.size());
  if (radius_ > 0) budget_ = static_cast<std::size_t>(static_cast<double>(budget_) / kSmoothCost);
  const double dear = radius_ > 0 ? kDear : 1;
  prices_.clear();
  for (const Transit& t : from.transits) prices_.push_back(t.price());
  for (std::size_t piece = 0; piece < work_.pieces().size(); ++piece) work_.undo(piece);
  finished_ = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    bool changed = false;
    for (std::size_t k = 0; k < order_.size(); ++k)
      if (prices_[k] > dear * bound(order_, k) + kGain && improve_at(k, context)) changed = true;
    if (!changed || budget_ == 0 || context.cancelled()) break;
  }
  return order_;
}

}  // namespace oxturn
