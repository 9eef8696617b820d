#include "algorithms/lanes/outline.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>

#include "algorithms/lanes/flat_path.hpp"
#include "algorithms/transit/component_links.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/coarse_arcs.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMostPieces = 1e6;  // of one segment of the path
// Tool widths that laps may keep off the boundary to run straight, tried in turn, and the share of the target that they
// may miss for it.
constexpr std::array kStraightening{1.0 / 20, 1.0 / 40, 1.0 / 80, 1.0 / 160};
constexpr double kMostMissed = 5e-4;
constexpr double kChord = 1e-3;            // tool widths, of the arcs of what laps cover
constexpr double kCoarsening = 1.0 / 100;  // of the robot's radius: laps may keep as far off corners

using Rings = std::vector<const Ring*>;

/// The edges of rings in a grid.
class RingGrid {
 public:
  struct Item {
    Point a, b;
    std::uint32_t ring, edge;
  };
  /// Without the rings for which `skip` is set.
  RingGrid(const Rings& rings, const std::vector<bool>& skip) {
    for (std::uint32_t r = 0; r < rings.size(); ++r)
      for (std::uint32_t e = 0, n = static_cast<std::uint32_t>(rings[r]->size()); !skip[r] && e < n; ++e)
        items_.push_back({(*rings[r])[e], (*rings[r])[e + 1 < n ? e + 1 : 0], r, e});
    grid_ = UniformGrid(items_.size(), [&](std::size_t i) { return std::array{items_[i].a, items_[i].b}; });
  }
  /// Calls f for every edge within `reach` of the segment ab, and for some others; an edge may be repeated.
  template <class F>
  void near(const Point& a, const Point& b, double reach, F f) const {
    grid_.visit_items(std::array{a, b}, reach, [&](std::uint32_t i) {
      f(items_[i]);
      return false;
    });
  }

 private:
  std::vector<Item> items_;
  UniformGrid grid_;
};

/// A lower bound of the distance of two segments, from their bounding boxes; less than that by more than rounding.
double box_gap(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point gap = (c.cwiseMin(d) - a.cwiseMax(b)).cwiseMax(a.cwiseMin(b) - c.cwiseMax(d));
  return gap.maxCoeff() * (1 - 1e-9);
}

/// Nearest points of two segments.
struct Approach {
  double distance;
  Point first, second;
};

Approach nearest_approach(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = d - c, w = c - a;
  const double den = cross(u, v);
  if (den != 0) {
    const double s = cross(w, v) / den, t = cross(w, u) / den;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return {0, a + s * u, c + t * v};
  }
  // Without a crossing one of the nearest points is an end of a segment.
  Approach best{kInfinity, a, c};
  const auto offer = [&](const Point& p, const Point& q) {
    if (const double d_pq = distance(p, q); d_pq < best.distance) best = {d_pq, p, q};
  };
  offer(a, nearest_on_segment(a, c, d));
  offer(b, nearest_on_segment(b, c, d));
  offer(nearest_on_segment(c, a, b), c);
  offer(nearest_on_segment(d, a, b), d);
  return best;
}

/// How a ring is attached to the path or to another ring, its parent.
struct Attachment {
  double distance = kInfinity;        // metres to drive
  std::optional<std::size_t> parent;  // a ring; nullopt: the path
  std::size_t segment = 0;            // of the parent
  double along = 0;                   // metres from the beginning of that segment
  Point from{0, 0};                   // on the parent
  Point on{0, 0};                     // on the ring
  std::size_t edge = 0;               // of the ring
};

/// Every ring attached to the path or to another ring, the nearest pair first (Prim).
class RingTree {
 public:
  /// `around`: walls may lie between path and rings; nullptr: never where one is nearest to the other.
  RingTree(Rings rings, const Polyline& path, double width, const Problem* around, Context& context)
      : rings_(std::move(rings)),
        path_(path),
        around_(around),
        attached_(rings_.size(), false),
        how_(rings_.size()),
        children_(rings_.size()) {
    remaining_ = rings_.size();
    if (around_) {
      attach_within(width);
      if (remaining_ > 0) attach_around(width / 2);
      return;
    }
    // The reach doubles, so a start far from every ring does not mean many passes.
    for (double reach = width; remaining_ > 0 && !context.cancelled(); reach *= 2) attach_within(reach);
  }
  const Ring& ring(std::size_t ring) const { return *rings_[ring]; }
  const Attachment& how(std::size_t ring) const { return how_[ring]; }
  const std::vector<std::size_t>& children(std::size_t ring) const { return children_[ring]; }
  const std::vector<std::size_t>& on_path() const { return on_path_; }

