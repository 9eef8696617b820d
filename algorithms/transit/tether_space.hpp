/// The problem's space cut open so that the tether is no longer a constraint: what tethered planners share.
///
///   const TetherSpace tether(problem, "berg");
///   Path path = cover_components(tether, [&](const TetherSpace::Component& c, Context& inner) {
///     return planner.plan(c.problem, inner);
///   }, false, context);
///
/// Free space without the cut locus of the anchor is star-shaped about the anchor along geodesics, hence contractible.
/// So for every robot path that starts with the tether along the geodesic and never crosses the cut, the taut tether is
/// the geodesic of the robot's position: never longer than that, never wound around an obstacle, never driven over, in
/// whatever order the robot covers the space. A tethered problem becomes an ordinary one with a line that must not be
/// crossed. The tool may reach over the line.
///
///        +------------------+
///        |       +--+~~~~~~~|     A  anchor
///        |  A    |  |       |     ~  the cut, behind the obstacle
///        |       +--+       |
///        +------------------+
///
/// Where the cut passes an obstacle nearer than the robot can, it divides configuration space into several components
/// although free space is connected. A component other than the start's is entered across the cut and back, next to
/// that obstacle. Inside, the tether is the geodesic again; on the way in it is a little longer.
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "geometry/tether/tethered_path.hpp"

namespace oxturn {

/// What space is cut open along: the anchor's cut locus; or straight bridges, where these are shorter in all and the
/// tether is long enough for them (bridge_cut.hpp). With bridges the tether is not the geodesic, but still determined
/// by the robot's position, and there is one component.
enum class TetherCut { geodesic, least };

class TetherSpace {
 public:
  /// `problem` must outlive it. Throws Unsupported ("planner 'x' needs a robot with a tether; ...") if its robot has
  /// none, Infeasible if the start lies in the cut itself (possible only if the anchor is elsewhere).
  TetherSpace(const Problem& problem, const std::string& planner, TetherCut cut = TetherCut::geodesic);
  ~TetherSpace();

  const Problem& problem() const { return problem_; }
  const GeodesicField& field() const { return problem_.tether()->geodesics(); }
  double tether_length() const { return problem_.robot().tether->length; }  // metres

  /// The lines of the cut near configuration space, and the width that is removed along them.
  const std::vector<Polyline>& cut() const { return cut_; }
  double cut_width() const { return width_; }

  /// A connected component of configuration space without the cut: simply connected.
  struct Component {
    Problem problem;      // with the component as configuration space; starts at its entry
    Polyline entry_path;  // from the start to the entry, in the class of the geodesic and within the tether's length
    std::size_t index;    // among components()
  };
  /// The start's component first, then those that the robot can enter, by their entries' distance from the anchor.
  /// Found at the first call; not safe from several threads.
  const std::vector<Component>& components() const;
  /// The one in which p is; nullptr if p is in none of them.
  const Component* component_at(const Point& p) const;
  /// Of the start's component: its space, and the problem for any planner.
  const Region& cut_space() const { return home_->problem.configuration_space(); }
  const Problem& cut_problem() const { return home_->problem; }
  /// Components that the tether does not let the robot enter, or that are too small. As components().
  const Region& unreached() const;

  /// From a point of one component to a point of another (or the same). At both ends the tether is the geodesic, and it
  /// is within its length on the way.
  Polyline path(const Component& from_component, const Point& from, const Component& to_component,
                const Point& to) const;

  /// For paths of any class. Built at the first call.
  const TetheredWorld& world() const;

 private:
  struct Locator;
  /// Of one of others_: across the cut.
  struct Entry {
    double away;  // metres from the anchor
    Point at;
    std::size_t other;
    bool tried = false;
    std::optional<Component> component = {};  // once it has been tried; none if the robot cannot enter
  };
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  void cut_open();
  void find_entries() const;
  void find_components() const;
  std::optional<std::size_t> polygon_at(const Point& p) const;
  const Component* entered(std::size_t rank) const;
  std::optional<Polyline> path_out(const Point& p, std::size_t ranks) const;
  std::optional<Polyline> path_into(std::size_t rank) const;

  const Problem& problem_;
  double width_;
  std::vector<Polyline> cut_;
  std::optional<Component> home_;                        // the start's
  std::vector<Polygon> others_;                          // as the cut leaves them
  mutable std::vector<Entry> entries_;                   // by distance from the anchor: their ranks
  mutable std::vector<std::size_t> rank_of_other_;       // kNone: too small, or out of reach
  mutable std::vector<std::size_t> component_of_other_;  // among components(); kNone: unreached
  mutable std::unique_ptr<const Locator> locator_;
  mutable std::vector<Component> components_;
  mutable Region unreached_;
  mutable std::unique_ptr<const TetheredWorld> world_;
};

/// Covers every component by `cover` (whose path begins at the component's start) and joins the paths: the start's
/// component first, then always the one whose entry is nearest by path, or, where there are more than 256, depth-first
/// over the tree of their entry paths. Paths in between are transit. Components for which `cover` throws Infeasible are
/// left out; if all are, this throws the first of these exceptions.
Path cover_components(const TetherSpace& tether,
                      const std::function<Path(const TetherSpace::Component&, Context&)>& cover, bool return_home,
                      Context& context);

}  // namespace oxturn
