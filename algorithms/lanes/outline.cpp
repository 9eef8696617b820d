#include "algorithms/lanes/outline.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <tuple>

namespace oxturn {
namespace {

// Ring edges in a uniform grid with cells of about `reach`, for "what is within reach of this piece?".
class RingGrid {
 public:
  struct Item {
    std::uint32_t ring, edge;
  };
  RingGrid(const std::vector<const Ring*>& rings, const std::vector<bool>& skip, double reach) {
    std::size_t n = 0;
    for (std::size_t r = 0; r < rings.size(); ++r)
      if (!skip[r]) {
        n += rings[r]->size();
        for (const Point& p : *rings[r]) box_.add(p);
      }
    if (n == 0) return;
    const Point size = box_.size();
    cell_ = std::max({reach, std::sqrt(size.x() * size.y() / (4.0 * static_cast<double>(n) + 64)),
                      std::max(size.x(), size.y()) / 4000, 1e-12});
    columns_ = static_cast<int>(size.x() / cell_) + 1;
    rows_ = static_cast<int>(size.y() / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t r = 0; r < rings.size(); ++r)
      for (std::size_t e = 0; !skip[r] && e < rings[r]->size(); ++e) {
        const Point& a = (*rings[r])[e];
        const Point& b = (*rings[r])[(e + 1) % rings[r]->size()];
        const Item item{static_cast<std::uint32_t>(r), static_cast<std::uint32_t>(e)};
        // Row by row, only the columns that the edge passes there (a hair more, for rounding).
        const int j0 = std::min(row(a.y()), row(b.y())), j1 = std::max(row(a.y()), row(b.y()));
        for (int j = j0; j <= j1; ++j) {
          double x0 = a.x(), x1 = b.x();
          if (j0 != j1) {
            const auto x_at = [&](double y) {
              return a.x() + std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0) * (b.x() - a.x());
            };
            x0 = x_at(box_.low.y() + j * cell_);
            x1 = x_at(box_.low.y() + (j + 1) * cell_);
          }
          const auto [low, high] = std::minmax(x0, x1);
          for (int i = column(low - 1e-6 * cell_); i <= column(high + 1e-6 * cell_); ++i) at(i, j).push_back(item);
        }
      }
  }
  template <class F>
  void near(Box box, double reach, F f) const {
    box.grow(reach);
    if (cells_.empty() || !box.overlaps(box_)) return;
    for (int j = row(box.low.y()); j <= row(box.high.y()); ++j)
      for (int i = column(box.low.x()); i <= column(box.high.x()); ++i)
        for (const Item& item : cells_[index(i, j)]) f(item);
  }

 private:
  int column(double x) const { return static_cast<int>(std::clamp((x - box_.low.x()) / cell_, 0.0, columns_ - 1.0)); }
  int row(double y) const { return static_cast<int>(std::clamp((y - box_.low.y()) / cell_, 0.0, rows_ - 1.0)); }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  std::vector<Item>& at(int i, int j) { return cells_[index(i, j)]; }
  Box box_;
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::vector<Item>> cells_;
};

struct Meeting {
  double distance;
  Point first, second;
};

// Nearest places of two segments. Ends against segments, and the crossing if they cross.
Meeting meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const Point u = b - a, v = d - c, w = c - a;
  const double den = cross(u, v);
  if (den != 0) {
    const double s = cross(w, v) / den, t = cross(w, u) / den;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return {0, a + s * u, c + t * v};
  }
  Meeting best{1e300, a, c};
  const auto offer = [&](const Point& p, const Point& q) {
    const double d2 = distance(p, q);
    if (d2 < best.distance) best = {d2, p, q};
  };
  offer(a, nearest_on_segment(a, c, d));
  offer(b, nearest_on_segment(b, c, d));
  offer(nearest_on_segment(c, a, b), c);
  offer(nearest_on_segment(d, a, b), d);
  return best;
}

constexpr std::int64_t kPath = -1;

// A segment that rings may hang on: one of the path, or one of a ring that already hangs.
struct Source {
  std::int64_t owner;   // kPath or ring
  std::size_t segment;  // in the owner
  Point a, b;           // a piece of it
  Point origin;         // where the whole segment begins
};

struct Hook {  // how a ring hangs
  double distance = 1e300;
  std::int64_t owner = kPath;
  std::size_t segment = 0;
  double along = 0;      // from the segment's beginning
  Point from{0, 0};      // on the owner
  Point on{0, 0};        // on the ring
  std::size_t edge = 0;  // of the ring
};

class Splicer {
 public:
  Splicer(const Problem& problem, const Region& rings, const Path& path, double width, const Connector& connector,
          Context& context)
      : width_(width), connector_(connector), context_(context), builder_(problem.start()) {
    for_each_ring(rings, [&](const Ring& ring) { rings_.push_back(&ring); });
    hooks_.resize(rings_.size());
    attached_.assign(rings_.size(), false);
    children_.resize(rings_.size());
    points_.push_back(problem.start());
    for (const Leg& leg : path.legs)
      for (std::size_t i = 1; i < leg.points.size(); ++i) {
        points_.push_back(leg.points[i]);
        tool_.push_back(leg.tool);
      }
    if (tool_.empty()) {  // nothing but the start
      points_.push_back(problem.start());
      tool_.push_back(false);
    }
  }

  Path run() {
    attach_all();
    return drive_all();
  }

