#include "geometry/tether/taut_tether.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "geometry/edge_index.hpp"
#include "geometry/predicates.hpp"
#include "tests/geometry/random_region.hpp"
#include "tests/geometry/samples.hpp"
#include "tests/geometry/taut_oracle.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {

void PrintTo(const TautTether::Bend& b, std::ostream* os) {
  *os << fmt::format("({}, {}) {}", b.at.x(), b.at.y(), b.side > 0 ? "left" : "right");
}

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;
using Bend = TautTether::Bend;

constexpr int kLeft = 1, kRight = -1;

/// Rooms of a square grid with most walls between them, one cell thick: many corners in line.
Region rooms(Rng& rng, int n) {
  BitGrid grid({0, 0}, 0.5, 2 * n + 1, 2 * n + 1);
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      grid.set(i, j, i % 2 + j % 2 == 2 || (i % 2 + j % 2 == 1 && rng.chance(0.6)) || rng.chance(0.1));
  return trace(grid);
}

/// Diamonds that touch each other and the border: corner to corner, and corners inside of walls.
Region diamonds(Rng& rng, int n) {
  Polygon p{{{0, 0}, {1.0 * n, 0}, {1.0 * n, 1.0 * n}, {0, 1.0 * n}}, {}};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const Point c(i + 0.5, j + 0.5);
      if (rng.chance(0.6))
        p.holes.push_back({c + Point(0.5, 0), c - Point(0, 0.5), c - Point(0.5, 0), c + Point(0, 0.5)});
    }
  return {{p}};
}

constexpr int kKinds = 7;
Region random_map(Rng& rng, int kind) {
  switch (kind) {
    case 0:
      return clutter_box(rng, 6, 6, false);
    case 1:
      return clutter_box(rng, 6, 6, true);
    case 2:
      return star_region(rng, rng.between(20, 80));
    case 3:
      return samples::holed_star(rng, {3, -2}, 6);
    case 4:
      return trace(samples::speckled(rng, 24, 0.25, 60, 4));  // rings that touch
    case 5:
      return diamonds(rng, 7);
    default:
      return rooms(rng, 8);
  }
}

/// A map with what it takes to walk in it at random.
struct World {
  explicit World(Region r)
      : region(std::move(r)), index(region), mesh(region), space(region), box(bounding_box(region)) {}

  Point random_point(Rng& rng) const {
    while (true) {
      const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      if (index.contains(p)) return p;
    }
  }
  /// Anywhere, on a wall or at a corner.
  Point anchor(Rng& rng) const {
    const Point& corner = mesh.points()[rng.below(mesh.points().size())];
    if (rng.chance(0.2)) return corner;
    const EdgeIndex::Edge& e = index.edges()[rng.below(index.edges().size())];
    const Point middle = lerp(e.a, e.b, 0.5);
    if (rng.chance(0.2) && index.contains(middle)) return middle;
    return random_point(rng);
  }
  /// Somewhere that can be driven to straight: mostly near, often at a corner, on a lattice, on a wall, or back.
  Point next(Rng& rng, const Point& at, const Point& earlier) const {
    while (true) {
      const double kind = rng.unit();
      Point to = earlier;
      if (kind < 0.15) {
        to = mesh.points()[rng.below(mesh.points().size())];
      } else if (kind < 0.25) {
        to = Point(0.125 * std::round(8 * at.x()), 0.125 * std::round(8 * at.y())) +
             0.125 * Point(rng.between(-16, 16), rng.between(-16, 16));
      } else if (kind < 0.35) {
        const EdgeIndex::Edge& e = index.edges()[rng.below(index.edges().size())];
        to = lerp(e.a, e.b, 0.25 * rng.between(1, 3));
      } else if (kind < 0.95) {
        const double angle = rng.between(0.0, 2 * kPi), far = rng.unit();
        to = at + 4 * far * far * Point(std::cos(angle), std::sin(angle));
      }
      if (to != at && index.contains(at, to)) return to;
    }
  }

  Region region;
  EdgeIndex index;
  Mesh mesh;
  TautSpace space;
  Box box;
};

