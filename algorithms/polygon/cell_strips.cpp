#include "algorithms/polygon/cell_strips.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "algorithms/lanes/corridors.hpp"

namespace oxturn {

Strip to_world(const std::vector<LaneEnds>& lanes, const LaneFrame& frame) {
  Strip strip;
  for (const LaneEnds& l : lanes) strip.lanes.push_back({frame.to_world(l.low), frame.to_world(l.high)});
  return strip;
}

Ring outline(const BoustrophedonCell& cell, const LaneFrame& frame) {
  Ring ring(cell.lower.begin(), cell.lower.end());
  ring.insert(ring.end(), cell.upper.rbegin(), cell.upper.rend());
  for (Point& p : ring) p = frame.to_world(p);
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  return ring;
}

namespace {

/// The end of the first edge of a chain that reaches x and is not upright; its size if there is none.
std::size_t edge_to(const Polyline& chain, double x) {
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (x <= chain[i].x() && chain[i].x() > chain[i - 1].x()) return i;
  return chain.size();
}

}  // namespace

double height_on(const Polyline& chain, double x) {
  const std::size_t i = edge_to(chain, x);
  if (i == chain.size()) return chain.back().y();
  const Point &a = chain[i - 1], &b = chain[i];
  return a.y() + std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0) * (b.y() - a.y());
}

namespace {

/// The farthest point of the segment ab to which it runs inside `space`; a itself must lie inside.
Point reach(const EdgeIndex& space, const Point& a, const Point& b) {
  if (space.contains(a, b)) return b;
  double inside = 0, outside = 1;
  for (int k = 0; k < 40; ++k) {
    const double middle = (inside + outside) / 2;
    (space.contains(a, lerp(a, b, middle)) ? inside : outside) = middle;
  }
  return lerp(a, b, inside);
}

/// The lane along a corridor, from the left side of its slabs to the right side. nullopt if a wall is in between, which
/// happens only if the lanes' region reaches walls.
std::optional<LaneEnds> lane_along(const std::vector<LaneInterval>& chain, const ChainPart& corridor,
                                   const Slabs& slabs, const EdgeIndex& space) {
  const std::size_t first = chain[corridor.from].slab, last = first + corridor.count - 1;
  const auto at = [&](std::size_t line) { return Point(slabs.line(line), corridor.middle); };
  const Point left = at(first + 1), right = at(last);  // the region connects the slabs on these lines
  if (!space.contains(left, right)) return std::nullopt;
  return LaneEnds{reach(space, left, at(first)), reach(space, right, at(last + 1))};
}

}  // namespace

std::vector<std::vector<LaneEnds>> strips_of_chain(const std::vector<LaneInterval>& chain, const Slabs& slabs,
                                                   const LaneField& f) {
  std::vector<std::vector<LaneEnds>> strips;
  for (const ChainPart& part : corridors_in(chain, f.spacing - 2 * f.margin)) {
    strips.emplace_back();
    if (part.corridor)
      if (const auto along = lane_along(chain, part, slabs, f.space)) {
        strips.back() = {*along};
        continue;
      }
    for (std::size_t i = part.from; i < part.from + part.count; ++i)
      strips.back().push_back(upright(slabs.centre(chain[i].slab), chain[i].low, chain[i].high));
  }
  return strips;
}

namespace {

constexpr double kMostBuckets = 1e7;

using Cells = std::vector<BoustrophedonCell>;

/// Least and greatest y of a chain between two x.
std::pair<double, double> range_on(const Polyline& chain, double x0, double x1) {
  const double y0 = height_on(chain, x0), y1 = height_on(chain, x1);
  double low = std::min(y0, y1), high = std::max(y0, y1);
  for (const Point& p : chain)
    if (p.x() >= x0 && p.x() <= x1) {
      low = std::min(low, p.y());
      high = std::max(high, p.y());
    }
  return {low, high};
}

/// Two points at the chain's heights, from left to right, and its vertices between them: also those straight above or
/// below the first one, where the chain goes on upright from there.
Polyline chain_between(const Polyline& chain, const Point& from, const Point& to) {
  Polyline link{from};
  std::size_t i = edge_to(chain, from.x());
  if (i < chain.size() && chain[i].x() <= from.x()) ++i;
  for (const std::size_t end = edge_to(chain, to.x()); i < end; ++i) link.push_back(chain[i]);
  link.push_back(to);
  return link;
}

/// Lanes placed so far, in buckets by x.
class PlacedLanes {
 public:
  PlacedLanes(double left, double right, double width)
      : width_(width),
        origin_(left),
        buckets_(static_cast<std::size_t>(std::min((right - left) / width + 1, kMostBuckets))) {}

  void add(const LaneEnds& lane) { buckets_[bucket(lane.low.x())].push_back(lane); }
  /// True if the box from (x0, low) to (x1, high) lies under lanes that each span its whole height.
  bool cover(double x0, double x1, double low, double high) const {
    std::vector<double> across;
    for (std::size_t b = bucket(x0 - width_); b <= bucket(x1 + width_); ++b)
      for (const LaneEnds& lane : buckets_[b])
        if (lane.low.y() <= low && lane.high.y() >= high) across.push_back(lane.low.x());
    std::sort(across.begin(), across.end());
    double reached = x0;
    for (const double x : across)
      if (x - width_ / 2 <= reached) reached = std::max(reached, x + width_ / 2);
    return reached >= x1;
  }

