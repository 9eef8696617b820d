/// The habits of simple vacuum cleaners, one motion each, the rule that ends a run, and the description that the
/// planners made of habits share.
///
///   struct Params : StopRule { double pitch = 0.9; };
///   void clean(const Params& p, Vacuum& vacuum, Rng&) {
///     while (const auto wall = spiral(vacuum, p.pitch * vacuum.tool_width(), vacuum.any_heading())) {}
///   }
///   PlannerInfo spiral_out() { return describe_habit<Params, clean>("spiral-out", "...", "...", {...}); }
///
/// Decisions   1. A robot that only bumps cannot know what it has missed. It knows what it has covered and how far it
///                has driven. So it stops when it has passed over the covered area `passes` times on average: length >=
///                passes * covered area / tool width. That ends on every map; a habit that drives in circles ends
///                soonest.
///             2. `length_limit` metres end a run as well, to compare habits at the same length.
///             3. Pose and headings are exact: no slip, no drift.
#pragma once

#include <optional>
#include <string>

#include "algorithms/baseline/bumper.hpp"
#include "algorithms/baseline/swept_cells.hpp"
#include "algorithms/coverage_planner.hpp"

namespace oxturn {

/// The parameters that all habits have; those of a planner derive from it.
struct StopRule {
  double passes = 8;
  double length_limit = 0;  // metres; 0: none
};

template <class P>
std::vector<Parameter<P>> with_stop_rule(std::vector<Parameter<P>> own) {
  own.push_back({"passes", &P::passes, Range{1, 1000},
                 "stop when the length is so many times the covered area over the tool's width"});
  own.push_back({"length_limit", &P::length_limit, Range{0, 1e9}, "stop after so many metres; 0: no such limit"});
  return own;
}

/// A robot that feels, remembers what it has covered, and knows when to stop.
class Vacuum {
 public:
  Vacuum(const Problem& problem, Context& context, const StopRule& rule);

  bool done() const;
  const Point& at() const { return bumper_.at(); }
  double tool_width() const { return bumper_.tool_width(); }
  double driven() const { return bumper_.driven(); }
  std::optional<Bumper::Wall> feel(double reach, const Point& towards, double cosine) const {
    return bumper_.feel(reach, towards, cosine);
  }
  /// As Bumper::drive, but no farther than the rule allows; a stop there is no contact.
  std::optional<Point> drive(const Point& to);
  /// Straight on until contact; nullopt: the run is over.
  std::optional<Point> drive_on(const Point& heading);
  /// Straight on from a wall for a random share of so many metres, or until contact.
  void leave_wall(const Point& heading, double farthest);

  /// A random unit vector.
  Point any_heading();
  /// A random unit vector that leads away from a wall, all such headings being equally likely.
  Point heading_off(const Point& away);

  /// The path, all with the tool on; records `swept_m2` and `bumps`. Throws Infeasible if the robot could not move.
  Path finish();

 private:
  double metres_left() const;

  const Problem& problem_;
  Context& context_;
  StopRule rule_;
  Bumper bumper_;
  SweptCells swept_;
  std::size_t bumps_ = 0;
  int stuck_ = 0;  // motions in a row that led nowhere
};

// Each motion begins where the robot is. It ends at a contact and returns the vector away from the wall; nullopt: the
// motion is complete or the run is over.

/// Archimedes' spiral, counter-clockwise from the robot, turns `pitch` metres apart; chord error tool width / 1000.
std::optional<Point> spiral(Vacuum& vacuum, double pitch, const Point& heading);

/// Along the wall on the right, `gap` metres from it (at least tool width / 1000), for one lap or `longest` metres.
/// Between walls that are nearer to each other the robot keeps to the middle, and turns around where it is stuck.
/// Begins beside a wall; `away` leads away from it and is updated.
void follow_wall(Vacuum& vacuum, double gap, double longest, Point& away);

/// Lanes back and forth, `pitch` metres apart, each from contact to contact, stepping aside towards `side`. Ends where
/// there is no room to step aside.
std::optional<Point> snake(Vacuum& vacuum, double pitch, const Point& heading, const Point& side);

/// A planner made of habits: clean(params, vacuum, rng) drives until the run is over.
template <class Params, void (*clean)(const Params&, Vacuum&, Rng&)>
Path plan_by_habits(const Params& p, const Problem& problem, Context& context) {
  Vacuum vacuum(problem, context, p);
  clean(p, vacuum, context.rng());
  return vacuum.finish();
}

template <class Params, void (*clean)(const Params&, Vacuum&, Rng&)>
PlannerInfo describe_habit(std::string name, std::string title, std::string guarantee,
                           std::vector<Parameter<Params>> own) {
  return describe<Params, plan_by_habits<Params, clean>>({.name = std::move(name),
                                                          .family = "baseline",
                                                          .title = std::move(title),
                                                          .citation = "after Hasan et al. 2014",
                                                          .capabilities = {Capability::online, Capability::holes},
                                                          .guarantee = std::move(guarantee),
                                                          .symmetries = {Symmetry::shift, Symmetry::scale},
                                                          .parameters = with_stop_rule<Params>(std::move(own))});
}

}  // namespace oxturn