/// Each part lies in free space and each bend turns about an obstacle at the right side.
void expect_taut(const World& world, const TautTether& tether) {
  const Polyline line = tether.polyline();
  for (std::size_t i = 1; i < line.size(); ++i) {
    EXPECT_TRUE(world.index.contains(line[i - 1], line[i]))
        << fmt::format("({}, {}) to ({}, {})", line[i - 1].x(), line[i - 1].y(), line[i].x(), line[i].y());
    if (i + 1 < line.size()) { EXPECT_EQ(orientation(line[i - 1], line[i], line[i + 1]), tether.bends()[i - 1].side); }
  }
}

/// OXTURN_TAUT_MOVES=1000000 is the promise; the default is for every day.
long moves_wanted() {
  const char* wanted = std::getenv("OXTURN_TAUT_MOVES");
  return wanted != nullptr ? std::atol(wanted) : 50000;
}

TEST(TautTether, AgreesWithTheFunnelOverTheWholePath) {
  const long wanted = moves_wanted();
  long moves = 0, bends = 0, most = 0;
  for (std::uint64_t seed = 1; moves < wanted; ++seed) {
    Rng rng(seed);
    const int kind = static_cast<int>(seed % kKinds);
    const World world(random_map(rng, kind));
    for (int walk = 0; walk < 4; ++walk) {
      const Point anchor = world.anchor(rng);
      TautTether tether(world.space, anchor);
      TautOracle oracle(world.mesh, anchor);
      Polyline driven{anchor};
      for (int i = rng.between(50, 150); i > 0; --i) {
        const Point to = world.next(rng, driven.back(), driven[rng.below(driven.size())]);
        const TautOracle before = oracle;
        if (!oracle.drive(to)) {  // through a point where two fans of free space touch
          ASSERT_GE(kind, 4);
          if (driven.size() == 1) break;
          oracle = before;
          continue;
        }
        tether.drive(to);
        driven.push_back(to);
        const Polyline expected = oracle.line();
        ++moves;
        bends += static_cast<long>(tether.bends().size());
        most = std::max(most, static_cast<long>(tether.bends().size()));
        if (tether.bends() != TautOracle::bends(expected) || std::abs(tether.length() - length(expected)) > 1e-9) {
          std::string path;
          for (const Point& p : driven) path += fmt::format("({:.17g}, {:.17g}) ", p.x(), p.y());
          FAIL() << fmt::format("map kind {} seed {} walk {} after {} moves, {} m against {} m\n", kind, seed, walk,
                                driven.size() - 1, tether.length(), length(expected))
                 << path << "\nstring " << testing::PrintToString(tether.bends()) << "\noracle "
                 << testing::PrintToString(TautOracle::bends(expected));
        }
      }
    }
  }
  RecordProperty("moves", std::to_string(moves));
  RecordProperty("bends_mean", std::to_string(static_cast<double>(bends) / static_cast<double>(moves)));
  RecordProperty("bends_max", std::to_string(most));
}

/// Calls f(world, path, rng) for random walks on maps of all kinds; on those with touching rings only walks that the
/// oracle can follow.
template <class F>
void for_random_paths(int maps, int moves, F f) {
  for (const std::uint64_t seed : seeds(static_cast<std::uint64_t>(maps))) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(1000 + seed);
    const World world(random_map(rng, static_cast<int>(seed % kKinds)));
    Polyline path{world.anchor(rng)};
    TautOracle oracle(world.mesh, path[0]);
    for (int i = 0; i < moves; ++i) {
      const Point to = world.next(rng, path.back(), path[rng.below(path.size())]);
      const TautOracle before = oracle;
      if (oracle.drive(to)) {
        path.push_back(to);
      } else {
        oracle = before;
      }
    }
    f(world, path, rng);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(TautTether, IsLocallyShortestAndNeverLongerThanTheWay) {
  for_random_paths(35, 80, [](const World& world, const Polyline& path, Rng&) {
    TautTether tether(world.space, path[0]);
    double driven = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
      tether.drive(path[i]);
      driven += distance(path[i - 1], path[i]);
      expect_taut(world, tether);
      EXPECT_LE(tether.length(), driven * (1 + 1e-12));
      EXPECT_NEAR(tether.length(), length(tether.polyline()), 1e-9);
    }
  });
}

