// Which exchanges of capsules are refused before they are tried.
#include "algorithms/improve/witnesses.hpp"

#include <gtest/gtest.h>

#include <array>

#include "base/random.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Point random_point(const Box& box, Rng& rng) {
  const double x = rng.between(box.low.x(), box.high.x()), y = rng.between(box.low.y(), box.high.y());
  return {x, y};
}

void add(const Point& a, const Point& b, Witnesses& to) {
  Witnesses::Capsule capsule;
  to.capsule(a, b, capsule);
  to.add(capsule);
}

// Lanes with gaps between them, and a vertex among them that moves.
TEST(WitnessesMayChange, WhatItRefusesWouldLeaveMore) {
  const Box hall{{0, 0}, {6, 4}};
  int refused = 0, possible = 0;
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Witnesses witnesses(box_region(hall.low, hall.high), 0.02, 0.3);
    for (double y = 0.3; y < 4; y += 0.6 + rng.between(-0.01, 0.01)) add({0, y}, {6, y}, witnesses);
    for (int k = 0; k < 100; ++k) {
      const Point a = random_point(hall, rng), b = random_point(hall, rng), v = random_point(hall, rng);
      const Point by(rng.between(-0.1, 0.1), rng.between(-0.1, 0.1));
      std::array<Witnesses::Capsule, 2> removed, added;
      witnesses.capsule(a, v, removed[0]);
      witnesses.capsule(v, b, removed[1]);
      witnesses.capsule(a, v + by, added[0]);
      witnesses.capsule(v + by, b, added[1]);
      for (const auto& capsule : removed) witnesses.add(capsule);
      const long most = static_cast<long>(rng.below(40)) - 20;
      const bool may = witnesses.may_change(removed, added, most);
      const long change = witnesses.exchange(removed, added);
      EXPECT_TRUE(may || change > most) << change << " > " << most;
      (may ? possible : refused) += 1;
      witnesses.exchange(added, {});
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(possible, 100);
}

// The disc about a vertex lies in both of its edges.
TEST(WitnessesMayChange, WhereNothingIsGainedItIsExact) {
  Witnesses witnesses(box_region({0, 0}, {6, 4}), 0.02, 0.3);
  std::array<Witnesses::Capsule, 2> removed;
  witnesses.capsule({1, 1}, {3, 2}, removed[0]);
  witnesses.capsule({3, 2}, {5, 1}, removed[1]);
  for (const auto& capsule : removed) witnesses.add(capsule);
  const long covered = witnesses.points() - witnesses.uncovered();
  EXPECT_FALSE(witnesses.may_change(removed, {}, covered - 1));
  EXPECT_TRUE(witnesses.may_change(removed, {}, covered));
}

}  // namespace
}  // namespace oxturn
