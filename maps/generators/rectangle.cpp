// An empty rectangle: shows the overhead of every planner. O(1).
#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {};

Region make(const Params& p, Rng&) { return floor_of(p); }

}  // namespace

GeneratorInfo rectangle() {
  return describe_site<Params>("rectangle", "an empty rectangle",
                               "one rectangle of the given size; no randomness, the seed changes nothing", {}, make);
}

}  // namespace oxturn::generator
