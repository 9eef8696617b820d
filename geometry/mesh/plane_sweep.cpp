#include "geometry/mesh/plane_sweep.hpp"

#include <algorithm>
#include <set>

#include "base/sorting.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

/// An edge, or the rest of it after a split; `left` is before `right`. Free space is above a lower wall (which bounds
/// its cell from below) and below an upper one. `cell` is the open cell on the free side.
struct Wall {
  Point left, right;
  bool lower = false;
  mutable std::size_t cell = 0;
};

/// Order of the walls that the line meets, from bottom to top. Walls can be compared with points, too.
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
  throw_invalid("region has edges that cross or overlap at ({}, {}); repair it before decomposing it", p.x(), p.y());
}

/// Where the vertical line at x meets the wall.
ChainPoint point_at(const Wall& w, double x) {
  if (x <= w.left.x()) return {w.left, false};
  if (x >= w.right.x()) return {w.right, false};
  const double t = (x - w.left.x()) / (w.right.x() - w.left.x());
  const double low = std::min(w.left.y(), w.right.y()), high = std::max(w.left.y(), w.right.y());
  return {{x, std::clamp(w.left.y() + t * (w.right.y() - w.left.y()), low, high)}, false};
}

/// The walls in sweep order, without pairs that lie on each other and so bound nothing.
std::vector<Wall> walls_of(const Region& region) {
  std::vector<Wall> all;
  for_each_edge(region, [&](const Point& a, const Point& b) {
    if (!finite(a)) throw_invalid("region has a vertex that is not finite; repair it before decomposing it");
    if (a != b) all.push_back(before(a, b) ? Wall{a, b, true} : Wall{b, a, false});
  });
  std::ranges::sort(all, [](const Wall& a, const Wall& b) {
    if (a.left != b.left) return before(a.left, b.left);
    if (a.right != b.right) return before(a.right, b.right);
    return a.lower < b.lower;
  });
  std::vector<Wall> kept;
  for (const Wall& w : all) {
    if (!kept.empty() && kept.back().left == w.left && kept.back().right == w.right && kept.back().lower != w.lower)
      kept.pop_back();
    else
      kept.push_back(w);
  }
  return kept;
}

std::vector<Point> ends_of(const std::vector<Wall>& walls) {
  std::vector<Point> ends;
  for (const Wall& w : walls) {
    ends.push_back(w.left);
    ends.push_back(w.right);
  }
  sort_unique(ends, before);
  return ends;
}

class PlaneSweep {
 public:
  explicit PlaneSweep(Cuts cuts) : cuts_(cuts) {}

  std::vector<PlaneSweepCell> run(const Region& region) {
    const std::vector<Wall> walls = walls_of(region);
    std::size_t next = 0;
    for (const Point& v : ends_of(walls)) {
      std::vector<Wall> starting;
      for (; next < walls.size() && walls[next].left == v; ++next) starting.push_back(walls[next]);
      pass_vertex(v, std::move(starting));
    }
    if (!status_.empty()) inconsistent(status_.begin()->right);
    return finished_cells();
  }

 private:
  using Status = std::set<Wall, Below>;
  /// What the line meets at a vertex: walls that end and start there, from bottom to top, and the walls next below and
  /// above it (nullptr: none).
  struct Event {
    Point at;
    std::vector<Wall> ending, starting;
    const Wall *under = nullptr, *over = nullptr;
    bool free_below = false, free_above = false;
  };

  void pass_vertex(const Point& v, std::vector<Wall> starting) {
    Event e{v, {}, std::move(starting)};
    const auto [first, last] = status_.equal_range(v);
    e.ending.assign(first, last);
    for (const Wall& w : e.ending)  // a vertex of another ring on the wall: the rest of it starts here
      if (w.right != v) e.starting.push_back({v, w.right, w.lower, 0});
    std::ranges::sort(e.starting, [&](const Wall& a, const Wall& b) { return orientation(v, a.right, b.right) > 0; });
    const auto above = status_.erase(first, last);
    if (above != status_.end()) e.over = &*above;
    if (above != status_.begin()) e.under = &*std::prev(above);
    e.free_below = e.ending.empty() ? e.under && e.under->lower : !e.ending.front().lower;
    e.free_above = e.ending.empty() ? e.free_below : e.ending.back().lower;
    check(e);
    if (e.ending.empty() && e.starting.empty()) return;

    for (std::size_t i = 0; i + 1 < e.ending.size(); ++i)
      if (e.ending[i].lower) close(e.ending[i].cell, {v, true}, {v, true});
    if (e.ending.empty() || e.starting.empty() || cuts_ == Cuts::every_vertex)
      cut(e);
    else
      continue_cells(e);
    for (std::size_t i = 0; i + 1 < e.starting.size(); ++i)
      if (e.starting[i].lower) e.starting[i].cell = e.starting[i + 1].cell = open({v, true}, {v, true});
    insert(e, above);
  }

