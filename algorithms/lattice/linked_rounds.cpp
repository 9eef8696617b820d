#include "algorithms/lattice/linked_rounds.hpp"

namespace oxturn {

LinkedRounds::LinkedRounds(const GridGraph& fine, std::vector<Link> links, PathBuilder& path)
    : fine_(fine),
      links_(std::move(links)),
      first_(links_.empty() ? 0 : fine.size(), kNone),
      next_(links_.size(), kNone),
      path_(path) {
  for (std::size_t k = links_.size(); k-- > 0;)
    next_[k] = std::exchange(first_[links_[k].from], static_cast<std::uint32_t>(k));
}

void LinkedRounds::drive(const Link& root, const Context& context, const Steps& steps_from) {
  enter(root, steps_from(root.to));
  while (!open_.empty() && !context.cancelled()) {
    Round& here = open_.back();
    if (const std::uint32_t k = next_link(here.at); k != kNone)
      enter(links_[k], steps_from(links_[k].to));
    else if (here.driven < here.steps.size())
      step(here);
    else
      leave();
  }
  if (line_.size() > 1) path_.drive(line_, true);
}

void LinkedRounds::enter(const Link& link, std::vector<Direction> steps) {
  // A single sub-cell is covered on arrival; the first one, where the robot may start, when it is left.
  const bool leaves_single = open_.size() == 1 && open_.front().steps.empty();
  transit(*link.path, steps.empty() || leaves_single);
  open_.push_back({link.to, std::move(steps), 0, link.path});
}

void LinkedRounds::step(Round& round) {
  const Direction d = round.steps[round.driven++];
  round.at = neighbour(round.at, d);
  if (last_ == d) line_.pop_back();
  line_.push_back(fine_.centre(round.at));
  last_ = d;
}

void LinkedRounds::leave() {
  const Polyline* arrival = open_.back().arrival;
  open_.pop_back();
  if (!open_.empty()) transit(Polyline(arrival->rbegin(), arrival->rend()), false);
}

void LinkedRounds::transit(const Polyline& line, bool tool_on) {
  if (line_.size() > 1) path_.drive(line_, true);
  path_.drive(line, tool_on);
  line_.assign(1, line.back());
  last_.reset();
}

std::uint32_t LinkedRounds::next_link(const Cell& c) {
  if (first_.empty()) return kNone;
  std::uint32_t& first = first_[fine_.at(c)];
  return first == kNone ? kNone : std::exchange(first, next_[first]);
}

}  // namespace oxturn
