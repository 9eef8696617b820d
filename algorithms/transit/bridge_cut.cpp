#include "algorithms/transit/bridge_cut.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/predicates.hpp"
#include "geometry/ring_boxes.hpp"
#include "geometry/tether/geodesic_field.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostVertices = 200'000;    // of configuration space
constexpr std::size_t kMostRounds = 24;           // in each, what the tether does not reach is found
constexpr std::size_t kMostMeasured = 1'200'000;  // vertices in all rounds together
constexpr double kBeyond = 2;                     // widths by which lines reach into walls
constexpr double kAway = 2;                       // widths between a line and the start or the anchor, at least
constexpr double kWallWithin = 1.1;     // radii: distance of configuration space from walls; its arcs are polygons
constexpr double kSpecksPerTool = 100;  // parts with less area than the tool's width squared over this do not count

struct Bridge {
  std::size_t a, b;  // rings of configuration space
  double length;     // in configuration space, metres
  Point from, to;    // inside walls
};

struct Stretch {
  Point a, b;
  std::size_t asked = 1;  // how often a path over it was
};

/// Shortest paths of the robot from its start, which are a tree: the straight parts, each once.
class DrivenTree {
 public:
  explicit DrivenTree(const Problem& problem)
      : from_start_(problem.configuration_space(), problem.start(), {}, problem.tolerance()) {}

  /// Asks for the path to p.
  void add(const Point& p) {
    const Polyline path = from_start_.path(p);
    for (std::size_t k = 1; k < path.size(); ++k) {
      const auto [known, fresh] = by_end_.try_emplace({path[k].x(), path[k].y()}, stretches_.size());
      if (fresh)
        stretches_.push_back({path[k - 1], path[k]});
      else
        ++stretches_[known->second].asked;
    }
  }

  const std::vector<Stretch>& stretches() const { return stretches_; }
  /// As barriers of a mesh.
  std::vector<Polyline> lines() const {
    std::vector<Polyline> lines;
    for (const Stretch& s : stretches_) lines.push_back({s.a, s.b});
    return lines;
  }

 private:
  GeodesicField from_start_;
  std::map<std::pair<double, double>, std::size_t> by_end_;  // the stretch
  std::vector<Stretch> stretches_;
};

class BridgeCut {
 public:
  BridgeCut(const Problem& problem, double width)
      : problem_(problem), width_(width), free_(problem.map().free), driven_(problem) {
    number_rings();
    add_candidates(Mesh(problem.map().free), bridges_);
    add_candidates(problem.transit().mesh(), bridges_);
  }

  std::optional<std::vector<Polyline>> find() {
    driven_.add(problem_.walls().nearest(anchor())->point);
    for (std::size_t left = std::min(kMostRounds, kMostMeasured / ring_.size()); left > 0; --left) {
      auto tree = this->tree();
      if (!tree) return std::nullopt;
      const auto far = too_far(tree->lines);
      if (!far) return std::nullopt;
      if (far->empty()) return std::move(tree->lines);
      const std::size_t known = driven_.stretches().size();
      for (const Point& p : *far) driven_.add(p);
      // Otherwise the next round would be the same.
      if (!tree->crosses && driven_.stretches().size() == known) return std::nullopt;
    }
    return std::nullopt;
  }

 private:
  struct Tree {
    explicit Tree(std::size_t rings) : connected(rings) {}
    bool whole() const { return lines.size() + 1 == connected.size(); }
    DisjointSets connected;  // rings
    std::vector<Polyline> lines;
    bool crosses = false;  // driven lines
  };

  const Point& anchor() const { return problem_.tether()->geodesics().anchor(); }

  /// As the edges of walls() follow one another.
  void number_rings() {
    for (const Polygon& polygon : problem_.configuration_space().polygons) {
      ring_.resize(ring_.size() + polygon.outer.size(), rings_++);
      for (const Ring& hole : polygon.holes) ring_.resize(ring_.size() + hole.size(), rings_++);
    }
  }

