// What tethered planners share: the problem's space cut open, so that a leash is no longer hard.
//
// Free space less the cut locus of the anchor is star-shaped about the anchor along geodesics, hence contractible. So
// every robot path that starts with the string along the geodesic and never crosses the cut keeps its string equal to
// the geodesic of where it stands: never longer than that, never wound, never driven over, in whatever order it
// sweeps (algorithms.md section 1). A tethered problem becomes an ordinary one with a line that must not be crossed.
// The tool may reach over the line.
//
// Where the cut passes an obstacle nearer than the robot can, it cuts configuration space into several parts although
// free space is one. A part other than the start's is entered across the cut and back, next to that obstacle; inside,
// the string is the geodesic again. On the way in it is a little longer than that.
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
  /// `problem` must outlive it. Throws Unsupported ("planner 'x' needs a robot with a tether; ...") if its robot has none,
  /// Infeasible if the start lies in the cut itself (possible only if the anchor is elsewhere).
  TetherSpace(const Problem& problem, const std::string& planner);
  ~TetherSpace();

  const Problem& problem() const { return problem_; }
  const GeodesicField& field() const { return problem_.tether()->geodesics(); }
  double tether_length() const { return problem_.robot().tether->length; }  // metres

  /// Where shortest ways meet, as far as that is of interest, with the slit's width.
  const std::vector<Polyline>& cut() const { return cut_; }
  double cut_width() const { return width_; }

  /// A part of configuration space less the slit: simply connected.
  struct Component {
    Problem problem;   // the problem with the part as configuration space; starts at its entry
    Polyline entry_path;  // from the problem's start to the entry, in the class of the geodesic; the string keeps the leash
  };
  /// The start's part first, then those that the robot can enter, by the distance of their entries from the anchor.
  const std::vector<Component>& components() const { return parts_; }
  /// The start's part: its space, and the problem for any planner.
  const Region& cut_space() const { return cut_problem().configuration_space(); }
  const Problem& cut_problem() const { return parts_.front().problem; }
  /// What the cut isolates and the leash does not let the robot enter, and crumbs of no area.
  const Region& slivers() const { return slivers_; }

  /// From a place in one part to a place in another (or the same), string the geodesic at both ends and within the
  /// leash on the way.
  Polyline path(const Component& from_part, const Point& from, const Component& to_part, const Point& to) const;

  /// For ways of any class; built at the first call.
  const TetheredWorld& world() const;

 private:
  void cut_open();
  std::optional<Polyline> path_into(const Polygon& part, Point& entry) const;

  const Problem& problem_;
  double width_;
  std::vector<Polyline> cut_;
  std::vector<Component> parts_;
  Region slivers_;
  mutable std::unique_ptr<const TetheredWorld> world_;
};

/// Sweeps every part by `sweep` (which begins at the part's start) and joins the paths: the start's part first, then
/// always the part whose entry is nearest by way; ways between are transit. A part for which `sweep` throws Infeasible
/// is left out; if that is all of them, so is the answer.
Path cover_components(const TetherSpace& leash, const std::function<Path(const TetherSpace::Component&, Context&)>& sweep, bool return_home,
                 Context& context);

}  // namespace oxturn
