#include "algorithms/polygon/wave_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/disjoint_sets.hpp"

namespace oxturn {
namespace {

constexpr double kLeastBranch = 1e-6;       // heights of the tree: shorter ones are rounding
constexpr std::size_t kManyLeaves = 32768;  // from which on laps are measured by samples
constexpr std::size_t kRun = 2;             // leaves of a sample
constexpr std::size_t kRunsForSample = 8;   // of which one is looked at

}  // namespace

WaveTree::WaveTree(std::vector<Node> nodes, const std::vector<std::pair<std::size_t, std::size_t>>& links,
                   std::vector<std::size_t> leaves)
    : nodes_(std::move(nodes)),
      links_(2 * links.size()),
      first_link_(nodes_.size() + 1, 0),
      leaves_(std::move(leaves)) {
  for (const auto& [a, b] : links) ++first_link_[a + 1], ++first_link_[b + 1];
  std::partial_sum(first_link_.begin(), first_link_.end(), first_link_.begin());
  std::vector<Index> next(first_link_.begin(), first_link_.end() - 1);
  for (const auto& [a, b] : links) {
    links_[next[a]++] = static_cast<Index>(b);
    links_[next[b]++] = static_cast<Index>(a);
  }
  renumber();
  orient();
}

/// Depth first: neighbours lie near each other in memory, where a tree of millions of nodes is walked many times.
void WaveTree::renumber() {
  std::vector<Index> order, number(nodes_.size(), static_cast<Index>(nodes_.size())), open{0};
  order.reserve(nodes_.size());
  while (!open.empty()) {
    const Index at = open.back();
    open.pop_back();
    number[at] = static_cast<Index>(order.size());
    order.push_back(at);
    for (const Index next : links(at))
      if (number[next] == nodes_.size()) open.push_back(next);
  }
  std::vector<Node> nodes;
  std::vector<Index> renumbered, first{0};
  nodes.reserve(order.size()), renumbered.reserve(links_.size()), first.reserve(first_link_.size());
  for (const Index old : order) {
    nodes.push_back(nodes_[old]);
    for (const Index next : links(old)) renumbered.push_back(number[next]);
    first.push_back(static_cast<Index>(renumbered.size()));
  }
  nodes_ = std::move(nodes), links_ = std::move(renumbered), first_link_ = std::move(first);
  for (std::size_t& leaf : leaves_) leaf = number[leaf];
}

/// Order, parents and heights from the root.
void WaveTree::orient() {
  order_.assign(1, static_cast<Index>(root_));
  order_.reserve(nodes_.size());
  parent_.assign(nodes_.size(), static_cast<Index>(root_));
  height_.assign(nodes_.size(), 0);
  for (std::size_t k = 0; k < order_.size(); ++k)
    for (const Index next : links(order_[k]))
      if (next != parent_[order_[k]]) {
        parent_[next] = order_[k];
        order_.push_back(next);
      }
  for (std::size_t k = order_.size(); k-- > 1;) {
    const std::size_t q = order_[k], p = parent_[q];
    height_[p] = std::max(height_[p], height_[q] + distance(nodes_[p].at, nodes_[q].at));
  }
}

std::size_t WaveTree::add(const Node& node, std::size_t a, std::size_t b) {
  const std::size_t added = nodes_.size();
  nodes_.push_back(node);
  for (const std::size_t end : {a, b}) {
    Index* const begin = links_.data();
    std::replace(begin + first_link_[end], begin + first_link_[end + 1], static_cast<Index>(end == a ? b : a),
                 static_cast<Index>(added));
  }
  links_.push_back(static_cast<Index>(a));
  links_.push_back(static_cast<Index>(b));
  first_link_.push_back(static_cast<Index>(links_.size()));
  return added;
}

/// Negative beyond where time is more than `latest`.
std::vector<double> WaveTree::distances(std::size_t from, double latest) const {
  std::vector<double> far(nodes_.size(), -1);
  std::vector<std::size_t> open{from};
  far[from] = 0;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const Index next : links(at))
      if (far[next] < 0 && (latest >= 1 || time_[next] <= latest)) {
        far[next] = far[at] + distance(nodes_[at].at, nodes_[next].at);
        open.push_back(next);
      }
  }
  return far;
}

