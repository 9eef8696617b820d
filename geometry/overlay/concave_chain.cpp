#include "geometry/overlay/concave_chain.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

constexpr std::size_t kLongestConcaveChain = 64;
constexpr double kLeastBend = 3e-5;    // sine: where lines cross at less, the crossing is ill-conditioned
constexpr double kLeastCosine = 0.01;  // of the whole chain's turn, which must stay below a quarter
constexpr double kMargin = 4;          // quanta of overlap with the neighbouring strips

Point difference(const LatticePoint& a, const LatticePoint& b) {
  return {static_cast<double>(a.x) - b.x, static_cast<double>(a.y) - b.y};
}

/// A chain of edges that may grow. Coordinates are relative to its first vertex.
class GrowingChain {
 public:
  GrowingChain(const Walk& walk, std::size_t begin, double reach) : walk_(walk), begin_(begin), reach_(reach) {
    add_edge();
  }

  /// Adds the next edge. If the conditions do not hold then, changes nothing and returns false.
  bool grow() {
    add_edge();
    if (valid()) return true;
    vertex_.pop_back();
    normal_.pop_back();
    return false;
  }

  std::vector<Point> far_side() const {
    if (size() == 1) return {reach_ * normal_[0], vertex_[1] + reach_ * normal_[0]};
    const Point apex = perpendiculars_cross();
    if (height(lowest(apex), apex) < reach_) return {apex};
    return envelope();
  }

 private:
  std::size_t size() const { return normal_.size(); }
  const Point& along(std::size_t i) const { return walk_.along[begin_ + i]; }
  /// Of p above the line of edge i.
  double height(std::size_t i, const Point& p) const { return (p - vertex_[i]).dot(normal_[i]); }

  void add_edge() {
    const std::size_t edge = begin_ + size(), n = walk_.ring.size();
    if (vertex_.empty()) vertex_.push_back({0, 0});
    vertex_.push_back(difference(walk_.ring[edge + 1 == n ? 0 : edge + 1], walk_.ring[begin_]));
    normal_.push_back(walk_.normal(edge));
  }

  bool valid() const {
    const std::size_t last = size() - 1;
    if (walk_.bend[begin_ + last] < kLeastBend || normal_[last - 1].dot(normal_[last]) <= 0 ||
        normal_[0].dot(normal_[last]) < kLeastCosine || !clear_before(last))
      return false;
    for (std::size_t i = 0; i < last; ++i)
      if (!clear_past(i)) return false;
    const Point apex = perpendiculars_cross();
    if (height(lowest(apex), apex) < reach_) return overlaps_neighbours(apex.norm(), distance(apex, vertex_[last + 1]));
    return overlaps_neighbours(depth(0, vertex_[0]).length, depth(last, vertex_[last + 1]).length);
  }

  /// Where the perpendiculars at the two ends cross.
  Point perpendiculars_cross() const {
    const std::size_t last = size() - 1;
    return vertex_[last + 1].dot(along(last)) / normal_[0].dot(along(last)) * normal_[0];
  }
  /// The line above which p is lowest.
  std::size_t lowest(const Point& p) const {
    std::size_t least = 0;
    for (std::size_t j = 1; j < size(); ++j)
      if (height(j, p) < height(least, p)) least = j;
    return least;
  }
  struct Depth {
    double length;
    std::size_t line;
  };
  /// How far it is from p along the normal of an edge to where all lines are `reach` behind, and the last of these
  /// lines.
  Depth depth(std::size_t edge, const Point& p) const {
    Depth most{-1e300, 0};
    for (std::size_t j = 0; j < size(); ++j) {
      const double s = (reach_ - height(j, p)) / normal_[edge].dot(normal_[j]);
      if (s > most.length) most = {s, j};
    }
    return most;
  }

  /// How far before the common vertex of two edges a point at this height above the one is no nearer to it than to the
  /// other.
  double neighbour_takes_over(std::size_t vertex, std::size_t neighbour, double height_above) const {
    const std::size_t last = walk_.before(vertex);
    const double tangent_of_half_bend = walk_.bend[vertex] / (1 + walk_.along[last].dot(walk_.along[vertex]));
    return std::min(height_above * tangent_of_half_bend, walk_.length[neighbour]);
  }
  double one_minus_cosine(std::size_t i, std::size_t j) const { return (normal_[i] - normal_[j]).squaredNorm() / 2; }

