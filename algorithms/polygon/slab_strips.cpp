#include "algorithms/polygon/slab_strips.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "algorithms/lanes/corridors.hpp"
#include "algorithms/polygon/cell_strips.hpp"

namespace oxturn {
namespace {

using Links = std::vector<std::pair<std::size_t, std::size_t>>;

/// Pairs of clipped lanes whose slabs the region connects. Sorted, unique.
Links links_of(const Projection& projection, const ClippedLanes& lanes) {
  Links links;
  for (const auto& [a, b] : projection.links)
    if (lanes.piece_of[a] != ClippedLanes::kNone && lanes.piece_of[b] != ClippedLanes::kNone)
      links.push_back({lanes.piece_of[a], lanes.piece_of[b]});
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  return links;
}

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

/// The lanes of a chain, one list for each strip: a corridor's lane is a strip of its own.
std::vector<std::vector<LaneEnds>> lanes_of(const std::vector<LaneInterval>& chain, const Slabs& slabs,
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

/// One set of slabs over the whole region, which is given in the field's frame; strips are the longest one-to-one runs
/// of lanes, cut where corridors begin and end.
std::vector<Strip> slab_strips(const LaneField& f, const Region& region) {
  const Box box = bounding_box(region);
  const Slabs slabs = slabs_over(box.low.x(), box.high.x(), f.spacing);
  const Projection projection = project(edges_of(region), slabs);
  const ClippedLanes lanes = clip_lanes(projection.intervals, slabs, f.space, f.join(), f.margin);
  const Links links = links_of(projection, lanes);
  std::vector<Strip> strips;
  std::vector<std::size_t> first_strip(lanes.pieces.size()), last_strip(lanes.pieces.size());  // of a piece's chain
  for (const std::vector<std::size_t>& chain : chains(lanes.pieces.size(), links)) {
    std::vector<LaneInterval> pieces;
    for (const std::size_t i : chain) pieces.push_back(lanes.pieces[i]);
    const std::size_t first = strips.size();
    for (const auto& strip : lanes_of(pieces, slabs, f)) strips.push_back(to_world(strip, f.frame));
    for (std::size_t s = first; s + 1 < strips.size(); ++s) connect(strips, s, s + 1);
    for (const std::size_t i : chain) {
      first_strip[i] = first;
      last_strip[i] = strips.size() - 1;
    }
  }
  for (const auto& [a, b] : links)
    if (first_strip[a] != first_strip[b]) connect(strips, last_strip[a], first_strip[b]);
  return strips;
}

/// Strips with lanes in one direction: one set of slabs for all of `wide`, a slab of its own for each polygon of
/// `narrow`, so that none lies astride two.
std::vector<Strip> strips_along(double direction, const Region& wide, const Region& narrow, double spacing,
                                const Problem& problem, const Region& near) {
  if (wide.empty() && narrow.empty()) return {};
  const LaneField field(problem, near, direction, spacing);
  const auto strips_in = [&](const Region& region) { return slab_strips(field, field.frame.to_frame(region)); };
  std::vector<Strip> strips;
  if (!wide.empty()) strips = strips_in(wide);
  for (const Polygon& polygon : narrow.polygons)
    for (Strip& strip : strips_in({{polygon}})) strips.push_back(std::move(strip));  // they have no neighbours
  return strips;
}

}  // namespace

std::vector<Strip> slab_strips(const Region& region, double degrees, double spacing, const Problem& problem) {
  return slab_strips(region, degrees, spacing, problem, problem.configuration_space());
}

std::vector<Strip> slab_strips(const Region& region, double degrees, double spacing, const Problem& problem,
                               const Region& near) {
  const LaneFrame frame(degrees);
  Region wide, along, across;
  for (const Polygon& polygon : region.polygons) {
    Box box;
    for (const Point& p : polygon.outer) box.add(frame.to_frame(p));
    Region& part = box.size().x() <= spacing ? along : box.size().y() <= spacing ? across : wide;
    part.polygons.push_back(polygon);
  }
  std::vector<Strip> strips = strips_along(degrees, wide, along, spacing, problem, near);
  for (Strip& strip : strips_along(degrees + 90, {}, across, spacing, problem, near))
    strips.push_back(std::move(strip));
  return strips;
}

}  // namespace oxturn
