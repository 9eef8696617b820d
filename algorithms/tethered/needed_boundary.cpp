// Decisions  1. Where the cut is driven, the passes on its two sides lie w/2 off it, side by side; nearer than 0.7 w to
//               walls they close up to the cut, so that no part is cut off.
//            2. Where the string meets the cut at an angle a, two laps w apart that end there leave nothing farther
//               than w / (2 cos a) from them: at most 1.11 w / 2.
//            3. Pockets between the two passes and a wall, farther than w/2 from both, are driven round as well.
#include "algorithms/tethered/needed_boundary.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/overlay/boolean.hpp"
#include "geometry/uniform_grid.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/raster.hpp"
#include "geometry/overlay/cut_along.hpp"

namespace oxturn {
namespace {

constexpr double kShallow = 25 * kPi / 180;

/// The cut in short pieces, sorted by what becomes of them.
struct Pieces {
  std::vector<Polyline> wide, thin, shallow;
};

/// Half the angle between the two strings that meet at the middle of a piece of the cut.
double half_angle(const GeodesicField& field, const Point& a, const Point& b, double beside) {
  const Point middle = lerp(a, b, 0.5), aside = perpendicular(b - a).normalized() * beside;
  const Point one = middle - field.sight(middle + aside).from, other = middle - field.sight(middle - aside).from;
  const double c = one.dot(other) / (one.norm() * other.norm());
  return std::isfinite(c) ? std::acos(std::clamp(c, -1.0, 1.0)) / 2 : kPi / 2;
}

Pieces pieces_of(const TetherSpace& leash, bool open) {
  const double w = leash.problem().robot().tool_width;
  const EdgeIndex& walls = leash.problem().walls();
  Pieces pieces;
  // Pieces of one kind that follow each other on one segment are one: fewer strips to unite.
  const auto add = [](std::vector<Polyline>& list, bool goes_on, const Point& a, const Point& b) {
    if (goes_on && !list.empty() && list.back()[1] == a)
      list.back()[1] = b;
    else
      list.push_back({a, b});
  };
  for (const Polyline& line : leash.cut())
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double n = std::max(1.0, std::ceil(distance(line[i - 1], line[i]) / (w / 4)));
      for (double k = 0; k < n; ++k) {
        const Point a = lerp(line[i - 1], line[i], k / n), b = lerp(line[i - 1], line[i], (k + 1) / n);
        if (a == b || (!walls.contains(a) && !walls.contains(b))) continue;
        if (open && half_angle(leash.field(), a, b, 2 * leash.cut_width()) < kShallow)
          add(pieces.shallow, k > 0, a, b);
        else if (walls.contains(a) && walls.contains(b) && !walls.nearest(a, b, 0.7 * w))
          add(pieces.wide, k > 0, a, b);
        else
          add(pieces.thin, k > 0, a, b);
      }
    }
  return pieces;
}

/// Squares of side `cell` that hold all places within `reach` of the segments.
Region about(const std::vector<Polyline>& segments, double reach, double cell) {
  Box box;
  for (const Polyline& segment : segments)
    for (const Point& p : segment) box.add(p);
  box.grow(reach + cell);
  const Point size = box.size() / cell;
  BitGrid grid(box.low, cell, static_cast<int>(std::ceil(size.x())), static_cast<int>(std::ceil(size.y())));
  const int around = static_cast<int>(std::ceil(reach / cell + 0.5));  // places are looked at half a cell apart
  for (const Polyline& segment : segments) {
    const double n = std::max(1.0, std::ceil(distance(segment[0], segment[1]) / cell));
    for (double k = 0; k <= n; ++k) {
      const Point at = (lerp(segment[0], segment[1], k / n) - grid.origin) / cell;
      const int i = static_cast<int>(at.x()), j = static_cast<int>(at.y());
      for (int y = std::max(0, j - around); y <= std::min(grid.rows - 1, j + around); ++y)
        for (int x = std::max(0, i - around); x <= std::min(grid.columns - 1, i + around); ++x) grid.set(x, y, true);
    }
  }
  return trace(grid);
}

/// Segments in a grid, for "is this place on one of them?".
class Nearby {
 public:
  explicit Nearby(const std::vector<Polyline>& pieces) : pieces_(pieces) {
    Box box;
    double total = 0;
    for (const Polyline& p : pieces) {
      total += distance(p[0], p[1]);
      for (const Point& q : p) box.add(q);
    }
    grid_ = UniformGrid(box, pieces.size(), total);
    grid_.fill(pieces.size(), [&](std::size_t i, auto enter) { grid_.visit(pieces_[i].data(), 2, 0, enter); });
  }
  bool on(const Point& a, const Point& b, double within, bool middle_only) const {
    const Point ends[2] = {a, b};
    return grid_.visit(ends, 2, within, [&](std::size_t cell) {
      const auto items = grid_.items(cell);
      return std::any_of(items.begin(), items.end(), [&](std::uint32_t i) {
        const Polyline& piece = pieces_[i];
        if (distance_to_segment(lerp(a, b, 0.5), piece[0], piece[1]) <= within) return true;
        return !middle_only &&
               (distance_to_segment(piece[0], a, b) <= within || distance_to_segment(piece[1], a, b) <= within);
      });
    });
  }

