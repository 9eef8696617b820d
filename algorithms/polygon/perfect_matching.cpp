#include "algorithms/polygon/perfect_matching.hpp"

#include <algorithm>
#include <deque>
#include <limits>

namespace oxturn {
namespace {

using Weight = std::int64_t;
constexpr Weight kMost = std::numeric_limits<Weight>::max();

template <class T>
auto& at(T& array, int i) {
  return array[static_cast<std::size_t>(i)];
}
template <class T>
auto& at(T& array, int i, int j) {
  return array[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
}

/// Matching of greatest weight. Nodes are vertices 1 .. n and, above n, blossoms; 0 means none.
class Blossoms {
 public:
  Blossoms(int n, const std::function<Weight(int, int)>& weight)
      : n_(n),
        last_(n),
        edge_(size(), std::vector<Edge>(size())),
        vertex_in_(size(), std::vector<int>(static_cast<std::size_t>(n) + 1, 0)),
        dual_(size(), 0),
        mate_(size(), 0),
        slack_(size(), 0),
        outer_(size(), 0),
        parent_(size(), 0),
        label_(size(), Label::none),
        visited_(size(), 0),
        ring_(size()) {
    Weight greatest = 0;
    for (int u = 1; u <= n; ++u)
      for (int v = 1; v <= n; ++v) {
        at(edge_, u, v) = {u, v, u == v ? 0 : weight(u, v)};
        greatest = std::max(greatest, at(edge_, u, v).weight);
      }
    for (int u = 1; u <= n; ++u) {
      at(outer_, u) = u;
      at(vertex_in_, u, u) = u;
      at(dual_, u) = greatest;
    }
    while (augmented()) {}
  }
  int mate(int vertex) const { return mate_[static_cast<std::size_t>(vertex)]; }

 private:
  enum class Label { none, even, odd };  // distance from an unmatched node in the search forest
  struct Edge {
    int u = 0, v = 0;
    Weight weight = 0;
  };

  std::size_t size() const { return 2 * static_cast<std::size_t>(n_) + 2; }
  Weight slack_of(const Edge& e) { return at(dual_, e.u) + at(dual_, e.v) - 2 * at(edge_, e.u, e.v).weight; }
  void offer_slack(int u, int x) {
    int& best = at(slack_, x);
    if (best == 0 || slack_of(at(edge_, u, x)) < slack_of(at(edge_, best, x))) best = u;
  }
  void find_slack(int x) {
    at(slack_, x) = 0;
    for (int u = 1; u <= n_; ++u)
      if (at(edge_, u, x).weight > 0 && at(outer_, u) != x && at(label_, at(outer_, u)) == Label::even)
        offer_slack(u, x);
  }
  void enqueue(int x) {
    if (x <= n_) return queue_.push_back(x);
    for (const int y : at(ring_, x)) enqueue(y);
  }
  void set_outer(int x, int blossom) {
    at(outer_, x) = blossom;
    if (x > n_)
      for (const int y : at(ring_, x)) set_outer(y, blossom);
  }

  /// Position of a node in a blossom's ring, turned so that an even number of edges leads to it.
  int even_position(int blossom, int node) {
    std::vector<int>& ring = at(ring_, blossom);
    const auto position = static_cast<int>(std::ranges::find(ring, node) - ring.begin());
    if (position % 2 == 0) return position;
    std::reverse(ring.begin() + 1, ring.end());
    return static_cast<int>(ring.size()) - position;
  }
  void match(int u, int v) {
    const Edge e = at(edge_, u, v);
    at(mate_, u) = e.v;
    if (u <= n_) return;
    const int node = at(vertex_in_, u, e.u), position = even_position(u, node);
    std::vector<int>& ring = at(ring_, u);
    for (int i = 0; i < position; ++i) match(at(ring, i), at(ring, i ^ 1));
    match(node, v);
    std::rotate(ring.begin(), ring.begin() + position, ring.end());
  }
  void augment(int u, int v) {
    while (true) {
      const int next = at(outer_, at(mate_, u));
      match(u, v);
      if (next == 0) return;
      const int before = at(outer_, at(parent_, next));
      match(next, before);
      u = before;
      v = next;
    }
  }
  /// Where the paths to the roots meet; 0: in different trees.
  int meeting(int u, int v) {
    ++round_;
    for (; u != 0 || v != 0; std::swap(u, v)) {
      if (u == 0) continue;
      if (at(visited_, u) == round_) return u;
      at(visited_, u) = round_;
      u = at(outer_, at(mate_, u));
      if (u != 0) u = at(outer_, at(parent_, u));
    }
    return 0;
  }

  void add_side(int blossom, int from, int base) {
    for (int x = from; x != base;) {
      const int y = at(outer_, at(mate_, x));
      at(ring_, blossom).push_back(x);
      at(ring_, blossom).push_back(y);
      enqueue(y);
      x = at(outer_, at(parent_, y));
    }
  }
  void shrink(int u, int base, int v) {
    int b = n_ + 1;
    while (b <= last_ && at(outer_, b) != 0) ++b;
    last_ = std::max(last_, b);
    at(dual_, b) = 0;
    at(label_, b) = Label::even;
    at(mate_, b) = at(mate_, base);
    std::vector<int>& ring = at(ring_, b);
    ring = {base};
    add_side(b, u, base);
    std::reverse(ring.begin() + 1, ring.end());
    add_side(b, v, base);
    set_outer(b, b);
    for (int x = 1; x <= last_; ++x) at(edge_, b, x).weight = at(edge_, x, b).weight = 0;
    for (int x = 1; x <= n_; ++x) at(vertex_in_, b, x) = 0;
    for (const int y : ring) {
      for (int x = 1; x <= last_; ++x)
        if (at(edge_, b, x).weight == 0 || slack_of(at(edge_, y, x)) < slack_of(at(edge_, b, x))) {
          at(edge_, b, x) = at(edge_, y, x);
          at(edge_, x, b) = at(edge_, x, y);
        }
      for (int x = 1; x <= n_; ++x)
        if (at(vertex_in_, y, x) != 0) at(vertex_in_, b, x) = y;
    }
    find_slack(b);
  }
  void expand(int b) {
    const std::vector<int>& ring = at(ring_, b);
    for (const int y : ring) set_outer(y, y);
    const int node = at(vertex_in_, b, at(edge_, b, at(parent_, b)).u), position = even_position(b, node);
    for (int i = 0; i < position; i += 2) {
      const int x = at(ring, i), y = at(ring, i + 1);
      at(parent_, x) = at(edge_, y, x).u;
      at(label_, x) = Label::odd;
      at(label_, y) = Label::even;
      at(slack_, x) = 0;
      find_slack(y);
      enqueue(y);
    }
    at(label_, node) = Label::odd;
    at(parent_, node) = at(parent_, b);
    for (int i = position + 1; i < static_cast<int>(ring.size()); ++i) {
      at(label_, at(ring, i)) = Label::none;
      find_slack(at(ring, i));
    }
    at(outer_, b) = 0;
  }

  /// True if the matching grew.
  bool use_tight(const Edge& e) {
    const int u = at(outer_, e.u), v = at(outer_, e.v);
    if (at(label_, v) == Label::none) {
      at(parent_, v) = e.u;
      at(label_, v) = Label::odd;
      const int next = at(outer_, at(mate_, v));
      at(slack_, v) = at(slack_, next) = 0;
      at(label_, next) = Label::even;
      enqueue(next);
    } else if (at(label_, v) == Label::even) {
      const int base = meeting(u, v);
      if (base == 0) {
        augment(u, v);
        augment(v, u);
        return true;
      }
      shrink(u, base, v);
    }
    return false;
  }
  bool grow_forest() {
    while (!queue_.empty()) {
      const int u = queue_.front();
      queue_.pop_front();
      if (at(label_, at(outer_, u)) == Label::odd) continue;
      for (int v = 1; v <= n_; ++v) {
        if (at(edge_, u, v).weight <= 0 || at(outer_, u) == at(outer_, v)) continue;
        if (slack_of(at(edge_, u, v)) > 0)
          offer_slack(u, at(outer_, v));
        else if (use_tight(at(edge_, u, v)))
          return true;
      }
    }
    return false;
  }
  bool is_outer(int x) { return at(outer_, x) == x; }
  /// By how much dual variables can change before an edge becomes tight or a blossom must be expanded.
  Weight step() {
    Weight d = kMost;
    for (int b = n_ + 1; b <= last_; ++b)
      if (is_outer(b) && at(label_, b) == Label::odd) d = std::min(d, at(dual_, b) / 2);
    for (int x = 1; x <= last_; ++x) {
      if (!is_outer(x) || at(slack_, x) == 0 || at(label_, x) == Label::odd) continue;
      const Weight slack = slack_of(at(edge_, at(slack_, x), x));
      d = std::min(d, at(label_, x) == Label::none ? slack : slack / 2);
    }
    return d;
  }
  /// False if no better matching exists.
  bool change_duals(Weight d) {
    for (int u = 1; u <= n_; ++u) {
      const Label label = at(label_, at(outer_, u));
      if (label == Label::even && at(dual_, u) <= d) return false;
      at(dual_, u) += label == Label::even ? -d : label == Label::odd ? d : 0;
    }
    for (int b = n_ + 1; b <= last_; ++b)
      if (is_outer(b)) at(dual_, b) += at(label_, b) == Label::even ? 2 * d : at(label_, b) == Label::odd ? -2 * d : 0;
    return true;
  }
  /// Adds an edge to the matching.
  bool augmented() {
    std::ranges::fill(label_, Label::none);
    std::ranges::fill(slack_, 0);
    queue_.clear();
    for (int x = 1; x <= last_; ++x)
      if (is_outer(x) && at(mate_, x) == 0) {
        at(parent_, x) = 0;
        at(label_, x) = Label::even;
        enqueue(x);
      }
    if (queue_.empty()) return false;
    while (true) {
      if (grow_forest()) return true;
      if (!change_duals(step())) return false;
      for (int x = 1; x <= last_; ++x) {
        const int u = at(slack_, x);
        if (is_outer(x) && u != 0 && at(outer_, u) != x && slack_of(at(edge_, u, x)) == 0 && use_tight(at(edge_, u, x)))
          return true;
      }
      for (int b = n_ + 1; b <= last_; ++b)
        if (is_outer(b) && at(label_, b) == Label::odd && at(dual_, b) == 0) expand(b);
    }
  }

  int n_, last_;
  std::vector<std::vector<Edge>> edge_;
  std::vector<std::vector<int>> vertex_in_;  // [blossom][vertex]: the node of its ring that holds the vertex
  std::vector<Weight> dual_;
  std::vector<int> mate_, slack_, outer_, parent_;
  std::vector<Label> label_;
  std::vector<int> visited_;
  std::vector<std::vector<int>> ring_;  // of a blossom: its nodes, the base first
  std::deque<int> queue_;
  int round_ = 0;
};

}  // namespace

std::vector<std::size_t> perfect_matching(std::size_t n, const std::function<Weight(std::size_t, std::size_t)>& cost) {
  if (n == 0) return {};
  const auto of = [&](int u, int v) { return cost(static_cast<std::size_t>(u - 1), static_cast<std::size_t>(v - 1)); };
  const auto count = static_cast<int>(n);
  Weight dearest = 0;
  for (int u = 1; u <= count; ++u)
    for (int v = u + 1; v <= count; ++v) dearest = std::max(dearest, of(u, v));
  // So heavy that one more pair is worth more than any saving.
  const Weight base = (dearest + 1) * (count + 1);
  const Blossoms blossoms(count, [&](int u, int v) { return 2 * (base - of(u, v)); });
  std::vector<std::size_t> mates;
  for (int u = 1; u <= count; ++u) mates.push_back(static_cast<std::size_t>(blossoms.mate(u) - 1));
  return mates;
}

}  // namespace oxturn