 private:
  /// A segment to which rings may be attached: one of the path, or one of an attached ring.
  struct Source {
    std::optional<std::size_t> ring;  // nullopt: the path
    std::size_t segment;
    Point a, b;
  };
  /// How a ring may be attached: as how_ says, or as blocked_[*blocked] does, with a wall in between and more to drive
  /// than the distance.
  struct Offer {
    double distance;
    std::uint32_t ring;
    std::optional<std::uint32_t> blocked;
    bool operator>(const Offer& o) const {
      return std::tie(distance, ring, blocked) > std::tie(o.distance, o.ring, o.blocked);
    }
  };

  void attach_within(double reach) {
    const RingGrid grid(rings_, attached_);
    least_.assign(rings_.size(), kInfinity);
    blocked_.clear();
    gathering_ = true;
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) search(of_path(i), grid, reach);
    for (const Source& s : sources_) search(s, grid, reach);
    put_in_heap();
    while (!offers_.empty()) {
      std::ranges::pop_heap(offers_, std::greater<>());
      const Offer offer = offers_.back();
      offers_.pop_back();
      const double least = least_[offer.ring];
      if (attached_[offer.ring] || offer.distance > least) continue;
      if (offer.blocked) {
        // Only now, because most rings have been attached to something in sight before.
        Attachment& how = blocked_[*offer.blocked];
        how.distance = driven_length(how.from, how.on, std::min(reach, least));
        if (how.distance <= reach && how.distance < least) accept(offer.ring, how);
        continue;
      }
      attach(offer.ring);
      const std::size_t before = sources_.size();
      add_sources(offer.ring);
      for (std::size_t s = before; s < sources_.size(); ++s) search(sources_[s], grid, reach);
    }
  }

  /// The offers that have been gathered: the best one of each ring, and those with a wall in between.
  void put_in_heap() {
    gathering_ = false;
    for (std::uint32_t ring = 0; ring < least_.size(); ++ring)
      if (least_[ring] < kInfinity) offers_.push_back({least_[ring], ring, std::nullopt});
    std::ranges::make_heap(offers_, std::greater<>());
  }
  void push(const Offer& offer) {
    offers_.push_back(offer);
    if (!gathering_) std::ranges::push_heap(offers_, std::greater<>());
  }

  Source of_path(std::size_t segment) const { return {std::nullopt, segment, path_[segment], path_[segment + 1]}; }

  void accept(std::uint32_t ring, const Attachment& how) {
    least_[ring] = how.distance;
    how_[ring] = how;
    if (!gathering_) push({how.distance, ring, std::nullopt});
  }
  bool in_sight(const Point& p, const Point& q) const { return around_->walls().contains(p, q); }
  /// Among the walls; infinity if above `longest`.
  double driven_length(const Point& p, const Point& q, double longest) const {
    const auto path = around_->transit().path(p, q, longest);
    return path ? length(*path) : kInfinity;
  }

  void add_sources(std::size_t ring) {
    const Ring& r = *rings_[ring];
    for (std::size_t e = 0; e < r.size(); ++e) sources_.push_back({ring, e, r[e], r[(e + 1) % r.size()]});
  }

  /// As how_ says.
  void attach(std::size_t ring) {
    const Attachment& how = how_[ring];
    attached_[ring] = true;
    --remaining_;
    (how.parent ? children_[*how.parent] : on_path_).push_back(ring);
  }

  /// The other rings, along shortest paths among the walls between points at most `step` apart. Rings that cannot be
  /// reached are left out.
  void attach_around(double step) {
    const auto component = [&](const Source& s) {
      return s.ring && !attached_[*s.ring] ? static_cast<int>(*s.ring) + 1 : 0;
    };
    std::vector<Source> of_path;
    for (std::size_t i = 0; i + 1 < path_.size(); ++i) of_path.push_back(this->of_path(i));
    sources_.insert(sources_.begin(), of_path.begin(), of_path.end());
    for (std::size_t r = 0; r < rings_.size(); ++r)
      if (!attached_[r]) add_sources(r);
    ComponentLinks links(*around_);
    std::vector<std::size_t> source_of;  // by entry point
    for (std::size_t s = 0; s < sources_.size(); ++s) {
      const Source& source = sources_[s];
      const double pieces = std::clamp(std::ceil(distance(source.a, source.b) / step), 1.0, kMostPieces);
      for (double k = 0; k < pieces; ++k, source_of.push_back(s))
        links.add(lerp(source.a, source.b, k / pieces), component(source), source_of.size());
    }
    for (const ComponentLinks::Link& link : links.tree(0)) {
      const Source& to = sources_[source_of[link.to]];
      how_[*to.ring] = attachment(sources_[source_of[link.from]], to, link.path);
      attach(*to.ring);
    }
  }

  /// Ends of the link are moved along their segments to where it is shorter, as far as that is in sight.
  Attachment attachment(const Source& parent, const Source& ring, const Polyline& link) const {
    Approach ends{0, link.front(), link.back()};
    if (link.size() > 2) {
      const Point first = nearest_on_segment(link[1], parent.a, parent.b);
      const Point second = nearest_on_segment(link[link.size() - 2], ring.a, ring.b);
      if (in_sight(first, link[1])) ends.first = first;
      if (in_sight(link[link.size() - 2], second)) ends.second = second;
    } else if (const Approach m = nearest_approach(parent.a, parent.b, ring.a, ring.b); in_sight(m.first, m.second)) {
      ends = m;
    }
    return {length(link), parent.ring, parent.segment, distance(parent.a, ends.first),
            ends.first,   ends.second, ring.segment};
  }

  /// Offers the source to all rings within reach that are not attached yet.
  void search(const Source& source, const RingGrid& grid, double reach) {
    // Long segments are divided, so that the box about a slanted one stays narrow.
    const auto pieces =
        static_cast<std::size_t>(std::clamp(std::ceil(distance(source.a, source.b) / (4 * reach)), 1.0, kMostPieces));
    const double n = static_cast<double>(pieces);
    for (std::size_t k = 0; k < pieces; ++k) {
      const Point a = lerp(source.a, source.b, static_cast<double>(k) / n),
                  b = lerp(source.a, source.b, static_cast<double>(k + 1) / n);
      grid.near(a, b, reach, [&](const RingGrid::Item& item) {
        if (attached_[item.ring] || box_gap(a, b, item.a, item.b) > std::min(reach, least_[item.ring])) return;
        const Approach m = nearest_approach(a, b, item.a, item.b);
        if (m.distance > reach || m.distance >= least_[item.ring]) return;
        const Attachment how{m.distance, source.ring, source.segment, distance(source.a, m.first),
                             m.first,    m.second,    item.edge};
        if (around_ == nullptr || in_sight(m.first, m.second)) return accept(item.ring, how);
        push({how.distance, item.ring, static_cast<std::uint32_t>(blocked_.size())});
        blocked_.push_back(how);
      });
    }
  }

  Rings rings_;
  const Polyline& path_;
  const Problem* around_;
  std::vector<bool> attached_;
  std::vector<Attachment> how_;
  std::vector<std::vector<std::size_t>> children_;  // rings attached to a ring
  std::vector<std::size_t> on_path_;                // rings attached to the path
  // Of attached rings. Those of the path, which may be millions, only for attach_around().
  std::vector<Source> sources_;
  std::size_t remaining_ = 0;
  // Of the present reach: what is known of the drive to each ring, and all offers that may be shorter.
  std::vector<double> least_;
  std::vector<Attachment> blocked_;
  std::vector<Offer> offers_;  // a heap
  bool gathering_ = false;     // offers of the path, or of rings attached before, which are not in order yet
};