TEST(TautTether, DrivingBackRestoresEveryState) {
  for_random_paths(70, 80, [](const World& world, const Polyline& path, Rng&) {
    TautTether tether(world.space, path[0]);
    std::vector<TautTether> states{tether};
    for (std::size_t i = 1; i < path.size(); ++i) {
      tether.drive(path[i]);
      states.push_back(tether);
    }
    for (std::size_t i = path.size(); i-- > 0;) {
      tether.drive(path[i]);
      ASSERT_EQ(tether.bends(), states[i].bends()) << "vertex " << i;
      ASSERT_EQ(tether.length(), states[i].length());  // bit for bit
    }
    EXPECT_THAT(tether.bends(), IsEmpty());
    EXPECT_EQ(tether.length(), 0);
  });
}

/// Every corner cut off by one to three edges of 30 nanometres to 10 micrometres, as roundings leave them.
Region chamfered(Rng& rng, const Region& region) {
  const auto chamfer = [&](const Ring& ring) {
    Ring out;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &before = ring[(i + ring.size() - 1) % ring.size()], &at = ring[i],
                  &after = ring[(i + 1) % ring.size()];
      const double size = 3e-8 * std::pow(300.0, rng.unit());
      const Point in = at + size * (before - at).normalized(), on = at + size * (after - at).normalized();
      out.push_back(in);
      if (rng.chance(0.5)) out.push_back(lerp(in, lerp(at, on, rng.unit()), rng.between(0.3, 0.6)));
      out.push_back(on);
    }
    return out;
  };
  Region result;
  for (const Polygon& p : region.polygons) {
    result.polygons.push_back({chamfer(p.outer), {}});
    for (const Ring& hole : p.holes) result.polygons.back().holes.push_back(chamfer(hole));
  }
  return result;
}

// Regression: where edges were shorter than rounding may move a path, tethers passed corners on the wrong side, and a
// winding undone could become a second one.
TEST(TautTether, EdgesShorterThanRoundingDoNotChangeTheClass) {
  for (const std::uint64_t seed : seeds(60)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(2000 + seed);
    const World world(chamfered(rng, random_map(rng, static_cast<int>(seed % 4))));
    Polyline path{world.anchor(rng)};
    TautTether tether(world.space, path[0]);
    TautOracle oracle(world.mesh, path[0]);
    std::vector<double> lengths{0};
    for (int i = 0; i < 80; ++i) {
      path.push_back(world.next(rng, path.back(), path[rng.below(path.size())]));
      ASSERT_TRUE(oracle.drive(path.back()));
      tether.drive(path.back());
      lengths.push_back(length(oracle.line()));
      ASSERT_NEAR(tether.length(), lengths.back(), 1e-4) << "vertex " << i;
    }
    for (std::size_t i = path.size(); i-- > 0;) {
      tether.drive(path[i]);
      ASSERT_NEAR(tether.length(), lengths[i], 1e-4) << "back at vertex " << i;
    }
  }
}

TEST(TautTether, DependsOnTheClassOfTheWayOnly) {  // not on how finely the path is cut, nor on a loop driven and undone
  for_random_paths(70, 60, [](const World& world, const Polyline& path, Rng& rng) {
    TautTether tether(world.space, path[0]), other(world.space, path[0]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      tether.drive(path[i]);
      const Point middle = lerp(path[i - 1], path[i], 0.5);
      if (world.index.contains(path[i - 1], middle) && world.index.contains(middle, path[i])) other.drive(middle);
      other.drive(path[i]);
      const Point aside = world.next(rng, path[i], path[i]);
      other.drive(aside);
      other.drive(path[i]);
      ASSERT_EQ(tether.bends(), other.bends());
      ASSERT_EQ(tether.length(), other.length());
    }
  });
}

