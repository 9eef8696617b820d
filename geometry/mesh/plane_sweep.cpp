#include "geometry/mesh/plane_sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

/// An edge, or what is left of it after a split; `left` comes before `right`. Free space lies above a lower edge (it
/// bounds its cell from below) and below an upper one. `cell` is the open cell on the free side.
struct Wall {
  Point left, right;
  bool lower = false;
  mutable std::size_t cell = 0;
};

/// Walls that the line meets at the same time, from bottom to top; points compare with them too.
struct Below {
  using is_transparent = void;
  bool operator()(const Wall& a, const Wall& b) const {
    if (before(b.left, a.left)) {  // judge by the wall that began first
      int s = orientation(b.left, b.right, a.left);
      if (s == 0) s = orientation(b.left, b.right, a.right);
      return s < 0;
    }
    int s = orientation(a.left, a.right, b.left);
    if (s == 0) s = orientation(a.left, a.right, b.right);
    return s > 0;
  }
  bool operator()(const Wall& a, const Point& p) const { return orientation(a.left, a.right, p) > 0; }
  bool operator()(const Point& p, const Wall& a) const { return orientation(a.left, a.right, p) < 0; }
};

[[noreturn]] void inconsistent(const Point& p) {
  throw std::invalid_argument(
      fmt::format("region has edges that cross or overlap at ({}, {}); repair it before decomposing it", p.x(), p.y()));
}

/// Where the vertical line at x meets the wall.
ChainPoint meet(const Wall& w, double x) {
  if (x <= w.left.x()) return {w.left, false};
  if (x >= w.right.x()) return {w.right, false};
  const double t = (x - w.left.x()) / (w.right.x() - w.left.x());
  const double low = std::min(w.left.y(), w.right.y()), high = std::max(w.left.y(), w.right.y());
  return {{x, std::clamp(w.left.y() + t * (w.right.y() - w.left.y()), low, high)}, false};
}

/// Walls in sweep order, without those that lie on one another twice (they bound nothing).
std::vector<Wall> walls(const Region& region) {
  std::vector<Wall> all;
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point& a = ring[i];
      const Point& b = ring[i + 1 < ring.size() ? i + 1 : 0];
      if (!finite(a))
        throw std::invalid_argument("region has a corner that is not finite; repair it before decomposing it");
      if (a == b) continue;
      if (before(a, b))
        all.push_back({a, b, true, 0});
      else
        all.push_back({b, a, false, 0});
    }
  });
  std::sort(all.begin(), all.end(), [](const Wall& a, const Wall& b) {
    if (a.left != b.left) return before(a.left, b.left);
    if (a.right != b.right) return before(a.right, b.right);
    return a.lower < b.lower;
  });
  std::vector<Wall> kept;
  for (const Wall& w : all) {
    if (!kept.empty() && kept.back().left == w.left && kept.back().right == w.right && kept.back().lower != w.lower) {
      kept.pop_back();
    } else {
      kept.push_back(w);
    }
  }
  return kept;
}

class SuiteRun {
 public:
  explicit SuiteRun(Cuts cuts) : cuts_(cuts) {}

  std::vector<PlaneSweepCell> run(const Region& region) {
    const std::vector<Wall> all = walls(region);
    std::vector<Point> corners;
    for (const Wall& w : all) {
      corners.push_back(w.left);
      corners.push_back(w.right);
    }
    std::sort(corners.begin(), corners.end(), before);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    std::size_t next = 0;
    for (const Point& v : corners) {
      std::size_t end = next;
      while (end < all.size() && all[end].left == v) ++end;
      std::vector<Wall> starting(all.begin() + static_cast<std::ptrdiff_t>(next),
                                 all.begin() + static_cast<std::ptrdiff_t>(end));
      next = end;
      corner(v, starting);
    }
    if (!status_.empty()) inconsistent(status_.begin()->right);
    return finished();
  }

 private:
  using Status = std::set<Wall, Below>;

