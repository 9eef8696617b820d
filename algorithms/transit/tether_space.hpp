/// A tethered robot's configuration space cut open along the anchor's cut locus: safe for any coverage planner.
///
///   const TetherSpace space(problem, "my-planner");
///   return cover_components(space, [&](const TetherSpace::Component& c, Context& inner) {
///     return planner.plan(c.problem, inner);               // an ordinary planner
///   }, true, context);
///
///                 .-------.
///        anchor   |       |  cut locus: points with two shortest paths to the anchor, one on either side of
///          o      |  obst.|- - - - - -      the obstacle. The robot must not cross it; the tool may reach over it.
///                 |       |
///                 '-------'
///
/// Free space without the cut locus of the anchor is star-shaped about the anchor along geodesics, hence contractible.
/// So if the tether starts along the geodesic and the robot never crosses the cut, the taut tether always equals the
/// geodesic to the robot's position: never longer than that, never wound round an obstacle, never driven over, in
/// whatever order the space is covered. A tethered problem becomes an ordinary one with a line that must not be
/// crossed.
///
/// Where the cut passes an obstacle more closely than the robot can, it divides configuration space into several
/// connected components, although free space stays connected. A component other than the start's is entered by crossing
/// the cut and crossing back, next to that obstacle. Inside, the tether is the geodesic again; on the way in it is a
/// little longer.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "geometry/tether/tethered_path.hpp"

namespace oxturn {

class TetherSpace {
 public:
  /// `problem` must outlive it; `planner` is named in messages. Throws Unsupported if the robot has no tether,
  /// Infeasible if the start lies on the cut itself (possible only if the anchor is elsewhere).
  TetherSpace(const Problem& problem, const std::string& planner);
  ~TetherSpace();

  const Problem& problem() const { return problem_; }
  const GeodesicField& field() const { return problem_.tether()->geodesics(); }
  double tether_length() const { return problem_.robot().tether->length; }  // metres

  /// The cut locus as far as it concerns configuration space.
  const std::vector<Polyline>& cut() const { return cut_; }
  /// Width of the strip that is removed along the cut, metres.
  double cut_width() const { return width_; }

  /// A connected component of configuration space without the cut. Simply connected.
  struct Component {
    Problem problem;      // the problem with the component as configuration space; starts at the component's entry
    Polyline entry_path;  // from the problem's start to the entry, in the class of the geodesic and within the tether
                          // length limit
  };
  /// The start's component first, then those that the robot can enter, by the distance of their entries from the
  /// anchor.
  const std::vector<Component>& components() const { return components_; }
  /// Of the start's component: its space, and the problem in it for any planner.
  const Region& cut_space() const { return cut_problem().configuration_space(); }
  const Problem& cut_problem() const { return components_.front().problem; }
  /// Components that the tether does not let the robot enter, and components of negligible area.
  const Region& unreached() const { return unreached_; }

  /// From a point of one component to a point of another one (or the same). The tether is the geodesic at both ends and
  /// keeps its length limit in between.
  Polyline path(const Component& from_component, const Point& from, const Component& to_component,
                const Point& to) const;

  /// For paths of any homotopy class; built at the first call.
  const TetheredWorld& world() const;

 private:
  void cut_open();
  void add_components(std::vector<Polygon> polygons);
  std::optional<Polyline> path_into(const Polygon& component, Point& entry) const;
  bool keeps_limit(const Polyline& path) const;

  const Problem& problem_;
  double width_;
  std::vector<Polyline> cut_;
  std::vector<Component> components_;
  Region unreached_;
  mutable std::unique_ptr<const TetheredWorld> world_;
};

/// Covers each component by a call of `cover`, whose path begins at the component's start, and joins the paths: the
/// start's component first, then always the one whose entry has the shortest path. The connections are transit. A
/// component for which `cover` throws Infeasible is skipped; if that happens for all, the first such exception is
/// thrown.
Path cover_components(const TetherSpace& space,
                      const std::function<Path(const TetherSpace::Component&, Context&)>& cover, bool return_home,
                      Context& context);

}  // namespace oxturn
