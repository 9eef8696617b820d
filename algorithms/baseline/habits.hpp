// The habits of vacuum cleaners, one motion each, and the rule that says when to stop.
//
// Decisions   1. A robot that only bumps cannot know what it has missed. It knows what it has swept and how far it has
//                gone, so it stops when it has passed over what it has swept `passes` times in the mean: length >= passes
//                * swept area / tool width. That ends on every map; a habit that goes round in circles ends soonest.
//             2. `length_limit` metres end a run as well (for comparing habits at the same length).
//             3. Pose and headings are exact: no slip, no drift.
#pragma once

#include <optional>
#include <string>

#include "algorithms/baseline/bumper.hpp"
#include "algorithms/baseline/swept_cells.hpp"
#include "algorithms/coverage_planner.hpp"

namespace oxturn {

/// The parameters that all habits have; a habit's own derive from it.
struct StopRule {
  double passes = 8;
  double length_limit = 0;  // metres; 0: none
};

template <class P>
std::vector<Parameter<P>> with_stop_rule(std::vector<Parameter<P>> own) {
  own.push_back({"passes", &P::passes, Range{1, 1000},
                 "stop when the length is so many times the swept area over the tool's width"});
  own.push_back({"length_limit", &P::length_limit, Range{0, 1e9}, "stop after so many metres; 0: no such limit"});
  return own;
}

/// A robot that feels, remembers what it has swept, and knows when to stop.
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
  /// As Bumper::drive, but no farther than the rule allows: a stop there is no contact.
  std::optional<Point> drive(const Point& to);
  /// Straight on until contact; nullopt: done.
  std::optional<Point> drive_on(const Point& heading);

  /// A unit vector of any heading.
  Point any_heading();
  /// A unit vector that leads away from a wall, all such headings alike.
  Point heading_off(const Point& away);

  /// Where it went, all with the tool on; reports `swept_m2` and `bumps`. Throws Infeasible if it could not move at all.
  Path finish();

 private:
  double metres_left() const;

  const Problem& problem_;
  Context& context_;
  StopRule rule_;
  Bumper bumper_;
  SweptCells swept_;
  std::size_t bumps_ = 0;
  int stuck_ = 0;  // stretches in a row that led nowhere
};

// Each motion begins where the robot is and ends at contact (the vector away from the wall), or when it is through or the
// rule says stop (nullopt).

/// Archimedes' spiral, counter-clockwise from where the robot is, laps `pitch` metres apart; chord error tool width / 1000.
std::optional<Point> spiral(Vacuum& vacuum, double pitch, const Point& heading);

/// Along the wall at the right hand, `gap` metres from it (at least tool width / 1000), for a lap or `longest` metres.
/// Between walls that are nearer to each other it keeps to the middle, and turns round where it is stuck. Begins beside a
/// wall; `away` leads away from it and is kept up to date.
void follow(Vacuum& vacuum, double gap, double longest, Point& away);

/// Lanes back and forth, `pitch` metres apart, each from contact to contact, stepping aside towards `side`; ends where
/// there is no room to step aside.
std::optional<Point> snake(Vacuum& vacuum, double pitch, const Point& heading, const Point& side);

}  // namespace oxturn
