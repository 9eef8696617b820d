#include "algorithms/tethered/level_set_strips.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace oxturn {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);
constexpr double kCountSlack = 0.02;  // spacings: a set longer than n lanes by no more than this still takes n, between
                                      // driven boundaries
// Radial lanes pay only if a part of a run has this many more level sets than lanes.
constexpr std::size_t kLeastDepth = 2;

LaneEnds lane_of(const Polyline& line) { return {line.front(), line.back(), line}; }

using Run = std::vector<std::size_t>;  // indices of level sets, outwards

/// The longest one-to-one sequences of level sets.
std::vector<Run> runs_of(const Outward& outward) {
  std::vector<std::size_t> inward_count(outward.size(), 0);
  for (const auto& list : outward)
    for (const std::size_t b : list) ++inward_count[b];
  std::vector<Run> runs;
  std::vector<bool> used(outward.size(), false);
  for (std::size_t i = 0; i < outward.size(); ++i) {  // by level, so a run's first level set comes first
    if (used[i]) continue;
    Run& run = runs.emplace_back();
    for (std::size_t k = i;; k = outward[k][0]) {
      run.push_back(k);
      used[k] = true;
      if (outward[k].size() != 1 || inward_count[outward[k][0]] != 1) break;
    }
  }
  return runs;
}

/// Strips under construction: each level set belongs to one strip.
class StripList {
 public:
  explicit StripList(std::size_t sets) : strip_of_(sets, kNone) {}
  /// Appends a strip made of the level sets run[first] .. run[end - 1].
  void add(Strip strip, const Run& run, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) strip_of_[run[i]] = strips_.size();
    strips_.push_back(std::move(strip));
  }
  /// The strips, adjacent where their level sets are.
  std::vector<Strip> take(const Outward& outward) {
    for (std::size_t a = 0; a < outward.size(); ++a)
      for (const std::size_t b : outward[a]) connect(strips_, strip_of_[a], strip_of_[b]);
    return std::move(strips_);
  }

 private:
  std::vector<Strip> strips_;
  std::vector<std::size_t> strip_of_;
};

/// A level set addressed by shares of its length, from 0 to 1.
class Along {
 public:
  Along(const LevelSet& set, double spacing) : line_(set.line), total_(length(set.line)), spacing_(spacing) {
    const double trim = kLevelSetTrim * spacing;
    if (set.trimmed_begin) unneeded_[0] = std::min(0.5, trim / total_);
    if (set.trimmed_end) unneeded_[1] = std::min(0.5, trim / total_);
    slack_ = set.trimmed_begin && set.trimmed_end ? kCountSlack : 0;
  }
  /// How many radial lanes it needs.
  std::size_t lanes() const {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(total_ * needed_share() / spacing_ - slack_)));
  }
  /// Where a lane crosses it: evenly spaced over what is needed.
  double share(std::size_t lane, std::size_t lanes) const {
    return unneeded_[0] + needed_share() * (static_cast<double>(lane) + 0.5) / static_cast<double>(lanes);
  }
  /// From share f to share g (backwards if g < f), both ends included.
  Polyline part(double f, double g) const {
    Polyline inside;
    double so_far = 0;
    for (std::size_t i = 1; i + 1 < line_.size(); ++i) {
      so_far += distance(line_[i - 1], line_[i]);
      if (so_far > std::min(f, g) * total_ && so_far < std::max(f, g) * total_) inside.push_back(line_[i]);
    }
    if (g < f) std::reverse(inside.begin(), inside.end());
    Polyline out{at(f)};
    out.insert(out.end(), inside.begin(), inside.end());
    out.push_back(at(g));
    return out;
  }
  Point at(double f) const {
    if (f <= 0) return line_.front();
    if (f >= 1) return line_.back();
    double remaining = f * total_;
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const double d = distance(line_[i - 1], line_[i]);
      if (remaining <= d) return d > 0 ? lerp(line_[i - 1], line_[i], remaining / d) : line_[i];
      remaining -= d;
    }
    return line_.back();
  }

 private:
  double needed_share() const { return 1 - unneeded_[0] - unneeded_[1]; }

  const Polyline& line_;
  double total_, spacing_, slack_;
  double unneeded_[2] = {0, 0};  // shares at the beginning and at the end
};

/// Radial lanes across part of a run.
class RadialLanes {
 public:
  RadialLanes(std::vector<Along> sets, std::size_t lanes)
      : sets_(std::move(sets)), lanes_(lanes), top_(sets_.size() - 1) {}

  /// Do straight lanes from one level set to the next stay in `space`?
  static bool free_between(const Along& a, const Along& b, std::size_t lanes, const EdgeIndex& space) {
    for (std::size_t lane = 0; lane < lanes; ++lane)
      if (!space.contains(a.at(a.share(lane, lanes)), b.at(b.share(lane, lanes)))) return false;
    return true;
  }

