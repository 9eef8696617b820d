// What workers send arrives as it was.
#include "bench/wire.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <thread>

#include "base/random.hpp"

namespace oxturn {
namespace {

void expect_same(const Path& received, const Path& sent) {
  ASSERT_EQ(received.legs.size(), sent.legs.size());
  for (std::size_t i = 0; i < sent.legs.size(); ++i) {
    EXPECT_EQ(received.legs[i].tool, sent.legs[i].tool);
    EXPECT_EQ(received.legs[i].gear, sent.legs[i].gear);
    EXPECT_EQ(received.legs[i].width, sent.legs[i].width);
    EXPECT_EQ(received.legs[i].points, sent.legs[i].points);
  }
}

TEST(Wire, PathsKeepToolAndGear) {
  Path sent;
  Point at(0, 0);
  for (const bool tool : {true, false})
    for (const Gear gear : {Gear::forward, Gear::reverse}) {
      sent.legs.push_back({tool, {at, at + Point(1, 0.1)}, gear});
      at += Point(1, 0.1);
    }
  wire::Pipe pipe = wire::make_pipe();
  ASSERT_TRUE(wire::send_path(pipe.write.number(), 'p', sent));
  Path received;
  wire::FrameReader reader(1 << 20);
  reader.read(pipe.read.number(), [&](char, std::string_view payload) { received = wire::path_from(payload); });
  expect_same(received, sent);
}

/// Short legs share calls, and long ones go past the buffer: in any order the bytes are the same.
TEST(Wire, PathsOfManyLegsOfAnyLength) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng(seed);
    Path sent;
    for (int k = 0; k < 300; ++k) {
      const int count = rng.chance(0.05) ? rng.between(0, 9000) : rng.between(0, 3);
      Polyline points;
      for (int i = 0; i < count; ++i) points.emplace_back(rng.unit(), rng.unit());
      sent.legs.push_back({rng.chance(0.5), std::move(points), Gear::forward, rng.unit()});
    }
    wire::Pipe pipe = wire::make_pipe();
    Path received;
    std::thread other([&] {
      wire::FrameReader reader(std::size_t{1} << 30);
      const auto take = [&](char, std::string_view payload) { received = wire::path_from(payload); };
      while (received.legs.empty() && reader.read(pipe.read.number(), take) == wire::FrameReader::State::open) {}
    });
    const bool all = wire::send_path(pipe.write.number(), 'p', sent);
    pipe.write.close();
    other.join();
    ASSERT_TRUE(all);
    expect_same(received, sent);
  }
}

TEST(Wire, RegionsKeepTheirHoles) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng rng(seed);
    const auto ring = [&rng] {
      Ring points;
      for (int i = rng.between(0, 5); i > 0; --i) points.emplace_back(rng.unit(), rng.unit());
      return points;
    };
    Region sent;
    for (int k = rng.between(0, 8); k > 0; --k) {
      sent.polygons.push_back({ring(), {}});
      for (int h = rng.between(0, 3); h > 0; --h) sent.polygons.back().holes.push_back(ring());
    }
    const std::string bytes = wire::pack(sent);
    const Region received = wire::region_from(bytes);
    ASSERT_EQ(received.polygons.size(), sent.polygons.size());
    for (std::size_t k = 0; k < sent.polygons.size(); ++k) {
      EXPECT_EQ(received.polygons[k].outer, sent.polygons[k].outer);
      EXPECT_EQ(received.polygons[k].holes, sent.polygons[k].holes);
    }
    EXPECT_THROW(wire::region_from(std::string_view(bytes).substr(0, bytes.size() - 1)), std::runtime_error);
  }
}

// No memory is reserved for more than the message can hold.
TEST(Wire, MorePolygonsThanBytes) {
  std::string bytes;
  wire::put(bytes, std::uint64_t{1} << 60);
  EXPECT_THROW(wire::region_from(bytes), std::runtime_error);
}

TEST(Wire, NobodyReadsThePath) {
  wire::Pipe pipe = wire::make_pipe();
  pipe.read.close();
  const auto before = std::signal(SIGPIPE, SIG_IGN);
  EXPECT_FALSE(wire::send_path(pipe.write.number(), 'p', Path{{{true, Polyline(100000, Point(1, 2))}}}));
  EXPECT_FALSE(wire::send_path(pipe.write.number(), 'p', Path{{{true, {{1, 2}, {3, 4}}}}}));
  std::signal(SIGPIPE, before);
}

}  // namespace
}  // namespace oxturn
