#include "algorithms/drawing/priced_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "algorithms/drawing/few_orders.hpp"
#include "algorithms/drawing/order_moves.hpp"
#include "base/random.hpp"

namespace oxturn {
namespace {

constexpr int kMostRounds = 10;
constexpr int kMostRepeats = 3;           // of local search from one order
constexpr std::size_t kKicks = 300;       // divided by the number of elements
constexpr std::size_t kFew = 200;         // elements: with more the search begins with one order
constexpr double kConstantWeight = 1000;  // metres, of a connection over finished work
constexpr double kNoDifference = 1e-9;

}  // namespace

bool better(const DrivenOrder& a, const DrivenOrder& b) { return a.price() < b.price() - kNoDifference; }

ElementPieces pieces_of(const std::vector<DrawingElement>& elements) {
  ElementPieces all;
  for (const DrawingElement& e : elements) {
    all.first.push_back(all.pieces.size());
    for (const Leg& leg : e.legs)
      if (leg.tool) all.pieces.push_back({leg.points, leg.width / 2});
  }
  all.first.push_back(all.pieces.size());
  return all;
}

PricedOrder::PricedOrder(const std::vector<DrawingElement>& elements, const Point& start, FinishedRule rule,
                         TransitRouter& router, FinishedWork& work)
    : elements_(elements),
      start_(start),
      rule_(rule),
      router_(router),
      work_(work),
      first_piece_(pieces_of(elements).first) {}

Transit PricedOrder::transit(const Pose& from, const Pose& to) {
  return rule_ == FinishedRule::around ? router_.route(from, to) : router_.direct(from, to);
}

Transit PricedOrder::transit_to(const std::vector<ElementVisit>& order, std::size_t k) {
  const Pose entry = entry_pose(elements_[order[k].element], order[k]);
  if (k > 0) return transit(exit_pose(elements_[order[k - 1].element], order[k - 1]), entry);
  return rule_ == FinishedRule::around ? router_.route(start_, entry) : router_.direct(start_, entry);
}

/// Finishes the element's pieces in driving order. Transits inside a fill.
std::vector<Transit> PricedOrder::draw(const ElementVisit& visit) {
  const DrawingElement& element = elements_[visit.element];
  std::size_t piece = visit.backwards ? first_piece_[visit.element + 1] : first_piece_[visit.element];
  std::vector<Transit> inner;
  const std::vector<Leg> legs = oxturn::driven(element, visit);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    if (legs[k].tool)
      work_.finish(visit.backwards ? --piece : piece++);
    else if (is_transit(legs, k))
      inner.push_back(transit(last_heading(legs[k - 1].points), first_heading(legs[k + 1].points)));
  }
  return inner;
}

void PricedOrder::undo(const ElementVisit& visit) {
  for (std::size_t p = first_piece_[visit.element]; p < first_piece_[visit.element + 1]; ++p) work_.undo(p);
}

void PricedOrder::undo_all() {
  for (std::size_t piece = 0; piece < work_.pieces().size(); ++piece) work_.undo(piece);
}

void PricedOrder::append(DrivenOrder& order) {
  const std::size_t k = order.transits.size();
  order.transits.push_back(transit_to(order.order, k));
  order.inner.push_back(draw(order.order[k]));
  order.crossing_m += order.transits.back().crossing_m;
  order.length_m += order.transits.back().length_m;
  for (const Transit& t : order.inner.back()) order.crossing_m += t.crossing_m, order.length_m += t.length_m;
}

DrivenOrder PricedOrder::driven(const std::vector<ElementVisit>& order) {
  DrivenOrder result{order, {}, {}, 0, 0};
  undo_all();
  while (result.transits.size() < order.size()) append(result);
  return result;
}

void PricedOrder::raise(const DrivenOrder& order, DrawingTour& tour) {
  for (std::size_t k = 0; k < order.order.size(); ++k) {
    const Transit& t = order.transits[k];
    const bool crosses = t.crossing_m > 0;
    const double price = rule_ == FinishedRule::weight ? t.length_m + (crosses ? kConstantWeight : 0) : t.price();
    if (rule_ == FinishedRule::weight ? !crosses
                                      : price <= distance(t.path.front(), t.path.back()) * (1 + kNoDifference))
      continue;
    tour.raise(k == 0 ? nullptr : &order.order[k - 1], order.order[k], price);
  }
}

