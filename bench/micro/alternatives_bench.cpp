// Our overlay and orientation predicate against GEOS, Boost.Polygon, Clipper 6 and CGAL, on the work that oxturn does.
// The figures in geometry/overlay/arrangement.hpp and geometry/predicates.hpp come from here:
//
//   cmake --preset release -DOXTURN_ALTERNATIVES=ON && ninja -C build/release oxturn_alternatives
//   build/release/bench/micro/oxturn_alternatives --benchmark_counters_tabular=true
//
// Conversions are not timed. `area` must agree between libraries; `flaws` is 1 if find_flaw() objects to the result.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>
#include <geos_c.h>

#include <algorithm>
#include <array>
#include <boost/polygon/polygon.hpp>
#include <cmath>
#include <memory>
#include <polyclipping/clipper.hpp>

#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/overlay/validity.hpp"
#include "geometry/predicates.hpp"
#include "geometry/raster.hpp"

namespace oxturn {
namespace {

// The work.

constexpr double kToolWidth = 0.4, kChordError = 0.4e-3;

/// What a robot covers on straight lanes through a square hall: one capsule for each metre, overlapping its neighbours.
std::vector<Region> capsules(std::int64_t count) {
  const auto side = static_cast<int>(std::lround(std::sqrt(static_cast<double>(count) * 0.36)));
  const double radius = kToolWidth / 2;
  const int steps = static_cast<int>(std::ceil(kPi / (2 * std::acos(1 - kChordError / radius))));
  Rng rng(1);
  std::vector<Region> out;
  for (double y = 0; static_cast<std::int64_t>(out.size()) < count; y += 0.36)
    for (int x = 0; x < side && static_cast<std::int64_t>(out.size()) < count; ++x) {
      const Point a(x, y + 1e-3 * rng.unit()), b(x + 1, y + 1e-3 * rng.unit());
      Ring ring;
      for (int k = 0; k <= steps; ++k) ring.push_back(b + rotated({0, -radius}, kPi * k / steps));
      for (int k = 0; k <= steps; ++k) ring.push_back(a + rotated({0, radius}, kPi * k / steps));
      out.push_back({{{ring, {}}}});
    }
  return out;
}

/// Cells of 0.4 m, a tenth of them obstacles: `obstacles` of them, about.
Region speckled(std::int64_t obstacles) {
  Rng rng(1);
  const int n = static_cast<int>(std::lround(std::sqrt(10.0 * static_cast<double>(obstacles))));
  BitGrid grid({0, 0}, 0.4, n, n);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) grid.set(i, j, !rng.chance(0.1));
  return trace(grid);
}
constexpr double kRadius = 0.19, kFineError = 0.02e-3;

/// A square hall with so many vertices, on obstacles of 4 to 16.
Region hall(std::int64_t vertices) {
  Rng rng(17);
  const int side = static_cast<int>(std::sqrt(static_cast<double>(vertices) / 10));
  Region region = box_region({0, 0}, {1.0 * side, 1.0 * side});
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      Ring hole;
      const int n = rng.between(4, 16);
      const double radius = rng.between(0.15, 0.45);
      for (int k = 0; k < n; ++k)
        hole.push_back(Point(i + 0.5, j + 0.5) + rotated({radius, 0}, -2 * kPi * (k + 0.7 * rng.unit()) / n));
      region.polygons[0].holes.push_back(hole);
    }
  return region;
}
Region turned(const Region& region) {
  const Point centre = bounding_box(region).centre();
  return transformed(transformed(region, 0, -centre), 0.3, centre);
}

void report(benchmark::State& state, const Region& result) {
  state.counters["area"] = area(result);
  state.counters["vertices"] = static_cast<double>(vertex_count(result));
  state.counters["flaws"] = find_flaw(result) ? 1 : 0;
}

// Libraries: each has a type, conversions, and the operations that it offers.

struct Ours {
  using Shape = Region;
  static Shape from(const Region& r) { return r; }
  static Region to(const Shape& s) { return s; }
  static Shape unite(const std::vector<Shape>& parts) { return oxturn::unite(parts); }
  static Shape intersect(const Shape& a, const Shape& b) { return oxturn::intersect(a, b); }
  static Shape erode_dilate(const Shape& s) {
    return dilate(erode(s, kRadius, kChordError, Bound::inside), kRadius, kFineError, Bound::inside);
  }
};

