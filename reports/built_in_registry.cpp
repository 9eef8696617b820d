#include "reports/built_in_registry.hpp"

#include "reports/report.hpp"

namespace oxturn {

Registry built_in_registry() {
  return {built_in_planners(), built_in_metrics(), built_in_generators(), built_in_map_formats(), built_in_tables()};
}

}  // namespace oxturn
