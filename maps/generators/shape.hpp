/// Common parts of all generators: size and scale of a site, exact rotation, convex polygons, spacing, finishing.
///
///   struct Params : SiteSettings { double jitter = 0; };            // a generator's own parameters
///   Region make(const Params& p, Rng&) { return floor_of(p); }
///   GeneratorInfo hall() { return describe_site<Params>("hall", "an empty hall", "one rectangle", {...}, make); }
///
/// Private to maps/generators. Maps have the same bytes on every machine: only + - * / sqrt floor of doubles are used,
/// which are correctly rounded everywhere, and Rng. Sines come from a series written out here, not from libm, and
/// finished maps are snapped to a power-of-two grid.
#pragma once

#include <functional>

#include "base/throw_invalid.hpp"
#include "geometry/overlay/validity.hpp"
#include "geometry/raster.hpp"
#include "maps/generators.hpp"

namespace oxturn::generator {

/// The parameters of every generator.
struct SiteSettings {
  double width = 20, height = 20;  // metres, before rotation
  double robot = 0.2;              // metres, radius
  double passage = 1.25;           // narrowest passage, in robot diameters
  double rotation = 0;             // degrees
};

/// A generator's own parameters between those for size and scale, which all have.
template <class P>
std::vector<Parameter<P>> with_site(const std::vector<Parameter<P>>& own) {
  std::vector<Parameter<P>> lines{{"width", &P::width, Range{0.001, 100000}, "metres, before rotation"},
                                  {"height", &P::height, Range{0.001, 100000}, "metres, before rotation"}};
  lines.insert(lines.end(), own.begin(), own.end());
  lines.push_back({"robot", &P::robot, Range{0.001, 1000}, "metres; radius of the robot the map is scaled for"});
  lines.push_back({"passage", &P::passage, Range{0.05, 1000},
                   "narrowest passage in robot diameters; below 1 the robot may not fit through"});
  lines.push_back({"rotation", &P::rotation, Range{-360, 360}, "degrees, counter-clockwise about the centre"});
  return lines;
}

/// The narrowest passage in metres, a thousandth wider so that the final snapping does not make it too narrow.
double narrowest_passage(const SiteSettings& site);
/// `value`; for 0 `diameters` robot diameters, but at least the narrowest passage. Refuses a value below the narrowest
/// passage; `what` is the parameter's name.
double passage_width(const std::string& what, double value, double diameters, const SiteSettings& site);

/// (cos, sin) of this many full turns. Within 1e-15; quarter turns are exact.
Point direction(double turns);
/// A convex polygon inscribed in a circle that is compressed along one axis.
Ring convex_blob(Rng& rng, int vertices, double radius, const Point& centre);
/// A regular polygon inscribed in the circle.
Ring disc(int vertices, double radius, const Point& centre);

/// Circles that keep a distance from each other, in a grid of buckets: O(1) per query.
class Spacing {
 public:
  Spacing(double width, double height, double largest_radius, double gap);
  /// True if no circle is nearer than the gap, except those with clear(number of the circle).
  template <class F>
  bool fits(const Point& centre, double radius, F clear) const {
    for (const Circle* c : near(centre)) {
      const double apart = radius + c->radius + gap_;
      if ((centre - c->centre).squaredNorm() < apart * apart && !clear(c->number)) return false;
    }
    return true;
  }
  bool fits(const Point& centre, double radius) const {
    return fits(centre, radius, [](std::size_t) { return false; });
  }
  /// Circles are numbered from 0 in the order in which they are added.
  void add(const Point& centre, double radius);

 private:
  struct Circle {
    Point centre;
    double radius;
    std::size_t number;
  };
  std::vector<const Circle*> near(const Point& centre) const;
  std::size_t bucket(int i, int j) const;
  double gap_, cell_;
  int columns_, rows_;
  std::size_t count_ = 0;
  std::vector<std::vector<Circle>> buckets_;
};

/// Every vertex becomes two, on the edges beside it: `share` of the edge's length away, but at most `most` metres
/// (share <= 0.5).
Ring cut_vertices(const Ring& ring, double share, double most);
/// The whole site, without holes.
Region floor_of(const SiteSettings& site);
/// The set cells of a grid, whose lattice lines have these coordinates.
Region traced(const BitGrid& grid, const std::vector<double>& xs, const std::vector<double>& ys);
/// The set cells of a grid that is stretched over the site.
Region traced(const BitGrid& grid, const SiteSettings& site);
/// No cells set, as many as squares of a wall's thickness fit on the site. Refuses too thick and too thin walls.
BitGrid wall_squares(const SiteSettings& site, double wall);

/// Calls make() for a site of at least `passages` narrowest passages in width and height. Rotates what it returns about
/// the site's centre and snaps it to a grid of 2^-16 m (finer for robots under 0.1 m), its rings oriented and without
/// straight vertices. Errors begin with the owner.
Region built_on(const SiteSettings& site, const std::string& owner, double passages,
                const std::function<Region()>& make);

/// The description of a generator: its own parameters and those of the site.
template <class P>
GeneratorInfo describe_site(const std::string& name, std::string title, std::string guarantee,
                            const std::vector<Parameter<P>>& own, Region (*make)(const P&, Rng&), double passages = 1) {
  const std::vector<Parameter<P>> lines = with_site(own);
  return {name, std::move(title), std::move(guarantee), infos_of(lines),
          [lines, make, passages, owner = "generator '" + name + "'"](const Settings& settings, Rng& rng) {
            const P p = with_settings<P>(owner, lines, settings);
            return built_on(p, owner, passages, [&] { return make(p, rng); });
          }};
}

}  // namespace oxturn::generator