TEST(TautTether, SwingsCoverTheDriveWithoutGaps) {
  for_random_paths(70, 60, [](const World& world, const Polyline& path, Rng&) {
    TautTether tether(world.space, path[0]);
    for (std::size_t i = 1; i < path.size(); ++i) {
      const TautTether before = tether;
      std::vector<TautTether::Swing> swings;
      tether.drive(path[i], [&](const TautTether::Swing& s) { swings.push_back(s); });
      if (path[i] == path[i - 1]) {
        EXPECT_THAT(swings, IsEmpty());
        continue;
      }
      ASSERT_FALSE(swings.empty());
      EXPECT_EQ(swings.front().from, path[i - 1]);
      EXPECT_EQ(swings.back().to, path[i]);
      EXPECT_NEAR(swings.front().before + distance(swings.front().pivot, path[i - 1]), before.length(), 1e-9);
      EXPECT_NEAR(swings.back().before + distance(swings.back().pivot, path[i]), tether.length(), 1e-9);
      double sum = 0;
      for (std::size_t k = 0; k < swings.size(); ++k) {
        const TautTether::Swing& s = swings[k];
        const double far = distance(s.from, s.to);
        sum += far;
        if (k > 0) {
          EXPECT_EQ(swings[k - 1].to, s.from);
          EXPECT_TRUE(swings[k - 1].pivot != s.pivot || swings[k - 1].bends != s.bends);
          EXPECT_NEAR(swings[k - 1].before + distance(swings[k - 1].pivot, s.from),
                      s.before + distance(s.pivot, s.from), 1e-9);
        }
        if (far < 1e-5) continue;
        TautTether part = before;
        part.drive(lerp(s.from, s.to, 0.5));
        EXPECT_EQ(part.pivot(), s.pivot);
        EXPECT_EQ(part.bends().size(), s.bends);
        EXPECT_NEAR(part.length(), s.before + distance(s.pivot, part.robot()), 1e-12 * (1 + part.length()));
      }
      EXPECT_NEAR(sum, distance(path[i - 1], path[i]), 1e-9);
    }
  });
}

/// The map and the path, moved by an exact map of the plane.
template <class Move>
void expect_same_moved(const Region& region, const Polyline& path, int sides, double scale, Move move) {
  Region moved = region;
  for (Polygon& p : moved.polygons) {
    const auto each = [&](Ring& r) {
      for (Point& q : r) q = move(q);
      if (sides < 0) std::reverse(r.begin(), r.end());
    };
    each(p.outer);
    for (Ring& h : p.holes) each(h);
  }
  const TautSpace space(region), other_space(moved);
  TautTether tether(space, path[0]), other(other_space, move(path[0]));
  for (std::size_t i = 1; i < path.size(); ++i) {
    tether.drive(path[i]);
    other.drive(move(path[i]));
    std::vector<Bend> expected;
    for (const Bend& b : tether.bends()) expected.push_back({move(b.at), sides * b.side});
    ASSERT_EQ(other.bends(), expected) << "vertex " << i;
    ASSERT_NEAR(other.length(), scale * tether.length(), 1e-9 * scale);
  }
}

TEST(TautTether, ShiftTurnMirrorAndScaleChangeNothing) {
  for (const std::uint64_t seed : seeds(40)) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    Rng rng(seed);
    const World world(seed % 2 == 0 ? clutter_box(rng, 6, 6, true) : rooms(rng, 6));
    Polyline path{world.random_point(rng)};
    const auto on_lattice = [](const Point& p) {
      return Point(std::round(64 * p.x()) / 64, std::round(64 * p.y()) / 64);
    };
    do path[0] = on_lattice(world.random_point(rng));
    while (!world.index.contains(path[0]));
    while (path.size() < 60) {
      const Point to = on_lattice(world.next(rng, path.back(), path[0]));
      if (to != path.back() && world.index.contains(path.back(), to)) path.push_back(to);
    }
    expect_same_moved(world.region, path, 1, 1, [](const Point& p) { return Point(p.x() + 4096, p.y() - 1000.5); });
    expect_same_moved(world.region, path, 1, 1, [](const Point& p) { return Point(-p.y(), p.x()); });
    expect_same_moved(world.region, path, -1, 1, [](const Point& p) { return Point(-p.x(), p.y()); });
    expect_same_moved(world.region, path, 1, 1024, [](const Point& p) { return Point(1024 * p.x(), 1024 * p.y()); });
  }
}

// ---------------------------------------------------------------- by hand

