#include "algorithms/drawing/priced_order.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

#include "algorithms/drawing/order_moves.hpp"

namespace oxturn {
namespace {

constexpr int kMostRounds = 10;
constexpr int kMostRepeats = 3;           // of local search from one order
constexpr std::size_t kFew = 200;         // elements: with more the search begins with one order
constexpr double kConstantWeight = 1000;  // metres, of a connection over finished work
constexpr double kNoDifference = 1e-9;

}  // namespace

bool better(const DrivenOrder& a, const DrivenOrder& b) {
  if (std::abs(a.crossing_m - b.crossing_m) > kNoDifference) return a.crossing_m < b.crossing_m;
  return a.length_m < b.length_m - kNoDifference;
}

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

DrivenOrder PricedOrder::driven(const std::vector<ElementVisit>& order) {
  DrivenOrder result{order, {}, {}, 0, 0};
  for (std::size_t piece = 0; piece < work_.pieces().size(); ++piece) work_.undo(piece);
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.transits.push_back(transit_to(order, k));
    result.inner.push_back(draw(order[k]));
    result.crossing_m += result.transits.back().crossing_m;
    result.length_m += result.transits.back().length_m;
    for (const Transit& t : result.inner.back()) result.crossing_m += t.crossing_m, result.length_m += t.length_m;
  }
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
  std::vector<ElementVisit> backwards(best.order.rbegin(), best.order.rend());
  for (ElementVisit& visit : backwards)
    if (!elements_[visit.element].closed) visit.backwards = !visit.backwards;
  if (tour.allows(backwards)) all.push_back(driven(backwards));
  return all;
}

DrivenOrder PricedOrder::search(DrawingTour& tour, Context& context) {
  DrivenOrder at = driven(tour.solve(context)), best = at;
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
      OrderMoves moves(elements_, start_, tour, router_.radius(), router_, work_, first_piece_);
      const DrivenOrder moved = driven(moves.improved(start, context));
      if (!better(moved, best)) break;
      best = moved;
      if (!is_cheap()) break;
      raise(best, tour);
      start = driven(tour.improve(best.order, context));
    }
  return best;
}

}  // namespace oxturn
