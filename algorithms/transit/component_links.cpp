#include "algorithms/transit/component_links.hpp"

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <tuple>

#include "base/graph_search.hpp"

namespace oxturn {
namespace {

// Of the largest component entry points are kept within one to two such squares of another component's.
constexpr double kNear = 16;           // tool widths
constexpr double kMostSquares = 4096;  // in a row

}  // namespace

/// Finds connections. A side is known by the number that its first triangle gives it.
class ComponentLinks::Wave {
 public:
  /// `entries`: by triangle.
  Wave(const Mesh& mesh, const std::vector<Entry>& entries)
      : mesh_(mesh), entries_(entries), labels_(std::make_unique_for_overwrite<Label[]>(sides())) {
    first_.assign(mesh.triangles().size() + 1, 0);
    for (const Entry& e : entries) ++first_[static_cast<std::size_t>(e.triangle) + 1];
    for (std::size_t t = 1; t < first_.size(); ++t) first_[t] += first_[t - 1];
  }

  /// Between entry points that are in one triangle, or in two that share a side.
  std::vector<Candidate> near_ones() {
    found_.clear();
    for (std::size_t e = 0; e < entries_.size(); e += entries_in(entries_[e].triangle).size()) {
      const std::int32_t t = entries_[e].triangle;
      join_neighbours(t, Mesh::kWall, 0);
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::int32_t n = mesh_.triangle(t).neighbour[k]; n > t || (n >= 0 && entries_in(n).empty()))
          join_neighbours(t, n, k);
    }
    return std::move(found_);
  }

  /// The shortest connection from these entry points to one with foreign(component); `best` is one that is known, or
  /// of infinite length. Costs what is nearer than the answer.
  template <class Foreign>
  Candidate nearest(const std::vector<std::uint32_t>& from, Candidate best, Foreign foreign) {
    const auto look_in = [&](std::int32_t t, const Label& label, double length) {
      for (const Entry& e : entries_in(t))
        if (const double whole = length + distance(label.at, e.at); whole < best.length && foreign(e.component))
          best = {whole, label.entry, index(e)};
    };
    const auto look_beyond = [&](std::size_t s) {
      if (wave_.cost(s) >= best.length) return true;
      const auto first = static_cast<std::int32_t>(s / 3);
      for (const std::int32_t t : {first, mesh_.triangle(first).neighbour[s % 3]})
        look_in(t, labels_[s], wave_.cost(s));
      return false;
    };
    dijkstra(
        wave_, sides(), sources(from), [this](std::size_t s, const auto& reach) { expand(s, reach); }, look_beyond);
    return best;
  }

 private:
  struct Label {
    std::uint32_t entry;  // where the wave came from
    Point at;             // on the side
  };
  struct Source {
    std::size_t side;
    double length;  // from the label's entry
    Label label;
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

