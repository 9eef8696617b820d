#include "metrics/coverage_curve.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace oxturn {
namespace {

constexpr std::size_t kBins = 65536;
constexpr double kSamples = 1e5;  // in the target
constexpr std::size_t kFewCapsules = 32, kFewSamples = 4;
constexpr double kSpare = 1e-9;  // tile sides: rounding
constexpr std::array<std::array<int, 2>, 7> kLattices{
    {{2, 1}, {5, 3}, {13, 8}, {34, 21}, {89, 55}, {233, 144}, {610, 377}}};

std::vector<Vec> lattice(double tiles) {
  std::size_t which = 0;
  while (which + 1 < kLattices.size() && kLattices[which][0] * tiles < kSamples) ++which;
  const auto [n, step] = kLattices[which];
  std::vector<Vec> samples;
  samples.reserve(n);
  for (int i = 0; i < n; ++i) samples.push_back({(i + 0.5) / n - 0.5, ((i * step) % n + 0.5) / n - 0.5});
  return samples;
}

}  // namespace

CoverageCurve::CoverageCurve(double length_m, double tiles)
    : length_m_(length_m), samples_(lattice(tiles)), bins_(kBins, 0.0) {}

std::size_t CoverageCurve::bin_of(double path_m) const {
  if (!(length_m_ > 0)) return 0;
  const double at = path_m / length_m_ * static_cast<double>(kBins);
  return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(kBins - 1)));
}

/// Where on the path the tool reaches `p`, which the capsule contains, first.
double CoverageCurve::first_reached(const Capsule& k, Vec p) const {
  const double length = dot(k.b - k.a, k.along);
  if (!(length > 0)) return k.path_m;
  const double along = dot(p - k.a, k.along), off = cross(k.along, p - k.a);
  const double half = std::sqrt(std::max(0.0, k.radius * k.radius - off * off));
  return k.path_m + std::clamp((along - half) / length, 0.0, 1.0) * (k.end_m - k.path_m);
}

/// Finds when the samples in open_ were reached.
void CoverageCurve::collect(Vec centre, std::span<const NearCapsule> near, const std::vector<Capsule>& capsules) {
  reached_.clear();
  near_.clear();
  for (const NearCapsule& n : near)
    if (!capsules[n.capsule].visits_only) near_.push_back(&capsules[n.capsule]);
  for (Vec& p : open_) p = centre + p;
  collect_cell({centre, {0.5, 0.5}}, open_, 0);
}

/// The capsules in near_ from `from` on are all that reach the samples, which lie in the cell.
void CoverageCurve::collect_cell(const Extent& cell, std::span<Vec> samples, std::size_t from) {
  const std::size_t to = near_.size();
  if (to - from <= kFewCapsules || samples.size() <= kFewSamples) return collect_each(samples, from);
  const auto upper = std::partition(samples.begin(), samples.end(), [&](Vec p) { return p.y < cell.centre.y; });
  const Vec half = 0.5 * cell.half;
  const double span = std::sqrt(dot(half, half)) + kSpare, far = kToolRadius + span;
  const auto quarter = [&](auto first, auto last, Vec middle) {
    for (std::size_t i = from; i < to && first != last; ++i) {
      const double distance2 = squared_distance(middle, *near_[i]);
      if (distance2 < far * far) near_.push_back(near_[i]);
      const double inside = near_[i]->radius - span;
      if (inside > 0 && distance2 < inside * inside) break;  // contains the quarter
    }
    if (first != last) collect_cell({middle, half}, {first, last}, to);
    near_.resize(to);
  };
  const auto row = [&](auto first, auto last, double y) {
    const auto right = std::partition(first, last, [&](Vec p) { return p.x < cell.centre.x; });
    quarter(first, right, {cell.centre.x - half.x, y});
    quarter(right, last, {cell.centre.x + half.x, y});
  };
  row(samples.begin(), upper, cell.centre.y - half.y);
  row(upper, samples.end(), cell.centre.y + half.y);
}

/// Capsule by capsule; those that are covered are moved to the end.
void CoverageCurve::collect_each(std::span<Vec> samples, std::size_t from) {
  std::size_t open = samples.size();
  for (std::size_t c = from; c < near_.size() && open > 0; ++c) {
    const Capsule& k = *near_[c];
    for (std::size_t i = 0; i < open;) {
      if (squared_distance(samples[i], k) > k.radius * k.radius) {
        ++i;
        continue;
      }
      reached_.push_back(bin_of(first_reached(k, samples[i])));
      std::swap(samples[i], samples[--open]);
    }
  }
}

void CoverageCurve::add(Vec centre, std::span<const NearCapsule> near, const std::vector<Capsule>& capsules,
                        const TileTarget& target, double covered) {
  open_.assign(samples_.begin(), samples_.end());
  if (!target.inside()) std::erase_if(open_, [&](Vec p) { return !target.contains(p); });
  collect(centre, near, capsules);
  if (reached_.empty()) {  // a sliver between the samples
    open_.assign(samples_.begin(), samples_.end());
    collect(centre, near, capsules);
  }
  if (reached_.empty())
    for (const NearCapsule& n : near)
      if (!capsules[n.capsule].visits_only) reached_.push_back(bin_of(capsules[n.capsule].path_m));
  for (const std::size_t bin : reached_) bins_[bin] += covered / static_cast<double>(reached_.size());
}

std::vector<CoveragePoint> CoverageCurve::points(double coverage) const {
  double all = 0;
  for (const double area : bins_) all += area;
  std::vector<CoveragePoint> points{{0, 0}};
  double sum = 0;
  const double bin_m = length_m_ / static_cast<double>(kBins);
  for (std::size_t i = 0; i < kBins && length_m_ > 0; ++i) {
    if (!(bins_[i] > 0)) continue;
    const double begin = static_cast<double>(i) * bin_m, share = sum / all * coverage;
    if (begin > points.back().path_m) points.push_back({begin, share});
    sum += bins_[i];
    points.push_back({static_cast<double>(i + 1) * bin_m, sum / all * coverage});
  }
  if (all > 0) points.back().coverage = coverage;
  if (points.back().path_m < length_m_ * (1 - 0.5 / kBins)) points.push_back({length_m_, points.back().coverage});
  if (length_m_ > 0) points.back().path_m = length_m_;
  return points;
}

}  // namespace oxturn
