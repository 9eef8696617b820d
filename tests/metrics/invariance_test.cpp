// Every metric of the list under transformations of path and problem that change nothing, or only the scale.
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"
#include "tethered.hpp"

namespace oxturn {
namespace {

struct Case {
  Region free;
  Robot robot;
  Point start;
  Path path;
  Region promised;
};

/// Moves everything by `f`, which scales lengths by `scale`.
Case mapped(Case c, const std::function<Point(const Point&)>& f, double scale, bool mirrored = false) {
  for (Region* r : {&c.free, &c.promised})
    for (Polygon& p : r->polygons) {
      const auto map_ring = [&](Ring& ring) {
        for (Point& q : ring) q = f(q);
        if (mirrored) std::reverse(ring.begin(), ring.end());
      };
      map_ring(p.outer);
      for (Ring& hole : p.holes) map_ring(hole);
    }
  for (Leg& leg : c.path.legs)
    for (Point& p : leg.points) p = f(p);
  c.start = f(c.start);
  for (double* length :
       {&c.robot.radius, &c.robot.tool_width, &c.robot.speed, &c.robot.acceleration, &c.robot.min_turn_radius})
    *length *= scale;
  if (c.robot.tether) c.robot.tether->length *= scale;
  return c;
}

/// The same path in other legs, at its vertices; some of a single segment.
Path recut(const Path& path, Rng& rng) {
  Path result;
  const double share = rng.unit() < 0.3 ? 1 : rng.unit();
  for (const Leg& leg : path.legs) {
    Leg part{leg.tool, {leg.points.front()}};
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      part.points.push_back(leg.points[i]);
      if (i + 1 == leg.points.size() || !rng.chance(share)) continue;
      result.legs.push_back(part);
      part.points = {leg.points[i]};
    }
    result.legs.push_back(part);
  }
  return result;
}

Path resampled(const Path& path, Rng& rng) {
  Path result;
  for (const Leg& leg : path.legs) {
    Leg dense{leg.tool, {leg.points.front()}};
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const int n = rng.between(1, 12);
      for (int k = 1; k < n; ++k) dense.points.push_back(lerp(leg.points[i - 1], leg.points[i], k / (n + 0.0)));
      dense.points.push_back(leg.points[i]);
    }
    result.legs.push_back(dense);
  }
  return result;
}

/// How much a metric may differ, in units of itself: `same` if the problem is the same, `moved` if not, because a
/// problem's configuration space errs by chords of other directions, and a missed piece may be just large enough.
/// Values scale with the length to `power`.
struct Rule {
  int power;
  double same, moved;
};
const std::map<std::string, Rule> kRules{
    {"coverage", {0, 1e-3, 3e-3}},
    {"coverage_lower", {0, 1e-3, 3e-3}},
    {"coverage_upper", {0, 1e-3, 3e-3}},
    {"coverage_of_free", {0, 1e-3, 3e-3}},
    {"target_m2", {2, 0, 2e-3}},
    {"path_m", {1, 1e-9, 1e-9}},
    {"work_m", {1, 1e-9, 1e-9}},
    {"transit_m", {1, 1e-9, 1e-9}},
    {"length_ratio", {0, 1e-3, 5e-3}},
    {"bound_m", {1, 1e-3, 5e-3}},
    {"bound_kind", {0, 1, 1}},  // where there is little to spill, either may be best
    {"gap", {0, 2e-3, 1e-2}},
    {"overlap", {0, 1e-3, 2e-3}},
    {"revisits", {0, 2e-3, 6e-3}},
    {"promise_coverage", {0, 1e-3, 3e-3}},
    {"missed_pieces", {0, 0, 0.2}},
    {"missed_largest_m2", {2, 0.01, 0.02}},
    {"turns", {0, 0, 0}},
    {"turn_rad", {0, 1e-9, 1e-9}},
    {"curvature_max_per_m", {-1, 1e-6, 1e-6}},
    {"curvature_violations", {0, 0, 0}},
    {"cusps", {0, 0, 0}},
    {"clearance_m", {1, 1e-9, 1e-9}},
    {"mission_s", {0, 1e-6, 1e-6}},
    {"tether_limit_m", {1, 0, 1e-12}},
    {"tether_max_m", {1, 1e-9, 1e-9}},
    {"tether_bends_max", {0, 0, 0}},
    {"tether_angle_min_rad", {0, 1e-6, 1e-6}},
    {"tether_angle_mean_rad", {0, 1e-6, 1e-6}},
    {"tether_sharp_fraction", {0, 1e-6, 1e-6}},
    {"tether_crossings", {0, 0, 0}},
    {"tether_entangled", {0, 0, 0}},
    // path_90_m ... mission_99_s: by the curve, see below
};

double coverage_at(const Score& s, double position, double CurvePoint::*member) {
  for (std::size_t i = 1; i < s.curve.size(); ++i) {
    const CurvePoint &a = s.curve[i - 1], &b = s.curve[i];
    if (position > b.*member) continue;
    return a.coverage + (position - a.*member) / (b.*member - a.*member) * (b.coverage - a.coverage);
  }
  return s.curve.back().coverage;
}

