// What stc-spiral and stc-scan share: the tree that grows while the robot goes round it.
#pragma once

#include <string>

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

struct OnlineStcParams {
  double cell_size = 0;
  bool partial = false;
  std::string align = "axes";
  std::string sensing = "map";
};

/// `scan`: children sideways are postponed (stc_scan.cpp). Throws Infeasible if no coarse cell about the start is free
/// (not for partial), or if the robot cannot step anywhere.
Path grow_and_go_round(const Problem& problem, Context& context, const OnlineStcParams& params, bool scan);

/// Name, title and so on are the caller's.
std::vector<Parameter<OnlineStcParams>> online_stc_parameters();

}  // namespace oxturn
