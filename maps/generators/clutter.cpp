// A rectangle full of convex obstacles: discs (chords of them) and polygons.
//
// Method      Random sequential placement, large ones first, in a grid of buckets: O(1) for each try. Two obstacles
//             are far enough apart if their circumscribed circles are, or if the line of an edge of one separates them
//             by the gap.
// Guarantee   Obstacles dilated by the robot stay disjoint, so free space is connected for it.
// Complexity  O(obstacles) well below the densest random packing
#include <algorithm>
#include <utility>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  double density = 0.15;
  double least = 0.3;
  double most = 1.2;
  double discs = 0.3;
  int corners = 7;
  int disc_chords = 32;
};

constexpr int kTries = 5000;            // to find a position for one obstacle
constexpr int kAttempts = 6;            // for all obstacles
constexpr double kMostObstacles = 1e7;  // roughly

struct Obstacle {
  double radius;
  bool round;
  Ring ring;
  Point centre{0, 0};
};

/// Extent of an obstacle along a unit vector.
std::pair<double, double> extent(const Obstacle& o, const Point& along) {
  if (o.round) return {o.centre.dot(along) - o.radius, o.centre.dot(along) + o.radius};
  double low = o.ring[0].dot(along), high = low;
  for (const Point& p : o.ring) {
    low = std::min(low, p.dot(along));
    high = std::max(high, p.dot(along));
  }
  return {low, high};
}

/// Does all of `b` lie at least `gap` beyond the line of an edge of `a`?
bool separated_by_an_edge(const Obstacle& a, const Obstacle& b, double gap) {
  if (a.round) return false;
  for (std::size_t i = 0; i < a.ring.size(); ++i) {
    const Point edge = a.ring[(i + 1) % a.ring.size()] - a.ring[i];
    const Point outwards = -perpendicular(edge) / edge.norm();
    if (extent(b, outwards).first >= a.ring[i].dot(outwards) + gap) return true;
  }
  return false;
}

/// Obstacles about the origin, enough for the density, largest first.
std::vector<Obstacle> drawn(const Params& p, double most, Rng& rng) {
  std::vector<Obstacle> obstacles;
  const double goal = p.density * p.width * p.height;
  for (double filled = 0; filled < goal;) {
    const double radius = rng.between(p.least, most);
    const bool round = rng.chance(p.discs);
    obstacles.push_back(
        {radius, round,
         round ? disc(p.disc_chords, radius, {0, 0}) : convex_blob(rng, rng.between(3, p.corners), radius, {0, 0})});
    filled += signed_area(obstacles.back().ring);
  }
  std::ranges::stable_sort(obstacles, [](const Obstacle& a, const Obstacle& b) { return a.radius > b.radius; });
  return obstacles;
}

/// Moves the obstacles to random positions; returns how many fit.
std::size_t move_apart(std::vector<Obstacle>& obstacles, const Params& p, double most, Rng& rng) {
  const double gap = narrowest_passage(p);
  Spacing spacing(p.width, p.height, most, gap);
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    Obstacle& o = obstacles[k];
    const Ring shape = o.ring;
    const auto [left, right] = extent(o, {1, 0});
    const auto [bottom, top] = extent(o, {0, 1});
    for (int tries = 0;; ++tries) {
      if (tries == kTries) return k;
      o.centre.x() = rng.between(gap - left, p.width - gap - right);
      o.centre.y() = rng.between(gap - bottom, p.height - gap - top);
      for (std::size_t i = 0; i < shape.size(); ++i) o.ring[i] = shape[i] + o.centre;
      if (spacing.fits(o.centre, o.radius, [&](std::size_t other) {
            return separated_by_an_edge(o, obstacles[other], gap) || separated_by_an_edge(obstacles[other], o, gap);
          }))
        break;
    }
    spacing.add(o.centre, o.radius);
  }
  return obstacles.size();
}

Region make(const Params& p, Rng& rng) {
  const double gap = narrowest_passage(p), most = std::min(p.most, (std::min(p.width, p.height) / 2 - gap) * 0.999);
  if (p.least > p.most) throw_invalid("least is {:.4g} m, expected no more than most, {:.4g} m", p.least, p.most);
  if (p.density > 0 && p.least > most)
    throw_invalid("obstacles of radius {:.4g} m do not fit in {:.4g} x {:.4g} m with passages of {:.4g} m; lower least",
                  p.least, p.width, p.height, gap);
  if (p.density * p.width * p.height > kMostObstacles * p.least * p.least)
    throw_invalid(
        "density {:.4g} of obstacles as small as {:.4g} m makes millions of them in {:.4g} x {:.4g} m; raise "
        "least or lower density",
        p.density, p.least, p.width, p.height);
  for (int attempt = 1;; ++attempt) {
    std::vector<Obstacle> obstacles = drawn(p, most, rng);
    const std::size_t fit = move_apart(obstacles, p, most, rng);
    if (fit < obstacles.size() && attempt < kAttempts) continue;  // other obstacles may fit
    if (fit < obstacles.size())
      throw_invalid(
          "density {:.4g} cannot be reached: only {} of {} obstacles fit; lower density, or take larger "
          "obstacles or a narrower passage",
          p.density, fit, obstacles.size());
    Region region = floor_of(p);
    for (Obstacle& o : obstacles) region.polygons[0].holes.push_back(std::move(o.ring));
    return region;
  }
}

}  // namespace

GeneratorInfo clutter() {
  return describe_site<Params>(
      "clutter", "a rectangle full of convex obstacles",
      "disjoint convex holes at least `passage` robot diameters from each other and from the border: connected",
      {{"density", &Params::density, Range{0, 0.9}, "share of the area that obstacles take"},
       {"least", &Params::least, Range{0.001, 10000}, "metres; radius of the smallest obstacle"},
       {"most", &Params::most, Range{0.001, 10000}, "metres; radius of the largest obstacle (or what fits)"},
       {"discs", &Params::discs, Range{0, 1}, "share of discs among the obstacles"},
       {"corners", &Params::corners, Range{3, 100}, "most vertices of an obstacle that is no disc"},
       {"disc_chords", &Params::disc_chords, Range{8, 1000}, "chords of a disc"}},
      make);
}

}  // namespace oxturn::generator
