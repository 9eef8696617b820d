#include "metrics/swept_area.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "metrics/tile_scan.hpp"

namespace oxturn {
namespace {

constexpr int kAttempts = 4;          // with smaller and smaller budgets
constexpr double kReach = 3;          // tool radii beyond the target's box that count (Decision 1)
constexpr double kSlackShare = 0.3;   // simplification of chains in tool radii, over the certainty
constexpr double kLeastPiece = 0.01;  // missed pieces, in discs of the tool
constexpr double kArcsAtLeast = 10;   // `certainty` over what the arcs get if the target's own error takes the rest

void check(double width, const Path& path) {
  if (!(width > 0)) throw std::invalid_argument("tool width is not above 0, expected metres");
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points)
      if (!finite(p)) throw std::invalid_argument("the path has a point that is not finite");
  if (!std::isfinite(path.length())) throw std::invalid_argument("the path's length is not finite");
}

struct Scan {
  CapsuleSet set;
  TileSums sums;
  CoverageCurve curve;
  UncoveredPieces pieces;
};

/// Scans with smaller budgets until the bounds of the missed target are close enough.
Scan scanned(const Region& target, const Point& origin, double side, const WorkChains& chains, const Box& room,
             double margin, double certainty, double wanted, double path_m) {
  Scan scan{{}, {}, {path_m, wanted}, {}};
  double budget = certainty / 2, slack = kToolRadius * certainty * kSlackShare;
  for (int attempt = 0; attempt < kAttempts; ++attempt, budget /= 4, slack /= 4) {
    scan.set = capsules(chains, room, slack);
    scan.curve = {path_m, wanted};
    scan.pieces = {};
    scan.sums = TileScan(target, origin, side, scan.set, margin, scan.curve, scan.pieces).run(budget);
    if (scan.sums.missed_most - scan.sums.missed_least <= 0.9 * certainty * wanted) break;
  }
  return scan;
}

/// Sums of tiles as areas. `wanted`: the target in tiles; `excess`: by how much it may be larger.
SweptArea areas_of(const Scan& scan, double wanted, double excess, double tile_m2) {
  const TileSums& sums = scan.sums;
  double untouched = wanted - sums.target;
  if (untouched < 1e-12 * wanted) untouched = 0;  // rounding of the sums
  const double hit_least = std::max(0.0, sums.target - sums.missed_most);
  const double hit_most = sums.target - sums.missed_least + excess;
  const double missed_most = untouched + sums.missed_most + excess;
  const double missed_least = untouched + sums.missed_least;
  SweptArea s;
  s.coverage.lower = hit_least / (hit_least + missed_most);
  s.coverage.upper = std::clamp(hit_most / (hit_most + missed_least), s.coverage.lower, 1.0);
  s.curve = scan.curve.points(s.coverage.middle());
  s.covered_m2 = hit_least * tile_m2;
  s.covered_estimate_m2 = std::max(hit_least, sums.target - sums.missed) * tile_m2;
  s.union_m2 = sums.swept * tile_m2;
  const double begun =
      2 * kToolRadius * scan.set.work + static_cast<double>(scan.set.discs) * kPi * kToolRadius * kToolRadius;
  s.visits_m2 = std::max(0.0, begun - sums.visits_outside) * tile_m2;
  return s;
}

}  // namespace

SweptArea swept_area(const Region& target, double target_excess, double width, const Path& path, double certainty) {
  check(width, path);
  const double wanted_m2 = area(target);
  if (!(wanted_m2 > 0)) throw std::invalid_argument("the target is empty, there is nothing to cover");

  const double side = width / 2 / kToolRadius, tile_m2 = side * side;
  const Box box = bounding_box(target);
  const Point size = box.size() / side;
  Box room;
  room.add(Point(0, 0));
  room.add(size);
  room.grow(kReach * kToolRadius);
  const double joint = 1e-6 * width + 1e-12 * box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
  const WorkChains chains = work_chains(path, box.low, side, joint);

  const double wanted = wanted_m2 / tile_m2, excess = target_excess / tile_m2;
  // What the target's own error leaves of the interval is for the arcs.
  const double arcs = std::max(certainty - excess / wanted, certainty / kArcsAtLeast);
  // Coordinates are rounded to 1e-16 of the map's size in tiles; the margin is above that on maps of any size.
  const double margin = 1e-9 + 1e-15 * size.maxCoeff();
  Scan scan = scanned(target, box.low, side, chains, room, margin, arcs, wanted, path.length());
  SweptArea s = areas_of(scan, wanted, excess, tile_m2);
  s.missed = scan.pieces.take(box.low, side, kLeastPiece * kPi * kToolRadius * kToolRadius);
  s.work_m2 = length_in(chains, room) * side * width;
  return s;
}

}  // namespace oxturn