FlatPath flattened(const Path& path, const Point& start) {
  FlatPath flat(path, start);
  if (flat.tool.empty()) {  // nothing but the start: rings may be attached to that
    flat.points.push_back(start);
    flat.tool.push_back(false);
  }
  return flat;
}

/// Drives a path with its rings.
class RingDrive {
 public:
  RingDrive(const RingTree& tree, const Point& start, double width, const Connector& connector)
      : tree_(tree), width_(width), connector_(connector), builder_(start) {}

  Path run(const FlatPath& path) {
    std::vector<std::size_t> order = tree_.on_path();
    const auto key = [&](std::size_t ring) { return std::tuple(tree_.how(ring).segment, tree_.how(ring).along, ring); };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    auto next = order.begin();
    for (std::size_t i = 0; i < path.tool.size(); ++i) {
      for (; next != order.end() && tree_.how(*next).segment == i; ++next) {
        builder_.drive(tree_.how(*next).from, path.tool[i]);
        drive_tree(*next);
      }
      builder_.drive(path.points[i + 1], path.tool[i]);
    }
    return builder_.take();
  }

 private:
  /// A ring being driven. An explicit stack of these: rings may be attached in long chains.
  struct Visit {
    std::size_t ring;
    std::vector<std::size_t> children;  // in the order in which the robot reaches them
    std::size_t next_child = 0, edges_done = 0;
  };

  /// After how many whole edges of the ring, counted from the entry, the robot comes to a ring attached to it.
  std::size_t edges_before(std::size_t ring, std::size_t child) const {
    const Attachment &own = tree_.how(ring), &attached = tree_.how(child);
    const std::size_t n = tree_.ring(ring).size();
    const std::size_t edges = (attached.segment + n - own.edge) % n;
    const double entry = distance(tree_.ring(ring)[own.edge], own.on);
    // On the entry edge but behind the entry: that part of the edge is driven last.
    return edges == 0 && attached.along < entry ? n : edges;
  }

