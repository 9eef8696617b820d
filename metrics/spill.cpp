#include "metrics/spill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>

#include "base/math.hpp"
#include "metrics/disc_area.hpp"

namespace oxturn {
namespace {

// All in tool widths, or their squares: the target is scaled.
constexpr double kRadius = 0.5;
constexpr double kSpacing = 0.25;     // of candidates on the boundary
constexpr double kLeastSpill = 2e-3;  // of a witness
constexpr double kTolerance = 1e-3;   // of the least spill
constexpr int kMostSquares = 1500;    // that one search divides
constexpr double kMostWork = 1e8;     // edges that are looked at: about a second of processor time
constexpr double kCell = 1.5;         // half the side of a cell at most
constexpr int kChords = 64;           // of the polygon about the first disc
constexpr double kRounding = 1e-9;
constexpr std::array kApart{0.4, 0.55, 0.7, 0.85, 1.0};  // least distances of witnesses that are tried
constexpr std::array kDistances{0.004, 0.01, 0.02, 0.035, 0.055, 0.08, 0.11, 0.15, 0.2, 0.26, 0.33, 0.4, 0.5};

using Edges = std::vector<std::pair<Point, Point>>;

/// Counts the edges that are looked at. Searches that end early, for want of work, give a smaller bound.
class Work {
 public:
  explicit Work(double most) : left_(most) {}
  void spend(std::size_t edges) { left_ -= static_cast<double>(edges); }
  bool is_done() const { return left_ <= 0; }

 private:
  double left_;
};

double disc_area(const Edges& edges, const Point& centre, double radius) {
  DiscArea common(centre, radius);
  for (const auto& [a, b] : edges) common.add(a, b);
  return std::max(0.0, common.area());
}

void add_edges(Edges& edges, const Ring& ring, bool reversed) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
    edges.push_back(reversed ? std::pair(b, a) : std::pair(a, b));
  }
}

/// The part of a ring in a convex cell.
Ring clipped_to(Ring ring, const Ring& cell) {
  for (std::size_t i = 0; i < cell.size() && !ring.empty(); ++i)
    ring = clipped_left(ring, cell[i], cell[(i + 1) % cell.size()]);
  return ring;
}

/// What is to be covered, and a convex polygon outside of which the tool spills: it holds the disc at the start. Empty:
/// the start does not matter.
struct Scene {
  std::vector<Ring> target;
  Ring first;
};

/// The target and its complement in a witness's cell; the complement without what the first disc may hold.
struct CellEdges {
  CellEdges(const Scene& scene, const Ring& cell) {
    add_edges(outside, cell, false);
    for (const Ring& ring : scene.target) {
      const Ring part = clipped_to(ring, cell);
      add_edges(inside, part, false);
      add_edges(outside, part, true);
    }
    const Ring first = clipped_to(scene.first, cell);
    if (first.empty()) return;
    add_edges(outside, first, true);
    for (const Ring& ring : scene.target) add_edges(outside, clipped_to(ring, first), false);
  }
  Edges inside, outside;
};

/// A certified lower bound of the least disc_area(outside, c, kRadius) over all c within `reach` of the witness.
double least_disc_area(const Edges& outside, const Point& witness, double reach, double tolerance, Work& work) {
  struct Square {
    double bound;
    Point middle;
    double half;
    bool operator>(const Square& o) const { return bound > o.bound; }
  };
  double best = disc_area(outside, witness, kRadius);
  const auto square = [&](const Point& middle, double half) -> Square {
    work.spend(2 * outside.size());
    const double away = half * std::sqrt(2.0), from = distance(middle, witness);
    const Point centre = from <= reach ? middle : Point(witness + reach / from * (middle - witness));
    DiscArea whole(centre, kRadius), inner(centre, std::max(0.0, kRadius - away));
    for (const auto& [a, b] : outside) {
      whole.add(a, b);
      if (away < kRadius) inner.add(a, b);
    }
    const double swept = std::max(0.0, whole.area());
    best = std::min(best, swept);
    // A centre in reach is no farther from the nearest such point to `middle` than from `middle` itself.
    return {std::max({0.0, swept - 2 * kRadius * away, away < kRadius ? inner.area() : 0}), middle, half};
  };
  std::priority_queue<Square, std::vector<Square>, std::greater<>> open;
  open.push(square(witness, reach));
  for (int divided = 0; divided < kMostSquares && !work.is_done(); ++divided) {
    const Square top = open.top();
    if (top.bound >= best - tolerance) break;
    open.pop();
    const double half = top.half / 2;
    for (const Point& corner : {Point(-half, -half), Point(half, -half), Point(-half, half), Point(half, half)}) {
      const Point middle = top.middle + corner;
      if (distance(middle, witness) - half * std::sqrt(2.0) > reach) continue;
      const Square part = square(middle, half);
      if (part.bound < best) open.push(part);
    }
    if (open.empty()) return std::max(0.0, best - tolerance);
  }
  return std::max(0.0, std::min(open.top().bound, best) - kRounding);
}

Ring box_about(const Point& p, double half) {
  return {p + Point(-half, -half), p + Point(half, -half), p + Point(half, half), p + Point(-half, half)};
}

/// A polygon that holds the tool's disc.
Ring around_disc(const Point& centre) {
  Ring ring;
  for (int k = 0; k < kChords; ++k)
    ring.push_back(centre + rotated({kRadius / math::cos(kPi / kChords) * (1 + kRounding), 0}, 2 * kPi * k / kChords));
  return ring;
}

