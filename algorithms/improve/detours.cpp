#include "algorithms/improve/detours.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "algorithms/improve/strokes.hpp"
#include "algorithms/lanes/stops.hpp"

namespace oxturn {
namespace {

/// A detour and what it covers.
struct Offer {
  Detour detour;
  std::size_t piece;
  bool whole;   // it covers all of the piece
  double area;  // square metres
};

Detour detour(const Stop& stop, double length) {
  return {stop.segment, stop.along, {stop.from, stop.at, stop.from}, length, stop.turn, stop.cut};
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

/// Only one detour cuts off a turn, and only where no other one leaves the path.
void keep_apart(const Polyline& path, std::vector<Detour>& detours) {
  std::vector<int> at_turn(path.size(), 0);
  std::vector<double> first(path.size(), std::numeric_limits<double>::infinity()), last(path.size(), 0);
  for (const Detour& d : detours) {
    if (d.turn) ++at_turn[*d.turn];
    if (d.turn) continue;
    first[d.segment] = std::min(first[d.segment], d.along);
    last[d.segment] = std::max(last[d.segment], d.along);
  }
  for (Detour& d : detours) {
    if (!d.turn) continue;
    const std::size_t v = *d.turn;
    if (at_turn[v] > 1 || first[v] < d.cut || last[v - 1] > distance(path[v - 1], path[v]) - d.cut) d.turn.reset();
  }
}

WithDetours inserted(const Polyline& path, std::vector<Detour> detours) {
  keep_apart(path, detours);
  std::ranges::stable_sort(detours, {}, [](const Detour& d) { return std::tuple(d.segment, d.along); });
  std::vector<const Detour*> at_turn(path.size(), nullptr);
  for (const Detour& d : detours)
    if (d.turn) at_turn[*d.turn] = &d;
  WithDetours result{{path.front()}, {}};
  const auto drive = [&result](Polyline detour) {
    result.path.insert(result.path.end(), detour.begin(), detour.end());
    result.detours.push_back(std::move(detour));
  };
  auto next = detours.begin();
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    for (; next != detours.end() && next->segment == k; ++next)
      if (!next->turn) drive(std::move(next->points));
    if (const Detour* turn = at_turn[k + 1]) {
      const Stop stop{turn->segment, turn->along, turn->points[0], turn->points[1], turn->turn, turn->cut};
      const auto [a, b] = ends_of_cut(stop, path);
      drive({a, stop.at, b});
    } else {
      result.path.push_back(path[k + 1]);
    }
  }
  return result;
}

}  // namespace

WithDetours with_detours(const Polyline& path, const std::vector<ToCover>& pieces, double enough, double noticed,
                         double reach, const Connector& connector, const EdgeIndex& walls) {
  const std::vector<bool> tool(path.size(), true);
  const StopFinder stops(path, tool, reach, walls);
  std::vector<Offer> offers;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& [whole, parts] = pieces[i];
    for (const Polygon& part : parts)
      if (const auto found = stops.find(part))
        offers.push_back({detour(*found, stops.length(*found)), i, parts.size() == 1, area(part)});
    if (area(whole) < noticed) continue;
    if (auto found = stroke(stops.segments(), whole.outer, reach, connector, walls))
      offers.push_back({std::move(*found), i, true, area(whole)});
  }
  return inserted(path, best_of(std::move(offers), pieces.size(), enough));
}

}  // namespace oxturn
