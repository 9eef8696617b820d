#include "maps/generators/shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/throw_invalid.hpp"
#include "geometry/predicates.hpp"

namespace oxturn::generator {

namespace {

constexpr double kWider = 1 + 1.0 / 1024;      // factor by which passages exceed what is asked for
constexpr double kMostBuckets = 2048;          // per side; larger buckets only mean more comparisons
constexpr int kSeriesTerms = 9;                // of sine and cosine within an eighth of a turn: the rest is below 1e-19
constexpr double kCoarsestGrid = 1.0 / 65536;  // metres
constexpr double kGridPerPassage = 1.0 / 4096;  // grid of the final snapping, in narrowest passages

}  // namespace

double narrowest_passage(const SiteSettings& site) { return 2 * site.robot * site.passage * kWider; }

void refuse(const std::string& name, const std::string& sentence) {
  throw_invalid("generator '{}': {}", name, sentence);
}

std::string number(double value) { return fmt::format("{:.4g}", value); }

void check_site(const std::string& name, const SiteSettings& site, double passages) {
  const double least = passages * narrowest_passage(site);
  for (const auto& [side, metres] : {std::pair{"width", site.width}, std::pair{"height", site.height}})
    if (metres < least)
      refuse(name, fmt::format("{} is {} m, expected at least {} m ({} times the narrowest passage: passage {} x robot "
                               "diameter {} m)",
                               side, number(metres), number(least), number(passages), number(site.passage),
                               number(2 * site.robot)));
}

double passage_width(const std::string& name, const std::string& what, double value, double diameters,
                     const SiteSettings& site) {
  if (value <= 0) return std::max(narrowest_passage(site), diameters * 2 * site.robot);
  // The user's value need not include the extra thousandth.
  if (value < 2 * site.robot * site.passage)
    refuse(name, fmt::format("{} is {} m, expected at least {} m (passage {} x robot diameter {} m); widen it or lower "
                             "passage",
                             what, number(value), number(2 * site.robot * site.passage), number(site.passage),
                             number(2 * site.robot)));
  return std::max(value, narrowest_passage(site));
}

Point direction(double turns) {
  const double quarters = (turns - std::floor(turns)) * 4;
  const double whole = std::floor(quarters + 0.5);
  const double x = (quarters - whole) * (kPi / 2);  // within an eighth of a turn
  const double x2 = x * x;
  double c = 0, s = 0;
  for (int k = kSeriesTerms; k >= 1; --k) {  // Horner's scheme
    c = (1 + c) * (-x2 / ((2 * k - 1) * (2 * k)));
    s = (1 + s) * (-x2 / ((2 * k) * (2 * k + 1)));
  }
  c += 1;
  s = (1 + s) * x;
  switch (static_cast<int>(whole) % 4) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

Ring convex_blob(Rng& rng, int vertices, double radius, const Point& centre) {
  const double compression = rng.between(0.65, 1.0);
  const double first = rng.unit();
  const Point axis = direction(rng.unit());
  Ring ring;
  for (int i = 0; i < vertices; ++i) {
    const Point d = direction(first + (i + rng.between(-0.3, 0.3)) / vertices);
    ring.push_back(centre + radius * (d.x() * axis + compression * d.y() * perpendicular(axis)));
  }
  return ring;
}

Ring disc(int vertices, double radius, const Point& centre) {
  Ring ring;
  for (int i = 0; i < vertices; ++i) ring.push_back(centre + radius * direction(static_cast<double>(i) / vertices));
  return ring;
}

Spacing::Spacing(double width, double height, double largest_radius, double gap)
    : gap_(gap),
      cell_(std::max(2 * largest_radius + gap, std::max(width, height) / kMostBuckets)),
      columns_(static_cast<int>(width / cell_) + 1),
      rows_(static_cast<int>(height / cell_) + 1),
      buckets_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

std::size_t Spacing::bucket(int i, int j) const {
  return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
}

std::vector<const Spacing::Circle*> Spacing::near(const Point& centre) const {
  std::vector<const Circle*> found;
  const int i = static_cast<int>(centre.x() / cell_), j = static_cast<int>(centre.y() / cell_);
  for (int b = std::max(0, j - 1); b <= std::min(rows_ - 1, j + 1); ++b)
    for (int a = std::max(0, i - 1); a <= std::min(columns_ - 1, i + 1); ++a)
      for (const Circle& c : buckets_[bucket(a, b)]) found.push_back(&c);
  return found;
}

void Spacing::add(const Point& centre, double radius) {
  buckets_[bucket(static_cast<int>(centre.x() / cell_), static_cast<int>(centre.y() / cell_))].push_back(
      {centre, radius, count_++});
}

Ring without_straight_vertices(const Ring& ring) {
  Ring kept;
  for (const Point& p : ring) {
    if (!kept.empty() && kept.back() == p) continue;
    while (kept.size() >= 2 && orientation(kept[kept.size() - 2], kept.back(), p) == 0) kept.pop_back();
    kept.push_back(p);
  }
  // The same where the ring closes.
  std::size_t first = 0;
  for (bool changed = true; changed && kept.size() - first >= 3;) {
    changed = false;
    const std::size_t n = kept.size();
    if (kept[n - 1] == kept[first] || orientation(kept[n - 2], kept[n - 1], kept[first]) == 0) {
      kept.pop_back();
      changed = true;
    } else if (orientation(kept[n - 1], kept[first], kept[first + 1]) == 0) {
      ++first;
      changed = true;
    }
  }
  kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(first));
  return kept;
}

Ring cut_vertices(const Ring& ring, double share, double most) {
  Ring result;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& p = ring[i];
    for (const Point& to : {ring[(i + ring.size() - 1) % ring.size()], ring[(i + 1) % ring.size()]}) {
      const double length = distance(p, to);
      result.push_back(p + (to - p) * (std::min(share * length, most) / length));
    }
  }
  return without_straight_vertices(result);
}

