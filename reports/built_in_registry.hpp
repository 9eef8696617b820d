/// Everything that comes with oxturn.
///
///   const Registry registry = built_in_registry();
#pragma once

#include "bench/registry.hpp"

namespace oxturn {

Registry built_in_registry();

}  // namespace oxturn
