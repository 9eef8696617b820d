// Decisions  1. A place y of a level set is of use if the geodesic through it has a point within spacing / 2 of y that is
//               farther than spacing / 2 from the boundary of `inner`. That is looked up at five points of the ray and
//               with a margin of a fifth of the spacing, which is more than can lie between them; at a lap's ends at
//               17 points, with a margin of kFine.
//            2. Stretches of no use, at most two spacings long and free, are kept: a break costs more.
#include "algorithms/tethered/level_sets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

constexpr double kMargin = 0.2;  // of the spacing
constexpr double kFine = 0.04;   // of the spacing: what a lap may be longer than needed at each end

/// Cuts level sets down to what is of use.
class Trimmer {
 public:
  Trimmer(const Region& space, const Region& inner, double spacing, double chord)
      : space_(space), inner_(inner), spacing_(spacing), chord_(chord) {}

  void add(const std::vector<GeodesicField::Arc>& chain, std::size_t level, std::vector<LevelSet>& out) {
    places_.clear();
    for (const GeodesicField::Arc& arc : chain) sample(arc);
    std::size_t begin = 0;
    while (begin < places_.size()) {
      if (!places_[begin].use) {
        ++begin;
        continue;
      }
      // As far as it is free, bridging short stretches of no use.
      std::size_t last = begin;
      double idle = 0;
      for (std::size_t i = begin + 1; i < places_.size(); ++i) {
        if (!places_[i].free || !space_.contains(places_[i - 1].at, places_[i].at)) break;
        idle += distance(places_[i - 1].at, places_[i].at);
        if (idle > 2 * spacing_) break;
        if (!places_[i].use) continue;
        last = i;
        idle = 0;
      }
      emit(begin, last, level, out);
      begin = last + 1;
    }
  }

 private:
  struct Location {
    Point at, out;  // out: away from the string
    double radius;
    bool free, use;
  };

  void sample(const GeodesicField::Arc& arc) {
    // Chord error of a step a: radius (1 - cos(a / 2)).
    const double by_chord = 2 * std::acos(std::clamp(1 - chord_ / arc.radius, -1.0, 1.0));
    const double step = std::min({by_chord, spacing_ / 8 / arc.radius, kPi / 4});
    const auto n = static_cast<std::size_t>(std::ceil((arc.end - arc.begin) / step * (1 - 1e-9)));
    double known = 0;  // places nearer than this to the one last looked at are of use as well
    for (std::size_t i = 0; i <= std::max<std::size_t>(n, 1); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(n, 1));
      const double angle = arc.begin + share * (arc.end - arc.begin);
      const Point p = arc.at(angle);
      if (!places_.empty()) {
        const double moved = distance(places_.back().at, p);
        if (moved <= 1e-12 * arc.radius) continue;
        known -= moved;
      }
      const Point out(std::cos(angle), std::sin(angle));
      if (known > 0) {
        places_.push_back({p, out, arc.radius, true, true});
        continue;
      }
      const double depth = depth_of(p);
      if (depth > (0.5 + kMargin) * spacing_) known = depth - (0.5 - kMargin) * spacing_;
      places_.push_back({p, out, arc.radius, space_.contains(p), useful(p, out, arc.radius, depth)});
    }
  }

  /// Distance to the boundary of `inner`, 0 outside of it; no more is asked than 2 spacings.
  double depth_of(const Point& p) const {
    if (!inner_.contains(p)) return 0;
    const auto hit = inner_.nearest(p, 4 * spacing_);
    return hit ? hit->distance : 4 * spacing_;
  }
  bool useful(const Point& p, const Point& out, double radius, double depth) const {
    const double enough = (0.5 - kMargin) * spacing_;
    if (depth > enough) return space_.contains(p);
    if (!space_.contains(p)) return false;
    for (const double t : {-0.5, -0.25, 0.25, 0.5})
      if (radius + t * spacing_ > 0 && depth_of(p + t * spacing_ * out) > enough) return true;
    return false;
  }

  bool needed(const Location& place) const {
    const double enough = (0.5 - kFine) * spacing_;
    for (int k = -8; k <= 8; ++k) {
      const double t = k * spacing_ / 16;
      if (place.radius + t > 0 && depth_of(place.at + t * place.out) > enough) return true;
    }
    return false;
  }
  /// Between a place that is not needed and one that is: where need begins, or a little before.
  Location threshold(Location idle, Location useful) const {
    for (int k = 0; k < 6; ++k) {
      Location middle = idle;
      middle.at = lerp(idle.at, useful.at, 0.5);
      middle.out = lerp(idle.out, useful.out, 0.5).normalized();
      (needed(middle) ? useful : idle) = middle;
    }
    return idle;
  }

  void emit(std::size_t first, std::size_t last, std::size_t level, std::vector<LevelSet>& out) const {
    std::size_t begin = first, end = last;
    while (begin < end && !needed(places_[begin])) ++begin;
    while (end > begin && !needed(places_[end])) --end;
    LevelSet lap{level, {}};
    if (begin > first) lap.line.push_back(threshold(places_[begin - 1], places_[begin]).at);
    for (std::size_t i = begin; i <= end; ++i) lap.line.push_back(places_[i].at);
    if (end < last) lap.line.push_back(threshold(places_[end + 1], places_[end]).at);
    if (lap.line.size() < 2 || (begin == end && !needed(places_[begin]))) return;
    out.push_back(std::move(lap));
  }

  const EdgeIndex space_, inner_;
  double spacing_, chord_;
  std::vector<Location> places_;
};

