/// Seeded families of maps. Same parameters and seed, same bytes, on every machine.
///
///   const Generators generators = built_in_generators();
///   const Map map = generate("rooms", {{"rooms", 9}}, 7, generators);
#pragma once

#include <cstdint>
#include <functional>

#include "base/named_list.hpp"
#include "base/parameters.hpp"
#include "base/random.hpp"
#include "maps/map.hpp"

namespace oxturn {

/// What a generator makes: free space, and the part of it that is to be covered, if that is not all of it.
struct Site {
  Site(Region free_space, std::optional<Region> to_cover = {})
      : free(std::move(free_space)), target_area(std::move(to_cover)) {}
  Region free;
  std::optional<Region> target_area;
};

struct GeneratorInfo {
  std::string name, title;
  std::string guarantee;  // topology it promises
  std::vector<ParameterInfo> parameters;
  std::function<Site(const Settings&, Rng&)> make;
};

using Generators = NamedList<GeneratorInfo>;

/// The generators that come with oxturn; maps/generators/generators.cpp lists them.
Generators built_in_generators();
/// A named map ("rooms-7"); throws std::invalid_argument for bad settings.
Map generate(const GeneratorInfo& generator, const Settings& settings, std::uint64_t seed);
Map generate(const std::string& generator, const Settings& settings, std::uint64_t seed, const Generators& generators);

/// Helper for generator files, as describe<> is for planners.
///   Region make(const Params&, Rng&);   // or Site
template <class P, class Made>
GeneratorInfo describe_generator(std::string name, std::string title, std::string guarantee,
                                 std::vector<Parameter<P>> lines, Made (*make)(const P&, Rng&)) {
  GeneratorInfo info{name, std::move(title), std::move(guarantee), infos_of(lines), {}};
  info.make = [owner = "generator '" + name + "'", lines = std::move(lines), make](const Settings& s, Rng& rng) {
    return Site(make(with_settings<P>(owner, lines, s), rng));
  };
  return info;
}

}  // namespace oxturn
