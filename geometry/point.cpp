#include "geometry/point.hpp"

#include "base/text.hpp"

namespace oxturn {

std::string to_text(const Point& p) { return "(" + to_decimal(p.x()) + ", " + to_decimal(p.y()) + ")"; }

}  // namespace oxturn
