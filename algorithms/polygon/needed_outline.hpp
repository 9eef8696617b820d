/// Lanes, and as much of the outline as coverage needs.
///
///   struct Params : OutlineChoice { ... };                         // outline = true|needed|false, coverage
///   if (p.outline == OutlineExtent::needed)
///     return drive_needed_outline(problem, p.coverage, with_whole_outline, strips_in, order, context);
///
///      _____________        Lanes that end at walls across them leave little there: a small cusp between every second
///     | .---. .---. |       pair of lanes. A lap along such a wall covers hardly anything that is not covered yet;
///     | |   | |   | |       beside a wall along the lanes it may cover half a tool's width.
///     |_|___'-'___'_|
///
/// Lanes are laid in all of configuration space first. Each stretch of its boundary then has a worth: the area that
/// these lanes leave uncovered nearest to it, for its length. For each of a few least worths the stretches above it are
/// driven, lanes are laid anew in what these do not cover, and both are ordered by one tour. What is still missing of
/// the coverage is added as detours (lanes/repair.hpp). The shortest of these paths and the one with the whole outline
/// is the result.
///
/// Guarantee   the share `coverage` of the target; if that is 1, but for seams (lanes/repair.hpp)
/// Complexity  at most ten times that of lanes and outline, plus O(m log m) for paths of m segments
#pragma once

#include <functional>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lanes/strips.hpp"
#include "base/parameters.hpp"

namespace oxturn {

/// off: lanes alone; needed: what coverage needs of the outline; whole: every wall once.
enum class OutlineExtent { off, needed, whole };

struct OutlineChoice {
  OutlineExtent outline = OutlineExtent::whole;
  double coverage = 1;  // with outline = needed

  /// Is all of the target covered, if lanes and the whole outline do so?
  bool covers_walls() const {
    return outline == OutlineExtent::whole || (outline == OutlineExtent::needed && coverage >= 1);
  }
};
template <class P>
P with_whole_outline(P p) {
  p.outline = OutlineExtent::whole;
  return p;
}
/// `off`: what happens without an outline; empty: nothing to say.
template <class P>
std::vector<Parameter<P>> with_outline_choice(std::vector<Parameter<P>> own, const std::string& off = "") {
  own.push_back(
      {"outline", &P::outline, Choices{"false", "needed", "true"},
       "true: drive every wall once; needed: as much of the walls as `coverage` needs, or all of them if that "
       "is shorter; false: lanes only" +
           off});
  own.push_back({"coverage", &P::coverage, Range{0, 1, true}, "least share of the target, with outline = needed"});
  return own;
}

/// `whole`: the path with the whole outline.
/// `strips_in(region)`: strips of lanes that cover the region, a part of configuration space, but for what lies nearer
/// than half a tool's width to its boundary. Publishes each path that reaches the coverage.
Path drive_needed_outline(const Problem& problem, double coverage, Path whole,
                          const std::function<std::vector<Strip>(const Region&)>& strips_in, StripOrder order,
                          Context& context);

}  // namespace oxturn