  /// First along the whole first level set, then outwards on lane 0, inwards on lane 1, and so on. The last level set
  /// is driven whole at the end if the last lane leads outwards, else after lane 0.
  Polyline drive() {
    append(sets_.front().part(1, 0));
    append(sets_.front().part(0, at(0, 0)));
    const bool ends_outside = lanes_ % 2 == 1;
    const std::size_t whole_after = ends_outside ? lanes_ - 1 : 0;
    bool outwards = true;
    for (std::size_t lane = 0; lane < lanes_; ++lane, outwards = !outwards) {
      cross(lane, outwards);
      const bool last = lane + 1 == lanes_;
      if (!outwards)  // one level farther out, the round ends of the lanes would leave gaps to the first level set
        append(sets_[0].part(at(lane, 0), at(last ? lane : lane + 1, 0)));
      else if (outwards && lane == whole_after)
        drive_last_set(lane);
      else if (outwards)
        append(sets_[top_].part(at(lane, top_), at(lane + 1, top_)));
    }
    line_.erase(std::unique(line_.begin(), line_.end()), line_.end());
    return std::move(line_);
  }

 private:
  double at(std::size_t lane, std::size_t set) const { return sets_[set].share(lane, lanes_); }
  void append(const Polyline& more) { line_.insert(line_.end(), more.begin(), more.end()); }

  /// Over the level sets between the first and the last one.
  void cross(std::size_t lane, bool outwards) {
    for (std::size_t i = 1; i < top_; ++i) {
      const std::size_t set = outwards ? i : top_ - i;
      line_.push_back(sets_[set].at(at(lane, set)));
    }
  }
  /// To the nearer end, to the other end, and on to the next lane if there is one.
  void drive_last_set(std::size_t lane) {
    const double here = at(lane, top_), near = here <= 0.5 ? 0 : 1;
    append(sets_[top_].part(here, near));
    append(sets_[top_].part(near, 1 - near));
    if (lane + 1 < lanes_) append(sets_[top_].part(1 - near, at(lane + 1, top_)));
  }

  std::vector<Along> sets_;
  std::size_t lanes_;
  std::size_t top_;
  Polyline line_;
};

/// Divides a run into parts with radial lanes and parts driven along the level sets.
void add_run(const Run& run, const std::vector<LevelSet>& sets, const EdgeIndex& space, const RadialSettings& settings,
             StripList& strips) {
  std::vector<Along> along;
  for (const std::size_t k : run) along.emplace_back(sets[k], settings.spacing);
  Strip level;  // level sets from run[level_from] on that are driven whole
  std::size_t level_from = 0;
  const auto flush = [&](std::size_t end) {
    if (!level.lanes.empty()) strips.add(std::exchange(level, {}), run, level_from, end);
  };
  for (std::size_t first = 0; first < run.size();) {
    const std::size_t lanes = along[first].lanes();
    std::size_t end = first + 1;  // of the level sets that take the same small number of lanes
    if (lanes <= settings.most_lanes)
      while (end < run.size() && along[end].lanes() == lanes &&
             RadialLanes::free_between(along[end - 1], along[end], lanes, space))
        ++end;
    if (lanes <= settings.most_lanes && end - first >= lanes + kLeastDepth) {
      flush(first);
      const auto begin = along.begin();
      const std::vector<Along> part(begin + static_cast<std::ptrdiff_t>(first),
                                    begin + static_cast<std::ptrdiff_t>(end));
      strips.add({{lane_of(RadialLanes(part, lanes).drive())}}, run, first, end);
      first = end;
      continue;
    }
    if (level.lanes.empty()) level_from = first;
    level.lanes.push_back(lane_of(sets[run[first]].line));
    ++first;
  }
  flush(run.size());
}

}  // namespace

std::vector<Strip> strips_of_sets(const std::vector<LevelSet>& sets, const Outward& outward) {
  StripList strips(sets.size());
  for (std::size_t k = 0; k < sets.size(); ++k) strips.add({{lane_of(sets[k].line)}}, {k}, 0, 1);
  return strips.take(outward);
}

std::vector<Strip> strips_of_runs(const std::vector<LevelSet>& sets, const Outward& outward) {
  StripList strips(sets.size());
  for (const Run& run : runs_of(outward)) {
    Strip strip;
    for (const std::size_t k : run) strip.lanes.push_back(lane_of(sets[k].line));
    strips.add(std::move(strip), run, 0, run.size());
  }
  return strips.take(outward);
}

std::vector<Strip> strips_with_radial_lanes(const std::vector<LevelSet>& sets, const Outward& outward,
                                            const EdgeIndex& space, const RadialSettings& settings) {
  StripList strips(sets.size());
  for (const Run& run : runs_of(outward)) add_run(run, sets, space, settings, strips);
  return strips.take(outward);
}

}  // namespace oxturn
