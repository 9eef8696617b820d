#include "geometry/mesh/medial_axis.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "base/math.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/mesh/voronoi_predicates.hpp"
#include "geometry/overlay/lattice.hpp"

namespace oxturn {
namespace {

struct SiteSegment {
  LatticePoint a, b;
};

using Diagram = boost::polygon::voronoi_diagram<double>;
constexpr auto kNone = static_cast<std::size_t>(-1);
constexpr double kMostChords = 200;  // of one parabola

/// A boundary edge, or the vertex where one begins.
struct Site {
  std::size_t edge;
  bool vertex;
  /// Sorts sites along the boundary.
  std::size_t order() const { return 2 * edge + (vertex ? 0 : 1); }
  friend bool operator==(const Site&, const Site&) = default;
};

/// To a thousandth of a quantum: the last bits differ between machines, as long double does.
double rounded_to_fraction(double quanta) { return std::nearbyint(quanta * 1024) / 1024; }

/// The Voronoi diagram of a region's edges.
class Voronoi {
 public:
  explicit Voronoi(const Region& region) : lattice_(finite_box(region)) {
    for_each_snapped_ring(region, lattice_, [&](std::vector<LatticePoint>& ring, RingKind) {
      const std::size_t n = ring.size(), first = segments_.size();
      for (std::size_t k = 0; n > 2 && k < n; ++k) {
        segments_.push_back({ring[k], ring[(k + 1) % n]});
        next_.push_back(first + (k + 1) % n);
        previous_.push_back(first + (k + n - 1) % n);
        ring_.push_back(rings_);
      }
      ++rings_;
    });
    build();
  }

  const Diagram& diagram() const { return *diagram_; }
  std::size_t rings() const { return rings_; }
  std::size_t ring(const Site& s) const { return ring_[s.edge]; }
  Point from(const Site& s) const { return lattice_.point(segments_[s.edge].a); }
  Point to(const Site& s) const { return lattice_.point(segments_[s.edge].b); }
  std::size_t next(std::size_t edge) const { return next_[edge]; }
  double quantum() const { return lattice_.quantum(); }
  Point at(const Diagram::vertex_type& v) const {
    Point quanta(rounded_to_fraction(v.x()), rounded_to_fraction(v.y()));
    for (int k = quarters_; k < 4 && k > 0; ++k) quanta = perpendicular(quanta);
    return lattice_.point({0, 0}) + lattice_.quantum() * quanta;
  }
  Site site(const Diagram::cell_type& cell) const {
    const std::size_t e = cell.source_index();
    if (cell.contains_segment()) return {e, false};
    const bool start = cell.source_category() == boost::polygon::SOURCE_CATEGORY_SEGMENT_START_POINT;
    return {start ? e : next_[e], true};
  }
  /// The point of a site nearest to p.
  Point foot(const Site& s, const Point& p) const { return s.vertex ? from(s) : nearest_on_segment(p, from(s), to(s)); }
  /// Grows along a site in the order of the boundary: metres along an edge, the angle from the edge before about a
  /// vertex.
  double along(const Site& s, const Point& p) const {
    if (!s.vertex) return (p - from(s)).dot((to(s) - from(s)).normalized());
    const Site before{previous_[s.edge], false};
    const Point normal = perpendicular(to(before) - from(before)), towards = p - from(s);
    return -math::atan2(cross(normal, towards), normal.dot(towards));
  }

 private:
  /// Boost's sweep puts a few events of nearly the same time into the wrong order, and then whole areas may be lost.
  /// From another side the same edges have other events.
  void build() {
    long fewest = std::numeric_limits<long>::max();
    for (int quarters = 0; quarters < 4 && fewest > 0; ++quarters) {
      auto diagram = std::make_unique<Diagram>();
      boost::polygon::voronoi_builder<std::int32_t, VoronoiNumbers, VoronoiPredicates> builder;
      for (const SiteSegment& s : segments_) {
        const LatticePoint a = turned(s.a, quarters), b = turned(s.b, quarters);
        builder.insert_segment(a.x, a.y, b.x, b.y);
      }
      builder.construct(diagram.get());
      if (const long found = defects(*diagram); found < fewest)
        fewest = found, quarters_ = quarters, diagram_ = std::move(diagram);
    }
  }
  static LatticePoint turned(LatticePoint p, int quarters) {
    for (int k = 0; k < quarters; ++k) p = {-p.y, p.x};
    return p;
  }
  /// 0 for a connected planar graph, with the vertex at infinity, by Euler's formula.
  static long defects(const Diagram& d) {
    return std::abs(static_cast<long>(d.num_vertices() + 1 + d.num_cells()) - static_cast<long>(d.num_edges() / 2) - 2);
  }