/// The place `back` metres back along the geodesic to p, or nothing if that is beyond the anchor.
std::optional<Point> towards_anchor(const GeodesicField& field, Point p, double back) {
  for (int guard = 0; guard < 1000; ++guard) {
    const GeodesicField::Sight sight = field.sight(p);
    const double rest = distance(sight.from, p);
    if (back <= rest) return rest > 0 ? lerp(p, sight.from, back / rest) : p;
    if (sight.corners == 0 || rest <= 0) return std::nullopt;
    back -= rest;
    p = sight.from;
  }
  return std::nullopt;
}

/// Points of laps in a grid of cells `side` wide, by sorted keys.
class LevelSetGrid {
 public:
  LevelSetGrid(const std::vector<LevelSet>& laps, double side) : laps_(laps), side_(side) {
    for (std::size_t k = 0; k < laps.size(); ++k)
      for (std::size_t i = 0; i < laps[k].line.size(); ++i) {
        const Point& p = laps[k].line[i];
        items_.push_back({column(p.x()), column(p.y()), static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i)});
      }
    std::sort(items_.begin(), items_.end());
  }
  /// The lap of this level with the point nearest to p, if nearer than `side`.
  std::optional<std::size_t> nearest(const Point& p, std::size_t level) const {
    std::optional<std::size_t> best;
    double least = side_;
    for (std::int64_t i = column(p.x()) - 1; i <= column(p.x()) + 1; ++i) {
      const std::int64_t j = column(p.y());
      auto it = std::lower_bound(items_.begin(), items_.end(), Item{i, j - 1, 0, 0});
      for (; it != items_.end() && it->column == i && it->row <= j + 1; ++it) {
        if (laps_[it->lap].level != level) continue;
        const double d = distance(laps_[it->lap].line[it->point], p);
        if (d < least) {
          least = d;
          best = it->lap;
        }
      }
    }
    return best;
  }

 private:
  struct Item {
    std::int64_t column, row;
    std::uint32_t lap, point;
    auto operator<=>(const Item&) const = default;
  };
  std::int64_t column(double x) const { return static_cast<std::int64_t>(std::floor(x / side_)); }
  const std::vector<LevelSet>& laps_;
  double side_;
  std::vector<Item> items_;
};

}  // namespace