 private:
  void attach_all() {
    std::vector<Source> sources;
    for (std::size_t i = 0; i + 1 < points_.size(); ++i)
      sources.push_back({kPath, i, points_[i], points_[i + 1], points_[i]});
    std::size_t left = rings_.size();
    // A start far from everything is no reason to search in small steps.
    for (double reach = width_; left > 0 && !context_.cancelled(); reach *= 2) {
      const RingGrid grid(rings_, attached_, reach);
      using Offer = std::tuple<double, std::size_t>;
      std::priority_queue<Offer, std::vector<Offer>, std::greater<>> offers;
      std::vector<Hook> best(rings_.size());
      const auto search = [&](const Source& s) {
        // Long pieces are cut up, so that the box about a slanted one stays slim.
        const auto pieces = static_cast<std::size_t>(std::min(std::ceil(distance(s.a, s.b) / (4 * reach)) + 1, 1e6));
        for (std::size_t k = 0; k < pieces; ++k) {
          const double n = static_cast<double>(pieces);
          const Point a = lerp(s.a, s.b, static_cast<double>(k) / n),
                      b = lerp(s.a, s.b, static_cast<double>(k + 1) / n);
          Box box;
          box.add(a);
          box.add(b);
          grid.near(box, reach, [&](const RingGrid::Item& item) {
            if (attached_[item.ring]) return;
            const Ring& ring = *rings_[item.ring];
            const Meeting m = meet(a, b, ring[item.edge], ring[(item.edge + 1) % ring.size()]);
            if (m.distance > reach || m.distance >= best[item.ring].distance) return;
            best[item.ring] = {m.distance, s.owner,  s.segment, distance(s.origin, m.first),
                               m.first,    m.second, item.edge};
            offers.push({m.distance, item.ring});
          });
        }
      };
      for (const Source& s : sources) search(s);
      while (!offers.empty()) {
        const auto [d, ring] = offers.top();
        offers.pop();
        if (attached_[ring] || d > best[ring].distance) continue;
        attached_[ring] = true;
        --left;
        hooks_[ring] = best[ring];
        if (best[ring].owner == kPath)
          on_path_.push_back(ring);
        else
          children_[static_cast<std::size_t>(best[ring].owner)].push_back(ring);
        const Ring& r = *rings_[ring];
        for (std::size_t e = 0; e < r.size(); ++e) {
          sources.push_back({static_cast<std::int64_t>(ring), e, r[e], r[(e + 1) % r.size()], r[e]});
          search(sources.back());
        }
      }
    }
  }

  Path drive_all() {
    std::sort(on_path_.begin(), on_path_.end(), [&](std::size_t a, std::size_t b) {
      return std::tuple(hooks_[a].segment, hooks_[a].along, a) < std::tuple(hooks_[b].segment, hooks_[b].along, b);
    });
    std::size_t next = 0;
    for (std::size_t i = 0; i < tool_.size(); ++i) {
      for (; next < on_path_.size() && hooks_[on_path_[next]].segment == i; ++next) {
        builder_.drive(hooks_[on_path_[next]].from, tool_[i]);
        drive_tree(on_path_[next]);
      }
      builder_.drive(points_[i + 1], tool_[i]);
    }
    return builder_.take();
  }

  struct Visit {  // a ring being driven: an explicit stack, since rings may hang in long chains
    std::size_t ring;
    std::vector<std::size_t> children;  // in the order in which they are met
    std::size_t next_child = 0, steps = 0;
  };

  Visit enter(std::size_t ring) {
    const Hook& hook = hooks_[ring];
    connect(hook.from, hook.on);
    const std::size_t n = rings_[ring]->size();
    const double entry = distance((*rings_[ring])[hook.edge], hook.on);
    const auto key = [&](std::size_t child) {
      const Hook& h = hooks_[child];
      std::size_t step = (h.segment + n - hook.edge) % n;
      if (step == 0 && h.along < entry) step = n;  // behind the entry, on the edge that is finished last
      return std::tuple(step, h.along, child);
    };
    std::vector<std::size_t> children = children_[ring];
    std::sort(children.begin(), children.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    return {ring, std::move(children)};
  }

  void drive_tree(std::size_t root) {
    std::vector<Visit> stack;
    stack.push_back(enter(root));
    while (!stack.empty()) {
      Visit& v = stack.back();
      const Ring& ring = *rings_[v.ring];
      const Hook& hook = hooks_[v.ring];
      const std::size_t n = ring.size();
      if (v.next_child < v.children.size()) {
        const std::size_t child = v.children[v.next_child];
        const Hook& h = hooks_[child];
        std::size_t step = (h.segment + n - hook.edge) % n;
        if (step == 0 && h.along < distance(ring[hook.edge], hook.on)) step = n;
        if (step == v.steps) {
          ++v.next_child;
          builder_.drive(h.from, true);
          stack.push_back(enter(child));
          continue;
        }
      }
      if (v.steps < n) {
        ++v.steps;
        builder_.drive(ring[(hook.edge + v.steps) % n], true);
        continue;
      }
      builder_.drive(hook.on, true);
      connect(hook.on, hook.from);
      stack.pop_back();
    }
  }

  void connect(const Point& a, const Point& b) {
    const Polyline way = connector_.path(a, b);
    builder_.drive(way, length(way) <= width_);
  }

  double width_;
  const Connector& connector_;
  Context& context_;
  PathBuilder builder_;
  std::vector<const Ring*> rings_;
  std::vector<Hook> hooks_;
  std::vector<bool> attached_;
  std::vector<std::vector<std::size_t>> children_;  // rings that hang on a ring
  std::vector<std::size_t> on_path_;
  std::vector<Point> points_;  // of the path
  std::vector<bool> tool_;     // of its segments
};

}  // namespace

Path with_outline(const Problem& problem, const Path& path, double width, const Connector& connector,
                  Context& context) {
  return with_rings(problem, problem.configuration_space(), path, width, connector, context);
}

Path with_rings(const Problem& problem, const Region& rings, const Path& path, double width, const Connector& connector,
                Context& context) {
  return Splicer(problem, rings, path, width, connector, context).run();
}

}  // namespace oxturn
