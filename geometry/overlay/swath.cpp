#include "geometry/overlay/swath.hpp"

#include <algorithm>
#include <cmath>

#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

constexpr double kMostChords = 1000;  // of half a disc

/// A disc's boundary as a polygon of chords or of tangents.
class Arc {
 public:
  Arc(double radius, double chord_error, Bound bound) : radius_(radius), inside_(bound == Bound::inside) {
    // Chords stay inside by 1 - cos of half their angle, tangents stick out by 1 / cos - 1.
    const double error = chord_error / radius;
    const double cosine = inside_ ? std::max(0.0, 1 - error) : 1 / (1 + error);
    step_ = kPi / std::clamp(std::ceil(kPi / (2 * std::acos(cosine))), 2.0, kMostChords);
  }
  /// Appends the arc about `centre` from `from` (a unit vector), counter-clockwise by `angle`, in equal parts.
  void append(Ring& ring, const Point& centre, const Point& from, double angle) const {
    const int parts = static_cast<int>(std::ceil(angle / step_));
    const double part = parts > 0 ? angle / parts : 0;
    const double reach = radius_ / std::cos(part / 2);
    const auto add = [&](double far, double turn) { ring.push_back(centre + far * rotated(from, turn)); };
    add(radius_, 0);
    for (int k = 0; k < parts; ++k) inside_ ? add(radius_, (k + 1) * part) : add(reach, (k + 0.5) * part);
    if (!inside_ && parts > 0) add(radius_, angle);
  }

 private:
  double radius_, step_;
  bool inside_;
};

/// The swath of a segment without its ends, and about b the arc that the next segment leaves open if the line turns
/// there by `turn` radians (positive: to the left), -pi to pi.
Region piece(const Point& a, const Point& b, const Point& along, double turn, const Arc& arc) {
  const Point left = perpendicular(along), right = -left;
  Ring ring;
  arc.append(ring, a, left, 0);
  arc.append(ring, a, right, 0);
  if (turn > 0) {  // the gap is on the right
    arc.append(ring, b, right, turn);
    arc.append(ring, b, left, 0);
  } else {
    arc.append(ring, b, right, 0);
    arc.append(ring, b, rotated(left, turn), -turn);
  }
  return {{{std::move(ring), {}}}};
}

Region disc(const Point& centre, const Arc& arc) {
  Ring ring;
  arc.append(ring, centre, Point(1, 0), kPi);
  arc.append(ring, centre, Point(-1, 0), kPi);
  return {{{std::move(ring), {}}}};
}

void add_line(const Polyline& points, const Arc& arc, std::vector<Region>& pieces) {
  Polyline line;
  for (const Point& p : points)
    if (line.empty() || p != line.back()) line.push_back(p);
  if (line.empty()) return;
  pieces.push_back(disc(line.front(), arc));
  if (line.size() > 1) pieces.push_back(disc(line.back(), arc));
  const auto direction = [&](std::size_t i) { return Point((line[i + 1] - line[i]).normalized()); };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point along = direction(i), next = i + 2 < line.size() ? direction(i + 1) : along;
    pieces.push_back(piece(line[i], line[i + 1], along, std::atan2(cross(along, next), along.dot(next)), arc));
  }
}

}  // namespace

Region swath(const std::vector<Polyline>& lines, double radius, double chord_error, Bound bound) {
  if (!(radius > 0) || !(chord_error > 0)) throw_invalid("a swath's radius and chord error must be above 0");
  const Arc arc(radius, chord_error, bound);
  std::vector<Region> pieces;
  for (const Polyline& line : lines) add_line(line, arc, pieces);
  return unite(pieces);
}

}  // namespace oxturn
