/// The last resort for transits that would cross finished work: a path round it, however long, or why there is none.
///
///   LastDetours detours(problem, work, radius);
///   const LastDetour d = detours.find(exit, entry, context);
///   if (d.end == LastDetour::End::found) drive(d.path);
///
/// What is free is computed exactly: configuration space less all finished pieces, but for the discs about both ends in
/// which nothing counts (finished_work.hpp). If the ends are in different parts of it, finished work encloses one of
/// them: no path exists. Without a radius the shortest path is taken. With one, poses are searched from both ends
/// (smoothing/detour_search.hpp) until there is a curve, or none is left: then no curve exists, up to the search's
/// resolution (a quarter radius, five degrees).
/// Work may only be finished between two calls. Searches share an effort of some ten seconds.
#pragma once

#include <string>

#include "algorithms/context.hpp"
#include "algorithms/drawing/finished_work.hpp"
#include "algorithms/smoothing/curve.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct LastDetour {
  enum class End { found, enclosed, no_curve, effort_spent, by_hand };  // by_hand: a person's curve
  End end = End::effort_spent;
  Polyline path;  // if found
};
/// What the trace of the transits is called that cross finished work for this reason. Not of `found`.
std::string trace_of_crossing(LastDetour::End why);

class LastDetours {
 public:
  /// `radius`: 0: paths may have bends. References must outlive it.
  LastDetours(const Problem& problem, const FinishedWork& work, double radius);

  LastDetour find(const Pose& from, const Pose& to, const Context& context);

 private:
  void take_out_finished();
  /// What is free, and the discs about both points.
  Region around(const Point& from, const Point& to) const;
  LastDetour curve(const Region& free, const Pose& from, const Pose& to, const Context& context);

  const Problem& problem_;
  const FinishedWork& work_;
  double radius_, chord_;
  Region free_;
  std::vector<bool> taken_;               // pieces that are not free any more
  std::size_t poses_ = 0, vertices_ = 0;  // spent
};

}  // namespace oxturn
