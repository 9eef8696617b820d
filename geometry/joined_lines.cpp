#include "geometry/joined_lines.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "geometry/ring_boxes.hpp"
#include "geometry/thinned.hpp"

namespace oxturn {
namespace {

/// Moves ends that differ by less than `tolerance` to one of them.
void unify_ends(std::vector<Polyline>& lines, double tolerance) {
  std::vector<Box> boxes;
  for (const Polyline& line : lines)
    for (const Point& end : {line.front(), line.back()}) {
      boxes.emplace_back();
      boxes.back().add(end);
      boxes.back().grow(tolerance / 2);
    }
  const BoxIndex index(boxes);
  std::vector<bool> done(boxes.size(), false);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (done[i]) continue;
    const Point at = i % 2 == 0 ? lines[i / 2].front() : lines[i / 2].back();
    for (const std::uint32_t k : index.overlapping(boxes[i])) {
      if (!done[k]) (k % 2 == 0 ? lines[k / 2].front() : lines[k / 2].back()) = at;
      done[k] = true;
    }
  }
}

/// Erases lines that are points or repeat another: two pieces of the same ends are the same but for rounding.
void erase_superfluous(std::vector<Polyline>& lines, double tolerance) {
  std::erase_if(lines, [&](const Polyline& line) {
    return line.size() < 2 || (line.front() == line.back() && length(line) <= 2 * tolerance);
  });
  const auto less = [](const Polyline& a, const Polyline& b) {
    if (a.front() != b.front()) return before(a.front(), b.front());
    return before(a.back(), b.back());
  };
  for (Polyline& line : lines)
    if (before(line.back(), line.front())) std::reverse(line.begin(), line.end());
  std::stable_sort(lines.begin(), lines.end(), less);
  const auto same = [&](const Polyline& a, const Polyline& b) {
    if (a.front() != b.front() || a.back() != b.back()) return false;
    return std::all_of(b.begin(), b.end(), [&](const Point& p) {
      for (std::size_t i = 1; i < a.size(); ++i)
        if (distance_to_segment(p, a[i - 1], a[i]) <= tolerance) return true;
      return false;
    });
  };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
}

class Joiner {
 public:
  explicit Joiner(const std::vector<Polyline>& lines) : lines_(lines), done_(lines.size(), false) {
    for (std::size_t i = 0; i < lines.size(); ++i) ends_.insert(ends_.end(), {{i, true}, {i, false}});
    std::stable_sort(ends_.begin(), ends_.end(), [&](const End& a, const End& b) { return before(at(a), at(b)); });
    for (std::size_t i = 0, k = 0; i < ends_.size(); i = k) {
      while (k < ends_.size() && at(ends_[k]) == at(ends_[i])) ++k;
      if (k - i != 2) continue;
      next_[ends_[i]] = ends_[i + 1];
      next_[ends_[i + 1]] = ends_[i];
    }
  }

  std::vector<Polyline> run() {
    std::vector<Polyline> whole;
    for (const bool rings : {false, true})
      for (const End& first : ends_)
        if ((rings || next_.count(first) == 0) && !done_[first.first]) whole.push_back(from(first));
    return whole;
  }

 private:
  using End = std::pair<std::size_t, bool>;  // a line, and whether it is its beginning

  const Point& at(const End& end) const { return end.second ? lines_[end.first].front() : lines_[end.first].back(); }
  /// The line that begins at the end.
  Polyline from(const End& first) {
    Polyline line{at(first)};
    for (std::optional<End> end = first; end && !done_[end->first];) {
      const Polyline& more = lines_[end->first];
      done_[end->first] = true;
      if (end->second)
        line.insert(line.end(), more.begin() + 1, more.end());
      else
        line.insert(line.end(), more.rbegin() + 1, more.rend());
      const auto found = next_.find({end->first, !end->second});
      end = found == next_.end() ? std::nullopt : std::optional(found->second);
    }
    return line;
  }

  const std::vector<Polyline>& lines_;
  std::vector<bool> done_;
  std::vector<End> ends_;
  std::map<End, End> next_;
};

}  // namespace

std::vector<Polyline> joined_lines(std::vector<Polyline> lines, double tolerance) {
  std::erase_if(lines, [](const Polyline& line) { return line.empty(); });
  unify_ends(lines, tolerance);
  erase_superfluous(lines, tolerance);
  std::vector<Polyline> whole = Joiner(lines).run();
  for (Polyline& line : whole) line = thinned(line, tolerance);
  return whole;
}

std::vector<Point> common_ends(const std::vector<Polyline>& lines, std::size_t least) {
  std::vector<Point> ends, common;
  for (const Polyline& line : lines)
    if (!line.empty()) ends.insert(ends.end(), {line.front(), line.back()});
  std::sort(ends.begin(), ends.end(), before);
  for (std::size_t i = 0, k = 0; i < ends.size(); i = k) {
    while (k < ends.size() && ends[k] == ends[i]) ++k;
    if (k - i >= least) common.push_back(ends[i]);
  }
  return common;
}

}  // namespace oxturn
