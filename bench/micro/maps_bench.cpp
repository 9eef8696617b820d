// Generators: time against tool-sized cells (0.4 m), up to 10^6.
#include <benchmark/benchmark.h>

#include <cmath>

#include "maps/generators.hpp"
#include "tests/support/maps.hpp"

namespace {

using namespace oxturn;

/// A square of `cells` cells; counts of rooms, corners and so on grow with the area.
Settings sized(const std::string& name, std::int64_t cells) {
  const double side = 0.4 * std::sqrt(static_cast<double>(cells));
  const double area = side * side;
  Settings s{{"width", side}, {"height", side}};
  if (name == "rooms") s["rooms"] = static_cast<std::int64_t>(area / 50) + 1;
  if (name == "polygon") s["corners"] = static_cast<std::int64_t>(area / 40) + 3;
  if (name == "comb") s["aisles"] = static_cast<std::int64_t>(side / 2) + 1;
  if (name == "field") s["ponds"] = static_cast<std::int64_t>(area / 160);
  return s;
}

void BM_Generate(benchmark::State& state, const std::string& name) {
  const Settings settings = sized(name, state.range(0));
  std::size_t corners = 0;
  for (auto _ : state) {
    const Map map = oxturn::generate(name, settings, 1);
    corners = vertex_count(map.free);
    benchmark::DoNotOptimize(corners);
  }
  state.SetComplexityN(state.range(0));
  state.counters["corners"] = static_cast<double>(corners);
}

// Listed from the generators' own list, so a new one is measured without a line here.
[[maybe_unused]] const bool kRegistered = [] {
  for (const GeneratorInfo& g : built_in_maps())
    benchmark::RegisterBenchmark(("BM_Generate/" + g.name).c_str(),
                                 [name = g.name](benchmark::State& state) { BM_Generate(state, name); })
        ->RangeMultiplier(10)
        ->Range(10000, 1000000)
        ->Unit(benchmark::kMillisecond)
        ->Complexity();
  return true;
}();

}  // namespace