std::vector<LevelSet> laps(const TetherSpace& leash, const Region& space, const Region& inner, double spacing, double chord) {
  std::vector<LevelSet> all;
  if (inner.empty()) return all;
  Trimmer trimmer(space, inner, spacing, chord);
  const double end = std::min(leash.tether_length(), leash.field().farthest());
  for (std::size_t k = 0; (static_cast<double>(k) + 0.5) * spacing < end; ++k)
    for (const auto& chain : leash.field().level_set((static_cast<double>(k) + 0.5) * spacing)) trimmer.add(chain, k, all);
  return all;
}

std::vector<std::vector<std::size_t>> outward_neighbours(const std::vector<LevelSet>& laps, const GeodesicField& field,
                                                         double spacing) {
  std::vector<std::vector<std::size_t>> outward(laps.size());
  const LevelSetGrid grid(laps, spacing / 2);
  for (std::size_t b = 0; b < laps.size(); ++b) {
    if (laps[b].level == 0) continue;
    double since = spacing;  // ask at the ends and every half spacing
    for (std::size_t i = 0; i < laps[b].line.size(); ++i) {
      if (i > 0) since += distance(laps[b].line[i - 1], laps[b].line[i]);
      if (since < spacing / 2 && i + 1 < laps[b].line.size()) continue;
      since = 0;
      const auto back = towards_anchor(field, laps[b].line[i], spacing);
      if (!back) continue;
      if (const auto a = grid.nearest(*back, laps[b].level - 1)) outward[*a].push_back(b);
    }
  }
  for (std::vector<std::size_t>& list : outward) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return outward;
}

namespace {

/// Places along a lap, by share of its length.
class Along {
 public:
  explicit Along(const Polyline& line) : line_(line), whole_(length(line)) {}
  double whole() const { return whole_; }
  /// The part from share f to share g (backwards if g < f), both ends included.
  Polyline part(double f, double g) const {
    Polyline out{at(f)};
    double run = 0;
    Polyline inside;
    for (std::size_t i = 1; i + 1 < line_.size(); ++i) {
      run += distance(line_[i - 1], line_[i]);
      if (run > std::min(f, g) * whole_ && run < std::max(f, g) * whole_) inside.push_back(line_[i]);
    }
    if (g < f) std::reverse(inside.begin(), inside.end());
    out.insert(out.end(), inside.begin(), inside.end());
    out.push_back(at(g));
    return out;
  }
  Point at(double f) const {
    if (f <= 0) return line_.front();
    if (f >= 1) return line_.back();
    double left = f * whole_;
    for (std::size_t i = 1; i < line_.size(); ++i) {
      const double d = distance(line_[i - 1], line_[i]);
      if (left <= d) return d > 0 ? lerp(line_[i - 1], line_[i], left / d) : line_[i];
      left -= d;
    }
    return line_.back();
  }

 private:
  const Polyline& line_;
  double whole_;
};

/// Where lane number `lane` of `count` crosses a lap: within what is needed of it.
double share(const Along& lap, std::size_t lane, std::size_t count, double spare) {
  const double free = std::min(0.5, spare / lap.whole());
  return free + (1 - 2 * free) * (static_cast<double>(lane) + 0.5) / static_cast<double>(count);
}

/// May `count` lanes go straight from one lap to the next?
bool lanes_free(const Along& a, const Along& b, std::size_t count, double spare, const EdgeIndex& space) {
  for (std::size_t lane = 0; lane < count; ++lane)
    if (!space.contains(a.at(share(a, lane, count, spare)), b.at(share(b, lane, count, spare)))) return false;
  return true;
}

/// The run of laps swept along the string by `count` lanes; its first and last lap are driven whole.
Polyline radial(const std::vector<Along>& run, std::size_t count, double spare) {
  Polyline line;
  const auto append = [&](const Polyline& more) { line.insert(line.end(), more.begin(), more.end()); };
  const auto at = [&](std::size_t lane, std::size_t lap) { return share(run[lap], lane, count, spare); };
  const std::size_t top = run.size() - 1;
  append(run.front().part(1, 0));
  append(run.front().part(0, at(0, 0)));
  for (std::size_t lane = 0; lane < count; ++lane) {
    const bool out = lane % 2 == 0;
    for (std::size_t i = 1; i < top; ++i) {
      const std::size_t lap = out ? i : top - i;
      line.push_back(run[lap].at(at(lane, lap)));
    }
    if (!out) {
      if (lane + 1 < count) append(run[1].part(at(lane, 1), at(lane + 1, 1)));
      continue;
    }
    // All of the last lap, the first time if the sweep ends at the bottom, else the last time.
    const double here = at(lane, top);
    if (count % 2 == 0 ? lane == 0 : lane + 1 == count) {
      const double near = here <= 0.5 ? 0 : 1;
      append(run[top].part(here, near));
      append(run[top].part(near, 1 - near));
      if (lane + 1 < count) append(run[top].part(1 - near, at(lane + 1, top)));
    } else {
      append(run[top].part(here, at(lane + 1, top)));
    }
  }
  line.erase(std::unique(line.begin(), line.end()), line.end());
  return line;
}

}  // namespace

