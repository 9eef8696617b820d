#include <fmt/format.h>
#include <gmock/gmock.h>
#include <png.h>

#include <cmath>
#include <map>

#include "base/files.hpp"
#include "base/random.hpp"
#include "maps/formats.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string sample(const std::string& name) { return OXTURN_SOURCE_DIR "/tests/data/ros/" + name; }

/// A folder with map.yaml and its image.
class RosFolder {
 public:
  std::map<std::string, std::string> keys{{"image", "map.pgm"}, {"resolution", "0.5"},       {"origin", "[0, 0, 0]"},
                                          {"negate", "0"},      {"occupied_thresh", "0.65"}, {"free_thresh", "0.196"}};
  void image(const std::string& bytes, const std::string& name = "map.pgm") { write_file(folder_.file(name), bytes); }
  MapFile read(const Settings& options = {}) const {
    std::string yaml;
    for (const auto& [key, value] : keys) yaml += key + ": " + value + "\n";
    write_file(folder_.file("map.yaml"), yaml);
    return read_map(folder_.file("map.yaml"), options);
  }
  std::string why(const Settings& options = {}) const {
    std::string text = complaint([&] { read(options); });
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    const std::string prefix = folder_.path().string() + "/";
    for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
    return text;
  }
  std::string file(const std::string& name) const { return folder_.file(name); }

 private:
  TemporaryFolder folder_;
};

std::string pgm(int columns, int rows, const std::vector<int>& values) {
  std::string bytes = fmt::format("P5\n{} {}\n255\n", columns, rows);
  for (const int v : values) bytes.push_back(static_cast<char>(v));
  return bytes;
}

/// Free or not, cell by cell, by point location in the region: shares nothing with the tracing.
std::vector<std::string> cells_of(const Region& free, const Point& origin, double cell, int columns, int rows) {
  std::vector<std::string> result;
  for (int row = 0; row < rows; ++row) {
    std::string line;
    for (int i = 0; i < columns; ++i)
      line += contains(free, origin + cell * Point(i + 0.5, rows - 1 - row + 0.5)) ? '.' : '#';
    result.push_back(line);
  }
  return result;
}

TEST(Ros, SmallMapCellByCell) {
  const MapFile m = read_map(sample("small.yaml"));
  EXPECT_EQ(m.map.name, "small");
  EXPECT_EQ(m.map.family, "file");
  EXPECT_EQ(m.map.source, sample("small.yaml"));
  EXPECT_THAT(cells_of(m.map.free, {-1.5, 2.25}, 0.05, 8, 6),
              ElementsAre("########", "#.....##", "#.#...##", "#.....##", "#....###", "########"));
  EXPECT_NEAR(area(m.map.free), 18 * 0.0025, 1e-12);
  EXPECT_EQ(hole_count(m.map.free), 1u);
  EXPECT_THAT(m.remarks, ElementsAre("3 cells are unknown and count as wall"));
}

TEST(Ros, VerticesAreWholePixelsFromTheOrigin) {
  const MapFile m = read_map(sample("small.yaml"));
  for_each_ring(m.map.free, [](const Ring& ring) {
    for (const Point& p : ring) {
      const double i = std::round((p.x() + 1.5) / 0.05), j = std::round((p.y() - 2.25) / 0.05);
      EXPECT_EQ(p.x(), -1.5 + i * 0.05);  // exactly: one multiplication, one addition
      EXPECT_EQ(p.y(), 2.25 + j * 0.05);
    }
  });
}

TEST(Ros, UnknownIsFreeOnlyByOption) {
  Settings options;
  options["unknown_free"] = true;
  const MapFile m = read_map(sample("small.yaml"), options);
  EXPECT_NEAR(area(m.map.free), 21 * 0.0025, 1e-12);
  EXPECT_THAT(m.remarks, ElementsAre("3 cells are unknown and count as free"));
}

