#include "algorithms/polygon/needed_outline.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "algorithms/improve/completion.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/lanes/uncovered.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// In tool widths, or squares of it.
constexpr double kBin = 0.5;         // stretch of the boundary whose worth is counted
constexpr int kSmoothed = 2;         // bins on either side that its worth is averaged over: a pair of lanes
constexpr double kSample = 0.1;      // side of the cells by which uncovered area is counted
constexpr double kGap = 2;           // stretches this near to each other become one
constexpr double kShortest = 1;      // stretch
constexpr double kChord = 1.0 / 50;  // error of what stretches cover, as of the region of lanes (lane_region)
constexpr double kSliver = 1e-3;     // area of what is left between them and lanes
constexpr int kRepairs = 4;          // until the coverage is reached
/// The least worth of a stretch, uncovered area for its length in tool widths: half of them would be a band as wide as
/// the robot's reach; cusps of lanes across a wall have 0.05 to 0.1.
constexpr double kWorths[] = {0.5, 0.3, 0.2, 0.14, 0.1, 0.07, 0.05, 0.03};

/// Stretches of closed boundaries.
struct Stretches {
  std::vector<Polyline> open;
  std::vector<Ring> closed;
};

/// The boundary of a region in bins, each with the uncovered area that lies nearest to it.
class Worth {
 public:
  Worth(const Region& region, double width) : index_(region), width_(width) {
    const std::vector<EdgeIndex::Edge>& edges = index_.edges();
    for (std::size_t e = 0; e < edges.size(); ++e) {
      if (e == 0 || edges[e].a != edges[e - 1].b) loops_.push_back({{}, {0}, {}});
      Loop& loop = loops_.back();
      loop.ring.push_back(edges[e].a);
      loop.along.push_back(loop.along.back() + distance(edges[e].a, edges[e].b));
      position_.push_back({loops_.size() - 1, loop.ring.size() - 1});
    }
    for (Loop& loop : loops_)
      loop.worth.resize(std::max<std::size_t>(1, static_cast<std::size_t>(loop.length() / (kBin * width_))));
  }

  void count(const Region& uncovered) {
    const double side = kSample * width_;
    for (const Polygon& piece : uncovered.polygons) {
      const Box box = bounding_box(piece.outer);
      const Point cells = (box.high - box.low) / side;
      const BitGrid grid = rasterise({{piece}}, box.low, side, static_cast<int>(cells.x()) + 1,
                                     static_cast<int>(cells.y()) + 1, CellRule::centre);
      const double share = area(piece) / std::max<double>(1, static_cast<double>(grid.count()));
      for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
          if (grid.get(i, j)) add(grid.centre(i, j), share);
      if (grid.count() == 0) add(piece.outer.front(), share);
    }
  }

  /// Those above a worth, in tool widths.
  Stretches above(double least) const {
    Stretches found;
    for (const Loop& loop : loops_) add_stretches(loop, marked(loop, least * width_), found);
    return found;
  }

 private:
  struct Loop {
    Ring ring;
    std::vector<double> along;  // metres from the first vertex to each, and the whole length
    std::vector<double> worth;  // m^2, by bin
    double length() const { return along.back(); }
    double bin() const { return length() / static_cast<double>(worth.size()); }
  };

  void add(const Point& p, double size) {
    const auto nearest = index_.nearest(p);
    if (!nearest) return;
    const auto& [number, vertex] = position_[nearest->edge];
    Loop& loop = loops_[number];
    const double along = loop.along[vertex] + distance(loop.ring[vertex], nearest->point);
    const auto bin = static_cast<std::size_t>(along / loop.bin());
    loop.worth[std::min(bin, loop.worth.size() - 1)] += size;
  }

  /// Bins of stretches worth at least `least` metres, without short gaps and without short stretches.
  static std::vector<bool> marked(const Loop& loop, double least) {
    const std::size_t n = loop.worth.size(), around = std::min<std::size_t>(kSmoothed, (n - 1) / 2);
    std::vector<bool> mark(n);
    for (std::size_t b = 0; b < n; ++b) {
      double sum = 0;
      for (std::size_t k = 0; k <= 2 * around; ++k) sum += loop.worth[(b + n - around + k) % n];
      mark[b] = sum >= least * loop.bin() * static_cast<double>(2 * around + 1);
    }
    flip_runs(mark, false, static_cast<std::size_t>(kGap / kBin));
    flip_runs(mark, true, static_cast<std::size_t>(kShortest / kBin));
    return mark;
  }
  /// Runs of `value` in the circle that are no longer than `most` get the other value.
  static void flip_runs(std::vector<bool>& mark, bool value, std::size_t most) {
    const auto other = std::find(mark.begin(), mark.end(), !value);
    if (other == mark.end()) return;
    const std::size_t n = mark.size(), start = static_cast<std::size_t>(other - mark.begin());
    for (std::size_t k = 0; k < n;) {
      std::size_t end = k;
      while (end < n && mark[(start + end) % n] == value) ++end;
      if (end - k <= most)
        for (std::size_t i = k; i < end; ++i) mark[(start + i) % n] = !value;
      k = end + 1;
    }
  }