struct Geos {
  struct Shape {
    explicit Shape(GEOSGeometry* g) : geometry(g, GEOSGeom_destroy) {}
    std::shared_ptr<GEOSGeometry> geometry;
  };
  static void ensure_started() {
    static const bool started = (initGEOS(nullptr, nullptr), true);
    static_cast<void>(started);
  }
  static GEOSGeometry* ring(const Ring& r) {
    GEOSCoordSequence* points = GEOSCoordSeq_create(static_cast<unsigned>(r.size() + 1), 2);
    for (unsigned i = 0; i <= r.size(); ++i) {
      const Point& p = r[i % r.size()];
      GEOSCoordSeq_setXY(points, i, p.x(), p.y());
    }
    return GEOSGeom_createLinearRing(points);
  }
  static Shape from(const Region& region) {
    ensure_started();
    std::vector<GEOSGeometry*> polygons;
    for (const Polygon& p : region.polygons) {
      std::vector<GEOSGeometry*> holes;
      for (const Ring& h : p.holes) holes.push_back(ring(h));
      polygons.push_back(GEOSGeom_createPolygon(ring(p.outer), holes.data(), static_cast<unsigned>(holes.size())));
    }
    return Shape(GEOSGeom_createCollection(GEOS_MULTIPOLYGON, polygons.data(), static_cast<unsigned>(polygons.size())));
  }
  static Ring ring(const GEOSGeometry* g) {
    const GEOSCoordSequence* points = GEOSGeom_getCoordSeq(g);
    unsigned n = 0;
    GEOSCoordSeq_getSize(points, &n);
    Ring out(n - 1);
    for (unsigned i = 0; i + 1 < n; ++i) GEOSCoordSeq_getXY(points, i, &out[i].x(), &out[i].y());
    return out;
  }
  static Region to(const Shape& s) {
    Region out;
    for (int k = 0; k < GEOSGetNumGeometries(s.geometry.get()); ++k) {
      const GEOSGeometry* g = GEOSGetGeometryN(s.geometry.get(), k);
      if (GEOSGeomTypeId(g) != GEOS_POLYGON) continue;
      Polygon p{ring(GEOSGetExteriorRing(g)), {}};
      for (int h = 0; h < GEOSGetNumInteriorRings(g); ++h) p.holes.push_back(ring(GEOSGetInteriorRingN(g, h)));
      out.polygons.push_back(std::move(p));
    }
    return out;
  }
  static Shape unite(const std::vector<Shape>& parts) {
    std::vector<GEOSGeometry*> all;
    for (const Shape& s : parts) all.push_back(GEOSGeom_clone(s.geometry.get()));
    const Shape collection(
        GEOSGeom_createCollection(GEOS_GEOMETRYCOLLECTION, all.data(), static_cast<unsigned>(all.size())));
    return Shape(GEOSUnaryUnion(collection.geometry.get()));
  }
  static Shape intersect(const Shape& a, const Shape& b) {
    return Shape(GEOSIntersection(a.geometry.get(), b.geometry.get()));
  }
  static int quarter_steps(double error) {
    return static_cast<int>(std::ceil(kPi / 4 / std::acos(1 - error / kRadius)));
  }
  static Shape erode_dilate(const Shape& s) {
    const Shape eroded(GEOSBuffer(s.geometry.get(), -kRadius, quarter_steps(kChordError)));
    return Shape(GEOSBuffer(eroded.geometry.get(), kRadius, quarter_steps(kFineError)));
  }
};

// Both integer libraries: a lattice of 2^-22 metres, which keeps coordinates below 2^30.
constexpr double kScale = 1 << 22;
std::int64_t to_integer(double v) { return std::llround(v * kScale); }

