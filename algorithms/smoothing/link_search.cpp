#include "algorithms/smoothing/link_search.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
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

/// In which a pose is moved by so many metres.
Gear gear_of(double shift) { return shift < 0 ? Gear::reverse : Gear::forward; }

/// Straight ahead by `shift` metres; backwards if it is negative.
Curve straight(const Pose& from, double shift, double radius) {
  return {from, ahead(from, shift), radius, {{Steering::straight, std::abs(shift), gear_of(shift)}}};
}

/// Between poses moved by `out` and `in`.
void add_curves(const Pose& from, double out, const Pose& to, double in, double radius, bool reverse,
                std::vector<Curve>& all) {
  const Curve first = straight(from, out, radius), last = straight(ahead(to, -in), in, radius);
  const auto add = [&](const Word& middle) {
    all.push_back(joined(joined(first, curve_of(middle, first.to, last.from, radius)), last));
  };
  if (reverse) add(reeds_shepp_word(first.to, last.from, radius));
  const DubinsWords forwards = dubins_words(first.to, last.from, radius);
  for (const Word& word : forwards.all()) add(word);
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
  for (std::uint8_t out = 0; out < outs_.size(); ++out)
    for (std::uint8_t in = 0; in < ins_.size(); ++in) add(out, in, most);
  while (!heap_.empty()) {
    const Item item = pop();
    if (item.kind == Kind::near_pair) {
      if (!moves_blocked(item)) bound(item, most);
    } else if (item.kind == Kind::pair) {
      work_out(item, most);
    } else if (!ends_blocked(item)) {
      if (Curve curve = link(item); space_.free(curve)) return curve;
    }
  }
  return std::nullopt;
}

double LinkSearch::moved(const Item& item) const {
  return std::abs(outs_[item.out].shift) + std::abs(ins_[item.in].shift);
}

void LinkSearch::add(std::uint8_t out, std::uint8_t in, double most) {
  Item item{0, made_++, out, in, Kind::near_pair, 0, 0};
  item.least = moved(item) + distance(outs_[out].pieces.from().at, ins_[in].pieces.from().at);
  if (item.least < most) push(item);
}

/// By the length without obstacles.
void LinkSearch::bound(Item item, double most) {
  const Pose &a = outs_[item.out].pieces.from(), &b = ins_[item.in].pieces.from();
  item.kind = Kind::pair;
  item.word = words_.size();
  if (space_.reverse()) {
    words_.push_back(reeds_shepp_word(a, b, space_.radius()));
  } else {
    const DubinsWords forwards = dubins_words(a, b, space_.radius());
    std::ranges::copy(forwards.all(), std::back_inserter(words_));
  }
  item.known = static_cast<std::uint8_t>(words_.size() - item.word);
  item.least = moved(item) + words_[item.word].length;
  if (item.least < most) push(item);
}

/// The curves between two moved poses.
void LinkSearch::work_out(const Item& pair, double most) {
  for (std::size_t k = 0; k < pair.known; ++k) add_curve(pair, pair.word + k, most);
  if (!space_.reverse()) return;
  const Pose &a = outs_[pair.out].pieces.from(), &b = ins_[pair.in].pieces.from();
  const DubinsWords forwards = dubins_words(a, b, space_.radius());
  for (const Word& word : forwards.all()) {
    words_.push_back(word);
    add_curve(pair, words_.size() - 1, most);
  }
}

void LinkSearch::add_curve(const Item& pair, std::size_t word, double most) {
  Item item{0, made_++, pair.out, pair.in, Kind::curve, 0, word};
  item.least = cost(item);
  if (item.least < most) push(item);
}

/// As of the curve with the straight lines at its ends.
double LinkSearch::cost(const Item& item) const {
  const double out = outs_[item.out].shift, in = ins_[item.in].shift;
  double length = std::abs(out);
  std::size_t cusps = 0;
  Gear before = gear_of(out);
  const auto change_to = [&](Gear gear) { cusps += std::exchange(before, gear) != gear; };
  for (const CurvePiece& piece : words_[item.word].driven()) {
    length += piece.length;
    change_to(piece.gear);
  }
  change_to(gear_of(in));
  return space_.cost(length + std::abs(in), cusps);
}

bool LinkSearch::moves_blocked(const Item& pair) {
  const auto move = [](double metres) { return CurvePiece{Steering::straight, std::abs(metres), gear_of(metres)}; };
  return before_.blocked(move(outs_[pair.out].shift)) || behind_.blocked(driven_back(move(ins_[pair.in].shift)));
}

bool LinkSearch::ends_blocked(const Item& item) {
  const auto pieces = words_[item.word].driven();
  const auto driven = [](const CurvePiece& piece) { return piece.length > 0; };
  const auto first = std::find_if(pieces.begin(), pieces.end(), driven);
  if (first == pieces.end()) return false;
  const auto last = std::find_if(pieces.rbegin(), pieces.rend(), driven);
  return outs_[item.out].pieces.blocked(*first) || ins_[item.in].pieces.blocked(driven_back(*last));
}

/// The curve with the straight lines between its ends and the poses that it links.
Curve LinkSearch::link(const Item& item) const {
  const Pose &a = outs_[item.out].pieces.from(), &b = ins_[item.in].pieces.from();
  const Curve first = straight(from_, outs_[item.out].shift, space_.radius());
  const Curve last = straight(b, ins_[item.in].shift, space_.radius());
  return joined(joined(first, curve_of(words_[item.word], a, b, space_.radius())), last);
}

void LinkSearch::push(const Item& item) {
  heap_.push_back(item);
  std::ranges::push_heap(heap_, std::greater{});
}

LinkSearch::Item LinkSearch::pop() {
  std::ranges::pop_heap(heap_, std::greater{});
  const Item item = heap_.back();
  heap_.pop_back();
  return item;
}

}  // namespace oxturn
