#include "geometry/dent.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace oxturn {
namespace {

constexpr std::size_t kLongestDent = 64;
constexpr double kLeastBend = 1e-3;  // lines that cross at less cross too vaguely
constexpr double kLeastCosine = 0.01;
constexpr double kMargin = 4;  // quanta

Point difference(const Site& a, const Site& b) {
  return {static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y};
}

/// The edges begin .. end-1, seen from the corner `begin`.
class Trial {
 public:
  Trial(const Walk& walk, std::size_t begin, double reach) : w_(walk), begin_(begin), reach_(reach) { add_edge(); }

  /// One edge more; false if the dent then cannot be written down.
  bool grow() {
    add_edge();
    const std::size_t k = size(), last = k - 1;
    const double bend = w_.bend[begin_ + last], turned = normal_[0].dot(normal_[last]);
    if (bend < kLeastBend || normal_[last - 1].dot(normal_[last]) <= 0 || turned < kLeastCosine) return false;
    if (!clear_before(last)) return false;
    for (std::size_t i = 0; i < last; ++i)
      if (!clear_past(i)) return false;

    const double sine = normal_[0].dot(along(last));
    const double to_apex = corner_[k].dot(along(last)) / sine, from_apex = corner_[k].dot(along(0)) / sine;
    const Point apex = to_apex * normal_[0];
    std::size_t lowest = 0;
    for (std::size_t j = 1; j < k; ++j)
      if (height(j, apex) < height(lowest, apex)) lowest = j;
    far_.clear();
    if (height(lowest, apex) < reach_) {  // no corner is higher above that line than the apex: all of T is near it
      far_.push_back(apex);
      return overlaps(to_apex, from_apex);
    }
    return shifted_lines();
  }

  const std::vector<Point>& far() const { return far_; }

 private:
  std::size_t size() const { return normal_.size(); }
  const Point& along(std::size_t i) const { return w_.along[begin_ + i]; }
  double height(std::size_t i, const Point& p) const { return (p - corner_[i]).dot(normal_[i]); }

  void add_edge() {
    const std::size_t edge = begin_ + size(), n = w_.ring.size();
    if (corner_.empty()) corner_.push_back({0, 0});
    corner_.push_back(difference(w_.ring[edge + 1 == n ? 0 : edge + 1], w_.ring[begin_]));
    normal_.push_back(w_.inwards(edge));
  }

  /// How far past the end of an edge what is `high` above it is no nearer to it than to the next edge.
  double next_takes_over(std::size_t corner, std::size_t next_edge, double high) const {
    const std::size_t last = w_.before(corner);
    const double half = w_.bend[corner] / (1 + w_.along[last].dot(w_.along[corner]));  // tangent of half the bend
    return std::min(high * half, w_.length[next_edge]);
  }

  /// No point before the start, nearer to edge i than to the start, has its nearest place there.
  bool clear_before(std::size_t i) const {
    const double high = height(i, corner_[0]) / (1 - normal_[0].dot(normal_[i]));  // where both are as near
    if (high > reach_ + 1) return true;
    const std::size_t corner = (begin_ + i + 1) % w_.ring.size();
    return (corner_[i + 1] - high * normal_[0]).dot(along(i)) <= next_takes_over(corner, corner, high);
  }
  bool clear_past(std::size_t i) const {
    const std::size_t last = size() - 1, corner = begin_ + i;
    const Point& end = corner_[last + 1];
    const double high = height(i, end) / (1 - normal_[last].dot(normal_[i]));
    if (high > reach_ + 1) return true;
    return (end + high * normal_[last] - corner_[i]).dot(along(i)) <= next_takes_over(corner, w_.before(corner), high);
  }

  /// Along the dent's two ends (so long), does the neighbouring edge take over some quanta before them?
  bool overlaps(double first, double last) const {
    const std::size_t n = w_.ring.size(), head = (begin_ + size()) % n;
    const auto gain = [&](double end, double sine, double neighbour) {
      return std::min(neighbour, end * sine) * sine / 2 > kMargin;
    };
    return gain(first, w_.bend[begin_], w_.length[w_.before(begin_)]) && gain(last, w_.bend[head], w_.length[head]);
  }

  /// The lower border of what lies beyond all lines shifted by the reach, from the first perpendicular to the last.
  bool shifted_lines() {
    const std::size_t k = size(), last = k - 1;
    std::size_t line = 0;
    double first = 0;
    for (std::size_t j = 0; j < k; ++j) {
      const double s = (reach_ - height(j, corner_[0])) / normal_[0].dot(normal_[j]);
      if (j == 0 || s > first) {
        first = s;
        line = j;
      }
    }
    Point at = first * normal_[0];
    far_.push_back(at);
    while (true) {
      const double to_end = (corner_[k] - at).dot(along(last)) / normal_[line].dot(normal_[last]);
      double step = to_end;
      std::size_t next = k;
      for (std::size_t l = line + 1; l < k; ++l) {
        const double s = (height(l, at) - reach_) / normal_[line].dot(along(l));
        if (s <= step) {
          step = s;
          next = l;
        }
      }
      at += std::max(step, 0.0) * along(line);
      far_.push_back(at);
      if (next == k) break;
      line = next;
    }
    return overlaps(first, (at - corner_[k]).norm());
  }

  const Walk& w_;
  std::size_t begin_;
  double reach_;
  std::vector<Point> corner_, normal_, far_;
};

}  // namespace

Walk::Walk(const std::vector<Site>& sites, double side_) : ring(sites), side(side_) {
  const std::size_t n = ring.size();
  along.resize(n);
  length.resize(n);
  bend.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point d = difference(ring[i + 1 == n ? 0 : i + 1], ring[i]);
    length[i] = d.norm();
    along[i] = d / length[i];
  }
  for (std::size_t i = 0; i < n; ++i) bend[i] = side * cross(along[before(i)], along[i]);
}

std::vector<Site> straightened(const std::vector<Site>& corners, bool ring) {
  constexpr std::size_t kMostDropped = 8;  // at a time
  const std::size_t n = corners.size(), end = ring ? n : n - 1;
  const auto dispensable = [&](std::size_t from, std::size_t to) {
    const Point chord = difference(corners[to % n], corners[from]);
    const double length = chord.norm();
    for (std::size_t k = from + 1; k < to; ++k) {
      const Point d = difference(corners[k], corners[from]);
      const double along = chord.dot(d) / length;
      if (!(std::abs(cross(chord, d)) <= length && along > 0 && along < length)) return false;
    }
    return true;
  };
  std::vector<Site> out;
  for (std::size_t i = 0; i < n;) {
    out.push_back(corners[i]);
    std::size_t next = i + 1;
    while (next < end && next - i <= kMostDropped && dispensable(i, next + 1)) ++next;
    i = next;
  }
  return ring && out.size() < 3 ? corners : out;
}

Dent longest_dent(const Walk& walk, std::size_t begin, std::size_t limit, double reach) {
  const Point origin(walk.ring[begin].x, walk.ring[begin].y);
  const Point shift = reach * walk.inwards(begin);
  Dent dent{begin, begin + 1, {shift, walk.length[begin] * walk.along[begin] + shift}};
  Trial trial(walk, begin, reach);
  for (std::size_t end = begin + 2; end <= std::min(limit, begin + kLongestDent) && trial.grow(); ++end) {
    dent.end = end;
    dent.far = trial.far();
  }
  for (Point& p : dent.far) p += origin;
  return dent;
}

}  // namespace oxturn
