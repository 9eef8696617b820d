#include "algorithms/grid/uncovered_chains.hpp"

#include <algorithm>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kFarthest = 2;        // cell sides from one point of a chain to the next
constexpr double kTurn = 0.5;          // cell sides that turning around costs: chains go straight on where they can
constexpr double kSameCost = 1e-6;     // cell sides; of spots that cost the same the first is taken
constexpr double kWorthClosing = 0.6;  // of the chain's length: a straight line back as short as that is taken

/// A point on the boundary of configuration space is often outside it by rounding: a nearby point inside.
std::optional<Point> inner_point(const EdgeIndex& space, const Point& p, double tool_width) {
  constexpr int kDirections = 16;
  const double step = tool_width / 1000;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = k * kPi / (kDirections / 2);
    const Point q = p + step * Point(math::cos(angle), math::sin(angle));
    if (space.contains(q)) return q;
  }
  return std::nullopt;
}

}  // namespace

UncoveredChains::UncoveredChains(const Problem& problem, const GridGraph& cells, UncoveredSamples& samples, From from)
    : problem_(problem),
      cells_(cells),
      samples_(samples),
      from_(from),
      centre_tried_(number(cells.columns(), cells.rows()) + 1, false) {}

/// A point from which the tool covers q; nullopt: there is none.
std::optional<Point> UncoveredChains::point_that_covers(const Point& q) const {
  const EdgeIndex& space = problem_.walls();
  const double tool_width = problem_.robot().tool_width;
  if (space.contains(q)) return q;
  const auto hit = space.nearest(q, tool_width / 2 * (1 - 1e-3));
  if (!hit) return std::nullopt;
  return space.contains(hit->point) ? std::optional<Point>(hit->point) : inner_point(space, hit->point, tool_width);
}

/// The centre of the cell, once; else a point for its first uncovered sample. Samples that no point covers are dropped.
std::optional<UncoveredChains::Spot> UncoveredChains::spot_in(int i, int j) {
  if (i < -1 || j < -1 || i > cells_.columns() || j > cells_.rows() || !samples_.any_uncovered(i, j))
    return std::nullopt;
  const bool try_centre = cells_.free(i, j) && !centre_tried_[number(i, j)];
  if (from_ == From::centres && !try_centre) return std::nullopt;
  for (int k = 0; k < UncoveredSamples::kPerCell; ++k) {
    if (!samples_.uncovered(i, j, k)) continue;
    const std::optional<Point> at = point_that_covers(samples_.position(i, j, k));
    if (at) return Spot{try_centre ? cells_.centre(i, j) : *at, i, j, k, try_centre};
    samples_.drop(i, j, k);
  }
  return std::nullopt;
}

void UncoveredChains::take(const Spot& spot, const Point& from) {
  if (spot.centre)
    centre_tried_[number(spot.i, spot.j)] = true;
  else
    samples_.drop(spot.i, spot.j, spot.k);
  samples_.cover(from, spot.at);
}

/// Of the spots in the cell and those around it that can be reached straight, the nearest, or one straight on.
std::optional<UncoveredChains::Spot> UncoveredChains::next_spot(const Polyline& nodes, const Cell& at) {
  const Point& end = nodes.back();
  Point heading(0, 0);
  if (nodes.size() > 1) heading = (end - nodes[nodes.size() - 2]).normalized();
  std::optional<Spot> best;
  double least = kFarthest;
  for (int dj = -1; dj <= 1; ++dj)
    for (int di = -1; di <= 1; ++di) {
      const std::optional<Spot> spot = spot_in(at.i + di, at.j + dj);
      if (!spot) continue;
      const Point step = spot->at - end;
      const double turn = step.norm() > 0 ? (1 - heading.dot(step) / step.norm()) / 2 : 0;
      const double cost = step.norm() / cells_.side() + kTurn * turn;
      if (cost >= least - kSameCost || !problem_.walls().contains(end, spot->at)) continue;
      least = cost;
      best = spot;
    }
  return best;
}

void UncoveredChains::extend(Polyline& nodes, Cell at) {
  while (const std::optional<Spot> spot = next_spot(nodes, at)) {
    take(*spot, nodes.back());
    if (spot->at != nodes.back()) nodes.push_back(spot->at);
    at = {spot->i, spot->j};
  }
}

std::optional<NodeChain> UncoveredChains::from(int i, int j) {
  const std::optional<Spot> spot = spot_in(i, j);
  if (!spot) return std::nullopt;
  take(*spot, spot->at);
  NodeChain chain{{spot->at}, false};
  Polyline& nodes = chain.nodes;
  extend(nodes, {i, j});
  std::reverse(nodes.begin(), nodes.end());
  extend(nodes, {i, j});
  const double back = distance(nodes.back(), nodes.front());
  chain.closed = back < kWorthClosing * length(nodes) && problem_.walls().contains(nodes.back(), nodes.front());
  if (chain.closed) {
    samples_.cover(nodes.back(), nodes.front());
    nodes.push_back(nodes.front());
  }
  return chain;
}

}  // namespace oxturn