  Visit enter(std::size_t ring) {
    connect(tree_.how(ring).from, tree_.how(ring).on);
    std::vector<std::size_t> children = tree_.children(ring);
    const auto key = [&](std::size_t child) {
      return std::tuple(edges_before(ring, child), tree_.how(child).along, child);
    };
    std::sort(children.begin(), children.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    return {ring, std::move(children)};
  }

  /// A ring and all that are attached to it.
  void drive_tree(std::size_t root) {
    std::vector<Visit> stack;
    stack.push_back(enter(root));
    while (!stack.empty()) {
      Visit& v = stack.back();
      const Ring& ring = tree_.ring(v.ring);
      const Attachment& how = tree_.how(v.ring);
      if (v.next_child < v.children.size() && edges_before(v.ring, v.children[v.next_child]) == v.edges_done) {
        const std::size_t child = v.children[v.next_child++];
        builder_.drive(tree_.how(child).from, true);
        stack.push_back(enter(child));  // invalidates v
      } else if (v.edges_done < ring.size()) {
        ++v.edges_done;
        builder_.drive(ring[(how.edge + v.edges_done) % ring.size()], true);
      } else {
        builder_.drive(how.on, true);
        connect(how.on, how.from);
        stack.pop_back();
      }
    }
  }

  void connect(const Point& a, const Point& b) {
    const Polyline path = connector_.path(a, b);
    builder_.drive(path, length(path) <= width_);
  }

  const RingTree& tree_;
  double width_;
  const Connector& connector_;
  PathBuilder builder_;
};

Region with_coarser_arcs(const Region& space, const Problem& problem) {
  return with_coarser_arcs(space, kCoarsening * problem.robot().radius, problem.robot().tool_width / 2,
                           problem.start());
}

}  // namespace

Region coarser_space(const Problem& problem) { return with_coarser_arcs(problem.configuration_space(), problem); }

Region straightened_space(const Problem& problem) {
  const double width = problem.robot().tool_width;
  if (!problem.has_staircase_walls()) return coarser_space(problem);
  const auto covered = [&](const Region& space) {
    return area(dilate(space, width / 2, kChord * width, Bound::inside));
  };
  const Region& space = problem.configuration_space();
  const double enough = covered(space) - kMostMissed * area(problem.target());
  for (const double tolerance : kStraightening) {
    const Region straight = with_coarser_arcs(simplify_inward(space, tolerance * width), problem);
    if (covered(straight) >= enough) return straight;
  }
  return coarser_space(problem);
}

Path with_outline(const Problem& problem, const Path& path, double width, const Connector& connector,
                  Context& context) {
  const Path with_laps = with_rings(problem, straightened_space(problem), path, width, connector, context);
  return without_short_segments(with_laps, problem);
}

namespace {

/// `around`: links may have to lead around walls (RingTree); nullptr: no.
Path driven_with(const Problem& problem, const std::vector<Ring>& rings, const Path& path, double width,
                 const Connector& connector, const Problem* around, Context& context) {
  Rings all;
  for (const Ring& ring : rings) all.push_back(&ring);
  const FlatPath flat = flattened(path, problem.start());
  const RingTree tree(std::move(all), flat.points, width, around, context);
  return RingDrive(tree, problem.start(), width, connector).run(flat);
}

}  // namespace

Path with_rings(const Problem& problem, const std::vector<Ring>& rings, const Path& path, double width,
                const Connector& connector, Context& context) {
  return driven_with(problem, rings, path, width, connector, nullptr, context);
}

Path with_detours(const Problem& problem, const std::vector<Ring>& detours, const Path& path, double width,
                  const Connector& connector, Context& context) {
  return driven_with(problem, detours, path, width, connector, &problem, context);
}

Path with_rings(const Problem& problem, const Region& region, const Path& path, double width,
                const Connector& connector, Context& context) {
  std::vector<Ring> rings;
  for_each_ring(region, [&](const Ring& ring) { rings.push_back(ring); });
  return with_rings(problem, rings, path, width, connector, context);
}

Path drive_strips_and_walls(const Problem& problem, const std::vector<Strip>& strips, StripOrder order, bool outline,
                            Context& context) {
  const Connector connector(problem);
  Path path = drive_strips(problem, strips, order, connector, context);
  context.publish(path);
  if (!outline || context.cancelled()) return path;
  path = with_outline(problem, path, problem.robot().tool_width, connector, context);
  context.publish(path);
  return path;
}

}  // namespace oxturn
