// Decisions  1. Where the cut is driven, the two passes along its sides lie w/2 from it, side by side. Nearer than 0.7
//               w to walls they approach the cut, so that nothing is disconnected.
//            2. Where the tether meets the cut at an angle a, two level sets w apart that end there leave no point
//               farther than w / (2 cos a) from them: at most 1.11 w / 2 for a up to 25 degrees.
//            3. Pockets between the two passes and a wall, farther than w/2 from both, are covered by detours.
#include "algorithms/tethered/needed_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {
namespace {

constexpr double kShallow = 25 * kPi / 180;  // half the angle between the two tethers that meet at the cut
// In tool widths.
constexpr double kWideFrom = 0.7;        // distance of the cut from walls above which both passes fit beside it
constexpr double kPassesWidth = 0.98;    // distance between the two passes
constexpr double kPocketReach = 1.2;     // distance from the cut within which there are pockets
constexpr double kPocketCell = 0.5;      // side of the squares that enclose pockets
constexpr double kLongRing = 30;         // longer rings are opened and split at turning points
constexpr double kLeastTurn = 3;         // changes of the distance from the anchor by less are no turning points
constexpr double kPiecesPerWidth = 4;    // pieces of the cut per tool width
constexpr double kChordsPerWidth = 200;  // tool widths over the chord error of dilation
constexpr double kShortestChain = 100;   // pieces over the length of chains that are dropped

/// The cut in pieces.
struct CutPieces {
  std::vector<Polyline> wide;     // far from walls: the passes lie side by side
  std::vector<Polyline> narrow;   // near walls
  std::vector<Polyline> shallow;  // nearly along the tether: not driven; of two points each
};

/// Half the angle between the two tethers that meet at the middle of a piece ab of the cut.
double half_angle(const GeodesicField& field, const Point& a, const Point& b, double beside) {
  const Point middle = lerp(a, b, 0.5), aside = perpendicular(b - a).normalized() * beside;
  const Point one = middle - field.sight(middle + aside).from, other = middle - field.sight(middle - aside).from;
  const double c = one.dot(other) / (one.norm() * other.norm());
  return std::isfinite(c) ? math::acos(std::clamp(c, -1.0, 1.0)) / 2 : kPi / 2;
}

/// Pieces of one kind that follow each other are joined, on one segment to one piece.
void append_piece(std::vector<Polyline>& pieces, bool same_segment, const Point& a, const Point& b) {
  if (pieces.empty() || pieces.back().back() != a)
    pieces.push_back({a, b});
  else if (same_segment)
    pieces.back().back() = b;
  else
    pieces.back().push_back(b);
}

CutPieces pieces_of_cut(const TetherSpace& space, CutEdges edges) {
  const double w = space.problem().robot().tool_width;
  const EdgeIndex& walls = space.problem().walls();
  CutPieces pieces;
  for (const Polyline& line : space.cut())
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double n = std::max(1.0, std::ceil(distance(line[i - 1], line[i]) / (w / kPiecesPerWidth)));
      for (double k = 0; k < n; ++k) {
        const Point a = lerp(line[i - 1], line[i], k / n);
        const Point b = k + 1 < n ? lerp(line[i - 1], line[i], (k + 1) / n) : line[i];
        if (a == b || (!walls.contains(a) && !walls.contains(b))) continue;
        if (edges == CutEdges::across_tether && half_angle(space.field(), a, b, 2 * space.cut_width()) < kShallow)
          pieces.shallow.push_back({a, b});
        else if (walls.contains(a) && walls.contains(b) && !walls.nearest(a, b, kWideFrom * w))
          append_piece(pieces.wide, k > 0, a, b);
        else
          append_piece(pieces.narrow, k > 0, a, b);
      }
    }
  return pieces;
}

