#include "metrics/swept_area.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <stdexcept>

#include "metrics/capsules.hpp"
#include "metrics/target_rows.hpp"

namespace oxturn {
namespace {

constexpr double kRadius = 1;  // of the tool, in tile sides
constexpr double kHalfDiagonal = 0.70710678118654757;
constexpr Extent kTile{{0, 0}, {0.5, 0.5}};
constexpr int kFirstChords = 16, kVisitChords = 32, kMostChords = 1024;

const Convex& unit_square() {
  static const Convex square = [] {
    Convex c;
    c.add({-0.5, -0.5});
    c.add({0.5, -0.5});
    c.add({0.5, 0.5});
    c.add({-0.5, 0.5});
    return c;
  }();
  return square;
}

/// A capsule near a tile.
struct Near {
  std::int64_t column;
  double distance2;  // segment to tile centre
  std::uint32_t capsule;
};
using Group = const Near*;

struct Sums {                                        // tile areas
  double target = 0;                                 // of touched tiles
  double missed_in = 0, missed_out = 0, missed = 0;  // target not covered: upper bound, lower bound, estimate
  double swept = 0, legs = 0, visits_outside = 0;
};

class SuiteRun {
 public:
  SuiteRun(const Region& target, const Point& origin, double side, const CapsuleSet& set, double margin)
      : rows_(target, origin, side), set_(set), margin_(margin), visit_chords_(kVisitChords) {
    for (int n = kFirstChords; n <= kMostChords; n *= 2) chords_.emplace_back(n);
  }

  /// `budget`: how much of a tile's target may stay undecided.
  Sums run(double budget) {
    budget_ = budget;
    const std::vector<Capsule>& all = set_.all;
    std::vector<std::uint32_t> order(all.size()), active;
    for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    const auto first_row = [&](std::uint32_t i) { return floor_of(std::min(all[i].a.y, all[i].b.y) - kRadius); };
    const auto last_row = [&](std::uint32_t i) { return floor_of(std::max(all[i].a.y, all[i].b.y) + kRadius); };
    std::sort(order.begin(), order.end(), [&](std::uint32_t l, std::uint32_t r) {
      const std::int64_t rl = first_row(l), rr = first_row(r);
      return rl != rr ? rl < rr : l < r;
    });
    std::size_t next = 0;
    std::int64_t row = 0;
    while (next < order.size() || !active.empty()) {
      if (active.empty()) row = first_row(order[next]);
      for (; next < order.size() && first_row(order[next]) <= row; ++next) active.push_back(order[next]);
      collect(row, active);
      rows_.start_row(row);
      for (std::size_t from = 0; from < near_.size();) {
        std::size_t to = from + 1;
        while (to < near_.size() && near_[to].column == near_[from].column) ++to;
        tile(row, near_.data() + from, near_.data() + to);
        from = to;
      }
      std::erase_if(active, [&](std::uint32_t i) { return last_row(i) <= row; });
      ++row;
    }
    return sums_;
  }

 private:
  static std::int64_t floor_of(double x) { return static_cast<std::int64_t>(std::floor(x)); }

