// A spiral corridor from the outside to the middle, square or round: the longest path with the fewest choices.
// O(vertices).
#include <algorithm>
#include <array>
#include <limits>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  double corridor = 0;
  double wall = 0.3;
  double jitter = 0;
  int arms = 0;
  bool round = false;
};

constexpr int kChords = 64;  // of one round of a round spiral
// A ray crosses the corridor at an angle (at most atan(1 / 2 pi)), and chords cut in by cos(pi / 64): 2 % in all.
constexpr double kRayPerCorridor = 1.02;

[[noreturn]] void refuse_arms(const std::string& found, double pitch, const std::string& size, int wanted) {
  throw_invalid(
      "only {} of {:.4g} m (corridor and wall) fit in {} m, expected {}; take a larger size, or a smaller "
      "corridor or wall",
      found, pitch, size, std::max(2, wanted));
}

/// Arms of a square spiral lead east, north, west, south, and so on.
Point heading(std::size_t arm) {
  static const std::array<Point, 4> kHeadings{Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)};
  return kHeadings[arm % 4];
}

/// The corridor's middle line: round the inside of a box that shrinks by `pitch` after each arm.
Polyline square_middle_line(const Params& p, double half, double pitch) {
  Point low(half, half), high(p.width - half, p.height - half);
  Polyline line{low};
  const std::size_t most = p.arms > 0 ? static_cast<std::size_t>(p.arms) : std::numeric_limits<std::size_t>::max();
  for (std::size_t arm = 0; arm < most; ++arm) {
    Point to = line.back();
    const Point& ahead = arm % 4 < 2 ? high : low;
    (arm % 2 == 0 ? to.x() : to.y()) = arm % 2 == 0 ? ahead.x() : ahead.y();
    (arm % 4 == 0 || arm % 4 == 3 ? low : high) += pitch * perpendicular(heading(arm));
    // Two parallel arms are as far apart as the arm between them is long.
    if ((to - line.back()).dot(heading(arm)) < pitch) break;
    line.push_back(to);
  }
  return line;
}

/// One wall of a square spiral: `side` is 1 for the left wall and -1 for the right one, `offsets` are the wall's
/// distances from the middle line, by arm. At a corner each of the two arms fixes one coordinate.
Ring square_wall(const Polyline& line, const std::vector<double>& offsets, double side, double half) {
  const auto offset = [&](std::size_t arm) { return Point(side * offsets[arm] * perpendicular(heading(arm))); };
  const std::size_t arms = offsets.size();
  Ring wall{line[0] - half * heading(0) + offset(0)};
  for (std::size_t i = 1; i < arms; ++i) wall.push_back(line[i] + offset(i - 1) + offset(i));
  wall.push_back(line[arms] + half * heading(arms - 1) + offset(arms - 1));
  return wall;
}

Ring square(const Params& p, double corridor, Rng& rng) {
  const double half = corridor / 2, pitch = corridor + p.wall;
  const Polyline line = square_middle_line(p, half, pitch);
  const int arms = static_cast<int>(line.size()) - 1;
  if (arms < 2 || arms < p.arms)
    refuse_arms(fmt::format("{} arms", arms), pitch, fmt::format("{:.4g} x {:.4g}", p.width, p.height), p.arms);
  const double slack = p.jitter * (half - narrowest_passage(p) / 2);
  std::vector<double> left, right;
  for (int i = 0; i < arms; ++i) {
    left.push_back(half - slack * rng.unit());
    right.push_back(half - slack * rng.unit());
  }
  Ring ring = square_wall(line, right, -1, half);
  const Ring back = square_wall(line, left, 1, half);
  ring.insert(ring.end(), back.rbegin(), back.rend());
  return ring;
}

/// Archimedes' spiral. Both walls have their vertices on the same rays, so chords are parallel.
Ring archimedes(const Params& p, double corridor, Rng& rng) {
  const double across = corridor * kRayPerCorridor, pitch = across + p.wall;
  const double outermost = std::min(p.width, p.height) / 2 - across / 2;  // radius of the middle line
  const int fit = static_cast<int>((outermost - pitch) / pitch * kChords);
  const int steps = p.arms > 0 ? p.arms * kChords / 4 : fit;
  if (fit < kChords / 2 || steps > fit)
    refuse_arms(fmt::format("{} quarter rounds", std::max(0, fit * 4 / kChords)), pitch,
                fmt::format("{:.4g}", 2 * outermost + across), p.arms);
  const Point centre(p.width / 2, p.height / 2);
  const double slack = p.jitter * (across / 2 - kRayPerCorridor * narrowest_passage(p) / 2);
  Ring outer, inner;
  for (int i = 0; i <= steps; ++i) {
    const double radius = outermost - pitch * i / kChords;
    const Point d = direction(static_cast<double>(i) / kChords);
    outer.push_back(centre + (radius + across / 2 - slack * rng.unit()) * d);
    inner.push_back(centre + (radius - across / 2 + slack * rng.unit()) * d);
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

Region make(const Params& p, Rng& rng) {
  const double corridor = passage_width("corridor", p.corridor, 2.5, p);
  return {{{p.round ? archimedes(p, corridor, rng) : square(p, corridor, rng), {}}}};
}

}  // namespace

GeneratorInfo spiral() {
  return describe_site<Params>(
      "spiral", "a spiral corridor",
      "one polygon without holes; the corridor at least `passage` robot diameters wide; random only with jitter",
      {{"corridor", &Params::corridor, Range{0, 10000}, "metres; 0: 2.5 robot diameters"},
       {"wall", &Params::wall, Range{0.001, 10000}, "metres; thickness between two rounds"},
       {"jitter", &Params::jitter, Range{0, 1}, "uneven walls; 1: as narrow as `passage` allows in some points"},
       {"arms", &Params::arms, Range{0, 1000000}, "straight arms or quarter rounds; 0: as many as fit"},
       {"round", &Params::round,
        "a round spiral, as wide as the smaller of width and height, instead of a square one"}},
      make);
}

}  // namespace oxturn::generator