 private:
  const std::vector<Polyline>& pieces_;
  UniformGrid grid_;
};

/// Cuts what lies along shallow pieces out of a ring: chains, or the whole ring if nothing does.
void sort_out(const Ring& ring, const Nearby& shallow, double within, double step, NeededBoundary& rims) {
  Polyline places{ring.front()};
  std::vector<bool> needed;  // of the stretch up to places[i + 1]
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double n = shallow.on(a, b, within, false) ? std::max(1.0, std::ceil(distance(a, b) / step)) : 1.0;
    for (double k = 0; k < n; ++k) {
      const Point c = lerp(a, b, (k + 1) / n);
      needed.push_back(!shallow.on(places.back(), c, within, true));
      places.push_back(c);
    }
  }
  const std::size_t n = needed.size();
  const auto gap = std::find(needed.begin(), needed.end(), false);
  if (gap == needed.end()) {
    rims.rings.polygons.push_back({ring, {}});
    return;
  }
  const auto first = static_cast<std::size_t>(gap - needed.begin());
  Polyline chain;
  for (std::size_t k = 1; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    if (needed[i]) {
      if (chain.empty()) chain.push_back(places[i]);
      chain.push_back(places[i + 1]);
    } else if (!chain.empty()) {
      if (length(chain) > step / 100) rims.chains.push_back(chain);
      chain.clear();
    }
  }
}

/// A stretch parted at the turning points of the distance from the anchor.
void part_at_turns(const Polyline& line, const GeodesicField& field, double least, std::vector<Polyline>& chains) {
  std::vector<std::size_t> turns{0};
  std::size_t high = 0, low = 0;
  int heading = 0;  // outwards or inwards, once known
  std::vector<double> away;
  for (const Point& p : line) away.push_back(field.distance(p));
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (away[i] > away[high]) high = i;
    if (away[i] < away[low]) low = i;
    const bool back = heading >= 0 && away[high] - away[i] > least, out = heading <= 0 && away[i] - away[low] > least;
    if (!back && !out) continue;
    const std::size_t turn = back ? high : low;
    if (heading != 0) turns.push_back(turn);
    heading = back ? -1 : 1;
    high = low = i;
    for (std::size_t k = turn; k <= i; ++k) {
      if (away[k] > away[high]) high = k;
      if (away[k] < away[low]) low = k;
    }
  }
  turns.push_back(line.size() - 1);
  for (std::size_t k = 1; k < turns.size(); ++k)
    if (turns[k] > turns[k - 1])
      chains.emplace_back(line.begin() + static_cast<std::ptrdiff_t>(turns[k - 1]),
                          line.begin() + static_cast<std::ptrdiff_t>(turns[k]) + 1);
}

/// The ring as a line that begins and ends where it is nearest to the anchor, with places at most `step` apart.
Polyline opened(const Ring& ring, const GeodesicField& field, double step) {
  Polyline line;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    const double n = std::max(1.0, std::ceil(distance(a, b) / step));
    for (double k = 0; k < n; ++k) line.push_back(lerp(a, b, k / n));
  }
  std::size_t nearest = 0;
  double least = field.distance(line[0]);
  for (std::size_t i = 1; i < line.size(); ++i)
    if (const double d = field.distance(line[i]); d < least) {
      least = d;
      nearest = i;
    }
  std::rotate(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(nearest), line.end());
  line.push_back(line.front());
  return line;
}

}  // namespace

NeededBoundary needed_boundary(const TetherSpace& leash, bool open) {
  const double w = leash.problem().robot().tool_width, width = leash.cut_width();
  NeededBoundary rims;
  for (const TetherSpace::Component& part : leash.components())
    rims.space.polygons.push_back(part.problem.configuration_space().polygons.front());
  const Pieces pieces = pieces_of(leash, open);
  const double passes = 0.98 * w;
  const Region rimmed = pieces.wide.empty() ? rims.space : cut_along(rims.space, pieces.wide, passes);
  if (pieces.shallow.empty()) {
    rims.inner = rimmed;
  } else {
    rims.inner = leash.problem().configuration_space();
    if (!pieces.thin.empty()) rims.inner = cut_along(rims.inner, pieces.thin, width);
    if (!pieces.wide.empty()) rims.inner = cut_along(rims.inner, pieces.wide, passes);
  }
  const Nearby shallow(pieces.shallow);
  for_each_ring(rimmed, [&](const Ring& ring) { sort_out(ring, shallow, 2 * width, w / 4, rims); });
  if (open) {
    NeededBoundary parted = std::move(rims);
    rims = {std::move(parted.space), std::move(parted.inner), {}, {}};
    for (Polygon& ring : parted.rings.polygons) {
      Polyline line = opened(ring.outer, leash.field(), w);
      if (length(line) > 30 * w)
        part_at_turns(line, leash.field(), 3 * w, rims.chains);
      else
        rims.rings.polygons.push_back(std::move(ring));
    }
    for (const Polyline& chain : parted.chains) part_at_turns(chain, leash.field(), 3 * w, rims.chains);
  }
  if (!pieces.wide.empty()) {
    // What lies farther off than this is nobody's pocket.
    const Region near = intersect(rims.space, about(pieces.wide, 1.2 * w, w / 2));
    const Region pockets = subtract(near, dilate(cut_along(near, pieces.wide, passes), w / 2, w / 200, Bound::inside));
    for_each_ring(pockets, [&](const Ring& ring) { rims.rings.polygons.push_back({ring, {}}); });
  }
  return rims;
}

}  // namespace oxturn