  static void add_stretches(const Loop& loop, const std::vector<bool>& mark, Stretches& found) {
    const auto off = std::find(mark.begin(), mark.end(), false);
    if (off == mark.end()) return found.closed.push_back(loop.ring);
    const std::size_t n = mark.size(), start = static_cast<std::size_t>(off - mark.begin());
    for (std::size_t k = 0; k < n;) {
      std::size_t end = k;
      while (end < n && mark[(start + end) % n]) ++end;
      if (end > k) found.open.push_back(stretch(loop, start + k, start + end));
      k = end + 1;
    }
  }
  /// From the beginning of one bin to that of another, once around at most.
  static Polyline stretch(const Loop& loop, std::size_t from, std::size_t to) {
    const std::size_t n = loop.worth.size(), count = loop.ring.size();
    double begin = static_cast<double>(from % n) * loop.bin();
    const double end = begin + static_cast<double>(to - from) * loop.bin();
    Polyline line{at(loop, begin)};
    for (std::size_t lap = 0; lap < 2; ++lap)
      for (std::size_t v = 0; v < count; ++v) {
        const double along = loop.along[v] + static_cast<double>(lap) * loop.length();
        if (along > begin && along < end && loop.ring[v] != line.back()) line.push_back(loop.ring[v]);
      }
    line.push_back(at(loop, std::fmod(end, loop.length())));
    return line;
  }
  static Point at(const Loop& loop, double along) {
    const auto next = std::upper_bound(loop.along.begin() + 1, loop.along.end() - 1, along);
    const auto v = static_cast<std::size_t>(next - loop.along.begin()) - 1;
    const Point &a = loop.ring[v], &b = loop.ring[(v + 1) % loop.ring.size()];
    const double edge = loop.along[v + 1] - loop.along[v];
    return edge > 0 ? lerp(a, b, std::clamp((along - loop.along[v]) / edge, 0.0, 1.0)) : a;
  }

  EdgeIndex index_;
  double width_;
  std::vector<Loop> loops_;
  std::vector<std::pair<std::size_t, std::size_t>> position_;  // of an edge: loop, and vertex where it begins
};

class NeededOutline {
 public:
  using StripsIn = std::function<std::vector<Strip>(const Region&)>;
  NeededOutline(const Problem& problem, double coverage, const StripsIn& strips_in, StripOrder order, Context& context)
      : problem_(problem),
        width_(problem.robot().tool_width),
        strips_in_(strips_in),
        order_(order),
        context_(context),
        connector_(problem),
        completion_(problem, coverage) {}

  Path shortest(Path whole) {
    if (completion_.whole())
      best_ = std::move(whole);  // which covers what it covers along traced walls, too
    else
      consider(std::move(whole));
    const Path lanes = lanes_in(problem_.configuration_space());
    Worth worth(straightened_space(problem_), width_);
    worth.count(uncovered(lanes));
    consider(lanes);
    for (const double least : kWorths) {
      if (context_.cancelled()) break;
      if (consider(with_stretches(worth.above(least)))) break;
    }
    return best_.value_or(lanes);
  }

 private:
  Path lanes_in(const Region& region) {
    return drive_strips(problem_, strips_in_(region), order_, connector_, context_);
  }

  /// What the path surely leaves uncovered, and slightly more.
  Region uncovered(const Path& path) const {
    std::vector<Polyline> lines;
    for (const Leg& leg : path.legs)
      if (leg.tool) lines.push_back(leg.points);
    return subtract(completion_.target(), swath_parts(lines, width_ / 2, Completion::kChord * width_, Bound::inside));
  }

  Path with_stretches(const Stretches& stretches) {
    std::vector<Polyline> lines = stretches.open;
    for (const Ring& ring : stretches.closed) {
      lines.push_back(ring);
      lines.back().push_back(ring.front());
    }
    Region inner =
        subtract(problem_.configuration_space(), swath_parts(lines, width_ / 2, kChord * width_, Bound::inside));
    std::erase_if(inner.polygons, [&](const Polygon& p) { return area(p) < kSliver * width_ * width_; });
    std::vector<Strip> strips = strips_in_(inner);
    for (const Polyline& line : stretches.open) {
      Strip& strip = strips.emplace_back();
      strip.lanes.push_back({line.front(), line.back(), line});
    }
    const Path path = drive_strips(problem_, strips, order_, connector_, context_);
    return with_rings(problem_, stretches.closed, path, width_, connector_, context_);
  }

  /// What has to be covered still.
  Region missing(const Path& path) const {
    return completion_.whole() ? oxturn::uncovered(completion_.target(), path, problem_.robot())
                               : completion_.needed(uncovered(path));
  }
  bool is_shortest(const Path& path) const {
    return !context_.cancelled() && (!best_ || path.length() < best_->length());
  }

  /// Keeps the path, with detours for what it lacks, if it is the shortest so far that reaches the coverage. Does it
  /// reach that without detours?
  bool consider(Path path) {
    Region rest = missing(path);
    const bool enough = rest.empty();
    double margin = covered_seam(problem_.robot());
    for (int round = 0; round < kRepairs && !rest.empty() && is_shortest(path); ++round, margin *= 2) {
      if (!completion_.whole()) {  // repaired() ignores seams
        const Region wider = dilate(rest, margin, Completion::kChord * width_, Bound::outside);
        rest = intersect(completion_.target(), wider);
      }
      path = repaired(problem_, path, std::move(rest), connector_, context_);
      rest = completion_.whole() ? Region{} : missing(path);
    }
    if (is_shortest(path) && (!best_ || rest.empty())) {
      best_ = without_short_segments(std::move(path), problem_);
      context_.publish(*best_);
    }
    return enough;
  }

  const Problem& problem_;
  double width_;
  const StripsIn& strips_in_;
  StripOrder order_;
  Context& context_;
  const Connector connector_;
  const Completion completion_;
  std::optional<Path> best_;
};

}  // namespace

Path drive_needed_outline(const Problem& problem, double coverage, Path whole,
                          const std::function<std::vector<Strip>(const Region&)>& strips_in, StripOrder order,
                          Context& context) {
  return NeededOutline(problem, coverage, strips_in, order, context).shortest(std::move(whole));
}

}  // namespace oxturn