  /// Is there no point on the perpendicular at the chain's start whose nearest point is on edge i? From a certain
  /// height on, such points are as near to line i as to the start; by then edge i + 1 must be nearer, or they are out
  /// of reach.
  bool clear_before(std::size_t i) const {
    const double high = height(i, vertex_[0]) / one_minus_cosine(0, i);
    if (high > reach_ + 1) return true;
    const std::size_t vertex = (begin_ + i + 1) % walk_.ring.size();
    return (vertex_[i + 1] - high * normal_[0]).dot(along(i)) <= neighbour_takes_over(vertex, vertex, high);
  }
  /// The same at the chain's end, with edge i - 1.
  bool clear_past(std::size_t i) const {
    const std::size_t last = size() - 1, vertex = begin_ + i;
    const Point& end = vertex_[last + 1];
    const double high = height(i, end) / one_minus_cosine(i, last);
    if (high > reach_ + 1) return true;
    return (end + high * normal_[last] - vertex_[i]).dot(along(i)) <=
           neighbour_takes_over(vertex, walk_.before(vertex), high);
  }

  /// Do the strips of the edges before and after the chain overlap its end perpendiculars, of the given lengths, by
  /// more than the margin?
  bool overlaps_neighbours(double first, double last) const {
    const std::size_t head = (begin_ + size()) % walk_.ring.size();
    const auto enough = [&](double end, double sine, double neighbour) {
      return std::min(neighbour, end * sine) * sine / 2 > kMargin;
    };
    return enough(first, walk_.bend[begin_], walk_.length[walk_.before(begin_)]) &&
           enough(last, walk_.bend[head], walk_.length[head]);
  }

  /// The lower boundary of what lies beyond all lines shifted by the reach, from the first perpendicular to the last.
  std::vector<Point> envelope() const {
    const std::size_t k = size(), last = k - 1;
    const Depth start = depth(0, vertex_[0]);
    std::size_t line = start.line;
    Point at = start.length * normal_[0];
    std::vector<Point> out{at};
    while (line < k) {
      double step = (vertex_[k] - at).dot(along(last)) / normal_[line].dot(normal_[last]);
      std::size_t next = k;  // the last perpendicular
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

  const Walk& walk_;
  std::size_t begin_;
  double reach_;
  std::vector<Point> vertex_, normal_;  // one vertex more than edges
};

/// Are all points strictly between positions `from` and `to` (cyclic) within a quantum of the segment between those
/// two?
bool dispensable(const std::vector<LatticePoint>& points, std::size_t from, std::size_t to) {
  const Point chord = difference(points[to % points.size()], points[from]);
  const double length = chord.norm();
  for (std::size_t k = from + 1; k < to; ++k) {
    const Point d = difference(points[k], points[from]);
    const double along = chord.dot(d) / length;
    if (!(std::abs(cross(chord, d)) <= length && along > 0 && along < length)) return false;
  }
  return true;
}

/// Leaves out points, greedily from the first; `end` is the last position that a segment may end at.
std::vector<LatticePoint> straightened(const std::vector<LatticePoint>& points, std::size_t end) {
  constexpr std::size_t kMostDropped = 8;  // in one segment, which bounds the cost
  std::vector<LatticePoint> out;
  for (std::size_t i = 0; i < points.size();) {
    out.push_back(points[i]);
    std::size_t next = i + 1;
    while (next < end && next - i <= kMostDropped && dispensable(points, i, next + 1)) ++next;
    i = next;
  }
  return out;
}

}  // namespace

Walk::Walk(const std::vector<LatticePoint>& points, double side_) : ring(points), side(side_) {
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

std::vector<LatticePoint> straightened_ring(const std::vector<LatticePoint>& ring) {
  std::vector<LatticePoint> out = straightened(ring, ring.size());
  return out.size() < 3 ? ring : out;
}

std::vector<LatticePoint> straightened_line(const std::vector<LatticePoint>& line) {
  return straightened(line, line.size() - 1);
}

ConcaveChain longest_concave_chain(const Walk& walk, std::size_t begin, std::size_t limit, double reach) {
  GrowingChain chain(walk, begin, reach);
  std::size_t end = begin + 1;
  while (end < std::min(limit, begin + kLongestConcaveChain) && chain.grow()) ++end;
  ConcaveChain out{begin, end, chain.far_side()};
  for (Point& p : out.far) p += Point(walk.ring[begin].x, walk.ring[begin].y);
  return out;
}

}  // namespace oxturn
