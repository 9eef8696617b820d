#include "algorithms/polygon/moving_rings.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace oxturn {
namespace {

constexpr double kSameTime = 1e-9;  // metres

}  // namespace

MovingRings::MovingRings(StraightSkeleton skeleton) : skeleton_(std::move(skeleton)), at_node_(skeleton_.nodes.size()) {
  for (std::size_t a = 0; a < skeleton_.arcs.size(); ++a) {
    at_node_[skeleton_.arcs[a].low].push_back(a);
    at_node_[skeleton_.arcs[a].high].push_back(a);
  }
}

bool MovingRings::alive(std::size_t arc, double time) const {
  const StraightSkeleton::Arc& a = skeleton_.arcs[arc];
  return skeleton_.nodes[a.low].time <= time && time < skeleton_.nodes[a.high].time;
}

Point MovingRings::at(std::size_t arc, double time) const {
  const StraightSkeleton::Node &low = skeleton_.nodes[skeleton_.arcs[arc].low],
                               &high = skeleton_.nodes[skeleton_.arcs[arc].high];
  const double size = high.time - low.time;
  return size > 0 ? lerp(low.at, high.at, std::clamp((time - low.time) / size, 0.0, 1.0)) : high.at;
}

Polyline MovingRings::closed(const MovingRing& ring, double time) const {
  Polyline line;
  for (const std::size_t arc : ring.arcs) line.push_back(at(arc, time));
  line.push_back(line.front());
  return line;
}

/// Rings of arcs that are alive: in each face, arcs in the order of its edge are the ends of segments, two by two.
std::vector<MovingRing> MovingRings::linked(const std::vector<std::size_t>& arcs, double time) const {
  std::map<std::size_t, std::vector<std::pair<double, std::size_t>>> in_face;
  for (const std::size_t a : arcs)
    for (const std::size_t f : skeleton_.arcs[a].faces)
      in_face[f].push_back({at(a, time).dot(skeleton_.directions[f]), a});
  std::map<std::size_t, std::size_t> next;
  for (auto& [face, ends] : in_face) {
    std::sort(ends.begin(), ends.end());
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2) next[ends[k].second] = ends[k + 1].second;
  }
  std::vector<MovingRing> rings;
  std::set<std::size_t> used;
  for (const std::size_t first : arcs) {
    MovingRing ring;
    std::size_t at = first;
    while (used.insert(at).second) {
      ring.arcs.push_back(at);
      const auto step = next.find(at);
      if (step == next.end()) break;
      at = step->second;
    }
    if (at == first && ring.arcs.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

std::vector<MovingRing> MovingRings::begin() const {
  std::vector<std::size_t> arcs;
  for (std::size_t a = 0; a < skeleton_.arcs.size(); ++a)
    if (alive(a, 0)) arcs.push_back(a);
  return linked(arcs, 0);
}

/// One step upwards: the arc itself if it is alive, else those that begin where it ends.
void MovingRings::collect(std::size_t arc, double to, std::vector<std::size_t>& open, std::vector<std::size_t>& found,
                          std::set<std::size_t>& seen) const {
  if (alive(arc, to)) return found.push_back(arc);
  const StraightSkeleton::Arc& a = skeleton_.arcs[arc];
  const double time = skeleton_.nodes[a.high].time;
  if (time > to) return;
  for (const std::size_t node : {a.high, a.low}) {
    if (skeleton_.nodes[node].time < time - kSameTime) continue;  // a level arc leads on from both ends
    for (const std::size_t b : at_node_[node])
      if (skeleton_.nodes[skeleton_.arcs[b].low].time >= time - kSameTime && seen.insert(b).second) open.push_back(b);
  }
}

std::vector<MovingRing> MovingRings::advance(const MovingRing& ring, double to) const {
  std::vector<std::size_t> open = ring.arcs, found;
  std::set<std::size_t> seen(open.begin(), open.end());
  while (!open.empty()) {
    const std::size_t arc = open.back();
    open.pop_back();
    collect(arc, to, open, found, seen);
  }
  std::sort(found.begin(), found.end());
  return linked(found, to);
}

std::optional<std::size_t> MovingRings::follow(std::size_t arc, double to) const {
  std::vector<std::size_t> open{arc}, found;
  std::set<std::size_t> seen{arc};
  while (!open.empty() && found.empty()) {
    const std::size_t next = open.back();
    open.pop_back();
    collect(next, to, open, found, seen);
  }
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::optional<Point> MovingRings::later(std::size_t arc, double to) const {
  const auto next = follow(arc, to);
  return next ? std::optional(at(*next, to)) : std::nullopt;
}

}  // namespace oxturn
