/// What links between the strokes of a tour cost, as far as that is known, and what asking for them has cost so far.
///
///   LinkCosts costs(patterns, [&](PatternId from, PatternId to) { return least_length(from, to); });
///   costs(3, 8);                                 // the bound, or what it was set to
///   costs.set(3, 8, 17.5);                       // the link that was found is so long
///   if (costs.effort() > most) ...               // counted, so the same on every machine
///
/// Few patterns have a table of all pairs. With many, what was asked for lately is kept in one of a fixed number of
/// slots for each pattern, so memory is O(n) for n patterns, and a bound is seldom computed twice.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "algorithms/tour/connection_cost.hpp"

namespace oxturn {

class LinkCosts {
 public:
  using Bound = std::function<double(PatternId from, PatternId to)>;
  static constexpr std::size_t kMostTabulated = 2000;  // patterns
  static constexpr std::uint64_t kBoundEffort = 30;    // of a bound, some curves, in looks

  /// `bound` is a least cost; computed at once for all pairs of at most kMostTabulated patterns.
  LinkCosts(std::size_t patterns, Bound bound);
  double operator()(PatternId from, PatternId to) const;
  /// From now on.
  void set(PatternId from, PatternId to, double cost);
  /// Was it set?
  bool known(PatternId from, PatternId to) const { return known_.contains({from, to}); }
  bool none_known() const { return known_.empty(); }
  bool tabulated() const { return !table_.empty(); }
  /// Looks so far; each bound that was computed counts as kBoundEffort of them.
  std::uint64_t effort() const { return effort_; }

 private:
  struct Slot {
    PatternId from = kNoPattern, to = kNoPattern;
    double cost = 0;
  };
  Slot& slot(PatternId from, PatternId to) const;
  double computed(PatternId from, PatternId to) const;

  std::size_t patterns_;
  Bound bound_;
  std::vector<double> table_;         // by pairs, if there are not too many
  mutable std::vector<Slot> recent_;  // otherwise
  std::map<std::pair<PatternId, PatternId>, double> known_;
  mutable std::uint64_t effort_ = 0;
};

}  // namespace oxturn
