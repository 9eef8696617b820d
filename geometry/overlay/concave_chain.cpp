#include "geometry/overlay/concave_chain.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr std::size_t kLongestConcaveChain = 64;
constexpr double kLeastBend = 3e-5;  // lines that cross at less cross too vaguely
constexpr double kLeastCosine = 0.01;
constexpr double kMargin = 4;  // quanta

Point difference(const Site& a, const Site& b) {
  return {static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y};
}

/// The edges begin .. end-1, seen from the corner `begin`.
class Trial {
 public:
  Trial(const Walk& walk, std::size_t begin, double reach) : w_(walk), begin_(begin), reach_(reach) { add_edge(); }

  /// One edge more; if the dent then cannot be written down, nothing changes and the answer is false.
  bool grow() {
    add_edge();
    if (fits()) return true;
    corner_.pop_back();
    normal_.pop_back();
    return false;
  }

  std::vector<Point> far() const {
    if (size() == 1) return {reach_ * normal_[0], corner_[1] + reach_ * normal_[0]};
    const Point apex = crossing();
    if (height(lowest(apex), apex) < reach_) return {apex};
    return shifted_lines();
  }

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

  /// What is to be held against a way along normal j, so that it comes to be as far from line i as it is long.
  double half_turn(std::size_t i, std::size_t j) const { return (normal_[i] - normal_[j]).squaredNorm() / 2; }

  bool fits() const {
    const std::size_t last = size() - 1;
    if (w_.bend[begin_ + last] < kLeastBend || normal_[last - 1].dot(normal_[last]) <= 0 ||
        normal_[0].dot(normal_[last]) < kLeastCosine || !clear_before(last))
      return false;
    for (std::size_t i = 0; i < last; ++i)
      if (!clear_past(i)) return false;
    const Point apex = crossing();
    if (height(lowest(apex), apex) < reach_) return overlaps(apex.norm(), distance(apex, corner_[last + 1]));
    return overlaps(depth(0, corner_[0]), depth(last, corner_[last + 1]));
  }

  /// Where the perpendiculars at the two ends cross. No corner is higher above any of the lines.
  Point crossing() const {
    const std::size_t last = size() - 1;
    return corner_[last + 1].dot(along(last)) / normal_[0].dot(along(last)) * normal_[0];
  }
  std::size_t lowest(const Point& p) const {
    std::size_t least = 0;
    for (std::size_t j = 1; j < size(); ++j)
      if (height(j, p) < height(least, p)) least = j;
    return least;
  }
  /// How far it is from p along the normal of an edge until all lines are `reach` behind; the last of them.
  double depth(std::size_t edge, const Point& p, std::size_t* line = nullptr) const {
    double most = -1e300;
    for (std::size_t j = 0; j < size(); ++j) {
      const double s = (reach_ - height(j, p)) / normal_[edge].dot(normal_[j]);
      if (s <= most) continue;
      most = s;
      if (line != nullptr) *line = j;
    }
    return most;
  }

  /// No point before the start, nearer to edge i than to the start, has its nearest place there.
  bool clear_before(std::size_t i) const {
    const double high = height(i, corner_[0]) / half_turn(0, i);  // where both are as near
    if (high > reach_ + 1) return true;
    const std::size_t corner = (begin_ + i + 1) % w_.ring.size();
    return (corner_[i + 1] - high * normal_[0]).dot(along(i)) <= next_takes_over(corner, corner, high);
  }
  bool clear_past(std::size_t i) const {
    const std::size_t last = size() - 1, corner = begin_ + i;
    const Point& end = corner_[last + 1];
    const double high = height(i, end) / half_turn(i, last);
    if (high > reach_ + 1) return true;
    return (end + high * normal_[last] - corner_[i]).dot(along(i)) <= next_takes_over(corner, w_.before(corner), high);
  }

  /// Along the dent's two ends (so long), does the neighbouring edge take over some quanta before them?
  bool overlaps(double first, double last) const {
    const std::size_t head = (begin_ + size()) % w_.ring.size();
    const auto gain = [&](double end, double sine, double neighbour) {
      return std::min(neighbour, end * sine) * sine / 2 > kMargin;
    };
    return gain(first, w_.bend[begin_], w_.length[w_.before(begin_)]) && gain(last, w_.bend[head], w_.length[head]);
  }

  /// The lower border of what lies beyond all lines shifted by the reach, from the first perpendicular to the last.
  std::vector<Point> shifted_lines() const {
    const std::size_t k = size(), last = k - 1;
    std::size_t line = 0;
    Point at = depth(0, corner_[0], &line) * normal_[0];
    std::vector<Point> out{at};
    while (line < k) {
      double step = (corner_[k] - at).dot(along(last)) / normal_[line].dot(normal_[last]);
      std::size_t next = k;
      for (std::size_t l = line + 1; l < k; ++l) {
        const double s = (height(l, at) - reach_) / normal_[line].dot(along(l));
        if (s > step) continue;
        step = s;
        next = l;
      }
      at += std::max(step, 0.0) * along(line);
      out.push_back(at);
      line = next;
    }
    return out;
  }

  const Walk& w_;
  std::size_t begin_;
  double reach_;
  std::vector<Point> corner_, normal_;
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

ConcaveChain longest_concave_chain(const Walk& walk, std::size_t begin, std::size_t limit, double reach) {
  Trial trial(walk, begin, reach);
  std::size_t end = begin + 1;
  while (end < std::min(limit, begin + kLongestConcaveChain) && trial.grow()) ++end;
  ConcaveChain dent{begin, end, trial.far()};
  for (Point& p : dent.far) p += Point(walk.ring[begin].x, walk.ring[begin].y);
  return dent;
}

}  // namespace oxturn