/// The Voronoi cell of witness k within a box.
Ring voronoi_cell(const std::vector<Point>& witnesses, std::size_t k) {
  const Point& p = witnesses[k];
  Ring cell = box_about(p, kCell);
  for (std::size_t o = 0; o < witnesses.size(); ++o) {
    const Point between = witnesses[o] - p;
    if (o == k || between.cwiseAbs().maxCoeff() > 2 * kCell) continue;
    const Point middle = p + between / 2;
    cell = clipped_left(cell, middle, middle + Point(-between.y(), between.x()));
  }
  return cell;
}

struct Candidate {
  Point at;
  double spill;
};

/// Vertices, and points between them, in an order in which neighbours are far from each other: where work ends early,
/// what was looked at lies everywhere along the boundary.
Polyline boundary_points(const std::vector<Ring>& target) {
  Polyline points;
  for (const Ring& ring : target)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      const auto steps = static_cast<std::size_t>(std::ceil(distance(a, b) / kSpacing));
      for (std::size_t k = 0; k < steps; ++k)
        points.push_back(lerp(a, b, static_cast<double>(k) / static_cast<double>(steps)));
    }
  const std::size_t n = points.size();
  std::size_t stride = std::max<std::size_t>(1, n * 5 / 13);  // about the golden section
  while (std::gcd(stride, n) != 1) ++stride;
  Polyline spread;
  for (std::size_t k = 0; k < n; ++k) spread.push_back(points[k * stride % n]);
  return spread;
}

/// Points of the boundary at which something must be spilled, were the rest of the plane theirs; greatest spill first.
std::vector<Candidate> candidates(const Scene& scene, Work work) {
  std::size_t vertices = 0;
  for (const Ring& ring : scene.target) vertices += ring.size();
  std::vector<Candidate> found;
  for (const Point& p : boundary_points(scene.target)) {
    if (work.is_done()) break;
    work.spend(vertices);
    const CellEdges edges(scene, box_about(p, kCell));
    const double spill = least_disc_area(edges.outside, p, kRadius, kTolerance, work);
    if (spill > kLeastSpill) found.push_back({p, spill});
  }
  std::ranges::stable_sort(found, std::greater<>(), &Candidate::spill);
  return found;
}

std::vector<Point> witnesses_of(const std::vector<Candidate>& all, double apart) {
  std::vector<Point> chosen;
  for (const Candidate& c : all)
    if (std::ranges::all_of(chosen, [&](const Point& p) { return distance(p, c.at) >= apart; })) chosen.push_back(c.at);
  return chosen;
}

/// Giving up `cost` of uncovered area saves `saved` of spill.
struct Saving {
  double cost, saved;
};

/// The savings along the lower convex hull of a witness's options (cost, spill), which begin with the cheapest.
void add_savings(const std::vector<Saving>& options, std::vector<Saving>& savings) {
  std::vector<Saving> hull;  // as (cost, spill)
  for (const Saving& option : options) {
    if (!hull.empty() && option.saved >= hull.back().saved) continue;
    while (hull.size() > 1) {
      const Saving &a = hull[hull.size() - 2], &b = hull.back();
      if ((b.saved - a.saved) * (option.cost - b.cost) < (option.saved - b.saved) * (b.cost - a.cost)) break;
      hull.pop_back();
    }
    hull.push_back(option);
  }
  for (std::size_t i = 1; i < hull.size(); ++i)
    savings.push_back({hull[i].cost - hull[i - 1].cost, hull[i - 1].saved - hull[i].saved});
}

/// What is spilled if `uncovered` may be given up, best use first.
double spill_with(const Scene& scene, const std::vector<Point>& witnesses, double uncovered, Work work) {
  double spill = 0;
  std::size_t vertices = 0;
  for (const Ring& ring : scene.target) vertices += ring.size();
  std::vector<Saving> savings;
  for (std::size_t k = 0; k < witnesses.size() && !work.is_done(); ++k) {
    work.spend(vertices + witnesses.size());
    const CellEdges edges(scene, voronoi_cell(witnesses, k));
    std::vector<Saving> options;
    double cost = 0;
    for (std::size_t j = 0; j <= kDistances.size() && cost <= uncovered; ++j) {
      const double least = j == kDistances.size() ? 0
                                                  : least_disc_area(edges.outside, witnesses[k],
                                                                    kRadius + kDistances[j], kTolerance, work);
      options.push_back({cost, options.empty() ? least : std::min(least, options.back().saved)});
      if (!(least > 0)) break;
      cost = disc_area(edges.inside, witnesses[k], kDistances[j]) * (1 - kRounding);
    }
    spill += options.front().saved;
    add_savings(options, savings);
  }
  std::ranges::stable_sort(savings,
                           [](const Saving& a, const Saving& b) { return a.saved * b.cost > b.saved * a.cost; });
  for (const Saving& s : savings) {
    const double share = s.cost > uncovered ? uncovered / s.cost : 1;
    spill -= share * s.saved;
    uncovered -= share * s.cost;
    if (share < 1) break;
  }
  return spill;
}

}  // namespace

double least_spill(const Region& target, double width, double uncovered_m2, const std::optional<Point>& start) {
  Scene scene;
  for_each_ring(target, [&](const Ring& ring) {
    scene.target.push_back(ring);
    for (Point& p : scene.target.back()) p /= width;
  });
  if (start) scene.first = around_disc(*start / width);
  const std::vector<Candidate> all = candidates(scene, Work(kMostWork / 2));
  double most = 0;
  const double uncovered = std::max(0.0, uncovered_m2) / (width * width);
  for (const double apart : kApart)
    most = std::max(most, spill_with(scene, witnesses_of(all, apart), uncovered, Work(kMostWork / 2 / kApart.size())));
  return most * width * width * (1 - kRounding);
}

}  // namespace oxturn
