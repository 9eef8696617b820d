#include "algorithms/polygon/moving_rings.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "base/disjoint_sets.hpp"

namespace oxturn {
namespace {

constexpr double kSameTime = 1e-9;  // metres

}  // namespace

MovingRings::MovingRings(StraightSkeleton skeleton)
    : skeleton_(std::move(skeleton)),
      at_node_(skeleton_.nodes.size()),
      seen_(skeleton_.arcs.size(), 0),
      end_in_face_(skeleton_.directions.size(), kNone) {
  for (std::size_t a = 0; a < skeleton_.arcs.size(); ++a) {
    at_node_[skeleton_.arcs[a].low].push_back(a);
    at_node_[skeleton_.arcs[a].high].push_back(a);
  }
  find_branches();
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

/// Rings of arcs that are alive, in ascending order: in each face, arcs in the order of its edge are the ends of
/// segments, two by two.
std::vector<MovingRing> MovingRings::linked(const std::vector<std::size_t>& arcs, double time) const {
  struct End {
    double along;
    std::size_t arc;   // its position in `arcs`
    std::size_t more;  // another end in the same face
  };
  std::vector<End> ends;
  ends.reserve(2 * arcs.size());
  std::vector<std::size_t> faces;
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    const Point p = at(arcs[k], time);
    for (const std::size_t f : skeleton_.arcs[arcs[k]].faces) {
      if (end_in_face_[f] == kNone) faces.push_back(f);
      ends.push_back({p.dot(skeleton_.directions[f]), k, std::exchange(end_in_face_[f], ends.size())});
    }
  }
  std::vector<std::size_t> next(arcs.size(), kNone);
  std::vector<End> in_face;
  for (const std::size_t f : faces) {
    in_face.clear();
    for (std::size_t e = std::exchange(end_in_face_[f], kNone); e != kNone; e = ends[e].more)
      in_face.push_back(ends[e]);
    std::ranges::sort(in_face, {}, [](const End& e) { return std::pair(e.along, e.arc); });
    for (std::size_t k = 0; k + 1 < in_face.size(); k += 2) next[in_face[k].arc] = in_face[k + 1].arc;
  }
  std::vector<MovingRing> rings;
  std::vector<bool> used(arcs.size(), false);
  for (std::size_t first = 0; first < arcs.size(); ++first) {
    MovingRing ring;
    std::size_t k = first;
    while (k != kNone && !used[k]) {
      used[k] = true;
      ring.arcs.push_back(arcs[k]);
      k = next[k];
    }
    if (k == first && ring.arcs.size() > 2) rings.push_back(std::move(ring));
  }
  return rings;
}

std::vector<MovingRing> MovingRings::begin() const {
  std::vector<std::size_t> arcs;
  for (std::size_t a = 0; a < skeleton_.arcs.size(); ++a)
    if (alive(a, 0)) arcs.push_back(a);
  return linked(arcs, 0);
}

/// The arcs that are alive at a later time and continue the given ones; with `first_only` no more than one. A step
/// upwards leads to the arcs that begin where one ends.
std::vector<std::size_t> MovingRings::followed(const std::vector<std::size_t>& arcs, double to, bool first_only) const {
  std::vector<std::size_t> open = arcs, found;
  ++walks_;
  for (const std::size_t a : arcs) seen_[a] = walks_;
  while (!open.empty() && !(first_only && !found.empty())) {
    const std::size_t arc = open.back();
    open.pop_back();
    if (alive(arc, to)) {
      found.push_back(arc);
      continue;
    }
    const StraightSkeleton::Arc& a = skeleton_.arcs[arc];
    const double time = skeleton_.nodes[a.high].time;
    if (time > to) continue;
    for (const std::size_t node : {a.high, a.low}) {
      if (skeleton_.nodes[node].time < time - kSameTime) continue;  // a level arc leads on from both ends
      for (const std::size_t b : at_node_[node])
        if (skeleton_.nodes[skeleton_.arcs[b].low].time >= time - kSameTime && seen_[b] != walks_) {
          seen_[b] = walks_;
          open.push_back(b);
        }
    }
  }
  return found;
}

std::vector<MovingRing> MovingRings::advance(const MovingRing& ring, double to) const {
  std::vector<std::size_t> found = followed(ring.arcs, to, false);
  std::sort(found.begin(), found.end());
  return linked(found, to);
}

/// From the last nodes back to the first: where parts meet, a whole has split.
void MovingRings::find_branches() {
  std::vector<std::size_t> order(skeleton_.nodes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>{}, [&](std::size_t v) { return skeleton_.nodes[v].time; });
  DisjointSets sets(order.size());
  std::vector<std::size_t> branch_of_set(order.size(), kNone);
  branch_.assign(order.size(), kNone);
  for (const std::size_t v : order) {
    std::vector<std::size_t> parts;
    const auto add = [&](std::size_t node) {
      const std::size_t b = branch_of_set[sets.find(node)];
      if (b != kNone && std::ranges::find(parts, b) == parts.end()) parts.push_back(b);
    };
    add(v);
    for (const std::size_t a : at_node_[v])
      if (skeleton_.arcs[a].low == v) add(skeleton_.arcs[a].high);
    for (const std::size_t a : at_node_[v])
      if (skeleton_.arcs[a].low == v) sets.unite(v, skeleton_.arcs[a].high);
    const double time = skeleton_.nodes[v].time;
    std::size_t branch = parts.empty() ? branches_.size() : parts.front();
    if (parts.size() != 1) {
      branch = branches_.size();
      double last = time;
      for (const std::size_t p : parts) {
        branches_[p].whole = branch;
        last = std::max(last, branches_[p].last);
      }
      branches_.push_back({time, last, std::move(parts)});
    }
    branch_[v] = branch_of_set[sets.find(v)] = branch;
  }
}

/// The branch that a ring of one time belongs to.
std::size_t MovingRings::branch_at(const MovingRing& ring, double time) const {
  std::size_t branch = branch_[skeleton_.arcs[ring.arcs.front()].high];
  while (branches_[branch].whole && branches_[*branches_[branch].whole].end > time) branch = *branches_[branch].whole;
  return branch;
}

/// How many of a branch's parts have not vanished at a later time.
std::ptrdiff_t MovingRings::parts_left(std::size_t branch, double to) const {
  return std::ranges::count_if(branches_[branch].parts, [&](std::size_t part) { return branches_[part].last > to; });
}

bool MovingRings::single(const MovingRing& ring, double time, double to) const {
  std::size_t branch = branch_at(ring, time);
  while (branches_[branch].end <= to) {
    if (parts_left(branch, to) != 1) return false;
    branch =
        *std::ranges::find_if(branches_[branch].parts, [&](std::size_t part) { return branches_[part].last > to; });
  }
  return true;
}

std::optional<double> MovingRings::split_until(const MovingRing& ring, double time, double to) const {
  const std::size_t branch = branch_at(ring, time);
  if (branches_[branch].end > to || parts_left(branch, to) < 2) return std::nullopt;
  return branches_[branch].end;
}

std::optional<std::size_t> MovingRings::follow(std::size_t arc, double to) const {
  if (alive(arc, to)) return arc;
  const std::vector<std::size_t> found = followed({arc}, to, true);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

std::optional<Point> MovingRings::later(std::size_t arc, double to) const {
  const auto next = follow(arc, to);
  return next ? std::optional(at(*next, to)) : std::nullopt;
}

}  // namespace oxturn