struct Clipper {
  using Shape = ClipperLib::Paths;
  static Shape from(const Region& region) {
    Shape out;
    for_each_ring(region, [&](const Ring& r) {
      ClipperLib::Path path;
      for (const Point& p : r) path.push_back({to_integer(p.x()), to_integer(p.y())});
      out.push_back(std::move(path));
    });
    return out;
  }
  static Ring ring(const ClipperLib::Path& path) {
    Ring out;
    for (const ClipperLib::IntPoint& p : path)
      out.push_back(Point(static_cast<double>(p.X), static_cast<double>(p.Y)) / kScale);
    return out;
  }
  static void add(const ClipperLib::PolyNode& outer, Region& out) {
    Polygon p{ring(outer.Contour), {}};
    for (const ClipperLib::PolyNode* hole : outer.Childs) p.holes.push_back(ring(hole->Contour));
    out.polygons.push_back(std::move(p));
    for (const ClipperLib::PolyNode* hole : outer.Childs)
      for (const ClipperLib::PolyNode* island : hole->Childs) add(*island, out);
  }
  static Region to(const Shape& s) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(s, ClipperLib::ptSubject, true);
    ClipperLib::PolyTree tree;
    clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    Region out;
    for (const ClipperLib::PolyNode* outer : tree.Childs) add(*outer, out);
    return out;
  }
  static Shape unite(const std::vector<Shape>& parts) {
    ClipperLib::Clipper clipper;
    for (const Shape& s : parts) clipper.AddPaths(s, ClipperLib::ptSubject, true);
    Shape out;
    clipper.Execute(ClipperLib::ctUnion, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return out;
  }
  static Shape intersect(const Shape& a, const Shape& b) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(a, ClipperLib::ptSubject, true);
    clipper.AddPaths(b, ClipperLib::ptClip, true);
    Shape out;
    clipper.Execute(ClipperLib::ctIntersection, out, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return out;
  }
  static Shape offset(const Shape& s, double radius, double error) {
    ClipperLib::ClipperOffset offset(2, error * kScale);
    offset.AddPaths(s, ClipperLib::jtRound, ClipperLib::etClosedPolygon);
    Shape out;
    offset.Execute(out, radius * kScale);
    return out;
  }
  static Shape erode_dilate(const Shape& s) { return offset(offset(s, -kRadius, kChordError), kRadius, kFineError); }
};

struct BoostPolygon {
  using Shape = boost::polygon::polygon_set_data<int>;
  using Holed = boost::polygon::polygon_with_holes_data<int>;
  using IntPoint = boost::polygon::point_data<int>;
  static std::vector<IntPoint> points(const Ring& r) {
    std::vector<IntPoint> out;
    for (const Point& p : r) out.push_back({static_cast<int>(to_integer(p.x())), static_cast<int>(to_integer(p.y()))});
    return out;
  }
  static Shape from(const Region& region) {
    Shape out;
    for (const Polygon& p : region.polygons) {
      Holed polygon;
      const auto outer = points(p.outer);
      polygon.set(outer.begin(), outer.end());
      std::vector<boost::polygon::polygon_data<int>> holes;
      for (const Ring& h : p.holes) {
        const auto hole = points(h);
        holes.emplace_back(hole.begin(), hole.end());
      }
      polygon.set_holes(holes.begin(), holes.end());
      out.insert(polygon);
    }
    return out;
  }
  template <class P>
  static Ring ring(const P& polygon) {
    Ring out;
    for (auto p = polygon.begin(); p != polygon.end(); ++p) out.push_back(Point((*p).x(), (*p).y()) / kScale);
    while (out.size() > 1 && out.back() == out.front()) out.pop_back();
    return out;
  }
  static Region to(const Shape& s) {
    std::vector<Holed> polygons;
    s.get(polygons);
    Region out;
    for (const Holed& polygon : polygons) {
      Polygon p{ring(polygon), {}};
      for (auto h = polygon.begin_holes(); h != polygon.end_holes(); ++h) p.holes.push_back(ring(*h));
      out.polygons.push_back(std::move(p));
    }
    return out;
  }
  static Shape unite(const std::vector<Shape>& parts) {
    Shape out;
    for (const Shape& s : parts) out.insert(s);
    out.clean();
    return out;
  }
  static Shape intersect(const Shape& a, const Shape& b) {
    using boost::polygon::operators::operator&;
    Shape out;
    out = a & b;
    out.clean();
    return out;
  }
  static int circle_steps(double error) { return static_cast<int>(std::ceil(kPi / std::acos(1 - error / kRadius))); }
  static Shape erode_dilate(const Shape& s) {
    const auto radius = static_cast<int>(to_integer(kRadius));
    Shape out = s;
    out.resize(-radius, true, circle_steps(kChordError));
    out.resize(radius, true, circle_steps(kFineError));
    return out;
  }
};

