// Drawings as files and areas, edits with their JSON pointers, the controller's text.
#include "maps/drawing.hpp"

#include <gmock/gmock.h>

#include "base/files.hpp"
#include "maps/drawing_edits.hpp"
#include "maps/drawing_file.hpp"
#include "maps/drawing_text.hpp"
#include "maps/formats.hpp"
#include "tests/support/files.hpp"

namespace oxturn {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Drawing sample() {
  Drawing d;
  d.strokes.push_back({"line", {{1, 1}, {2, 1}, {2, 2}}, 0.16, true, {0, 1, 2}, {1}});
  d.strokes.push_back({"up", {{2, 2}, {3, 2}}, 0.04, false, {0, 1}, {}});
  d.areas.push_back({"box", box_region({4, 1}, {8, 3}).polygons[0], {}});
  d.sha256 = "abc";
  return d;
}
std::string edits(const std::string& members) {
  return R"({"oxturn_edits": 1, "drawing_sha256": "abc")" + std::string(members.empty() ? "" : ", ") + members + "}";
}
Drawing edit(const std::string& members) { return edited(sample(), edits(members), "e.json"); }
std::string why(const std::string& text) {
  return complaint([&] { edited(sample(), text, "e.json"); });
}

TEST(Drawing, AreaIsFillsAndStrokesAsWideAsDrawn) {
  Drawing d = sample();
  d.strokes[0].points = {{1, 1}, {3, 1}};
  const double disc = kPi * 0.08 * 0.08;
  EXPECT_NEAR(area(drawn_area(d)), 8 + 2 * 0.16 + disc, 1e-4);
  EXPECT_TRUE(drawn_area(Drawing{}).empty());
}

TEST(Drawing, GeoJsonKeepsEverything) {
  Drawing d =
      edit(R"("start": [1, 2], "fills": [{"element": "box", "fill": "zigzag", "angle_deg": 90, "outline": true}],
    "connections": [{"action": "enforce", "from": {"element": "line", "vertex": -1},
                     "to": {"element": "up", "vertex": 0}}],
    "curves": [{"from": {"element": "up", "vertex": 1}, "to": {"element": "box", "vertex": 2}, "kind": "bezier",
                "points": [[5, 5]]}])");
  const std::string text = to_geojson(d);
  const Drawing copy = drawing_from_geojson(text, "d.geojson");
  EXPECT_EQ(to_geojson(copy), text);
  EXPECT_EQ(canonical_bytes(copy), canonical_bytes(d));
  EXPECT_EQ(copy.strokes[0].points, d.strokes[0].points);
  EXPECT_THAT(copy.strokes[0].nodes, ElementsAre(0, 1, 2));
  EXPECT_FALSE(copy.strokes[1].tool);
  EXPECT_EQ(copy.areas[0].choice.fill, "zigzag");
  EXPECT_NEAR(*copy.areas[0].choice.angle, kPi / 2, 1e-12);
  EXPECT_EQ(copy.connections[0].from.node, -1);
  EXPECT_EQ(copy.curves[0].kind, DrawnCurve::Kind::bezier);
  EXPECT_THAT(complaint([&] {
                drawing_from_geojson(R"({"features": [{"geometry": {"type": "Point"}, "properties": {}}]})", "d");
              }),
              HasSubstr("d: features 1, geometry, type is \"Point\", expected LineString or Polygon"));
}

TEST(Drawing, MapWithADrawingIsReadAsItWasWritten) {
  const TemporaryFolder folder;
  MapFile file;
  file.map = {"canvas", box_region({0, 0}, {10, 5}), "file", "x"};
  const std::string empty_canvas = content_hash(file.map);
  file.map.drawing = std::make_shared<const Drawing>(sample());
  const std::string drawn = content_hash(file.map);
  EXPECT_NE(drawn, empty_canvas);
  const MapFormats formats = built_in_map_formats();
  write_map(folder.file("m.geojson"), file, formats);
  const MapFile copy = read_map(folder.file("m.geojson"), {}, formats);
  ASSERT_TRUE(copy.map.drawing && copy.map.target_area);
  EXPECT_EQ(canonical_bytes(*copy.map.drawing), canonical_bytes(*file.map.drawing));
  EXPECT_NEAR(area(*copy.map.target_area), area(drawn_area(sample())), 1e-9);
}

TEST(Drawing, SvgIsAMapWithRobotTargetAndEdits) {
  const TemporaryFolder folder;
  write_file(folder.file("d.svg"), "<svg><path id=\"p\" d=\"M0 0H9V9\" stroke=\"#000\" fill=\"none\"/></svg>");
  const MapFormats formats = built_in_map_formats();
  const MapFile plain = read_map(folder.file("d.svg"), {{"canvas_width", 6.0}, {"canvas_height", 6.0}}, formats);
  EXPECT_EQ(area(plain.map.free), 36);
  EXPECT_EQ(plain.robot->tool_width, 0.42);
  EXPECT_GT(area(*plain.map.target_area), 0.04 * 10);
  write_file(folder.file("e.json"),
             R"({"oxturn_edits": 1, "start": [1, 1], "drawing_sha256": ")" + plain.map.drawing->sha256 + "\"}");
  EXPECT_EQ(read_map(folder.file("d.svg"), {{"edits", std::string("e.json")}}, formats).start, Point(1, 1));
}

