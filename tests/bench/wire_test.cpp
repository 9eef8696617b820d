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
