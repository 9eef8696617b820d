#include "geometry/overlay/swath.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>

#include "base/math.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/predicates.hpp"
#include "geometry/thinned.hpp"

namespace oxturn {
namespace {

constexpr double kMostChords = 1000;  // of half a disc
constexpr double kThinning = 0.25;    // of the chord error
constexpr std::size_t kGroup = 4;     // consecutive parts that are united at a time
constexpr double kBlunt = 0.134;      // of the radius: by which three chords of half a disc are off it
constexpr double kDeep = 2;           // times that a group's parts would cover its bounding box

/// A disc's boundary as a polygon of chords or of tangents.
class Arc {
 public:
  Arc(double radius, double chord_error, Bound bound) : radius_(radius), inside_(bound == Bound::inside) {
    // Chords stay inside by 1 - cos of half their angle, tangents stick out by 1 / cos - 1.
    const double error = chord_error / radius;
    const double cosine = inside_ ? std::max(0.0, 1 - error) : 1 / (1 + error);
    step_ = kPi / std::clamp(std::ceil(kPi / (2 * math::acos(cosine))), 2.0, kMostChords);
  }
  /// Appends the arc about `centre` from `from` (a unit vector), counter-clockwise by `angle`, in equal parts. Without
  /// the ends of tangents: they lie on the sides before and after the arc.
  void append(Ring& ring, const Point& centre, const Point& from, double angle) const {
    const int parts = static_cast<int>(std::ceil(angle / step_));
    const double part = parts > 0 ? angle / parts : 0;
    const double reach = radius_ / math::cos(part / 2);
    const auto add = [&](double far, double turn) { ring.push_back(centre + far * rotated(from, turn)); };
    if (inside_ || parts == 0) add(radius_, 0);
    for (int k = 0; k < parts; ++k) inside_ ? add(radius_, (k + 1) * part) : add(reach, (k + 0.5) * part);
  }

  double radius() const { return radius_; }

 private:
  double radius_, step_;
  bool inside_;
};

Region disc(const Point& centre, const Arc& arc) {
  Ring ring;
  arc.append(ring, centre, Point(1, 0), kPi);
  arc.append(ring, centre, Point(-1, 0), kPi);
  return {{{std::move(ring), {}}}};
}

/// The swath of a line without repeated points, in rings of a few segments each. A point's nearest point on the line
/// lies inside a segment, at a bend or at an end: rectangles, arcs on the outer side of bends and half discs at the
/// ends cover all. Every ring winds around what it covers at least once.
class LineSwath {
 public:
  LineSwath(const Polyline& line, const Arc& arc, const Arc& end)
      : line_(line), arc_(arc), end_(end), segments_(line.size() - 1) {
    left_.reserve(segments_);
    for (std::size_t i = 0; i < segments_; ++i) left_.push_back(perpendicular((line[i + 1] - line[i]).normalized()));
    turn_.assign(line.size(), 0);
    for (std::size_t v = 1; v < segments_; ++v)
      turn_[v] = math::atan2(cross(left_[v - 1], left_[v]), left_[v - 1].dot(left_[v]));
    find_mitres();
  }
  void append(std::vector<Region>& parts) const {
    for (std::size_t first = 0; first < segments_; first += kSegments)
      parts.push_back({{{part(first, std::min(first + kSegments, segments_)), {}}}});
  }

 private:
  static constexpr std::size_t kSegments = 16;  // of a ring: parts stay small, and neighbours share few edges
  static constexpr std::size_t kPerSegment = 3, kAtEnds = 24;  // vertices of a ring, as a rule

  /// On the inner side of a bend the two rectangles end where their sides meet, if these are long enough for the bends
  /// at both of their ends.
  void find_mitres() {
    mitre_.assign(line_.size(), 0);
    double left = 0, right = 0;  // what the bend before has taken of a segment's sides
    for (std::size_t v = 1; v < segments_; ++v) {
      const double before = distance(line_[v - 1], line_[v]), after = distance(line_[v], line_[v + 1]);
      const double needed = arc_.radius() * math::tan(std::abs(turn_[v]) / 2);
      const double taken = turn_[v] > 0 ? left : right;
      const bool fits = v % kSegments != 0 && needed <= before - taken && needed <= after;
      if (fits) mitre_[v] = arc_.radius() / math::cos(turn_[v] / 2);
      left = fits && turn_[v] > 0 ? needed : 0;
      right = fits && turn_[v] < 0 ? needed : 0;
    }
  }