std::vector<Strip> strips_of(const std::vector<LevelSet>& laps, const std::vector<std::vector<std::size_t>>& outward,
                             const EdgeIndex& space, double spacing, int lanes, bool single) {
  constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<std::size_t> parents(laps.size(), 0);
  for (const auto& list : outward)
    for (const std::size_t b : list) ++parents[b];
  std::vector<std::size_t> strip_of(laps.size(), kNone);
  std::vector<Strip> strips;
  const double spare = kFine * spacing;
  const auto needed = [&](std::size_t k) {
    return static_cast<std::size_t>(std::max(1.0, std::ceil(length(laps[k].line) / spacing - 2 * kFine - 0.02)));
  };
  const auto add = [&](Strip strip, const std::vector<std::size_t>& run, std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) strip_of[run[i]] = strips.size();
    strips.push_back(std::move(strip));
  };
  // Of a run: what takes the same small number of lanes, for long enough, goes along the string; the rest are laps.
  const auto add_run = [&](const std::vector<std::size_t>& run) {
    std::vector<Along> alongs;
    for (const std::size_t k : run) alongs.emplace_back(laps[k].line);
    Strip across;
    std::size_t across_from = 0;
    const auto flush = [&](std::size_t end) {
      if (!across.lanes.empty()) add(std::exchange(across, {}), run, across_from, end);
    };
    for (std::size_t first = 0; first < run.size();) {
      const std::size_t count = needed(run[first]);
      std::size_t end = first + 1;
      if (count <= static_cast<std::size_t>(lanes))
        while (end < run.size() && needed(run[end]) == count &&
               lanes_free(alongs[end - 1], alongs[end], count, spare, space))
          ++end;
      if (count <= static_cast<std::size_t>(lanes) && end - first >= count + 2) {
        flush(first);
        Polyline line = radial(
            {alongs.begin() + static_cast<std::ptrdiff_t>(first), alongs.begin() + static_cast<std::ptrdiff_t>(end)},
            count, spare);
        add({{{line.front(), line.back(), line}}, {}, {}, {}}, run, first, end);
        first = end;
        continue;
      }
      if (across.lanes.empty()) across_from = first;
      const Polyline& line = laps[run[first]].line;
      across.lanes.push_back({line.front(), line.back(), line});
      ++first;
    }
    flush(run.size());
  };
  for (std::size_t i = 0; i < laps.size(); ++i) {  // by level: a run's first lap comes first
    if (strip_of[i] != kNone) continue;
    std::vector<std::size_t> run;
    for (std::size_t k = i;; k = outward[k][0]) {
      run.push_back(k);
      if (single || outward[k].size() != 1 || parents[outward[k][0]] != 1) break;
    }
    add_run(run);
  }
  for (std::size_t a = 0; a < laps.size(); ++a)
    for (const std::size_t b : outward[a])
      if (strip_of[a] != strip_of[b]) {
        strips[strip_of[a]].neighbours.push_back(strip_of[b]);
        strips[strip_of[b]].neighbours.push_back(strip_of[a]);
      }
  return strips;
}

}  // namespace oxturn
