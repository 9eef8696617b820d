#include "geometry/paths/shortest_path.hpp"

#include <algorithm>

#include "base/throw_invalid.hpp"
#include "geometry/paths/interval_search.hpp"
#include "geometry/paths/shortest_path_impl.hpp"

namespace oxturn {
namespace {

/// What a search for one path knows about points and triangles; stamped, so that a search need not clear it.
struct Knowledge {
  struct Root {
    std::uint32_t search = 0;
    double length = 0;        // the least so far
    double to_end = 0;        // from there, at least
    std::int32_t turns = -1;  // index of the latest turn about the point
  };
  /// A turn about a point that has been followed: coming from `from`, in `triangle`.
  struct TurnDone {
    PathPoint from;
    std::int32_t triangle;
    double length;
    std::int32_t next;  // about the same point; -1: none
  };
  std::vector<Root> roots;  // by point
  std::vector<TurnDone> turns;
  std::vector<std::uint32_t> target;       // by triangle: the search that it is a target of
  std::vector<std::uint32_t> goal_within;  // by dead end: the search whose goal lies in it, or farther in
  std::uint32_t search = 0;

  void begin(const Mesh& mesh) {
    turns.clear();
    if (roots.size() < mesh.points().size()) roots.resize(mesh.points().size());
    if (target.size() < mesh.triangles().size()) target.resize(mesh.triangles().size(), 0);
    goal_within.resize(target.size(), 0);
    if (++search == 0) {  // the counter has come round
      for (Root& r : roots) r.search = 0;
      std::fill(target.begin(), target.end(), 0);
      std::fill(goal_within.begin(), goal_within.end(), 0);
      search = 1;
    }
  }
};

class OnePathSearch : public IntervalSearch<OnePathSearch> {
 public:
  static constexpr bool kSearchesBehindGoal = false;

  /// `to_end` may be empty.
  OnePathSearch(const ShortestPaths::Impl& impl, const ShortestPaths::Impl::Ends& ends, double longest,
                ConeStorage& storage, Knowledge& knowledge, const std::function<double(const Point&)>& to_end)
      : IntervalSearch(impl.mesh, ends.start, ends.goal, longest, storage),
        tree_(impl.tree),
        ends_(ends),
        known_(knowledge),
        to_end_(to_end) {
    known_.begin(impl.mesh);
  }

  /// The finished node, or nullopt.
  std::optional<std::int32_t> run() {
    for (std::int32_t t : ends_.to) {
      known_.target[static_cast<std::size_t>(t)] = known_.search;
      for (; tree_.out_of(t) != DualTree::kNone; t = tree_.out_of(t))
        known_.goal_within[static_cast<std::size_t>(t)] = known_.search;
    }
    leave_start(ends_.from);
    while (!exhausted()) {
      const std::int32_t next = pop();
      const ConeNode& n = node(next);
      if (n.triangle == Mesh::kWall) return next;
      if (n.from.root == start_id() || !worse(n.from.length, n.from.root)) expand(next);
    }
    return std::nullopt;
  }
  /// The bends of a finished path, last first.
  Polyline bends(std::int32_t finished) const {
    Polyline out;
    PathPoint root = start_id();
    for (std::int32_t i = finished; i >= 0; i = node(i).parent) {
      const PathPoint next = node(i).from.root;
      if (next != root && next != start_id()) out.push_back(at(next));
      root = next;
    }
    return out;
  }

  bool is_target(std::int32_t t) const { return known_.target[static_cast<std::size_t>(t)] == known_.search; }
  /// A path that leads from t into n leads nowhere else.
  bool is_useless(std::int32_t t, std::int32_t n) const {
    return tree_.out_of(n) == t && known_.goal_within[static_cast<std::size_t>(n)] != known_.search;
  }
  void starts_at(PathPoint vertex) { root(vertex).length = 0; }
  std::int32_t finished_chain(const ConeOrigin&) const { return 0; }
  double least(const ConeOrigin& from) {
    return from.root == start_id() ? 0 : (from.length + root(from.root).to_end) * (1 - 1e-9);
  }
  std::optional<ConeOrigin> last_turn(const ConeNode& n, PathPoint v, Turn) { return turn(n, v, Turn::left); }
  /// Every (root, vertex, triangle) is followed once, or again on a shorter path: otherwise equally long paths, as
  /// between obstacles on a lattice, would multiply.
  std::optional<ConeOrigin> turn(const ConeNode& n, PathPoint v, Turn) {
    if (!mesh_.is_reflex(v)) return std::nullopt;
    const double length = n.from.length + distance(at(n.from.root), at(v));
    if (worse(length, v)) return std::nullopt;
    Knowledge::Root& r = root(v);
    r.length = std::min(r.length, length);
    for (std::int32_t i = r.turns; i >= 0; i = known_.turns[static_cast<std::size_t>(i)].next) {
      Knowledge::TurnDone& done = known_.turns[static_cast<std::size_t>(i)];
      if (done.from != n.from.root || done.triangle != n.triangle) continue;
      if (length >= done.length * (1 - kRounding)) return std::nullopt;
      done.length = length;
      return ConeOrigin{v, length, 0};
    }
    known_.turns.push_back({n.from.root, n.triangle, length, r.turns});
    r.turns = static_cast<std::int32_t>(known_.turns.size()) - 1;
    return ConeOrigin{v, length, 0};
  }