  void corner(const Point& v, std::vector<Wall>& starting) {
    const auto [first, last] = status_.equal_range(v);
    const std::vector<Wall> ending(first, last);
    for (const Wall& w : ending) {  // a corner of another ring on it: goes on from here
      if (w.right != v) starting.push_back({v, w.right, w.lower, 0});
    }
    std::sort(starting.begin(), starting.end(),
              [&](const Wall& a, const Wall& b) { return orientation(v, a.right, b.right) > 0; });
    const auto above = status_.erase(first, last);
    const Wall* over = above == status_.end() ? nullptr : &*above;
    const Wall* under = above == status_.begin() ? nullptr : &*std::prev(above);
    const bool free_below = ending.empty() ? under && under->lower : !ending.front().lower;
    const bool free_above = ending.empty() ? free_below : ending.back().lower;
    check(v, ending, free_below, free_above);
    check(v, starting, free_below, free_above);
    if ((free_below && !under) || (free_above && !over)) inconsistent(v);
    if (ending.empty() && starting.empty()) return;

    for (std::size_t i = 0; i + 1 < ending.size(); ++i) {
      if (ending[i].lower) close(ending[i].cell, {v, true}, {v, true});
    }
    const bool cut = ending.empty() || starting.empty() || cuts_ == Cuts::every_corner;
    if (!cut) {
      if (free_below) {
        starting.front().cell = ending.front().cell;
        cells_[ending.front().cell].upper.push_back({v, true});
      }
      if (free_above) {
        starting.back().cell = ending.back().cell;
        cells_[ending.back().cell].lower.push_back({v, true});
      }
    } else {
      const ChainPoint here{v, true};
      ChainPoint down = here, up = here;
      if (free_below) {
        down = meet(*under, v.x());
        down.place.y() = std::min(down.place.y(), v.y());
      }
      if (free_above) {
        up = meet(*over, v.x());
        up.place.y() = std::max(up.place.y(), v.y());
      }
      if (ending.empty()) {
        if (free_below) close(under->cell, down, up);
      } else {
        if (free_below) close(ending.front().cell, down, here);
        if (free_above) close(ending.back().cell, here, up);
      }
      if (starting.empty()) {
        if (free_below) under->cell = over->cell = open(down, up);
      } else {
        if (free_below) under->cell = starting.front().cell = open(down, here);
        if (free_above) over->cell = starting.back().cell = open(here, up);
      }
    }
    for (std::size_t i = 0; i + 1 < starting.size(); ++i) {
      if (starting[i].lower) starting[i].cell = starting[i + 1].cell = open({v, true}, {v, true});
    }
    auto hint = above;
    for (std::size_t i = starting.size(); i-- > 0;) {
      const std::size_t size = status_.size();
      hint = status_.insert(hint, starting[i]);
      if (status_.size() == size) inconsistent(v);
    }
  }

  /// Free and blocked must take turns from below the corner to above it.
  static void check(const Point& v, const std::vector<Wall>& walls, bool free_below, bool free_above) {
    bool free = free_below;
    for (const Wall& w : walls) {
      if (w.lower == free) inconsistent(v);
      free = w.lower;
    }
    if (free != free_above) inconsistent(v);
  }

  std::size_t open(const ChainPoint& lower, const ChainPoint& upper) {
    cells_.push_back({{lower}, {upper}});
    return cells_.size() - 1;
  }
  void close(std::size_t cell, const ChainPoint& lower, const ChainPoint& upper) {
    cells_[cell].lower.push_back(lower);
    cells_[cell].upper.push_back(upper);
  }

  static void trim(Chain& chain) {
    std::size_t begin = 0, end = chain.size();
    while (begin + 1 < end && chain[begin].place.x() == chain[begin + 1].place.x()) ++begin;
    while (end > begin + 1 && chain[end - 1].place.x() == chain[end - 2].place.x()) --end;
    chain = Chain(chain.begin() + static_cast<std::ptrdiff_t>(begin), chain.begin() + static_cast<std::ptrdiff_t>(end));
  }

  std::vector<PlaneSweepCell> finished() {
    std::vector<PlaneSweepCell> out;
    for (PlaneSweepCell& c : cells_) {
      if (!(c.lower.front().place.x() < c.lower.back().place.x())) continue;
      trim(c.lower);
      trim(c.upper);
      out.push_back(std::move(c));
    }
    return out;
  }

  Cuts cuts_;
  Status status_;
  std::vector<PlaneSweepCell> cells_;
};

}  // namespace

std::vector<PlaneSweepCell> plane_sweep_cells(const Region& region, Cuts cuts) { return SuiteRun(cuts).run(region); }

}  // namespace oxturn
