#include "algorithms/improve/stops.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>

#include "geometry/ring_boxes.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostTried = 12;  // segments of the path from which a detour is tried
constexpr int kHalvings = 30;

struct Stop {
  std::size_t segment;
  double along;  // metres
  Point from, at;
  double area;  // of the piece that it covers
  double detour() const { return 2 * distance(from, at); }
};

bool covers(const Point& at, const Polygon& piece, double reach) {
  return std::ranges::all_of(piece.outer, [&](const Point& p) { return distance(p, at) <= reach; });
}

Box around(const Point& p, double distance) { return {p - Point(distance, distance), p + Point(distance, distance)}; }

BoxIndex index_of_segments(const Polyline& path) {
  std::vector<Box> boxes(path.size() - 1);
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    boxes[k].add(path[k]);
    boxes[k].add(path[k + 1]);
  }
  return BoxIndex(std::move(boxes));
}

std::optional<Stop> shortest_stop(const Polyline& path, const BoxIndex& index, const Polygon& piece, double reach,
                                  const EdgeIndex& walls) {
  const Point centre = bounding_box(piece.outer).centre();
  if (!covers(centre, piece, reach)) return std::nullopt;
  const auto nearest = [&](std::size_t k) { return nearest_on_segment(centre, path[k], path[k + 1]); };
  std::vector<std::pair<double, std::size_t>> segments;
  for (const std::size_t k : index.overlapping(around(centre, 2 * reach)))
    if (const double far = distance(nearest(k), centre); far < 2 * reach) segments.emplace_back(far, k);
  std::ranges::sort(segments);
  segments.resize(std::min(segments.size(), kMostTried));
  for (const auto& [far, k] : segments) {
    const Point from = nearest(k);
    double outside = 0, inside = 1;  // the positions that cover the piece are an interval of the line to its centre
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (outside + inside) / 2;
      (covers(lerp(from, centre, middle), piece, reach) ? inside : outside) = middle;
    }
    const Point at = lerp(from, centre, inside);
    if (walls.contains(from) && walls.contains(from, at))
      return Stop{k, distance(path[k], from), from, at, area(piece)};
  }
  return std::nullopt;
}

/// Those that cover most for their length, until `enough` square metres are covered.
std::vector<Stop> best_of(std::vector<Stop> stops, double enough) {
  std::ranges::stable_sort(stops, std::greater<>(), [](const Stop& s) { return s.area / std::max(s.detour(), 1e-12); });
  const auto last = std::ranges::find_if(stops, [&](const Stop& s) {
    const bool done = enough <= 0;
    enough -= s.area;
    return done;
  });
  stops.erase(last, stops.end());
  return stops;
}

}  // namespace

Polyline with_stops(const Polyline& path, const std::vector<Polygon>& pieces, double enough, double reach,
                    const EdgeIndex& walls) {
  const BoxIndex index = index_of_segments(path);
  std::vector<Stop> stops;
  for (const Polygon& piece : pieces)
    if (const auto stop = shortest_stop(path, index, piece, reach, walls)) stops.push_back(*stop);
  stops = best_of(std::move(stops), enough);
  std::ranges::stable_sort(stops, {}, [](const Stop& s) { return std::tuple(s.segment, s.along); });
  Polyline whole{path.front()};
  auto next = stops.begin();
  for (std::size_t k = 0; k + 1 < path.size(); ++k) {
    for (; next != stops.end() && next->segment == k; ++next)
      whole.insert(whole.end(), {next->from, next->at, next->from});
    whole.push_back(path[k + 1]);
  }
  return whole;
}

}  // namespace oxturn
