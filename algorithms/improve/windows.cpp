#include "algorithms/improve/windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "algorithms/improve/window_parts.hpp"
#include "base/math.hpp"
#include "base/parallel.hpp"
#include "geometry/raster.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {
namespace {

// In tool widths.
constexpr double kSide = 16;  // of a window
// Longest side of a target that is annealed as a whole where it is hot, and else. Where it is hot, lanes are shifted in
// all their length, which cannot be done in windows.
constexpr double kWhole = 160, kWholeIfCold = 40;
constexpr double kMostPoints = 8e7;  // of a raster of the whole
constexpr double kSample = 0.5;      // distance of the points by which moves are shared out
constexpr double kCoarsest = 0.1;    // distance of the points of a raster, unless a coarser one is asked for
// Moves of a pass for each window, unless that makes too few or too many passes.
constexpr double kMovesEach = 4000;
constexpr int kLeastPasses = 3, kMostPasses = 32;
constexpr double kNearFocus = 0.8;  // share of the moves
// A window gets at least one move for so many points of its raster, as does the whole raster, and a pass gets one for
// so many vertices of the path: the time to find what is in them.
constexpr double kPointsEach = 1250, kVerticesEach = 2;
// Changes of the price from pass to pass: its logarithm by kPower times that of the uncovered area, of what is allowed,
// as it will be if it goes on changing kAhead times as much; by kMostStep at most.
constexpr double kPower = 0.3, kAhead = 1.5, kMostStep = 0.25, kLeastUncovered = 0.01;
constexpr double kNoHeat = 1e-9;   // temperature, in tool widths
constexpr double kPriceRange = 6;  // times and parts of the first price that it may reach

/// Squares in the raster's directions, which cover a box.
class Grid {
 public:
  Grid(const Box& box, const Point& low, double side)
      : low_(low), side_(side), columns_(count(box.high.x() - low.x())), rows_(count(box.high.y() - low.y())) {}
  std::size_t size() const { return columns_ * rows_; }
  std::size_t at(const Point& p) const {
    return index(p.y() - low_.y(), rows_) * columns_ + index(p.x() - low_.x(), columns_);
  }
  Box window(std::size_t k) const {
    const Point corner = low_ + side_ * Point(static_cast<double>(k % columns_), static_cast<double>(k / columns_));
    return {corner, corner + Point(side_, side_)};
  }
  /// 0 to 3: windows of the same batch are a window's side apart at least.
  std::size_t batch(std::size_t k) const { return k / columns_ % 2 * 2 + k % columns_ % 2; }

 private:
  std::size_t count(double length) const { return static_cast<std::size_t>(length / side_) + 1; }
  std::size_t index(double at, std::size_t n) const {
    return at > 0 ? std::min(static_cast<std::size_t>(at / side_), n - 1) : 0;
  }
  Point low_;
  double side_;
  std::size_t columns_, rows_;
};

class Windows {
 public:
  Windows(const Problem& problem, const Region& target, const Annealing::Options& options,
          const std::vector<Point>& focus, int threads)
      : walls_(problem.walls()),
        width_(problem.robot().tool_width),
        target_(Witnesses::turned(target)),
        box_(bounding_box(target_)),
        options_(options),
        focus_(focus),
        threads_(threads) {}

  bool one(double hot) const {
    const double longest = std::max(box_.size().x(), box_.size().y());
    return options_.without == AnnealingPart::windows ||
           longest <= (hot > options_.hot * width_ ? kWhole : kWholeIfCold) * width_;
  }

  Annealed whole(const Polyline& points, const Annealing::Schedule& schedule, Rng& rng, const Context& context) const {
    std::vector<std::size_t> fixed{0};
    if (options_.fixed_end) fixed.push_back(points.size() - 1);
    Annealing::Options options = options_;
    options.cell = std::max(options.cell, std::sqrt(box_.size().x() * box_.size().y() / kMostPoints));
    Annealing annealing(walls_, VertexPath(points, fixed, width_), witnesses(points, options.cell), width_, options);
    annealing.focus(focus_);
    annealing.run(schedule, rng, context);
    const Effort effort{static_cast<double>(schedule.moves), static_cast<double>(annealing.witnesses().bytes()), 0};
    return {annealing.path().points(), annealing.uncovered(), annealing.price(), effort};
  }