Ring block(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}}; }
Region hall(const std::vector<Ring>& blocks) { return {{{{{0, 0}, {8, 0}, {8, 5}, {0, 5}}, blocks}}}; }
/// One pillar with corners A, B, C, D, counter-clockwise from the lower left.
const Point kA(2, 2), kB(3, 2), kC(3, 3), kD(2, 3);
Region pillar() { return hall({block(2, 2, 3, 3)}); }

TEST(TautTether, WindsTwiceRoundAPillarAndBack) {
  const TautSpace space(pillar());
  TautTether tether(space, {1, 1});
  const Polyline lap{{4, 1}, {4, 4}, {1, 4}, {1, 1}};
  std::vector<std::vector<Bend>> states{{}};
  for (int i = 0; i < 2; ++i)
    for (const Point& p : lap) {
      tether.drive(p);
      states.push_back(tether.bends());
    }
  const Bend a{kA, kLeft}, b{kB, kLeft}, c{kC, kLeft}, d{kD, kLeft};
  EXPECT_THAT(states[1], IsEmpty());
  EXPECT_THAT(states[2], ElementsAre(b));
  EXPECT_THAT(states[3], ElementsAre(b, c));
  EXPECT_THAT(states[4], ElementsAre(b, c, d));
  EXPECT_THAT(states[8], ElementsAre(b, c, d, a, b, c, d));
  EXPECT_NEAR(tether.length(), 2 * std::sqrt(5) + 6, 1e-12);
  for (int i = 7; i >= 0; --i) {
    tether.drive(i % 4 == 0 ? Point(1, 1) : lap[static_cast<std::size_t>(i % 4 - 1)]);
    EXPECT_EQ(tether.bends(), states[static_cast<std::size_t>(i)]);
  }
  EXPECT_EQ(tether.length(), 0);
}

TEST(TautTether, RunsAlongAWallAndThroughItsCorners) {
  const TautSpace space(pillar());
  TautTether tether(space, {1, 1});
  tether.drive(kA);
  EXPECT_THAT(tether.bends(), IsEmpty());
  tether.drive(Point(2.5, 2));
  tether.drive(kB);
  EXPECT_THAT(tether.bends(), IsEmpty());
  tether.drive(Point(3, 2.5));
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(Point(3, 4));  // through C, straight on
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(Point(2, 4));
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}, Bend{kC, kLeft}));
  tether.drive(kC);
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(Point(4, 2.625));
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(Point(5, 3));  // in line with the anchor and B: no turn is left
  EXPECT_THAT(tether.bends(), IsEmpty());
  EXPECT_NEAR(tether.length(), std::sqrt(20), 1e-15);
}

TEST(TautTether, RunsStraightThroughACornerThatHoldsItLater) {
  const TautSpace space(pillar());
  TautTether tether(space, {2, 1});
  tether.drive(Point(3, 1));
  tether.drive(Point(3, 4));  // through B and C at once
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(Point(2, 4));
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}, Bend{kC, kLeft}));
}

TEST(TautTether, PassesOverItsPivotAndItsAnchor) {
  const TautSpace space(pillar());
  TautTether tether(space, {1, 1});
  tether.drive(Point(1.5, 1));
  tether.drive(Point(0.5, 1));  // over the anchor
  EXPECT_THAT(tether.bends(), IsEmpty());
  EXPECT_EQ(tether.length(), 0.5);
  tether.drive(Point(4, 1));
  tether.drive(Point(4, 3));
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  std::vector<TautTether::Swing> swings;
  tether.drive(Point(2, 1), [&](const TautTether::Swing& s) { swings.push_back(s); });  // over B
  EXPECT_THAT(tether.bends(), IsEmpty());
  EXPECT_EQ(tether.length(), 1);
  ASSERT_EQ(swings.size(), 2u);
  EXPECT_EQ(swings[0].pivot, kB);
  EXPECT_EQ(swings[0].to, kB);
  EXPECT_EQ(swings[1].pivot, Point(1, 1));
}

