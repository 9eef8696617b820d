#include "algorithms/polygon/island_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "algorithms/polygon/wave_tree.hpp"
#include "base/math.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/mesh/medial_axis.hpp"
#include "geometry/mesh/shortest_bridges.hpp"
#include "geometry/overlay/cut_along.hpp"

namespace oxturn {
namespace {

// Of the source.
constexpr double kPartCost = 0.8;
constexpr double kAngleCost = 0.5;

constexpr std::size_t kMostTried = 8;    // candidates for one cut
constexpr double kLeastShare = 0.02;     // of a part's boundary, on either side of a cut
constexpr double kLeastAngle = kPi / 9;  // smaller ones count as this

/// A polygon without holes and how uneven its spiral is.
struct Part {
  Polygon polygon;
  double variation = 1;
};

/// A line that divides a part, and how evenly.
struct Candidate {
  Polyline line;
  double share = 0;  // of the part's boundary, on the side that has less
};

class Decomposition {
 public:
  Decomposition(const Region& region, const IslandCuts& options) : options_(options) {
    RingBridges bridges = bridges_between_rings(region);
    cuts_ = std::move(bridges.tree);
    lines_ = std::move(bridges.all);
    for (Polygon& polygon : cut_along(region, cuts_, options.cut).polygons)
      parts_.push_back(measured(std::move(polygon)));
  }

  Region run(const Context& context) {
    std::vector<Part> best = parts_;
    double least = cost();
    // A single cut seldom lessens the greatest variation. So all that may pay are made, and the best number is kept.
    while (!context.cancelled() && kPartCost * static_cast<double>(dividing_ + 1) + 1 < least && cut_worst())
      if (const double now = cost(); now < least) {
        least = now;
        best = parts_;
      }
    Region all;
    for (Part& part : best) all.polygons.push_back(std::move(part.polygon));
    return all;
  }

 private:
  Part measured(Polygon polygon) const {
    double most = 1;
    for (WaveTree& tree : wave_trees(medial_axis({{polygon}}, options_.chord))) {
      tree.root_at_centre();
      most = std::max(most, tree.step_variation(options_.start_height * tree.greatest_clearance()));
    }
    return {std::move(polygon), most};
  }

  /// What is to be least, but for the parts there were at the beginning.
  double cost() const {
    double most = 1;
    for (const Part& part : parts_) most = std::max(most, part.variation);
    const auto k = static_cast<double>(dividing_);
    return dividing_ == 0 ? most : most + kPartCost * k + kAngleCost / k * angles_;
  }

  /// |pi / b - 1| of a cut: at each of its ends the best continuation counts.
  double angle_cost(const Polyline& line) const {
    double most = 0;
    for (const bool back : {false, true}) {
      const Point out = back ? Point(line[1] - line[0]) : Point(line[0] - line[1]);
      const Point end = back ? line[1] : line[0];
      double best = 0;
      for (const Polyline& cut : cuts_)
        for (const bool other : {false, true}) {
          const Point begin = other ? cut[1] : cut[0];
          if (distance(begin, end) > distance(line[0], line[1]) + distance(cut[0], cut[1])) continue;
          const Point on = other ? Point(cut[0] - cut[1]) : Point(cut[1] - cut[0]);
          best = std::max(best, kPi - std::abs(math::atan2(cross(out, on), out.dot(on))));
        }
      if (best > 0) most = std::max(most, std::abs(kPi / std::max(best, kLeastAngle) - 1));
    }
    return most;
  }

  /// Cuts the part with the greatest variation where the halves and the angles are best. False if it cannot be cut.
  bool cut_worst() {
    const auto worst = std::ranges::max_element(parts_, {}, &Part::variation);
    if (worst == parts_.end()) return false;
    double least = std::numeric_limits<double>::infinity();
    std::optional<std::pair<Part, Part>> best;
    Polyline best_line;
    for (const Candidate& candidate : candidates_in(worst->polygon)) {
      Region halves = cut_along({{worst->polygon}}, {candidate.line}, options_.cut);
      if (halves.polygons.size() != 2) continue;
      std::pair<Part, Part> two{measured(halves.polygons[0]), measured(halves.polygons[1])};
      const double now = std::max(two.first.variation, two.second.variation) + kAngleCost * angle_cost(candidate.line);
      if (now >= least) continue;
      least = now;
      best = std::move(two);
      best_line = candidate.line;
    }
    if (!best) return false;
    angles_ += angle_cost(best_line);
    cuts_.push_back(std::move(best_line));
    ++dividing_;
    *worst = std::move(best->first);
    parts_.push_back(std::move(best->second));
    return true;
  }

  /// Those that divide the boundary most evenly.
  std::vector<Candidate> candidates_in(const Polygon& polygon) const {
    std::vector<Candidate> found;
    const EdgeIndex inside(Region{{polygon}});
    const Ring& ring = polygon.outer;
    std::vector<double> along{0};
    for (std::size_t i = 0; i < ring.size(); ++i)
      along.push_back(along.back() + distance(ring[i], ring[(i + 1) % ring.size()]));
    for (const Polyline& line : lines_) {
      if (!inside.contains((line[0] + line[1]) / 2) || std::ranges::find(cuts_, line) != cuts_.end()) continue;
      const double apart = std::abs(position(ring, along, line[0]) - position(ring, along, line[1])) / along.back();
      if (const double share = std::min(apart, 1 - apart); share >= kLeastShare) found.push_back({line, share});
    }
    std::ranges::stable_sort(found, std::greater<>{}, &Candidate::share);
    if (found.size() > kMostTried) found.resize(kMostTried);
    return found;
  }

  /// Metres along the ring to the point of it that is nearest to p.
  static double position(const Ring& ring, const std::vector<double>& along, const Point& p) {
    double least = std::numeric_limits<double>::infinity(), at = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point q = nearest_on_segment(p, ring[i], ring[(i + 1) % ring.size()]);
      if (const double d = distance(p, q); d < least) least = d, at = along[i] + distance(ring[i], q);
    }
    return at;
  }

  IslandCuts options_;
  std::vector<Polyline> cuts_;   // bridges, then those that divide parts
  std::vector<Polyline> lines_;  // candidates
  std::vector<Part> parts_;
  double angles_ = 0;         // of the cuts that divide parts
  std::size_t dividing_ = 0;  // their number
};

}  // namespace

Region bridged(const Region& region, double cut) { return cut_along(region, shortest_bridges(region), cut); }

Region decomposed(const Region& region, const IslandCuts& options, const Context& context) {
  if (region.empty()) return {};
  return Decomposition(region, options).run(context);
}

}  // namespace oxturn
