// What all generators share: the size and scale of a site, exact turning, blobs, spacing, finishing.
// Private to maps/generators.
//
// Same bytes on every machine: only + - * / sqrt floor of doubles (correctly rounded everywhere) and Rng; sines
// come from a series written out here, not from libm; finished maps are snapped to a power-of-two grid.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "geometry/region.hpp"
#include "maps/generators.hpp"

namespace oxturn::generator {

/// The parameters every generator has.
struct SiteSettings {
  double width = 20, height = 20;  // metres, before rotation
  double robot = 0.2;              // metres, radius
  double passage = 1.25;           // narrowest passage, in robot diameters
  double rotation = 0;             // degrees
};

/// A generator's own lines, between the size and the scale that all have.
template <class P>
std::vector<Parameter<P>> with_site(const std::vector<Parameter<P>>& own) {
  std::vector<Parameter<P>> lines{{"width", &P::width, Range{0.001, 100000}, "metres, before rotation"},
                                  {"height", &P::height, Range{0.001, 100000}, "metres, before rotation"}};
  lines.insert(lines.end(), own.begin(), own.end());
  lines.push_back({"robot", &P::robot, Range{0.001, 1000}, "metres; radius of the robot the map is scaled for"});
  lines.push_back({"passage", &P::passage, Range{0.05, 1000},
                   "narrowest passage in robot diameters; below 1 the robot may be shut out"});
  lines.push_back({"rotation", &P::rotation, Range{-360, 360}, "degrees off the axes, about the centre"});
  return lines;
}

/// The narrowest passage in metres, with a thousandth to spare for the final snapping.
double narrowest(const SiteSettings& site);
/// Throws std::invalid_argument("generator 'NAME': SENTENCE").
[[noreturn]] void refuse(const std::string& name, const std::string& sentence);
/// Refuses a site narrower than `passages` of its narrowest passages.
void check_site(const std::string& name, const SiteSettings& site, double passages = 1);
/// `value`, or `diameters` robot diameters (never under the narrowest passage) if it is 0. Refuses a value under
/// the narrowest passage; `what` is the parameter's name.
double passage_width(const std::string& name, const std::string& what, double value, double diameters,
                     const SiteSettings& site);
/// "1.25" for sentences.
std::string number(double value);

/// (cos, sin) of so many full turns. Within 1e-15; quarter turns are exact.
Point direction(double turns);
/// A convex ring with `corners` corners in a circle about `centre`: a squashed circle's inscribed polygon.
Ring convex_blob(Rng& rng, int corners, double radius, const Point& centre);
/// A regular polygon inscribed in the circle.
Ring disc(int corners, double radius, const Point& centre);

/// Circles that keep a distance, in a grid of buckets: O(1) for each question.
class Spacing {
 public:
  Spacing(double width, double height, double largest_radius, double gap);
  /// No circle is nearer than the gap, unless clear(its number) says that it does no harm.
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
  /// Circles are numbered from 0 in the order they are added.
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

/// Corners repeated or exactly straight on are dropped.
Ring without_straight_vertices(const Ring& ring);
/// Every corner becomes two, `share` of the edge away from it but no more than `most` (share <= 0.5).
Ring cut_vertices(const Ring& ring, double share, double most);
/// Lattice corners (whole numbers) looked up in tables of coordinates.
Region placed(const Region& lattice, const std::vector<double>& xs, const std::vector<double>& ys);
/// Where the lines of a lattice of so many cells are, stretched to `size`.
std::vector<double> lattice_lines(int cells, double size);

/// Which of n things are connected (union-find with path halving).
class Groups {
 public:
  explicit Groups(std::size_t n);
  int find(int a);
  /// False if they were together already.
  bool join(int a, int b);

 private:
  std::vector<int> parent_;
};

/// The last step of every generator: turned about the site's centre, snapped to a grid of 2^-16 m (finer for
/// robots under 0.1 m), rings oriented and without straight corners.
Region finished(Region region, const SiteSettings& site);

}  // namespace oxturn::generator