TEST(DrawingEdits, CutsThenFillsByAPointInside) {
  const Drawing d = edit(R"("cuts": [{"element": "box", "line": [[6, 0], [6, 4]]}],
    "fills": [{"element": "box", "at": [5, 2], "fill": "spiral"},
              {"element": "box", "at": [7, 2], "outline": false}])");
  ASSERT_EQ(d.areas.size(), 2u);
  for (const FilledArea& a : d.areas) {
    EXPECT_NEAR(area(a.area), 4, 1e-3);
    const bool left = contains(Region{{a.area}}, {5, 2});
    EXPECT_EQ(a.choice.fill, left ? "spiral" : "");
    EXPECT_EQ(a.choice.outline.has_value(), !left);
  }
}

TEST(DrawingEdits, ErrorsNameTheirPointer) {
  EXPECT_THAT(why("{"), HasSubstr("e.json:1: not JSON"));
  EXPECT_THAT(why("{}"), HasSubstr("e.json: /oxturn_edits: is missing"));
  EXPECT_THAT(why(R"({"oxturn_edits": 1, "drawing_sha256": "x"})"),
              HasSubstr("e.json: /drawing_sha256: the edits are of another"));
  EXPECT_THAT(why(edits(R"("colour": 1)")), HasSubstr("e.json: /colour: unknown key, expected one of: oxturn_edits"));
  EXPECT_THAT(why(edits(R"("fills": [{"element": "x"}])")),
              HasSubstr("e.json: /fills/0/element: no filled element 'x'"));
  EXPECT_THAT(why(edits(R"("fills": [{"element": "box", "at": [0, 0]}])")),
              HasSubstr("/fills/0/at: is not inside one area"));
  EXPECT_THAT(why(edits(R"("fills": [{"element": "box", "fill": "dots"}])")),
              HasSubstr("/fills/0/fill is \"dots\", expected one of: spiral"));
  EXPECT_THAT(why(edits(R"("fills": [{"element": "box"}, {"element": "box"}])")),
              HasSubstr("/fills/1: the fill of this area was chosen"));
  EXPECT_THAT(why(edits(R"("cuts": [{"element": "box", "line": [[0, 0], [1, 0]]}])")),
              HasSubstr("/cuts/0/line: does not cut an area of element 'box' in two"));
  const auto connection = [](const std::string& action, int to) {
    return R"({"action": ")" + action +
           R"(", "from": {"element": "line", "vertex": -1}, "to": {"element": "up", "vertex": )" + std::to_string(to) +
           "}}";
  };
  EXPECT_THAT(why(edits("\"connections\": [" + connection("enforce", 2) + "]")),
              HasSubstr("/connections/0/to/vertex is 2, expected 0 to 1, or -1 for the last"));
  EXPECT_THAT(why(edits("\"connections\": [" + connection("enforce", 0) + "," + connection("delete", 0) + "]")),
              HasSubstr("/connections/1: the same connection is enforced and deleted"));
  EXPECT_THAT(why(edits(R"("connections": [{"action": "delete", "from": {"element": "up", "vertex": 0},
                                            "to": {"element": "up", "vertex": 0}}])")),
              HasSubstr("/connections/0: a connection from a node to itself"));
}

TEST(DrawingText, EvenlySpacedWithMasksAndStops) {
  const Path path{{{true, {{0, 0}, {0.12, 0}}, Gear::forward, 0.16},
                   {false, {{0.12, 0}, {0.12, 0.04}}},
                   {true, {{0.12, 0.04}, {0.12, 0.08}}}}};
  EXPECT_EQ(drawing_text(path),
            "0 0 28\n0.04 0 28\n0.08 0 28\n0.12 0 28\n\n0.12 0 0\n0.12 0.04 0\n0.12 0.04 127\n0.12 0.08 127\n");
  EXPECT_THAT(drawing_text(path, {}, RakeText::pins), testing::StartsWith("0 0 3\n"));
  const int masks[] = {8, 28, 62, 127};
  const double widths[] = {0.04, 0.16, 0.32, 0.42};
  for (int i = 0; i < 4; ++i)
    EXPECT_EQ(drawing_text({{{true, {{0, 0}, {0.01, 0}}, Gear::forward, widths[i]}}}),
              "0 0 " + std::to_string(masks[i]) + "\n0.01 0 " + std::to_string(masks[i]) + "\n");
}

}  // namespace
}  // namespace oxturn
