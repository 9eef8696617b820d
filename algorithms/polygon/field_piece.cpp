#include "algorithms/polygon/field_piece.hpp"

#include <cmath>

#include "algorithms/lanes/laps.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

/// The sum of turns, whichever side each is to: directions are multiplied as complex numbers, so that many turns take
/// one arc tangent.
class TurnSum {
 public:
  /// Of a turn, times the lengths of the edges before and after it.
  void add(double cosine, double sine) {
    if (cosine == 0 && sine == 0) return;  // a repeated vertex
    const double across = std::abs(sine);
    product_ = {product_.x() * cosine - product_.y() * across, product_.x() * across + product_.y() * cosine};
    if (++factors_ == kMostFactors || product_.y() >= product_.x()) take_product();
  }
  double radians() {
    take_product();
    return sum_;
  }

 private:
  static constexpr int kMostFactors = 8;  // their product neither overflows nor vanishes

  void take_product() {
    const double turn = math::atan2(product_.y(), product_.x());
    sum_ += turn < 0 ? turn + 2 * kPi : turn;
    product_ = {1, 0};
    factors_ = 0;
  }

  Point product_{1, 0};  // below 45 degrees between calls
  int factors_ = 0;
  double sum_ = 0;
};

/// The part of the ring from one vertex to another, all of it if they are the same; the rest is that of the round.
Stretch stretch_of(const Ring& ring, std::size_t from, std::size_t to, const Stretch& round) {
  Stretch s = round;
  const std::size_t n = ring.size();
  s.points.reserve((to + n - from - 1) % n + 2);
  s.points.push_back(ring[from]);
  for (std::size_t i = (from + 1) % n;; i = (i + 1) % n) {
    s.points.push_back(ring[i]);
    if (i == to) break;
  }
  s.metres = length(s.points);
  return s;
}

}  // namespace

FieldPiece::FieldPiece(Polygon polygon) : region_{{std::move(polygon)}}, box_(bounding_box(region_)) {
  for_each_ring(region_, [this](const Ring& ring) { add_stretches(ring); });
}

bool FieldPiece::contains(const Point& p) const {
  if (!box_.contains(p)) return false;
  if (!rows_) rows_.emplace(region_);
  return rows_->contains(p);
}

Stretch FieldPiece::all_round(const Ring& ring, const Point& at, const Stretch& round) {
  const std::size_t nearest = nearest_vertex(ring, at);
  return stretch_of(ring, nearest, nearest, round);
}

void FieldPiece::add_stretches(const Ring& ring) {
  const std::size_t n = ring.size();
  std::vector<std::size_t> cuts;
  Stretch round;
  TurnSum turns;
  Point before = ring[0] - ring[n - 1];
  for (std::size_t i = 0; i < n; ++i) {
    const Point after = ring[(i + 1) % n] - ring[i];
    const double along = before.dot(after), across = cross(before, after);
    if (std::abs(across) > along) cuts.push_back(i);
    turns.add(along, across);
    round.round_metres += after.norm();
    before = after;
  }
  round.round_turns = turns.radians();
  if (cuts.empty()) smooth_.emplace_back(ring, round);
  for (std::size_t k = 0; k < cuts.size(); ++k)
    stretches_.push_back(stretch_of(ring, cuts[k], cuts[(k + 1) % cuts.size()], round));
}

}  // namespace oxturn