TEST(TautTether, DrivesBackAlongItselfToNothing) {
  const TautSpace space(pillar());
  TautTether tether(space, {2.5, 1});
  for (const Point& p : Polyline{{4, 1}, {4, 4}, {1, 4}, {1, 1}, {4, 1}}) tether.drive(p);
  EXPECT_EQ(tether.bends().size(), 4u);
  Polyline back = tether.polyline();
  while (back.size() > 1) {
    back.pop_back();
    tether.drive(lerp(tether.robot(), back.back(), 0.5));
    EXPECT_EQ(tether.bends().size(), back.size() - 1);
    tether.drive(back.back());
    EXPECT_EQ(tether.bends().size(), back.size() > 1 ? back.size() - 2 : 0);
  }
  EXPECT_EQ(tether.length(), 0);
  EXPECT_THAT(tether.polyline(), ElementsAre(Point(2.5, 1), Point(2.5, 1)));
}

TEST(TautTether, OfCornersInLineOnlyTheFarthestIsABend) {
  const TautSpace space(hall({block(2, 2, 3, 3), block(4, 2, 5, 3)}));
  for (const Point& anchor : {Point(1, 2), Point(1.5, 2)}) {
    TautTether tether(space, anchor);
    tether.drive(Point(6, 2));  // along both
    EXPECT_THAT(tether.bends(), IsEmpty());
    tether.drive(Point(6, 4));
    EXPECT_THAT(tether.bends(), ElementsAre(Bend{{5, 2}, kLeft}));
    tether.drive(Point(6, 1));
    EXPECT_THAT(tether.bends(), IsEmpty());
    tether.drive(Point(3.5, 1));
    tether.drive(Point(3.5, 4));
    EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
    // From B into line with (4, 2) and (5, 2): a point where nothing turns.
    tether.drive(Point(3.5, 2));
    EXPECT_THAT(tether.bends(), IsEmpty());
  }
}

TEST(TautTether, AnObstacleAtItsOtherSideDoesNotHoldIt) {
  const TautSpace space(hall({block(2, 2, 3, 3), block(4, 1, 5, 2)}));  // above the line y = 2, and below it
  TautTether tether(space, {1, 2});
  tether.drive(Point(6, 2));
  EXPECT_THAT(tether.bends(), IsEmpty());
  tether.drive(Point(6, 3));
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(Point(6, 1));
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{{5, 2}, kRight}));
  tether.drive(Point(6, 2));
  EXPECT_THAT(tether.bends(), IsEmpty());
  EXPECT_EQ(tether.length(), 5);
}

TEST(TautTether, GainsAndReleasesSeveralInOneDrive) {
  const TautSpace space(hall({block(2, 2, 3, 3), block(4, 3, 5, 4)}));
  TautTether tether(space, {1, 1.5});
  std::vector<std::size_t> bends;
  const auto count = [&](const TautTether::Swing& s) { bends.push_back(s.bends); };
  tether.drive(Point(7, 1));
  tether.drive(Point(7, 4.9), count);
  EXPECT_THAT(bends, ElementsAre(0u, 1u, 2u));
  tether.drive(Point(1, 3.5));
  EXPECT_THAT(tether.bends(),
              ElementsAre(Bend{kB, kLeft}, Bend{{5, 3}, kLeft}, Bend{{5, 4}, kLeft}, Bend{{4, 4}, kLeft}));
  tether.drive(Point(7, 4.9));
  bends.clear();
  tether.drive(Point(7, 1), count);
  EXPECT_THAT(bends, ElementsAre(2u, 1u, 0u));
}

TEST(TautTether, AnchorOnAWallOrAtACorner) {
  const TautSpace space(pillar());
  TautTether wall(space, {2.5, 2});
  wall.drive(Polyline{kB, kC});
  EXPECT_THAT(wall.bends(), ElementsAre(Bend{kB, kLeft}));
  EXPECT_EQ(wall.length(), 1.5);
  wall.drive(Polyline{{4, 3}, {4, 1}, {1, 1}, {1, 2.5}});
  EXPECT_THAT(wall.bends(), ElementsAre(Bend{kA, kRight}));

  TautTether corner(space, kB);
  corner.drive(Polyline{{4, 1}, {3.5, 2.5}});
  EXPECT_THAT(corner.bends(), IsEmpty());
  corner.drive(Point(2.5, 4));
  EXPECT_THAT(corner.bends(), ElementsAre(Bend{kC, kLeft}));
  corner.drive(Polyline{{1, 4}, {1, 1}, {4, 1}});
  EXPECT_THAT(corner.bends(), ElementsAre(Bend{kC, kLeft}, Bend{kD, kLeft}, Bend{kA, kLeft}));
  corner.drive(Point(4, 2.5));  // round the anchor's own corner
  EXPECT_THAT(corner.bends(), ElementsAre(Bend{kC, kLeft}, Bend{kD, kLeft}, Bend{kA, kLeft}, Bend{kB, kLeft}));
  corner.drive(Polyline{{4, 1}, {1, 1}, {1, 4}, {4, 4}, kB});
  EXPECT_THAT(corner.bends(), IsEmpty());
  EXPECT_EQ(corner.length(), 0);
}

