#include "algorithms/lanes/ring_graph.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "base/disjoint_sets.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

// Spacings.
constexpr double kShared = 1.1;   // length from which a shared part connects
constexpr double kBeside = 1.3;   // distance of laps beside each other
constexpr double kRidge = 2.1;    // the same of laps of one level with no room for one between them
constexpr double kSample = 0.25;  // between the points of a lap that are looked at
constexpr auto kNone = static_cast<std::size_t>(-1);
constexpr double kSpare = 1e-9;  // of a distance, for rounding

/// Is the box about ab clearly farther from p than that?
bool clearly_farther(const Point& p, const Point& a, const Point& b, double distance) {
  const double x = std::max(std::min(a.x(), b.x()) - p.x(), p.x() - std::max(a.x(), b.x()));
  const double y = std::max(std::min(a.y(), b.y()) - p.y(), p.y() - std::max(a.y(), b.y()));
  const double far = distance * (1 + kSpare);
  return x > far || y > far || (x > 0 && y > 0 && x * x + y * y > far * far);
}

}  // namespace

MeasuredRing::MeasuredRing(const Ring& ring) : ring_(ring), begin_{0} {
  for_each_edge(ring_, [&](const Point& a, const Point& b) { begin_.push_back(begin_.back() + distance(a, b)); });
}

double MeasuredRing::wrapped(double along) const {
  const double rest = std::fmod(along, length());
  return rest < 0 ? rest + length() : rest;
}

std::size_t MeasuredRing::edge_at(double along) const {
  const auto after = std::upper_bound(begin_.begin() + 1, begin_.end() - 1, along);
  return static_cast<std::size_t>(after - begin_.begin()) - 1;
}

Point MeasuredRing::at(double along) const {
  const double s = wrapped(along);
  const std::size_t e = edge_at(s);
  const double size = begin_[e + 1] - begin_[e];
  return size > 0 ? lerp(ring_[e], ring_[(e + 1) % ring_.size()], std::min(1.0, (s - begin_[e]) / size)) : ring_[e];
}

Polyline MeasuredRing::piece(double from, double to) const {
  const double s = wrapped(from), far = to - from;
  Polyline line{at(s)};
  for (std::size_t e = edge_at(s);; ++e) {
    const double laps = static_cast<double>(e / ring_.size()) * length();
    const double next = begin_[e % ring_.size() + 1] + laps - s;
    if (next >= far) break;
    line.push_back(ring_[(e + 1) % ring_.size()]);
  }
  line.push_back(at(to));
  return line;
}

RingGraph::RingGraph(const Laps& laps, double spacing) : spacing_(spacing), level_(laps.all.size(), 0) {
  for (std::size_t k = 0; k < laps.all.size(); ++k) {
    const Ring& ring = laps.all[k].ring;
    rings_.emplace_back(ring);
    for (const std::size_t inner : laps.all[k].inner) level_[inner] = level_[k] + 1;  // parents come first
    for (std::size_t v = 0; v < ring.size(); ++v) edges_.push_back({k, v, ring[v], ring[(v + 1) % ring.size()]});
  }
  grid_ = UniformGrid(edges_.size(), [&](std::size_t e) { return std::array{edges_[e].a, edges_[e].b}; });
  find_links();
}

template <class F>
void RingGraph::for_each_near(const Point& a, const Point& b, double within, F f) const {
  grid_.visit_items(std::array{a, b}, within, [&](std::uint32_t e) {
    f(edges_[e]);
    return false;
  });
}

std::optional<RingPosition> RingGraph::nearest(std::size_t lap, const Point& p, double within) const {
  std::optional<RingPosition> best;
  for_each_near(p, p, within, [&](const Edge& e) {
    if (e.lap != lap || clearly_farther(p, e.a, e.b, best ? best->distance : within)) return;
    const Point q = nearest_on_segment(p, e.a, e.b);
    const double far = distance(p, q), along = rings_[lap].to_vertex(e.vertex) + distance(e.a, q);
    if (far > within) return;
    if (!best || std::tie(far, along) < std::tie(best->distance, best->along)) best = RingPosition{along, q, far};
  });
  return best;
}

