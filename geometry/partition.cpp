// The optimal convex partition, by CGAL, piece by piece: it wants strictly simple polygons without holes.
#include "geometry/partition.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <list>
#include <stdexcept>

#include "geometry/cgal_guard.hpp"
#include "geometry/mesh_parts.hpp"

namespace oxturn {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Partition_traits_2<Kernel>;
using CgalPolygon = Traits::Polygon_2;

std::vector<Ring> optimal_parts(const Ring& piece) {
  CgalPolygon polygon;
  for (const Point& p : piece) polygon.push_back(Kernel::Point_2(p.x(), p.y()));
  std::list<CgalPolygon> cut;
  cgal_guarded("optimal convex partition", [&] {
    CGAL::optimal_convex_partition_2(polygon.vertices_begin(), polygon.vertices_end(), std::back_inserter(cut),
                                     Traits());
  });
  std::vector<Ring> parts;
  double sum = 0;
  for (const CgalPolygon& c : cut) {
    Ring ring;
    for (auto v = c.vertices_begin(); v != c.vertices_end(); ++v) ring.emplace_back(v->x(), v->y());
    sum += signed_area(ring);
    parts.push_back(std::move(ring));
  }
  const double whole = signed_area(piece);
  if (!(std::abs(sum - whole) <= 1e-6 * whole)) {
    throw std::runtime_error(fmt::format("optimal convex partition at ({}, {}) lost area; use the approximate one",
                                         piece.front().x(), piece.front().y()));
  }
  return parts;
}

}  // namespace

std::vector<Ring> convex_partition_optimal(const Region& region, std::size_t most_corners) {
  const std::size_t corners = corner_count(region);
  if (corners > most_corners) {
    throw std::invalid_argument(fmt::format(
        "optimal convex partition of a region with {} corners would take too long; it is meant for up to {}: "
        "use the approximate one or simplify the region",
        corners, most_corners));
  }
  std::vector<Ring> parts;
  for (const Ring& piece : simple_pieces(region)) {
    for (Ring& part : optimal_parts(piece)) parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace oxturn