void WaveTree::root_at_centre() {
  const auto farthest = [&](std::size_t from) {
    const std::vector<double> far = distances(from, 1);
    return static_cast<std::size_t>(std::ranges::max_element(far) - far.begin());
  };
  root_ = farthest(0);
  orient();
  const std::size_t end = farthest(root_);
  const double half = height_[root_] / 2;
  std::size_t q = end;
  double from_end = 0;
  while (q != root_) {
    const double size = distance(nodes_[q].at, nodes_[parent_[q]].at);
    if (from_end + size >= half) break;
    from_end += size;
    q = parent_[q];
  }
  const std::size_t p = parent_[q];
  const double size = distance(nodes_[q].at, nodes_[p].at);
  if (p != q && size > 0) {
    const double t = std::min(1.0, (half - from_end) / size);
    q = add({lerp(nodes_[q].at, nodes_[p].at, t), std::lerp(nodes_[q].clearance, nodes_[p].clearance, t)}, p, q);
  }
  root_ = q;
  orient();
}

void WaveTree::root_near(const Point& p) {
  for (std::size_t k = 0; k < nodes_.size(); ++k)
    if (distance(nodes_[k].at, p) < distance(nodes_[root_].at, p)) root_ = k;
  orient();
}

double WaveTree::greatest_clearance() const {
  double most = 0;
  for (const Node& n : nodes_) most = std::max(most, n.clearance);
  return most;
}

/// Nodes where branches pass a height above the boundary.
void WaveTree::cut_at(double height) {
  const std::vector<Index> order = order_, parent = parent_;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::size_t q = order[k], p = parent[q];
    const double size = distance(nodes_[p].at, nodes_[q].at), below = height - height_[q];
    if (!(below > 0 && below < size)) continue;
    const double t = below / size;
    add({lerp(nodes_[q].at, nodes_[p].at, t), std::lerp(nodes_[q].clearance, nodes_[p].clearance, t)}, p, q);
  }
  orient();
}

void WaveTree::set_times(double start_height) {
  const double high = start_height * (1 - 1e-12);
  time_.assign(nodes_.size(), 0);
  for (std::size_t k = 1; k < order_.size(); ++k) {
    const std::size_t q = order_[k], p = parent_[q];
    if (height_[q] >= high) continue;
    const double size = distance(nodes_[p].at, nodes_[q].at), far = size + height_[q];
    time_[q] = far > 0 ? time_[p] + (1 - time_[p]) * size / far : 1;
  }
}

std::vector<double> WaveTree::arrivals(double start_height) {
  if (start_height < height()) cut_at(start_height);
  set_times(start_height);
  std::vector<double> times;
  for (const std::size_t leaf : leaves_) times.push_back(time_[leaf]);
  return times;
}

double WaveTree::step_variation(double start_height) {
  arrivals(start_height);
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const std::size_t q : order_) {
    const double size = distance(nodes_[parent_[q]].at, nodes_[q].at), far = size + height_[q];
    if (time_[q] <= 0 || far < kLeastBranch * height()) continue;
    const double speed = far / (1 - time_[parent_[q]]);
    least = std::min(least, speed), most = std::max(most, speed);
  }
  return most > 0 ? most / least : 1;
}

/// Of each node the last ancestor, or itself, at time 0.
std::vector<WaveTree::Index> WaveTree::starts() const {
  std::vector<Index> start(nodes_.size());
  for (const Index k : order_) start[k] = time_[k] > 0 ? start[parent_[k]] : k;
  return start;
}

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
  for (std::size_t at = leaf;; at = parent_[at]) {
    path.push_back({time_[at], nodes_[at].at});
    if (time_[at] == 0) break;
  }
  std::ranges::reverse(path);
}

Point WaveTree::wave_at(const std::vector<Crossing>& path, double time, std::size_t& passed) const {
  while (passed + 1 < path.size() && path[passed + 1].time <= time) ++passed;
  const Crossing& before = path[passed];
  if (passed + 1 == path.size()) return before.at;
  const Crossing& after = path[passed + 1];
  return lerp(before.at, after.at, (time - before.time) / (after.time - before.time));
}