TEST(Ros, SpeckleIsDroppedUpToTheAreaWithARemark) {
  Settings options;
  options["drop_speckle"] = 0.0025;  // exactly one cell
  const MapFile m = read_map(sample("small.yaml"), options);
  EXPECT_EQ(hole_count(m.map.free), 0u);
  EXPECT_NEAR(area(m.map.free), 19 * 0.0025, 1e-12);
  EXPECT_THAT(m.remarks, testing::Contains("1 specks of at most 0.0025 m2 dropped (1 cells)"));
  options["drop_speckle"] = 0.0024;
  EXPECT_EQ(hole_count(read_map(sample("small.yaml"), options).map.free), 1u);
  options["drop_speckle"] = 1e6;  // walls that touch the border are no specks
  EXPECT_NEAR(area(read_map(sample("small.yaml"), options).map.free), 19 * 0.0025, 1e-12);
}

TEST(Ros, DiagonalCellsAreOneSpeck) {
  RosFolder f;
  f.image(pgm(6, 4, {255, 255, 255, 255, 255, 255, 255, 0,   255, 255, 0,   255,
                     255, 255, 0,   255, 255, 255, 255, 255, 255, 255, 255, 255}));
  Settings options;
  options["drop_speckle"] = 0.25;  // one cell of 0.5 m: drops the single one, keeps the pair
  const MapFile m = f.read(options);
  EXPECT_DOUBLE_EQ(area(m.map.free), 22 * 0.25);
  EXPECT_THAT(m.remarks, ElementsAre("1 specks of at most 0.25 m2 dropped (1 cells)"));
}

// Oracle: map_server's rule written out by hand for every grey value.
TEST(Ros, ThresholdsAsInMapServer) {
  for (const bool negate : {false, true})
    for (const char* mode : {"trinary", "scale"}) {
      RosFolder f;
      f.keys["negate"] = negate ? "1" : "0";
      f.keys["mode"] = mode;
      std::vector<int> values;
      for (int v = 0; v < 256; ++v) values.push_back(v);
      f.image(pgm(16, 16, values));
      double free = 0, unknown = 0;
      for (int v = 0; v < 256; ++v) {
        const double occ = negate ? v / 255.0 : (255 - v) / 255.0;
        if (occ > 0.65) continue;
        (occ < 0.196 ? free : unknown) += 0.25;
      }
      EXPECT_DOUBLE_EQ(area(f.read().map.free), free);
      Settings options;
      options["unknown_free"] = true;
      EXPECT_DOUBLE_EQ(area(f.read(options).map.free), free + unknown);
    }
}

TEST(Ros, RawValuesArePercent) {
  RosFolder f;
  f.keys["mode"] = "raw";
  f.image(pgm(5, 1, {0, 19, 50, 100, 255}));
  EXPECT_THAT(cells_of(f.read().map.free, {0, 0}, 0.5, 5, 1), ElementsAre("..###"));
  Settings options;
  options["unknown_free"] = true;
  EXPECT_THAT(cells_of(f.read(options).map.free, {0, 0}, 0.5, 5, 1), ElementsAre("...#."));
}

TEST(Ros, YawRotatesAboutTheOrigin) {
  RosFolder f;
  f.keys["origin"] = "[10, 20, 1.5707963267948966]";
  f.image(pgm(3, 1, {255, 255, 0}));  // free from (0, 0) to (1, 0.5) before it is placed
  const Box box = bounding_box(f.read().map.free);
  EXPECT_NEAR(box.low.x(), 9.5, 1e-12);
  EXPECT_NEAR(box.high.x(), 10, 1e-12);
  EXPECT_NEAR(box.low.y(), 20, 1e-12);
  EXPECT_NEAR(box.high.y(), 21, 1e-12);
  EXPECT_GT(area(f.read().map.free), 0);
}

