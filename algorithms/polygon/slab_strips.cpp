#include "algorithms/polygon/slab_strips.hpp"

#include <algorithm>
#include <utility>

#include "algorithms/polygon/cell_strips.hpp"

namespace oxturn {
namespace {

using Links = std::vector<std::pair<std::size_t, std::size_t>>;

Strip to_world(const std::vector<LaneEnds>& lanes, const LaneFrame& frame) {
  Strip strip;
  for (const LaneEnds& l : lanes) strip.lanes.push_back({frame.to_world(l.low), frame.to_world(l.high)});
  return strip;
}

LaneEnds upright(double x, double low, double high) { return {{x, low}, {x, high}}; }

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
/// of lanes.
std::vector<Strip> slab_strips(const LaneField& f, const Region& region) {
  const Box box = bounding_box(region);
  const Slabs slabs = slabs_over(box.low.x(), box.high.x(), f.spacing);
  const Projection projection = project(edges_of(region), slabs);
  const ClippedLanes lanes = clip_lanes(projection.intervals, slabs, f.space, f.join(), f.margin);
  const Links links = links_of(projection, lanes);
  const std::size_t n = lanes.pieces.size();
  std::vector<std::vector<std::size_t>> right(n), left(n);
  for (const auto& [a, b] : links) {
    right[a].push_back(b);
    left[b].push_back(a);
  }
  const auto has_one_successor = [&](std::size_t a) { return right[a].size() == 1 && left[right[a][0]].size() == 1; };
  std::vector<Strip> strips;
  std::vector<std::size_t> strip_of(n, ClippedLanes::kNone);
  for (std::size_t i = 0; i < n; ++i) {  // by slab, so a run's first lane comes first
    if (strip_of[i] != ClippedLanes::kNone) continue;
    std::vector<LaneEnds> run;
    for (std::size_t k = i;; k = right[k][0]) {
      const LaneInterval& s = lanes.pieces[k];
      run.push_back(upright(slabs.centre(s.slab), s.low, s.high));
      strip_of[k] = strips.size();
      if (!has_one_successor(k)) break;
    }
    strips.push_back(to_world(run, f.frame));
  }
  for (const auto& [a, b] : links) connect(strips, strip_of[a], strip_of[b]);
  return strips;
}

/// Strips with lanes in one direction: one set of slabs for all of `wide`, a slab of its own for each polygon of
/// `narrow`, so that none lies astride two.
std::vector<Strip> strips_along(double direction, const Region& wide, const Region& narrow, double spacing,
                                const Problem& problem) {
  if (wide.empty() && narrow.empty()) return {};
  const LaneField field(problem, direction, spacing);
  const auto strips_in = [&](const Region& region) { return slab_strips(field, field.frame.to_frame(region)); };
  std::vector<Strip> strips;
  if (!wide.empty()) strips = strips_in(wide);
  for (const Polygon& polygon : narrow.polygons)
    for (Strip& strip : strips_in({{polygon}})) strips.push_back(std::move(strip));  // they have no neighbours
  return strips;
}

}  // namespace

std::vector<Strip> slab_strips(const Region& region, double degrees, double spacing, const Problem& problem) {
  const LaneFrame frame(degrees);
  Region wide, along, across;
  for (const Polygon& polygon : region.polygons) {
    Box box;
    for (const Point& p : polygon.outer) box.add(frame.to_frame(p));
    Region& part = box.size().x() <= spacing ? along : box.size().y() <= spacing ? across : wide;
    part.polygons.push_back(polygon);
  }
  std::vector<Strip> strips = strips_along(degrees, wide, along, spacing, problem);
  for (Strip& strip : strips_along(degrees + 90, {}, across, spacing, problem)) strips.push_back(std::move(strip));
  return strips;
}

}  // namespace oxturn
