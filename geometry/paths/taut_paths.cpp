// All taut paths, by the same search as the shortest one, but with paths told apart by their chains of bends: each
// (chain, triangle) is followed once, and the search goes on behind the goal.
#include <algorithm>
#include <map>
#include <set>

#include "geometry/paths/interval_search.hpp"
#include "geometry/paths/shortest_path_impl.hpp"

namespace oxturn {
namespace {

using Visit = std::function<bool(const Polyline&)>;

/// A chain of bends from the start. Chains are interned: equal curves have equal chains, because collinear vertices are
/// no bends.
struct BendChain {
  enum class Admission { unknown, admitted, rejected };
  std::int32_t parent = -1;
  PathPoint last = -1;
  Admission admission = Admission::unknown;
  bool visited = false;
};

class AllPathsSearch : public IntervalSearch<AllPathsSearch> {
 public:
  static constexpr bool kSearchesBehindGoal = true;

  AllPathsSearch(const Mesh& mesh, const ShortestPaths::Impl::Ends& ends, double longest, ConeStorage& storage)
      : IntervalSearch(mesh, ends.start, ends.goal, longest, storage), ends_(ends) {}

  /// The straight path has been visited already.
  void skip_straight() { chain(extended(kStart, goal_id())).visited = true; }

  /// See ShortestPaths::for_each_taut_path.
  bool run(std::size_t budget, const Visit& visit, const Visit& admits) {
    leave_start(ends_.from);
    while (!exhausted()) {
      const std::int32_t next = pop();
      const ConeNode& n = node(next);
      if (n.triangle == Mesh::kWall) {
        if (std::exchange(chain(n.from.chain).visited, true)) continue;
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
  bool is_useless(std::int32_t, std::int32_t) const { return false; }
  double least(const ConeOrigin&) const { return 0; }
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
  static constexpr std::int32_t kStart = 0;  // the chain without bends

  BendChain& chain(std::int32_t i) { return chains_[static_cast<std::size_t>(i)]; }
  const Point& end_of(std::int32_t i) { return i == kStart ? ends_.start : at(chain(i).last); }
  /// The chain that continues to point v.
  std::int32_t extended(std::int32_t i, PathPoint v) {
    for (; i != kStart; i = chain(i).parent) {
      const Point &before = end_of(chain(i).parent), &here = end_of(i), &next = at(v);
      if (orientation(before, here, next) != 0 || (here - before).dot(next - here) < 0) break;
    }
    const auto [found, is_new] = ids_.try_emplace({i, v}, static_cast<std::int32_t>(chains_.size()));
    if (is_new) chains_.push_back({i, v});
    return found->second;
  }
  Polyline polyline(std::int32_t i) {
    Polyline points;
    for (; i != kStart; i = chain(i).parent) points.push_back(end_of(i));
    points.push_back(ends_.start);
    std::reverse(points.begin(), points.end());
    return points;
  }
  bool admitted(std::int32_t i, const Visit& admits) {
    using Admission = BendChain::Admission;
    if (i == kStart) return true;
    if (chain(i).admission == Admission::unknown)
      chain(i).admission = admits(polyline(i)) ? Admission::admitted : Admission::rejected;
    return chain(i).admission == Admission::admitted;
  }

  const ShortestPaths::Impl::Ends& ends_;
  std::vector<BendChain> chains_{{}};
  std::map<std::pair<std::int32_t, PathPoint>, std::int32_t> ids_;  // (parent, last point) -> chain
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