  /// Lines between the walls next to both ends of edges, and of perpendiculars to walls.
  void add_candidates(const Mesh& mesh, std::vector<Bridge>& bridges) const {
    const auto add = [&](const Point& a, const Point& b) {
      if (const auto bridge = bridge_between(wall_at(a), wall_at(b))) bridges.push_back(*bridge);
    };
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
      const auto number = static_cast<std::int32_t>(t);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &apex = mesh.vertex(number, k), &a = mesh.vertex(number, k + 1), &b = mesh.vertex(number, k + 2);
        if (mesh.triangles()[t].neighbour[k] == Mesh::kWall)
          add(apex, nearest_on_segment(apex, a, b));
        else if (number < mesh.triangles()[t].neighbour[k])
          add(a, b);
      }
    }
  }
  Point wall_at(const Point& p) const {
    const auto wall = free_.nearest(p, kWallWithin * problem_.robot().radius + problem_.tolerance());
    return wall ? wall->point : p;
  }

  /// If the line crosses configuration space once, from ring to ring, and keeps off the start and the anchor.
  std::optional<Bridge> bridge_between(const Point& a, const Point& b) const {
    const double size = distance(a, b);
    if (size <= 2 * problem_.robot().radius) return std::nullopt;
    const Point beyond = kBeyond * width_ / size * (b - a), from = a - beyond, to = b + beyond;
    for (const Point& p : {problem_.start(), anchor()})
      if (distance_to_segment(p, from, to) < kAway * width_) return std::nullopt;
    std::vector<std::pair<std::size_t, Point>> crossed;  // ring, where
    const EdgeIndex& walls = problem_.walls();
    walls.for_each_near(bounding_box({from, to}), [&](std::size_t e) {
      const auto& [p, q] = walls.edges()[e];
      const bool left_p = orientation(from, to, p) > 0, left_q = orientation(from, to, q) > 0;
      if (left_p == left_q || orientation(p, q, from) * orientation(p, q, to) > 0) return;
      const double u = cross(to - from, p - from), v = cross(to - from, q - from);
      crossed.emplace_back(ring_[e], lerp(p, q, u / (u - v)));
    });
    if (crossed.size() != 2 || crossed[0].first == crossed[1].first) return std::nullopt;
    return Bridge{crossed[0].first, crossed[1].first, distance(crossed[0].second, crossed[1].second), from, to};
  }

  /// A short tree that connects all rings; nullopt: there is none.
  std::optional<Tree> tree() const {
    Tree tree = grown(bridges_, false);
    if (!tree.whole()) {  // what lies between driven lines may need bridges of its own
      std::vector<Bridge> bridges = bridges_;
      add_candidates(Mesh(problem_.configuration_space(), driven_.lines()), bridges);
      tree = grown(bridges, true);
    }
    return tree.whole() ? std::optional(std::move(tree)) : std::nullopt;
  }
  /// By bridges that no driven line crosses, and then, with `with_crossed`, by the others: those first that cross lines
  /// seldom asked for, so that a path asked for in each round is crossed no more in the end. Of equal ones the shortest
  /// comes first.
  Tree grown(const std::vector<Bridge>& bridges, bool with_crossed) const {
    std::vector<Box> boxes;
    for (const Stretch& s : driven_.stretches()) boxes.push_back(bounding_box({s.a, s.b}));
    const BoxIndex index(std::move(boxes));
    const auto most_asked = [&](const Bridge& bridge) {
      std::size_t most = 0;
      for (const std::uint32_t k : index.overlapping(bounding_box({bridge.from, bridge.to}))) {
        const Stretch& s = driven_.stretches()[k];
        if (s.asked > most && crossing(bridge.from, bridge.to, s.a, s.b) != Crossing::none) most = s.asked;
      }
      return most;
    };
    std::vector<std::pair<std::size_t, const Bridge*>> found;  // with how often what it crosses was asked for
    for (const Bridge& bridge : bridges)
      if (const std::size_t asked = most_asked(bridge); asked == 0 || with_crossed) found.emplace_back(asked, &bridge);
    std::ranges::stable_sort(found, [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first < b.first : a.second->length < b.second->length;
    });
    Tree tree(rings_);
    for (const auto& [asked, bridge] : found) {
      if (!tree.connected.unite(bridge->a, bridge->b)) continue;
      tree.lines.push_back({bridge->from, bridge->to});
      tree.crosses = tree.crosses || asked > 0;
    }
    return tree;
  }

  /// Vertices of the cut space for which the tether is too short. nullopt: the lines do not cut space open, or the
  /// tether cannot begin as it does.
  std::optional<std::vector<Point>> too_far(const std::vector<Polyline>& lines) const {
    const double speck = problem_.robot().tool_width * problem_.robot().tool_width / kSpecksPerTool;
    const Region open = cut_along(problem_.configuration_space(), lines, width_);
    const GeodesicField field(cut_along(problem_.map().free, lines, width_), anchor(), problem_.tether()->closed_gaps(),
                              problem_.tolerance(), problem_.start());
    if (is_too_far(problem_.start(), field)) return std::nullopt;
    std::vector<Point> far;
    std::size_t parts = 0;
    for (const Polygon& part : open.polygons) {
      if (area(part) <= speck) continue;
      if (!part.holes.empty() || ++parts > 1) return std::nullopt;
      add_ends(part.outer, field, far);
    }
    return far;
  }
  /// Of each run of vertices that are too far, the first, the farthest and the last: of one alone, the next round would
  /// find its neighbour too far.
  void add_ends(const Ring& ring, const GeodesicField& field, std::vector<Point>& far) const {
    for (std::size_t i = 0, end = 0; i < ring.size(); i = end + 1) {
      std::size_t farthest = i;
      for (end = i; end < ring.size() && is_too_far(ring[end], field); ++end)
        if (field.distance(ring[end]) > field.distance(ring[farthest])) farthest = end;
      if (end > i) far.insert(far.end(), {ring[i], ring[farthest], ring[end - 1]});
    }
  }
  bool is_too_far(const Point& p, const GeodesicField& field) const {
    const double needed = field.distance(p);
    return needed > problem_.robot().tether->length &&
           needed > problem_.tether()->geodesics().distance(p) + problem_.tolerance();
  }

  const Problem& problem_;
  double width_;
  EdgeIndex free_;
  DrivenTree driven_;
  std::vector<std::size_t> ring_;  // by edge of walls()
  std::size_t rings_ = 0;
  std::vector<Bridge> bridges_;
};

}  // namespace

std::optional<std::vector<Polyline>> bridge_cut(const Problem& problem, double width) {
  if (problem.tether()->farthest() > problem.robot().tether->length) return std::nullopt;
  if (vertex_count(problem.configuration_space()) > kMostVertices) return std::nullopt;
  return BridgeCut(problem, width).find();
}

}  // namespace oxturn
