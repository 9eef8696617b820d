// Or-opt and 2-opt moves over neighbour lists. The number of path searches is limited, so the effort does not depend on
// the clock.
#include <algorithm>
#include <array>

#include "algorithms/tour/open_tour.hpp"
#include "geometry/point_grid.hpp"

namespace oxturn {
namespace {

constexpr double kGain = 1e-9;          // metres; a smaller gain may be rounding
constexpr int kMostRounds = 8;          // over the whole tour
constexpr double kMostDetour = 8;       // path over straight distance: a port behind a long wall is no neighbour
constexpr std::size_t kLongestRun = 3;  // stops that are moved together (Or 1976)

/// So many path searches keep a tour of thousands of elements within seconds.
std::size_t most_searches(std::size_t stops) { return std::min<std::size_t>(4000 + 6 * stops, 12000); }

class LocalSearch {
 public:
  /// All must outlive it.

  LocalSearch(const TourCosts& costs, std::vector<TourStop>& tour, Context& context)
      : costs_(costs),
        tour_(tour),
        context_(context),
        n_(tour.size()),
        neighbours_(costs.ports().size()),
        neighbour_count_(costs.ports().size(), 0),
        index_of_(costs.elements().size(), n_) {
    find_neighbours();
    renumber(0, n_);
  }
  /// Until no move helps, or the effort is spent.

  void run() {
    const std::size_t most = costs_.searches() + most_searches(n_);
    bool improved = true;
    for (int round = 0; improved && round < kMostRounds; ++round) {
      improved = false;
      for (std::size_t i = 0; i < n_; ++i) {
        if (costs_.searches() >= most || context_.cancelled()) return;
        if (improve_at(i)) improved = true;
      }
    }
  }

 private:
  static constexpr std::size_t kNeighbours = 10;
  /// One possible order and direction of a run of stops.
  struct Variant {
    TourStop head, tail;  // its first and its last stop
    double extra = 0;     // what its patterns cost more than the present ones
  };
  /// Where a run of stops may be inserted: between two ports.
  struct Gap {
    std::size_t left, right;
    bool has_right;  // else it is the end of the tour
  };

  void find_neighbours() {
    const PointGrid grid(costs_.ports());
    for (std::size_t p = 0; p < costs_.ports().size(); ++p)
      grid.visit(costs_.ports()[p], [&](std::size_t other, double) {
        if (costs_.element_of(other) != costs_.element_of(p))
          neighbours_[p][neighbour_count_[p]++] = static_cast<std::uint32_t>(other);
        return neighbour_count_[p] < kNeighbours;
      });
  }

  /// Length of a connection that a move would add. Its search ends early if it leads far round.
  double added_path(std::size_t a, std::size_t b, double longest) const {
    return costs_.exact(a, b, std::min(longest, kMostDetour * costs_.bound(a, b)));
  }
  void renumber(std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) index_of_[tour_[i].element] = i;
  }
  /// The port where the robot leaves for stop i.
  std::size_t exit_before(std::size_t i) const { return i == 0 ? costs_.start() : costs_.exit(tour_[i - 1]); }

  bool improve_at(std::size_t i) {
    if (try_reversals(i)) return true;
    for (std::size_t count = 1; count <= kLongestRun && i + count <= n_; ++count)
      if (try_moves(i, count)) return true;
    return false;
  }

  /// 2-opt moves that connect one end of the path to stop i to a port nearer than the path's length.
  bool try_reversals(std::size_t i) {
    const std::size_t before = exit_before(i), in = costs_.entry(tour_[i]);
    const double here = costs_.exact(before, in);
    for (std::size_t k = 0; before != costs_.start() && k < neighbour_count_[before]; ++k) {
      const std::size_t port = neighbours_[before][k];
      if (costs_.bound(before, port) >= here) break;
      const std::size_t j = index_of_[costs_.element_of(port)];
      if (j < n_ && j >= i && port == costs_.exit(tour_[j]) && try_reversal(i, j)) return true;
    }
    for (std::size_t k = 0; k < neighbour_count_[in]; ++k) {
      const std::size_t port = neighbours_[in][k];
      if (costs_.bound(in, port) >= here) break;
      const std::size_t j = index_of_[costs_.element_of(port)];
      if (j < n_ && j > i && port == costs_.entry(tour_[j]) && try_reversal(i, j - 1)) return true;
    }
    return false;
  }

  /// Or-opt moves of `count` stops from i on to beside the elements that are near to one of their ends.
  bool try_moves(std::size_t i, std::size_t count) {
    for (const std::size_t end : {costs_.entry(tour_[i]), costs_.exit(tour_[i + count - 1])})
      for (std::size_t k = 0; k < neighbour_count_[end]; ++k) {
        const std::size_t j = index_of_[costs_.element_of(neighbours_[end][k])];
        if (j >= n_) continue;
        if (try_move(i, count, j) || try_move(i, count, j + 1)) return true;
      }
    return false;
  }