  /// The sides of the triangles that hold these entry points, each labelled with the nearest of them.
  const std::vector<std::pair<std::size_t, double>>& sources(const std::vector<std::uint32_t>& from) {
    offers_.clear();
    for (const std::uint32_t i : from)
      for (std::size_t k = 0; k < 3; ++k) {
        const Entry& e = entries_[i];
        if (!open(e.triangle, k)) continue;
        const Point at = nearest_on_side(e.triangle, k, e.at);
        offers_.push_back({side(e.triangle, k), distance(e.at, at), {i, at}});
      }
    std::sort(offers_.begin(), offers_.end(), [](const Source& a, const Source& b) {
      return std::tie(a.side, a.length, a.label.entry) < std::tie(b.side, b.length, b.label.entry);
    });
    sources_.clear();
    for (const Source& s : offers_) {
      if (!sources_.empty() && sources_.back().first == s.side) continue;
      sources_.emplace_back(s.side, s.length);
      labels_[s.side] = s.label;
    }
    return sources_;
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

  /// Entry points in triangle t, and in its neighbour across edge k unless that is none, are connected to those beside
  /// them along the edge, if they are of another component.
  void join_neighbours(std::int32_t t, std::int32_t neighbour, std::size_t k) {
    const Point along = mesh_.vertex(t, k + 2) - mesh_.vertex(t, k + 1);
    in_order_.clear();
    for (const Entry& e : entries_in(t)) in_order_.emplace_back(e.at.dot(along), index(e));
    if (neighbour != Mesh::kWall)
      for (const Entry& e : entries_in(neighbour)) in_order_.emplace_back(e.at.dot(along), index(e));
    std::sort(in_order_.begin(), in_order_.end());
    for (std::size_t i = 0; i + 1 < in_order_.size(); ++i) {
      const std::uint32_t a = in_order_[i].second, b = in_order_[i + 1].second;
      if (entries_[a].component != entries_[b].component)
        found_.push_back({distance(entries_[a].at, entries_[b].at), a, b});
    }
  }

  const Mesh& mesh_;
  const std::vector<Entry>& entries_;
  std::vector<std::size_t> first_;   // of each triangle's entries
  std::unique_ptr<Label[]> labels_;  // by side; set where the wave has been
  SearchTree<double> wave_;
  std::vector<Source> offers_;
  std::vector<std::pair<std::size_t, double>> sources_;
  std::vector<Candidate> found_;
  std::vector<std::pair<double, std::uint32_t>> in_order_;
};

void ComponentLinks::add(const Point& p, int component, std::size_t id) {
  all_.push_back({p, component, Mesh::kWall, id});
  count_ = std::max(count_, component + 1);
}

/// Entry points of the component with the most of them, unless they are near to one of another component, are not
/// worth locating.
std::vector<bool> ComponentLinks::near_others() const {
  std::vector<std::size_t> size(static_cast<std::size_t>(count_), 0);
  for (const Entry& e : all_) ++size[static_cast<std::size_t>(e.component)];
  const auto largest = static_cast<int>(std::ranges::max_element(size) - size.begin());
  Box box;
  for (const Entry& e : all_) box.add(e.at);
  const double side = std::max(kNear * problem_.robot().tool_width, box.size().maxCoeff() / kMostSquares);
  const auto square = [&](const Point& p) {
    return std::pair(static_cast<std::size_t>((p.x() - box.low.x()) / side) + 1,
                     static_cast<std::size_t>((p.y() - box.low.y()) / side) + 1);
  };
  const auto [columns, rows] = square(box.high);
  std::vector<bool> near((columns + 2) * (rows + 2), false);  // squares, with a border
  const auto at = [&, width = columns + 2](std::size_t i, std::size_t j) { return j * width + i; };
  for (const Entry& e : all_) {
    if (e.component == largest) continue;
    const auto [i, j] = square(e.at);
    for (std::size_t y = j - 1; y <= j + 1; ++y)
      for (std::size_t x = i - 1; x <= i + 1; ++x) near[at(x, y)] = true;
  }
  std::vector<bool> chosen;
  chosen.reserve(all_.size());
  for (const Entry& e : all_) {
    const auto [i, j] = square(e.at);
    chosen.push_back(e.component != largest || near[at(i, j)]);
  }
  return chosen;
}

/// Locates the chosen entry points and sorts them by triangle.
void ComponentLinks::locate(const std::vector<bool>& chosen) {
  entries_.clear();
  for (std::size_t k = 0; k < all_.size(); ++k) {
    if (!chosen[k]) continue;
    Entry entry = all_[k];
    entry.triangle = problem_.transit().mesh().locate(entry.at, problem_.tolerance());
    if (entry.triangle != Mesh::kWall) entries_.push_back(entry);
  }
  std::stable_sort(entries_.begin(), entries_.end(),
                   [](const Entry& a, const Entry& b) { return a.triangle < b.triangle; });
}

/// The components that are connected so far: the group of each entry point's component, in the order of their first.
std::vector<ComponentLinks::Group> ComponentLinks::groups_of(DisjointSets& joined,
                                                             const std::vector<Candidate>& near) const {
  std::vector<Group> groups;
  std::vector<std::size_t> index(joined.size(), joined.size());  // by representative
  const auto representative = [&](std::uint32_t e) {
    return joined.find(static_cast<std::size_t>(entries_[e].component));
  };
  for (std::uint32_t e = 0; e < entries_.size(); ++e) {
    const std::size_t r = representative(e);
    if (index[r] == joined.size()) {
      index[r] = groups.size();
      groups.emplace_back();
    }
    groups[index[r]].entries.push_back(e);
  }
  for (const Candidate& c : near) {
    const std::size_t a = representative(c.a), b = representative(c.b);
    for (const std::size_t r : {a, b})
      if (Candidate& best = groups[index[r]].best; a != b && c.length < best.length) best = c;
  }
  return groups;
}

/// Boruvka's algorithm: each group but the one with the most entry points is connected to what is nearest outside,
/// until there is one group only.
std::vector<ComponentLinks::Candidate> ComponentLinks::connections() const {
  Wave wave(problem_.transit().mesh(), entries_);
  const std::vector<Candidate> near = wave.near_ones();
  DisjointSets joined(static_cast<std::size_t>(count_));
  const auto component = [&](std::uint32_t e) { return static_cast<std::size_t>(entries_[e].component); };
  std::vector<Candidate> chosen;
  for (bool any = true; any;) {
    const std::vector<Group> groups = groups_of(joined, near);
    const auto largest = std::ranges::max_element(groups, {}, [](const Group& g) { return g.entries.size(); });
    std::vector<Candidate> offers;
    for (auto group = groups.begin(); group != groups.end(); ++group) {
      if (group == largest) continue;
      const std::size_t mine = component(group->entries.front());
      offers.push_back(wave.nearest(group->entries, group->best,
                                    [&](int other) { return !joined.same(mine, static_cast<std::size_t>(other)); }));
    }
    std::stable_sort(offers.begin(), offers.end(),
                     [](const Candidate& a, const Candidate& b) { return a.length < b.length; });
    any = false;
    for (const Candidate& c : offers) {
      if (c.length == std::numeric_limits<double>::infinity()) break;
      if (!joined.unite(component(c.a), component(c.b))) continue;
      chosen.push_back(c);
      any = true;
    }
  }
  return chosen;
}

std::vector<ComponentLinks::Link> ComponentLinks::tree(int root) {
  std::vector<bool> has_entries(static_cast<std::size_t>(count_), false);
  for (const Entry& e : all_) has_entries[static_cast<std::size_t>(e.component)] = true;
  const auto components = static_cast<std::size_t>(std::ranges::count(has_entries, true));
  if (root >= count_ || components < 2) return {};
  locate(near_others());
  std::vector<Link> links = tree_of_located(root);
  if (links.size() + 1 == components) return links;
  // Some component lies far from all others, or the root among those that were left out.
  locate(std::vector<bool>(all_.size(), true));
  return tree_of_located(root);
}

std::vector<ComponentLinks::Link> ComponentLinks::tree_of_located(int root) const {
  const auto component = [&](std::uint32_t entry) { return static_cast<std::size_t>(entries_[entry].component); };
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> edges;  // entries here and there, by component
  edges.resize(static_cast<std::size_t>(count_));
  for (const Candidate& c : connections()) {
    edges[component(c.a)].emplace_back(c.a, c.b);
    edges[component(c.b)].emplace_back(c.b, c.a);
  }
  std::vector<Link> links;
  std::vector<bool> reached(edges.size(), false);
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