  /// Fills near_: by column, then nearest first.
  void collect(std::int64_t row, const std::vector<std::uint32_t>& active) {
    const double low = static_cast<double>(row);
    const double reach = kRadius + kHalfDiagonal + 1e-9;
    near_.clear();
    std::int64_t least = INT64_MAX, most = INT64_MIN;
    for (const std::uint32_t i : active) {
      const Capsule& k = set_.all[i];
      double from = std::min(k.a.x, k.b.x), to = std::max(k.a.x, k.b.x);
      if (k.a.y != k.b.y) {  // the part that is within a radius of the row
        const double slope = (k.b.x - k.a.x) / (k.b.y - k.a.y);
        const double x0 = k.a.x + (low - kRadius - k.a.y) * slope, x1 = k.a.x + (low + 1 + kRadius - k.a.y) * slope;
        from = std::max(from, std::min(x0, x1));
        to = std::min(to, std::max(x0, x1));
      }
      for (std::int64_t c = floor_of(from - kRadius - 1e-9); c <= floor_of(to + kRadius + 1e-9); ++c) {
        const double d2 = squared_distance({static_cast<double>(c) + 0.5, low + 0.5}, k);
        if (d2 >= reach * reach) continue;
        near_.push_back({c, d2, i});
        least = std::min(least, c);
        most = std::max(most, c);
      }
    }
    const auto nearer = [](const Near& l, const Near& r) {
      return l.distance2 != r.distance2 ? l.distance2 < r.distance2 : l.capsule < r.capsule;
    };
    if (near_.empty()) return;
    const auto columns = static_cast<std::uint64_t>(most - least) + 1;
    if (columns > 8 * near_.size() + 64) {
      std::sort(near_.begin(), near_.end(), [&](const Near& l, const Near& r) {
        return l.column != r.column ? l.column < r.column : nearer(l, r);
      });
      return;
    }
    first_.assign(columns + 1, 0);
    for (const Near& n : near_) ++first_[static_cast<std::size_t>(n.column - least) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    sorted_.resize(near_.size());
    fill_ = first_;
    for (const Near& n : near_) sorted_[fill_[static_cast<std::size_t>(n.column - least)]++] = n;
    for (std::size_t c = 0; c + 1 < first_.size(); ++c) {
      const auto begin = sorted_.begin() + static_cast<std::ptrdiff_t>(first_[c]);
      std::sort(begin, sorted_.begin() + static_cast<std::ptrdiff_t>(first_[c + 1]), nearer);
    }
    near_.swap(sorted_);
  }

  bool holds_tile(const Near& n, Vec centre) const {
    const double r = kRadius - margin_;
    if (n.distance2 >= r * r) return false;
    const double sure = r - kHalfDiagonal - 1e-9;
    if (n.distance2 <= sure * sure) return true;
    for (const Vec corner : {Vec{-0.5, -0.5}, Vec{0.5, -0.5}, Vec{0.5, 0.5}, Vec{-0.5, 0.5}})
      if (squared_distance(centre + corner, set_.all[n.capsule]) > r * r) return false;
    return true;
  }

  /// pieces = tile \ polygons of the group's capsules (of one leg, if given).
  void remainder(Group from, Group to, Vec centre, const Chords& chords, bool inscribed, const std::uint32_t* leg,
                 std::vector<Convex>& pieces) {
    pieces.assign(1, unit_square());
    Extent where = kTile;
    double span = kHalfDiagonal;
    const double side = inscribed ? kRadius - margin_ : kRadius + margin_;
    const double cap = inscribed ? kRadius * chords.inscribed() - margin_ : kRadius + margin_;
    for (Group n = from; n != to && !pieces.empty(); ++n) {
      const Capsule& k = set_.all[n->capsule];
      if (k.visits_only || (leg != nullptr && k.leg != *leg)) continue;
      const double far = side + span + 1e-9;  // only what is left matters, and it shrinks fast
      if (squared_distance(centre + where.centre, k) >= far * far) continue;
      polygon_of(k, centre, where, chords, side, cap, cut_);
      subtract(pieces, cut_, spare_);
      where = extent_of(pieces);
      span = std::hypot(where.half.x, where.half.y);
    }
  }

  struct Left {
    double most = 0, least = 0;
  };  // uncovered area of the tile
  Left left_of(Group from, Group to, Vec centre, const std::uint32_t* leg, std::vector<Convex>& in,
               std::vector<Convex>& out) {
    in.clear();
    out.clear();
    for (Group n = from; n != to; ++n) {
      const Capsule& k = set_.all[n->capsule];
      if (!k.visits_only && (leg == nullptr || k.leg == *leg) && holds_tile(*n, centre)) return {};
    }
    remainder(from, to, centre, chords_[0], true, leg, in);
    if (in.empty()) return {};
    remainder(from, to, centre, chords_[0], false, leg, out);
    return {area(in), area(out)};
  }
  static double estimate(double inscribed, double circumscribed) { return inscribed / 3 + 2 * circumscribed / 3; }

  void tile(std::int64_t row, Group from, Group to) {
    const Vec centre{static_cast<double>(from->column) + 0.5, static_cast<double>(row) + 0.5};
    const TileTarget& target = rows_.tile(from->column);
    const double wanted = target.inside() ? 1 : target.outside() ? 0 : target.area_in(unit_square());
    const Left left = left_of(from, to, centre, nullptr, in_, out_);
    const double swept = 1 - estimate(left.most, left.least);
    sums_.target += wanted;
    sums_.swept += swept;
    if (wanted > 0 && !in_.empty()) {
      double missed_in = target.area_in(in_), missed_out = target.area_in(out_);
      sums_.missed += std::min(wanted, estimate(missed_in, missed_out));
      for (std::size_t n = 1; n < chords_.size() && missed_in - missed_out > budget_ * std::max(wanted, 0.1); ++n) {
        remainder(from, to, centre, chords_[n], true, nullptr, in_);
        remainder(from, to, centre, chords_[n], false, nullptr, out_);
        missed_in = target.area_in(in_);
        missed_out = target.area_in(out_);
      }
      sums_.missed_in += std::min(missed_in, wanted);
      sums_.missed_out += std::min(missed_out, wanted);
    }
    legs(from, to, centre, swept);
    if (!target.inside()) visits(from, to, centre, target);
  }

  void legs(Group from, Group to, Vec centre, double swept) {
    legs_.clear();
    for (Group n = from; n != to; ++n)
      if (!set_.all[n->capsule].visits_only) legs_.push_back(set_.all[n->capsule].leg);
    std::sort(legs_.begin(), legs_.end());
    legs_.erase(std::unique(legs_.begin(), legs_.end()), legs_.end());
    if (legs_.size() <= 1) {
      if (!legs_.empty()) sums_.legs += swept;
      return;
    }
    for (const std::uint32_t leg : legs_) {
      const Left left = left_of(from, to, centre, &leg, in_, out_);
      sums_.legs += 1 - estimate(left.most, left.least);
    }
  }

  /// The area outside the target where visits begin.
  void visits(Group from, Group to, Vec centre, const TileTarget& target) {
    const double cap = kRadius * visit_chords_.equal_area();
    for (Group n = from; n != to; ++n) {
      const Capsule& k = set_.all[n->capsule];
      if (k.disc && !k.visits_only) continue;
      in_.clear();
      polygon_of(k, centre, kTile, visit_chords_, kRadius, cap, cut_);
      clip_all(unit_square(), 0);
      if (!k.disc && !in_.empty()) {
        disc_of(k, centre, kTile, visit_chords_, cap, cut_);
        subtract(in_, cut_, spare_);
      }
      sums_.visits_outside += std::max(0.0, area(in_) - target.area_in(in_));
    }
  }
  /// Appends `c` cut by cut_[k...] to in_, in halves where it grows too many corners.
  void clip_all(Convex c, std::size_t k) {
    for (; k < cut_.size() && c.size >= 3; ++k) {
      if (c.size > Convex::kWide) {
        const auto [one, two] = halves(c);
        clip_all(one, k);
        clip_all(two, k);
        return;
      }
      c = clipped(c, cut_[k]);
    }
    if (c.size >= 3) in_.push_back(c);
  }

  TargetRows rows_;
  const CapsuleSet& set_;
  double margin_, budget_ = 0;
  std::vector<Chords> chords_;
  Chords visit_chords_;
  Sums sums_;
  std::vector<Near> near_, sorted_;
  std::vector<std::size_t> first_, fill_;
  std::vector<Convex> in_, out_, spare_;
  std::vector<HalfPlane> cut_;
  std::vector<std::uint32_t> legs_;
};

}  // namespace

SweptArea swept_area(const Region& target, double target_excess, double width, const Path& path, double certainty) {
  if (!(width > 0)) throw std::invalid_argument("tool width is not above 0, expected metres");
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points)
      if (!finite(p)) throw std::invalid_argument("the path has a point that is not finite");
  if (!std::isfinite(path.length())) throw std::invalid_argument("the path's length is not finite");
  const double wanted_m2 = area(target);
  if (!(wanted_m2 > 0)) throw std::invalid_argument("the target is empty, there is nothing to cover");

