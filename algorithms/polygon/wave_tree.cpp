#include "algorithms/polygon/wave_tree.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/disjoint_sets.hpp"

namespace oxturn {
namespace {

constexpr double kLonger = 1 + 1e-6;    // times the clearance's change: no spoke
constexpr double kNarrower = 1 - 1e-9;  // times the reach
constexpr double kLeastBranch = 1e-6;   // heights of the tree: shorter ones are rounding

/// What a tree is made of.
struct Part {
  std::vector<WaveTree::Node> nodes = {};
  std::vector<std::pair<std::size_t, std::size_t>> links = {};
  std::vector<std::size_t> leaves = {};

  void add_leaf(const Point& at, std::size_t node) {
    links.push_back({node, nodes.size()});
    leaves.push_back(nodes.size());
    nodes.push_back({at, 0});
  }
};

WaveTree tree_of(Part part) { return {std::move(part.nodes), part.links, std::move(part.leaves)}; }

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
  dead_end_.assign(nodes_.size(), false);
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
    if (!dead_end_[q])
      height_[p] = std::max(height_[p], height_[q] + distance(nodes_[p].at, nodes_[q].at));
    else if (!dead_end_[p])
      height_[p] = std::max(height_[p], reach_);
  }
}

std::size_t WaveTree::add(const Node& node, std::size_t a, std::size_t b) {
  const std::size_t added = nodes_.size();
  nodes_.push_back(node);
  dead_end_.push_back(false);
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
      if (far[next] < 0 && !dead_end_[next] && (latest >= 1 || time_[next] <= latest)) {
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
  root_ = farthest(root_);
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

/// Where links that are longer than the clearance changes pass a clearance. (Spokes are not longer.)
void WaveTree::split_dead_ends(double reach) {
  const std::size_t n = nodes_.size();
  for (std::size_t a = 0; a < n; ++a) {
    if (nodes_[a].clearance <= reach) continue;
    for (std::size_t k = first_link_[a]; k < first_link_[a + 1]; ++k) {
      const std::size_t b = links_[k];
      const double drop = nodes_[a].clearance - nodes_[b].clearance;
      if (b >= n || !(nodes_[b].clearance < reach) || distance(nodes_[a].at, nodes_[b].at) <= drop * kLonger) continue;
      add({lerp(nodes_[a].at, nodes_[b].at, (nodes_[a].clearance - reach) / drop), reach}, a, b);
    }
  }
}

void WaveTree::stop_before(double reach) {
  split_dead_ends(reach);
  reach_ = reach;
  const double narrow = reach * kNarrower;
  std::vector<std::size_t> goes_on(nodes_.size()), open;  // by node: how many links lead to no leaf and no dead end
  std::vector<bool> leaf(nodes_.size(), false);
  for (const std::size_t k : leaves_) leaf[k] = true;
  const auto ends = [&](std::size_t a) {
    return goes_on[a] <= 1 && nodes_[a].clearance < narrow && std::ranges::all_of(links(a), [&](std::size_t b) {
             return leaf[b] || dead_end_[b] || nodes_[b].clearance <= reach;
           });
  };
  for (std::size_t a = 0; a < nodes_.size(); ++a) {
    if (leaf[a]) continue;
    for (const Index b : links(a)) goes_on[a] += leaf[b] ? 0 : 1;
    if (ends(a)) open.push_back(a);
  }
  while (!open.empty()) {
    const std::size_t a = open.back();
    open.pop_back();
    dead_end_[a] = true;
    for (const Index b : links(a))
      if (!leaf[b] && !dead_end_[b] && --goes_on[b] == 1 && ends(b)) open.push_back(b);
  }
  for (const std::size_t k : leaves_) {
    const std::size_t a = links(k).front();
    dead_end_[k] = dead_end_[a] || (nodes_[a].clearance <= reach && distance(nodes_[a].at, nodes_[k].at) > reach);
  }
  if (dead_end_[root_]) root_ = static_cast<std::size_t>(std::ranges::find(dead_end_, false) - dead_end_.begin());
  orient();
}

/// Nodes where branches pass a height above the boundary.
void WaveTree::cut_at(double height) {
  const std::vector<Index> order = order_, parent = parent_;
  for (std::size_t k = 1; k < order.size(); ++k) {
    const std::size_t q = order[k], p = parent[q];
    const double size = distance(nodes_[p].at, nodes_[q].at), below = height - height_[q];
    if (dead_end_[q] || !(below > 0 && below < size)) continue;
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
    if (dead_end_[q]) time_[q] = 1;
    if (dead_end_[q] || height_[q] >= high) continue;
    const double size = distance(nodes_[p].at, nodes_[q].at), far = size + height_[q];
    time_[q] = far > 0 ? time_[p] + (1 - time_[p]) * size / far : 1;
  }
}

void WaveTree::start_at(double start_height) {
  if (start_height < height()) cut_at(start_height);
  set_times(start_height);
}

std::vector<double> WaveTree::arrivals(double start_height) {
  start_at(start_height);
  std::vector<double> times;
  for (const std::size_t leaf : leaves_) times.push_back(time_[leaf]);
  return times;
}

double WaveTree::step_variation(double start_height) {
  start_at(start_height);
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

/// Walks round the spine, from where the path to a leaf begins to where that to the next leaf does, and calls
/// f(a, b, next leaf) for each link from a to b. `start`: of all nodes, what starts() returns.
template <class F>
void WaveTree::walk_round_spine(const std::vector<Index>& start, F f) const {
  std::vector<Index> rank(nodes_.size());
  for (std::size_t k = 0; k < order_.size(); ++k) rank[order_[k]] = static_cast<Index>(k);
  std::vector<Index> down;
  const std::size_t n = leaves_.size();
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t leaf = (j + 1) % n;
    Index from = start[leaves_[j]], to = start[leaves_[leaf]];
    for (down.clear(); from != to;) {
      if (rank[from] > rank[to]) {
        f(from, parent_[from], leaf);
        from = parent_[from];
      } else {
        down.push_back(to);
        to = parent_[to];
      }
    }
    for (; !down.empty(); down.pop_back()) f(parent_[down.back()], down.back(), leaf);
  }
}

/// Of nodes without spokes, between those that have some: the first lap is straight there.
void WaveTree::interpolate_clearances() {
  const auto leaf = [&](std::size_t k) { return links(k).size() == 1; };
  const auto between = [&](std::size_t k) { return links(k).size() == 2 && !(leaf(links(k)[0]) && leaf(links(k)[1])); };
  std::vector<std::size_t> chain;
  for (std::size_t end = 0; end < nodes_.size(); ++end) {
    if (between(end)) continue;
    for (std::size_t at : links(end)) {
      chain.assign(1, end);
      while (between(at)) {
        const std::size_t next = links(at)[links(at)[0] == chain.back() ? 1 : 0];
        chain.push_back(at);
        at = next;
      }
      if (at < end) continue;  // from its other end
      double whole = distance(nodes_[chain.back()].at, nodes_[at].at), along = 0;
      for (std::size_t k = 1; k < chain.size(); ++k) whole += distance(nodes_[chain[k - 1]].at, nodes_[chain[k]].at);
      for (std::size_t k = 1; k < chain.size(); ++k) {
        along += distance(nodes_[chain[k - 1]].at, nodes_[chain[k]].at);
        nodes_[chain[k]].clearance =
            std::lerp(nodes_[end].clearance, nodes_[at].clearance, whole > 0 ? along / whole : 0.0);
      }
    }
  }
}

std::vector<WidePart> WaveTree::wide_parts(double start_height) const {
  const std::vector<Index> start = starts();
  std::vector<bool> inside(nodes_.size());  // of the first lap
  for (const Index k : order_) inside[k] = time_[k] == 0;
  for (const std::size_t leaf : leaves_) inside[start[leaf]] = false;
  std::vector<Part> parts;
  std::vector<std::vector<std::size_t>> leaf_of;  // by part, and leaf of the part
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> part_of(nodes_.size(), kNone), index(nodes_.size());
  for (const Index k : order_) {
    if (!inside[k]) continue;
    const std::size_t above = k == root_ ? kNone : part_of[parent_[k]];
    part_of[k] = above == kNone ? parts.size() : above;
    if (above == kNone) parts.emplace_back(), leaf_of.emplace_back();
    Part& part = parts[part_of[k]];
    index[k] = part.nodes.size();
    if (above != kNone) part.links.push_back({index[parent_[k]], index[k]});
    part.nodes.push_back({nodes_[k].at, std::max(0.0, nodes_[k].clearance - start_height)});
  }
  walk_round_spine(start, [&](Index a, Index b, std::size_t leaf) {
    if (part_of[a] == kNone || part_of[b] != kNone) return;
    Part& part = parts[part_of[a]];
    part.add_leaf(nodes_[b].at, index[a]);
    leaf_of[part_of[a]].push_back(start[leaves_[leaf]] == b ? leaf : WidePart::kGate);
  });
  std::vector<WidePart> result;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    result.push_back({tree_of(std::move(parts[k])), std::move(leaf_of[k])});
    result.back().tree.interpolate_clearances();
  }
  return result;
}

std::vector<WaveTree> wave_trees(const MedialAxis& axis) {
  const std::size_t n = axis.nodes.size();
  DisjointSets sets(n);
  std::vector<MedialAxis::Edge> tree;
  for (const MedialAxis::Edge& e : axis.edges)
    if (sets.unite(e.a, e.b)) tree.push_back(e);
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
  for (const MedialAxis::Spoke& s : axis.spokes) part(s.node).add_leaf(s.foot, index[s.node]);
  std::vector<WaveTree> trees;
  for (Part& p : parts)
    if (!p.leaves.empty()) trees.push_back(tree_of(std::move(p)));
  return trees;
}

}  // namespace oxturn
