// The optimal convex partition of each simple piece, by CGAL.
//
// Decisions   1. CGAL 5.5 sometimes returns parts that are not convex (seen where vertices of several pieces are
//                collinear). Its own check runs in some builds only, so it is off here, and we check every part in
//                every build.
//             2. The same ring beginning at another vertex often gives a correct result, so a few are tried.
#define CGAL_NO_POSTCONDITIONS
#include "geometry/mesh/partition.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <list>
#include <optional>
#include <stdexcept>

#include "base/throw_invalid.hpp"
#include "geometry/mesh/cgal_guard.hpp"
#include "geometry/mesh/mesh_parts.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Partition_traits_2<Kernel>;
using CgalPolygon = Traits::Polygon_2;

/// Does the ring turn left or not at all at every vertex, and once around in all?
bool convex(const Ring& ring) {
  if (ring.size() < 3) return false;
  int minima = 0;  // a convex ring passes its lowest point once
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
    if (orientation(a, b, c) < 0) return false;
    const auto upwards = [](const Point& p, const Point& q) {
      return q.y() > p.y() || (q.y() == p.y() && q.x() > p.x());
    };
    minima += !upwards(a, b) && upwards(b, c);
  }
  return minima == 1;
}

/// CGAL's partition of the piece, its ring beginning at vertex `first`; nullopt if that is not a convex partition.
std::optional<std::vector<Ring>> optimal_parts_from(const Ring& piece, std::size_t first) {
  constexpr double kRounding = 1e-6;  // of the areas' sum
  CgalPolygon polygon;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Point& p = piece[(first + i) % piece.size()];
    polygon.push_back(Kernel::Point_2(p.x(), p.y()));
  }
  std::list<CgalPolygon> found;
  cgal_guarded("optimal convex partition", [&] {
    CGAL::optimal_convex_partition_2(polygon.vertices_begin(), polygon.vertices_end(), std::back_inserter(found),
                                     Traits());
  });
  std::vector<Ring> parts;
  double sum = 0;
  for (const CgalPolygon& c : found) {
    Ring ring;
    for (auto v = c.vertices_begin(); v != c.vertices_end(); ++v) ring.emplace_back(v->x(), v->y());
    if (!convex(ring)) return std::nullopt;
    sum += signed_area(ring);
    parts.push_back(std::move(ring));
  }
  const double whole = signed_area(piece);
  if (!(std::abs(sum - whole) <= kRounding * whole)) return std::nullopt;
  return parts;
}

std::vector<Ring> optimal_parts(const Ring& piece) {
  constexpr std::size_t kAttempts = 4;
  for (std::size_t k = 0; k < kAttempts; ++k)
    if (auto parts = optimal_parts_from(piece, k * piece.size() / kAttempts)) return std::move(*parts);
  throw std::runtime_error(fmt::format("CGAL finds no optimal convex partition at ({}, {}); use the approximate one",
                                       piece.front().x(), piece.front().y()));
}

}  // namespace

std::vector<Ring> convex_partition_optimal(const Region& region, std::size_t most_vertices) {
  const std::size_t vertices = vertex_count(region);
  if (vertices > most_vertices)
    throw_invalid(
        "optimal convex partition of a region with {} vertices would take too long; it is meant for up to {}: "
        "use the approximate one or simplify the region",
        vertices, most_vertices);
  std::vector<Ring> parts;
  for (const Ring& piece : simple_pieces(region))
    for (Ring& part : optimal_parts(piece)) parts.push_back(std::move(part));
  return parts;
}

}  // namespace oxturn
