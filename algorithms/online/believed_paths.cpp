#include "algorithms/online/believed_paths.hpp"

#include <algorithm>

#include "maps/followed_path.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kTurns = 16;  // points of the driven path from which turning off is tried

void append(Polyline& line, const Polyline& more) {
  for (const Point& p : more)
    if (line.empty() || line.back() != p) line.push_back(p);
}

}  // namespace

/// The tether as it was along the driven path.
struct BelievedPaths::Tether {
  struct State {
    std::size_t at;  // index into `driven`
    TautTether tether;
  };
  TautSpace space;                 // where the robot's centre may be
  double length = 0;               // limit
  Polyline driven = {};            // within that space
  std::vector<State> states = {};  // at some points of it, the first and the last included

  const TautTether& now() const { return states.back().tether; }
  /// After driving on; nullopt if the tether is too short on the way.
  std::optional<TautTether> after(TautTether tether, const Polyline& points) const {
    for (const Point& p : points) {
      tether.drive(p);
      if (tether.length() > length) return std::nullopt;
    }
    return tether;
  }
  /// The shortest line of the same class in the robot's space.
  Polyline taut(const Polyline& line) const {
    if (line.size() < 3) return line;
    TautTether copy(space, line.front());
    copy.drive(line);
    return copy.polyline();
  }
};

// Believed walls move by about a cell from one time to the next: the driven path is moved to where it fits today. The
// tether lies in free space, of which there is more: it followed the robot, unless not even that is free today.
BelievedPaths::BelievedPaths(const Problem& believed, const Polyline& driven) : believed_(believed), driven_(driven) {
  if (!believed.robot().tether) return;
  tether_.reset(new Tether{TautSpace(believed.configuration_space()), believed.robot().tether->length});
  const EdgeIndex free(believed.map().free);
  Polyline& fitted = tether_->driven;
  TautTether tether = tether_at_start(believed);
  const std::size_t n = driven.size(), every = std::max<std::size_t>(1, n / kTurns);
  for (std::size_t k = 0; k < n; ++k) {
    Polyline on{inside(driven[k])};
    if (!fitted.empty() && !believed.walls().contains(fitted.back(), on.back()))
      if (auto around = path(fitted.back(), on.back())) on = std::move(*around);
    append(fitted, on);
    if (free.contains(tether.robot(), driven[k])) on = {driven[k]};
    for (const Point& p : on) tether.drive(p);
    if (k % every == 0 || k + 1 == n) tether_->states.push_back({fitted.size() - 1, tether});
  }
}
BelievedPaths::~BelievedPaths() = default;

Point BelievedPaths::inside(const Point& p) const {
  if (believed_.walls().contains(p)) return p;
  const auto hit = believed_.walls().nearest(p);
  return hit ? hit->point : p;
}

/// Ends that the believed walls have come too near to are connected to the nearest point of configuration space.
std::optional<Polyline> BelievedPaths::path(const Point& from, const Point& to) const {
  const auto middle = believed_.transit().path(inside(from), inside(to));
  if (!middle) return std::nullopt;
  Polyline line{from};
  append(line, *middle);
  append(line, {to});
  return line;
}

bool BelievedPaths::within_tether(const Polyline& points) const {
  return !tether_ || tether_->after(tether_->now(), points).has_value();
}

std::optional<Polyline> BelievedPaths::to(const Point& goal) const {
  const auto direct = path(driven_.back(), goal);
  if (!tether_ || (direct && within_tether(*direct))) return direct;
  return path_turning_back(goal);
}

/// The shortest of the paths that go back along the driven path to one of the known tether states, and on from there.
std::optional<Polyline> BelievedPaths::path_turning_back(const Point& goal) const {
  const Polyline& driven = tether_->driven;
  std::optional<Polyline> best;
  double least = std::numeric_limits<double>::infinity();
  Polyline back{driven_.back()};
  std::size_t k = driven.size();
  for (std::size_t s = tether_->states.size(); s-- > 0;) {
    const auto& [at, tether] = tether_->states[s];
    while (k > at) append(back, {driven[--k]});
    const auto on = path(driven[k], goal);
    if (!on || length(*on) - distance(driven[k], driven.back()) >= least) continue;
    if (!tether_->after(tether, *on)) continue;
    Polyline whole = back;
    append(whole, *on);
    Polyline line = tether_->taut(whole);
    if (!within_tether(line)) {  // by rounding; then without pulling it taut
      if (!within_tether(whole)) continue;
      line = std::move(whole);
    }
    if (length(line) >= least) continue;
    least = length(line);
    best = std::move(line);
  }
  return best;
}

std::optional<Polyline> BelievedPaths::home() const {
  if (!tether_) return path(driven_.back(), driven_.front());
  Polyline fitted{driven_.back()};
  append(fitted, Polyline(tether_->driven.rbegin(), tether_->driven.rend()));
  append(fitted, {driven_.front()});
  Polyline line = tether_->taut(fitted);
  const auto at_home = tether_->after(tether_->now(), line);
  if (at_home && at_home->bends() == tether_->states.front().tether.bends()) return line;
  return Polyline(driven_.rbegin(), driven_.rend());
}

}  // namespace oxturn