/// Segments in a grid, to find those near another segment.
class SegmentIndex {
 public:
  explicit SegmentIndex(const std::vector<Polyline>& segments)
      : segments_(segments), grid_(segments.size(), [&](std::size_t i) -> const Polyline& { return segments[i]; }) {}
  /// Is the middle of ab within `reach` of a segment?
  bool near_middle(const Point& a, const Point& b, double reach) const {
    const Point middle = lerp(a, b, 0.5);
    return any_near(a, b, reach, [&](const Polyline& s) { return distance_to_segment(middle, s[0], s[1]) <= reach; });
  }
  /// Is the middle of ab within `reach` of a segment, or an end of a segment within `reach` of ab?
  bool near(const Point& a, const Point& b, double reach) const {
    const Point middle = lerp(a, b, 0.5);
    return any_near(a, b, reach, [&](const Polyline& s) {
      return distance_to_segment(middle, s[0], s[1]) <= reach || distance_to_segment(s[0], a, b) <= reach ||
             distance_to_segment(s[1], a, b) <= reach;
    });
  }

 private:
  template <class Test>
  bool any_near(const Point& a, const Point& b, double reach, Test test) const {
    return grid_.visit_items(std::array{a, b}, reach, [&](std::uint32_t i) { return test(segments_[i]); });
  }
  const std::vector<Polyline>& segments_;
  UniformGrid grid_;
};

/// Adds what must be driven of a ring: the whole ring, or the chains between the parts along shallow pieces of the cut.
void add_needed(const Ring& ring, const SegmentIndex& shallow, double reach, double step, NeededBoundary& boundary) {
  Polyline points{ring.front()};
  std::vector<bool> needed;  // of the segment that ends at points[i + 1]
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double n = shallow.near(a, b, reach) ? std::max(1.0, std::ceil(distance(a, b) / step)) : 1.0;
    for (double k = 0; k < n; ++k) {
      const Point c = lerp(a, b, (k + 1) / n);
      needed.push_back(!shallow.near_middle(points.back(), c, reach));
      points.push_back(c);
    }
  }
  const auto gap = std::find(needed.begin(), needed.end(), false);
  if (gap == needed.end()) {
    boundary.rings.polygons.push_back({ring, {}});
    return;
  }
  const auto first = static_cast<std::size_t>(gap - needed.begin());
  Polyline chain;
  for (std::size_t k = 1; k <= needed.size(); ++k) {
    const std::size_t i = (first + k) % needed.size();
    if (needed[i]) {
      if (chain.empty()) chain.push_back(points[i]);
      chain.push_back(points[i + 1]);
    } else if (!chain.empty()) {
      if (length(chain) > step / kShortestChain) boundary.chains.push_back(chain);
      chain.clear();
    }
  }
}

/// Appends the parts of a chain between the turning points of the distance from the anchor. Changes of the distance by
/// less than `least` are no turning points.
void split_at_turns(const Polyline& chain, const GeodesicField& field, double least, std::vector<Polyline>& parts) {
  enum class Trend { unknown, outwards, inwards };
  std::vector<double> away;
  for (const Point& p : chain) away.push_back(field.distance(p));
  Trend trend = Trend::unknown;
  std::vector<std::size_t> turns{0};
  std::size_t high = 0, low = 0;  // farthest and nearest point since the last turn
  const auto note = [&](std::size_t i) {
    if (away[i] > away[high]) high = i;
    if (away[i] < away[low]) low = i;
  };
  for (std::size_t i = 1; i < chain.size(); ++i) {
    note(i);
    const bool back = trend != Trend::inwards && away[high] - away[i] > least;
    const bool out = trend != Trend::outwards && away[i] - away[low] > least;
    if (!back && !out) continue;
    const std::size_t turn = back ? high : low;
    if (trend != Trend::unknown) turns.push_back(turn);
    trend = back ? Trend::inwards : Trend::outwards;
    high = low = i;
    for (std::size_t k = turn; k <= i; ++k) note(k);
  }
  turns.push_back(chain.size() - 1);
  for (std::size_t k = 1; k < turns.size(); ++k)
    if (turns[k] > turns[k - 1])
      parts.emplace_back(chain.begin() + static_cast<std::ptrdiff_t>(turns[k - 1]),
                         chain.begin() + static_cast<std::ptrdiff_t>(turns[k]) + 1);
}

