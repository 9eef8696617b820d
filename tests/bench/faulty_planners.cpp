#include "faulty_planners.hpp"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "algorithms/coverage_planner.hpp"
#include "reports/built_in_registry.hpp"
#include "test_planners.hpp"

namespace oxturn::testing {
namespace {

/// A good planner, and what is wrong with how it is used.
using Fault = Path (*)(const CoveragePlanner& good, const Problem& problem, Context& context);

class Faulty final : public CoveragePlanner {
 public:
  Faulty(std::unique_ptr<CoveragePlanner> good, Fault fault) : good_(std::move(good)), fault_(fault) {}
  Path plan(const Problem& problem, Context& context) const override { return fault_(*good_, problem, context); }

 private:
  std::unique_ptr<CoveragePlanner> good_;
  Fault fault_;
};

/// The same path, and at its end back over a share of the last segment and forth again: longer, and still valid.
Path longer(Path path, double share = 0.5) {
  Polyline& points = path.legs.back().points;
  const Point last = points.back(), before = points[points.size() - 2];
  points.push_back(lerp(last, before, share));
  points.push_back(last);
  return path;
}

Box space(const Problem& problem) { return bounding_box(problem.configuration_space()); }
bool small(const Problem& problem, double metres) {
  const Point size = space(problem).high - space(problem).low;
  return std::min(size.x(), size.y()) < metres;
}

// --- not the same bytes --------------------------------------------------------------------------------------

Path clock_seeded(const CoveragePlanner& good, const Problem& problem, Context& context) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return longer(good.plan(problem, context), 0.1 + 1e-9 * static_cast<double>(now % 100000000));
}
/// The order of a set of pointers is that of addresses.
[[maybe_unused]] Path orders_by_address(const CoveragePlanner& good, const Problem& problem, Context& context) {
  std::vector<std::unique_ptr<Point>> objects;
  for (int k = 0; k < 100; ++k) objects.push_back(std::make_unique<Point>(k, 0));
  std::set<const Point*> sorted;
  for (const auto& object : objects) sorted.insert(object.get());
  double sum = 0, rank = 0;
  for (const Point* object : sorted) sum += ++rank * object->x();
  return longer(good.plan(problem, context), 0.1 + 1e-6 * sum);
}
/// The order of pointers in a hash table depends on addresses, too.
Path hashes_addresses(const CoveragePlanner& good, const Problem& problem, Context& context) {
  constexpr std::uintptr_t kBuckets = 1009;
  std::vector<std::unique_ptr<Point>> objects;
  for (int k = 0; k < 100; ++k) objects.push_back(std::make_unique<Point>(k, 0));
  std::ranges::stable_sort(
      objects, {}, [](const auto& object) { return reinterpret_cast<std::uintptr_t>(object.get()) % kBuckets; });
  double sum = 0, rank = 0;
  for (const auto& object : objects) sum += ++rank * object->x();
  return longer(good.plan(problem, context), 0.1 + 1e-6 * sum);
}
Path counts_calls(const CoveragePlanner& good, const Problem& problem, Context& context) {
  static int calls = 0;
  Path path = good.plan(problem, context);
  return ++calls > 1 ? longer(path) : path;
}
Path draws_for_drawings(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path = good.plan(problem, context);
  return context.wants_traces() ? longer(path) : path;
}
/// The file stays from run to run.
const Folder& shared_folder() {
  static const Folder folder;
  return folder;
}
Path learns_from_files(const CoveragePlanner& good, const Problem& problem, Context& context) {
  const std::string file = shared_folder().file("learned");
  std::string before;
  std::ifstream(file) >> before;
  std::ofstream(file) << problem.map().name.front();
  Path path = good.plan(problem, context);
  return before.empty() ? path : longer(path, 0.001 * before.front());
}

// --- fails on some problems ----------------------------------------------------------------------------------

Path dies_in_one_cell(const CoveragePlanner& good, const Problem& problem, Context& context) {
  if (small(problem, 0.1)) std::abort();
  return good.plan(problem, context);
}
Path needs_two_lanes(const CoveragePlanner& good, const Problem& problem, Context& context) {
  if (small(problem, 0.01)) throw std::out_of_range("vector::at");
  return good.plan(problem, context);
}
Path visits_other_components(const CoveragePlanner& good, const Problem& problem, Context& context) {
  PathBuilder path(problem.start());
  for (const Leg& leg : good.plan(problem, context).legs) path.drive(leg.points, leg.tool);
  for (const auto& polygon : problem.map().free.polygons) path.drive(polygon.outer.front(), true);
  return problem.map().free.polygons.size() > 1 ? path.take() : good.plan(problem, context);
}
Path quadratic(const CoveragePlanner& good, const Problem& problem, Context& context) {
  const std::size_t n = problem.map().free.polygons.front().outer.size();
  for (std::size_t k = 0; k < n * n * n / 10; ++k) asm volatile("");  // so that the loop stays
  return good.plan(problem, context);
}
Path divides_by_lengths(const CoveragePlanner& good, const Problem& problem, Context& context) {
  const Ring& ring = problem.map().free.polygons.front().outer;
  for (std::size_t k = 1; k < ring.size(); ++k)
    if (distance(ring[k - 1], ring[k]) < 1e-4) throw std::domain_error("division by zero");
  return good.plan(problem, context);
}
Path fixed_point(const CoveragePlanner& good, const Problem& problem, Context& context) {
  if (space(problem).low.cwiseAbs().maxCoeff() > 1e5) throw std::overflow_error("coordinates do not fit");
  return good.plan(problem, context);
}
/// Volatile, because GCC 12 at -O2 wrongly drops the conversion of two neighbouring numbers to float and back.
double in_single_precision(double value) {
  const volatile float rounded = static_cast<float>(value);
  return rounded;
}
/// Valid to the tolerance near the origin, centimetres off at 10^6 m.
Path single_precision(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path = good.plan(problem, context);
  for (Leg& leg : path.legs)
    for (Point& p : leg.points)
      if (p != problem.start()) p = Point(in_single_precision(p.x()), in_single_precision(p.y()));
  return path;
}
Path bounded_grid(const CoveragePlanner& good, const Problem& problem, Context& context) {
  if (space(problem).high.x() > 32767) throw std::length_error("the grid is too large");
  return good.plan(problem, context);
}
Path centimetres(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path{{{true, {problem.start()}}}};
  for (const Leg& leg : good.plan(problem, context).legs)
    for (const Point& p : leg.points)
      if (distance(p, path.legs[0].points.back()) > 0.01) path.legs[0].points.push_back(p);
  return path;
}
Path moves_the_start(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path = good.plan(problem, context);
  if (std::abs(problem.start().x() - space(problem).low.x()) < 1e-3) path.legs[0].points[0] += Point(0.05, 0);
  return path;
}
Path refuses_wide_tools(const CoveragePlanner& good, const Problem& problem, Context& context) {
  if (problem.robot().tool_width > 2.5 * problem.robot().radius) throw Infeasible("the tool is too wide");
  return good.plan(problem, context);
}
/// Drives less the wider the tool is.
Path skips_lanes_with_wide_tools(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path = good.plan(problem, context);
  if (problem.robot().tool_width > 2.5 * problem.robot().radius) path.legs.resize(1);
  path.legs[0].tool = true;
  return path;
}
Path tool_as_wide_as_the_robot(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Robot robot = problem.robot();
  robot.tool_width = 2 * robot.radius;
  return good.plan(Problem(problem.map(), robot, problem.start()), context);
}

// --- declares what is not so ---------------------------------------------------------------------------------

Path wide_first(const CoveragePlanner& good, const Problem& problem, Context& context) {
  const Point size = space(problem).high - space(problem).low;
  Path path = good.plan(problem, context);
  return size.x() > size.y() ? longer(path) : path;
}
Path left_first(const CoveragePlanner& good, const Problem& problem, Context& context) {
  const bool left = problem.start().x() < (space(problem).low.x() + space(problem).high.x()) / 2;
  Path path = good.plan(problem, context);
  return left ? longer(path) : path;
}
Path far_from_the_origin(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path = good.plan(problem, context);
  return space(problem).low.x() > 10 ? longer(path) : path;
}
Path wants_five_metres(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path = good.plan(problem, context);
  return space(problem).high.x() > 8 ? longer(path) : path;
}
Path fears_holes(const CoveragePlanner& good, const Problem& problem, Context& context) {
  if (hole_count(problem.configuration_space()) > 0) throw Unsupported("holes are future work");
  return good.plan(problem, context);
}
Path takes_squares_for_discs(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Robot robot = problem.robot();
  robot.footprint = {};
  return good.plan(Problem(problem.map(), robot, problem.start()), context);
}
/// Looks at the far end before it drives off.
Path knows_the_map(const CoveragePlanner& good, const Problem& problem, Context& context) {
  PathBuilder path(problem.start());
  path.drive(lerp(problem.start(), problem.start() + Point(1, 0), space(problem).high.x() / 100), true);
  path.drive(problem.start(), true);
  for (const Leg& leg : good.plan(problem, context).legs) path.drive(leg.points, leg.tool);
  return path.take();
}
Path as_it_is(const CoveragePlanner& good, const Problem& problem, Context& context) {
  return good.plan(problem, context);
}
Path turns_on_the_spot(const CoveragePlanner& good, const Problem& problem, Context& context) {
  return good.plan(problem.turning_on_the_spot(), context);
}
Path gives_up_early(const CoveragePlanner& good, const Problem& problem, Context& context) {
  Path path = good.plan(problem, context);
  Polyline& points = path.legs.back().points;
  points.resize(std::max<std::size_t>(2, points.size() / 2));
  return path;
}

// --- limits and refusals -------------------------------------------------------------------------------------

Path never_looks_at_the_clock(const CoveragePlanner& good, const Problem& problem, Context& context) {
  for (volatile int rounds = 0; rounds < 1;) ::usleep(1000);
  return good.plan(problem, context);
}
Path never_asks_whether_cancelled(const CoveragePlanner& good, const Problem& problem, Context& context) {
  const auto end = Context::Clock::now() + std::chrono::milliseconds(static_cast<int>(800 * context.wall_s()));
  while (Context::Clock::now() < end) ::usleep(1000);
  return good.plan(problem, context);
}
Path refuses_rooms(const CoveragePlanner& good, const Problem& problem, Context& context) {
  if (problem.map().name == "room") throw Infeasible("");
  return good.plan(problem, context);
}
Path empty_in_the_narrow(const CoveragePlanner& good, const Problem& problem, Context& context) {
  return small(problem, 0.01) ? Path{} : good.plan(problem, context);
}

// --- does something else -------------------------------------------------------------------------------------

Path prints(const CoveragePlanner& good, const Problem& problem, Context& context) {
  std::printf("planning ...\n");
  return good.plan(problem, context);
}
Path leaves_a_log(const CoveragePlanner& good, const Problem& problem, Context& context) {
  std::ofstream("debug.log") << "planning\n";
  return good.plan(problem, context);
}
Path writes_elsewhere(const CoveragePlanner& good, const Problem& problem, Context& context) {
  std::ofstream(shared_folder().file("elsewhere")) << "planning\n";
  return good.plan(problem, context);
}
Path rolls_dice(const CoveragePlanner& good, const Problem& problem, Context& context) {
  return longer(good.plan(problem, context), 0.1 + 0.8 * std::rand() / RAND_MAX);
}
Path publishes_drafts(const CoveragePlanner& good, const Problem& problem, Context& context) {
  context.publish({{{true, {problem.start(), problem.start() + Point(100, 0)}}}});
  return good.plan(problem, context);
}

struct Planted {
  const char *name, *check;
  Fault fault;
  std::vector<Capability> more = {};
  Promise promise = Promise::target;
};

const std::vector<Planted>& planted() {
  static const std::vector<Planted> all{
      {"clock-seeded", "same-seed", clock_seeded},
#ifndef __SANITIZE_ADDRESS__  // whose allocator reuses no memory: addresses ascend whatever was allocated before
      {"orders-by-address", "same-seed", orders_by_address},
#endif
      {"hashes-addresses", "same-seed", hashes_addresses},
      {"counts-calls", "no-memory", counts_calls},
      {"draws-for-drawings", "unobserved", draws_for_drawings},
      {"learns-from-files", "any-order", learns_from_files},
      {"dies-in-one-cell", "one-cell", dies_in_one_cell},
      {"needs-two-lanes", "corridor", needs_two_lanes},
      {"visits-other-components", "disconnected", visits_other_components},
      {"quadratic", "many-vertices", quadratic},
      {"divides-by-lengths", "collinear", divides_by_lengths},
      {"fixed-point", "huge-coordinates", fixed_point},
      {"single-precision", "huge-coordinates", single_precision},
      {"bounded-grid", "huge", bounded_grid},
      {"centimetres", "tiny", centimetres},
      {"moves-the-start", "start-on-boundary", moves_the_start},
      {"refuses-wide-tools", "wide-tool", refuses_wide_tools},
      {"skips-lanes-with-wide-tools", "wide-tool", skips_lanes_with_wide_tools},
      {"tool-as-wide-as-the-robot", "narrow-tool", tool_as_wide_as_the_robot},
      {"wide-first", "quarter-turn", wide_first},
      {"left-first", "mirror", left_first},
      {"far-from-the-origin", "shift", far_from_the_origin},
      {"wants-five-metres", "scale", wants_five_metres},
      {"never-looks-at-the-clock", "deadline", never_looks_at_the_clock},
      {"never-asks-whether-cancelled", "cancel", never_asks_whether_cancelled},
      {"refuses-rooms", "refusal", refuses_rooms, {}, Promise::nothing},
      {"empty-in-the-narrow", "infeasible", empty_in_the_narrow},
      {"prints", "no-output", prints},
      {"leaves-a-log", "no-files", leaves_a_log},
      {"writes-elsewhere", "no-files", writes_elsewhere},
      {"rolls-dice", "no-global-random", rolls_dice},
      {"publishes-drafts", "published", publishes_drafts},
      {"fears-holes", "holes", fears_holes},
      {"ignores-its-tether", "tether", as_it_is, {Capability::tether}, Promise::nothing},
      {"takes-squares-for-discs", "footprint", takes_squares_for_discs},
      {"turns-on-the-spot", "curvature", turns_on_the_spot},
      {"knows-the-map", "online", knows_the_map, {Capability::online}},
      {"gives-up-early", "promise", gives_up_early},
  };
  return all;
}

PlannerInfo faulty(const Planted& planted) {
  PlannerInfo info = built_in_planners().find("boustrophedon");
  info.name = planted.name;
  info.capabilities.insert(info.capabilities.end(), planted.more.begin(), planted.more.end());
  info.promise = planted.promise;
  info.make = [good = info.make, fault = planted.fault](const Settings& settings, const Planners& planners) {
    return std::make_unique<Faulty>(good(settings, planners), fault);
  };
  return info;
}

/// One of the values of its parameter is refused in plan().
PlannerInfo forgot_a_choice() {
  PlannerInfo info = built_in_planners().find("boustrophedon");
  info.name = "forgot-a-choice";
  info.make = [good = info.make](const Settings& settings, const Planners& planners) {
    const bool forgotten = settings.count("order") > 0;
    return std::make_unique<Faulty>(good(settings, planners),
                                    forgotten ? Fault([](const CoveragePlanner&, const Problem&, Context&) -> Path {
                                      throw std::logic_error("not implemented");
                                    })
                                              : as_it_is);
  };
  return info;
}

}  // namespace

const std::vector<PlantedFault>& planted_faults() {
  static const std::vector<PlantedFault> all = [] {
    std::vector<PlantedFault> faults;
    for (const Planted& p : planted()) faults.push_back({p.name, p.check});
    faults.push_back({"forgot-a-choice", "parameters"});
    return faults;
  }();
  return all;
}

const Registry& faulty_registry() {
  static const Registry registry = [] {
    Registry all = built_in_registry();
    (void)shared_folder();  // made here, not in each planner's process
    for (const Planted& p : planted()) all.planners.add(faulty(p));
    all.planners.add(forgot_a_choice());
    all.planners.add(faulty({"good", "", as_it_is}));
    return all;
  }();
  return registry;
}

}  // namespace oxturn::testing
