// Parallel lines in each part of a partition, parts joined by a tour, then every wall once.
//
// Source      "Path generation for the BeachBot" (thesis), 2.2.4 Zig Zag Filling; Greene 1983 for the parts
// Model       polygons with holes, offline, disc footprint
// Guarantee   covers the whole target with `fit` cover, `outline`, `small_parts` merge and `margin` at most w/2:
//             let C be configuration space, w the tool width, m the margin, R the points of C at least m from its
//             boundary. The walls, driven, cover all within w/2 of them. What is partitioned is R' =
//             simplify_inward(E, 0.04 m), where E (lane_region) holds all points of C at least 0.96 m from its
//             boundary. Simplifying takes away only points within 0.04 m of the boundary of E: a point of a sliver
//             between a chain of dropped corners and its chord is, across the chord, no farther from the chain than
//             the chain from the chord. Such a point is within m of C's boundary (or beyond it, where chords make E
//             larger): covered by the walls. So R is in R' up to boundary points. The parts make up R', their slab
//             projections that of R', and a point p of R in a slab no wider than w with centre x is covered from
//             (x, p.y): no farther from p than p from the boundary, hence in C.
//             fit = literal, small_parts = drop and larger margins leave gaps, as in the seed.
// Complexity  O((n + k) log n) for n corners and k crossings of parts with slab lines, plus the partition (convex:
//             cubic, at most 150 corners), plus the tour: about O(m log m) steps and path searches for m strips
// Decisions   1. The seed puts a line *through* the start vertex: it has no two intersections there and the loop
//                ends. The first line is w/2 inside the part (literal), or the slabs are fitted (cover).
//             2. cover: all parts share one set of slabs; where two parts reach into the same slab each height
//                belongs to one of them, the larger part first, so a seam between parts costs no second lane.
//             3. The seed's start rule (leftmost vertex for lanes steeper than 45 degrees, else bottommost) decides
//                from which side the lines are counted (literal); where to enter a part is left to the tour.
//             4. sweep = best: the least sum of widths of the parts; for one part (none) as boustrophedon.
//             5. Slivers, dropped by the seed, join a neighbour (small_parts = merge).
#include <algorithm>
#include <limits>

#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/polygon/parts.hpp"
#include "algorithms/lanes/strips.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

struct Params {
  std::string partition = "auto";
  double margin = 0;
  std::string sweep = "best";
  double angle = 0;
  bool outline = true;
  std::string fit = "cover";
  std::string small_parts = "merge";
  std::string order = "improved";
};

struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

Extent across(const Part& part, const Frame& frame) {
  Extent e;
  for (const Ring& r : part.rings)
    for (const Point& p : r) e.add(frame.to(p).x());
  return e;
}

std::vector<Segment> turned_edges(const Part& part, const Frame& frame) {
  std::vector<Segment> edges;
  for (const Ring& r : part.rings) add_ring(edges, r);
  for (Segment& s : edges) s = {frame.to(s.a), frame.to(s.b)};
  return edges;
}

double least_sum_of_widths(const Region& region, const std::vector<Part>& parts) {
  double best = std::numeric_limits<double>::infinity(), direction = 0;
  for (const double d : lane_directions(region)) {
    const Frame frame(d);
    double sum = 0;
    for (const Part& p : parts) {
      const Extent e = across(p, frame);
      sum += e.high - e.low;
    }
    if (sum < best * (1 - 1e-9)) {
      best = sum;
      direction = d;
    }
  }
  return direction;
}

// The seed's start vertex lies on the low side of the lanes' frame?
bool starts_low(const Part& part, double angle, const Frame& frame) {
  const bool steep = std::abs(std::sin(angle * kPi / 180)) > std::abs(std::cos(angle * kPi / 180));
  const Point* first = &part.rings.front().front();
  for (const Ring& r : part.rings)
    for (const Point& p : r)
      if (steep ? before(p, *first) : std::pair(p.y(), p.x()) < std::pair(first->y(), first->x())) first = &p;
  const Extent e = across(part, frame);
  return frame.to(*first).x() <= (e.low + e.high) / 2;
}

struct Lane {
  long slab;  // lanes of neighbouring numbers may be driven one after the other
  double x, low, high;
};

