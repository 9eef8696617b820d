// An empty rectangle: shows the overhead of every planner. O(1).
#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {};

Region make(const Params& p, Rng&) {
  check_site("rectangle", p);
  return finished(box_region({0, 0}, {p.width, p.height}), p);
}

}  // namespace

GeneratorInfo rectangle() {
  return describe_generator<Params>("rectangle", "an empty rectangle",
                                    "one rectangle of the given size; no randomness, the seed changes nothing",
                                    with_site<Params>({}), make);
}

}  // namespace oxturn::generator
