#include "algorithms/online/string_ways.hpp"

#include <algorithm>

#include "maps/tethered_way.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kTurns = 48;  // places of the way driven at which turning off is tried

void append(Polyline& line, const Polyline& more) {
  for (const Point& p : more)
    if (line.empty() || line.back() != p) line.push_back(p);
}

}  // namespace

/// The string at chosen places of the way driven, the last being the robot's.
struct StringWays::Strings {
  std::vector<std::size_t> at;      // index in the way
  std::vector<TautString> strings;  // there
  double longest = 0;

  const TautString& now() const { return strings.back(); }
  /// Drives on; nullopt if the leash is too short on the way.
  std::optional<TautString> driven(TautString string, const Polyline& points) const {
    for (const Point& p : points) {
      string.drive(p);
      if (string.length() > longest) return std::nullopt;
    }
    return string;
  }
};

StringWays::StringWays(const Problem& believed, Polyline way) : believed_(believed), way_(std::move(way)) {
  if (!believed.robot().tether) return;
  strings_ = std::make_unique<Strings>();
  strings_->longest = believed.robot().tether->length;
  TautString string = string_at_start(believed);
  const std::size_t n = way_.size(), every = std::max<std::size_t>(1, n / kTurns);
  for (std::size_t k = 0; k < n; ++k) {
    string.drive(way_[k]);
    if (k % every != 0 && k + 1 != n) continue;
    strings_->at.push_back(k);
    strings_->strings.push_back(string);
  }
}
StringWays::~StringWays() = default;

// Ends that the believed walls have come too near to are joined to the nearest place of configuration space.
std::optional<Polyline> StringWays::path(const Point& from, const Point& to) const {
  const auto inside = [&](const Point& p) -> std::optional<Point> {
    if (believed_.walls().contains(p)) return p;
    const auto hit = believed_.walls().nearest(p, believed_.robot().radius + believed_.robot().tool_width);
    return hit ? std::optional(hit->place) : std::nullopt;
  };
  const auto a = inside(from), b = inside(to);
  if (!a || !b) return std::nullopt;
  const auto middle = believed_.transit().path(*a, *b);
  if (!middle) return std::nullopt;
  Polyline line{from};
  append(line, *middle);
  append(line, {to});
  return line;
}

bool StringWays::holds(const Polyline& points) const {
  return !strings_ || strings_->driven(strings_->now(), points).has_value();
}

std::optional<Polyline> StringWays::to(const Point& goal) const {
  const auto direct = path(way_.back(), goal);
  if (!strings_) return direct;
  if (direct && holds(*direct)) return direct;
  std::optional<Polyline> best;
  double least = std::numeric_limits<double>::infinity();
  Polyline back{way_.back()};
  std::size_t k = way_.size() - 1;
  for (std::size_t s = strings_->at.size(); s-- > 0;) {
    while (k > strings_->at[s]) append(back, {way_[--k]});
    if (length(back) >= least) break;
    const auto on = path(way_[k], goal);
    if (!on || length(back) + length(*on) >= least || !strings_->driven(strings_->strings[s], *on)) continue;
    // Back to that place by the shortest path, if that is of the same class.
    Polyline line = back;
    if (const auto cut = path(way_.back(), way_[k]); cut && length(*cut) < length(back))
      if (const auto string = strings_->driven(strings_->now(), *cut);
          string && string->bends() == strings_->strings[s].bends())
        line = *cut;
    append(line, *on);
    least = length(line);
    best = std::move(line);
  }
  return best;
}

std::optional<Polyline> StringWays::home() const {
  const Point& goal = way_.front();
  if (!strings_) return path(way_.back(), goal);
  const auto& first = strings_->strings.front().bends();
  Polyline back{way_.back()};
  std::size_t k = way_.size() - 1;
  for (std::size_t s = strings_->at.size(); s-- > 0;) {
    while (k > strings_->at[s]) append(back, {way_[--k]});
    const auto on = path(way_[k], goal);
    if (!on) continue;
    const auto string = strings_->driven(strings_->strings[s], *on);
    if (!string || string->bends() != first) continue;
    Polyline line = back;
    append(line, *on);
    return line;
  }
  while (k > 0) append(back, {way_[--k]});
  return back;
}

}  // namespace oxturn
