// The laps of a wave over a tree, and how long they are.
#include <algorithm>
#include <cmath>

#include "algorithms/polygon/wave_tree.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kManyLeaves = 32768;  // from which on laps are measured by samples
constexpr std::size_t kRun = 2;             // leaves of a sample
constexpr std::size_t kRunsForSample = 8;   // of which one is looked at

}  // namespace

/// The node of the spine farthest from another one.
std::size_t WaveTree::spine_end(std::size_t from) const {
  const std::vector<double> far = distances(from, 0);
  std::size_t best = from;
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    if (time_[k] == 0 && far[k] > far[best]) best = k;
  return best;
}

/// Over all branches of the spine, each but those on the path between the ends there and back.
Polyline WaveTree::walk_spine(std::size_t from, std::size_t to) const {
  std::vector<std::size_t> before(nodes_.size(), nodes_.size()), open{from};
  before[from] = from;
  for (std::size_t k = 0; k < open.size(); ++k)
    for (const Index next : links(open[k]))
      if (before[next] == nodes_.size() && time_[next] == 0) {
        before[next] = open[k];
        open.push_back(next);
      }
  std::vector<bool> on_path(nodes_.size(), false);
  for (std::size_t at = to; !on_path[at]; at = before[at]) on_path[at] = true;
  struct Visit {
    std::size_t node, parent;
    std::size_t next = 0;
    bool last_round = false;
  };
  Polyline walk{nodes_[from].at};
  std::vector<Visit> stack{{from, from}};
  while (!stack.empty()) {
    Visit& v = stack.back();
    const std::span<const Index> links = this->links(v.node);
    std::size_t child = nodes_.size();
    while (v.next < links.size() && child == nodes_.size()) {
      const std::size_t c = links[v.next++];
      if (c != v.parent && time_[c] == 0 && on_path[c] == v.last_round) child = c;
    }
    if (child < nodes_.size()) {
      walk.push_back(nodes_[child].at);
      stack.push_back({child, v.node});
    } else if (on_path[v.node] && !v.last_round && v.node != to) {  // side branches are done
      v.last_round = true;
      v.next = 0;
    } else if (v.node == to) {
      break;
    } else {
      walk.push_back(nodes_[v.parent].at);
      stack.pop_back();
    }
  }
  return walk;
}

void WaveTree::path_to(std::size_t leaf, std::vector<Crossing>& path) const {
  path.clear();
  std::size_t at = leaf;
  for (; dead_end_[at]; at = parent_[at]) path.push_back({1, nodes_[at].at});
  if (at != leaf) path.push_back({1, nodes_[at].at});  // where the wave waits
  for (;; at = parent_[at]) {
    path.push_back({time_[at], nodes_[at].at});
    if (time_[at] == 0) break;
  }
  std::ranges::reverse(path);
}

void WaveTree::path_from(double start_height, std::size_t leaf, std::vector<Crossing>& path) const {
  path.clear();
  std::size_t at = leaf;
  while (dead_end_[at]) at = parent_[at];
  const std::size_t end = at;
  for (; height_[at] < start_height && at != root_; at = parent_[at]) path.push_back({height_[at], nodes_[at].at});
  Point start = nodes_[at].at;  // a node, unless the height is passed between two
  if (!path.empty() && height_[at] >= start_height) {
    const Crossing& below = path.back();
    const double size = distance(below.at, start), rise = start_height - below.time;
    if (rise < size) start = lerp(below.at, start, rise / size);
  }
  path.push_back({0, start});
  std::ranges::reverse(path);
  for (std::size_t k = 1; k < path.size(); ++k) {  // from heights to times
    const double size = distance(path[k - 1].at, path[k].at), far = size + path[k].time, before = path[k - 1].time;
    path[k].time = far > 0 ? before + (1 - before) * size / far : 1;
  }
  if (end != leaf) path.push_back({1, nodes_[end].at}), path.push_back({1, nodes_[leaf].at});
}

Point WaveTree::wave_at(const std::vector<Crossing>& path, double time, std::size_t& passed) const {
  while (passed + 1 < path.size() && path[passed + 1].time <= time) ++passed;
  const Crossing& before = path[passed];
  if (passed + 1 == path.size()) return before.at;
  const Crossing& after = path[passed + 1];
  return lerp(before.at, after.at, (time - before.time) / (after.time - before.time));
}