/// The position at which a share is reached is compared by the coverage there, because the curve may be flat.
void expect_reached(const Score& base, const Score& other, int percent, double scale) {
  const double share = percent / 100.0;
  const auto metres = other.value("path_" + std::to_string(percent) + "_m"),
             seconds = other.value("mission_" + std::to_string(percent) + "_s");
  EXPECT_EQ(metres.has_value(), seconds.has_value());
  if (std::abs(*base.value("coverage") - share) < 0.005) return;
  ASSERT_EQ(metres.has_value(), *base.value("coverage") > share);
  if (!metres) return;
  EXPECT_NEAR(coverage_at(base, *metres / scale, &CurvePoint::path_m), share, 0.012);
  EXPECT_NEAR(coverage_at(base, *seconds, &CurvePoint::mission_s), share, 0.02);
}

void compare(const Score& base, const Score& other, double scale, bool same_problem) {
  EXPECT_EQ(base.flaw.empty(), other.flaw.empty()) << base.flaw << other.flaw;
  for (const MetricValue& value : base.values) {
    const auto rule = kRules.find(value.name);
    if (rule == kRules.end()) continue;
    const auto now = other.value(value.name);
    ASSERT_EQ(now.has_value(), value.value.has_value()) << value.name;
    if (!now) continue;
    const double expected = *value.value * std::pow(scale, rule->second.power);
    const double tolerance = same_problem ? rule->second.same : rule->second.moved;
    EXPECT_NEAR(*now, expected, tolerance * std::max(std::abs(expected), std::pow(scale, rule->second.power)))
        << value.name;
  }
  for (const int percent : {90, 95, 99}) expect_reached(base, other, percent, scale);
}

Score score_of(const Case& c) {
  const Problem problem(Map{"drawn", c.free, "test", "test"}, c.robot, c.start);
  return score(problem, c.path, ScoreOptions{.promise = Promise::cells, .promised = &c.promised});
}

Case random_case(std::uint64_t seed) {
  Rng rng(seed);
  Case c;
  c.free = seed % 2 ? two_holes() : pillars(rng, 4);
  c.robot.tool_width = seed % 3 ? 1.5 : 0.8;
  c.robot.min_turn_radius = seed % 5 ? 0 : 0.3;
  if (seed % 10 == 0) c.robot.tether = Tether{20};
  c.start = {1, 1};
  c.promised = box_region({0.5, 0.5}, {6, 7});
  const Problem problem(Map{"drawn", c.free, "test", "test"}, c.robot, c.start);
  const Polyline walk = free_walk(problem, rng, rng.between(3, 70), 5);
  for (std::size_t i = 1; i < walk.size(); ++i) {
    if (i == 1 || rng.chance(0.1)) c.path.legs.push_back(Leg{rng.chance(0.8), {walk[i - 1]}});
    c.path.legs.back().points.push_back(walk[i]);
  }
  return c;
}

/// Of drawings; these cases have none. Their tolerance is a length, which does not scale: drawing_test.cpp has them.
const std::set<std::string> kOfDrawings{"stroke_share",  "stroke_error_m", "fill_share",      "fill_share_reachable",
                                        "spill_m2",      "tool_up_m",      "over_finished_m", "work_over_finished_m",
                                        "tangent_breaks"};

TEST(Invariance, EveryMetricHasARule) {
  for (const Metric& m : built_in_metrics()) {
    const bool by_curve = m.name.starts_with("path_9") || m.name.starts_with("mission_9");
    EXPECT_TRUE(by_curve || kOfDrawings.contains(m.name) || kRules.contains(m.name)) << m.name;
  }
}

TEST(Invariance, RecutResampledShiftedRotatedMirroredScaled) {
  for (const auto seed : seeds(200)) {
    SCOPED_TRACE(seed);
    const Case base = random_case(seed);
    const Score before = score_of(base);
    // A tether may be too short for a random walk, and a car cannot drive one.
    if (!base.robot.tether && base.robot.min_turn_radius == 0) { EXPECT_EQ(before.flaw, ""); }
    Rng rng(1000 + seed);
    const auto check = [&](const char* what, const Case& c, double scale, bool same) {
      SCOPED_TRACE(what);
      compare(before, score_of(c), scale, same);
    };
    Case c = base;
    c.path = recut(base.path, rng);
    check("recut", c, 1, true);
    c.path = resampled(recut(base.path, rng), rng);
    check("resampled", c, 1, true);
    const double angle = rng.between(0.1, 6.0);
    check("shifted",
          mapped(
              base, [](const Point& p) { return Point(p + Point(512, -256)); }, 1),
          1, false);
    check("rotated",
          mapped(
              base, [&](const Point& p) { return rotated(p, angle); }, 1),
          1, false);
    check("mirrored",
          mapped(
              base, [](const Point& p) { return Point(-p.x(), p.y()); }, 1, true),
          1, false);
    check("scaled",
          mapped(
              base, [](const Point& p) { return Point(8 * p); }, 8),
          8, false);
  }
}

}  // namespace
}  // namespace oxturn
