// maps/generators/spiral.cpp
// A spiral corridor from the rim to the middle, square or round: the longest way with the fewest choices.
// O(corners).
#include <algorithm>
#include <array>

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

constexpr int kChords = 64;  // of a round lap

/// Square: the corridor's middle line goes round inside a shrinking box.
Ring square(const Params& p, double corridor, Rng& rng) {
  const double half = corridor / 2, pitch = corridor + p.wall;
  Point low(half, half), high(p.width - half, p.height - half);
  Polyline line{low};
  const int most = p.arms > 0 ? p.arms : 1 << 30;
  for (int arm = 0; arm < most; ++arm) {
    Point to = line.back();
    switch (arm % 4) {
      case 0:
        to.x() = high.x();
        low.y() += pitch;
        break;
      case 1:
        to.y() = high.y();
        high.x() -= pitch;
        break;
      case 2:
        to.x() = low.x();
        high.y() -= pitch;
        break;
      default:
        to.y() = low.y();
        low.x() += pitch;
        break;
    }
    // Two parallel arms are as far apart as the arm between them is long.
    const Point step = to - line.back();
    const double along = arm % 4 == 0 ? step.x() : arm % 4 == 1 ? step.y() : arm % 4 == 2 ? -step.x() : -step.y();
    if (along < pitch) break;
    line.push_back(to);
  }
  const int arms = static_cast<int>(line.size()) - 1;
  if (arms < 2 || arms < p.arms)
    refuse("spiral", "only " + std::to_string(arms) + " arms of " + number(pitch) + " m (corridor and wall) fit in " +
                         number(p.width) + " x " + number(p.height) + " m, expected " +
                         std::to_string(std::max(2, p.arms)) + "; take a larger size, or a smaller corridor or wall");
  const std::array<Point, 4> ways{Point(1, 0), Point(0, 1), Point(-1, 0), Point(0, -1)};
  const auto way = [&](int arm) { return ways[static_cast<std::size_t>(arm % 4)]; };
  const auto at = [&](int i) { return line[static_cast<std::size_t>(i)]; };
  const double slack = p.jitter * (half - narrowest(p) / 2);
  std::vector<double> left, right;
  for (int i = 0; i < arms; ++i) {
    left.push_back(half - slack * rng.unit());
    right.push_back(half - slack * rng.unit());
  }
  // Where the walls of arm i - 1 and arm i meet: each fixes one coordinate.
  const auto corner = [&](int i, const std::vector<double>& offset, double side) {
    const auto off = [&](int arm) {
      return Point(side * offset[static_cast<std::size_t>(arm)] * perpendicular(way(arm)));
    };
    if (i == 0) return Point(at(0) - half * way(0) + off(0));
    if (i == arms) return Point(at(arms) + half * way(arms - 1) + off(arms - 1));
    return Point(at(i) + off(i - 1) + off(i));
  };
  Ring ring;
  for (int i = 0; i <= arms; ++i) ring.push_back(corner(i, right, -1));
  for (int i = arms; i >= 0; --i) ring.push_back(corner(i, left, 1));
  return ring;
}

/// Round: Archimedes' spiral; both walls have their corners on the same rays, so chords stay parallel.
Ring archimedes(const Params& p, double corridor, Rng& rng) {
  // A ray crosses the corridor aslant (at most atan(1 / 2 pi)) and chords cut in by cos(pi / 64): 2 % in all.
  const double across = corridor * 1.02, pitch = across + p.wall;
  const double rim = std::min(p.width, p.height) / 2 - across / 2;
  const int fit = static_cast<int>((rim - pitch) / pitch * kChords);
  const int steps = p.arms > 0 ? p.arms * kChords / 4 : fit;
  if (fit < kChords / 2 || steps > fit)
    refuse("spiral", "only " + std::to_string(std::max(0, fit * 4 / kChords)) + " quarter laps of " + number(pitch) +
                         " m (corridor and wall) fit in " + number(2 * rim + across) + " m, expected " +
                         std::to_string(std::max(2, p.arms)) + "; take a larger size, or a smaller corridor or wall");
  const Point centre(p.width / 2, p.height / 2);
  const double slack = p.jitter * (across / 2 - 1.02 * narrowest(p) / 2);
  Ring outer, inner;
  for (int i = 0; i <= steps; ++i) {
    const double radius = rim - pitch * i / kChords;
    const Point d = direction(static_cast<double>(i) / kChords);
    outer.push_back(centre + (radius + across / 2 - slack * rng.unit()) * d);
    inner.push_back(centre + (radius - across / 2 + slack * rng.unit()) * d);
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

Region make(const Params& p, Rng& rng) {
  check_site("spiral", p);
  const double corridor = passage_width("spiral", "corridor", p.corridor, 2.5, p);
  return finished({{{p.round ? archimedes(p, corridor, rng) : square(p, corridor, rng), {}}}}, p);
}

}  // namespace

GeneratorInfo spiral() {
  return describe_generator<Params>(
      "spiral", "a spiral corridor",
      "one polygon without holes; the corridor at least `passage` robot diameters wide; random only with jitter",
      with_site<Params>(
          {{"corridor", &Params::corridor, Range{0, 10000}, "metres; 0: 2.5 robot diameters"},
           {"wall", &Params::wall, Range{0.001, 10000}, "metres; thickness between two laps"},
           {"jitter", &Params::jitter, Range{0, 1}, "uneven walls; 1: some places as narrow as passage allows"},
           {"arms", &Params::arms, Range{0, 1000000}, "straight arms or quarter laps; 0: as many as fit"},
           {"round", &Params::round, "round laps (the smaller of width and height across) instead of square ones"}}),
      make);
}

}  // namespace oxturn::generator