TEST(Ros, RandomImagesCellByCell) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const int columns = rng.between(1, 20), rows = rng.between(1, 20);
    RosFolder f;
    std::vector<int> values;
    std::vector<std::string> truth;
    for (int j = 0; j < rows; ++j) {
      truth.emplace_back();
      for (int i = 0; i < columns; ++i) {
        const bool free = (i == 0 && j == 0) || rng.chance(0.6);
        values.push_back(free ? 254 : 0);
        truth.back() += free ? '.' : '#';
      }
    }
    f.image(pgm(columns, rows, values));
    EXPECT_EQ(cells_of(f.read().map.free, {0, 0}, 0.5, columns, rows), truth);
  }
}

TEST(Ros, SimplifyingNeverGrowsFreeSpace) {
  RosFolder f;
  std::vector<int> values;
  for (int j = 0; j < 40; ++j)
    for (int i = 0; i < 40; ++i)
      values.push_back(std::hypot(i - 20, j - 20) < 18 && std::hypot(i - 25, j - 22) > 5 ? 255 : 0);
  f.image(pgm(40, 40, values));
  const MapFile exact = f.read();
  Settings options;
  options["simplify"] = 0.5;
  const MapFile simple = f.read(options);
  EXPECT_LT(vertex_count(simple.map.free), vertex_count(exact.map.free) / 2);
  EXPECT_EQ(hole_count(simple.map.free), 1u);
  Rng rng(1);
  for (int k = 0; k < 4000; ++k) {
    const Point p(rng.between(0.0, 20.0), rng.between(0.0, 20.0));
    if (contains(simple.map.free, p)) { EXPECT_TRUE(contains(exact.map.free, p)); }
  }
  EXPECT_THAT(simple.remarks, testing::Contains(HasSubstr("vertices simplified to")));
}

// --- PNG, written here by libpng's simplified interface ------------------------------------------------------

void write_png(const std::string& file, std::uint32_t format, std::uint32_t columns, std::uint32_t rows,
               const std::vector<std::uint8_t>& pixels, const std::vector<std::uint8_t>& palette = {}) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = columns;
  image.height = rows;
  image.format = format;
  image.colormap_entries = static_cast<png_uint_32>(palette.size() / 3);
  ASSERT_NE(
      png_image_write_to_file(&image, file.c_str(), 0, pixels.data(), 0, palette.empty() ? nullptr : palette.data()),
      0);
}

TEST(Ros, PngOfEveryKind) {
  const std::vector<std::string> truth{".#..", "..#."};
  const std::vector<std::uint8_t> bright{254, 0, 254, 254, 254, 254, 0, 254};
  RosFolder f;
  f.keys["image"] = "map.png";
  const auto check_cells = [&](const char* kind) {
    SCOPED_TRACE(kind);
    EXPECT_EQ(cells_of(f.read().map.free, {0, 0}, 0.5, 4, 2), truth);
  };
  write_png(f.file("map.png"), PNG_FORMAT_GRAY, 4, 2, bright);
  check_cells("grey");
  std::vector<std::uint8_t> rgb, rgba, index;
  for (const std::uint8_t v : bright) {
    rgb.insert(rgb.end(), 3, v);
    rgba.insert(rgba.end(), 3, v);
    rgba.push_back(255);
    index.push_back(v > 0 ? 1 : 0);
  }
  write_png(f.file("map.png"), PNG_FORMAT_RGB, 4, 2, rgb);
  check_cells("colour");
  write_png(f.file("map.png"), PNG_FORMAT_RGBA, 4, 2, rgba);
  check_cells("colour and alpha");
  write_png(f.file("map.png"), PNG_FORMAT_RGB_COLORMAP, 4, 2, index, {0, 0, 0, 254, 254, 254});
  check_cells("palette");
}

TEST(Ros, AlphaDoesNotMakeUnknownFree) {
  RosFolder f;
  f.keys["image"] = "map.png";
  // Unknown grey, opaque (averaging alpha in would make it free); white, opaque; white, transparent.
  write_png(f.file("map.png"), PNG_FORMAT_RGBA, 3, 1, {205, 205, 205, 255, 254, 254, 254, 255, 254, 254, 254, 0});
  const MapFile m = f.read();
  EXPECT_THAT(cells_of(m.map.free, {0, 0}, 0.5, 3, 1), ElementsAre("#.#"));
  EXPECT_THAT(m.remarks, testing::Contains("1 pixels are transparent and count as unknown"));
}