 private:
  std::size_t bucket(double x) const {
    const double k = std::floor((x - origin_) / width_);
    return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(buckets_.size() - 1)));
  }
  double width_, origin_;
  std::vector<std::vector<LaneEnds>> buckets_;
};

/// Runs of lanes in consecutive slabs, one lane in each.
std::vector<std::vector<LaneInterval>> runs_of(const std::vector<LaneInterval>& lanes) {
  std::vector<std::vector<LaneInterval>> runs;
  for (const LaneInterval& lane : lanes) {
    if (runs.empty() || lane.slab != runs.back().back().slab + 1) runs.emplace_back();
    runs.back().push_back(lane);
  }
  return runs;
}

/// A strip for each exact cell, if the outline is driven as well: the projections of slabs fitted to the cell. The
/// widest cells come first; a lane whose part of the cell lies under lanes of other cells is omitted.
std::vector<Strip> fitted_strips(const LaneField& f, const Cells& cells, Context& context) {
  std::vector<Strip> strips(cells.size());
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto extent = [&](std::size_t c) { return right_of(cells[c]) - left_of(cells[c]); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return extent(a) > extent(b); });
  double left = cells.empty() ? 0 : left_of(cells[0]), right = left;
  for (const BoustrophedonCell& cell : cells) {
    left = std::min(left, left_of(cell));
    right = std::max(right, right_of(cell));
  }
  PlacedLanes placed(left, right, f.width);
  for (const std::size_t c : order) {
    const BoustrophedonCell& cell = cells[c];
    const double x0 = left_of(cell), x1 = right_of(cell);
    const Slabs slabs = slabs_over(x0, x1, f.spacing);
    std::vector<LaneInterval> intervals;
    for (std::size_t k = 0; k < slabs.count; ++k) {
      const double a = std::max(slabs.line(k), x0), b = std::min(slabs.line(k + 1), x1);
      const double low = range_on(cell.lower, a, b).first, high = range_on(cell.upper, a, b).second;
      if (!placed.cover(a, b, low, high)) intervals.push_back({k, low, high});
    }
    std::vector<LaneEnds> lanes;
    for (const auto& chain : runs_of(clip_lanes(intervals, slabs, f.space, f.join(), f.margin).pieces))
      for (const auto& strip : strips_of_chain(chain, slabs, f)) lanes.insert(lanes.end(), strip.begin(), strip.end());
    for (const LaneEnds& lane : lanes)
      if (lane.low.x() == lane.high.x()) placed.add(lane);
    strips[c] = to_world(lanes, f.frame);
    if (context.cancelled()) break;
  }
  return strips;
}

/// How a cell's boundary runs from one lane to the next, at the ends that `end_of` names.
template <class EndOf>
std::vector<Polyline> links_along(const Polyline& chain, const std::vector<LaneEnds>& lanes, const LaneFrame& frame,
                                  EndOf end_of) {
  std::vector<Polyline> links;
  for (std::size_t k = 1; k < lanes.size(); ++k) {
    links.push_back(chain_between(chain, end_of(lanes[k - 1]), end_of(lanes[k])));
    for (Point& p : links.back()) p = frame.to_world(p);
  }
  return links;
}

/// A strip for each exact cell, as in the paper: evenly spaced lanes from the cell's left end to its right end,
/// inclusive, and links that follow the boundary.
std::vector<Strip> spaced_strips(const LaneField& f, const Cells& cells, Context& context) {
  std::vector<Strip> strips(cells.size());
  for (std::size_t c = 0; c < cells.size() && !context.cancelled(); ++c) {
    const BoustrophedonCell& cell = cells[c];
    const double x0 = left_of(cell), x1 = right_of(cell);
    const Slabs slabs = slabs_over(x0, x1, f.spacing);
    std::vector<LaneEnds> lanes;
    for (std::size_t k = 0; k <= slabs.count; ++k) {
      const double x = k == slabs.count ? x1 : std::max(x0, slabs.line(k));
      const double low = height_on(cell.lower, x), high = std::max(low, height_on(cell.upper, x));
      const double keep = std::min(f.margin, (high - low) / 2);
      lanes.push_back(upright(x, low + keep, high - keep));
    }
    strips[c] = to_world(lanes, f.frame);
    strips[c].low_links = links_along(cell.lower, lanes, f.frame, [](const LaneEnds& l) { return l.low; });
    strips[c].high_links = links_along(cell.upper, lanes, f.frame, [](const LaneEnds& l) { return l.high; });
  }
  return strips;
}

}  // namespace

std::vector<Strip> cell_strips(const LaneField& field, const Cells& cells, LaneFit fit, Context& context) {
  return fit == LaneFit::fitted ? fitted_strips(field, cells, context) : spaced_strips(field, cells, context);
}

}  // namespace oxturn
