#include "algorithms/transit/nearest_component.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <set>

namespace oxturn {
namespace {

// The wave measures by the middles of triangle sides, which may favour the second nearest part: so many are compared by
// their true ways.
constexpr std::size_t kCandidates = 4;

struct Front {
  double distance;
  std::int32_t triangle;
  Point at;
  bool operator<(const Front& o) const {  // nearest on top, then the lowest number
    return distance != o.distance ? distance > o.distance : triangle > o.triangle;
  }
};

}  // namespace

NearestComponent::NearestComponent(const Problem& problem)
    : problem_(problem),
      mesh_(problem.transit().mesh()),
      entries_(mesh_.triangles().size()),
      reached_(mesh_.triangles().size()) {}

void NearestComponent::add(const Point& p, int part, std::size_t id) {
  const std::int32_t triangle = mesh_.locate(p, problem_.tolerance());
  if (triangle != Mesh::kWall) entries_[static_cast<std::size_t>(triangle)].push_back({p, part, id});
}

void NearestComponent::remove(int part) {
  if (dropped_.size() <= static_cast<std::size_t>(part)) dropped_.resize(static_cast<std::size_t>(part) + 1, false);
  dropped_[static_cast<std::size_t>(part)] = true;
}

// The live entry in a triangle that is nearest to a point of it; entries of dropped parts go for good.
const NearestComponent::Entry* NearestComponent::nearest_in(std::size_t triangle, const Point& to) {
  std::vector<Entry>& here = entries_[triangle];
  std::erase_if(here, [&](const Entry& e) { return dropped(e.part); });
  const auto best = std::min_element(here.begin(), here.end(), [&](const Entry& a, const Entry& b) {
    return (a.at - to).squaredNorm() < (b.at - to).squaredNorm();
  });
  return best == here.end() ? nullptr : &*best;
}

std::optional<NearestComponent::Found> NearestComponent::from(const Point& p) {
  const std::int32_t home = mesh_.locate(p, problem_.tolerance());
  if (home == Mesh::kWall) return std::nullopt;
  ++stamp_;
  std::priority_queue<Front> fronts;
  fronts.push({0, home, p});
  reached_[static_cast<std::size_t>(home)] = {0, stamp_};
  std::set<int> parts;
  std::vector<Entry> candidates;
  while (!fronts.empty() && parts.size() < kCandidates) {
    const Front front = fronts.top();
    fronts.pop();
    const auto t = static_cast<std::size_t>(front.triangle);
    if (front.distance > reached_[t].distance) continue;
    if (const Entry* entry = nearest_in(t, front.at)) {
      candidates.push_back(*entry);
      parts.insert(entry->part);
    }
    const Mesh::Triangle& triangle = mesh_.triangles()[t];
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle.neighbour[k] == Mesh::kWall) continue;
      const auto corner = [&](std::size_t c) {
        return mesh_.points()[static_cast<std::size_t>(triangle.vertex[c % 3])];
      };
      const Point middle = (corner(k + 1) + corner(k + 2)) / 2;
      const double there = front.distance + distance(front.at, middle);
      Reached& next = reached_[static_cast<std::size_t>(triangle.neighbour[k])];
      if (next.stamp == stamp_ && next.distance <= there) continue;
      next = {there, stamp_};
      fronts.push({there, triangle.neighbour[k], middle});
    }
  }
  std::optional<Found> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Entry& e : candidates) {
    std::optional<Polyline> way = problem_.transit().path(p, e.at, least);
    if (!way || !(length(*way) < least)) continue;
    least = length(*way);
    best = Found{e.id, std::move(*way)};
  }
  return best;
}

}  // namespace oxturn
