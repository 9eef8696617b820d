// The optimal convex partition, by CGAL, piece by piece: it wants strictly simple polygons without holes.
//
// CGAL 5.5 sometimes returns parts that are not convex (seen where corners of several pieces line up). Its own check of
// that is on in some builds only, so it is off here and every part is checked by us, in every build; a ring that begins at
// another corner often does better, so a few beginnings are tried.
#define CGAL_NO_POSTCONDITIONS
#include "geometry/mesh/partition.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Partition_traits_2.h>
#include <CGAL/partition_2.h>
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <list>
#include <stdexcept>

#include "geometry/mesh/cgal_guard.hpp"
#include "geometry/mesh/mesh_parts.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Traits = CGAL::Partition_traits_2<Kernel>;
using CgalPolygon = Traits::Polygon_2;

// Turns left or straight on at every corner, and once round in all.
bool convex(const Ring& ring) {
  if (ring.size() < 3) return false;
  int rises = 0;  // a convex ring passes its lowest point once
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
    if (orientation(a, b, c) < 0) return false;
    const auto upwards = [](const Point& p, const Point& q) {
      return q.y() > p.y() || (q.y() == p.y() && q.x() > p.x());
    };
    rises += !upwards(a, b) && upwards(b, c);
  }
  return rises == 1;
}

// Empty if CGAL's answer is no convex partition of the piece.
std::vector<Ring> optimal_parts_from(const Ring& piece, std::size_t beginning) {
  CgalPolygon polygon;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const Point& p = piece[(beginning + i) % piece.size()];
    polygon.push_back(Kernel::Point_2(p.x(), p.y()));
  }
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
    if (!convex(ring)) return {};
    sum += signed_area(ring);
    parts.push_back(std::move(ring));
  }
  const double whole = signed_area(piece);
  return std::abs(sum - whole) <= 1e-6 * whole ? parts : std::vector<Ring>{};
}

std::vector<Ring> optimal_parts(const Ring& piece) {
  constexpr std::size_t kBeginnings = 4;
  for (std::size_t k = 0; k < kBeginnings; ++k) {
    std::vector<Ring> parts = optimal_parts_from(piece, k * piece.size() / kBeginnings);
    if (!parts.empty()) return parts;
  }
  throw std::runtime_error(fmt::format("CGAL finds no optimal convex partition at ({}, {}); use the approximate one",
                                       piece.front().x(), piece.front().y()));
}

}  // namespace

std::vector<Ring> convex_partition_optimal(const Region& region, std::size_t most_corners) {
  const std::size_t corners = vertex_count(region);
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
