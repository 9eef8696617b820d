// Decisions  1. A point y of a level set is useful if the geodesic through it contains a point, within spacing / 2 of
//               y, that is farther than spacing / 2 from the boundary of `inner`. Most points are tested at five points
//               of the geodesic, with a margin of a fifth of the spacing, which is more than can lie between them. The
//               ends of a piece are found with 17 points and a margin of kLevelSetTrim.
//            2. A piece ends exactly where the region does if that is not trimmed: at the cut.
//            3. Useless parts up to two spacings long are kept where they are free: an interruption costs more.
#include "algorithms/tethered/level_sets.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "base/math.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

// In spacings.
constexpr double kMargin = 0.2;        // of the test for usefulness
constexpr double kLongestUseless = 2;  // parts kept between useful ones
constexpr double kSampling = 1.0 / 8;  // largest distance between samples
constexpr double kFarthestSeen = 4;    // depths beyond this are not distinguished
constexpr int kFineSteps = 8;          // points of the geodesic on either side, at the ends of a piece
constexpr int kBisections = 6;         // to find where a piece ends
constexpr int kFreeBisections = 12;    // to find where the region ends
constexpr int kMostBends = 1000;       // of a geodesic, against endless loops

/// Trims level sets to what is useful.
class Trimmer {
 public:
  Trimmer(const Region& region, const Region& inner, double spacing, double chord)
      : region_(region), inner_(inner), spacing_(spacing), chord_(chord) {}

  /// Appends the useful pieces of a chain of arcs.
  void trim(const std::vector<GeodesicField::Arc>& chain, std::size_t level, std::vector<LevelSet>& sets) {
    samples_.clear();
    for (const GeodesicField::Arc& arc : chain) sample(arc);
    std::size_t begin = 0;
    while (begin < samples_.size()) {
      if (!samples_[begin].useful) {
        ++begin;
        continue;
      }
      const std::size_t last = last_of_piece(begin);
      add_piece(begin, last, level, sets);
      begin = last + 1;
    }
  }

 private:
  struct Sample {
    Point at, outward;  // outward: unit vector away from the tether
    double radius;      // of the arc, metres
    bool free, useful;
  };

  void sample(const GeodesicField::Arc& arc) {
    // A step of angle a has the chord error radius (1 - cos(a / 2)).
    const double by_chord = 2 * math::acos(std::clamp(1 - chord_ / arc.radius, -1.0, 1.0));
    const double step = std::min({by_chord, spacing_ * kSampling / arc.radius, kPi / 4});
    const auto n =
        std::max<std::size_t>(static_cast<std::size_t>(std::ceil((arc.end - arc.begin) / step * (1 - 1e-9))), 1);
    double known = 0;  // metres from the sample last tested within which all are useful
    for (std::size_t i = 0; i <= n; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(n);
      const double angle = arc.begin + share * (arc.end - arc.begin);
      const Point p = arc.at(angle);
      if (!samples_.empty()) {
        const double moved = distance(samples_.back().at, p);
        if (moved <= 1e-12 * arc.radius) continue;
        known -= moved;
      }
      const Point outward(math::cos(angle), math::sin(angle));
      if (known > 0) {
        samples_.push_back({p, outward, arc.radius, true, true});
        continue;
      }
      const double depth = depth_of(p);
      if (depth > (0.5 + kMargin) * spacing_) known = depth - (0.5 - kMargin) * spacing_;
      samples_.push_back({p, outward, arc.radius, region_.contains(p), useful(p, outward, arc.radius, depth)});
    }
  }

  /// Distance to the boundary of `inner`, 0 outside of it.
  double depth_of(const Point& p) const {
    if (!inner_.contains(p)) return 0;
    const auto hit = inner_.nearest(p, kFarthestSeen * spacing_);
    return hit ? hit->distance : kFarthestSeen * spacing_;
  }
  bool useful(const Point& p, const Point& outward, double radius, double depth) const {
    const double enough = (0.5 - kMargin) * spacing_;
    if (depth > enough) return region_.contains(p);
    if (!region_.contains(p)) return false;
    for (const double t : {-0.5, -0.25, 0.25, 0.5})
      if (radius + t * spacing_ > 0 && depth_of(p + t * spacing_ * outward) > enough) return true;
    return false;
  }
  /// The same with the fine margin.
  bool needed(const Sample& s) const {
    const double enough = (0.5 - kLevelSetTrim) * spacing_;
    for (int k = -kFineSteps; k <= kFineSteps; ++k) {
      const double t = k * spacing_ / (2 * kFineSteps);
      if (s.radius + t > 0 && depth_of(s.at + t * s.outward) > enough) return true;
    }
    return false;
  }

  /// The last useful sample that can be reached from a useful one along free samples, over short useless parts.
  std::size_t last_of_piece(std::size_t begin) const {
    std::size_t last = begin;
    double useless = 0;
    for (std::size_t i = begin + 1; i < samples_.size(); ++i) {
      if (!samples_[i].free || !region_.contains(samples_[i - 1].at, samples_[i].at)) break;
      useless += distance(samples_[i - 1].at, samples_[i].at);
      if (useless > kLongestUseless * spacing_) break;
      if (!samples_[i].useful) continue;
      last = i;
      useless = 0;
    }
    return last;
  }

  /// Between a sample that is not needed and one that is: where need begins, or a little before.
  Sample threshold(Sample unneeded, Sample needed_one) const {
    for (int k = 0; k < kBisections; ++k) {
      Sample middle = unneeded;
      middle.at = lerp(unneeded.at, needed_one.at, 0.5);
      middle.outward = lerp(unneeded.outward, needed_one.outward, 0.5).normalized();
      (needed(middle) ? needed_one : unneeded) = middle;
    }
    return unneeded;
  }

