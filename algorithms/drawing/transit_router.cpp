#include "algorithms/drawing/transit_router.hpp"

#include <algorithm>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/thinned.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 2e-3;  // tool widths: error of the obstacles' arcs, outside
constexpr int kMostRounds = 40;  // of adding what the path crosses

}  // namespace

TransitRouter::TransitRouter(const Problem& problem, const FinishedWork& work, double keep_off,
                             const SmoothTransits* smooth)
    : problem_(problem), work_(work), keep_off_(keep_off), smooth_(smooth), connector_(problem) {}

Transit TransitRouter::measured(Polyline path, bool keeps_radius) const {
  const double metres = length(path), crossing = work_.crossing_m(path);
  return {std::move(path), metres, crossing, keeps_radius};
}

Transit TransitRouter::direct(const Pose& from, const Pose& to) const {
  Polyline path = connector_.path(from.at, to.at);
  if (smooth_ == nullptr) return measured(std::move(path));
  SmoothTransit t = smooth_->find(from, to, path);
  return measured(std::move(t.path), t.keeps_radius);
}

Transit TransitRouter::direct(const Point& from, const Pose& to) const {
  Polyline path = connector_.path(from, to.at);
  if (smooth_ == nullptr) return measured(std::move(path));
  SmoothTransit t = smooth_->find(from, to, path);
  return measured(std::move(t.path), t.keeps_radius);
}

const Region& TransitRouter::sweep(std::size_t piece, bool grown) {
  const auto found = sweeps_.find({piece, grown});
  if (found != sweeps_.end()) return found->second;
  const DrawnPiece& p = work_.pieces()[piece];
  const double chord = kChord * problem_.robot().tool_width;
  const double radius = p.half_width + (grown ? keep_off_ : 0);
  // What the thinned line may be off is added to the radius, so the sweep still holds all of the piece's.
  return sweeps_[{piece, grown}] = swath({thinned(p.points, chord / 4)}, radius + chord / 4, chord / 2, Bound::outside);
}

Region TransitRouter::free_region(const std::vector<std::size_t>& pieces, const Point& from, const Point& to,
                                  double keep_off) {
  std::vector<Region> obstacles;
  const double chord = kChord * problem_.robot().tool_width;
  for (const bool grown : {false, true}) {
    if (grown && !(keep_off > 0)) continue;
    const double exempt = work_.exempt() + (grown ? keep_off : 0);
    const std::vector<Region> discs{swath({{from}}, exempt, chord, Bound::inside),
                                    swath({{to}}, exempt, chord, Bound::inside)};
    for (const std::size_t piece : pieces) {
      const Region& swept = sweep(piece, grown);
      effort_ += vertex_count(swept);
      const Box box = bounding_box(swept);
      const bool near = box.overlaps(bounding_box(discs[0])) || box.overlaps(bounding_box(discs[1]));
      obstacles.push_back(near ? subtract(swept, discs) : swept);
    }
  }
  return subtract(problem_.configuration_space(), obstacles);
}

std::optional<TransitRouter::Known> TransitRouter::lazy(const Point& from, const Point& to, double keep_off) {
  const std::array<double, 5> ends{from.x(), from.y(), to.x(), to.y(), keep_off};
  if (const auto found = enclosing_.find(ends); found != enclosing_.end() && all_finished(found->second))
    return std::nullopt;
  Known known{.round = {}, .keep_off = keep_off, .transit = {connector_.path(from, to)}};
  for (int round = 0; round < kMostRounds; ++round) {
    bool added = false;
    for (const std::size_t piece : work_.crossed(known.transit.path, keep_off)) {
      const auto at = std::lower_bound(known.round.begin(), known.round.end(), piece);
      if (at != known.round.end() && *at == piece) continue;
      known.round.insert(at, piece);
      added = true;
    }
    if (!added) {
      known.transit = measured(std::move(known.transit.path));
      return known;
    }
    if (exhausted()) return std::nullopt;
    const ShortestPaths paths(free_region(known.round, from, to, keep_off), problem_.tolerance());
    std::optional<Polyline> path = paths.path(from, to);
    if (!path) {
      enclosing_[ends] = std::move(known.round);
      return std::nullopt;
    }
    known.transit.path = std::move(*path);
  }
  return std::nullopt;
}

bool TransitRouter::valid(const Known& known) const {
  if (!known.for_this_work) return all_finished(known.round) && is_clear(known);
  if (known.fingerprint == work_.fingerprint()) return true;
  if (known.finished.empty()) return false;
  for (std::size_t piece = 0; piece < known.finished.size(); ++piece)
    if (known.finished[piece] && !work_.finished(piece)) return false;
  return work_.crossing_m(known.transit.path) <= known.transit.crossing_m;
}

bool TransitRouter::all_finished(const std::vector<std::size_t>& pieces) const {
  return std::ranges::all_of(pieces, [&](std::size_t piece) { return work_.finished(piece); });
}

/// Of all but the pieces that it goes round, which it may touch.
bool TransitRouter::is_clear(const Known& known) const {
  const std::vector<std::size_t> crossed = work_.crossed(known.transit.path, known.keep_off);
  return std::includes(known.round.begin(), known.round.end(), crossed.begin(), crossed.end());
}

TransitRouter::Known TransitRouter::with_bends(const Point& from, const Point& to) {
  if (auto best = lazy(from, to, keep_off_)) return *best;
  if (keep_off_ > 0)
    if (auto best = lazy(from, to, 0)) {
      best->for_this_work = true;
      return *best;
    }
  Known best{.round = {}, .transit = measured(connector_.path(from, to)), .for_this_work = true};
  if (!weighted_) weighted_.emplace(problem_, work_, Transit::kCrossingWeight);
  const auto path = weighted_->path(from, to);
  effort_ += weighted_->cells_reached() / kCellsToVertex;
  if (path)
    if (Transit t = measured(*path); t.price() < best.transit.price()) best.transit = std::move(t);
  return best;
}

void TransitRouter::smoothen(Known& known, const Pose& from, bool any_heading, const Pose& to) const {
  SmoothTransit t =
      any_heading ? smooth_->find(from.at, to, known.transit.path) : smooth_->find(from, to, known.transit.path);
  known.transit = measured(std::move(t.path), t.keeps_radius);
  known.for_this_work = known.for_this_work || known.transit.crossing_m > 0 || !t.keeps_radius;
  if (!is_clear(known)) known.keep_off = 0;
}

Transit TransitRouter::route(const Pose& from, bool any_heading, const Pose& to) {
  const bool headings = smooth_ != nullptr;
  const Key key{from.at.x(), from.at.y(), headings && !any_heading ? from.heading : kAnyHeading,
                to.at.x(),   to.at.y(),   headings ? to.heading : kAnyHeading};
  const auto found = known_.find(key);
  if (found != known_.end() && valid(found->second)) return found->second.transit;
  Known known = with_bends(from.at, to.at);
  if (smooth_ != nullptr) smoothen(known, from, any_heading, to);
  known.fingerprint = work_.fingerprint();
  if (known.for_this_work && smooth_ == nullptr && !exhausted()) known.finished = work_.finished();
  return known_.insert_or_assign(key, std::move(known)).first->second.transit;
}

Transit TransitRouter::route(const Pose& from, const Pose& to) { return route(from, false, to); }
Transit TransitRouter::route(const Point& from, const Pose& to) { return route(Pose{from, 0}, true, to); }

}  // namespace oxturn
