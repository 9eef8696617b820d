#include "reports/tether_rows.hpp"

namespace oxturn {

bool tether_followed(const Row& row) { return row.number("tether_limit_m") && row.number("tether_max_m"); }

std::optional<double> over_limit(const Row& row) {
  if (!tether_followed(row)) return std::nullopt;
  const double limit = *row.number("tether_limit_m"), over = *row.number("tether_max_m") - limit;
  return over > 1e-6 * limit ? over : 0;
}

std::optional<bool> entangled(const Row& row) {
  const auto value = row.number("tether_entangled");
  if (!tether_followed(row) || !value) return std::nullopt;
  return *value != 0;
}

}  // namespace oxturn
