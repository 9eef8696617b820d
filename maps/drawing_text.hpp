/// A path as the drawing robot's controller reads it: a line `x y rake` for each position.
///
///   write_file("plan.txt", drawing_text(path));
///
/// Positions are at most 0.05 m apart, evenly spaced between stops and changes of the rake; metres, y up. Where the
/// rake changes, the position is repeated. An empty line follows a position at which the robot stops and turns (by more
/// than 20 degrees, or into the other gear). Source: Vollprecht 2014, section 3.4.
#pragma once

#include <string>

#include "geometry/path.hpp"
#include "maps/svg_drawing.hpp"

namespace oxturn {

enum class RakeText {
  mask,  // bits of the lowered pins: 0, 8, 28, 62, 127
  pins,  // their number: 0, 1, 3, 5, 7
};

/// The pins of a leg follow from the width that it uses and the widths in `options`; all of the tool: 7.
std::string drawing_text(const Path& path, const DrawingOptions& options = {}, RakeText rake = RakeText::mask);

}  // namespace oxturn
