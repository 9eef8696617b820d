// What the page knows, as JSON. Private to reports/viewer.
#pragma once

#include <string>

#include "reports/viewer/viewer.hpp"

namespace oxturn {

/// Coordinates are rounded to a millionth of the map's extent, times to milliseconds. '<' is written as \u003c, so that
/// no text can end the page's data.
std::string viewer_json(const ViewerData& data);

}  // namespace oxturn
