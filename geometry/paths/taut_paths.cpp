// All taut paths, by the same search as the shortest one, but with paths told apart by their chains of bends: each
// (chain, triangle) is followed once, and the search goes on behind the goal.
#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "geometry/paths/interval_search.hpp"
#include "geometry/paths/shortest_path_impl.hpp"

namespace oxturn {
namespace {

using Visit = std::function<bool(const Polyline&)>;

/// Chains of bends from the start, interned: equal curves have equal chains, because collinear vertices are no bends.
class BendChains {
 public:
  static constexpr std::int32_t kStart = 0;  // the chain without bends
  enum class Admission { unknown, admitted, rejected };
  struct Chain {
    std::int32_t parent = -1;
    PathPoint last = -1;
    Admission admission = Admission::unknown;
    bool visited = false;
  };

  Chain& operator[](std::int32_t chain) { return chains_[static_cast<std::size_t>(chain)]; }

  /// The chain that continues to point v. `at` gives the coordinates of points.
  template <class At>
  std::int32_t extended(std::int32_t chain, PathPoint v, const Point& start, At at) {
    for (; chain != kStart; chain = (*this)[chain].parent) {
      const Chain& c = (*this)[chain];
      const Point& before = c.parent != kStart ? at((*this)[c.parent].last) : start;
      const Point &here = at(c.last), &next = at(v);
      if (orientation(before, here, next) != 0 || (here - before).dot(next - here) < 0) break;
    }
    const auto [found, is_new] = ids_.try_emplace({chain, v}, static_cast<std::int32_t>(chains_.size()));
    if (is_new) chains_.push_back({chain, v});
    return found->second;
  }
  template <class At>
  Polyline polyline(std::int32_t chain, const Point& start, At at) {
    Polyline points;
    for (; chain != kStart; chain = (*this)[chain].parent) points.push_back(at((*this)[chain].last));
    points.push_back(start);
    std::reverse(points.begin(), points.end());
    return points;
  }

 private:
  std::vector<Chain> chains_{{}};
  std::map<std::pair<std::int32_t, PathPoint>, std::int32_t> ids_;  // (parent, last point) -> chain
};

class AllPathsSearch : public IntervalSearch<AllPathsSearch> {
 public:
  static constexpr bool kSearchesBehindGoal = true;

  AllPathsSearch(const Mesh& mesh, const ShortestPaths::Impl::Ends& ends, double longest, ConeStorage& storage)
      : IntervalSearch(mesh, ends.start, ends.goal, longest, storage), ends_(ends) {}

  /// The straight path has been visited already.
  void skip_straight() { chains_[extended(BendChains::kStart, goal_id())].visited = true; }

  /// See ShortestPaths::for_each_taut_path.
  bool run(std::size_t budget, const Visit& visit, const Visit& admits) {
    leave_start(ends_.from);
    while (!exhausted()) {
      const std::int32_t next = pop();
      const ConeNode& n = node(next);
      if (n.triangle == Mesh::kWall) {
        if (std::exchange(chains_[n.from.chain].visited, true)) continue;
        if (!visit(polyline(n.from.chain))) return true;
        continue;
      }
      if (admits && !admitted(n.from.chain, admits)) continue;
      if (budget-- == 0) return false;
      expand(next);
    }
    return true;
  }

  bool is_target(std::int32_t t) const { return std::find(ends_.to.begin(), ends_.to.end(), t) != ends_.to.end(); }
  void starts_at(PathPoint) const {}
  std::int32_t finished_chain(const ConeOrigin& from) { return extended(from.chain, goal_id()); }
  std::optional<ConeOrigin> turn(const ConeNode& n, PathPoint v, Turn turn) {
    const auto turned = last_turn(n, v, turn);
    if (!turned || !turns_[turn == Turn::left ? 0 : 1].insert({turned->chain, n.triangle}).second) return std::nullopt;
    return turned;
  }
  std::optional<ConeOrigin> last_turn(const ConeNode& n, PathPoint v, Turn) {
    if (!mesh_.is_reflex(v)) return std::nullopt;
    return ConeOrigin{v, n.from.length + distance(at(n.from.root), at(v)), extended(n.from.chain, v)};
  }

 private:
  std::int32_t extended(std::int32_t chain, PathPoint v) {
    return chains_.extended(chain, v, ends_.start, [&](PathPoint id) -> const Point& { return at(id); });
  }
  Polyline polyline(std::int32_t chain) {
    return chains_.polyline(chain, ends_.start, [&](PathPoint id) -> const Point& { return at(id); });
  }
  bool admitted(std::int32_t chain, const Visit& admits) {
    using Admission = BendChains::Admission;
    if (chain == BendChains::kStart) return true;
    if (chains_[chain].admission == Admission::unknown)
      chains_[chain].admission = admits(polyline(chain)) ? Admission::admitted : Admission::rejected;
    return chains_[chain].admission == Admission::admitted;
  }

  const ShortestPaths::Impl::Ends& ends_;
  BendChains chains_;
  std::set<std::pair<std::int32_t, std::int32_t>> turns_[2];  // (chain, triangle) followed to the left, to the right
};

}  // namespace

bool ShortestPaths::for_each_taut_path(const Point& a, const Point& b, double longest, std::size_t budget,
                                       const Visit& visit, const Visit& admits) const {
  if (!finite(a) || !finite(b) || !(distance(a, b) <= longest)) return true;
  Impl::Ends ends;  // not thread-local: visitors may ask for paths themselves
  ConeStorage storage;
  if (!impl_->find_ends(a, b, ends)) return true;
  const bool straight = ends.share_a_triangle();
  if (straight && !visit({a, b})) return true;
  AllPathsSearch search(impl_->mesh, ends, longest, storage);
  if (straight) search.skip_straight();
  // The search works with the ends moved into the mesh; visitors see the given ones.
  const auto beginning_at_a = [&](Polyline line) {
    line.front() = a;
    if (line.size() > 2 && line[1] == a) line.erase(line.begin() + 1);
    return line;
  };
  const auto visit_path = [&](Polyline line) {
    line.back() = b;
    line = beginning_at_a(std::move(line));
    if (line.size() > 2 && line[line.size() - 2] == b) line.erase(line.end() - 2);
    return visit(line);
  };
  const auto admits_prefix = [&](const Polyline& line) { return admits(beginning_at_a(line)); };
  return search.run(budget, visit_path, admits ? Visit(admits_prefix) : nullptr);
}

}  // namespace oxturn
