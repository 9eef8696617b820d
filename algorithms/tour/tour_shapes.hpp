/// Tours over shapes to be drawn: polylines, driven from either end, and polygons, left at the vertex of entry.
///
///   ShapeTour drawing;
///   drawing.shapes = {{.points = stroke}, {.points = outline, .closed = true}};
///   drawing.joined = {{{0, 0}, {1, 2}}};           // end 0 of the stroke is connected to vertex 2 of the outline
///   drawing.contained = {{1, 0}};                  // what lies inside the outline is drawn before it
///   drawing.start = Point(0, 0);                   // without: wherever it is cheapest
///   const ShapeTourModel model(drawing);
///   const Tour tour = solve_tour(model.problem(), context);
///   for (const ShapeVisit& v : model.visits(tour)) ...
///
/// After Vollprecht, "Path generation for the BeachBot", ETH Zurich 2014.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/tour/tour_problem.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct TourShape {
  Polyline points = {};
  bool closed = false;    // a polygon; driven in the order of its points
  bool one_way = false;   // a polyline that is driven from its first point to its last only
  std::string name = {};  // for messages; none: its number
};
/// "'eye'" or "3", for messages.
std::string label(const std::vector<TourShape>& shapes, std::size_t shape);

/// A vertex of a shape: of a polyline the first or the last.
struct ShapeVertex {
  std::size_t shape = 0, vertex = 0;
};

/// How containment is kept. strict: what is inside is drawn before what contains it. literal, as in Vollprecht (2014):
/// the robot never drives directly from a shape to one inside it; it may still do so by way of a third shape.
enum class Containment { strict, literal };

struct ShapeTour {
  std::vector<TourShape> shapes = {};
  std::vector<std::pair<ShapeVertex, ShapeVertex>> joined = {};     // connections that must be driven
  std::vector<std::pair<std::size_t, std::size_t>> contained = {};  // (outer shape, inner shape)
  Containment containment = Containment::strict;
  std::optional<Point> start = {}, end = {};  // none: free. A closed tour ends at its start
  /// The cost of a connection, the same in both directions, at least 0; none: straight distance.
  std::function<double(const Point&, const Point&)> connection = {};
};

/// A shape as it is driven: entered at `entry`; polylines backwards if that is their last point.
struct ShapeVisit {
  std::size_t shape = 0, entry = 0;
  friend bool operator==(const ShapeVisit&, const ShapeVisit&) = default;
};

/// The tour problem of a drawing. Shapes joined by connections are one element, driven from either end; a polygon is an
/// element with a pattern for each vertex.
class ShapeTourModel {
 public:
  /// Throws std::invalid_argument, naming the shapes, for a shape without points, a joined vertex that is no end of its
  /// polyline, an end joined twice, a polygon joined at two vertices, joints that close a cycle or lead against a
  /// one-way shape, and joints that contradict containment.
  explicit ShapeTourModel(ShapeTour drawing);
  ~ShapeTourModel();
  ShapeTourModel(ShapeTourModel&&) noexcept;

  const TourProblem& problem() const;
  /// The shapes in the order of a tour.
  std::vector<ShapeVisit> visits(const Tour& tour) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace oxturn