  /// Reverses stops i to j if that makes the tour shorter.
  bool try_reversal(std::size_t i, std::size_t j) {
    const std::size_t before = exit_before(i), in = costs_.entry(tour_[i]), out = costs_.exit(tour_[j]);
    const bool has_next = j + 1 < n_;
    const std::size_t next = has_next ? costs_.entry(tour_[j + 1]) : costs_.start();
    double removed = costs_.exact(before, in), lower = costs_.bound(before, out);
    if (has_next) {
      removed += costs_.exact(out, next);
      lower += costs_.bound(in, next);
    }
    if (removed - lower <= kGain) return false;
    const double rest = has_next ? costs_.bound(in, next) : 0;
    double added = added_path(before, out, removed - rest);
    if (has_next && added < TourCosts::kFar) added += added_path(in, next, removed - added);
    if (removed - added <= kGain) return false;
    std::reverse(tour_.begin() + static_cast<std::ptrdiff_t>(i), tour_.begin() + static_cast<std::ptrdiff_t>(j) + 1);
    for (std::size_t k = i; k <= j; ++k) tour_[k] = costs_.reversed(tour_[k]);
    renumber(i, j + 1);
    return true;
  }

  /// Moves `count` stops from i on to before stop `to` if that makes the tour shorter: a single stop in any pattern,
  /// more of them in either direction.
  bool try_move(std::size_t i, std::size_t count, std::size_t to) {
    const std::size_t last = i + count - 1;
    if (to >= i && to <= last + 1) return false;
    const bool has_next = last + 1 < n_;
    const Gap gap{exit_before(to), to < n_ ? costs_.entry(tour_[to]) : costs_.start(), to < n_};
    double removed = costs_.exact(exit_before(i), costs_.entry(tour_[i]));
    if (has_next) removed += costs_.exact(costs_.exit(tour_[last]), costs_.entry(tour_[last + 1]));
    if (gap.has_right) removed += costs_.exact(gap.left, gap.right);
    double closed = 0;  // the path that closes the gap which the run leaves behind
    if (has_next) {
      const std::size_t before = exit_before(i), next = costs_.entry(tour_[last + 1]);
      if (removed - costs_.bound(before, next) <= kGain) return false;
      closed = added_path(before, next, removed);
      if (removed - closed <= kGain) return false;
    }
    const std::vector<Variant> variants = variants_of(i, count);
    const std::size_t best = best_insertion(variants, gap, closed, removed);
    if (best == variants.size()) return false;
    move(i, count, to, variants[best]);
    return true;
  }

  std::vector<Variant> variants_of(std::size_t i, std::size_t count) const {
    const TourStop &head = tour_[i], &tail = tour_[i + count - 1];
    if (count > 1) return {{head, tail}, {costs_.reversed(tail), costs_.reversed(head)}};
    std::vector<Variant> variants;
    for (std::size_t q = 0; q < costs_.elements()[head.element].size(); ++q) {
      const TourStop s{head.element, q};
      variants.push_back({s, s, costs_.pattern_cost(s) - costs_.pattern_cost(head)});
    }
    return variants;
  }

  /// The index of the variant that adds least, if that is less than what is removed; else variants.size().
  std::size_t best_insertion(const std::vector<Variant>& variants, const Gap& gap, double closed,
                             double removed) const {
    double best = removed - kGain;
    std::size_t chosen = variants.size();
    for (std::size_t v = 0; v < variants.size(); ++v) {
      const auto& [head, tail, extra] = variants[v];
      const double rest = gap.has_right ? costs_.bound(costs_.exit(tail), gap.right) : 0;
      if (closed + extra + costs_.bound(gap.left, costs_.entry(head)) + rest >= best) continue;
      double added = closed + extra + added_path(gap.left, costs_.entry(head), best - closed - extra - rest);
      if (gap.has_right && added < best) added += added_path(costs_.exit(tail), gap.right, best - added);
      if (added < best) {
        best = added;
        chosen = v;
      }
    }
    return chosen;
  }

  void move(std::size_t i, std::size_t count, std::size_t to, const Variant& variant) {
    const std::size_t last = i + count - 1;
    const auto first = tour_.begin() + static_cast<std::ptrdiff_t>(i), end = first + static_cast<std::ptrdiff_t>(count);
    std::vector<TourStop> moved(first, end);
    if (count == 1) {
      moved[0] = variant.head;
    } else if (variant.head.element != moved[0].element) {
      std::reverse(moved.begin(), moved.end());
      for (TourStop& s : moved) s = costs_.reversed(s);
    }
    tour_.erase(first, end);
    const std::size_t at = to > last ? to - count : to;
    tour_.insert(tour_.begin() + static_cast<std::ptrdiff_t>(at), moved.begin(), moved.end());
    renumber(std::min(i, at), std::min(n_, std::max(last, at + count) + 1));
  }

  const TourCosts& costs_;
  std::vector<TourStop>& tour_;
  Context& context_;
  std::size_t n_;
  std::vector<std::array<std::uint32_t, kNeighbours>> neighbours_;  // of each port: the nearest of other elements
  std::vector<std::uint8_t> neighbour_count_;
  std::vector<std::size_t> index_of_;  // of each element in the tour; n_ if it is not there
};

}  // namespace

void improve_tour(const TourCosts& costs, std::vector<TourStop>& tour, Context& context) {
  if (tour.size() > 1) LocalSearch(costs, tour, context).run();
}

}  // namespace oxturn
