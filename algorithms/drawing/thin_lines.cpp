#include "algorithms/drawing/thin_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "base/math.hpp"
#include "geometry/thinned.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 1e-2;       // pen widths: error of parabolas
constexpr double kThinned = 0.02;     // pen widths
constexpr double kCorner = 1.5;       // clearances of a junction: branches that reach no further lead into a corner
constexpr double kLeastBridge = 0.5;  // pen widths, between thick parts
constexpr double kDot = 0.25;         // pen widths
constexpr double kSharpest = 1.75;    // radians by which a line may turn at a junction
constexpr std::size_t kNone = static_cast<std::size_t>(-1);

/// The part of the axis with less clearance than half the pen's width.
class ThinAxis {
 public:
  ThinAxis(const MedialAxis& axis, double half) : half_(half), nodes_(axis.nodes), thick_(axis.nodes.size(), false) {
    for (std::size_t n = 0; n < nodes_.size(); ++n) thick_[n] = nodes_[n].clearance >= half;
    for (auto [a, b] : axis.edges) {
      if (thick_[a] && thick_[b]) continue;
      if (thick_[a]) std::swap(a, b);
      if (thick_[b]) b = split(a, b, half);
      if (nodes_[a].at != nodes_[b].at) edges_.push_back({a, b});
    }
    index();
  }

  bool empty() const { return edges_.empty(); }

  void prune(double least, double least_bridge) {
    for (bool changed = true; changed;) {
      std::vector<bool> removed(edges_.size(), false);
      changed = false;
      for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (at_[n].size() == 1 && leads_nowhere(chain_from(n), least, least_bridge)) {
          for (const std::size_t e : chain_from(n).edges) removed[e] = true;
          changed = true;
        }
      std::vector<std::array<std::size_t, 2>> kept;
      for (std::size_t e = 0; e < edges_.size(); ++e)
        if (!removed[e]) kept.push_back(edges_[e]);
      edges_ = std::move(kept);
      index();
    }
  }

  std::vector<Polyline> lines() {
    join();
    std::vector<Polyline> lines;
    std::vector<bool> drawn(edges_.size(), false);
    for (const bool closed : {false, true})
      for (std::size_t e = 0; e < edges_.size(); ++e)
        for (const std::size_t side : {0, 1})
          if (!drawn[e] && (closed || mates_[e][side] == kNone)) lines.push_back(line_from(e, side, drawn));
    return lines;
  }

 private:
  /// From a node with one edge to the next with more or fewer than two.
  struct Chain {
    std::vector<std::size_t> edges, nodes;
    double length = 0;
  };

  std::size_t split(std::size_t thin, std::size_t thick, double half) {
    const double low = nodes_[thin].clearance, high = nodes_[thick].clearance;
    nodes_.push_back({lerp(nodes_[thin].at, nodes_[thick].at, (half - low) / (high - low)), half});
    thick_.push_back(true);
    return nodes_.size() - 1;
  }
  void index() {
    at_.assign(nodes_.size(), {});
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (const std::size_t n : edges_[e]) at_[n].push_back(e);
  }
  std::size_t other(std::size_t edge, std::size_t node) const { return edges_[edge][edges_[edge][0] == node ? 1 : 0]; }
  const Point& point(std::size_t node) const { return nodes_[node].at; }

  Chain chain_from(std::size_t node) const {
    Chain chain{{}, {node}};
    for (std::size_t e = at_[node][0];;) {
      const std::size_t before = chain.nodes.back(), next = other(e, before);
      chain.edges.push_back(e);
      chain.nodes.push_back(next);
      chain.length += distance(point(before), point(next));
      if (at_[next].size() != 2) return chain;
      e = at_[next][at_[next][0] == e ? 1 : 0];
    }
  }