std::vector<ElementVisit> PricedOrder::backwards(std::vector<ElementVisit> order) const {
  std::ranges::reverse(order);
  for (ElementVisit& visit : order)
    if (!elements_[visit.element].closed) visit.backwards = !visit.backwards;
  return order;
}

/// Whether there is time for more than one local search; curves cost far more than straight transits.
bool PricedOrder::is_cheap() const {
  return elements_.size() <= kFew && !(router_.radius() > 0) && !router_.exhausted();
}

/// The best order, the last one, and the best one backwards: it costs as much without, but not with finished work.
std::vector<DrivenOrder> PricedOrder::starts(const DrivenOrder& best, const DrivenOrder& last,
                                             const DrawingTour& tour) {
  std::vector<DrivenOrder> all{best};
  if (!is_cheap()) return all;
  if (last.order != best.order) all.push_back(last);
  if (const std::vector<ElementVisit> turned = backwards(best.order); tour.allows(turned))
    all.push_back(driven(turned));
  return all;
}

DrivenOrder PricedOrder::improved(const DrivenOrder& from, const DrawingTour& tour, const Context& context) {
  OrderMoves moves(elements_, start_, tour, router_.radius(), router_, work_, first_piece_);
  return driven(moves.improved(from, context));
}

/// Iterated local search: some consecutive elements of the best order are driven elsewhere, perhaps backwards.
DrivenOrder PricedOrder::with_kicks(DrivenOrder best, const DrawingTour& tour, const Context& context) {
  const std::size_t n = elements_.size();
  if (n < 3) return best;
  Rng rng(context.seed());
  for (std::size_t kick = 0; kick < kKicks / n && is_cheap() && !context.cancelled(); ++kick) {
    std::vector<ElementVisit> order = best.order;
    const std::size_t length = 1 + rng.below(std::max<std::size_t>(n / 2, 1)), from = rng.below(n - length + 1);
    const auto first = order.begin() + static_cast<std::ptrdiff_t>(from);
    std::vector<ElementVisit> run(first, first + static_cast<std::ptrdiff_t>(length));
    order.erase(first, first + static_cast<std::ptrdiff_t>(length));
    if (rng.chance(0.5)) run = backwards(std::move(run));
    order.insert(order.begin() + static_cast<std::ptrdiff_t>(rng.below(order.size() + 1)), run.begin(), run.end());
    if (!tour.allows(order)) continue;
    const DrivenOrder moved = improved(driven(order), tour, context);
    if (better(moved, best)) best = moved;
  }
  return best;
}

DrivenOrder PricedOrder::search(DrawingTour& tour, Context& context) {
  const std::vector<ElementVisit> first = tour.solve(context);
  straight_m_ = tour.cost(first);
  DrivenOrder at = driven(first), best = at;
  for (int round = 0;
       round < kMostRounds && rule_ != FinishedRule::ignore && !context.cancelled() && !router_.exhausted(); ++round) {
    raise(at, tour);
    std::vector<ElementVisit> order = tour.improve(at.order, context);
    if (order == at.order) break;
    at = driven(order);
    if (better(at, best)) best = at;
  }
  if (rule_ != FinishedRule::around || context.cancelled()) return best;
  for (DrivenOrder start : starts(best, at, tour))
    for (int round = 0; round < kMostRepeats && !context.cancelled(); ++round) {
      const DrivenOrder moved = improved(start, tour, context);
      if (!better(moved, best)) break;
      best = moved;
      if (!is_cheap()) break;
      raise(best, tour);
      start = driven(tour.improve(best.order, context));
    }
  if (is_cheap() && elements_.size() <= FewOrders::kMostElements)
    return FewOrders(elements_, start_, tour, *this).search(best, context);
  return with_kicks(std::move(best), tour, context);
}

}  // namespace oxturn