/// The ring as a chain that begins and ends at its point nearest to the anchor, points at most `step` apart.
Polyline opened(const Ring& ring, const GeodesicField& field, double step) {
  Polyline chain;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double n = std::max(1.0, std::ceil(distance(a, b) / step));
    for (double k = 0; k < n; ++k) chain.push_back(lerp(a, b, k / n));
  }
  std::size_t nearest = 0;
  double least = field.distance(chain[0]);
  for (std::size_t i = 1; i < chain.size(); ++i)
    if (const double d = field.distance(chain[i]); d < least) {
      least = d;
      nearest = i;
    }
  std::rotate(chain.begin(), chain.begin() + static_cast<std::ptrdiff_t>(nearest), chain.end());
  chain.push_back(chain.front());
  return chain;
}

/// Opens long rings, and splits chains at the turning points of the distance from the anchor: parts that lead one way
/// fit better into a tour.
void split_long(NeededBoundary& boundary, const GeodesicField& field, double w) {
  std::vector<Polygon> rings = std::move(boundary.rings.polygons);
  const std::vector<Polyline> chains = std::move(boundary.chains);
  boundary.rings.polygons.clear();
  boundary.chains.clear();
  for (Polygon& ring : rings) {
    const Polyline chain = opened(ring.outer, field, w);
    if (length(chain) > kLongRing * w)
      split_at_turns(chain, field, kLeastTurn * w, boundary.chains);
    else
      boundary.rings.polygons.push_back(std::move(ring));
  }
  for (const Polyline& chain : chains) split_at_turns(chain, field, kLeastTurn * w, boundary.chains);
}

/// What lies farther than w/2 from both passes along wide pieces of the cut and from walls (Decision 3).
Region pockets_beside(const std::vector<Polyline>& wide, const Region& space, double w) {
  const Region near = intersect(space, squares_around(wide, kPocketReach * w, w * kPocketCell));
  return subtract(near, dilate(cut_along(near, wide, kPassesWidth * w), w / 2, w / kChordsPerWidth, Bound::inside));
}

}  // namespace

NeededBoundary needed_boundary(const TetherSpace& space, CutEdges edges) {
  const double w = space.problem().robot().tool_width, cut_width = space.cut_width();
  NeededBoundary boundary;
  for (const TetherSpace::Component& component : space.components())
    boundary.space.polygons.push_back(component.problem.configuration_space().polygons.front());
  const CutPieces pieces = pieces_of_cut(space, edges);
  const Region with_passes =
      pieces.wide.empty() ? boundary.space : cut_along(boundary.space, pieces.wide, kPassesWidth * w);
  if (pieces.shallow.empty()) {
    boundary.inner = with_passes;
  } else {  // without the cut where it is shallow
    boundary.inner = space.problem().configuration_space();
    if (!pieces.narrow.empty()) boundary.inner = cut_along(boundary.inner, pieces.narrow, cut_width);
    if (!pieces.wide.empty()) boundary.inner = cut_along(boundary.inner, pieces.wide, kPassesWidth * w);
  }
  const SegmentIndex shallow(pieces.shallow);
  for_each_ring(with_passes,
                [&](const Ring& ring) { add_needed(ring, shallow, 2 * cut_width, w / kPiecesPerWidth, boundary); });
  if (edges == CutEdges::across_tether) split_long(boundary, space.field(), w);
  if (!pieces.wide.empty()) boundary.pockets = pockets_beside(pieces.wide, boundary.space, w);
  return boundary;
}

}  // namespace oxturn
