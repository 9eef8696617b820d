#include "algorithms/grid/near_lines.hpp"

#include <algorithm>

namespace oxturn {

// A bucket holds what comes within reach of its square, so that a question looks into one bucket only.
NearLines::NearLines(const Box& box, double reach) : reach_(reach), low_(box.low) {
  const Point size = box.size();
  // Never more than about a million buckets.
  side_ = std::max({2 * reach, std::sqrt(size.x() * size.y() / 1e6), size.maxCoeff() / 1e6});
  columns_ = static_cast<int>(size.x() / side_) + 1;
  rows_ = static_cast<int>(size.y() / side_) + 1;
  buckets_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
}

int NearLines::column(double x) const {
  return static_cast<int>(std::clamp((x - low_.x()) / side_, 0.0, columns_ - 1.0));
}
int NearLines::row(double y) const { return static_cast<int>(std::clamp((y - low_.y()) / side_, 0.0, rows_ - 1.0)); }

void NearLines::add(const Point& a, const Point& b) {
  const auto id = static_cast<std::uint32_t>(segments_.size());
  segments_.push_back({a, b});
  const int last_row = row(std::max(a.y(), b.y()) + reach_);
  for (int j = row(std::min(a.y(), b.y()) - reach_); j <= last_row; ++j) {
    // The stretch of the segment that can matter to this row.
    double s = 0, t = 1;
    if (const double dy = b.y() - a.y(); dy != 0) {
      const double u = (low_.y() + j * side_ - reach_ - a.y()) / dy;
      const double v = (low_.y() + (j + 1) * side_ + reach_ - a.y()) / dy;
      s = std::clamp(std::min(u, v), 0.0, 1.0);
      t = std::clamp(std::max(u, v), 0.0, 1.0);
    }
    const double x1 = a.x() + s * (b.x() - a.x()), x2 = a.x() + t * (b.x() - a.x());
    const int last_column = column(std::max(x1, x2) + reach_);
    for (int i = column(std::min(x1, x2) - reach_); i <= last_column; ++i)
      buckets_[static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i)]
          .push_back(id);
  }
}

bool NearLines::within_reach(const Point& p) const {
  const auto& bucket = buckets_[static_cast<std::size_t>(row(p.y())) * static_cast<std::size_t>(columns_) +
                                static_cast<std::size_t>(column(p.x()))];
  return std::any_of(bucket.begin(), bucket.end(), [&](std::uint32_t k) {
    const Point d = p - nearest_on_segment(p, segments_[k].a, segments_[k].b);
    return d.squaredNorm() <= reach_ * reach_;
  });
}

}  // namespace oxturn
