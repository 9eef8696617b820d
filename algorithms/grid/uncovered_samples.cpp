#include "algorithms/grid/uncovered_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace oxturn {

namespace {

// Samples; a sample as close as that to the boundary of what is covered counts as covered, whatever rounding says.
// Paths run along the lattice at distances of whole samples, so this is usual.
constexpr double kTouches = 1e-6;

}  // namespace

UncoveredSamples::UncoveredSamples(const GridGraph& cells, const Region& free, double reach)
    : cells_(cells),
      reach_(4 * reach / cells.side() + kTouches),
      bits_(rasterise(free, cells, 4, 1, CellRule::centre)) {}

// A row of samples meets the capsule in one interval. Its right end lies on the right flank, whose foot on the segment
// is at t, or on the disc around the end of the segment that is nearest to that foot; its left end likewise.
void UncoveredSamples::cover(const Point& a, const Point& b) {
  const Point p = coordinates(a), d = coordinates(b) - p;
  const double r = reach_, length = d.norm();
  const int bottom = std::max(0, static_cast<int>(std::ceil(p.y() + std::min(0.0, d.y()) - r)));
  const int top = std::min(bits_.rows - 1, static_cast<int>(std::floor(p.y() + std::max(0.0, d.y()) + r)));
  const double rise = length > 0 ? std::copysign(d.x() / length, d.x() * d.y()) : 0;  // of the left flank's foot
  for (int j = bottom; j <= top; ++j) {
    // How far along the segment the foot is, and how far the disc around it reaches in this row.
    const auto end = [&](double side) {
      double t = side * d.x() > 0 ? 1 : 0;
      if (d.y() != 0) t = std::clamp((j - p.y() + side * r * rise) / d.y(), 0.0, 1.0);
      const double off = j - p.y() - t * d.y();
      return p.x() + t * d.x() + side * std::sqrt(std::max(0.0, r * r - off * off));
    };
    const int left = std::max(0, static_cast<int>(std::ceil(end(-1))));
    const int right = std::min(bits_.columns - 1, static_cast<int>(std::floor(end(1))));
    if (left <= right) std::memset(&bits_.bits[bits_.at(left, j)], 0, static_cast<std::size_t>(right - left + 1));
  }
}

bool UncoveredSamples::any_uncovered(int i, int j) const {
  std::uint32_t any = 0;
  for (int k = 0; k < kPerCell; k += 4) {
    std::uint32_t four;
    std::memcpy(&four, &bits_.bits[bits_.at(column(i, k), row(j, k))], 4);
    any |= four;
  }
  return any != 0;
}

}  // namespace oxturn
