#include "metrics/tile_remainder.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr double kSpare = 1e-9;     // tile sides: an extra candidate costs little, a missing one would be wrong
constexpr std::size_t kFew = 16;    // capsules for which a cell is not divided
constexpr std::size_t kMuch = 512;  // pieces from which a capsule is subtracted, over all capsules; then it is
constexpr int kDeepest = 10;        // cells of 1/1024 tile: their pieces are few, however many capsules reach them
constexpr Extent kTile{{0, 0}, {0.5, 0.5}};

double half_diagonal(const Extent& e) { return std::sqrt(dot(e.half, e.half)); }

}  // namespace

bool TileRemainder::covers_tile(const Capsule& k, double distance2, Vec centre) const {
  return covers(k, distance2, {centre, kTile.half});
}

/// `cell` in tile coordinates.
bool TileRemainder::covers(const Capsule& k, double distance2, const Extent& cell) const {
  const double r = inner(k), half = cell.half.x;
  if (r <= half || distance2 > (r - half) * (r - half)) return false;  // a cell extends at least so far everywhere
  const double sure = r - half_diagonal(cell) - kSpare;
  if (sure >= 0 && distance2 <= sure * sure) return true;
  for (const Vec corner : {Vec{-half, -half}, Vec{half, -half}, Vec{half, half}, Vec{-half, half}})
    if (squared_distance(cell.centre + corner, k) > r * r) return false;
  return true;
}

void TileRemainder::compute(Vec centre, std::span<const NearCapsule> near, const Chords& chords) {
  centre_ = centre;
  chords_ = &chords;
  most_.clear();
  least_.clear();
  candidates_.clear();
  for (const NearCapsule& n : near)
    if (!capsules_[n.capsule].visits_only) candidates_.push_back({n.distance2, n.capsule});
  add_cell(kTile, 0, 0);
}

/// The candidates from `from` on are all that reach the cell.
void TileRemainder::add_cell(const Extent& cell, std::size_t from, int depth) {
  const std::size_t to = candidates_.size();
  const auto begin = candidates_.begin() + static_cast<std::ptrdiff_t>(from);
  const auto nearest = begin + static_cast<std::ptrdiff_t>(std::min(to - from, 2 * kFew));
  std::partial_sort(begin, nearest, candidates_.end(), [](const Candidate& l, const Candidate& r) {
    return l.distance2 != r.distance2 ? l.distance2 < r.distance2 : l.capsule < r.capsule;
  });
  if (subtract(cell, from, Bound::inscribed, depth < kDeepest)) {
    if (pieces_.empty()) return;
    most_.insert(most_.end(), pieces_.begin(), pieces_.end());
    subtract(cell, from, Bound::circumscribed, false);
    least_.insert(least_.end(), pieces_.begin(), pieces_.end());
    return;
  }
  const Vec half = 0.5 * cell.half;
  for (const Vec step : {Vec{-half.x, -half.y}, Vec{half.x, -half.y}, Vec{-half.x, half.y}, Vec{half.x, half.y}}) {
    add_quarter({cell.centre + step, half}, from, to, depth + 1);
    candidates_.resize(to);
  }
}

void TileRemainder::add_quarter(const Extent& quarter, std::size_t from, std::size_t to, int depth) {
  const Vec middle = centre_ + quarter.centre;
  const double span = half_diagonal(quarter);
  for (std::size_t i = from; i < to; ++i) {
    const std::uint32_t index = candidates_[i].capsule;
    const Capsule& k = capsules_[index];
    const double distance2 = squared_distance(middle, k), far = outer(k) + span + kSpare;
    if (distance2 >= far * far) continue;
    if (covers(k, distance2, {middle, quarter.half})) return;
    candidates_.push_back({distance2, index});
  }
  add_cell(quarter, to, depth);
}

/// pieces_ = cell without the polygons of the candidates from `from` on. If it may stop, it does where that takes too
/// much work, and returns false.
bool TileRemainder::subtract(const Extent& cell, std::size_t from, Bound bound, bool may_stop) {
  pieces_.assign(1, box_of(cell));
  Extent where = cell;  // box of the pieces: it shrinks fast, and capsules that do not reach it are skipped
  double span = half_diagonal(where);
  std::size_t work = 0;
  for (std::size_t i = from; i < candidates_.size() && !pieces_.empty(); ++i) {
    const Capsule& k = capsules_[candidates_[i].capsule];
    const double far = outer(k) + span + kSpare;
    if (squared_distance(centre_ + where.centre, k) >= far * far) continue;
    work += pieces_.size();
    if (may_stop && work > kMuch && candidates_.size() - i > kFew) return false;
    if (!subtract(k, bound, where)) continue;
    where = extent_of(pieces_);
    span = half_diagonal(where);
  }
  return true;
}

/// Subtracts the capsule's polygon from pieces_, which lie in the box `where`. Most of them are apart from it. False if
/// all are.
bool TileRemainder::subtract(const Capsule& k, Bound bound, const Extent& where) {
  const bool inscribed = bound == Bound::inscribed;
  const double side = inscribed ? inner(k) : outer(k);
  const double cap = inscribed ? (k.radius - k.slack) * chords_->inscribed() - margin_ : side;
  polygon_of(k, centre_, where, *chords_, side, cap, cut_);
  parts_.clear();
  std::size_t kept = 0;
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    if (oxturn::subtract(pieces_[i], cut_, parts_, crossing_)) continue;
    if (kept != i) pieces_[kept] = pieces_[i];
    ++kept;
  }
  if (kept == pieces_.size()) return false;
  pieces_.resize(kept);
  pieces_.insert(pieces_.end(), parts_.begin(), parts_.end());
  return true;
}

}  // namespace oxturn
