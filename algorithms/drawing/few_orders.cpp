#include "algorithms/drawing/few_orders.hpp"

#include <algorithm>

namespace oxturn {
namespace {

constexpr std::size_t kMostTransits = 6000;
constexpr std::size_t kMostEntries = 8;  // of a closed stroke that are tried
constexpr double kGain = 1e-9;           // metres

std::vector<ElementVisit> visits_of(const std::vector<DrawingElement>& elements, std::size_t e) {
  const DrawingElement& element = elements[e];
  std::vector<ElementVisit> visits;
  if (element.closed) {
    const std::size_t step = (element.entries.size() + kMostEntries - 1) / kMostEntries;
    for (std::size_t k = 0; k < element.entries.size(); k += step) visits.push_back({e, element.entries[k], false});
    return visits;
  }
  visits.push_back({e, 0, false});
  if (!element.one_way) visits.push_back({e, 0, true});
  return visits;
}

}  // namespace

FewOrders::FewOrders(const std::vector<DrawingElement>& elements, const Point& start, const DrawingTour& tour,
                     PricedOrder& priced)
    : elements_(elements),
      start_(start),
      tour_(tour),
      priced_(priced),
      least_(elements.size(), std::numeric_limits<double>::infinity()),
      drawn_(elements.size(), false) {
  for (std::size_t e = 0; e < elements.size(); ++e)
    for (const ElementVisit& to : visits_of(elements, e)) {
      const Point entry = entry_of(elements[e], to);
      least_[e] = std::min(least_[e], distance(start, entry));
      for (std::size_t f = 0; f < elements.size(); ++f)
        for (const ElementVisit& from : visits_of(elements, f))
          if (e != f) least_[e] = std::min(least_[e], distance(exit_of(elements[f], from), entry));
    }
}

double FewOrders::still_to_come() const {
  double sum = 0;
  for (std::size_t e = 0; e < elements_.size(); ++e)
    if (!drawn_[e]) sum += least_[e];
  return sum;
}

/// Containment; all other demands are asked of complete orders.
bool FewOrders::may_come(const ElementVisit& visit) const {
  const TourDemands& demands = tour_.demands();
  return demands.containment == Containment::literal || std::ranges::none_of(demands.contained, [&](const auto& pair) {
           return pair.first == visit.element && !drawn_[pair.second];
         });
}

std::vector<FewOrders::Step> FewOrders::next_steps() const {
  const Point at = at_.order.empty() ? start_ : exit_of(elements_[at_.order.back().element], at_.order.back());
  std::vector<Step> steps;
  for (std::size_t e = 0; e < elements_.size(); ++e)
    for (const ElementVisit& visit : visits_of(elements_, e))
      if (!drawn_[e] && may_come(visit)) steps.push_back({distance(at, entry_of(elements_[e], visit)), visit});
  std::ranges::stable_sort(steps, {}, &Step::bound);
  return steps;
}

void FewOrders::append(const Context& context) {
  if (at_.order.size() == elements_.size()) {
    if (tour_.allows(at_.order)) best_ = at_;
    return;
  }
  for (const Step& step : next_steps()) {
    if (budget_ == 0 || context.cancelled()) return;
    const std::size_t e = step.visit.element;
    const double rest = still_to_come() - least_[e];
    if (at_.price() + step.bound + rest >= best_.price() - kGain) continue;
    const DrivenOrder before = at_;
    at_.order.push_back(step.visit);
    priced_.append(at_);
    drawn_[e] = true;
    budget_ -= std::min(budget_, 1 + at_.inner.back().size());
    if (at_.price() + rest < best_.price() - kGain) append(context);
    drawn_[e] = false;
    priced_.undo(step.visit);
    at_ = before;
  }
}

DrivenOrder FewOrders::search(const DrivenOrder& best, const Context& context) {
  best_ = best;
  at_ = {};
  budget_ = kMostTransits;
  priced_.undo_all();
  append(context);
  return best_;
}

}  // namespace oxturn