  /// Between a free point and one outside of the region: the last free one.
  Point last_free(Point free, Point outside) const {
    for (int k = 0; k < kFreeBisections; ++k) {
      const Point middle = lerp(free, outside, 0.5);
      (region_.contains(free, middle) ? free : outside) = middle;
    }
    return free;
  }

  void add_piece(std::size_t first, std::size_t last, std::size_t level, std::vector<LevelSet>& sets) const {
    std::size_t begin = first, end = last;
    while (begin < end && !needed(samples_[begin])) ++begin;
    while (end > begin && !needed(samples_[end])) --end;
    LevelSet set{level, {}, begin > first, end < last};
    const auto goes_on = [&](std::size_t i) { return i < samples_.size() && !samples_[i].free; };  // beyond the region
    if (set.trimmed_begin)
      set.line.push_back(threshold(samples_[begin - 1], samples_[begin]).at);
    else if (begin > 0 && goes_on(begin - 1))
      set.line.push_back(last_free(samples_[begin].at, samples_[begin - 1].at));
    for (std::size_t i = begin; i <= end; ++i) set.line.push_back(samples_[i].at);
    if (set.trimmed_end)
      set.line.push_back(threshold(samples_[end + 1], samples_[end]).at);
    else if (goes_on(end + 1))
      set.line.push_back(last_free(samples_[end].at, samples_[end + 1].at));
    if (set.line.size() < 2 || (begin == end && !needed(samples_[begin]))) return;
    sets.push_back(std::move(set));
  }

  const EdgeIndex region_, inner_;
  double spacing_, chord_;
  std::vector<Sample> samples_;  // of the present chain
};

/// The point `back` metres back along the geodesic to p; nullopt if that is beyond the anchor.
std::optional<Point> towards_anchor(const GeodesicField& field, Point p, double back) {
  for (int bend = 0; bend < kMostBends; ++bend) {
    const GeodesicField::Sight sight = field.sight(p);
    const double straight = distance(sight.from, p);
    if (back <= straight) return straight > 0 ? lerp(p, sight.from, back / straight) : p;
    if (sight.corners == 0 || straight <= 0) return std::nullopt;
    back -= straight;
    p = sight.from;
  }
  return std::nullopt;
}

/// The points of level sets in a grid of cells `side` wide, as a sorted list.
class LevelSetGrid {
 public:
  LevelSetGrid(const std::vector<LevelSet>& sets, double side) : sets_(sets), side_(side) {
    for (std::size_t k = 0; k < sets.size(); ++k)
      for (std::size_t i = 0; i < sets[k].line.size(); ++i) {
        const Point& p = sets[k].line[i];
        items_.push_back({cell(p.x()), cell(p.y()), static_cast<std::uint32_t>(k), static_cast<std::uint32_t>(i)});
      }
    std::sort(items_.begin(), items_.end());
  }
  /// The level set of this level with the point nearest to p, if that is nearer than `side`.
  std::optional<std::size_t> nearest(const Point& p, std::size_t level) const {
    std::optional<std::size_t> best;
    double least = side_;
    for (std::int64_t i = cell(p.x()) - 1; i <= cell(p.x()) + 1; ++i) {
      const std::int64_t j = cell(p.y());
      auto it = std::lower_bound(items_.begin(), items_.end(), Item{i, j - 1, 0, 0});
      for (; it != items_.end() && it->column == i && it->row <= j + 1; ++it) {
        if (sets_[it->set].level != level) continue;
        const double d = distance(sets_[it->set].line[it->point], p);
        if (d < least) {
          least = d;
          best = it->set;
        }
      }
    }
    return best;
  }

 private:
  struct Item {
    std::int64_t column, row;
    std::uint32_t set, point;
    auto operator<=>(const Item&) const = default;
  };
  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / side_)); }
  const std::vector<LevelSet>& sets_;
  double side_;
  std::vector<Item> items_;
};

}  // namespace

std::vector<LevelSet> level_sets(const TetherSpace& space, const Region& region, const Region& inner, double spacing,
                                 double chord) {
  std::vector<LevelSet> all;
  if (inner.empty()) return all;
  Trimmer trimmer(region, inner, spacing, chord);
  const double end = std::min(space.tether_length(), space.field().farthest());
  const auto distance_of = [&](std::size_t level) { return (static_cast<double>(level) + 0.5) * spacing; };
  std::vector<double> lengths;
  for (std::size_t k = 0; distance_of(k) < end; ++k) lengths.push_back(distance_of(k));
  const auto levels = space.field().level_sets(lengths);
  for (std::size_t k = 0; k < levels.size(); ++k)
    for (const auto& chain : levels[k]) trimmer.trim(chain, k, all);
  return all;
}

Outward outward_neighbours(const std::vector<LevelSet>& sets, const GeodesicField& field, double spacing) {
  Outward outward(sets.size());
  const LevelSetGrid grid(sets, spacing / 2);
  for (std::size_t b = 0; b < sets.size(); ++b) {
    if (sets[b].level == 0) continue;
    const Polyline& line = sets[b].line;
    double since = spacing;  // looked up at both ends and every half spacing
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (i > 0) since += distance(line[i - 1], line[i]);
      if (since < spacing / 2 && i + 1 < line.size()) continue;
      since = 0;
      const auto back = towards_anchor(field, line[i], spacing);
      if (!back) continue;
      if (const auto a = grid.nearest(*back, sets[b].level - 1)) outward[*a].push_back(b);
    }
  }
  for (std::vector<std::size_t>& list : outward) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return outward;
}

}  // namespace oxturn
