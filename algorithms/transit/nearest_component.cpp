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
    : problem_(problem), wave_(problem), entries_(wave_.triangle_count()) {}

void NearestComponent::add(const Point& p, int component, std::size_t id) {
  if (const auto triangle = wave_.triangle_of(p)) entries_[*triangle].push_back({p, component, id});
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
  wave_.spread(p, triangle, [&](std::size_t t) {
    if (const Entry* entry = nearest_in(t, wave_.entered_at(t))) {
      found.push_back(*entry);
      components.insert(entry->component);
    }
    return components.size() >= kCandidates;
  });
  return found;
}

std::optional<NearestComponent::Found> NearestComponent::from(const Point& p) {
  const auto home = wave_.triangle_of(p);
  if (!home) return std::nullopt;
  std::optional<Found> best;
  double least = std::numeric_limits<double>::infinity();
  for (const Entry& e : candidates(p, *home)) {
    std::optional<Polyline> path = problem_.transit().path(p, e.at, least);
    if (!path || !(length(*path) < least)) continue;
    least = length(*path);
    best = Found{e.id, std::move(*path)};
  }
  return best;
}

}  // namespace oxturn
