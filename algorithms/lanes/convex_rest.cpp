#include "algorithms/lanes/convex_rest.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kThin = 1e-9;      // of the radius: thinner pieces are dropped
constexpr double kWideAngle = 0.4;  // radians: a disc loses little behind a chord of less
constexpr int kDepth = 4;           // divisions of a piece beyond a segment's end

bool near_all(const ConvexPiece& piece, const Point& a, const Point& b, double radius) {
  return std::ranges::all_of(
      piece, [&](const Point& p) { return (p - nearest_on_segment(p, a, b)).squaredNorm() <= radius * radius; });
}

/// The least and the greatest coordinate along a direction.
std::pair<double, double> extent(const ConvexPiece& piece, const Point& along) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Point& p : piece) {
    const double x = p.dot(along);
    low = std::min(low, x), high = std::max(high, x);
  }
  return {low, high};
}

}  // namespace

void ConvexRest::reset(const Box& box) {
  ConvexPiece& all = pieces_[0];
  all.size = 4;
  all.at[0] = box.low;
  all.at[1] = {box.high.x(), box.low.y()};
  all.at[2] = box.high;
  all.at[3] = {box.low.x(), box.high.y()};
  count_ = 1;
  fits_ = true;
}

bool ConvexRest::subtract(const Point& a, const Point& b, double radius) {
  next_count_ = 0;
  for (const ConvexPiece& piece : *this) subtract(piece, a, b, radius);
  if (!fits_) return false;
  std::copy(next_.begin(), next_.begin() + static_cast<std::ptrdiff_t>(next_count_), pieces_.begin());
  count_ = next_count_;
  return true;
}

void ConvexRest::keep(const ConvexPiece& piece) {
  if (next_count_ == kMostPieces)
    fits_ = false;
  else
    next_[next_count_++] = piece;
}

/// Beside the segment on either side, and beyond each end, less the disc there.
void ConvexRest::subtract(const ConvexPiece& piece, const Point& a, const Point& b, double radius) {
  if (near_all(piece, a, b, radius)) return;
  const double size = distance(a, b), thin = kThin * radius;
  if (size <= thin) return subtract_disc(piece, a, radius, 0);
  const Point along = (b - a) / size, across = perpendicular(along);
  const double begin = along.dot(a), end = along.dot(b), middle = across.dot(a);
  const auto [right, left] = extent(piece, across);
  const auto [back, front] = extent(piece, along);
  if (right > middle + radius - thin || left < middle - radius + thin || back > end + radius || front < begin - radius)
    return keep(piece);
  ConvexPiece rest = piece, below, above;
  if (split(rest, across, middle + radius, thin, below, above)) keep(above), rest = below;
  if (split(rest, across, middle - radius, thin, below, above)) keep(below), rest = above;
  if (extent(rest, along).second <= begin + thin) return subtract_disc(rest, a, radius, 0);
  if (split(rest, along, begin, thin, below, above)) subtract_disc(below, a, radius, 0), rest = above;
  if (extent(rest, along).first >= end - thin) return subtract_disc(rest, b, radius, 0);
  if (split(rest, along, end, thin, below, above)) subtract_disc(above, b, radius, 0);
}

/// The piece does not contain the centre. As seen from there, it is divided until it is narrow; then a chord stands for
/// the arc.
void ConvexRest::subtract_disc(const ConvexPiece& piece, const Point& centre, double radius, int depth) {
  if (near_all(piece, centre, centre, radius)) return;
  const Point* farthest =
      std::ranges::max_element(piece, {}, [&](const Point& p) { return (p - centre).squaredNorm(); });
  const Point towards = (*farthest - centre).normalized();
  const double thin = kThin * radius;
  double right = 0, left = 0;  // angles
  for (const Point& p : piece) {
    const Point d = p - centre;
    if (d.squaredNorm() <= thin * thin) continue;
    const double angle = math::atan2(cross(towards, d), towards.dot(d));
    right = std::min(right, angle), left = std::max(left, angle);
  }
  ConvexPiece below, above;
  if (left - right > kWideAngle && depth < kDepth) {
    const Point normal = perpendicular(rotated(towards, (left + right) / 2));
    if (split(piece, normal, normal.dot(centre), thin, below, above)) {
      subtract_disc(below, centre, radius, depth + 1);
      return subtract_disc(above, centre, radius, depth + 1);
    }
  }
  const Point middle = rotated(towards, (left + right) / 2);
  const double chord = middle.dot(centre) + radius * math::cos((left - right) / 2) * (1 - kThin);
  if (split(piece, middle, chord, thin, below, above) && near_all(below, centre, centre, radius)) return keep(above);
  keep(piece);
}

/// Where p . normal is less and greater than `at`. False, if one of them is thinner than the tolerance.
bool ConvexRest::split(const ConvexPiece& piece, const Point& normal, double at, double tolerance, ConvexPiece& below,
                       ConvexPiece& above) {
  const auto [low, high] = extent(piece, normal);
  if (low >= at - tolerance || high <= at + tolerance) return false;
  if (piece.size + 2 > ConvexPiece::kMost) {
    fits_ = false;
    return false;
  }
  below.size = above.size = 0;
  for (std::size_t k = 0; k < piece.size; ++k) {
    const Point &p = piece.at[k], &q = piece.at[k + 1 < piece.size ? k + 1 : 0];
    const double from = p.dot(normal) - at, to = q.dot(normal) - at;
    if (from <= 0) below.at[below.size++] = p;
    if (from >= 0) above.at[above.size++] = p;
    if ((from < 0 && to > 0) || (from > 0 && to < 0)) {
      const Point crossing = lerp(p, q, from / (from - to));
      below.at[below.size++] = crossing;
      above.at[above.size++] = crossing;
    }
  }
  return true;
}

}  // namespace oxturn
