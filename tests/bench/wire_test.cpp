// What workers send arrives as it was.
#include "bench/wire.hpp"

#include <gtest/gtest.h>

namespace oxturn {
namespace {

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
  ASSERT_EQ(received.legs.size(), sent.legs.size());
  for (std::size_t i = 0; i < sent.legs.size(); ++i) {
    EXPECT_EQ(received.legs[i].tool, sent.legs[i].tool);
    EXPECT_EQ(received.legs[i].gear, sent.legs[i].gear);
    EXPECT_EQ(received.legs[i].points, sent.legs[i].points);
  }
}

}  // namespace
}  // namespace oxturn