  Annealed in_passes(const Polyline& points, const Annealing::Schedule& schedule, Rng& rng, const Context& context) {
    options_.floating = false;
    sample();
    const double moves = static_cast<double>(schedule.moves);
    make_raster(moves);
    Annealed now{points, uncovered(points), options_.price};
    now.effort.raster_points = box_.size().prod() / math::pow(options_.cell, 2);
    const double first = now.price;
    const double windows = static_cast<double>(samples_.size()) * kSample * kSample / (kSide * kSide);
    const double worthwhile = std::max(1.0, kVerticesEach * moves / static_cast<double>(points.size()));
    const int passes = static_cast<int>(
        std::min(worthwhile, std::clamp<double>(moves / (windows * kMovesEach), kLeastPasses, kMostPasses)));
    const auto temperature = [&](int k) {
      return schedule.hot * math::pow(schedule.cold / schedule.hot, static_cast<double>(k) / passes);
    };
    const auto excess = [&] { return math::log(std::max(now.uncovered / options_.uncovered, kLeastUncovered)); };
    for (int k = 0; k < passes && !context.cancelled(); ++k) {
      const double last = excess();
      now = pass(std::move(now), {schedule.moves / passes, temperature(k), temperature(k + 1)}, rng, context);
      const double step = kPower * (excess() + kAhead * (excess() - last));
      now.price = std::clamp(now.price * math::exp(std::clamp(step, -kMostStep, kMostStep)), first / kPriceRange,
                             first * kPriceRange);
    }
    return now;
  }

 private:
  struct Task {
    Box window;
    std::vector<Point> focus;
    long moves = 0;
    std::uint64_t seed = 0;
  };
  /// Of the whole target, less what the line covers.
  Witnesses witnesses(const Polyline& line, double cell) const {
    Witnesses all(target_, box_, cell, options_.radius);
    add(boxes_of(line), line, box_, all);
    return all;
  }
  /// In the box, turned, less what the line covers; the same points in every box. `edges`: boxes_of(line).
  Witnesses witnesses(const Box& box, const BoxIndex& edges, const Polyline& line) const {
    const CellRange part = cells_in(box);
    Witnesses all(*raster_, box_.low, part, options_.cell, options_.radius);
    if (all.points() > 0) add(edges, line, grown(box, options_.cell), all);
    return all;
  }
  /// What the edges cover that come near the box.
  void add(const BoxIndex& edges, const Polyline& line, const Box& box, Witnesses& to) const {
    Witnesses::Capsule capsule;
    for (const std::uint32_t i : edges.overlapping(grown(box, options_.radius))) {
      to.capsule(line[i], line[i + 1], capsule);
      to.add(capsule);
    }
  }
  /// Of each edge, turned.
  static BoxIndex boxes_of(const Polyline& line) {
    std::vector<Box> boxes(line.size() - 1);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      boxes[i].add(Witnesses::turned(line[i]));
      boxes[i].add(Witnesses::turned(line[i + 1]));
    }
    return BoxIndex(std::move(boxes));
  }
  /// No finer than the moves pay for.
  void make_raster(double moves) {
    const double area = static_cast<double>(samples_.size()) * math::pow(kSample * width_, 2);
    const double paid_for = std::min(std::sqrt(area / (kPointsEach * std::max(moves, 1.0))), kCoarsest * width_);
    options_.cell = std::max(options_.cell, paid_for);
    const auto count = [&](double size) { return static_cast<int>(size / options_.cell) + 1; };
    raster_.emplace(target_, box_.low, options_.cell, count(box_.size().x()), count(box_.size().y()));
  }
  CellRange cells_in(const Box& box) const {
    const auto index = [&](double at, int n) {
      return static_cast<int>(std::clamp(std::floor(at / options_.cell), 0.0, static_cast<double>(n)));
    };
    const Point low = box.low - box_.low, high = box.high - box_.low;
    const int columns = raster_->columns(), rows = raster_->rows();
    CellRange part{index(low.x(), columns), index(low.y(), rows), index(high.x() + options_.cell, columns),
                   index(high.y() + options_.cell, rows)};
    part.end_column = std::max(part.end_column, part.column);
    part.end_row = std::max(part.end_row, part.row);
    return part;
  }
  static Box grown(const Box& box, double by) { return {box.low - Point(by, by), box.high + Point(by, by)}; }

  double uncovered(const Polyline& points) const {
    const Grid grid(box_, box_.low, kSide * width_);
    const BoxIndex edges = boxes_of(points);
    std::vector<double> areas(grid.size());
    in_parallel(threads_, grid.size(),
                [&](std::size_t k) { areas[k] = area_uncovered(witnesses(grid.window(k), edges, points)); });
    return std::accumulate(areas.begin(), areas.end(), 0.0);
  }
  static double area_uncovered(const Witnesses& witnesses) {
    return static_cast<double>(witnesses.uncovered()) * witnesses.area_each();
  }

