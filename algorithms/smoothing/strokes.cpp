#include "algorithms/smoothing/strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "algorithms/smoothing/rounding.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

constexpr double kSameEnd = 1e-4;                              // tool widths
constexpr double kSameHeading = 1e-3;                          // radians
constexpr double kSampleStep = 0.25;                           // tool widths, along strokes
constexpr double kAcross[] = {-0.45, -0.225, 0, 0.225, 0.45};  // tool widths
constexpr double kLeastPart = 0.4;                             // radii, of an edge that is cut
constexpr double kUncovered = 0.05;                            // share of a stroke's swath that may be lost with it

/// Joins runs that go on from each other's ends in the same direction.
class Chains {
 public:
  Chains(std::vector<Polyline> runs, double width, const CarSpace& space)
      : space_(space), runs_(std::move(runs)), partner_(2 * runs_.size(), kNone) {
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> ends;
    for (std::size_t e = 0; e < partner_.size(); ++e) {
      const Point at = end_pose(e).at / (kSameEnd * width);
      ends[{std::llround(at.x()), std::llround(at.y())}].push_back(e);
    }
    for (const auto& [at, here] : ends)
      for (const std::size_t e : here)
        for (const std::size_t f : here)
          if (e < f && e / 2 != f / 2 && partner_[e] == kNone && partner_[f] == kNone && continues(e, f))
            partner_[e] = f, partner_[f] = e;
  }

  std::vector<Stroke> strokes() {
    std::vector<Stroke> result;
    for (std::size_t e = 0; e < partner_.size(); ++e)
      if (partner_[e] == kNone && !used(e)) result.push_back(chain_from(e));
    for (std::size_t e = 0; e < partner_.size(); ++e)  // what is left are rings
      if (!used(e)) result.push_back(chain_from(e));
    for (Stroke& s : result)
      if (!s.closed && s.points.size() > 3 && s.points.front() == s.points.back() &&
          std::abs(std::remainder(first_pose(s.points).heading - last_pose(s.points).heading, 2 * kPi)) < kSameHeading)
        s.closed = true;
    return result;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  /// End 2 r is the first of run r, 2 r + 1 the last. The heading leads out of the run.
  Pose end_pose(std::size_t e) const {
    const Polyline& run = runs_[e / 2];
    return e % 2 == 1 ? last_pose(run) : turned_round(first_pose(run));
  }
  bool continues(std::size_t e, std::size_t f) const {
    return std::abs(std::remainder(end_pose(e).heading - end_pose(f).heading - kPi, 2 * kPi)) < kSameHeading;
  }
  /// Ends that meet may be off each other by more than rounding, and then off a wall along which both runs lead.
  bool free_past(const Polyline& chain, std::size_t e) const {
    const Polyline& run = runs_[e / 2];
    return space_.free(Polyline{chain[chain.size() - 2], e % 2 == 1 ? run[run.size() - 2] : run[1]});
  }
  bool used(std::size_t e) const { return runs_[e / 2].empty(); }

  Stroke chain_from(std::size_t e) {
    const std::size_t begin = e;
    Polyline chain;
    while (e != kNone && !used(e)) {
      if (!chain.empty() && !free_past(chain, e)) {
        partner_[partner_[e]] = kNone, partner_[e] = kNone;
        return {std::move(chain), false};
      }
      Polyline run = std::exchange(runs_[e / 2], {});
      if (e % 2 == 1) std::ranges::reverse(run);
      // The vertex in which two runs meet is a point of a straight line: not needed, unless it closes the chain.
      if (!chain.empty()) chain.pop_back();
      chain.insert(chain.end(), run.begin() + (chain.empty() ? 0 : 1), run.end());
      e = partner_[e ^ 1];
    }
    return {std::move(chain), e == begin};
  }

  const CarSpace& space_;
  std::vector<Polyline> runs_;
  std::vector<std::size_t> partner_;
};

/// Which strokes the others cover.
class Cover {
 public:
  Cover(const std::vector<Stroke>& strokes, const Problem& problem)
      : strokes_(strokes), problem_(problem), width_(problem.robot().tool_width), kept_(strokes.size(), true) {
    for (std::size_t s = 0; s < strokes.size(); ++s)
      for (std::size_t i = 1; i < strokes[s].points.size(); ++i) {
        segments_.push_back({strokes[s].points[i - 1], strokes[s].points[i]});
        owner_.push_back(s);
      }
    grid_ = UniformGrid(segments_.size(), [&](std::size_t i) { return segments_[i]; });
  }