std::size_t WaveTree::begin_spiral(WaveSpiral& spiral, double start_height, const Point& near) {
  start_at(start_height);
  const std::size_t end = spine_end(root_), begin = spine_end(end), n = leaves_.size();
  const std::vector<Index> start = starts();
  std::size_t first = n;
  for (std::size_t j = 0; j < n; ++j) {
    if (start[leaves_[j]] != end) continue;
    if (first == n || distance(nodes_[leaves_[j]].at, near) < distance(nodes_[leaves_[first]].at, near)) first = j;
  }
  if (first == n) first = 0;
  spiral.spine = walk_spine(begin, start[leaves_[first]]);
  return first;
}

Polyline WaveTree::boundary_from(std::size_t leaf) const {
  Polyline boundary;
  for (std::size_t j = 0; j <= leaves_.size(); ++j) boundary.push_back(nodes_[leaves_[(leaf + j) % leaves_.size()]].at);
  return boundary;
}

void WaveTree::add_spiral(WaveSpiral& spiral, std::size_t first, double laps) const {
  const std::size_t n = leaves_.size();
  const double each = laps * static_cast<double>(n);
  const auto count = static_cast<std::size_t>(std::ceil(each - 1e-9));
  spiral.laps.reserve(spiral.spine.size() + count);  // the spine may be put before them
  spiral.laps.resize(count);
  std::vector<Crossing> path;
  for (std::size_t j = 0; j < std::min(n, count); ++j) {
    path_to(leaves_[(first + j) % n], path);
    std::size_t passed = 0;
    for (std::size_t i = j; i < count; i += n) spiral.laps[i] = wave_at(path, static_cast<double>(i) / each, passed);
  }
  path_to(leaves_[(first + count) % n], path);
  add_dead_end(path, spiral.laps);
  spiral.boundary = boundary_from((first + count) % n);
}

/// From where the wave waits to the leaf, exclusive.
void WaveTree::add_dead_end(const std::vector<Crossing>& path, Polyline& line) {
  for (std::size_t k = 0; k + 1 < path.size(); ++k)
    if (path[k].time == 1 && path[k].at != path.back().at) line.push_back(path[k].at);
}

WaveSpiral WaveTree::spiral(double laps, double start_height, const Point& near) {
  WaveSpiral spiral;
  const std::size_t first = begin_spiral(spiral, start_height, near);
  add_spiral(spiral, first, laps);
  return spiral;
}

void WaveTree::add_closed_laps(WaveSpiral& spiral, std::size_t first, double laps) const {
  const std::size_t n = leaves_.size();
  std::vector<Crossing> link, path;
  path_to(leaves_[first], link);
  const double rings = std::max(0.0, std::ceil(laps - 1e-9) - 1);
  const bool no_spine = laps - rings <= 0.5;
  if (no_spine) spiral.spine.clear(), spiral.begin = 1 - rings / laps;
  double last = no_spine ? 1 : 0;
  const auto link_to = [&](double time) {
    for (const Crossing& c : link)
      if (c.time > last && c.time < time) spiral.laps.push_back(c.at);
    last = time;
  };
  for (auto ring = static_cast<std::size_t>(rings); ring > 0; --ring) {
    const double time = 1 - static_cast<double>(ring) / laps;
    link_to(time);
    for (std::size_t j = 0; j <= n; ++j) {
      path_to(leaves_[(first + j) % n], path);
      std::size_t passed = 0;
      spiral.laps.push_back(wave_at(path, time, passed));
    }
  }
  link_to(1);
  add_dead_end(link, spiral.laps);
  spiral.boundary = boundary_from(first);
}

WaveSpiral WaveTree::closed_laps(double laps, double start_height, const Point& near) {
  WaveSpiral spiral;
  const std::size_t first = begin_spiral(spiral, start_height, near);
  add_closed_laps(spiral, first, laps);
  return spiral;
}

WaveSpiral WaveTree::laps_at(std::size_t leaf, double laps, bool closed, bool spine) const {
  WaveSpiral spiral;
  if (spine) {
    std::size_t start = leaves_[leaf];
    while (time_[start] > 0) start = parent_[start];
    spiral.spine = walk_spine(start, start);
  }
  closed ? add_closed_laps(spiral, leaf, laps) : add_spiral(spiral, leaf, std::ceil(laps - 1e-9));
  return spiral;
}

Polyline WaveTree::branch(std::size_t leaf, double time) const {
  std::vector<Crossing> path;
  path_to(leaves_[leaf], path);
  Polyline inwards;
  for (std::size_t k = path.size() - 1; k-- > 0 && path[k].time >= time;) inwards.push_back(path[k].at);
  return inwards;
}

std::size_t WaveTree::leaf_nearest(const Point& p) const {
  const auto nearer = [&](std::size_t a, std::size_t b) {
    return distance(nodes_[a].at, p) < distance(nodes_[b].at, p);
  };
  return static_cast<std::size_t>(std::ranges::min_element(leaves_, nearer) - leaves_.begin());
}

