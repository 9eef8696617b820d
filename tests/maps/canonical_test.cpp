#include <gmock/gmock.h>

#include <algorithm>

#include "base/files.hpp"
#include "base/random.hpp"
#include "base/sha256.hpp"
#include "base/text.hpp"
#include "maps/formats.hpp"
#include "maps/map.hpp"
#include "maps/robot.hpp"
#include "tests/support/files.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Region sample() {
  Region r;
  r.polygons.push_back(
      {{{0, 0}, {10, 0}, {10, 8}, {0, 8}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}, {{4, 4}, {4, 6}, {6, 6}, {6, 4}}}});
  r.polygons.push_back({{{20, 0}, {25, 0}, {25, 5}}, {}});
  return r;
}

void spin(Ring& ring, Rng& rng) {
  std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(rng.below(ring.size())), ring.end());
}

TEST(Canonical, TheSameRegionWrittenDifferentlyHasTheSameBytes) {
  const std::string bytes = canonical_bytes(sample());
  for (const auto seed : seeds(50)) {
    Rng rng(seed);
    Region r = sample();
    rng.shuffle(r.polygons);
    for (Polygon& p : r.polygons) {
      rng.shuffle(p.holes);
      spin(p.outer, rng);
      for (Ring& h : p.holes) spin(h, rng);
    }
    EXPECT_EQ(canonical_bytes(r), bytes) << "seed " << seed;
  }
}

TEST(Canonical, RingThatTouchesItselfInItsSmallestVertex) {
  const Ring bow{{0, 0}, {2, -1}, {2, 0}, {0, 0}, {2, 1}, {1, 2}};
  for (std::size_t k = 0; k < bow.size(); ++k) {
    Ring r = bow;
    std::rotate(r.begin(), r.begin() + static_cast<std::ptrdiff_t>(k), r.end());
    EXPECT_EQ(canonical_bytes({{{r, {}}}}), canonical_bytes({{{bow, {}}}}));
  }
}

TEST(Canonical, AnyChangeOfThePointSetChangesTheBytes) {
  const std::string bytes = canonical_bytes(sample());
  Region moved = sample();
  moved.polygons[0].holes[1][2].x() = std::nextafter(6.0, 7.0);
  EXPECT_NE(canonical_bytes(moved), bytes);
  Region fewer = sample();
  fewer.polygons[0].holes.pop_back();
  EXPECT_NE(canonical_bytes(fewer), bytes);
  // The same rings, but the second hole is now an island.
  Region island = sample();
  island.polygons.push_back({island.polygons[0].holes[1], {}});
  island.polygons[0].holes.pop_back();
  EXPECT_NE(canonical_bytes(island), bytes);
}

TEST(Canonical, MinusZeroIsZero) {
  Region r = sample();
  r.polygons[0].outer[0] = {-0.0, 0.0};
  EXPECT_EQ(canonical_bytes(r), canonical_bytes(sample()));
}

TEST(Canonical, NameAndSourceMakeNoDifference) {
  EXPECT_EQ(content_hash(Map{"a", sample(), "file", "x"}), content_hash(Map{"b", sample(), "rooms", "y"}));
}

// FIPS 180-2, appendix B, and the empty message.
TEST(Sha256, PublishedVectors) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Decimal, IsTheShortestThatReadsBackExactly) {
  EXPECT_EQ(to_decimal(0.1), "0.1");
  EXPECT_EQ(to_decimal(-0.0), "0");
  EXPECT_EQ(to_decimal(40), "40");
  Rng rng(7);
  for (int i = 0; i < 2000; ++i) {
    const double d = (rng.unit() - 0.5) * std::pow(10.0, rng.between(-12, 12));
    EXPECT_EQ(std::stod(to_decimal(d)), d);
  }
}

TEST(Files, AreWrittenCompletelyOrNotAtAll) {
  const TemporaryFolder folder;
  const std::string file = folder.file("a.txt");
  write_file(file, "one");
  write_file(file, std::string("two\0three", 9));
  EXPECT_EQ(read_file(file), std::string("two\0three", 9));
  EXPECT_EQ(complaint([&] { write_file(folder.file("no/such/a.txt"), "x"); }),
            "cannot write '" + folder.file("no/such/a.txt") + "': No such file or directory");
  EXPECT_EQ(complaint([&] { write_file(folder.path().string(), "x"); }),
            "cannot write '" + folder.path().string() + "': Is a directory");
  EXPECT_EQ(complaint([&] { write_file("/dev/full", "x"); }), "cannot write '/dev/full': No space left on device");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder.path())) ++files;
  EXPECT_EQ(files, 1u) << "a temporary file was left";
}

TEST(Files, UnreadableFilesAreOneSentence) {
  const TemporaryFolder folder;
  EXPECT_EQ(complaint([&] { read_file(folder.file("x")); }), "no such file: '" + folder.file("x") + "'");
  EXPECT_THAT(complaint([&] { read_file(folder.path().string()); }), testing::HasSubstr("it is a folder"));
}

}  // namespace
}  // namespace oxturn