  Lattice lattice_;
  std::vector<SiteSegment> segments_;
  std::vector<std::size_t> next_, previous_, ring_;  // by segment
  std::size_t rings_ = 0;
  std::unique_ptr<Diagram> diagram_;
  int quarters_ = 0;  // by which the diagram is turned
};

/// Collects the part of a diagram inside a region.
class AxisMaker {
 public:
  AxisMaker(const Region& region, double chord_error)
      : voronoi_(region), inside_(region), error_(chord_error), node_(voronoi_.diagram().vertices().size(), kNone) {}

  MedialAxis make() {
    for (const Diagram::edge_type& e : voronoi_.diagram().edges())
      if (&e < e.twin() && e.is_primary() && e.is_finite()) add_edge(e);
    std::sort(feet_.begin(), feet_.end(), [](const Foot& a, const Foot& b) {
      return std::tuple(a.site, a.along, a.node) < std::tuple(b.site, b.along, b.node);
    });
    for (const Foot& f : feet_) {
      const MedialAxis::Spoke spoke{f.node, f.at};
      if (axis_.spokes.empty() || axis_.spokes.back().node != f.node || axis_.spokes.back().foot != f.at)
        axis_.spokes.push_back(spoke);
    }
    return std::move(axis_);
  }

 private:
  struct Foot {
    std::size_t site;  // order along the boundary
    double along;
    std::size_t node;
    Point at;
  };

  void add_edge(const Diagram::edge_type& e) {
    const Point a = voronoi_.at(*e.vertex0()), b = voronoi_.at(*e.vertex1());
    const Site left = voronoi_.site(*e.cell()), right = voronoi_.site(*e.twin()->cell());
    const Polyline line = left.vertex == right.vertex ? Polyline{a, b} : parabola(a, b, left, right);
    if (!inside_.contains(middle_of(line))) return;
    std::size_t from = node_of(*e.vertex0(), a);
    for (std::size_t k = 1; k < line.size(); ++k) {
      const bool last = k + 1 == line.size();
      const std::size_t to = last ? node_of(*e.vertex1(), b) : axis_.nodes.size();
      if (!last) axis_.nodes.push_back({line[k], distance(line[k], voronoi_.foot(left, line[k]))});
      for (const Site& s : {left, right}) {
        if (k == 1) add_foot(from, s);
        add_foot(to, s);
      }
      axis_.edges.push_back({from, to});
      from = to;
    }
  }

  static Point middle_of(const Polyline& line) {
    const std::size_t k = line.size() / 2;
    return line.size() % 2 == 0 ? Point((line[k - 1] + line[k]) / 2) : line[k];
  }

  std::size_t node_of(const Diagram::vertex_type& v, const Point& at) {
    std::size_t& node = node_[static_cast<std::size_t>(&v - voronoi_.diagram().vertices().data())];
    if (node == kNone) {
      node = axis_.nodes.size();
      axis_.nodes.push_back({at, std::numeric_limits<double>::infinity()});
    }
    return node;
  }

  void add_foot(std::size_t node, const Site& site) {
    MedialAxis::Node& n = axis_.nodes[node];
    const Point foot = voronoi_.foot(site, n.at);
    n.clearance = std::min(n.clearance, distance(n.at, foot));
    if (n.clearance > voronoi_.quantum())
      feet_.push_back({site.order(), voronoi_.along(site, n.at), node, foot});
    else if (site.vertex || distance(foot, voronoi_.from(site)) <= distance(foot, voronoi_.to(site)))
      feet_.push_back({2 * site.edge, 0, node, n.at});  // a convex vertex: the same for both edges
    else
      feet_.push_back({2 * voronoi_.next(site.edge), 0, node, n.at});
  }