TEST(TautTether, TouchingRingsHoldItAsOne) {
  // Two blocks that share the corner (3, 3), and one that touches the border.
  const TautSpace space(hall({block(2, 2, 3, 3), block(3, 3, 4, 4), {{6, 0}, {5, 1}, {6, 2}, {7, 1}}}));
  TautTether tether(space, {1, 1});
  tether.drive(Polyline{{3.5, 1}, {3.5, 2.9}});
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(kC);  // the shared corner, from below
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether.drive(Polyline{{4, 3}, {4.5, 4.5}, {2.5, 4.5}});
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}, Bend{{4, 3}, kLeft}, Bend{{4, 4}, kLeft}));
  tether.drive(kC);  // the same point from above, but another bend
  EXPECT_THAT(tether.bends(),
              ElementsAre(Bend{kB, kLeft}, Bend{{4, 3}, kLeft}, Bend{{4, 4}, kLeft}, Bend{{3, 4}, kLeft}));
  tether.drive(Polyline{{2.5, 4.5}, {1, 4}, {1, 1}});
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}, Bend{{4, 3}, kLeft}, Bend{{4, 4}, kLeft},
                                          Bend{{3, 4}, kLeft}, Bend{kD, kLeft}));
}

TEST(TautTether, ZeroLengthDriveChangesNothing) {
  const TautSpace space(pillar());
  TautTether tether(space, {1, 1});
  int calls = 0;
  tether.drive(Point(1, 1), [&](const TautTether::Swing&) { ++calls; });
  EXPECT_EQ(calls, 0);
  EXPECT_EQ(tether.length(), 0);
  tether.drive(Polyline{{4, 1}, {4, 4}, {4, 4}});
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
}

TEST(TautTether, ACopyIsIndependent) {
  const TautSpace space(pillar());
  TautTether tether(space, {1, 1});
  tether.drive(Polyline{{4, 1}, {4, 4}});
  TautTether copy = tether;
  copy.drive(Point(1, 4));
  EXPECT_EQ(copy.bends().size(), 2u);
  EXPECT_THAT(tether.bends(), ElementsAre(Bend{kB, kLeft}));
  tether = copy;
  EXPECT_EQ(tether.bends().size(), 2u);
}

TEST(TautTether, WithoutObstaclesItIsAStraightLine) {
  const TautSpace nothing(Region{}), hall_only(box_region({0, 0}, {2, 1}));
  for (const TautSpace* space : {&nothing, &hall_only}) {
    TautTether tether(*space, {0, 0});
    tether.drive(Polyline{{2, 0}, {2, 1}, {0, 1}});
    EXPECT_THAT(tether.polyline(), ElementsAre(Point(0, 0), Point(0, 1)));
  }
}