struct Cgal {
  using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
  using Holed = CGAL::Polygon_with_holes_2<Kernel>;
  using Simple = CGAL::Polygon_2<Kernel>;
  using Shape = std::vector<Holed>;
  static Simple ring(const Ring& r) {
    Simple out;
    for (const Point& p : r) out.push_back({p.x(), p.y()});
    return out;
  }
  static Ring ring(const Simple& polygon) {
    Ring out;
    for (auto v = polygon.vertices_begin(); v != polygon.vertices_end(); ++v)
      out.emplace_back(CGAL::to_double(v->x()), CGAL::to_double(v->y()));
    return out;
  }
  static Shape from(const Region& region) {
    Shape out;
    for (const Polygon& p : region.polygons) {
      Holed polygon(ring(p.outer));
      for (const Ring& h : p.holes) polygon.add_hole(ring(h));
      out.push_back(std::move(polygon));
    }
    return out;
  }
  static Region to(const Shape& s) {
    Region out;
    for (const Holed& polygon : s) {
      Polygon p{ring(polygon.outer_boundary()), {}};
      for (auto h = polygon.holes_begin(); h != polygon.holes_end(); ++h) p.holes.push_back(ring(*h));
      out.polygons.push_back(std::move(p));
    }
    return out;
  }
  static Shape unite(const std::vector<Shape>& parts) {
    Shape all, out;
    for (const Shape& s : parts) all.insert(all.end(), s.begin(), s.end());
    CGAL::join(all.begin(), all.end(), std::back_inserter(out));
    return out;
  }
  static Shape intersect(const Shape& a, const Shape& b) {
    CGAL::Polygon_set_2<Kernel> set(a[0]);
    set.intersection(b[0]);
    Shape out;
    set.polygons_with_holes(std::back_inserter(out));
    return out;
  }
};

template <class Library>
void BM_UniteCapsules(benchmark::State& state) {
  std::vector<typename Library::Shape> parts;
  for (const Region& r : capsules(state.range(0))) parts.push_back(Library::from(r));
  typename Library::Shape result = parts[0];
  for (auto _ : state) result = Library::unite(parts);
  report(state, Library::to(result));
}

template <class Library>
void BM_ErodeDilate(benchmark::State& state) {
  const auto shape = Library::from(speckled(state.range(0)));
  auto result = shape;
  for (auto _ : state) result = Library::erode_dilate(shape);
  report(state, Library::to(result));
}

template <class Library>
void BM_Intersect(benchmark::State& state) {
  const Region region = hall(state.range(0));
  const auto a = Library::from(region), b = Library::from(turned(region));
  auto result = a;
  for (auto _ : state) result = Library::intersect(a, b);
  report(state, Library::to(result));
}

#define OXTURN_WORK(task, library) \
  BENCHMARK_TEMPLATE(task, library)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond)
OXTURN_WORK(BM_UniteCapsules, Ours);
OXTURN_WORK(BM_UniteCapsules, Geos);
OXTURN_WORK(BM_UniteCapsules, BoostPolygon);
OXTURN_WORK(BM_UniteCapsules, Clipper);
OXTURN_WORK(BM_UniteCapsules, Cgal);
OXTURN_WORK(BM_ErodeDilate, Ours)->Arg(100);
OXTURN_WORK(BM_ErodeDilate, Geos);
OXTURN_WORK(BM_ErodeDilate, BoostPolygon)->Arg(100);
OXTURN_WORK(BM_ErodeDilate, Clipper);
OXTURN_WORK(BM_Intersect, Ours)->Arg(100000);
OXTURN_WORK(BM_Intersect, Geos)->Arg(100000);
OXTURN_WORK(BM_Intersect, BoostPolygon)->Arg(100000);
OXTURN_WORK(BM_Intersect, Clipper)->Arg(100000);
OXTURN_WORK(BM_Intersect, Cgal)->Arg(100000);

}  // namespace
}  // namespace oxturn
