#include "algorithms/smoothing/linked_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/smoothing/strokes.hpp"

namespace oxturn {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();
constexpr double kUncut = 0.4;         // radii at both ends of an edge
constexpr std::size_t kCutsNear = 16;  // that are compared by the least that they may cost
constexpr std::size_t kTried = 5;      // of these, exactly
constexpr double kSpacing = 1;         // tool widths or radii, whichever is more, between cuts

}  // namespace

Path path_of(const std::vector<LinkedStroke>& strokes, const Point& start, double chord_error) {
  PathBuilder builder(start);
  for (const LinkedStroke& s : strokes) {
    for (const Leg& leg : sampled(s.link, chord_error, s.covers)) builder.drive(leg.points, leg.tool, leg.gear);
    builder.drive(s.stroke, true);
  }
  return builder.take();
}

Polyline points_of(const Curve& curve, double chord_error) {
  Polyline all;
  for (const Leg& leg : sampled(curve, chord_error, false))
    all.insert(all.end(), leg.points.begin() + (all.empty() ? 0 : 1), leg.points.end());
  return all;
}

InsertedStrokes::InsertedStrokes(std::vector<LinkedStroke> strokes, KnownLinks& links, double width,
                                 DetourEffort& effort, const Context& context)
    : strokes_(std::move(strokes)),
      links_(links),
      space_(links.space()),
      width_(width),
      effort_(effort),
      context_(context) {
  for (std::size_t s = 0; s < strokes_.size(); ++s) add_cuts(s);
  for (const Cut& cut : cuts_) positions_.push_back(cut.out.at);
  grid_.emplace(positions_);
  chosen_.resize(cuts_.size());
}

void InsertedStrokes::add_cuts(std::size_t s) {
  const Polyline& line = strokes_[s].stroke;
  const double uncut = kUncut * space_.radius(), spacing = kSpacing * std::max(width_, space_.radius());
  double next = spacing / 2;  // metres from the edge's beginning
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const double edge = distance(line[i], line[i + 1]);
    for (next = std::max(next, uncut); next <= edge - uncut; next += spacing) {
      const Pose pose{lerp(line[i], line[i + 1], next / edge), heading(line[i], line[i + 1])};
      cuts_.push_back({s, i, next, pose, pose, 0, false});
    }
    next -= edge;
  }
  const bool last = s + 1 == strokes_.size();
  const Pose end = last_pose(line);
  cuts_.push_back({s, line.size() - 1, 0, end, last ? end : first_pose(strokes_[s + 1].stroke),
                   last ? 0 : space_.cost(strokes_[s + 1].link), last});
}

std::vector<InsertedStrokes::Candidate> InsertedStrokes::candidates(const Polyline& line) const {
  std::vector<Candidate> all;
  const Pose first = first_pose(line), last = last_pose(line);
  std::size_t looked_at = 0;
  grid_->visit(first.at, [&](std::size_t c, double) {
    if (chosen_[c]) return true;
    const Cut& cut = cuts_[c];
    for (const bool backwards : {false, true}) {
      const Pose in = backwards ? turned_round(last) : first, out = backwards ? turned_round(first) : last;
      const double back = cut.last ? 0 : space_.least_length(out, cut.in);
      all.push_back({space_.least_length(cut.out, in) + back - cut.saved, {c, backwards}});
    }
    return ++looked_at < kCutsNear;
  });
  std::ranges::sort(all);
  return all;
}

std::optional<Curve> InsertedStrokes::link(const Pose& from, const Pose& to, bool search, double most) const {
  if (auto simple = links_.find(from, to, most)) return simple;
  return search ? space_.detour({from}, to, effort_, context_) : std::nullopt;
}

std::optional<InsertedStrokes::Insertion> InsertedStrokes::inserted_at(std::size_t c, Polyline line, bool search,
                                                                       double most) const {
  const Cut& cut = cuts_[c];
  const double least_back = cut.last ? 0 : space_.least_length(last_pose(line), cut.in);
  most += cut.saved - length(line);  // for the links
  std::optional<Curve> to = link(cut.out, first_pose(line), search, most - least_back);
  if (!to) return std::nullopt;
  std::optional<Curve> back;
  if (!cut.last && !(back = link(last_pose(line), cut.in, search, most - space_.cost(*to)))) return std::nullopt;
  const double cost = space_.cost(*to) + length(line) + (back ? space_.cost(*back) : 0) - cut.saved;
  return Insertion{c, std::move(line), std::move(*to), std::move(back), cost};
}

std::optional<InsertedStrokes::Insertion> InsertedStrokes::insertion_of(const Polyline& line, bool search) const {
  std::optional<Insertion> best;
  std::size_t tried = 0;
  for (const auto& [least, where] : candidates(line)) {
    if (best && least + length(line) >= best->cost) break;
    if (tried++ == (search ? 1 : kTried)) break;
    Polyline driven = line;
    if (where.second) std::ranges::reverse(driven);
    if (auto insertion = inserted_at(where.first, std::move(driven), search, best ? best->cost : kNoLimit);
        insertion && (!best || insertion->cost < best->cost))
      best = std::move(insertion);
  }
  return best;
}

void InsertedStrokes::insert(Insertion insertion) {
  const std::size_t cut = insertion.cut;
  chosen_[cut] = std::move(insertion);
  grid_->remove(cut);
}

std::vector<LinkedStroke> InsertedStrokes::take() {
  std::vector<LinkedStroke> all;
  std::optional<Curve> back;  // from a stroke inserted, instead of the next one's link
  std::size_t c = 0;
  for (LinkedStroke& s : strokes_) {
    LinkedStroke part{back ? std::move(*back) : std::move(s.link), {}, back || s.covers};
    back.reset();
    std::size_t from = 0;  // the first point that is not yet part of one
    const auto take_until = [&](std::size_t end) {
      for (; from < end; ++from) part.stroke.push_back(s.stroke[from]);
    };
    for (; c < cuts_.size() && &strokes_[cuts_[c].stroke] == &s; ++c) {
      if (!chosen_[c]) continue;
      Insertion& insertion = *chosen_[c];
      take_until(cuts_[c].edge + 1);
      const bool at_end = from == s.stroke.size();
      if (!at_end) part.stroke.push_back(cuts_[c].out.at);
      all.push_back(std::move(part));
      all.push_back({std::move(insertion.to), std::move(insertion.stroke), true});
      part = {};
      if (at_end)
        back = std::move(insertion.back);
      else
        part = {std::move(*insertion.back), {cuts_[c].out.at}, true};
    }
    if (from == s.stroke.size() && part.stroke.empty()) continue;  // its end was a cut
    take_until(s.stroke.size());
    all.push_back(std::move(part));
  }
  return all;
}

}  // namespace oxturn