  /// Between a vertex and an edge, from a to b.
  Polyline parabola(const Point& a, const Point& b, const Site& left, const Site& right) const {
    const Site& focus_site = left.vertex ? left : right;
    const Site& edge = left.vertex ? right : left;
    const Point origin = voronoi_.from(edge), x = (voronoi_.to(edge) - origin).normalized(), y = perpendicular(x);
    const Point focus = voronoi_.from(focus_site) - origin;
    const double fx = focus.dot(x), fy = focus.dot(y), x0 = (a - origin).dot(x), x1 = (b - origin).dot(x);
    Polyline line{a};
    if (fy != 0) {
      const double chord = std::sqrt(8 * std::abs(fy) * error_);  // the parabola's second derivative is 1 / fy
      const double n = std::clamp(std::ceil(std::abs(x1 - x0) / chord), 1.0, kMostChords);
      for (double k = 1; k < n; ++k) {
        const double u = x0 + (x1 - x0) * k / n;
        line.push_back(origin + u * x + ((u - fx) * (u - fx) / fy + fy) / 2 * y);
      }
    }
    line.push_back(b);
    return line;
  }

  Voronoi voronoi_;
  EdgeIndex inside_;
  double error_;
  MedialAxis axis_;
  std::vector<std::size_t> node_;  // by index of the diagram's vertex
  std::vector<Foot> feet_;
};

/// Where two sites come nearest to each other.
Polyline shortest_between(const Voronoi& voronoi, const Site& s, const Site& t) {
  Polyline best;
  const auto offer = [&](const Point& p, const Point& q) {
    if (best.empty() || distance(p, q) < distance(best[0], best[1])) best = {p, q};
  };
  for (const Point& p : s.vertex ? Polyline{voronoi.from(s)} : Polyline{voronoi.from(s), voronoi.to(s)})
    offer(p, voronoi.foot(t, p));
  for (const Point& q : t.vertex ? Polyline{voronoi.from(t)} : Polyline{voronoi.from(t), voronoi.to(t)})
    offer(voronoi.foot(s, q), q);
  return best;
}

struct Bridge {
  double length;
  std::size_t a, b;  // rings
  Polyline line;
};

/// The shortest lines between neighbouring sites of different rings, those outside of the region too; the shortest
/// first.
std::vector<Bridge> bridges_of(const Voronoi& voronoi) {
  std::vector<Bridge> bridges;
  for (const Diagram::edge_type& e : voronoi.diagram().edges()) {
    const Site s = voronoi.site(*e.cell()), t = voronoi.site(*e.twin()->cell());
    if (voronoi.ring(s) >= voronoi.ring(t)) continue;
    Polyline line = shortest_between(voronoi, s, t);
    bridges.push_back({length(line), voronoi.ring(s), voronoi.ring(t), std::move(line)});
  }
  std::ranges::stable_sort(bridges, {}, &Bridge::length);
  return bridges;
}

}  // namespace

MedialAxis medial_axis(const Region& region, double chord_error) {
  if (!(chord_error > 0)) throw std::invalid_argument("medial_axis: chord_error must be above 0");
  if (region.empty()) return {};
  return AxisMaker(region, chord_error).make();
}

RingBridges bridges_between_rings(const Region& region) {
  if (region.empty()) return {};
  const Voronoi voronoi(region);
  const EdgeIndex walls(region);
  DisjointSets rings(voronoi.rings());
  RingBridges lines;
  for (Bridge& b : bridges_of(voronoi)) {
    const Point middle = (b.line[0] + b.line[1]) / 2;
    if (!walls.contains(middle)) continue;
    if (rings.unite(b.a, b.b)) lines.tree.push_back(b.line);
    if (!lines.all.empty() && lines.all.back() == b.line) continue;
    const auto wall = walls.nearest(middle);  // nothing else is as near to its middle as its ends
    if (wall && distance(wall->point, middle) >= b.length / 2 - 4 * voronoi.quantum())
      lines.all.push_back(std::move(b.line));
  }
  return lines;
}

}  // namespace oxturn
