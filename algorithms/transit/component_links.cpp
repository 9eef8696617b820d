#include "algorithms/transit/component_links.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "base/disjoint_sets.hpp"
#include "base/graph_search.hpp"

namespace oxturn {
namespace {

/// Two entry points, by index, and roughly how long the path between them is.
struct Candidate {
  double length;
  std::uint32_t a, b;
};

}  // namespace

/// The wave, and the connections that it finds. A side is known by the number that its first triangle gives it.
class ComponentLinks::Wave {
 public:
  Wave(const Mesh& mesh, const std::vector<Entry>& entries) : mesh_(mesh), entries_(entries), labels_(sides()) {
    first_.assign(mesh.triangles().size() + 1, 0);
    for (const Entry& e : entries) ++first_[static_cast<std::size_t>(e.triangle) + 1];
    for (std::size_t t = 1; t < first_.size(); ++t) first_[t] += first_[t - 1];
  }

  std::vector<Candidate> run() {
    spread();
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh_.triangles().size()); ++t) {
      meet_in(t);
      join_neighbours(t, Mesh::kWall, 0);
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::int32_t n = mesh_.triangle(t).neighbour[k]; n > t) join_neighbours(t, n, k);
    }
    return std::move(found_);
  }

 private:
  struct Label {
    std::uint32_t entry = 0;  // where the wave came from
    Point at{0, 0};           // on the side
  };

  std::size_t sides() const { return 3 * mesh_.triangles().size(); }
  bool open(std::int32_t t, std::size_t k) const { return mesh_.triangle(t).neighbour[k] != Mesh::kWall; }
  std::size_t side(std::int32_t t, std::size_t k) const {
    const std::int32_t n = mesh_.triangle(t).neighbour[k];
    return n > t ? 3 * static_cast<std::size_t>(t) + k : 3 * static_cast<std::size_t>(n) + mesh_.edge_towards(n, t);
  }
  Point nearest_on_side(std::int32_t t, std::size_t k, const Point& p) const {
    return nearest_on_segment(p, mesh_.vertex(t, k + 1), mesh_.vertex(t, k + 2));
  }
  std::span<const Entry> entries_in(std::int32_t t) const {
    const auto k = static_cast<std::size_t>(t);
    return std::span(entries_).subspan(first_[k], first_[k + 1] - first_[k]);
  }
  std::uint32_t index(const Entry& e) const { return static_cast<std::uint32_t>(&e - entries_.data()); }

  void spread() {
    std::vector<double> least(sides(), std::numeric_limits<double>::infinity());
    for (const Entry& e : entries_)
      for (std::size_t k = 0; k < 3; ++k) {
        if (!open(e.triangle, k)) continue;
        const Point at = nearest_on_side(e.triangle, k, e.at);
        const std::size_t s = side(e.triangle, k);
        if (const double length = distance(e.at, at); length < least[s]) {
          least[s] = length;
          labels_[s] = {index(e), at};
        }
      }
    std::vector<std::pair<std::size_t, double>> sources;
    for (std::size_t s = 0; s < least.size(); ++s)
      if (least[s] < std::numeric_limits<double>::infinity()) sources.emplace_back(s, least[s]);
    dijkstra(
        wave_, sides(), sources, [this](std::size_t s, const auto& reach) { expand(s, reach); },
        [](std::size_t) { return false; });
  }
  template <class Reach>
  void expand(std::size_t s, const Reach& reach) {
    const auto first = static_cast<std::int32_t>(s / 3);
    for (const std::int32_t t : {first, mesh_.triangle(first).neighbour[s % 3]})
      for (std::size_t k = 0; k < 3; ++k) {
        if (!open(t, k) || side(t, k) == s) continue;
        const Point at = nearest_on_side(t, k, labels_[s].at);
        if (reach(side(t, k), distance(labels_[s].at, at))) labels_[side(t, k)] = {labels_[s].entry, at};
      }
  }

  void connect(double length, std::uint32_t a, std::uint32_t b) {
    if (entries_[a].component != entries_[b].component) found_.push_back({length, a, b});
  }
  /// The waves that come in over the triangle's sides meet each other, and the entry points inside.
  void meet_in(std::int32_t t) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!open(t, k) || !wave_.reached(side(t, k))) continue;
      const Label& label = labels_[side(t, k)];
      const double length = wave_.cost(side(t, k));
      for (std::size_t m = 0; m < k; ++m) {
        if (!open(t, m) || !wave_.reached(side(t, m))) continue;
        const Label& other = labels_[side(t, m)];
        connect(length + distance(label.at, other.at) + wave_.cost(side(t, m)), label.entry, other.entry);
      }
      const Entry* nearest = nullptr;
      for (const Entry& e : entries_in(t))
        if (e.component != entries_[label.entry].component &&
            (!nearest || distance(e.at, label.at) < distance(nearest->at, label.at)))
          nearest = &e;
      if (nearest) connect(length + distance(label.at, nearest->at), label.entry, index(*nearest));
    }
  }
  /// Entry points in triangle t, and in its neighbour across edge k unless that is none, meet those beside them along
  /// the edge: a wave tells one component for a whole side, which may be long.
  void join_neighbours(std::int32_t t, std::int32_t neighbour, std::size_t k) {
    const Point along = mesh_.vertex(t, k + 2) - mesh_.vertex(t, k + 1);
    in_order_.clear();
    for (const Entry& e : entries_in(t)) in_order_.emplace_back(e.at.dot(along), index(e));
    if (neighbour != Mesh::kWall)
      for (const Entry& e : entries_in(neighbour)) in_order_.emplace_back(e.at.dot(along), index(e));
    std::sort(in_order_.begin(), in_order_.end());
    for (std::size_t i = 0; i + 1 < in_order_.size(); ++i) {
      const std::uint32_t a = in_order_[i].second, b = in_order_[i + 1].second;
      connect(distance(entries_[a].at, entries_[b].at), a, b);
    }
  }

  const Mesh& mesh_;
  const std::vector<Entry>& entries_;
  std::vector<std::size_t> first_;  // of each triangle's entries
  std::vector<Label> labels_;       // by side
  SearchTree<double> wave_;
  std::vector<Candidate> found_;
  std::vector<std::pair<double, std::uint32_t>> in_order_;
};

