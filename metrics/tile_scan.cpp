#include "metrics/tile_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace oxturn {
namespace {

constexpr double kHalfDiagonal = 0.70710678118654757;  // of a tile
constexpr Extent kTile{{0, 0}, {0.5, 0.5}};
constexpr double kSpare = 1e-9;        // tile sides: an extra candidate costs little, a missing one would be wrong
constexpr std::size_t kCrowded = 8;    // capsules near a tile: with more, the coarsest chords come first
constexpr double kCloseBounds = 5e-4;  // tiles: the coarsest chords tell enough of the uncovered area
// Chords per half disc.
constexpr int kFirstChords = 8, kMostChords = 1024, kVisitChords = 32;
constexpr double kStillShrinks = 0.9;                    // of the gap between bounds, with twice the chords
constexpr double kGain = 4;                              // factor by which it shrinks where the arcs make it
constexpr double kLeastWanted = 0.1;                     // tiles: budgets of tiles with less target are not smaller
constexpr double kMostVisitReach = 1.001 * kToolRadius;  // of the polygons for visits: their vertices are farther out

const Convex& unit_square() {
  static const Convex square = box_of(kTile);
  return square;
}

std::int64_t floor_of(double x) { return static_cast<std::int64_t>(std::floor(x)); }

/// Huygens: cancels the leading errors of both.
double estimate(double inscribed, double circumscribed) { return inscribed / 3 + 2 * circumscribed / 3; }

}  // namespace

TileScan::TileScan(const Region& target, const Point& origin, double side, const CapsuleSet& capsules, double margin,
                   TileDetails* details)
    : rows_(target, origin, side),
      capsules_(capsules),
      details_(details),
      left_(capsules.all, margin),
      reach_(kToolRadius + capsules.slack + kSpare),
      visit_chords_(kVisitChords) {
  for (int n = kFirstChords; n <= kMostChords; n *= 2) chords_.emplace_back(n);
}

std::int64_t TileScan::first_row(std::uint32_t capsule) const {
  const Capsule& k = capsules_.all[capsule];
  return floor_of(std::min(k.a.y, k.b.y) - reach_);
}
std::int64_t TileScan::last_row(std::uint32_t capsule) const {
  const Capsule& k = capsules_.all[capsule];
  return floor_of(std::max(k.a.y, k.b.y) + reach_);
}