 private:
  Knowledge::Root& root(PathPoint id) {
    Knowledge::Root& r = known_.roots[static_cast<std::size_t>(id)];
    if (r.search != known_.search)
      r = {known_.search, std::numeric_limits<double>::infinity(), to_end_ ? to_end_(at(id)) : 0, -1};
    return r;
  }
  bool worse(double length, PathPoint id) { return length > root(id).length * (1 + kRounding); }

  const DualTree& tree_;
  const ShortestPaths::Impl::Ends& ends_;
  Knowledge& known_;
  const std::function<double(const Point&)>& to_end_;
};

/// One triangle for each group of the given ones that is connected by edges: where walls touch in a point, there are
/// several such groups about it.
std::vector<std::int32_t> one_of_each_group(const Mesh& mesh, const std::vector<std::int32_t>& triangles) {
  const auto groups = connected_components(triangles.size(), [&](std::size_t i, auto reach) {
    const auto& neighbour = mesh.triangle(triangles[i]).neighbour;
    for (std::size_t j = 0; j < triangles.size(); ++j)
      if (std::find(neighbour.begin(), neighbour.end(), triangles[j]) != neighbour.end()) reach(j);
  });
  std::vector<std::int32_t> first;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (groups.of[i] == static_cast<std::int32_t>(first.size())) first.push_back(triangles[i]);
  return first;
}

/// The shortest path in a component without holes; empty if it is longer than `longest`.
Polyline path_in_tree(const ShortestPaths::Impl& impl, const ShortestPaths::Impl::Ends& ends, double longest) {
  Polyline best;
  for (const std::int32_t from : one_of_each_group(impl.mesh, ends.from))
    for (const std::int32_t to : one_of_each_group(impl.mesh, ends.to)) {
      std::optional<Polyline> line = impl.tree.path(ends.start, from, ends.goal, to, longest);
      if (line && (best.empty() || length(*line) < length(best))) best = std::move(*line);
    }
  return best;
}

}  // namespace

ShortestPaths::ShortestPaths(const Region& region, double tolerance) : ShortestPaths(Mesh(region), tolerance) {}
ShortestPaths::ShortestPaths(Mesh mesh, double tolerance) {
  if (!(tolerance >= 0)) throw_invalid("tolerance of shortest paths must be 0 or more metres");
  impl_ = std::make_shared<const Impl>(std::move(mesh), tolerance);
}
const Mesh& ShortestPaths::mesh() const { return impl_->mesh; }

std::optional<Polyline> ShortestPaths::path(const Point& a, const Point& b, double longest) const {
  return path(a, b, longest, {});
}
std::optional<Polyline> ShortestPaths::path(const Point& a, const Point& b, double longest,
                                            const std::function<double(const Point&)>& to_end) const {
  if (!finite(a) || !finite(b) || !(distance(a, b) <= longest)) return std::nullopt;
  thread_local Impl::Ends ends;
  if (!impl_->find_ends(a, b, ends)) return std::nullopt;
  if (ends.share_a_triangle()) return Polyline{a, b};
  const std::int32_t component = impl_->component(ends.from.front());
  Polyline path;
  if (impl_->tree.is_tree(component) && std::all_of(ends.from.begin(), ends.from.end(),
                                                    [&](std::int32_t t) { return impl_->component(t) == component; })) {
    path = path_in_tree(*impl_, ends, longest);
    if (path.empty()) return std::nullopt;
    path.front() = a;
    path.back() = b;
  } else {
    thread_local ConeStorage storage;
    thread_local Knowledge knowledge;
    OnePathSearch search(*impl_, ends, longest, storage, knowledge, to_end);
    const std::optional<std::int32_t> finished = search.run();
    if (!finished) return std::nullopt;
    path.push_back(b);
    for (const Point& bend : search.bends(*finished))
      if (bend != path.back()) path.push_back(bend);
    if (path.size() > 1 && path.back() == a) path.pop_back();
    path.push_back(a);
    std::reverse(path.begin(), path.end());
  }
  if (length(path) > longest) return std::nullopt;
  return path;
}

}  // namespace oxturn
