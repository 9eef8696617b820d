// Planners with one planted fault each, around a good one; and the check that must find it.
#pragma once

#include <string>
#include <vector>

#include "bench/registry.hpp"

namespace oxturn::testing {

struct PlantedFault {
  std::string planner;  // its name in faulty_registry()
  std::string check;    // that finds it
};
/// At least one for every check.
const std::vector<PlantedFault>& planted_faults();
/// The built-in registry with them, and with `good`, the planner without a fault.
const Registry& faulty_registry();

}  // namespace oxturn::testing