  /// Segments `first` to `last` - 1: forwards on the right side, back on the left.
  Ring part(std::size_t first, std::size_t last) const {
    Ring ring;
    ring.reserve(kPerSegment * (last - first) + kAtEnds);
    const Point &start = line_[first], &end = line_[last];
    if (first == 0) {
      end_.append(ring, start, left_[first], kPi);
    } else {
      arc_.append(ring, start, left_[first], 0);
      arc_.append(ring, start, -left_[first], 0);
    }
    for (std::size_t v = first + 1; v < last; ++v) append_bend(ring, v, -left_[v - 1], -left_[v], turn_[v]);
    if (last == segments_) {
      end_.append(ring, end, -left_[last - 1], kPi);
    } else {  // with the arc of the bend to the next part, from or to where that begins
      const bool left_turn = turn_[last] > 0;
      arc_.append(ring, end, -left_[last - 1], std::max(turn_[last], 0.0));
      arc_.append(ring, end, left_turn ? Point(-left_[last]) : left_[last], 0);
      arc_.append(ring, end, left_turn ? left_[last - 1] : left_[last], std::max(-turn_[last], 0.0));
    }
    for (std::size_t v = last; --v > first;) append_bend(ring, v, left_[v], left_[v - 1], -turn_[v]);
    return ring;
  }

  /// From one direction about vertex v to another; `turn` is positive on the outer side.
  void append_bend(Ring& ring, std::size_t v, const Point& from, const Point& to, double turn) const {
    if (turn >= 0) {
      arc_.append(ring, line_[v], from, turn);
    } else if (mitre_[v] > 0) {
      ring.push_back(line_[v] + mitre_[v] * (from + to).normalized());
    } else {
      arc_.append(ring, line_[v], from, 0);
      ring.push_back(line_[v]);
      arc_.append(ring, line_[v], to, 0);
    }
  }

  const Polyline& line_;
  const Arc &arc_, &end_;  // of bends, of the line's ends
  std::size_t segments_;
  std::vector<Point> left_;    // of each segment: the unit vector to its left
  std::vector<double> turn_;   // of each vertex, radians to the left, -pi to pi
  std::vector<double> mitre_;  // of each vertex: metres to where the sides meet; 0: they do not
};

/// Does the robot drive straight on at b? Exact.
bool straight_on(const Point& a, const Point& b, const Point& c) {
  return (b - a).dot(c - b) > 0 && orientation(a, b, c) == 0;
}

void add_line(const Polyline& points, const Arc& arc, const Arc& end, std::vector<Region>& parts) {
  Polyline line;
  line.reserve(points.size());
  for (const Point& p : points) {
    if (!line.empty() && p == line.back()) continue;
    if (line.size() > 1 && straight_on(line[line.size() - 2], line.back(), p)) line.pop_back();
    line.push_back(p);
  }
  if (line.size() == 1) parts.push_back(disc(line.front(), arc));
  if (line.size() > 1) LineSwath(line, arc, end).append(parts);
}

double area_of(std::span<const Region> parts) {
  double sum = 0;
  for (const Region& part : parts) sum += area(part);
  return sum;
}

/// Unites consecutive parts where they lie several deep on each other, as under a zigzag much narrower than the tool:
/// all edges of all parts would cross each other.
std::vector<Region> without_deep(std::vector<Region> parts) {
  for (bool merged = true; merged;) {
    merged = false;
    std::vector<Region> fewer;
    for (std::size_t k = 0; k < parts.size(); k += kGroup) {
      const auto first = parts.begin() + static_cast<std::ptrdiff_t>(k);
      const std::span<Region> group(first, std::min(kGroup, parts.size() - k));
      Box box;
      for (const Region& part : group) box.add(bounding_box(part));
      if (group.size() > 1 && area_of(group) > kDeep * box.size().prod()) {
        fewer.push_back(unite({group.begin(), group.end()}));
        merged = true;
      } else {
        std::ranges::move(group, std::back_inserter(fewer));
      }
    }
    parts = std::move(fewer);
  }
  return parts;
}

/// `blunt`: by how much ends may fall short; 0: as arcs do.
std::vector<Region> parts_of(const std::vector<Polyline>& lines, double radius, double chord_error, Bound bound,
                             double blunt) {
  if (!(radius > 0) || !(chord_error > 0)) throw_invalid("a swath's radius and chord error must be above 0");
  const Arc arc(radius, chord_error, bound);
  // A line that is thinned may come nearer to a point by that much.
  const double thinning = std::min(kThinning * chord_error, radius / 2);
  const Arc thin_arc(radius + (bound == Bound::inside ? -thinning : thinning), chord_error - 2 * thinning, bound);
  const Arc end(radius, blunt, Bound::inside);
  std::vector<Region> parts;
  for (const Polyline& line : lines)
    if (is_dense(line, chord_error))
      add_line(thinned(line, thinning), thin_arc, blunt > 0 ? end : thin_arc, parts);
    else
      add_line(line, arc, blunt > 0 ? end : arc, parts);
  return without_deep(std::move(parts));
}

}  // namespace

std::vector<Region> swath_parts(const std::vector<Polyline>& lines, double radius, double chord_error, Bound bound) {
  return parts_of(lines, radius, chord_error, bound, 0);
}
std::vector<Region> swath_parts_with_blunt_ends(const std::vector<Polyline>& lines, double radius, double chord_error,
                                                Bound bound) {
  return parts_of(lines, radius, chord_error, bound, kBlunt * radius);
}

Region swath(const std::vector<Polyline>& lines, double radius, double chord_error, Bound bound) {
  return unite(swath_parts(lines, radius, chord_error, bound));
}

}  // namespace oxturn