// Takes each part's stretches out of one set of slabs, larger parts first, every height once.
std::vector<std::vector<Lane>> fitted_lanes(const std::vector<Part>& parts, const Frame& frame, const EdgeIndex& room,
                                            double width, double margin) {
  Extent all;
  std::vector<std::size_t> order(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    order[i] = i;
    const Extent e = across(parts[i], frame);
    all.add(e.low);
    all.add(e.high);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return parts[a].area > parts[b].area; });
  const Slabs slabs = slabs_over(all.low, all.high, width);
  struct Held {
    double low, high;
    std::size_t part, index;
  };
  std::vector<std::vector<Held>> held(slabs.count);  // sorted, disjoint
  std::vector<std::vector<Stretch>> owned(parts.size());
  for (const std::size_t p : order) {
    std::vector<Stretch> wanted;
    // Ring by ring: merged parts may overlap in rounding, which even-odd over all edges would turn inside out.
    if (parts.size() == 1) {
      wanted = project(turned_edges(parts[p], frame), slabs).stretches;
    } else {
      for (const Ring& r : parts[p].rings) {
        const auto some = project(turned_edges({{r}, 0}, frame), slabs).stretches;
        wanted.insert(wanted.end(), some.begin(), some.end());
      }
    }
    for (const Stretch& s : wanted) {
      std::vector<Held>& taken = held[s.slab];
      std::vector<Stretch> free;
      double from = s.low;
      bool open = true;
      for (const Held& h : taken) {
        if (h.high < from) continue;
        if (h.low > s.high) break;
        if (h.low > from) free.push_back({s.slab, from, h.low});
        from = std::max(from, h.high);
        if (from >= s.high) {
          open = false;
          break;
        }
      }
      if (open) free.push_back({s.slab, from, s.high});
      for (const Stretch& f : free) {
        // A short remainder lengthens the lane that it touches; a longer one of the same part as well.
        const auto joins = [&](const Held& h) {
          return (h.high == f.low || h.low == f.high) && (h.part == p || f.high - f.low < width / 2);
        };
        const auto beside = std::find_if(taken.begin(), taken.end(), joins);
        if (beside != taken.end()) {
          Stretch& lane = owned[beside->part][beside->index];
          lane.low = beside->low = std::min(beside->low, f.low);
          lane.high = beside->high = std::max(beside->high, f.high);
          continue;
        }
        const Held h{f.low, f.high, p, owned[p].size()};
        owned[p].push_back(f);
        taken.insert(
            std::upper_bound(taken.begin(), taken.end(), h, [](const Held& a, const Held& b) { return a.low < b.low; }),
            h);
      }
    }
  }
  std::vector<std::vector<Lane>> lanes(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::sort(owned[p].begin(), owned[p].end(),
              [](const Stretch& a, const Stretch& b) { return std::pair(a.slab, a.low) < std::pair(b.slab, b.low); });
    for (const Stretch& s : clip(owned[p], slabs, room, 2 * width, margin).pieces)
      lanes[p].push_back({static_cast<long>(s.slab), slabs.centre(s.slab), s.low, s.high});
  }
  return lanes;
}

// The seed's lines: w apart, the first w/2 inside the part.
std::vector<std::vector<Lane>> literal_lanes(const std::vector<Part>& parts, const Frame& frame, double angle,
                                             const EdgeIndex& room, double width, double margin) {
  std::vector<std::vector<Lane>> lanes(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Extent e = across(parts[p], frame);
    const bool low_first = starts_low(parts[p], angle, frame);
    const std::vector<Segment> edges = turned_edges(parts[p], frame);
    const auto count = static_cast<long>(std::floor((e.high - e.low) / width + 0.5));
    std::vector<std::vector<double>> cuts(static_cast<std::size_t>(std::max(count, 0L)));
    const auto line = [&](long k) {
      const double in = (static_cast<double>(k) + 0.5) * width;
      return low_first ? e.low + in : e.high - in;
    };
    for (const Segment& s : edges) {
      const auto [x0, x1] = std::minmax(s.a.x(), s.b.x());
      const double near = low_first ? x0 - e.low : e.high - x1, far = low_first ? x1 - e.low : e.high - x0;
      const long from = std::max(0L, static_cast<long>(std::floor(near / width - 0.5)));
      const long to = std::min(count - 1, static_cast<long>(std::ceil(far / width - 0.5)));
      for (long k = from; k <= to; ++k) {
        const double x = line(k);
        if (x0 <= x && x < x1)
          cuts[static_cast<std::size_t>(k)].push_back(s.a.y() +
                                                      (x - s.a.x()) / (s.b.x() - s.a.x()) * (s.b.y() - s.a.y()));
      }
    }
    for (long k = 0; k < count; ++k) {
      std::vector<double>& ys = cuts[static_cast<std::size_t>(k)];
      std::sort(ys.begin(), ys.end());
      for (std::size_t i = 0; i + 1 < ys.size(); i += 2)
        for (const auto& [low, high] : clip_vertical(room, line(k), ys[i], ys[i + 1], margin))
          lanes[p].push_back({k, line(k), low, high});
    }
  }
  return lanes;
}