TEST(Ros, PgmOfEveryKind) {
  RosFolder f;
  f.image("P2 # comment\n3 # another\n1 100\n100\t0 #x\n 100");
  EXPECT_THAT(cells_of(f.read().map.free, {0, 0}, 0.5, 3, 1), ElementsAre(".#."));
  f.image(std::string("P5 3 1 1000\n\x03\xe8\x00\x00\x03\xe7", 18));
  EXPECT_THAT(cells_of(f.read().map.free, {0, 0}, 0.5, 3, 1), ElementsAre(".#."));
}

TEST(PlainImage, NeedsAScale) {
  const TemporaryFolder folder;
  write_file(folder.file("plan.pgm"), pgm(3, 2, {255, 255, 0, 0, 255, 205}));
  EXPECT_EQ(complaint([&] { read_map(folder.file("plan.pgm")); }),
            folder.file("plan.pgm") +
                ": a plain image needs a scale in metres per pixel: --scale, or `scale` of the map in a suite");
  Settings options;
  options["scale"] = 2.0;
  EXPECT_THAT(cells_of(read_map(folder.file("plan.pgm"), options).map.free, {0, 0}, 2, 3, 2),
              ElementsAre("..#", "#.#"));
}

TEST(Ros, BadYamlIsOneSentenceWithItsLine) {
  EXPECT_EQ(complaint([] { read_map(sample("backwards.yaml")); }),
            sample("backwards.yaml") + ":4: resolution is -0.05, expected metres per pixel above 0");
  RosFolder good;
  good.image(pgm(2, 1, {255, 255}));
  EXPECT_EQ(good.why(), "");
  const auto with = [&](const char* key, const char* value) {
    const auto keys = good.keys;
    if (value)
      good.keys[key] = value;
    else
      good.keys.erase(key);
    std::string text = good.why();
    good.keys = keys;
    return text;
  };
  for (const char* key : {"image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh"})
    EXPECT_THAT(with(key, nullptr), testing::StartsWith(fmt::format("map.yaml: {} is missing, expected", key)));
  EXPECT_EQ(with("resolution", "five"), "map.yaml:6: resolution is 'five', expected metres per pixel above 0");
  EXPECT_EQ(with("resolution", ".nan"), "map.yaml:6: resolution is nan, expected metres per pixel above 0");
  EXPECT_EQ(with("resolution", "[1]"), "map.yaml:6: resolution is not a number, expected metres per pixel above 0");
  EXPECT_EQ(with("origin", "[0]"),
            "map.yaml:5: origin is not a list of three numbers, expected [x, y, yaw] in metres and radians");
  EXPECT_EQ(with("origin", "[0, x, 0]"), "map.yaml:5: origin's y is 'x', expected metres");
  EXPECT_EQ(with("negate", "perhaps"), "map.yaml:3: negate is 'perhaps', expected 0 or 1");
  EXPECT_EQ(with("occupied_thresh", "65"), "map.yaml:4: occupied_thresh is 65, expected a number from 0 to 1");
  EXPECT_EQ(with("free_thresh", "0.7"),
            "map.yaml:1: free_thresh is 0.7, expected at most occupied_thresh, which is 0.65");
  EXPECT_EQ(with("mode", "colour"), "map.yaml:3: mode is 'colour', expected trinary, scale or raw");
  EXPECT_EQ(with("image", "none.png"), "map.yaml:2: no such file: 'none.png'");
  EXPECT_THAT(with("image", "[unclosed"), testing::StartsWith("map.yaml:"));
  const TemporaryFolder folder;
  for (const char* text : {"", "just words", "- a\n- b\n", "42"}) {
    write_file(folder.file("m.yaml"), text);
    EXPECT_THAT(complaint([&] { read_map(folder.file("m.yaml")); }), HasSubstr("m.yaml: not a ROS map"));
  }
}