Region placed(const Region& lattice, const std::vector<double>& xs, const std::vector<double>& ys) {
  Region result = lattice;
  const auto look_up = [&](Ring& ring) {
    for (Point& p : ring)
      p = {xs[static_cast<std::size_t>(std::floor(p.x() + 0.5))],
           ys[static_cast<std::size_t>(std::floor(p.y() + 0.5))]};
  };
  for (Polygon& polygon : result.polygons) {
    look_up(polygon.outer);
    for (Ring& hole : polygon.holes) look_up(hole);
  }
  return result;
}

std::vector<double> lattice_lines(int cells, double size) {
  std::vector<double> at;
  for (int i = 0; i <= cells; ++i) at.push_back(size * i / cells);
  return at;
}

namespace {

/// Largest power of two that is neither above narrowest passage / 4096 nor above 2^-16 m.
double grid_of(const SiteSettings& site) {
  double grid = kCoarsestGrid;
  while (grid > narrowest_passage(site) * kGridPerPassage) grid /= 2;
  return grid;
}

}  // namespace

Region finished(Region region, const SiteSettings& site) {
  const double grid = grid_of(site);
  const Point d = direction(site.rotation / 360);
  const Point centre(site.width / 2, site.height / 2);
  const auto finish = [&](Ring& ring, bool counter_clockwise) {
    ring = without_straight_vertices(ring);
    for (Point& p : ring) {
      const Point v = p - centre;
      if (site.rotation != 0) p = centre + Point(d.x() * v.x() - d.y() * v.y(), d.y() * v.x() + d.x() * v.y());
      p = {std::floor(p.x() / grid + 0.5) * grid, std::floor(p.y() / grid + 0.5) * grid};
    }
    ring = without_straight_vertices(ring);
    if ((signed_area(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  };
  for (Polygon& polygon : region.polygons) {
    finish(polygon.outer, true);
    for (Ring& hole : polygon.holes) finish(hole, false);
  }
  return region;
}

}  // namespace oxturn::generator