  /// By stroke.
  std::vector<char> needed() {
    std::vector<std::size_t> order(strokes_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t s) { return length(strokes_[s].points); });
    for (const std::size_t s : order) kept_[s] = share_lost(s) > kUncovered;
    return kept_;
  }

 private:
  double share_lost(std::size_t s) const {
    double all = 0, lost = 0;
    const Polyline& points = strokes_[s].points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point side = perpendicular(points[i] - points[i - 1]).normalized() * width_;
      const double parts = std::ceil(distance(points[i - 1], points[i]) / (kSampleStep * width_));
      const double each = distance(points[i - 1], points[i]) / parts;
      for (double k = 0.5; k < parts; ++k)
        for (const double across : kAcross) {
          const Point p = lerp(points[i - 1], points[i], k / parts) + across * side;
          if (!problem_.map_edges().contains(p)) continue;
          all += each;
          if (!covered_without(s, p)) lost += each;
        }
    }
    return all > 0 ? lost / all : 0;
  }

  bool covered_without(std::size_t s, const Point& p) const {
    return grid_.visit_items(std::array{p}, width_ / 2, [&](std::uint32_t i) {
      return owner_[i] != s && kept_[owner_[i]] &&
             distance_to_segment(p, segments_[i][0], segments_[i][1]) <= width_ / 2;
    });
  }

  const std::vector<Stroke>& strokes_;
  const Problem& problem_;
  double width_;
  std::vector<char> kept_;
  std::vector<std::array<Point, 2>> segments_;
  std::vector<std::size_t> owner_;
  UniformGrid grid_;
};

/// Without the last `metres`, or a little more: edges of a sampled curve are not cut, because a shorter edge would make
/// the curve sharper.
void shorten(Polyline& line, double metres, double radius) {
  while (line.size() > 1) {
    const double last = distance(line[line.size() - 2], line.back());
    if (last > metres + kLeastPart * radius) {
      line.back() = lerp(line.back(), line[line.size() - 2], metres / last);
      return;
    }
    if (metres <= 0) return;
    metres -= last;
    line.pop_back();
  }
  line.clear();
}

}  // namespace

std::vector<Polyline> work_lines(const Path& path) {
  std::vector<Polyline> lines;
  bool goes_on = false;
  for (const Leg& leg : path.legs) {
    if (leg.tool && !goes_on) lines.emplace_back();
    if (leg.tool) lines.back().insert(lines.back().end(), leg.points.begin() + (goes_on ? 1 : 0), leg.points.end());
    goes_on = leg.tool;
  }
  return lines;
}

Pose first_pose(const Polyline& line) { return {line.front(), heading(line[0], line[1])}; }
Pose last_pose(const Polyline& line) { return {line.back(), heading(line[line.size() - 2], line.back())}; }

std::vector<Stroke> strokes_of(const Path& path, const Problem& problem, const CarSpace& space) {
  std::vector<Polyline> runs;
  for (const Polyline& line : work_lines(path))
    for (Polyline& run : rounded_runs(line, space)) runs.push_back(std::move(run));
  std::vector<Stroke> strokes = Chains(std::move(runs), problem.robot().tool_width, space).strokes();
  const std::vector<char> needed = Cover(strokes, problem).needed();
  std::vector<Stroke> kept;
  for (std::size_t s = 0; s < strokes.size(); ++s)
    if (needed[s]) kept.push_back(std::move(strokes[s]));
  return kept;
}

void shorten_dead_ends(std::vector<Stroke>& strokes, const Problem& problem, const CarSpace& space) {
  const double step = problem.robot().tool_width / 4, turn = kPi * space.radius();
  for (Stroke& stroke : strokes) {
    if (stroke.closed) continue;
    for (int end = 0; end < 2 && !stroke.points.empty(); ++end) {
      while (stroke.points.size() > 1 && !space.can_go_on(last_pose(stroke.points), turn))
        shorten(stroke.points, step, space.radius());
      if (stroke.points.size() < 2) stroke.points.clear();
      std::ranges::reverse(stroke.points);
    }
  }
}

}  // namespace oxturn
