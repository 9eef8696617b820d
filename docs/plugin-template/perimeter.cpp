// A plug-in with a planner, a metric and a map generator.
#include <oxturn/algorithms/coverage_planner.hpp>
#include <oxturn/bench/plugin.hpp>
#include <oxturn/geometry/region.hpp>

using namespace oxturn;

namespace {

// --- a planner: drives every wall, a number of times --------------------------------------------------------

struct PerimeterParams {
  int laps = 1;
};

Path drive_perimeter(const PerimeterParams& p, const Problem& problem, Context& context) {
  PathBuilder path(problem.start());
  for_each_ring(problem.configuration_space(), [&](const Ring& ring) {
    if (context.cancelled()) return;
    const auto transit = problem.transit().path(path.at(), ring.front());  // around obstacles
    if (!transit) throw Infeasible("a wall cannot be reached from the start");
    path.drive(*transit, false);  // with the tool off
    for (int lap = 0; lap < p.laps; ++lap) {
      path.drive(ring, true);
      path.drive(ring.front(), true);
    }
  });
  return path.take();
}

PlannerInfo perimeter() {
  return describe<PerimeterParams, drive_perimeter>(
      {.name = "perimeter",
       .family = "baseline",
       .title = "along every wall",
       .citation = "mine",
       .capabilities = {Capability::holes},
       .guarantee = "covers the strip along the walls",
       .parameters = {{"laps", &PerimeterParams::laps, Range{1, 100}, "how often each wall is driven"}}});
}

// --- a metric: a column of runs.csv -------------------------------------------------------------------------

const Metric kLegs{"legs", "count", Better::lower, "changes between tool on and tool off, plus one",
                   [](const Scored& s) { return static_cast<double>(s.path.legs.size()); }};

// --- a map generator ----------------------------------------------------------------------------------------

struct CorridorParams {
  double length = 10, width = 2;
};

Region make_corridor(const CorridorParams& p, Rng&) { return box_region({0, 0}, {p.length, p.width}); }

GeneratorInfo corridor() {
  return describe_generator<CorridorParams>("corridor", "one straight corridor", "one component, no holes",
                                            {{"length", &CorridorParams::length, Range{1, 1000}, "metres"},
                                             {"width", &CorridorParams::width, Range{0.5, 100}, "metres"}},
                                            make_corridor);
}

}  // namespace

OXTURN_PLUGIN(registry) {
  registry.planners.add(perimeter());
  registry.metrics.add(kLegs);
  registry.generators.add(corridor());
}
