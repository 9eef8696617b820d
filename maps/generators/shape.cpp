#include "maps/generators/shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace oxturn::generator {

namespace {

constexpr double kWider = 1 + 1.0 / 1024;      // factor by which passages exceed what is asked for
constexpr double kMostBuckets = 2048;          // per side; larger buckets only mean more comparisons
constexpr int kSeriesTerms = 9;                // of sine and cosine within an eighth of a turn: the rest is below 1e-19
constexpr double kCoarsestGrid = 1.0 / 65536;  // metres
constexpr double kGridPerPassage = 1.0 / 4096;  // grid of the final snapping, in narrowest passages

}  // namespace

double narrowest_passage(const SiteSettings& site) { return 2 * site.robot * site.passage * kWider; }

double passage_width(const std::string& what, double value, double diameters, const SiteSettings& site) {
  if (value <= 0) return std::max(narrowest_passage(site), diameters * 2 * site.robot);
  const double least = 2 * site.robot * site.passage;  // the user's value need not include the extra thousandth
  if (value < least)
    throw_invalid(
        "{} is {:.4g} m, expected at least {:.4g} m (passage {:.4g} x robot diameter {:.4g} m); widen it or "
        "lower passage",
        what, value, least, site.passage, 2 * site.robot);
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
  const std::array turned{Point(c, s), Point(-s, c), Point(-c, -s), Point(s, -c)};
  return turned[static_cast<std::size_t>(whole) % 4];
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

Region floor_of(const SiteSettings& site) { return box_region({0, 0}, {site.width, site.height}); }

Region traced(const BitGrid& grid, const std::vector<double>& xs, const std::vector<double>& ys) {
  Region region = trace(grid);
  for_each_ring(region, [&](Ring& ring) {
    for (Point& p : ring)
      p = {xs[static_cast<std::size_t>(std::floor(p.x() + 0.5))],
           ys[static_cast<std::size_t>(std::floor(p.y() + 0.5))]};
  });
  return region;
}

Region traced(const BitGrid& grid, const SiteSettings& site) {
  const auto lines = [](int cells, double size) {
    std::vector<double> at;
    for (int i = 0; i <= cells; ++i) at.push_back(size * i / cells);
    return at;
  };
  return traced(grid, lines(grid.columns, site.width), lines(grid.rows, site.height));
}

BitGrid wall_squares(const SiteSettings& site, double wall) {
  constexpr double kMostSquares = 1e8;
  if (site.width < wall || site.height < wall || site.width / wall * (site.height / wall) > kMostSquares)
    throw_invalid(
        "wall is {:.4g} m in {:.4g} x {:.4g} m, expected thinner than the size and no more than 10^8 squares "
        "of its thickness",
        wall, site.width, site.height);
  return BitGrid({0, 0}, 1, static_cast<int>(site.width / wall), static_cast<int>(site.height / wall));
}

namespace {

/// Refuses a site whose width or height is below `passages` narrowest passages.
void check_site(const SiteSettings& site, double passages) {
  const double least = passages * narrowest_passage(site);
  for (const auto& [side, metres] : {std::pair{"width", site.width}, std::pair{"height", site.height}})
    if (metres < least)
      throw_invalid(
          "{} is {:.4g} m, expected at least {:.4g} m ({:.4g} times the narrowest passage: passage {:.4g} x "
          "robot diameter {:.4g} m)",
          side, metres, least, passages, site.passage, 2 * site.robot);
}

/// Largest power of two that is neither above narrowest passage / 4096 nor above 2^-16 m.
double grid_of(const SiteSettings& site) {
  double grid = kCoarsestGrid;
  while (grid > narrowest_passage(site) * kGridPerPassage) grid /= 2;
  return grid;
}

/// Rotated, snapped, oriented, without straight vertices.
void finish(Ring& ring, double orientation, const SiteSettings& site) {
  const double grid = grid_of(site);
  const Point d = direction(site.rotation / 360);
  const Point centre(site.width / 2, site.height / 2);
  ring = without_straight_vertices(ring);
  for (Point& p : ring) {
    const Point v = p - centre;
    if (site.rotation != 0) p = centre + Point(d.x() * v.x() - d.y() * v.y(), d.y() * v.x() + d.x() * v.y());
    p = {std::floor(p.x() / grid + 0.5) * grid, std::floor(p.y() / grid + 0.5) * grid};
  }
  ring = without_straight_vertices(ring);
  if (signed_area(ring) * orientation < 0) std::reverse(ring.begin(), ring.end());
}

}  // namespace

Region built_on(const SiteSettings& site, const std::string& owner, double passages,
                const std::function<Region()>& make) {
  try {
    check_site(site, passages);
    Region region = make();
    for (Polygon& polygon : region.polygons) {
      finish(polygon.outer, 1, site);
      for (Ring& hole : polygon.holes) finish(hole, -1, site);
    }
    return region;
  } catch (const std::invalid_argument& e) { throw_invalid("{}: {}", owner, e.what()); }
}

}  // namespace oxturn::generator
