#include "algorithms/smoothing/link_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace oxturn {
namespace {

constexpr double kShifts[] = {0, 0.5, 1, 2};  // radii that a pose is moved along its lane's line

/// One curve after the other.
Curve joined(Curve first, const Curve& second) {
  first.pieces.insert(first.pieces.end(), second.pieces.begin(), second.pieces.end());
  first.to = second.to;
  return first;
}

/// Straight ahead by `shift` metres; backwards if it is negative.
Curve straight(const Pose& from, double shift, double radius) {
  return {from,
          ahead(from, shift),
          radius,
          {{Steering::straight, std::abs(shift), shift < 0 ? Gear::reverse : Gear::forward}}};
}

/// Between poses moved by `out` and `in`.
void add_curves(const Pose& from, double out, const Pose& to, double in, double radius, bool reverse,
                std::vector<Curve>& all) {
  const Curve first = straight(from, out, radius), last = straight(ahead(to, -in), in, radius);
  const auto add = [&](const Curve& middle) { all.push_back(joined(joined(first, middle), last)); };
  if (reverse) add(reeds_shepp_curve(first.to, last.from, radius));
  for (const Curve& word : dubins_words(first.to, last.from, radius)) add(word);
}

/// Metres that a pose is moved, none first.
std::vector<double> shifts(double radius, bool reverse) {
  std::vector<double> all;
  for (const double shift : kShifts) {
    all.push_back(shift * radius);
    if (reverse && shift > 0) all.push_back(-shift * radius);
  }
  return all;
}

/// The piece driven back from its end.
CurvePiece driven_back(CurvePiece piece) {
  piece.gear = piece.gear == Gear::forward ? Gear::reverse : Gear::forward;
  return piece;
}

}  // namespace

std::vector<Curve> link_curves(const Pose& from, const Pose& to, double radius, bool reverse) {
  std::vector<Curve> all;
  const std::vector<double> each = shifts(radius, reverse);
  for (const double out : each)
    for (const double in : each) add_curves(from, out, to, in, radius, reverse, all);
  return all;
}

bool FreePieces::blocked(const CurvePiece& piece) {
  const std::size_t gear = piece.gear == Gear::reverse ? 3 : 0;
  Known& known = known_[gear + static_cast<std::size_t>(piece.steering)];
  if (piece.length <= known.free) return false;
  if (piece.length >= known.blocked) return true;
  if (piece.steering != Steering::straight) return arc_blocked(piece, known);
  const bool free = space_->free(from_, piece);
  (free ? known.free : known.blocked) = piece.length;
  return !free;
}

bool FreePieces::arc_blocked(const CurvePiece& piece, Known& known) const {
  const auto at = [&](double metres) {
    return after(from_, {piece.steering, metres, piece.gear}, space_->radius()).at;
  };
  for (Point begin = at(known.free); known.free + space_->chord() <= piece.length;) {
    const double next = known.free + space_->chord();
    const Point end = at(next);
    if (!space_->free(Polyline{begin, end})) {
      known.blocked = next;
      return true;
    }
    known.free = next, begin = end;
  }
  return false;
}

LinkSearch::LinkSearch(const CarSpace& space, const Pose& from, const Pose& to)
    : space_(space), from_(from), to_(to), before_(space, from), behind_(space, to) {
  for (const double metres : shifts(space.radius(), space.reverse())) {
    outs_.push_back({metres, {space, ahead(from, metres)}});
    ins_.push_back({metres, {space, ahead(to, -metres)}});
  }
}

std::optional<Curve> LinkSearch::cheapest(double most) {
  for (std::size_t out = 0; out < outs_.size(); ++out)
    for (std::size_t in = 0; in < ins_.size(); ++in) add(out, in, most);
  while (!heap_.empty()) {
    Item item = pop();
    if (item.kind == Kind::near_pair) {
      if (!moves_blocked(item.out, item.in)) bound(item, most);
    } else if (item.kind == Kind::pair) {
      work_out(item.out, item.in, most);
    } else if (!ends_blocked(item)) {
      if (Curve curve = link(item); space_.free(curve)) return curve;
    }
  }
  return std::nullopt;
}

double LinkSearch::moved(std::size_t out, std::size_t in) const {
  return std::abs(outs_[out].shift) + std::abs(ins_[in].shift);
}

void LinkSearch::add(std::size_t out, std::size_t in, double most) {
  const double least = moved(out, in) + distance(outs_[out].pieces.from().at, ins_[in].pieces.from().at);
  if (least < most) push({Kind::near_pair, least, made_++, out, in, {}});
}

/// By the length without obstacles.
void LinkSearch::bound(Item& item, double most) {
  item.kind = Kind::pair;
  item.least =
      moved(item.out, item.in) + space_.least_length(outs_[item.out].pieces.from(), ins_[item.in].pieces.from());
  if (item.least < most) push(std::move(item));
}

/// The curves between two moved poses.
void LinkSearch::work_out(std::size_t out, std::size_t in, double most) {
  const auto add_curve = [&](Curve curve) {
    Item item{Kind::curve, 0, made_++, out, in, std::move(curve)};
    item.least = space_.cost(link(item));
    if (item.least < most) push(std::move(item));
  };
  const Pose &a = outs_[out].pieces.from(), &b = ins_[in].pieces.from();
  if (space_.reverse()) add_curve(reeds_shepp_curve(a, b, space_.radius()));
  for (Curve& word : dubins_words(a, b, space_.radius())) add_curve(std::move(word));
}

bool LinkSearch::moves_blocked(std::size_t out, std::size_t in) {
  const auto move = [](double metres) {
    return CurvePiece{Steering::straight, std::abs(metres), metres < 0 ? Gear::reverse : Gear::forward};
  };
  return before_.blocked(move(outs_[out].shift)) || behind_.blocked(driven_back(move(ins_[in].shift)));
}

bool LinkSearch::ends_blocked(const Item& item) {
  const std::vector<CurvePiece>& pieces = item.curve.pieces;
  const auto driven = [](const CurvePiece& piece) { return piece.length > 0; };
  const auto first = std::find_if(pieces.begin(), pieces.end(), driven);
  if (first == pieces.end()) return false;
  const auto last = std::find_if(pieces.rbegin(), pieces.rend(), driven);
  return outs_[item.out].pieces.blocked(*first) || ins_[item.in].pieces.blocked(driven_back(*last));
}

/// The curve with the straight lines between its ends and the poses that it links.
Curve LinkSearch::link(const Item& item) const {
  const Curve first = straight(from_, outs_[item.out].shift, space_.radius());
  const Curve last = straight(ins_[item.in].pieces.from(), ins_[item.in].shift, space_.radius());
  return joined(joined(first, item.curve), last);
}

void LinkSearch::push(Item item) {
  heap_.push_back(std::move(item));
  std::ranges::push_heap(heap_, std::greater{});
}

LinkSearch::Item LinkSearch::pop() {
  std::ranges::pop_heap(heap_, std::greater{});
  Item item = std::move(heap_.back());
  heap_.pop_back();
  return item;
}

}  // namespace oxturn
