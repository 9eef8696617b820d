#include "metrics/swept_area.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "metrics/tile_scan.hpp"

namespace oxturn {
namespace {

constexpr int kAttempts = 4;          // with smaller and smaller budgets
constexpr double kReach = 3;          // tool radii beyond the target's box that count (Decision 1)
constexpr double kSlackShare = 0.3;   // simplification of chains in tool radii, over the certainty
constexpr double kLeastPiece = 0.01;  // missed pieces, in discs of the tool
constexpr double kMostRows = 2e7;     // of tiles
constexpr double kMostWork = 1e9;     // tile sides driven: about ten minutes
constexpr double kArcsAtLeast = 10;   // `certainty` over what the arcs get if the target's own error takes the rest

void check(double width, const Path& path) {
  if (!(width > 0)) throw std::invalid_argument("tool width is not above 0, expected metres");
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points)
      if (!finite(p)) throw std::invalid_argument("the path has a point that is not finite");
  if (!std::isfinite(path.length())) throw std::invalid_argument("the path's length is not finite");
}

/// The path over the target, in tile coordinates: (p - origin) / side.
struct Ground {
  const Region& target;
  const Path& path;
  Point origin;
  double side, tile_m2, joint;
  Box room;               // the part of the path inside it counts
  double wanted, excess;  // tiles: the target, and by how much it may be larger
  double arcs;            // how wide the chords may make the coverage's interval
  double tile_share;      // how much of `arcs` a tile may take: tiles within the target take nothing
  double margin;          // by how much polygons are shrunk or grown
};

Ground ground_of(const Region& target, double target_excess, double width, const Path& path, double certainty) {
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
  const double wanted = wanted_m2 / tile_m2, excess = target_excess / tile_m2;
  return {target, path, box.low, side, tile_m2, joint, room, wanted, excess,
          // What the target's own error leaves of the interval is for the arcs.
          std::max(certainty - excess / wanted, certainty / kArcsAtLeast),
          // Where all tiles have a boundary in them, each may take its share only.
          2 / std::clamp(perimeter(target) * side / wanted_m2, 1.0, 2.0),
          // Coordinates are rounded to 1e-16 of the map's size in tiles; the margin is above that on maps of any size.
          1e-9 + 1e-15 * size.maxCoeff()};
}

/// Says so rather than scan without an end. `work`: length times width, tiles.
void check_size(const Ground& g, double work) {
  const double rows = bounding_box(g.target).size().y() / g.side;
  if (rows > kMostRows)
    throw std::invalid_argument(fmt::format(
        "the target is {:.3g} m high, {:.3g} times half the tool's width, more than 2e7: too much to score; "
        "take a wider tool or a smaller map, or check the map's scale",
        rows * g.side, rows));
  const double driven = work / (2 * kToolRadius);
  if (driven > kMostWork)
    throw std::invalid_argument(fmt::format(
        "the path works for {:.3g} m, {:.3g} times half the tool's width, more than 1e9: too much to score; "
        "take a wider tool or a smaller map, or check the map's scale",
        driven * g.side, driven));
}

struct Scan {
  double work = 0;  // length times width, tiles
  CapsuleSet set;
  TileSums sums;
};

/// Scans with smaller budgets until the bounds of the missed target are close enough. The details of the last scan
/// replace `details`, unless they are nullptr.
Scan scanned(const Ground& g, TileDetails* details) {
  Scan scan;
  double budget = g.tile_share * g.arcs, slack = kToolRadius * g.arcs * kSlackShare;
  for (int attempt = 0; attempt < kAttempts; ++attempt, budget /= 4, slack /= 4) {
    WorkChains chains = work_chains(g.path, g.origin, g.side, g.joint);
    scan.work = work_in(chains, g.room);
    check_size(g, scan.work);
    scan.set = capsules(std::move(chains), g.room, slack);
    if (details != nullptr)
      *details = {{g.path.length(), g.wanted}, UncoveredPieces(details->pieces.outlines()), details->swath};
    scan.sums = TileScan(g.target, g.origin, g.side, scan.set, g.margin, details).run(budget);
    if (scan.sums.missed_most - scan.sums.missed_least <= 0.9 * g.arcs * g.wanted) break;
  }
  return scan;
}

/// Covered target, certified lower bound, in tiles.
double least_covered(const TileSums& sums) { return std::max(0.0, sums.target - sums.missed_most); }

Interval coverage_in(const Ground& g, const TileSums& sums) {
  double untouched = g.wanted - sums.target;
  if (untouched < 1e-12 * g.wanted) untouched = 0;  // rounding of the sums
  const double hit_least = least_covered(sums), hit_most = sums.target - sums.missed_least + g.excess;
  const double missed_most = untouched + sums.missed_most + g.excess;
  const double missed_least = untouched + sums.missed_least;
  const double lower = hit_least / (hit_least + missed_most);
  return {lower, std::clamp(hit_most / (hit_most + missed_least), lower, 1.0)};
}

}  // namespace

Interval coverage_of(const Region& target, double target_excess, double width, const Path& path, double certainty) {
  const Ground g = ground_of(target, target_excess, width, path, certainty);
  return coverage_in(g, scanned(g, nullptr).sums);
}

SweptArea swept_area(const Region& target, double target_excess, double width, const Path& path, double certainty,
                     MissedOutlines outlines, Swath swath) {
  const Ground g = ground_of(target, target_excess, width, path, certainty);
  TileDetails details{{path.length(), g.wanted}, UncoveredPieces(outlines), swath};
  const Scan scan = scanned(g, &details);
  SweptArea s;
  s.coverage = coverage_in(g, scan.sums);
  s.covered_m2 = least_covered(scan.sums) * g.tile_m2;
  s.union_m2 = details.swept * g.tile_m2;
  s.covered_estimate_m2 = swath == Swath::in_target
                              ? s.union_m2
                              : std::max(least_covered(scan.sums), scan.sums.target - scan.sums.missed) * g.tile_m2;
  s.work_m2 = scan.work * g.tile_m2;
  s.visits_m2 = std::max(0.0, scan.set.begun - details.visits_outside) * g.tile_m2;
  s.curve = details.curve.points(s.coverage.middle());
  s.missed = details.pieces.take(g.origin, g.side, kLeastPiece * kPi * kToolRadius * kToolRadius);
  return s;
}

}  // namespace oxturn