/// Points beside walls and corners, `off` metres outside (or, below 0, inside) of them.
TEST(TautTether, ToleratesPointsALittleInsideWalls) {
  for (const std::uint64_t seed : seeds(60)) {
    Rng rng(seed);
    const Ring hole = convex_ring(rng, {4, 2.5}, rng.between(0.5, 1.5), rng.between(3, 9));
    const TautSpace space(hall({samples::reversed(hole)}));
    const Point anchor = lerp(hole[0], hole[1], 0.3);  // rounded, so a little inside or outside as well
    std::vector<TautTether> strings;
    const std::vector<double> offs{1e-5, 0, 1e-15, -1e-15, 1e-12, -1e-12, -1e-9, 1e-7, -1e-7, -1e-6};
    for (std::size_t k = 0; k < offs.size(); ++k) strings.emplace_back(space, anchor);
    const int n = static_cast<int>(hole.size());
    for (int lap = 0; lap < 4 * n; ++lap) {  // twice round, and twice back
      const bool back = lap >= 2 * n;
      const int i = (back ? 4 * n - 1 - lap : lap) % n;
      const auto at = [&](int j) { return hole[static_cast<std::size_t>((j + 2 * n) % n)]; };
      const Point a = at(i), b = at(i + 1), c = at(i + 2);
      const Point out = -perpendicular(b - a).normalized();
      const Point tip = (b - a).normalized() + (b - c).normalized();
      Polyline local{lerp(a, b, 0.4), lerp(a, b, 0.6)};
      for (int stop = 0; stop < 3; ++stop) {
        const int which = back ? 2 - stop : stop;
        for (std::size_t k = 0; k < offs.size(); ++k) {
          SCOPED_TRACE(fmt::format("seed {} off {} step {}.{}", seed, offs[k], lap, stop));
          const Point p = which == 2 ? Point(b + offs[k] * tip.normalized())
                                     : Point(local[static_cast<std::size_t>(which)] + offs[k] * out);
          strings[k].drive(p);
          ASSERT_NEAR(strings[k].length(), strings[0].length(), 1e-4);
          if (which == 2 && offs[k] <= 1e-12) continue;  // at a corner: a bend may count or not
          ASSERT_EQ(strings[k].bends(), strings[0].bends());
        }
      }
    }
    EXPECT_THAT(strings[1].bends(), IsEmpty());
  }
}

TEST(TautTether, ForgivesTheRoundingOfATurnedMap) {  // walls are followed and corners met only but for rounding
  for_random_paths(140, 80, [](const World& world, const Polyline& path, Rng& rng) {
    const double angle = rng.between(0.1, 6.0);
    const Point shift(rng.between(-50.0, 50.0), rng.between(-50.0, 50.0)), noise(1e-7 * rng.unit(), 1e-7 * rng.unit());
    const TautSpace turned(transformed(world.region, angle, shift));
    const auto move = [&](const Point& p) {
      return transformed({{{{p}, {}}}}, angle, shift).polygons[0].outer[0];  // corners meet corners
    };
    TautTether tether(world.space, path[0]), other(turned, move(path[0])), noisy(turned, move(path[0]) + noise);
    for (std::size_t i = 1; i < path.size(); ++i) {
      tether.drive(path[i]);
      other.drive(move(path[i]));
      noisy.drive(move(path[i]) + noise * rng.between(-1.0, 1.0));
      ASSERT_NEAR(other.length(), tether.length(), 1e-9) << "vertex " << i;
      ASSERT_NEAR(noisy.length(), tether.length(), 1e-5) << "vertex " << i;
    }
  });
}

TEST(TautTether, EndsWhereverAWayLeadsThatNoRobotCanDrive) {  // through walls: no promise but an end
  for (const std::uint64_t seed : seeds(30)) {
    Rng rng(seed);
    const World world(random_map(rng, static_cast<int>(seed % kKinds)));
    TautTether tether(world.space, world.random_point(rng));
    for (int i = 0; i < 300; ++i) {
      const Point to(rng.between(world.box.low.x() - 1, world.box.high.x() + 1),
                     rng.between(world.box.low.y() - 1, world.box.high.y() + 1));
      tether.drive(rng.chance(0.3) ? world.mesh.points()[rng.below(world.mesh.points().size())] : to);
      ASSERT_TRUE(std::isfinite(tether.length()));
      ASSERT_NEAR(tether.length(), length(tether.polyline()), 1e-9 * (1 + tether.length()));
    }
  }
}

TEST(TautTether, RefusesPointsThatAreNotFinite) {
  const TautSpace space(pillar());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(
      [&] {
        TautTether(space, {nan, 1});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("anchor (nan, 1) of a taut tether is not finite")));
  TautTether tether(space, {1, 1});
  EXPECT_THAT([&] { tether.drive(Point(1, std::numeric_limits<double>::infinity())); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("path point (1, inf) of a taut tether is not finite")));
}

}  // namespace
}  // namespace oxturn
