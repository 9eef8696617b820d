#include "algorithms/lanes/inner_space.hpp"

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"

namespace oxturn {
namespace {

// Of half the tool's width. Laps lie a little deeper in the target's boundary than they reach, so that no seam is left,
// and configuration space is found again beside walls although the target errs inside.
constexpr double kInset = 0.998;
constexpr double kChord = 1e-3;     // w
constexpr double kSmallest = 0.25;  // w^2: components of less area are left for detours

}  // namespace

Region reachable_target(const Problem& problem, double margin, double chord) {
  if (margin <= 0 && !problem.limited()) return problem.target();
  const double w = problem.robot().tool_width;
  return intersect(problem.target(), dilate(problem.configuration_space(), w / 2 - margin, chord * w, Bound::inside));
}

Region inner_space(const Problem& problem) {
  const double w = problem.robot().tool_width;
  Region inner = intersect(erode(reachable_target(problem), kInset * w / 2, kChord * w, Bound::outside),
                           problem.configuration_space());
  std::erase_if(inner.polygons, [&](const Polygon& part) { return area(part) < kSmallest * w * w; });
  return inner;
}

}  // namespace oxturn