TEST(Ros, BadImagesAreOneSentence) {
  RosFolder f;
  const auto with = [&](const std::string& bytes) {
    f.image(bytes);
    return f.why();
  };
  EXPECT_THAT(with(""), HasSubstr("map.pgm: the file is empty"));
  EXPECT_THAT(with("GIF89a........"), HasSubstr("map.pgm: neither a PNG nor a PGM"));
  EXPECT_THAT(with("P5\n3 2\n255\nabc"), HasSubstr("map.pgm: the file ends in the middle of the image"));
  EXPECT_THAT(with("P2\n3 2\n255\n1 2 3"), HasSubstr("map.pgm: the file ends in the middle of the image"));
  EXPECT_THAT(with("P2\n2 1\n255\n1 300"), HasSubstr("map.pgm: pixel 2 is 300, expected at most 255"));
  EXPECT_THAT(with("P5\n0 2\n255\nabc"), HasSubstr("the image is 0 x 2 pixels, expected at least 1 x 1"));
  EXPECT_THAT(with("P5\n90000 90000\n255\nabc"),
              HasSubstr("the image is 90000 x 90000 pixels, expected at most 100 million"));
  EXPECT_THAT(with("P5\nx 2\n255\nabc"), HasSubstr("width is not a whole number"));
  EXPECT_THAT(with(pgm(2, 1, {0, 205})), HasSubstr("no cell is free (1 occupied, 1 unknown)"));

  f.keys["image"] = "map.png";
  write_png(f.file("map.png"), PNG_FORMAT_GRAY, 64, 64, std::vector<std::uint8_t>(64 * 64, 254));
  const std::string whole = read_file(f.file("map.png"));
  for (std::size_t keep = 8; keep < whole.size(); keep += 7) {
    f.image(whole.substr(0, keep), "map.png");
    EXPECT_THAT(f.why(), HasSubstr("map.png: not a readable PNG: ")) << keep;
  }
  f.image(whole.substr(0, whole.size() / 2), "map.png");
  EXPECT_THAT(f.why(), HasSubstr("map.png: not a readable PNG: the file ends in the middle of the image"));
}

TEST(Ros, RandomDamageNeverCrashes) {
  RosFolder f;
  f.keys["image"] = "map.png";
  std::vector<std::uint8_t> rgba(16 * 16 * 4, 254);
  write_png(f.file("map.png"), PNG_FORMAT_RGBA, 16, 16, rgba);
  const std::string whole = read_file(f.file("map.png"));
  for (const auto seed : seeds(200)) {
    Rng rng(seed);
    std::string bad = whole;
    for (int k = rng.between(1, 5); k > 0; --k) bad[rng.below(bad.size())] = static_cast<char>(rng.below(256));
    f.image(bad, "map.png");
    try {
      f.read();
    } catch (const std::invalid_argument& e) { EXPECT_THAT(e.what(), HasSubstr("map.png")); }
  }
}

TEST(ReadMap, MissingFileUnknownSuffixAndBadOptions) {
  EXPECT_EQ(complaint([] { read_map("no/such.yaml"); }), "no such file: 'no/such.yaml'");
  const TemporaryFolder folder;
  write_file(folder.file("a.dwg"), "x");
  EXPECT_EQ(complaint([&] { read_map(folder.file("a.dwg")); }),
            "cannot read '" + folder.file("a.dwg") +
                "': its name must end in one of: .yaml, .yml, .geojson, .json, .png, .pgm, .svg, .poly");
  EXPECT_THAT(complaint([&] { read_map(folder.path().string()); }), HasSubstr("it is a folder"));
  Settings options;
  options["simplify"] = std::nan("");
  EXPECT_EQ(complaint([&] { read_map(sample("small.yaml"), options); }),
            "parameter 'simplify' of a map reader is nan, expected a finite number");
}

}  // namespace
}  // namespace oxturn
