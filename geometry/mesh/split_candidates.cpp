#include "geometry/mesh/split_candidates.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace oxturn {
namespace {

constexpr double kTolerance = 1e-7;     // of the extent: above what rounded positions of vertices are off
constexpr double kRelative = 1e-6;      // of a time
constexpr double kFirstStep = 1.0 / 8;  // cells of the grid
constexpr int kBisections = 4;          // of a vertex's life
constexpr double kParallel = 1e-3;      // the rate below which it is open where a vertex meets a front

}  // namespace

SplitCandidates::SplitCandidates(std::vector<Edge> edges)
    : edges_(std::move(edges)), grid_(edges_.size(), [this](std::size_t i) {
        return std::array{edges_[i].a, edges_[i].b};
      }) {
  if (edges_.empty()) return;
  tolerance_ = kTolerance * (grid_.high() - grid_.low()).maxCoeff();
  fastest_ = fastest_vertex();
}

double SplitCandidates::fastest_vertex() const {
  double least = 1;  // cosine of half a turn
  for (std::size_t k = 0, first = 0; k < edges_.size(); ++k) {
    const bool closes = edges_[k].b == edges_[first].a;
    const Point before = normal(k), after = normal(closes ? first : k + 1);
    if (cross(before, after) < 0) least = std::min(least, std::sqrt(std::max(0.0, (1 + before.dot(after)) / 2)));
    if (closes) first = k + 1;
  }
  return least > 0 ? 1 / least : std::numeric_limits<double>::infinity();
}

/// Certainly, by some edge.
bool SplitCandidates::swept(const Point& p, double time) const {
  if ((p - grid_.low()).minCoeff() < -tolerance_ || (grid_.high() - p).minCoeff() < -tolerance_) return true;
  const double reach = time * (1 - kRelative) - tolerance_;
  if (reach <= 0) return false;
  return grid_.visit_items(std::array{p}, reach,
                           [&](std::uint32_t e) { return distance_to_segment(p, edges_[e].a, edges_[e].b) < reach; });
}

/// Seconds after which a vertex has ended, certainly.
double SplitCandidates::longest_life(const Motion& motion) const {
  double lived = 0, life = kFirstStep * grid_.cell();
  while (!swept(motion.after(life), motion.time + life)) {
    lived = life;
    life *= 2;
  }
  for (int k = 0; k < kBisections; ++k) {
    const double middle = (lived + life) / 2;
    (swept(motion.after(middle), motion.time + middle) ? life : lived) = middle;
  }
  return life;
}

bool SplitCandidates::may_meet(const Motion& motion, double life, const Edge& edge) const {
  const Point inwards = perpendicular((edge.b - edge.a).normalized());
  const double ahead = inwards.dot(motion.at - edge.a) - motion.time, rate = 1 - inwards.dot(motion.velocity);
  const double slack = tolerance_ * (1 + std::abs(rate));
  if (ahead < -slack || ahead > rate * life + slack) return false;
  if (rate < kParallel) return true;
  const double met = std::clamp(ahead / rate, 0.0, life);
  const double off = slack / rate * motion.velocity.norm() + tolerance_;
  return distance_to_segment(motion.after(met), edge.a, edge.b) <=
         fastest_ * (motion.time + met) * (1 + kRelative) + off;
}

std::vector<std::uint32_t> SplitCandidates::all() const {
  std::vector<std::uint32_t> found(edges_.size());
  std::iota(found.begin(), found.end(), std::uint32_t{0});
  return found;
}

std::vector<std::uint32_t> SplitCandidates::find(std::size_t e0, std::size_t e1, const Point& at, double time) const {
  const Point sum = normal(e0) + normal(e1);
  const double cosine = sum.squaredNorm() / 2;  // 1 + that of the turn
  if (!(cosine > kRelative)) return all();
  const Motion motion{at, time, sum / cosine};
  const double life = longest_life(motion), reach = fastest_ * (time + life) + tolerance_;
  if (!(reach < (grid_.high() - grid_.low()).maxCoeff())) return all();
  std::vector<std::uint32_t> found;
  grid_.visit_items(std::array{motion.at, motion.after(life)}, reach, [&](std::uint32_t e) {
    if (may_meet(motion, life, edges_[e])) found.push_back(e);
    return false;
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace oxturn
