#include "algorithms/polygon/strand.hpp"

#include <algorithm>

namespace oxturn {

void Strand::add(const Polyline& line, std::size_t on) {
  for (const Point& p : line) {
    if (!points.empty() && points.back() == p) continue;
    if (!points.empty()) lap.back() = on;
    points.push_back(p);
    lap.push_back(kLink);
  }
}

void Strand::reverse() {
  std::reverse(points.begin(), points.end());
  lap.pop_back();
  std::reverse(lap.begin(), lap.end());
  lap.push_back(kLink);
}

namespace {

double distance_to_box(const Point& p, const Box& box) { return distance(p, p.cwiseMax(box.low).cwiseMin(box.high)); }

}  // namespace

void SplicedPath::Lap::add(std::size_t node, const Point& from, const Point& to) {
  if (nodes.size() % kBlock == 0) boxes.emplace_back();
  nodes.push_back(node);
  boxes.back().add(from);
  boxes.back().add(to);
}

SplicedPath::SplicedPath(const Strand& first, std::size_t laps) : on_lap_(laps) { append(first); }

std::size_t SplicedPath::append(const Strand& strand) {
  const std::size_t begin = nodes_.size();
  for (std::size_t i = 0; i < strand.points.size(); ++i) {
    const bool last = i + 1 == strand.points.size();
    if (!last && strand.lap[i] != Strand::kLink)
      on_lap_[strand.lap[i]].add(nodes_.size(), strand.points[i], strand.points[i + 1]);
    nodes_.push_back({strand.points[i], strand.lap[i], last ? kEnd : nodes_.size() + 1});
  }
  return begin;
}

std::optional<SplicedPath::Position> SplicedPath::nearest(std::size_t lap, const Point& p, double reach) const {
  std::optional<Position> best;
  const Lap& on = on_lap_[lap];
  for (std::size_t k = 0; k < on.nodes.size(); ++k) {
    const double within = best ? best->distance : reach;
    if (k % kBlock == 0 && distance_to_box(p, on.boxes[k / kBlock]) > within * (1 + 1e-9)) {
      k += kBlock - 1;
      continue;
    }
    const Node& node = nodes_[on.nodes[k]];
    if (node.lap != lap) continue;
    const Point q = nearest_on_segment(p, node.at, nodes_[node.next].at);
    const double far = distance(p, q);
    if (far <= reach && (!best || far < best->distance)) best = Position{on.nodes[k], q, distance(node.at, q), far};
  }
  return best;
}

bool SplicedPath::follows(const Position& a, const Position& b, double longest) const {
  if (a.node == b.node) return a.along <= b.along && b.along - a.along <= longest;
  const std::size_t lap = nodes_[a.node].lap;
  double driven = -a.along;
  for (std::size_t n = a.node; n != b.node; n = nodes_[n].next) {
    if (nodes_[n].lap != lap || nodes_[n].next == kEnd) return false;
    driven += distance(nodes_[n].at, nodes_[nodes_[n].next].at);
    if (driven > longest) return false;
  }
  return driven + b.along <= longest;
}

std::optional<SplicedPath::Cut> SplicedPath::cut(std::size_t lap, const Point& begin, const Point& end, double reach,
                                                 double longest) const {
  const auto a = nearest(lap, begin, reach), b = nearest(lap, end, reach);
  if (!a || !b) return std::nullopt;
  if (follows(*a, *b, longest)) return Cut{*a, *b, false};
  if (follows(*b, *a, longest)) return Cut{*b, *a, true};
  return std::nullopt;
}

void SplicedPath::splice(const Cut& cut, Strand strand) {
  if (cut.backwards) strand.reverse();
  const std::size_t lap = nodes_[cut.first.node].lap, after = nodes_[cut.last.node].next;
  for (std::size_t n = nodes_[cut.first.node].next; cut.first.node != cut.last.node && n != after;) {
    const std::size_t next = nodes_[n].next;
    nodes_[n].lap = kDropped;
    n = next;
  }
  Strand whole;
  whole.add({cut.first.at}, Strand::kLink);
  whole.add({strand.points.front()}, Strand::kLink);
  for (std::size_t i = 1; i < strand.points.size(); ++i) whole.add({strand.points[i]}, strand.lap[i - 1]);
  whole.add({cut.last.at}, Strand::kLink);
  whole.lap.back() = lap;
  const std::size_t begin = append(whole), last = nodes_.size() - 1;
  on_lap_[lap].add(last, nodes_[last].at, nodes_[after].at);
  nodes_[cut.first.node].next = begin;
  nodes_[last].next = after;
}

Polyline SplicedPath::points() const {
  Polyline line;
  for (std::size_t n = 0; n != kEnd; n = nodes_[n].next)
    if (line.empty() || line.back() != nodes_[n].at) line.push_back(nodes_[n].at);
  return line;
}

}  // namespace oxturn