  bool leads_nowhere(const Chain& chain, double least, double least_bridge) const {
    const std::size_t tip = chain.nodes.front(), end = chain.nodes.back();
    if (thick_[tip] && thick_[end]) return chain.length < least_bridge;
    if (thick_[tip] || thick_[end]) return at_[end].size() == 1 && chain.length < least;
    return reach(chain) <= std::max(kCorner * nodes_[end].clearance, half_);
  }
  /// Of the discs about the chain's nodes, from its end.
  double reach(const Chain& chain) const {
    double most = 0;
    for (const std::size_t n : chain.nodes)
      most = std::max(most, distance(point(n), point(chain.nodes.back())) + nodes_[n].clearance);
    return most;
  }

  /// Radians by which the line turns that comes to the node by one edge and leaves by the other.
  double turn(std::size_t node, std::size_t from, std::size_t to) const {
    const Point u = point(node) - point(other(from, node)), v = point(other(to, node)) - point(node);
    return std::abs(math::atan2(cross(u, v), u.dot(v)));
  }
  /// At each node the straightest pairs of edges.
  void join() {
    mates_.assign(edges_.size(), {kNone, kNone});
    const auto mate = [&](std::size_t edge, std::size_t node) -> std::size_t& {
      return mates_[edge][edges_[edge][0] == node ? 0 : 1];
    };
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
      for (std::size_t i = 0; i < at_[n].size(); ++i)
        for (std::size_t j = i + 1; j < at_[n].size(); ++j)
          if (const double t = turn(n, at_[n][i], at_[n][j]); at_[n].size() == 2 || t < kSharpest)
            pairs.push_back({t, at_[n][i], at_[n][j]});
      std::ranges::sort(pairs);
      for (const auto& [t, a, b] : pairs)
        if (mate(a, n) == kNone && mate(b, n) == kNone) mate(a, n) = b, mate(b, n) = a;
    }
  }
  Polyline line_from(std::size_t e, std::size_t side, std::vector<bool>& drawn) const {
    Polyline line{point(edges_[e][side])};
    for (std::size_t at = edges_[e][side]; e != kNone && !drawn[e];) {
      drawn[e] = true;
      at = other(e, at);
      line.push_back(point(at));
      e = mates_[e][edges_[e][0] == at ? 0 : 1];
    }
    return line;
  }

  double half_;  // of the pen's width
  std::vector<MedialAxis::Node> nodes_;
  std::vector<bool> thick_;  // by node: the pen fits there
  std::vector<std::array<std::size_t, 2>> edges_;
  std::vector<std::vector<std::size_t>> at_;       // edges by node
  std::vector<std::array<std::size_t, 2>> mates_;  // by edge and its end: the edge that the line goes on by
};

/// Of an area that is as large, but has no length.
std::vector<Polyline> dot(const Polygon& area, const MedialAxis& axis, double width) {
  const Point size = bounding_box(area.outer).size();
  if (axis.nodes.empty() || size.maxCoeff() < kDot * width) return {};
  const auto middle = std::ranges::max_element(axis.nodes, {}, &MedialAxis::Node::clearance);
  const Point half = kDot / 2 * width * (size.x() >= size.y() ? Point(1, 0) : Point(0, 1));
  return {{middle->at - half, middle->at + half}};
}

}  // namespace

ThinLines::ThinLines(const Polygon& area, double width)
    : area_(area), width_(width), axis_(medial_axis({{area}}, kChord * width)) {}

double ThinLines::largest_radius() const {
  double largest = 0;
  for (const MedialAxis::Node& node : axis_.nodes) largest = std::max(largest, node.clearance);
  return largest;
}

std::vector<Polyline> ThinLines::lines(double least) const {
  ThinAxis thin(axis_, width_ / 2);
  if (thin.empty()) return {};
  const bool all_thin = std::ranges::all_of(axis_.nodes, [&](const auto& n) { return n.clearance < width_ / 2; });
  thin.prune(least, kLeastBridge * width_);
  if (thin.empty()) return all_thin ? dot(area_, axis_, width_) : std::vector<Polyline>{};
  std::vector<Polyline> all = thin.lines();
  for (Polyline& line : all) line = thinned(line, kThinned * width_);
  return all;
}

}  // namespace oxturn