// Runs of lanes of neighbouring slabs that overlap in height.
void add_strips(std::vector<Strip>& strips, const std::vector<Lane>& lanes, const Frame& frame) {
  struct Open {
    std::size_t strip;
    Lane last;
  };
  std::vector<Open> open, next;
  long slab = std::numeric_limits<long>::min();
  for (const Lane& lane : lanes) {
    if (lane.slab != slab) {
      open.swap(next);
      if (lane.slab != slab + 1) open.clear();
      next.clear();
      slab = lane.slab;
    }
    const auto fits = [&](const Open& o) { return o.last.low <= lane.high && lane.low <= o.last.high; };
    const auto found = std::find_if(open.begin(), open.end(), fits);
    std::size_t strip = strips.size();
    if (found != open.end()) {
      strip = found->strip;
      open.erase(found);
    } else {
      strips.emplace_back();
    }
    strips[strip].lanes.push_back({frame.back({lane.x, lane.low}), frame.back({lane.x, lane.high})});
    next.push_back({strip, lane});
  }
}

class Zigzag final : public CoveragePlanner {
 public:
  explicit Zigzag(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const double w = problem.robot().tool_width;
    const double inset = p_.margin > 0 ? p_.margin : w / 2;
    const Connector connector(problem);
    const Region& c = problem.configuration_space();
    const Region filled = simplify_inward(lane_region(problem, 0.96 * inset, 0.1 * w), 0.04 * inset);
    Path path;
    if (!filled.empty()) {
      std::vector<Part> parts = cut_into_parts(filled, p_.partition);
      if (parts.size() > 1) parts = without_slivers(std::move(parts), w, p_.small_parts == "merge");
      if (context.wants_traces()) trace_parts(parts, context);
      const double angle = p_.sweep == "given"      ? p_.angle
                           : p_.partition == "none" ? best_lane_direction(filled, w)
                                                    : least_sum_of_widths(filled, parts);
      const Frame frame(angle);
      const EdgeIndex room(frame.to(c));
      const double margin = 2 * problem.tolerance();
      std::vector<Strip> strips;
      if (!parts.empty()) {
        const auto lanes = p_.fit == "cover" ? fitted_lanes(parts, frame, room, w, margin)
                                             : literal_lanes(parts, frame, angle, room, w, margin);
        for (const std::vector<Lane>& of_part : lanes) {
          if (p_.partition != "none") {
            add_strips(strips, of_part, frame);
          } else {
            for (const Lane& lane : of_part) add_strips(strips, {lane}, frame);
          }
        }
      }
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
  static void trace_parts(const std::vector<Part>& parts, Context& context) {
    std::vector<Polyline> lines;
    for (const Part& p : parts)
      for (const Ring& r : p.rings) {
        lines.push_back(r);
        lines.back().push_back(r.front());
      }
    context.trace("parts", std::move(lines));
  }
  Params p_;
};

}  // namespace

PlannerInfo zigzag() {
  return describe<Zigzag, Params>(
      {.name = "zigzag",
       .family = "polygon",
       .title = "Zig zag filling",
       .citation = "BeachBot thesis, 2.2.4; Greene 1983",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (fit cover, with outline, slivers merged, margin up to half a tool width)",
       .parameters = {
           {"partition",
            &Params::partition,
            {"auto", "convex", "approximate", "monotone", "trapezoid", "none"},
            "parts; auto: convex up to 150 corners if CGAL finds one, else approximate; none: every line by itself"},
           {"margin", &Params::margin, Range{0, 100}, "metres that lines keep off walls; 0: half the tool width"},
           {"sweep", &Params::sweep, {"best", "given"}, "direction of lines: least sum of widths, or `angle`"},
           {"angle", &Params::angle, Range{-360, 360}, "degrees, lines' direction if sweep is given"},
           {"outline", &Params::outline, "drive every wall once"},
           {"fit",
            &Params::fit,
            {"cover", "literal"},
            "cover: no gaps; literal: lines a tool width apart, as in the seed"},
           {"small_parts", &Params::small_parts, {"merge", "drop"}, "what becomes of slivers"},
           {"order", &Params::order, {"improved", "nearest"}, "of the parts' runs of lines"}}});
}

}  // namespace oxturn