  void sample() {
    const double cell = kSample * width_;
    const auto count = [&](double size) { return static_cast<int>(size / cell) + 1; };
    const BitGrid grid =
        rasterise(target_, box_.low, cell, count(box_.size().x()), count(box_.size().y()), CellRule::centre);
    for (int j = 0; j < grid.rows; ++j)
      for (int i = 0; i < grid.columns; ++i)
        if (grid.bits[grid.at(i, j)] != 0) samples_.push_back(grid.centre(i, j));
  }

  /// In each window, as many moves as it has of the target, and of the focus; if these are few, in some windows only.
  /// In batches of windows that do not see each other.
  Annealed pass(Annealed now, const Annealing::Schedule& schedule, Rng& rng, const Context& context) const {
    const double side = kSide * width_, x = rng.unit(), y = rng.unit();
    const Grid grid(box_, box_.low - side * Point(x, y), side);
    std::vector<double> share(grid.size());
    std::vector<std::vector<Point>> focus(grid.size());
    const double of_focus = focus_.empty() ? 0 : kNearFocus;
    for (const Point& p : samples_) share[grid.at(p)] += (1 - of_focus) / static_cast<double>(samples_.size());
    for (const Point& p : focus_) {
      const std::size_t k = grid.at(Witnesses::turned(p));
      share[k] += of_focus / static_cast<double>(focus_.size());
      focus[k].push_back(p);
    }
    const double least = math::pow((side + 2 * options_.radius) / options_.cell, 2) / kPointsEach;
    const std::uint64_t seed = rng.bits();
    std::array<std::vector<Task>, 4> batches;
    for (std::size_t k = 0; k < grid.size(); ++k) {
      double moves = share[k] * static_cast<double>(schedule.moves);
      if (moves < least) moves = rng.unit() * least < moves ? least : 0;  // by lot: as many on average
      if (moves < 1) continue;
      batches[grid.batch(k)].push_back(
          {grid.window(k), std::move(focus[k]), static_cast<long>(moves), mix(seed, std::to_string(k))});
    }
    for (std::vector<Task>& batch : batches)
      if (!batch.empty() && !context.cancelled()) change(now, batch, schedule, context);
    return now;
  }

  /// All windows of a batch, from the same path.
  void change(Annealed& now, std::vector<Task>& batch, const Annealing::Schedule& schedule,
              const Context& context) const {
    std::vector<Box> windows;
    for (const Task& task : batch) windows.push_back(task.window);
    const WindowParts parts(now.points, windows, walls_, width_, options_.fixed_end);
    std::vector<std::optional<VertexPath>> changed(batch.size());
    std::vector<double> more(batch.size());  // area uncovered
    std::vector<Effort> efforts(batch.size());
    const BoxIndex edges = boxes_of(parts.path());
    in_parallel(threads_, batch.size(), [&](std::size_t k) {
      if (!parts.visited(k)) return;
      Task& task = batch[k];
      Annealing::Options options = options_;
      options.price = now.price;
      Witnesses seen = witnesses(grown(task.window, options_.radius), edges, parts.path());
      const double before = area_uncovered(seen);
      efforts[k] = {static_cast<double>(task.moves), static_cast<double>(seen.bytes()), 0};
      Annealing annealing(walls_, parts.part(k), std::move(seen), width_, options);
      annealing.focus(std::move(task.focus));
      Rng rng(task.seed);
      annealing.run({task.moves, schedule.hot, schedule.cold}, rng, context);
      more[k] = annealing.uncovered() - before;
      changed[k] = annealing.path();
    });
    Joined joined = parts.joined(changed);
    now.points = std::move(joined.path);
    for (std::size_t k = 0; k < batch.size(); ++k) {
      if (joined.kept[k] != 0) now.uncovered += more[k];
      now.effort += efforts[k];
    }
  }

  const EdgeIndex& walls_;
  double width_;
  const Region target_;  // turned
  const Box box_;        // of it
  Annealing::Options options_;
  std::vector<Point> focus_;
  int threads_;
  std::vector<Point> samples_;        // of the target, turned
  std::optional<RasterRows> raster_;  // of the target, turned: for windows
};

}  // namespace

Annealed annealed(const Problem& problem, const Region& target, const Polyline& points,
                  const Annealing::Options& options, const Annealing::Schedule& schedule,
                  const std::vector<Point>& focus, int threads, Rng& rng, const Context& context) {
  Windows windows(problem, target, options, focus, threads);
  Annealing::Schedule at = schedule;
  if (options.without == AnnealingPart::heat) at.hot = at.cold = kNoHeat * problem.robot().tool_width;
  return windows.one(schedule.hot) ? windows.whole(points, at, rng, context)
                                   : windows.in_passes(points, at, rng, context);
}

}  // namespace oxturn
