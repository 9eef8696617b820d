// A corridor with dead-end aisles, as in a warehouse or a library. O(aisles).
#include <algorithm>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { height = 12; }
  int aisles = 8;
  double wall = 0.6;
  double corridor = 0;
  double jitter = 0.3;
  bool both_sides = false;
};

constexpr double kMostShortened = 0.75;  // of an aisle's depth, by jitter

Region make(const Params& p, Rng& rng) {
  const double corridor = passage_width("corridor", p.corridor, 3, p);
  const double aisle = (p.width - (p.aisles - 1) * p.wall) / p.aisles;
  if (aisle < narrowest_passage(p))
    throw_invalid(
        "{} aisles and walls of {:.4g} m in a width of {:.4g} m leave aisles of {:.4g} m, expected at least "
        "{:.4g} m; take fewer aisles or a larger width",
        p.aisles, p.wall, p.width, std::max(0.0, aisle), narrowest_passage(p));
  const double depth = (p.height - corridor) / (p.both_sides ? 2 : 1);
  if (depth <= 0)
    throw_invalid("corridor is {:.4g} m wide, expected less than the height of {:.4g} m", corridor, p.height);
  const double low = p.both_sides ? depth : 0, high = low + corridor;
  const auto reach = [&] { return depth * (1 - kMostShortened * p.jitter * rng.unit()); };
  const auto left = [&](int i) { return i * (aisle + p.wall); };
  const auto right = [&](int i) { return i + 1 == p.aisles ? p.width : i * (aisle + p.wall) + aisle; };
  Ring ring;
  if (p.both_sides) {
    for (int i = 0; i < p.aisles; ++i) {
      const double bottom = low - reach();
      for (const Point& q :
           {Point(left(i), low), Point(left(i), bottom), Point(right(i), bottom), Point(right(i), low)})
        ring.push_back(q);
    }
  } else {
    ring = {{0, low}, {p.width, low}};
  }
  for (int i = p.aisles - 1; i >= 0; --i) {
    const double top = high + reach();
    for (const Point& q : {Point(right(i), high), Point(right(i), top), Point(left(i), top), Point(left(i), high)})
      ring.push_back(q);
  }
  return {{{ring, {}}}};
}

}  // namespace

GeneratorInfo comb() {
  return describe_site<Params>(
      "comb", "a corridor with dead-end aisles",
      "one polygon without holes; corridor and aisles at least `passage` robot diameters wide",
      {{"aisles", &Params::aisles, Range{1, 100000}, "dead ends on a side"},
       {"wall", &Params::wall, Range{0.001, 10000}, "metres; thickness between two aisles"},
       {"corridor", &Params::corridor, Range{0, 10000}, "metres; 0: 3 robot diameters"},
       {"jitter", &Params::jitter, Range{0, 1}, "how unequal the aisles' depths are; 1: down to a quarter"},
       {"both_sides", &Params::both_sides, "aisles on both sides of the corridor"}},
      make);
}

}  // namespace oxturn::generator