/// By their first rows, those of one row in driving order. A counting sort: rows are dense.
std::vector<std::uint32_t> TileScan::sorted_capsules() const {
  const auto size = static_cast<std::uint32_t>(capsules_.all.size());
  if (size == 0) return {};
  std::int64_t low = first_row(0), high = low;
  for (std::uint32_t i = 1; i < size; ++i) {
    low = std::min(low, first_row(i));
    high = std::max(high, first_row(i));
  }
  const auto index = [&](std::uint32_t i) { return static_cast<std::size_t>(first_row(i) - low); };
  std::vector<std::uint32_t> next(static_cast<std::size_t>(high - low) + 2, 0), sorted(size);
  for (std::uint32_t i = 0; i < size; ++i) ++next[index(i) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  for (std::uint32_t i = 0; i < size; ++i) sorted[next[index(i)]++] = i;
  return sorted;
}

TileSums TileScan::run(double budget) {
  budget_ = budget;
  const std::vector<std::uint32_t> order = sorted_capsules();
  std::vector<std::uint32_t> active;
  std::size_t next = 0;
  std::int64_t row = order.empty() ? 0 : std::min<std::int64_t>(0, first_row(order.front()));
  for (; next < order.size() || !active.empty() || row <= rows_.last_row(); ++row) {
    const auto old = static_cast<std::ptrdiff_t>(active.size());
    for (; next < order.size() && first_row(order[next]) <= row; ++next) active.push_back(order[next]);
    std::inplace_merge(active.begin(), active.begin() + old, active.end());
    collect(row, active);
    scan_row(row);
    std::erase_if(active, [&](std::uint32_t i) { return last_row(i) <= row; });
  }
  return sums_;
}

/// Fills near_ for a row.
void TileScan::collect(std::int64_t row, const std::vector<std::uint32_t>& active) {
  near_.clear();
  for (const std::uint32_t i : active) add_near(row, i);
  sort_near();
}

/// Adds the capsule to all tiles of the row that it may touch.
void TileScan::add_near(std::int64_t row, std::uint32_t capsule) {
  const Capsule& k = capsules_.all[capsule];
  const double low = static_cast<double>(row);
  const double reach = reach_ + kHalfDiagonal;
  double from = std::min(k.a.x, k.b.x), to = std::max(k.a.x, k.b.x);
  if (k.a.y != k.b.y) {  // the part of the segment within a radius of the row
    const double slope = (k.b.x - k.a.x) / (k.b.y - k.a.y);
    const double x0 = k.a.x + (low - reach_ - k.a.y) * slope, x1 = k.a.x + (low + 1 + reach_ - k.a.y) * slope;
    from = std::max(from, std::min(x0, x1));
    to = std::min(to, std::max(x0, x1));
  }
  for (std::int64_t c = floor_of(from - reach_); c <= floor_of(to + reach_); ++c) {
    const double d2 = squared_distance({static_cast<double>(c) + 0.5, low + 0.5}, k);
    if (d2 < reach * reach) near_.push_back({c, d2, capsule});
  }
}

/// By column, then in driving order: by a counting sort of the columns if they are dense.
void TileScan::sort_near() {
  if (near_.empty()) return;
  const auto by_column = [](const NearCapsule& l, const NearCapsule& r) { return l.column < r.column; };
  const auto [least, most] = std::minmax_element(near_.begin(), near_.end(), by_column);
  const std::int64_t base = least->column;
  const auto columns = static_cast<std::uint64_t>(most->column - base) + 1;
  if (columns > 8 * near_.size() + 64) {
    std::stable_sort(near_.begin(), near_.end(), by_column);
    return;
  }
  first_of_column_.assign(columns + 1, 0);
  for (const NearCapsule& n : near_) ++first_of_column_[static_cast<std::size_t>(n.column - base) + 1];
  for (std::size_t c = 1; c < first_of_column_.size(); ++c) first_of_column_[c] += first_of_column_[c - 1];
  sorted_.resize(near_.size());
  fill_ = first_of_column_;
  for (const NearCapsule& n : near_) sorted_[fill_[static_cast<std::size_t>(n.column - base)]++] = n;
  near_.swap(sorted_);
}

void TileScan::scan_row(std::int64_t row) {
  rows_.start_row(row);
  if (details_ != nullptr) details_->pieces.start_row(row);
  std::int64_t untouched = 0;  // from this column on
  const std::int64_t end = rows_.last_column() + 1;
  for (std::size_t from = 0; from < near_.size();) {
    const std::int64_t column = near_[from].column;
    std::size_t to = from + 1;
    while (to < near_.size() && near_[to].column == column) ++to;
    const Vec centre{static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5};
    add_untouched(untouched, std::min(column, end));
    untouched = std::max(untouched, column + 1);
    scan_tile({{near_.data() + from, near_.data() + to}, centre}, rows_.tile(column));
    from = to;
  }
  add_untouched(untouched, end);
}

/// Tiles of the row that no capsule touches.
void TileScan::add_untouched(std::int64_t from, std::int64_t to) {
  if (details_ == nullptr) return;
  while (from < to) {
    const TileTarget& target = rows_.tile(from);
    if (!target.inside() && !target.outside()) {
      details_->pieces.add_tile(from++, {unit_square()}, target);
      continue;
    }
    const std::int64_t until = std::min(to, rows_.alike_until(from));
    if (target.inside()) details_->pieces.add_run(from, until);
    from = until;
  }
}

/// Does what is swept outside the target count?
bool TileScan::counts_outside() const { return details_ != nullptr && details_->swath == Swath::anywhere; }

void TileScan::scan_tile(const Tile& tile, const TileTarget& target) {
  if (target.outside() && !counts_outside()) return;
  const double wanted = target.inside() ? 1 : target.outside() ? 0 : target.area_in(unit_square());
  const double left = uncovered(tile);
  double missed = 0;
  if (wanted > 0 && left > 0) {
    const double least = target.area_in(left_.least());
    // Before the chords are refined: finer ones make more parts of the same pieces.
    if (details_ != nullptr && least > UncoveredPieces::kLeastArea / 2)
      details_->pieces.add_tile(floor_of(tile.centre.x), left_.least(), target);
    missed = add_missed(tile, target, wanted, least);
  }
  sums_.target += wanted;
  if (details_ != nullptr) add_details(tile, target, left, wanted - missed);
}

/// `left` of the tile is not covered, and `covered` of it is covered target.
void TileScan::add_details(const Tile& tile, const TileTarget& target, double left, double covered) {
  details_->swept += 1 - left;
  if (covered > 0) details_->curve.add(tile.centre, tile.near, capsules_.all, target, covered);
  if (!target.inside() && counts_outside()) add_visits(tile, target);
}

bool TileScan::any_covers(const Tile& tile) const {
  return std::any_of(tile.near.begin(), tile.near.end(), [&](const NearCapsule& n) {
    const Capsule& k = capsules_.all[n.capsule];
    return !k.visits_only && left_.covers_tile(k, n.distance2, tile.centre);
  });
}

/// Uncovered area of the tile, estimated; leaves the pieces in left_ unless it is 0. By the coarsest chords, if they
/// tell enough: where capsules are crowded, most arcs are inside others.
double TileScan::uncovered(const Tile& tile) {
  if (any_covers(tile)) return 0;
  compute_left(tile, tile.near.size() > kCrowded ? 0 : 1);
  if (level_ == 0 && area(left_.most()) - area(left_.least()) > kCloseBounds) compute_left(tile, 1);
  return estimate(area(left_.most()), area(left_.least()));
}

void TileScan::compute_left(const Tile& tile, std::size_t level) {
  level_ = level;
  left_.compute(tile.centre, tile.near, chords_[level]);
}

/// Refines the chords until the bounds of the missed target are within the budget, or as near as they get (the
/// capsules' slack remains). Returns the estimate.
double TileScan::add_missed(const Tile& tile, const TileTarget& target, double wanted, double least) {
  double most = target.area_in(left_.most());
  double gap = std::numeric_limits<double>::infinity();
  const double missed = std::min(wanted, estimate(most, least));
  const double wide = budget_ * std::max(wanted, kLeastWanted);
  for (std::size_t n = level_ + 1; n < chords_.size() && most - least > wide; ++n) {
    if (most - least > kStillShrinks * gap) break;
    gap = most - least;
    for (double next = gap / kGain; next > kGain * wide && n + 1 < chords_.size(); next /= kGain) ++n;
    compute_left(tile, n);
    most = target.area_in(left_.most());
    least = target.area_in(left_.least());
  }
  sums_.missed += missed;
  sums_.missed_most += std::min(most, wanted);
  sums_.missed_least += std::min(least, wanted);
  return missed;
}

/// Adds the area outside the target where visits begin.
void TileScan::add_visits(const Tile& tile, const TileTarget& target) {
  const std::optional<Extent> where = box_outside(target);
  if (!where) return;
  for (const NearCapsule& n : tile.near) {
    const Capsule& k = capsules_.all[n.capsule];
    if (k.disc && !k.visits_only) continue;
    details_->visits_outside += k.forth * visits_begun(tile, target, *where, k, k.a);
    if (k.back > 0) details_->visits_outside += k.back * visits_begun(tile, target, *where, k, k.b);
  }
}

/// A box around the part of the tile outside the target.
std::optional<Extent> TileScan::box_outside(const TileTarget& target) {
  begun_.assign(1, unit_square());
  if (target.outside() || !target.cut(begun_, in_disc_)) return kTile;
  std::erase_if(begun_, [&](const Convex& c) { return target.contains(middle_of(c)); });
  if (begun_.empty()) return std::nullopt;
  return extent_of(begun_);
}

/// The area outside the target, all of it in the box `where`, where visits begin while the robot drives the capsule's
/// segment from its end `from`: that in the capsule less that in the disc about `from`.
double TileScan::visits_begun(const Tile& tile, const TileTarget& target, const Extent& where, const Capsule& k,
                              Vec from) {
  const double cap = k.radius * visit_chords_.equal_area();
  const Vec off = tile.centre + where.centre - from;
  const Vec farthest{std::abs(off.x) + where.half.x, std::abs(off.y) + where.half.y};
  if (!k.disc && dot(farthest, farthest) < cap * cap) return 0;
  const double reach = kMostVisitReach + std::sqrt(dot(where.half, where.half));
  if (squared_distance(tile.centre + where.centre, k) > reach * reach) return 0;

  polygon_of(k, tile.centre, where, visit_chords_, k.radius, cap, cut_);
  begun_.clear();
  clip_to_cut(box_of(where), 0, begun_);
  double outside = area(begun_) - target.area_in(begun_);
  if (!k.disc && !begun_.empty()) {
    disc_of(from, k.along, tile.centre, where, visit_chords_, cap, cut_);
    in_disc_.clear();
    for (const Convex& c : begun_) clip_to_cut(c, 0, in_disc_);
    outside -= area(in_disc_) - target.area_in(in_disc_);
  }
  return std::max(0.0, outside);
}

/// Appends `piece` clipped to cut_[from] and all later half-planes, in halves where it gets too many vertices.
void TileScan::clip_to_cut(const Convex& piece, std::size_t from, std::vector<Convex>& out) {
  Convex one, two;
  const Convex* left = &piece;
  for (; from < cut_.size() && left != nullptr; ++from) {
    if (left->size > Convex::kWide) {
      const auto [half, other] = halves(*left);
      clip_to_cut(half, from, out);
      clip_to_cut(other, from, out);
      return;
    }
    left = clip(*left, cut_[from], left == &one ? two : one);
  }
  if (left != nullptr) out.push_back(*left);
}

}  // namespace oxturn
