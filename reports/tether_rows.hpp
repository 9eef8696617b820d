/// What a row says about its tether.
#pragma once

#include <optional>

#include "bench/results.hpp"

namespace oxturn {

/// The tether could be followed along the run's path, so that the other two functions have an answer.
bool tether_followed(const Row& row);
/// Metres by which the tether was pulled over its limit, 0 within rounding (10^-6 of the limit). Empty if not followed.
std::optional<double> over_limit(const Row& row);
/// The tether ended wound about something. Empty if not followed.
std::optional<bool> entangled(const Row& row);

}  // namespace oxturn
