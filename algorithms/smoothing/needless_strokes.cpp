#include "algorithms/smoothing/needless_strokes.hpp"

#include <algorithm>
#include <queue>
#include <utility>

#include "algorithms/improve/witnesses.hpp"
#include "algorithms/smoothing/strokes.hpp"

namespace oxturn {
namespace {

constexpr double kCell = 1.0 / 32;  // tool widths, between the points of the raster
constexpr int kMostTries = 3;       // of a stroke: once, and again when one beside it was taken out

class Needless {
 public:
  Needless(std::vector<LinkedStroke> driven, const Region& target, double width, const CarSpace& space,
           const Context& context)
      : strokes_(std::move(driven)),
        tries_of_(strokes_.size(), 0),
        taken_out_(strokes_.size(), false),
        space_(space),
        context_(context),
        witnesses_(target, kCell * width, width / 2) {
    for (std::size_t s = 0; s < strokes_.size(); ++s) {
      before_.push_back(s - 1), behind_.push_back(s + 1);
      for (const auto& capsule : capsules_of(s)) witnesses_.add(capsule);
      if (strokes_[s].covers)
        for (const auto& capsule : capsules_of(strokes_[s].link)) witnesses_.add(capsule);
    }
  }

  /// The first stroke stays: the link from the start to it was chosen among all headings.
  std::vector<LinkedStroke> run() {
    for (std::size_t s = 1; s < strokes_.size(); ++s) offer(s);
    while (!open_.empty() && !context_.cancelled()) {
      const std::size_t s = open_.top().second;
      open_.pop();
      if (taken_out_[s] || !take_out(s)) continue;
      if (before_[s] > 0) offer(before_[s]);
      if (behind_[s] < strokes_.size()) offer(behind_[s]);
    }
    std::vector<LinkedStroke> rest;
    for (std::size_t s = 0; s < strokes_.size(); ++s)
      if (!taken_out_[s]) rest.push_back(std::move(strokes_[s]));
    return rest;
  }

  std::size_t tries() const { return tries_; }

 private:
  using Capsules = std::vector<Witnesses::Capsule>;

  bool last(std::size_t s) const { return behind_[s] == strokes_.size(); }
  Pose out(std::size_t s) const { return last_pose(strokes_[before_[s]].stroke); }
  Pose in(std::size_t s) const { return first_pose(strokes_[behind_[s]].stroke); }

  /// Metres of the stroke and its links.
  double cost(std::size_t s) const {
    return space_.cost(strokes_[s].link) + length(strokes_[s].stroke) +
           (last(s) ? 0 : space_.cost(strokes_[behind_[s]].link));
  }

  void offer(std::size_t s) {
    if (tries_of_[s]++ == kMostTries) return;
    const double saved = cost(s) - (last(s) ? 0 : space_.least_length(out(s), in(s)));
    if (saved > 0) open_.push({saved, s});
  }

  void add_capsules(const Polyline& line, Capsules& all) const {
    for (std::size_t i = 1; i < line.size(); ++i) {
      all.emplace_back();
      witnesses_.capsule(line[i - 1], line[i], all.back());
    }
  }
  Capsules capsules_of(std::size_t s) const {
    Capsules all;
    add_capsules(strokes_[s].stroke, all);
    return all;
  }
  Capsules capsules_of(const Curve& link) const {
    Capsules all;
    if (!link.pieces.empty()) add_capsules(points_of(link, space_.chord_error()), all);
    return all;
  }

  /// False, and nothing is changed, if a point would be lost.
  bool exchange(const Capsules& old, const Capsules& added) {
    if (!witnesses_.may_change(old, added, 0)) return false;
    // First what is added, so that what it covers besides does not make up for points that are lost.
    witnesses_.exchange({}, added);
    if (witnesses_.exchange(old, {}) == 0) return true;
    witnesses_.exchange(added, old);
    return false;
  }

  bool take_out(std::size_t s) {
    ++tries_;
    Capsules old = capsules_of(s), added;
    const auto add_link = [&](std::size_t k) {
      if (!strokes_[k].covers) return;
      for (auto& capsule : capsules_of(strokes_[k].link)) old.push_back(std::move(capsule));
    };
    add_link(s);
    std::optional<Curve> link;
    if (!last(s)) {
      add_link(behind_[s]);
      if (!(link = space_.simple_link(out(s), in(s), cost(s)))) return false;
      added = capsules_of(*link);
    }
    if (!exchange(old, added)) return false;
    if (link) strokes_[behind_[s]] = {std::move(*link), std::move(strokes_[behind_[s]].stroke), true};
    behind_[before_[s]] = behind_[s];
    if (!last(s)) before_[behind_[s]] = before_[s];
    taken_out_[s] = true;
    return true;
  }

  std::vector<LinkedStroke> strokes_;
  std::vector<std::size_t> before_, behind_;  // in driving order, of those left
  std::vector<int> tries_of_;
  std::vector<char> taken_out_;
  const CarSpace& space_;
  const Context& context_;
  Witnesses witnesses_;
  std::priority_queue<std::pair<double, std::size_t>> open_;  // metres saved at most
  std::size_t tries_ = 0;
};

}  // namespace

std::vector<LinkedStroke> without_needless_strokes(std::vector<LinkedStroke> driven, const Region& target, double width,
                                                   const CarSpace& space, const Context& context, std::size_t* tries) {
  Needless needless(std::move(driven), target, width, space, context);
  std::vector<LinkedStroke> rest = needless.run();
  if (tries != nullptr) *tries = needless.tries();
  return rest;
}

}  // namespace oxturn
