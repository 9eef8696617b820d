#include "algorithms/transit/nearest_component.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace oxturn {
namespace {

// Midpoints of triangle sides measure distance roughly, so the nearest component may be met as the second or third. So
// many are compared by their shortest paths.
constexpr std::size_t kCandidates = 4;

}  // namespace

NearestComponent::NearestComponent(const Problem& problem)
    : problem_(problem),
      mesh_(problem.transit().mesh()),
      entries_(mesh_.triangles().size()),
      entered_at_(mesh_.triangles().size()) {}

void NearestComponent::add(const Point& p, int component, std::size_t id) {
  const std::int32_t triangle = mesh_.locate(p, problem_.tolerance());
  if (triangle != Mesh::kWall) entries_[static_cast<std::size_t>(triangle)].push_back({p, component, id});
}

void NearestComponent::remove(int component) {
  if (removed_.size() <= static_cast<std::size_t>(component))
    removed_.resize(static_cast<std::size_t>(component) + 1, false);
  removed_[static_cast<std::size_t>(component)] = true;
}

/// The entry in a triangle that is nearest to a point; nullptr if there is none. Forgets those of removed components.
const NearestComponent::Entry* NearestComponent::nearest_in(std::size_t triangle, const Point& to) {
  std::vector<Entry>& here = entries_[triangle];
  std::erase_if(here, [&](const Entry& e) { return removed(e.component); });
  const auto best = std::min_element(here.begin(), here.end(), [&](const Entry& a, const Entry& b) {
    return (a.at - to).squaredNorm() < (b.at - to).squaredNorm();
  });
  return best == here.end() ? nullptr : &*best;
}

std::vector<NearestComponent::Entry> NearestComponent::candidates(const Point& p, std::size_t triangle) {
  std::set<int> components;
  std::vector<Entry> found;
  const auto enough = [&](std::size_t t) {
    if (const Entry* entry = nearest_in(t, entered_at_[t])) {
      found.push_back(*entry);
      components.insert(entry->component);
    }
    return components.size() >= kCandidates;
  };
  const auto neighbours = [&](std::size_t t, const auto& reach) {
    const Mesh::Triangle& here = mesh_.triangles()[t];
    const auto vertex = [&](std::size_t k) { return mesh_.points()[static_cast<std::size_t>(here.vertex[k % 3])]; };
    for (std::size_t k = 0; k < 3; ++k) {
      if (here.neighbour[k] == Mesh::kWall) continue;
      const Point middle = (vertex(k + 1) + vertex(k + 2)) / 2;
      const auto next = static_cast<std::size_t>(here.neighbour[k]);
      if (reach(next, distance(entered_at_[t], middle))) entered_at_[next] = middle;
    }
  };
  entered_at_[triangle] = p;
  dijkstra(wave_, entries_.size(), triangle, neighbours, enough);
  return found;
}

std::optional<NearestComponent::Found> NearestComponent::from(const Point& p) {
  const std::int32_t home = mesh_.locate(p, problem_.tolerance());
  if (home == Mesh::kWall) return std::nullopt;
  std::optional<Found> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Entry& e : candidates(p, static_cast<std::size_t>(home))) {
    std::optional<Polyline> path = problem_.transit().path(p, e.at, least);
    if (!path || !(length(*path) < least)) continue;
    least = length(*path);
    best = Found{e.id, std::move(*path)};
  }
  return best;
}

}  // namespace oxturn
