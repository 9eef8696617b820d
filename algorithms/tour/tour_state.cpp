#include "algorithms/tour/tour_state.hpp"

#include <algorithm>

namespace oxturn {

TourState::TourState(const TourProblem& problem, const Tour& tour)
    : problem_(&problem), order_(tour.size()), position_(tour.size()), pattern_(tour.size()) {
  const auto depot = std::find_if(tour.begin(), tour.end(), [](const TourStop& s) { return s.element == 0; });
  const auto shift = static_cast<std::size_t>(depot - tour.begin());
  for (std::size_t i = 0; i < tour.size(); ++i) {
    const TourStop& stop = tour[(i + shift) % tour.size()];
    put(i, static_cast<ElementId>(stop.element));
    pattern_[stop.element] = problem.pattern_of(stop);
  }
}

bool TourState::reverse(std::size_t from, std::size_t count) {
  std::size_t other = wrap(from + count), others = size() - count;
  const bool anchored = problem_->has_precedence();
  if (anchored ? holds_depot(from, count) : count > others) {
    std::swap(from, other);
    std::swap(count, others);
  }
  if (anchored && !may_reverse(from, count)) return false;
  do_reverse(from, count);
  journal_.push_back({Kind::reverse, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(count), 0});
  return true;
}

bool TourState::swap_blocks(std::size_t from, std::size_t first, std::size_t second) {
  // Three blocks make the whole tour; whichever two are exchanged, the tour is the same.
  const std::size_t third = size() - first - second;
  const std::size_t middle = wrap(from + first), last = wrap(middle + second);
  const bool anchored = problem_->has_precedence();
  if (anchored ? holds_depot(from, first) : first >= std::max(second, third)) {
    from = middle, first = second, second = third;
  } else if (anchored ? holds_depot(middle, second) : second >= std::max(first, third)) {
    from = last, second = first, first = third;
  }
  if (anchored && !may_swap(from, first, second)) return false;
  do_swap(from, first, second);
  journal_.push_back({Kind::swap, static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(second),
                      static_cast<std::uint32_t>(first)});
  return true;
}

void TourState::set_pattern(ElementId e, PatternId p) {
  journal_.push_back({Kind::pattern, e, pattern_[e], 0});
  pattern_[e] = p;
}

void TourState::undo(std::size_t mark) {
  for (; journal_.size() > mark; journal_.pop_back()) {
    const Change& change = journal_.back();
    if (change.kind == Kind::reverse)
      do_reverse(change.a, change.b);
    else if (change.kind == Kind::swap)
      do_swap(change.a, change.b, change.c);
    else
      pattern_[change.a] = change.b;
  }
}

Tour TourState::tour() const {
  const bool backwards = problem_->has_direction() && pattern_[0] != problem_->first_pattern(0);
  Tour tour;
  for (std::size_t k = 0; k < size(); ++k) {
    const ElementId e = order_[(position_[0] + (backwards ? size() - k : k)) % size()];
    tour.push_back(problem_->stop_of(backwards ? problem_->reverse(pattern_[e]) : pattern_[e]));
  }
  return tour;
}

/// No element of the block may have to stay before another one of it. Direct requirements suffice: what is implied by
/// two of them leads through an element that lies between the others, so in the block.
bool TourState::may_reverse(std::size_t from, std::size_t count) const {
  for (std::size_t k = 0; k < count; ++k)
    for (const ElementId later : problem_->after(order_[from + k]))
      if (in_block(later, from, count)) return false;
  return true;
}

bool TourState::may_swap(std::size_t from, std::size_t first, std::size_t second) const {
  if (first <= second) {
    for (std::size_t k = 0; k < first; ++k)
      for (const ElementId later : problem_->after(order_[from + k]))
        if (in_block(later, from + first, second)) return false;
  } else {
    for (std::size_t k = 0; k < second; ++k)
      for (const ElementId sooner : problem_->before(order_[from + first + k]))
        if (in_block(sooner, from, first)) return false;
  }
  return true;
}

void TourState::do_reverse(std::size_t from, std::size_t count) {
  std::size_t i = from, j = (from + count + size() - 1) % size();
  for (std::size_t k = 0; k < count / 2; ++k) {
    const ElementId a = order_[i], b = order_[j];
    flip(a);
    flip(b);
    put(i, b);
    put(j, a);
    i = i + 1 == size() ? 0 : i + 1;
    j = j == 0 ? size() - 1 : j - 1;
  }
  if (count % 2 == 1) flip(order_[i]);
}

void TourState::do_swap(std::size_t from, std::size_t first, std::size_t second) {
  // The shorter block is set aside while the longer one is shifted.
  moved_.clear();
  if (first <= second) {
    for (std::size_t k = 0; k < first; ++k) moved_.push_back(order_[wrap(from + k)]);
    for (std::size_t k = 0; k < second; ++k) put(wrap(from + k), order_[wrap(from + first + k)]);
    for (std::size_t k = 0; k < first; ++k) put(wrap(from + second + k), moved_[k]);
  } else {
    for (std::size_t k = 0; k < second; ++k) moved_.push_back(order_[wrap(from + first + k)]);
    for (std::size_t k = first; k-- > 0;) put(wrap(from + second + k), order_[wrap(from + k)]);
    for (std::size_t k = 0; k < second; ++k) put(wrap(from + k), moved_[k]);
  }
}

}  // namespace oxturn