  const double side = width / 2 / kRadius;
  const Box box = bounding_box(target);
  const Point origin = box.low;
  const Point size = box.size() / side;
  Box room;
  room.add(Point(0, 0));
  room.add(size);
  room.grow(3 * kRadius);
  const CapsuleSet set = capsules(path, origin, side, room,
                                  1e-6 * width + 1e-12 * box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff());
  // Coordinates round to 1e-16 of the map's size in tiles; the margin stays above that on maps of any size.
  const double margin = 1e-9 + 1e-15 * size.maxCoeff();

  const double tile_m2 = side * side;
  const double wanted = wanted_m2 / tile_m2;
  Sums sums;
  // What the target's own doubt leaves of the interval is the arcs'.
  const double excess = target_excess / tile_m2;
  const double arcs = std::max(certainty - excess / wanted, certainty / 10);
  double budget = arcs / 2;
  for (int attempt = 0; attempt < 4; ++attempt, budget /= 4) {
    sums = SuiteRun(target, origin, side, set, margin).run(budget);
    if (sums.missed_in - sums.missed_out <= 0.9 * arcs * wanted) break;
  }

  double untouched = wanted - sums.target;
  if (untouched < 1e-12 * wanted) untouched = 0;  // the sums' rounding
  SweptArea s;
  const double hit_least = std::max(0.0, sums.target - sums.missed_in);
  const double hit_most = sums.target - sums.missed_out + excess;
  const double missed_most = untouched + sums.missed_in + excess;
  const double missed_least = untouched + sums.missed_out;
  s.coverage.lower = hit_least / (hit_least + missed_most);
  s.coverage.upper = std::clamp(hit_most / (hit_most + missed_least), s.coverage.lower, 1.0);
  s.covered_m2 = hit_least * tile_m2;
  s.seen_m2 = std::max(hit_least, sums.target - sums.missed) * tile_m2;
  s.union_m2 = sums.swept * tile_m2;
  s.legs_m2 = sums.legs * tile_m2;
  const double begun = 2 * kRadius * set.work + static_cast<double>(set.discs) * kPi * kRadius * kRadius;
  s.visits_m2 = std::max(0.0, begun - sums.visits_outside) * tile_m2;
  return s;
}

}  // namespace oxturn
