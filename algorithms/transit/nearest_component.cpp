#include "algorithms/transit/nearest_component.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "geometry/paths/sleeve.hpp"

namespace oxturn {
namespace {

// Midpoints of triangle sides measure distance roughly, so the nearest component may be met as the second or third. So
// many are compared by the shortest paths through the triangles by which the wave came.
constexpr std::size_t kCandidates = 4;
constexpr double kFarEnough = 1.5;  // times the path found, where any that is about as near will do

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAlmostStraight = 1.3;  // straight distances
constexpr int kMostTries = 16;           // to see an entry point
constexpr std::size_t kNear = 4096;      // triangles of a wave, before groups of them are asked
constexpr std::size_t kInGroup = 256;    // triangles

}  // namespace

NearestComponent::NearestComponent(const Problem& problem)
    : problem_(problem), wave_(problem), in_triangle_(wave_.triangle_count(), kNone) {}

void NearestComponent::add(const Point& p, int component, std::size_t id) {
  const auto triangle = wave_.triangle_of(p);
  if (!triangle) return;
  const auto number = static_cast<std::uint32_t>(entries_.size());
  const std::uint32_t next = std::exchange(in_triangle_[*triangle], number);
  entries_.push_back({p, component, id, static_cast<std::uint32_t>(*triangle), next});
}

void NearestComponent::remove(int component) {
  if (removed_.size() <= static_cast<std::size_t>(component))
    removed_.resize(static_cast<std::size_t>(component) + 1, false);
  removed_[static_cast<std::size_t>(component)] = true;
}

/// Made again when there are twice as many entries.
void NearestComponent::keep_grid() {
  if (entries_.size() < std::max<std::size_t>(1, 2 * in_grid_)) return;
  std::vector<Point> points;
  for (const Entry& e : entries_) points.push_back(e.at);
  in_grid_ = points.size();
  grid_.emplace(std::move(points));
}

void NearestComponent::try_entry(const Point& p, const Entry& entry, double longest, Nearest& best) const {
  std::optional<Polyline> path = problem_.transit().path(p, entry.at, std::min(longest, best.metres));
  if (!path) return;
  if (const double metres = length(*path); metres < best.metres)
    best = {.found = Found{entry.id, std::move(*path)}, .metres = metres};
}

/// Is the best certainly the nearest of all? No other entry is nearer by straight distance but one of which a limit of
/// the search has shown that it is farther by path. One search only: among many obstacles each is long, and the wave
/// finds the same entry in nearly all cases.
bool NearestComponent::find_almost_straight(const Point& p, Nearest& best) {
  keep_grid();
  if (in_grid_ < entries_.size()) return false;
  std::vector<std::size_t> gone;
  bool searched = false, all_nearer_tried = true;
  double farther = kInfinity;  // than that is the one that was searched in vain
  grid_->visit(p, [&](std::size_t i, double straight) {
    const Entry& entry = entries_[i];
    if (removed(entry.component)) {
      gone.push_back(i);
      return true;
    }
    if (straight >= best.metres) return false;
    if (problem_.walls().contains(p, entry.at)) {
      best = {.found = Found{entry.id, {p, entry.at}}, .metres = straight};
      return false;
    }
    all_nearer_tried = !std::exchange(searched, true);
    if (!all_nearer_tried) return false;
    try_entry(p, entry, kAlmostStraight * straight, best);
    if (!best.found) farther = kAlmostStraight * straight;
    return true;
  });
  for (const std::size_t i : gone) grid_->remove(i);
  return all_nearer_tried && best.metres <= farther;
}

/// The first entry by straight distance that is in sight, if it is among the first few.
NearestComponent::Nearest NearestComponent::nearest_in_sight(const Point& p) {
  keep_grid();
  std::vector<std::size_t> gone;
  Nearest best;
  int tries = 0;
  grid_->visit(p, [&](std::size_t i, double straight) {
    const Entry& entry = entries_[i];
    if (removed(entry.component)) {
      gone.push_back(i);
      return true;
    }
    if (!problem_.walls().contains(p, entry.at)) return ++tries < kMostTries;
    best = {.found = Found{entry.id, {p, entry.at}}, .metres = straight};
    return false;
  });
  for (const std::size_t i : gone) grid_->remove(i);
  return best;
}

void NearestComponent::forget_removed(std::vector<std::uint32_t>& entries) const {
  std::erase_if(entries, [this](std::uint32_t e) { return removed(entries_[e].component); });
}

/// The entry in a triangle that is nearest to a point, the first of those equally near; nullopt if there is none.
/// Removed ones are left out from then on.
std::optional<std::uint32_t> NearestComponent::nearest_in(std::size_t triangle, const Point& to) {
  std::optional<std::uint32_t> best;
  double least = kInfinity;
  for (std::uint32_t* link = &in_triangle_[triangle]; *link != kNone;) {
    Entry& entry = entries_[*link];
    if (removed(entry.component)) {
      *link = entry.next;
      continue;
    }
    if (const double d = (entry.at - to).squaredNorm(); d <= least) {  // those before come later in the list
      least = d;
      best = *link;
    }
    link = &entry.next;
  }
  return best;
}

/// Made when first needed; entries may still be added later.
void NearestComponent::keep_groups() {
  if (!groups_) {
    groups_.emplace(problem_.transit().mesh(), kInGroup);
    in_group_.resize(groups_->count());
  }
  for (; in_groups_ < entries_.size(); ++in_groups_)
    in_group_[groups_->of(entries_[in_groups_].triangle)].push_back(static_cast<std::uint32_t>(in_groups_));
}

/// Allows the groups on the path to the first ones that have entries of a few components, and their neighbours.
void NearestComponent::allow_path_to_few(std::size_t home, double longest) {
  keep_groups();
  allowed_.assign(groups_->count(), false);
  std::set<int> components;
  const auto neighbours = [&](std::size_t g, const auto& reach) {
    for (const std::uint32_t next : groups_->neighbours(g))
      reach(next, distance(groups_->centre(g), groups_->centre(next)));
  };
  dijkstra(coarse_, groups_->count(), groups_->of(home), neighbours, [&](std::size_t group) {
    if (coarse_.cost(group) >= longest) return true;
    forget_removed(in_group_[group]);
    if (in_group_[group].empty()) return false;
    for (const std::uint32_t e : in_group_[group]) components.insert(entries_[e].component);
    for (const std::size_t g : coarse_.path_to(group)) {
      allowed_[g] = true;
      for (const std::uint32_t next : groups_->neighbours(g)) allowed_[next] = true;
    }
    return components.size() >= kCandidates;
  });
}

/// Of the entries of the first components that a wave from p meets the one with the shortest path through the triangles
/// by which the wave came: no search through the triangles for each of them, which far away would cost all that lies
/// nearer. The path is at least as long as the shortest one. The wave ends when it has come `far_enough` times as far.
NearestComponent::Nearest NearestComponent::nearest_by_wave(const Point& p, std::size_t home, double longest,
                                                            double far_enough) {
  std::set<int> components;
  Nearest best{.found = std::nullopt, .metres = longest};
  const auto meet = [&](std::size_t t) {
    if (wave_.metres(t) >= std::min(longest, far_enough * best.metres)) return true;
    const auto entry = nearest_in(t, wave_.entered_at(t));
    if (!entry) return false;
    components.insert(entries_[*entry].component);
    Polyline path = shortest_in_sleeve(problem_.transit().mesh(), p, wave_.triangles_to(t), entries_[*entry].at);
    if (const double metres = length(path); metres < best.metres)
      best = {.found = Found{entries_[*entry].id, std::move(path)}, .metres = metres, .entry = *entry};
    return components.size() >= kCandidates;
  };
  std::size_t near = 0;
  wave_.spread(p, home, [&](std::size_t t) { return meet(t) || ++near == kNear; });
  if (near < kNear || !components.empty()) return best;
  allow_path_to_few(home, longest);
  wave_.spread_within(
      p, home, [&](std::size_t t) { return allowed_[groups_->of(t)]; }, meet);
  return best;
}

std::optional<std::size_t> NearestComponent::nearest(const Point& p) {
  const auto home = wave_.triangle_of(p);
  if (!home || entries_.empty()) return std::nullopt;
  Nearest best = nearest_in_sight(p);
  if (Nearest by_wave = nearest_by_wave(p, *home, best.metres, kFarEnough); by_wave.found) best = std::move(by_wave);
  return best.found ? std::optional(best.found->id) : std::nullopt;
}

std::optional<NearestComponent::Found> NearestComponent::from(const Point& p) {
  const auto home = wave_.triangle_of(p);
  if (!home || entries_.empty()) return std::nullopt;
  Nearest best;
  if (find_almost_straight(p, best)) return std::move(best.found);
  if (Nearest by_wave = nearest_by_wave(p, *home, kInfinity, kInfinity); by_wave.metres < best.metres) {
    best = std::move(by_wave);
    // The wave may have come on the wrong side of an obstacle.
    try_entry(p, entries_[best.entry], best.metres, best);
  }
  return std::move(best.found);
}

}  // namespace oxturn
