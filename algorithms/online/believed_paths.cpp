#include "algorithms/online/believed_paths.hpp"

#include <algorithm>

#include "maps/followed_path.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kTurns = 16;  // places of the way driven at which turning off is tried

void append(Polyline& line, const Polyline& more) {
  for (const Point& p : more)
    if (line.empty() || line.back() != p) line.push_back(p);
}

}  // namespace

struct BelievedPaths::Strings {
  TautSpace space;                  // where the robot's centre may be
  Polyline way;                     // the way driven, within that space
  std::vector<std::size_t> at;      // some places of it (index), first and last included
  std::vector<TautTether> strings;  // there
  double longest = 0;

  const TautTether& now() const { return strings.back(); }
  /// Drives on; nullopt if the leash is too short on the way.
  std::optional<TautTether> driven(TautTether string, const Polyline& points) const {
    for (const Point& p : points) {
      string.drive(p);
      if (string.length() > longest) return std::nullopt;
    }
    return string;
  }
  /// The shortest line of the same class in the robot's space.
  Polyline taut(const Polyline& line) const {
    if (line.size() < 3) return line;
    TautTether shadow(space, line.front());
    shadow.drive(line);
    return shadow.polyline();
  }
};

BelievedPaths::BelievedPaths(const Problem& believed, const Polyline& way) : believed_(believed), driven_(way) {
  if (!believed.robot().tether) return;
  strings_.reset(new Strings{TautSpace(believed.configuration_space()), {}, {}, {}, believed.robot().tether->length});
  // Believed walls move by a cell or so from one time to the next: the way is put where it fits today. The string lies
  // in free space, of which there is more: it went where the robot went, unless not even that is free today.
  const EdgeIndex free(believed.map().free);
  Polyline& fitted = strings_->way;
  TautTether string = tether_at_start(believed);
  const std::size_t n = way.size(), every = std::max<std::size_t>(1, n / kTurns);
  for (std::size_t k = 0; k < n; ++k) {
    Polyline on{inside(way[k])};
    if (!fitted.empty() && !believed.walls().contains(fitted.back(), on.back()))
      if (auto round = path(fitted.back(), on.back())) on = std::move(*round);
    append(fitted, on);
    if (free.contains(string.robot(), way[k])) on = {way[k]};
    for (const Point& p : on) string.drive(p);
    if (k % every != 0 && k + 1 != n) continue;
    strings_->at.push_back(fitted.size() - 1);
    strings_->strings.push_back(string);
  }
}
BelievedPaths::~BelievedPaths() = default;

Point BelievedPaths::inside(const Point& p) const {
  if (believed_.walls().contains(p)) return p;
  const auto hit = believed_.walls().nearest(p);
  return hit ? hit->point : p;
}

// Ends that the believed walls have come too near to are joined to the nearest place of configuration space.
std::optional<Polyline> BelievedPaths::path(const Point& from, const Point& to) const {
  const auto middle = believed_.transit().path(inside(from), inside(to));
  if (!middle) return std::nullopt;
  Polyline line{from};
  append(line, *middle);
  append(line, {to});
  return line;
}

bool BelievedPaths::holds(const Polyline& points) const {
  return !strings_ || strings_->driven(strings_->now(), points).has_value();
}

std::optional<Polyline> BelievedPaths::to(const Point& goal) const {
  const auto direct = path(driven_.back(), goal);
  if (!strings_ || (direct && holds(*direct))) return direct;
  const Polyline& way = strings_->way;
  std::optional<Polyline> best;
  double least = std::numeric_limits<double>::infinity();
  Polyline back{driven_.back()};
  std::size_t k = way.size();
  for (std::size_t s = strings_->at.size(); s-- > 0;) {
    while (k > strings_->at[s]) append(back, {way[--k]});
    const auto on = path(way[k], goal);
    if (!on || length(*on) - distance(way[k], way.back()) >= least) continue;
    if (!strings_->driven(strings_->strings[s], *on)) continue;
    Polyline whole = back;
    append(whole, *on);
    Polyline line = strings_->taut(whole);
    if (!holds(line)) {  // rounding: as it comes, along the way driven
      if (!holds(whole)) continue;
      line = std::move(whole);
    }
    if (length(line) >= least) continue;
    least = length(line);
    best = std::move(line);
  }
  return best;
}

std::optional<Polyline> BelievedPaths::home() const {
  if (!strings_) return path(driven_.back(), driven_.front());
  Polyline back(driven_.rbegin(), driven_.rend()), fitted{driven_.back()};
  append(fitted, Polyline(strings_->way.rbegin(), strings_->way.rend()));
  append(fitted, {driven_.front()});
  Polyline line = strings_->taut(fitted);
  const auto string = strings_->driven(strings_->now(), line);
  return string && string->bends() == strings_->strings.front().bends() ? std::move(line) : std::move(back);
}

}  // namespace oxturn