std::size_t WaveTree::begin_spiral(WaveSpiral& spiral, double start_height, const Point& near) {
  arrivals(start_height);
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

WaveSpiral WaveTree::spiral(double laps, double start_height, const Point& near) {
  WaveSpiral spiral;
  const std::size_t first = begin_spiral(spiral, start_height, near), n = leaves_.size();
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
  spiral.boundary = boundary_from((first + count) % n);
  return spiral;
}

WaveSpiral WaveTree::closed_laps(double laps, double start_height, const Point& near) {
  WaveSpiral spiral;
  const std::size_t first = begin_spiral(spiral, start_height, near), n = leaves_.size();
  std::vector<Crossing> link, path;
  path_to(leaves_[first], link);
  const double rings = std::max(0.0, std::ceil(laps - 1e-9) - 1);
  double last = 0;
  const auto link_to = [&](double time) {
    for (const Crossing& c : link)
      if (c.time > last && c.time < time) spiral.laps.push_back(c.at);
    last = time;
  };
  const bool no_spine = laps - rings <= 0.5;
  if (no_spine) spiral.spine.clear(), last = 1;
  for (double ring = rings; ring > 0; --ring) {
    const double time = 1 - ring / laps;
    link_to(time);
    for (std::size_t j = 0; j <= n; ++j) {
      path_to(leaves_[(first + j) % n], path);
      std::size_t passed = 0;
      spiral.laps.push_back(wave_at(path, time, passed));
    }
  }
  link_to(1);
  spiral.boundary = boundary_from(first);
  return spiral;
}

/// Of the laps between neighbouring leaves, summed over samples; time(lap, j) is when the wave is at the j-th leaf's
/// vertex of a lap.
template <class Times>
double WaveTree::sampled_length(std::size_t first, std::size_t laps, Times time) const {
  const std::size_t n = leaves_.size(), size = n < kManyLeaves ? n : kRun,
                    step = n < kManyLeaves ? n : kRun * kRunsForSample;
  std::vector<Crossing> path;
  Polyline before, now;
  double metres = 0;
  std::size_t pairs = 0;
  for (std::size_t run = 0; run < n; run += step) {
    for (std::size_t j = run; j <= std::min(run + size, n); ++j) {
      path_to(leaves_[(first + j) % n], path);
      std::size_t passed = 0;
      now.clear();
      for (std::size_t lap = 0; lap < laps; ++lap) now.push_back(wave_at(path, std::min(1.0, time(lap, j)), passed));
      if (j > run) ++pairs;
      for (std::size_t lap = 0; lap < laps && j > run && time(lap, j) <= 1; ++lap)
        metres += distance(before[lap], now[lap]);
      std::swap(before, now);
    }
  }
  return metres * static_cast<double>(n) / static_cast<double>(pairs);
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

std::vector<WaveTree> wave_trees(const MedialAxis& axis) {
  const std::size_t n = axis.nodes.size();
  DisjointSets sets(n);
  std::vector<MedialAxis::Edge> tree;
  for (const MedialAxis::Edge& e : axis.edges)
    if (sets.unite(e.a, e.b)) tree.push_back(e);
  struct Part {
    std::vector<WaveTree::Node> nodes = {};
    std::vector<std::pair<std::size_t, std::size_t>> links = {};
    std::vector<std::size_t> leaves = {};
  };
  std::vector<Part> parts;
  std::vector<std::size_t> part_of(n, n), index(n);
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t& part = part_of[sets.find(k)];
    if (part == n) part = parts.size(), parts.emplace_back();
    index[k] = parts[part].nodes.size();
    parts[part].nodes.push_back({axis.nodes[k].at, axis.nodes[k].clearance});
  }
  const auto part = [&](std::size_t node) -> Part& { return parts[part_of[sets.find(node)]]; };
  for (const MedialAxis::Edge& e : tree) part(e.a).links.push_back({index[e.a], index[e.b]});
  for (const MedialAxis::Spoke& s : axis.spokes) {
    Part& p = part(s.node);
    p.links.push_back({index[s.node], p.nodes.size()});
    p.leaves.push_back(p.nodes.size());
    p.nodes.push_back({s.foot, 0});
  }
  std::vector<WaveTree> trees;
  for (Part& p : parts)
    if (!p.leaves.empty()) trees.emplace_back(std::move(p.nodes), p.links, std::move(p.leaves));
  return trees;
}

}  // namespace oxturn