  /// The outermost walls that start continue the chains of the outermost walls that end.
  void continue_cells(Event& e) {
    if (e.free_below) {
      e.starting.front().cell = e.ending.front().cell;
      cells_[e.ending.front().cell].upper.push_back({e.at, true});
    }
    if (e.free_above) {
      e.starting.back().cell = e.ending.back().cell;
      cells_[e.ending.back().cell].lower.push_back({e.at, true});
    }
  }

  /// Closes the cells on the left of the line through the vertex, down to the wall below and up to the wall above it,
  /// and opens cells on its right.
  void cut(Event& e) {
    const ChainPoint here{e.at, true};
    ChainPoint down = here, up = here;
    if (e.free_below) {
      down = point_at(*e.under, e.at.x());
      down.point.y() = std::min(down.point.y(), e.at.y());
    }
    if (e.free_above) {
      up = point_at(*e.over, e.at.x());
      up.point.y() = std::max(up.point.y(), e.at.y());
    }
    if (e.ending.empty()) {
      if (e.free_below) close(e.under->cell, down, up);
    } else {
      if (e.free_below) close(e.ending.front().cell, down, here);
      if (e.free_above) close(e.ending.back().cell, here, up);
    }
    if (e.starting.empty()) {
      if (e.free_below) e.under->cell = e.over->cell = open(down, up);
    } else {
      if (e.free_below) e.under->cell = e.starting.front().cell = open(down, here);
      if (e.free_above) e.over->cell = e.starting.back().cell = open(here, up);
    }
  }

  void insert(const Event& e, Status::iterator hint) {
    for (std::size_t i = e.starting.size(); i-- > 0;) {
      const std::size_t size = status_.size();
      hint = status_.insert(hint, e.starting[i]);
      if (status_.size() == size) inconsistent(e.at);
    }
  }

  /// Free and blocked space must alternate around the vertex.
  static void check(const Event& e) {
    for (const auto* walls : {&e.ending, &e.starting}) {
      bool free = e.free_below;
      for (const Wall& w : *walls) {
        if (w.lower == free) inconsistent(e.at);
        free = w.lower;
      }
      if (free != e.free_above) inconsistent(e.at);
    }
    if ((e.free_below && !e.under) || (e.free_above && !e.over)) inconsistent(e.at);
  }

  std::size_t open(const ChainPoint& lower, const ChainPoint& upper) {
    cells_.push_back({{lower}, {upper}});
    return cells_.size() - 1;
  }
  void close(std::size_t cell, const ChainPoint& lower, const ChainPoint& upper) {
    cells_[cell].lower.push_back(lower);
    cells_[cell].upper.push_back(upper);
  }

  /// Removes vertical edges at both ends.
  static void trim(Chain& chain) {
    std::size_t begin = 0, end = chain.size();
    while (begin + 1 < end && chain[begin].point.x() == chain[begin + 1].point.x()) ++begin;
    while (end > begin + 1 && chain[end - 1].point.x() == chain[end - 2].point.x()) --end;
    chain = Chain(chain.begin() + static_cast<std::ptrdiff_t>(begin), chain.begin() + static_cast<std::ptrdiff_t>(end));
  }

  std::vector<PlaneSweepCell> finished_cells() {
    std::vector<PlaneSweepCell> out;
    for (PlaneSweepCell& c : cells_) {
      if (!(c.lower.front().point.x() < c.lower.back().point.x())) continue;
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

std::vector<PlaneSweepCell> plane_sweep_cells(const Region& region, Cuts cuts) { return PlaneSweep(cuts).run(region); }

}  // namespace oxturn
