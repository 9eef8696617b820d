// Back and forth: cells without a turn in them, each swept lane by lane, joined by transit.
//
// Source      Choset, Pignon, "Coverage Path Planning: The Boustrophedon Cellular Decomposition", FSR 1997;
//             Choset, Autonomous Robots 9, 2000
// Model       polygons with holes, offline, disc footprint
// Guarantee   with `outline`: covers the whole target. Let C be configuration space, w the tool width, R the points
//             of C at least w/2 from its boundary. Driving the boundary covers all within w/2 of it, inside and
//             outside C. A point p of R lies in a slab no wider than w with centre line x; (x, p.y) is no farther
//             from p than p from the boundary, hence in C and on the slab's lane, and covers p (lanes.hpp).
//             Without `outline` slanted ends of lanes and a seam along the walls stay uncovered, as in the paper.
// Complexity  n corners, m lanes, k crossings of walls with slab lines: O((n + k) log n) for the lanes (times up
//             to 16 to find the direction), about O(m log m) steps and path searches for the order
// Decisions   1. Lanes are projections of whole slabs, not samples on a line, and rings of the outline are spliced
//                in where the path passes next to them: never a second visit to a wall.
//             2. cells = slab (default): one set of slabs over the whole map, a cell is a longest run of lanes that
//                follow each other one to one. Where two critical points are nearer than w the exact cells need an
//                extra lane each; slabs never do. On traced laser maps that is most of the length.
//             3. cells = exact: the paper's cells (of R with outline, of C without), lanes evenly spaced in each.
//                A lane whose slab lies under lanes placed before is left out.
//             4. sweep = best counts a turn as 2 w and a break between cells as 4 w.
//             5. Links longer than 3 w between lanes of a cell are transit.
#include <algorithm>
#include <limits>

#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/strips.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/mesh/partition.hpp"

