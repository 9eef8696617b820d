// Seeded families of maps. Same parameters and seed, same bytes, on every machine.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "base/random.hpp"
#include "maps/map.hpp"

namespace oxturn {

struct GeneratorInfo {
  std::string name, title;
  std::string guarantee;  // topology it promises
  std::vector<ParameterInfo> parameters;
  std::function<Region(const Settings&, Rng&)> make;
};

/// Generators are listed in maps/generators/generators.cpp and nowhere else.
const std::vector<GeneratorInfo>& generators();
/// Throws "no generator 'room'; did you mean 'rooms'? There are: ...".
const GeneratorInfo& find_generator(const std::string& name);
/// A named map ("rooms-7"); throws std::invalid_argument for bad settings.
Map generate(const std::string& generator, const Settings& settings, std::uint64_t seed);

/// Helper for generator files, as describe<> is for planners.
template <class P>
GeneratorInfo describe_generator(std::string name, std::string title, std::string guarantee,
                                 std::vector<Parameter<P>> lines, Region (*make)(const P&, Rng&)) {
  GeneratorInfo info{name, std::move(title), std::move(guarantee), to_infos(lines), {}};
  info.make = [owner = "generator '" + name + "'", lines = std::move(lines), make](const Settings& s, Rng& rng) {
    return make(with_settings<P>(owner, lines, s), rng);
  };
  return info;
}

}  // namespace oxturn
