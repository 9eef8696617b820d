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
    for (const auto& strip : strips_of_chain(pieces, slabs, f)) strips.push_back(to_world(strip, f.frame));
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