namespace oxturn {
namespace {

struct Params {
  std::string sweep = "best";
  double angle = 0;
  bool outline = true;
  std::string cells = "slab";
  double spacing = 1;
  std::string order = "improved";
};

struct Field {  // what the cells are made of, in the lanes' frame
  const Frame& frame;
  const Region& region;
  const EdgeIndex& room;
  double step, width, margin;  // lane spacing, tool width, how far lane ends keep off walls
};

Strip to_world(const std::vector<LaneEnds>& lanes, const Frame& frame) {
  Strip strip;
  for (const LaneEnds& l : lanes) strip.lanes.push_back({frame.back(l.low), frame.back(l.high)});
  return strip;
}

// One set of slabs for all; cells are the longest one-to-one runs.
std::vector<Strip> slab_strips(const Field& f) {
  const Box box = bounding_box(f.region);
  const Slabs slabs = slabs_over(box.low.x(), box.high.x(), f.step);
  const Projection all = project(edges_of(f.region), slabs);
  const Clipped lanes = clip(all.stretches, slabs, f.room, 2 * f.width, f.margin);
  const std::size_t n = lanes.pieces.size();
  std::vector<std::vector<std::size_t>> right(n), left(n);
  std::vector<std::pair<std::size_t, std::size_t>> links;
  for (const auto& [a, b] : all.links)
    if (lanes.piece_of[a] != Clipped::kNone && lanes.piece_of[b] != Clipped::kNone)
      links.push_back({lanes.piece_of[a], lanes.piece_of[b]});
  std::sort(links.begin(), links.end());
  links.erase(std::unique(links.begin(), links.end()), links.end());
  for (const auto& [a, b] : links) {
    right[a].push_back(b);
    left[b].push_back(a);
  }
  const auto follows = [&](std::size_t a) { return right[a].size() == 1 && left[right[a][0]].size() == 1; };
  std::vector<Strip> strips;
  std::vector<std::size_t> strip_of(n, Clipped::kNone);
  for (std::size_t i = 0; i < n; ++i) {  // by slab: a run's first lane comes first
    if (strip_of[i] != Clipped::kNone) continue;
    std::vector<LaneEnds> run;
    for (std::size_t k = i;; k = right[k][0]) {
      const Stretch& s = lanes.pieces[k];
      const double x = slabs.centre(s.slab);
      run.push_back({{x, s.low}, {x, s.high}});
      strip_of[k] = strips.size();
      if (!follows(k)) break;
    }
    strips.push_back(to_world(run, f.frame));
  }
  for (const auto& [a, b] : links)
    if (strip_of[a] != strip_of[b]) {
      strips[strip_of[a]].neighbours.push_back(strip_of[b]);
      strips[strip_of[b]].neighbours.push_back(strip_of[a]);
    }
  return strips;
}

double height_on(const Polyline& chain, double x) {
  for (std::size_t i = 1; i < chain.size(); ++i) {
    const Point& a = chain[i - 1];
    const Point& b = chain[i];
    if (x <= b.x() && b.x() > a.x())
      return a.y() + std::clamp((x - a.x()) / (b.x() - a.x()), 0.0, 1.0) * (b.y() - a.y());
  }
  return chain.back().y();
}

// Lowest and highest of a chain between two x.
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

Polyline chain_between(const Polyline& chain, const Point& from, const Point& to) {
  Polyline link{from};
  for (const Point& p : chain)
    if (p.x() > from.x() && p.x() < to.x()) link.push_back(p);
  link.push_back(to);
  return link;
}

struct Covered {  // lanes placed so far, by position across
  double width;
  std::vector<std::pair<double, Stretch>> lanes;  // x, and its extent
  std::vector<std::vector<std::size_t>> buckets;
  double origin;
  std::size_t bucket(double x) const {
    const double k = std::floor((x - origin) / width);
    return static_cast<std::size_t>(std::clamp(k, 0.0, static_cast<double>(buckets.size() - 1)));
  }
  void add(double x, double low, double high) {
    buckets[bucket(x)].push_back(lanes.size());
    lanes.push_back({x, {0, low, high}});
  }
  // The box x0..x1, low..high lies under lanes that each span its whole height.
  bool covers(double x0, double x1, double low, double high) const {
    std::vector<double> across;
    for (std::size_t b = bucket(x0 - width); b <= bucket(x1 + width); ++b)
      for (const std::size_t i : buckets[b])
        if (lanes[i].second.low <= low && lanes[i].second.high >= high) across.push_back(lanes[i].first);
    std::sort(across.begin(), across.end());
    double reached = x0;
    for (const double x : across)
      if (x - width / 2 <= reached) reached = std::max(reached, x + width / 2);
    return reached >= x1;
  }
};

// The paper's cells. With the outline driven: lanes are projections of slabs in the cell. Without: lanes from the
// cell's first to its last vertical inclusive, and links that follow the boundary.
std::vector<Strip> exact_strips(const Field& f, bool outline, Context& context) {
  // United: turning the region may have made rings that touch cross by a hair, which the exact sweep refuses.
  const std::vector<BoustrophedonCell> cells = boustrophedon_cells(unite({f.region}));
  std::vector<Strip> of_cell(cells.size());
  std::vector<std::size_t> order(cells.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto extent = [&](std::size_t c) { return cells[c].lower.back().x() - cells[c].lower.front().x(); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return extent(a) > extent(b); });
  const Box box = bounding_box(f.region);
  const auto buckets = static_cast<std::size_t>(std::min(box.size().x() / f.width + 1, 1e7));
  Covered covered{f.width, {}, std::vector<std::vector<std::size_t>>(buckets), box.low.x()};

  for (const std::size_t c : order) {
    const BoustrophedonCell& cell = cells[c];
    const double x0 = cell.lower.front().x(), x1 = cell.lower.back().x();
    if (outline) {
      const Slabs slabs = slabs_over(x0, x1, f.step);
      std::vector<Stretch> stretches;
      for (std::size_t k = 0; k < slabs.count; ++k) {
        const double a = std::max(slabs.line(k), x0), b = std::min(slabs.line(k + 1), x1);
        const double low = range_on(cell.lower, a, b).first, high = range_on(cell.upper, a, b).second;
        if (!covered.covers(a, b, low, high)) stretches.push_back({k, low, high});
      }
      std::vector<LaneEnds> lanes;
      for (const Stretch& s : clip(stretches, slabs, f.room, 2 * f.width, f.margin).pieces) {
        const double x = slabs.centre(s.slab);
        lanes.push_back({{x, s.low}, {x, s.high}});
        covered.add(x, s.low, s.high);
      }
      of_cell[c] = to_world(lanes, f.frame);
    } else {
      const Slabs slabs = slabs_over(x0, x1, f.step);
      std::vector<LaneEnds> lanes;
      for (std::size_t k = 0; k <= slabs.count; ++k) {
        const double x = k == slabs.count ? x1 : std::max(x0, slabs.line(k));
        const double low = height_on(cell.lower, x), high = std::max(low, height_on(cell.upper, x));
        const double keep = std::min(f.margin, (high - low) / 2);
        lanes.push_back({{x, low + keep}, {x, high - keep}});
      }
      Strip strip = to_world(lanes, f.frame);
      const auto links = [&](const Polyline& chain, auto end) {
        std::vector<Polyline> all;
        for (std::size_t k = 1; k < lanes.size(); ++k) {
          Polyline link = chain_between(chain, end(lanes[k - 1]), end(lanes[k]));
          for (Point& p : link) p = f.frame.back(p);
          all.push_back(std::move(link));
        }
        return all;
      };
      strip.low_links = links(cell.lower, [](const LaneEnds& l) { return l.low; });
      strip.high_links = links(cell.upper, [](const LaneEnds& l) { return l.high; });
      of_cell[c] = std::move(strip);
    }
    if (context.cancelled()) break;
  }
  if (context.wants_traces()) {
    std::vector<Polyline> drawn;
    for (const BoustrophedonCell& cell : cells) {
      Polyline line = cell.lower;
      line.insert(line.end(), cell.upper.rbegin(), cell.upper.rend());
      line.push_back(line.front());
      for (Point& p : line) p = f.frame.back(p);
      drawn.push_back(std::move(line));
    }
    context.trace("cells", std::move(drawn));
  }
  // Cells that need no lane of their own drop out; their neighbours stay connected through them only in the tour.
  std::vector<std::size_t> index(cells.size(), Clipped::kNone);
  std::vector<Strip> strips;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (!of_cell[c].lanes.empty()) {
      index[c] = strips.size();
      strips.push_back(std::move(of_cell[c]));
    }
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const std::size_t o : cells[c].neighbours)
      if (index[c] != Clipped::kNone && index[o] != Clipped::kNone) strips[index[c]].neighbours.push_back(index[o]);
  return strips;
}

class Boustrophedon final : public CoveragePlanner {
 public:
  explicit Boustrophedon(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const double w = problem.robot().tool_width;
    const Connector connector(problem);
    const Region& c = problem.configuration_space();
    const Region region = p_.outline ? lane_region(problem, w / 2, w / 50) : c;
    Path path;
    if (!region.empty()) {
      const double step = p_.spacing * w;
      const Frame frame(p_.sweep == "given" ? p_.angle : best_lane_direction(region, step));
      const Region turned = frame.to(region);
      const EdgeIndex room(frame.to(c));
      const Field field{frame, turned, room, step, w, 2 * problem.tolerance()};
      const std::vector<Strip> strips =
          p_.cells == "exact" ? exact_strips(field, p_.outline, context) : slab_strips(field);
      path = drive_strips(problem, strips, p_.order, connector, context);
    }
    if (p_.outline && !context.cancelled()) {
      context.publish(path);
      path = with_outline(problem, path, w, connector, context);
    }
    context.publish(path);
    return path;
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo boustrophedon() {
  return describe<Boustrophedon, Params>(
      {.name = "boustrophedon",
       .family = "polygon",
       .title = "Boustrophedon decomposition",
       .citation = "Choset, Pignon 1998",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with outline)",
       .parameters = {
           {"sweep", &Params::sweep, {"best", "given"}, "lane direction: the cheapest of up to 16, or `angle`"},
           {"angle", &Params::angle, Range{-360, 360}, "degrees, lanes' direction if sweep is given"},
           {"outline", &Params::outline, "drive every wall once; off: links follow the walls, as in the paper"},
           {"cells", &Params::cells, {"slab", "exact"}, "slab: runs of lanes; exact: cut at critical points"},
           {"spacing", &Params::spacing, Range{0.1, 1}, "distance of lanes, in tool widths"},
           {"order", &Params::order, {"improved", "nearest", "dfs"}, "of cells; dfs: depth-first on their graph"}}});
}

}  // namespace oxturn