void ComponentLinks::add(const Point& p, int component, std::size_t id) {
  const std::int32_t triangle = problem_.transit().mesh().locate(p, problem_.tolerance());
  if (triangle == Mesh::kWall) return;
  entries_.push_back({p, component, triangle, id});
  count_ = std::max(count_, component + 1);
}

std::vector<ComponentLinks::Link> ComponentLinks::tree(int root) {
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.triangle < b.triangle; });
  std::vector<Candidate> candidates = Wave(problem_.transit().mesh(), entries_).run();
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
  const auto component = [&](std::uint32_t entry) { return static_cast<std::size_t>(entries_[entry].component); };
  DisjointSets joined(static_cast<std::size_t>(count_));
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> edges(joined.size());  // entries here and there
  for (const Candidate& c : candidates) {
    if (!joined.unite(component(c.a), component(c.b))) continue;
    edges[component(c.a)].emplace_back(c.a, c.b);
    edges[component(c.b)].emplace_back(c.b, c.a);
  }
  std::vector<Link> links;
  if (root >= count_) return links;
  std::vector<bool> reached(joined.size(), false);
  std::vector<std::size_t> queue{static_cast<std::size_t>(root)};
  reached[queue.front()] = true;
  breadth_first(queue, [&](std::size_t at, const auto& reach) {
    for (const auto& [from, to] : edges[at]) {
      if (reached[component(to)]) continue;
      auto path = problem_.transit().path(entries_[from].at, entries_[to].at);
      if (!path) continue;
      reached[component(to)] = true;
      links.push_back({entries_[from].id, entries_[to].id, std::move(*path)});
      reach(component(to));
    }
  });
  return links;
}

}  // namespace oxturn