Polyline WaveTree::first_lap() const {
  const std::vector<Index> start = starts();
  Polyline lap;
  lap.reserve(leaves_.size());
  for (const std::size_t leaf : leaves_) lap.push_back(nodes_[start[leaf]].at);
  return lap;
}

/// Calls add(before, now) for the wave on neighbouring branches at the times of all laps; where there are many leaves,
/// for a sample of them. Returns how many stand for each.
template <class PathTo, class Times, class Add>
double WaveTree::sample_laps(std::size_t first, std::size_t laps, PathTo path_to, Times time, Add add) const {
  const std::size_t n = leaves_.size(), size = n < kManyLeaves ? n : kRun,
                    step = n < kManyLeaves ? n : kRun * kRunsForSample;
  std::vector<Crossing> path;
  Polyline before, now;
  std::size_t pairs = 0;
  for (std::size_t run = 0; run < n; run += step) {
    for (std::size_t j = run; j <= std::min(run + size, n); ++j) {
      path_to(leaves_[(first + j) % n], path);
      std::size_t passed = 0;
      now.clear();
      for (std::size_t lap = 0; lap < laps; ++lap) now.push_back(wave_at(path, std::min(1.0, time(lap, j)), passed));
      if (j > run) ++pairs, add(before, now, j);
      std::swap(before, now);
    }
  }
  return static_cast<double>(n) / static_cast<double>(pairs);
}

/// time(lap, j) is when the wave is at the j-th leaf's vertex of a lap.
template <class Times>
double WaveTree::sampled_length(std::size_t first, std::size_t laps, Times time) const {
  double metres = 0;
  const double each = sample_laps(
      first, laps, [this](std::size_t leaf, std::vector<Crossing>& path) { path_to(leaf, path); }, time,
      [&](const Polyline& before, const Polyline& now, std::size_t j) {
        for (std::size_t lap = 0; lap < laps; ++lap)
          if (time(lap, j) <= 1) metres += distance(before[lap], now[lap]);
      });
  return metres * each;
}

WaveTree::Measures WaveTree::begin_measures(const WaveSpiral& begun, std::size_t first) const {
  const Polyline boundary = boundary_from(first);
  return {length(begun.spine), 0, length(boundary), std::abs(signed_area({boundary.begin(), boundary.end() - 1}))};
}

WaveTree::Measures WaveTree::spiral_measures(double laps, double start_height, const Point& near) {
  WaveSpiral begun;
  const std::size_t first = begin_spiral(begun, start_height, near), n = leaves_.size();
  Measures measures = begin_measures(begun, first);
  const auto rounds = static_cast<std::size_t>(std::ceil(laps));
  measures.laps = sampled_length(first, rounds, [&](std::size_t lap, std::size_t j) {
    return (static_cast<double>(lap) + static_cast<double>(j) / static_cast<double>(n)) / laps;
  });
  return measures;
}

WaveTree::Measures WaveTree::closed_measures(double laps, double start_height, const Point& near) {
  WaveSpiral begun;
  const std::size_t first = begin_spiral(begun, start_height, near);
  Measures measures = begin_measures(begun, first);
  const double rings = std::max(0.0, std::ceil(laps - 1e-9) - 1);
  if (laps - rings <= 0.5) measures.spine = 0;
  measures.laps = sampled_length(first, static_cast<std::size_t>(rings), [&](std::size_t lap, std::size_t) {
    return 1 - (rings - static_cast<double>(lap)) / laps;
  });
  return measures;
}

WaveTree::NestedMeasures WaveTree::nested_measures(std::size_t laps, double start_height) const {
  NestedMeasures found{begin_measures({}, 0), 0};
  double first = 0, others = 0, band = 0;
  const double each = sample_laps(
      0, laps + 1, [&](std::size_t leaf, std::vector<Crossing>& path) { path_from(start_height, leaf, path); },
      [&](std::size_t lap, std::size_t) { return static_cast<double>(lap) / static_cast<double>(laps); },
      [&](const Polyline& before, const Polyline& now, std::size_t) {
        first += distance(before[0], now[0]);
        for (std::size_t lap = 1; lap < laps; ++lap) others += distance(before[lap], now[lap]);
        band += std::abs(cross(now[laps] - before[0], now[0] - before[laps])) / 2;
      });
  found.of.spine = first * each;
  found.of.laps = others * each;
  found.inside = std::max(0.0, found.of.area - band * each);
  return found;
}

}  // namespace oxturn
