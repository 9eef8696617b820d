// The list of map generators. To add one: its file, two lines here, one line in CMakeLists.txt, a test.
#include "maps/generators.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "base/text.hpp"
#include "geometry/overlay/validity.hpp"

namespace oxturn {

// In a namespace of their own: a planner may have the same name as a generator.
namespace generator {
GeneratorInfo rectangle();
GeneratorInfo polygon();
GeneratorInfo clutter();
GeneratorInfo rooms();
GeneratorInfo maze();
GeneratorInfo cave();
GeneratorInfo comb();
GeneratorInfo spiral();
GeneratorInfo field();
GeneratorInfo berg_rectangle();
GeneratorInfo berg_rooms();
GeneratorInfo divided_corridor();
GeneratorInfo pillars();
GeneratorInfo speckle();
GeneratorInfo hyun();
GeneratorInfo polyomino();
}  // namespace generator

Generators built_in_generators() {
  using namespace generator;
  return Generators("generator",
                    {rectangle(), polygon(), clutter(), rooms(), maze(), cave(), comb(), spiral(), field(),
                     berg_rectangle(), berg_rooms(), divided_corridor(), pillars(), speckle(), hyun(), polyomino()});
}

Map generate(const std::string& generator, const Settings& settings, std::uint64_t seed, const Generators& generators) {
  return generate(generators.find(generator), settings, seed);
}

Map generate(const GeneratorInfo& info, const Settings& settings, std::uint64_t seed) {
  // The name is mixed in, so that two families with the same seed do not use the same random numbers.
  Rng rng(mix(seed, info.name));
  Map map;
  map.name = fmt::format("{}-{}", info.name, seed);
  map.family = info.name;
  map.source = fmt::format("{} --seed {}", info.name, seed);
  for (const auto& [name, value] : settings) map.source += fmt::format(" --set {}={}", name, to_text(value));
  Site site = info.make(settings, rng);
  map.free = std::move(site.free);
  map.target_area = std::move(site.target_area);
  // Every generator guarantees this: a violation is our fault, and must not reach a results table.
  if (const auto flaw = find_flaw(map.free))
    throw std::logic_error(fmt::format("fault of generator '{}' ({}): {} at ({}, {})", info.name, map.source,
                                       flaw->reason, flaw->point.x(), flaw->point.y()));
  if (map.free.polygons.size() != 1)
    throw std::logic_error(fmt::format("fault of generator '{}' ({}): {} polygons instead of 1", info.name, map.source,
                                       map.free.polygons.size()));
  return map;
}

}  // namespace oxturn