bool RingGraph::crosses(std::size_t lap, const Point& a, const Point& b, double around, double gap) const {
  bool found = false;
  const double size = rings_[lap].length();
  for_each_near(a, b, 0, [&](const Edge& e) {
    if (found || e.lap != lap) return;
    if (orientation(a, b, e.a) == orientation(a, b, e.b) || orientation(e.a, e.b, a) == orientation(e.a, e.b, b))
      return;
    const double den = cross(b - a, e.b - e.a);
    const double t = den != 0 ? cross(a - e.a, b - a) / -den : 0;  // along the edge
    const double along = rings_[lap].to_vertex(e.vertex) + std::clamp(t, 0.0, 1.0) * distance(e.a, e.b);
    found = std::abs(std::remainder(along - around, size)) > gap * (1 + 1e-9) + 1e-9 * size;
  });
  return found;
}

double RingGraph::reach(std::size_t lap, std::size_t other) const {
  return (level_[lap] == level_[other] ? kRidge : kBeside) * spacing_;
}

std::vector<double> RingGraph::beside(std::size_t lap, std::size_t other, double reach, double step) const {
  const double size = rings_[lap].length(), samples = std::max(1.0, std::floor(size / step));
  std::vector<double> found;
  for (double k = 0; k < samples; ++k) {
    const double along = k * size / samples;
    if (nearest(other, rings_[lap].at(along), reach)) found.push_back(along);
  }
  return found;
}

/// The shared parts of a lap with laps of its own level and of the one before.
void RingGraph::add_samples(std::size_t lap) {
  struct Near {
    double distance;
    std::size_t lap = kNone;
  };
  const double size = rings_[lap].length(), samples = std::max(1.0, std::ceil(size / (kSample * spacing_)));
  std::map<std::size_t, double> shared;
  for (double k = 0; k < samples; ++k) {
    const Point p = rings_[lap].at(k * size / samples);
    Near outer{kBeside * spacing_}, level{kRidge * spacing_};  // none farther counts
    for_each_near(p, p, kRidge * spacing_, [&](const Edge& e) {
      const int up = level_[lap] - level_[e.lap];
      if (e.lap == lap || up < 0 || up > 1) return;
      Near& best = up == 1 ? outer : level;
      if (clearly_farther(p, e.a, e.b, best.distance)) return;
      const double far = distance_to_segment(p, e.a, e.b);
      if (std::tie(far, e.lap) < std::tie(best.distance, best.lap)) best = {far, e.lap};
    });
    if (outer.lap != kNone) shared[outer.lap] += size / samples;
    if (level.lap != kNone) shared[level.lap] += size / samples;
  }
  for (const auto& [other, metres] : shared)
    if (metres > kShared * spacing_) links_.push_back({other, lap, metres, level_[other] == level_[lap]});
}

void RingGraph::find_links() {
  for (std::size_t lap = 0; lap < rings_.size(); ++lap) add_samples(lap);
  neighbours_.resize(rings_.size());
  for (const Link& l : links_) {
    neighbours_[l.outer].push_back(l.inner);
    neighbours_[l.inner].push_back(l.outer);
  }
  for (std::vector<std::size_t>& all : neighbours_) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
}

LapTree RingGraph::tree(std::size_t root, LinkLaps by) const {
  std::vector<Link> links = links_;
  const double sign = by == LinkLaps::shortest_shared ? 1 : -1;
  const auto key = [&](const Link& l) { return std::tuple(l.ridge, sign * l.shared, l.outer, l.inner); };
  std::sort(links.begin(), links.end(), [&](const Link& a, const Link& b) { return key(a) < key(b); });
  DisjointSets sets(size());
  std::vector<std::vector<std::size_t>> neighbours(size());
  for (const Link& l : links) {
    if (!sets.unite(l.outer, l.inner)) continue;
    neighbours[l.outer].push_back(l.inner);
    neighbours[l.inner].push_back(l.outer);
  }
  LapTree tree{std::vector<std::optional<std::size_t>>(size()), std::vector<std::vector<std::size_t>>(size()), {root}};
  for (std::size_t k = 0; k < tree.order.size(); ++k) {
    const std::size_t lap = tree.order[k];
    std::sort(neighbours[lap].begin(), neighbours[lap].end());
    for (const std::size_t other : neighbours[lap]) {
      if (tree.parent[lap] == other) continue;
      tree.parent[other] = lap;
      tree.children[lap].push_back(other);
      tree.order.push_back(other);
    }
  }
  return tree;
}

}  // namespace oxturn
