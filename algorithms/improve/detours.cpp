#include "algorithms/improve/detours.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "algorithms/improve/strokes.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostTried = 12;  // segments of the path from which a detour is tried
constexpr int kHalvings = 30;

/// A detour and what it covers.
struct Offer {
  Detour detour;
  std::size_t piece;
  bool whole;   // it covers all of the piece
  double area;  // square metres
};

bool covers(const Point& at, const Polygon& piece, double reach) {
  return std::ranges::all_of(piece.outer, [&](const Point& p) { return distance(p, at) <= reach; });
}

std::optional<Detour> stop(const NearbySegments& path, const Polygon& piece, double reach, const EdgeIndex& walls) {
  const Point centre = bounding_box(piece.outer).centre();
  if (!covers(centre, piece, reach)) return std::nullopt;
  for (const NearbySegments::Near& near : path.near(centre, 2 * reach, kMostTried)) {
    double outside = 0, inside = 1;  // the positions that cover the piece are an interval of the line to its centre
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (outside + inside) / 2;
      (covers(lerp(near.at, centre, middle), piece, reach) ? inside : outside) = middle;
    }
    const Point at = lerp(near.at, centre, inside);
    if (walls.contains(near.at) && walls.contains(near.at, at))
      return Detour{near.segment, path.along(near), {near.at, at, near.at}, 2 * distance(near.at, at)};
  }
  return std::nullopt;
}

/// Which of the offers cover `enough` on a short length: the best ones for their length, and for the rest the shortest
/// one that covers it, wherever that is the best of all ends.
std::vector<Detour> best_of(std::vector<Offer> offers, std::size_t pieces, double enough) {
  std::ranges::stable_sort(offers, std::greater<>(),
                           [](const Offer& o) { return o.area / std::max(o.detour.length, 1e-12); });
  std::vector<double> largest(offers.size() + 1, 0);  // of this offer and those after it
  for (std::size_t i = offers.size(); i-- > 0;) largest[i] = std::max(largest[i + 1], offers[i].area);
  std::vector<double> left(pieces, std::numeric_limits<double>::infinity());  // of a piece, to be covered
  double length = 0, least = std::numeric_limits<double>::infinity();
  std::vector<std::size_t> taken;
  std::size_t kept = 0, last = offers.size();  // of the best end: how many of those taken, and one more
  const auto gain = [&](const Offer& o) { return std::min(o.area, left[o.piece]); };
  for (std::size_t i = 0; i < offers.size() && enough > 0 && length < least; ++i) {
    for (std::size_t k = i; k < offers.size() && largest[k] >= enough; ++k)
      if (gain(offers[k]) >= enough && length + offers[k].detour.length < least) {
        least = length + offers[k].detour.length;
        kept = taken.size();
        last = k;
      }
    const Offer& o = offers[i];
    const double area = gain(o);
    if (area <= 0) continue;
    enough -= area;
    length += o.detour.length;
    left[o.piece] = o.whole ? 0 : left[o.piece];
    taken.push_back(i);
  }
  if (last == offers.size()) kept = taken.size();  // all that there are do not suffice
  std::vector<Detour> chosen;
  for (std::size_t k = 0; k < kept; ++k) chosen.push_back(std::move(offers[taken[k]].detour));
  if (last < offers.size()) chosen.push_back(std::move(offers[last].detour));
  return chosen;
}

Polyline inserted(const Polyline& path, std::vector<Detour> detours) {
  std::ranges::stable_sort(detours, {}, [](const Detour& d) { return std::tuple(d.segment, d.along); });
  Polyline whole{path.front()};
  auto next = detours.begin();
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    for (; next != detours.end() && next->segment == k; ++next)
      whole.insert(whole.end(), next->points.begin(), next->points.end());
    whole.push_back(path[k + 1]);
  }
  return whole;
}

}  // namespace

Polyline with_detours(const Polyline& path, const std::vector<ToCover>& pieces, double enough, double noticed,
                      double reach, const Connector& connector, const EdgeIndex& walls) {
  const NearbySegments segments(path);
  std::vector<Offer> offers;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& [whole, parts] = pieces[i];
    for (const Polygon& part : parts)
      if (auto found = stop(segments, part, reach, walls))
        offers.push_back({std::move(*found), i, parts.size() == 1, area(part)});
    if (area(whole) < noticed) continue;
    if (auto found = stroke(segments, whole.outer, reach, connector, walls))
      offers.push_back({std::move(*found), i, true, area(whole)});
  }
  return inserted(path, best_of(std::move(offers), pieces.size(), enough));
}

}  // namespace oxturn
