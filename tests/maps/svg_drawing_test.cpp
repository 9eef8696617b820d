// Drawings from SVG: syntax, cascade, units, mapping to strokes and areas, limits, and rsvg-convert as the oracle.
#include "maps/svg_drawing.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstdlib>

#include "base/files.hpp"
#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "maps/formats/readers.hpp"
#include "tests/support/files.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr DrawingOptions kPlain{.canvas_width = 20, .canvas_height = 20, .margin = 0, .width_1 = 0.01};

std::string svg(const std::string& body, const std::string& attributes = "") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " + attributes +
         ">\n" + body + "\n</svg>\n";
}
SvgDrawing read(const std::string& body, const DrawingOptions& options = kPlain) {
  return drawing_from_svg(svg(body), "a.svg", options);
}
/// A frame without a stroke's width, so that one pixel is a centimetre: 2000 pixels on 20 m.
const std::string kFrame = "<path d=\"M-500-500V1500H1500V-500\" fill=\"none\" stroke=\"red\"/>\n";
Drawing framed(const std::string& body, DrawingOptions options = kPlain) {
  return read(kFrame + body, options).drawing;
}
std::string why(const std::string& text) {
  return complaint([&] { drawing_from_svg(text, "a.svg", kPlain); });
}
double total_area(const Drawing& d) {
  double sum = 0;
  for (const FilledArea& a : d.areas) sum += area(a.area);
  return sum;
}
/// The points of the stroke after the frame's, in pixels of the framed drawing (y down).
Polyline pixels(const Drawing& d, std::size_t stroke = 1) {
  Polyline out;
  for (const Point& p : d.strokes.at(stroke).points) out.emplace_back(p.x() * 100 - 500, 1500 - p.y() * 100);
  return out;
}
void expect_points(const Polyline& found, const Polyline& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_LT(distance(found[i], expected[i]), 1e-6) << to_text(found[i]);
}

TEST(SvgDrawing, LinesOfAllKinds) {
  const std::string style = " fill=\"none\" stroke=\"black\"/>";
  const Polyline expected{{100, 100}, {300, 100}, {300, 400}, {200, 350}};
  for (const std::string d :
       {"M100 100 L300 100 L300 400 L200 350", "m100,100 200 0 0 300 -100-50", "M100 100H300V400L200 350",
        "m100 100h2e2v+300l-1E2-50.", "M100,100L300,100,300,400,200,350", "M 100.0.1e3 h200 v300 l-100 -50"}) {
    SCOPED_TRACE(d);
    expect_points(pixels(framed("<path d=\"" + d + "\"" + style)), expected);
  }
  expect_points(pixels(framed("<polyline points=\"100 100,300 100 300,400 200-350\"" + style)),
                {{100, 100}, {300, 100}, {300, 400}, {200, -350}});
  expect_points(pixels(framed("<line x1=\"1in\" y1=\"0\" x2=\"50%\" y2=\"72pt\"" + style)), {{96, 0}, {150, 96}});
}

TEST(SvgDrawing, ClosedPathsEndWhereTheyBegan) {
  const Drawing d = framed("<path d=\"M10 10h80v80zm100 0h10v10Z\" fill=\"none\" stroke=\"#000\" id=\"p\"/>");
  ASSERT_EQ(d.strokes.size(), 3u);
  EXPECT_EQ(d.strokes[1].points.front(), d.strokes[1].points.back());
  EXPECT_THAT(d.strokes[1].nodes, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(d.strokes[1].corners, ElementsAre(0, 1, 2));
  EXPECT_EQ(d.strokes[1].element, "p#0");
  EXPECT_EQ(d.strokes[2].element, "p#1");
  expect_points({pixels(d, 2).front()}, {{110, 10}});  // relative to where the first began
}

TEST(SvgDrawing, CurvesAreWithinAThousandthOfTheNarrowestPen) {
  const double t = 1e-3 * kPlain.width_1;
  for (const std::string shape :
       {"<circle cx=\"500\" cy=\"500\" r=\"300\"", "<ellipse cx=\"500\" cy=\"500\" rx=\"300\" ry=\"300\"",
        "<rect x=\"200\" y=\"200\" width=\"600\" height=\"600\" rx=\"300\"",
        "<path d=\"M200 500A300 300 0 1 1 800 500A300 300 0 01200 500\""}) {
    const Drawing d = framed(shape + " stroke=\"#000\" fill=\"none\"/>");
    const Polyline& line = d.strokes.at(1).points;
    for (std::size_t i = 1; i < line.size(); ++i) {
      EXPECT_NEAR(distance(line[i], {10, 10}), 3, 1e-9);
      EXPECT_GE(distance(lerp(line[i - 1], line[i], 0.5), {10, 10}), 3 - t);
    }
    EXPECT_THAT(d.strokes[1].corners, IsEmpty());
    EXPECT_NEAR(length(line), 6 * kPi, 1e-4);
  }
}

TEST(SvgDrawing, ArcsAreScaledUpAndFlagsChooseOneOfFour) {
  const auto middle = [&](const std::string& flags) {
    const Polyline line =
        pixels(framed("<path stroke=\"#000\" fill=\"none\" d=\"M400 500A200 200 0 " + flags + " 600 500\"/>"));
    return line[line.size() / 2].y();
  };
  const double centre = std::sqrt(200 * 200 - 100 * 100);
  EXPECT_NEAR(middle("0 0"), 500 + (200 - centre), 0.1);
  EXPECT_NEAR(middle("0 1"), 500 - (200 - centre), 0.1);
  EXPECT_NEAR(middle("1,0"), 500 + 200 + centre, 0.1);
  EXPECT_NEAR(middle("11"), 500 - 200 - centre, 0.1);
  // Radii too small for the chord give a half circle.
  const Polyline half = pixels(framed("<path stroke=\"#000\" fill=\"none\" d=\"M400 500A1 1 0 0 1 600 500\"/>"));
  for (const Point& p : half) EXPECT_NEAR(distance(p, {500, 500}), 100, 1e-6);
  expect_points(pixels(framed("<path stroke=\"#000\" fill=\"none\" d=\"M4 5A0 9 0 0 1 6 5\"/>")), {{4, 5}, {6, 5}});
}

TEST(SvgDrawing, CascadeDecidesWhatIsDrawn) {
  const auto width_of = [&](const std::string& css, const std::string& element) {
    const Drawing d = framed("<style>" + css + "</style><g stroke=\"black\" fill=\"none\">" + element + "</g>");
    return d.strokes.size() < 2 ? 0 : d.strokes[1].width;
  };
  const auto path = [](const std::string& attributes) { return "<path d=\"M1 1H9\" " + attributes + "/>"; };
  EXPECT_EQ(width_of("", path("")), kPlain.width_1);
  EXPECT_EQ(width_of("", path("stroke-width=\"3\"")), kPlain.width_3);
  EXPECT_EQ(width_of("path{stroke-width:5}", path("stroke-width=\"3\"")), kPlain.width_5);
  EXPECT_EQ(width_of(".a{stroke-width:8px} path{stroke-width:5}", path("class=\"b a\"")), kPlain.width_7);
  EXPECT_EQ(width_of("/* } */#i{stroke-width:3}.a{stroke-width:8}", path("class=\"a\" id=\"i\"")), kPlain.width_3);
  EXPECT_EQ(width_of("#i{stroke-width:3}", path("id=\"i\" style=\"stroke-width:7\"")), kPlain.width_7);
  EXPECT_EQ(width_of("*{stroke-width:3 !important}", path("style=\"stroke-width:7\"")), kPlain.width_3);
  EXPECT_EQ(width_of("g > .a{stroke-width:5} svg .a, .b{stroke-width:3}", path("class=\"a\"")), kPlain.width_3);
  EXPECT_EQ(width_of("svg > .a, a{stroke-width:5}", path("class=\"a\"")), kPlain.width_1);
  EXPECT_EQ(width_of(".a{stroke:none}", path("class=\"a\"")), 0);
  EXPECT_EQ(width_of("", path("stroke=\"#FFFFFF\"")), 0);
  EXPECT_EQ(width_of("", path("stroke=\"rgb(100%,100%,100%)\"")), 0);
  EXPECT_EQ(width_of("", path("opacity=\"0\"")), 0);
  EXPECT_EQ(width_of("", path("stroke-opacity=\"0\"")), 0);
  EXPECT_EQ(width_of("", path("display=\"none\"")), 0);
  EXPECT_EQ(width_of("", path("visibility=\"hidden\"")), 0);
  EXPECT_EQ(width_of("", path("stroke=\"currentColor\" color=\"white\"")), 0);
  EXPECT_EQ(width_of("", path("stroke-width=\"bad\"")), kPlain.width_1);
}

TEST(SvgDrawing, TransformsAndViewBoxes) {
  const std::string style = " stroke=\"#000\" fill=\"none\"/>";
  const auto drawn = [&](const std::string& transform) {
    return pixels(framed("<g transform=\"" + transform + "\"><path d=\"M1 2H3\"" + style + "</g>"));
  };
  expect_points(drawn("translate(10) scale(2,3)"), {{12, 6}, {16, 6}});
  expect_points(drawn("matrix(1 2 3 4,5 6)"), {{12, 16}, {14, 20}});
  expect_points(drawn("rotate(90)"), {{-2, 1}, {-2, 3}});
  expect_points(drawn("rotate(90 1 2),skewX(45)"), {{1, 4}, {1, 6}});
  const auto nested = [&](const std::string& attributes) {
    return pixels(framed("<svg x=\"100\" y=\"200\" " + attributes + "><path d=\"M0 0H10\"" + style + "</svg>"));
  };
  expect_points(nested("width=\"40\" height=\"80\" viewBox=\"0 0 10 10\""), {{100, 220}, {140, 220}});
  expect_points(nested("width=\"40\" height=\"80\" viewBox=\"0 0 10 10\" preserveAspectRatio=\"xMinYMax slice\""),
                {{100, 200}, {180, 200}});
  expect_points(nested("width=\"40\" height=\"80\" viewBox=\"5 0 10 10\" preserveAspectRatio=\"none\""),
                {{80, 200}, {120, 200}});
}

TEST(SvgDrawing, WidthsArePixelsAfterTransforms) {
  const std::string line = "<path d=\"M0 0H9\" fill=\"none\" stroke=\"#000\" style=\"stroke-width:0.79375\"/>";
  const std::string text = svg(line, "width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\"");
  DrawingOptions o;
  EXPECT_EQ(drawing_from_svg(text, "a", o).drawing.strokes.at(0).width,
            o.width_3);  // 3 pixels, as Inkscape writes them
  o.literal = true;
  EXPECT_EQ(drawing_from_svg(text, "a", o).drawing.strokes.at(0).width, o.width_1);
}

TEST(SvgDrawing, UseAndSymbolsAreInstances) {
  const SvgDrawing r = read(kFrame + R"(<defs><path id="p" d="M0 0H10" fill="none"/>
    <symbol id="s" viewBox="0 0 10 10"><use href="#p"/></symbol><g id="loop"><use href="#loop"/></g></defs>
    <use id="one" xlink:href="#p" x="100" y="50" stroke="black"/>
    <use id="two" href="#s" width="200" height="200" stroke="black"/>
    <use href="#loop"/><use href="#none"/>)");
  ASSERT_EQ(r.drawing.strokes.size(), 3u);
  expect_points(pixels(r.drawing, 1), {{100, 50}, {110, 50}});
  expect_points(pixels(r.drawing, 2), {{0, 0}, {200, 0}});
  EXPECT_EQ(r.drawing.strokes[1].element, "one/p");
  EXPECT_THAT(r.remarks, ElementsAre("a.svg:4: use of '#loop' inside itself is not drawn",
                                     "a.svg:7: use of '#none', which is not in the document, is not drawn"));
}

TEST(SvgDrawing, ColoursMeanPensAndTheStart) {
  const Drawing d =
      framed("<path d=\"M0 0H9\" fill=\"none\" stroke=\"#0F0\"/><path d=\"M0 500H9\" fill=\"none\" stroke=\"blue\"/>");
  ASSERT_EQ(d.strokes.size(), 2u);
  EXPECT_FALSE(d.strokes[0].tool);
  EXPECT_TRUE(d.strokes[1].tool);
  ASSERT_TRUE(d.start);
  EXPECT_LT(distance(*d.start, {5.09, 15}), 1e-9);
}

TEST(SvgDrawing, FillRulesAndOpenPaths) {
  const std::string rings = "<path d=\"M100 100h300v300h-300zm100 100h100v100h-100z\" ";
  EXPECT_NEAR(total_area(framed(rings + "/>")), 9, 1e-6);
  EXPECT_NEAR(total_area(framed(rings + "fill-rule=\"evenodd\"/>")), 8, 1e-6);
  const std::string star = "<path d=\"M0 0L400 400V0L0 400Z\" ";
  EXPECT_NEAR(total_area(framed(star + "/>")), 8, 1e-6);
  const std::string open = "<path d=\"M0 0H400V400\"/>";
  EXPECT_NEAR(total_area(framed(open)), 8, 1e-6);
  DrawingOptions literal = kPlain;
  literal.literal = true;
  EXPECT_THAT(framed(open, literal).areas, IsEmpty());
}

TEST(SvgDrawing, OverlappingFillsAreOneAndWhiteErases) {
  const std::string a = "<rect id=\"a\" width=\"200\" height=\"200\"/>",
                    b = "<rect id=\"b\" x=\"100\" width=\"200\" height=\"200\"/>";
  const Drawing united = framed(a + b);
  ASSERT_EQ(united.areas.size(), 1u);
  EXPECT_EQ(united.areas[0].element, "a");
  EXPECT_NEAR(total_area(united), 6, 1e-6);
  EXPECT_EQ(framed(a + "<rect id=\"b\" x=\"200\" width=\"200\" height=\"200\"/>").areas.size(), 2u);  // contact
  const std::string white = "<rect x=\"50\" y=\"-10\" width=\"50\" height=\"400\" fill=\"white\"/>";
  const Drawing cut = framed(a + white + "<path d=\"M60 100H70\" stroke=\"#000\"/>");
  EXPECT_EQ(cut.areas.size(), 2u);
  EXPECT_NEAR(total_area(cut), 3, 1e-6);
  EXPECT_NEAR(length(cut.strokes.back().points), 0.1, 1e-9);
  const Drawing line = framed("<circle id=\"c\" cx=\"75\" cy=\"100\" r=\"70\" fill=\"none\" stroke=\"#000\"/>" + white);
  ASSERT_EQ(line.strokes.size(), 3u);
  EXPECT_THAT((std::vector{line.strokes[1].element, line.strokes[2].element}), ElementsAre("c#0", "c#1"));
}

TEST(SvgDrawing, FitsTheCanvasWithPensAndMargin) {
  const Drawing d =
      read("<path d=\"M-7 3H13\" stroke=\"#000\" stroke-width=\"7\"/><path d=\"M0 1V2\" stroke=\"#000\"/>",
           {.canvas_width = 6, .canvas_height = 4, .margin = 0.5})
          .drawing;
  Box box;
  for (const DrawnStroke& s : d.strokes) {
    Box own = bounding_box(s.points);
    own.grow(s.width / 2);
    box.add(own);
  }
  EXPECT_NEAR(box.low.x(), 0.5, 1e-9);
  EXPECT_NEAR(box.high.x(), 5.5, 1e-9);
  EXPECT_NEAR(box.centre().y(), 2, 1e-9);
  EXPECT_GT(d.strokes[1].points[0].y(), d.strokes[0].points[0].y());  // y is up
}

TEST(SvgDrawing, UnsupportedIsARemarkWithItsLine) {
  const SvgDrawing r = read(kFrame +
                            "<text>a</text>\n<image href=\"x\"/>\n<path d=\"M0 0H9X\" stroke-dasharray=\"1 2\"/>\n"
                            "<rect width=\"-1\" height=\"2\"/>\n<rect clip-path=\"url(#a)\" width=\"9\" height=\"9\" "
                            "fill=\"url(#g)\"/>\n<style>a:hover {fill:red} @media print {a{b:c}}</style><blob/>");
  const std::vector<std::string> expected{
      "a.svg:8: the selector 'a:hover' of a style sheet is not supported and ignored",
      "a.svg:8: the rule '@media print ' of a style sheet is not supported and ignored",
      "a.svg:3: text is not supported and not drawn: turn it into paths first",
      "a.svg:4: image is not supported and not drawn",
      "a.svg:5: stroke-dasharray is not supported: it is drawn without",
      "a.svg:5: path: its path data has an error after command 2: it is drawn up to there",
      "a.svg:6: rect: its width or height is negative",
      "a.svg:7: clip-path is not supported: it is drawn without",
      "a.svg:7: fill 'url(#g)' is not supported: it is drawn plainly",
      "a.svg:8: unknown element 'blob' is not drawn"};
  EXPECT_EQ(r.remarks, expected);
}

TEST(SvgDrawing, StylesThatMoveOrShapeElementsAreRemarks) {
  const SvgDrawing r = read(kFrame +
                            "<style>circle {r: 5px; fill: red}</style><circle cx=\"9\"/>\n"
                            "<rect style=\"width: 9px; transform: rotate(3deg)\" width=\"5\" height=\"5\"/>\n"
                            "<path d=\"M0 0H9V9\" style=\"&st0;\"/>\n"
                            "<g style=\"width: 9px; transform: none\"/>");
  const std::vector<std::string> expected{"a.svg:3: r in a style is not supported: it is drawn without",
                                          "a.svg:4: width in a style is not supported: it is drawn without",
                                          "a.svg:4: transform in a style is not supported: it is drawn without",
                                          "a.svg:5: '&st0' in a style is not understood and ignored"};
  EXPECT_EQ(r.remarks, expected);
}

TEST(SvgDrawing, PrefixesMeanTheNamespaceTheyAreBoundTo) {
  const SvgDrawing r = drawing_from_svg(
      "<p:svg xmlns:p=\"http://www.w3.org/2000/svg\" xmlns:i=\"http://example.org/\"><p:g><p:rect width=\"3\" "
      "height=\"2\"/><i:rect width=\"9\" height=\"9\"/></p:g></p:svg>",
      "a.svg", {});
  EXPECT_EQ(r.drawing.areas.size(), 1u);
  EXPECT_TRUE(r.remarks.empty());
}

std::string repeated(const std::string& text, int n) {
  std::string out;
  for (int i = 0; i < n; ++i) out += text;
  return out;
}

TEST(SvgDrawing, HostileInputIsOneSentence) {
  EXPECT_THAT(why(""), HasSubstr("a.svg"));
  EXPECT_THAT(why("<svg>\n<g>\n<path d=\"M0"), HasSubstr("a.svg:3: not XML"));
  EXPECT_THAT(why("<html/>"), HasSubstr("the root element is 'html', expected 'svg'"));
  EXPECT_THAT(why(svg("<path d=\"M0 0L1e300 5\" stroke=\"#000\"/>")), HasSubstr("a.svg:2: path has coordinates above"));
  EXPECT_THAT(why(svg("<path d=\"M0 0L9 9\" stroke=\"#000\" transform=\"scale(1e200) scale(1e200)\"/>")),
              HasSubstr("a.svg:2: path has coordinates above"));
  EXPECT_THAT(why(svg("<text/>")), testing::AllOf(HasSubstr("a.svg:2: "), HasSubstr("nothing to draw")));
  EXPECT_THAT(why(svg("\n<path d=\"M5 5z\" stroke=\"#000\" fill=\"none\"/>")),
              HasSubstr("a.svg:1: nothing to draw: no element has an outline"));
  EXPECT_THAT(why(svg("\n\n")), HasSubstr("a.svg:1: nothing to draw: no element has an outline"));
  EXPECT_THAT(why(repeated("<g>", 3000) + repeated("</g>", 3000)), HasSubstr("nested deeper than 256"));
  EXPECT_THAT(why(svg(repeated("<g/>", 1'000'001))), HasSubstr("more than 1000000 nodes"));
  EXPECT_THAT(why(svg("<path d=\"M0 0" + repeated("h1", 1'000'001) + "\"/>")), HasSubstr("path commands"));
  std::string bomb = "<defs><path id=\"u0\" d=\"M0 0H1\"/>";
  for (int i = 1; i < 20; ++i)
    bomb += fmt::format("<g id=\"u{}\">{}</g>", i, repeated(fmt::format("<use href=\"#u{}\"/>", i - 1), 10));
  EXPECT_THAT(why(svg(bomb + "</defs><use href=\"#u19\"/>")), HasSubstr("more than 100000 instances"));
  EXPECT_THAT(why("<!DOCTYPE svg [<!ENTITY a \"&a;&a;\"><!ENTITY b \"&a;&a;\">]>" + svg("<path d=\"&b;\"/>")),
              HasSubstr("nothing to draw"));
  Rng rng(1);
  std::string tangle = "M0 0";
  for (int i = 0; i < 100000; ++i) tangle += fmt::format("L{} {}", rng.below(1000), rng.below(1000));
  EXPECT_THAT(why(svg("<path d=\"" + tangle + "\"/>")), HasSubstr("too tangled"));
}

const std::string kSeedDrawing = svg(R"xml(<style>.a{fill:none;stroke:#000;stroke-width:3}</style>
<g transform="rotate(10) scale(2)" class="a"><path id="p"
d="M0 0C10 20 30-5 40 9S5 5 8-9Q1 2 3 4T9 9A5 3 20 1 0 30 30z"/>
<rect x="5" y="5" width="30" height="20" rx="4" fill="#123456"/><circle cx="20" cy="40" r="9" fill="white"/></g>
<use xlink:href="#p" x="50" fill="none" stroke="black"/>
<polygon points="0,0 90,10 40,80"/><ellipse rx="3" ry="9" stroke="red"/>)xml",
                                     "viewBox=\"0 0 200 100\"");

// Thousands of damaged files: each is read or refused with one sentence.
TEST(SvgDrawing, MutatedFilesAreReadOrRefused) {
  const std::string pieces[] = {"-", "1e309", "\"", "<", ">", "&", "nan", "#", "z", "A", "999999999", "%", "/>", "use"};
  Rng rng(7);
  int good = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = kSeedDrawing;
    for (std::uint64_t k = 1 + rng.below(4); k > 0; --k) {
      const std::size_t at = rng.below(text.size());
      switch (rng.below(4)) {
        case 0:
          text[at] = static_cast<char>(rng.below(256));
          break;
        case 1:
          text.erase(at, rng.below(30));
          break;
        case 2:
          text.insert(at, pieces[rng.below(std::size(pieces))]);
          break;
        default:
          text.insert(at, text.substr(rng.below(text.size()), rng.below(40)));
      }
    }
    try {
      const SvgDrawing d = drawing_from_svg(text, "a.svg", kPlain);
      for (const DrawnStroke& s : d.drawing.strokes)
        for (const Point& p : s.points) ASSERT_TRUE(finite(p)) << text;
      ++good;
    } catch (const std::invalid_argument& e) {
      EXPECT_THAT(std::string(e.what()), testing::AllOf(HasSubstr("a.svg"), testing::Not(HasSubstr("\n")))) << text;
    }
  }
  EXPECT_GT(good, 400);
}

// ---- the oracle: rsvg-convert ----

bool has_rsvg() { return std::system("command -v rsvg-convert > /dev/null 2>&1") == 0; }

/// A picture of all commands and shapes, 300 x 300 pixels, whose parts are the more varied the larger the seed.
std::string varied_drawing(std::uint64_t seed) {
  Rng rng(seed);
  const auto n = [&] { return static_cast<int>(rng.below(80)) + 110; };
  const auto d = [&] { return static_cast<int>(rng.below(50)) - 25; };
  std::string body =
      "<rect x=\"2\" y=\"2\" width=\"296\" height=\"296\" fill=\"none\" stroke=\"black\" stroke-width=\"4\"/>";
  for (int i = 0; i < 3; ++i) {
    body += fmt::format(
        "<path fill-rule=\"{}\" d=\"M{} {}c{} {} {} {} {} {}s{} {} {} {}q{} {} {} {}t{} {}A{} {} {} {} {} {} {}L{} "
        "{}h{}v{}z\"/>",
        rng.chance(0.5) ? "evenodd" : "nonzero", n(), n(), d(), d(), d(), d(), d(), d(), d(), d(), d(), d(), d(), d(),
        d(), d(), d(), d(), n() / 5, n() / 4, n(), rng.below(2), rng.below(2), n(), n(), n(), n(), d(), d());
    body += fmt::format(
        "<g transform=\"rotate({} 150 150) skewX({}) translate({} {})\"><rect x=\"{}\" y=\"{}\" width=\"50\" "
        "height=\"30\" "
        "rx=\"{}\" fill=\"{}\"/><ellipse cx=\"{}\" cy=\"{}\" rx=\"33\" ry=\"17\" fill=\"{}\"/></g>",
        d(), d() / 3, d() / 4, d() / 4, n() / 2, n(), rng.below(20), i == 1 ? "white" : "black", n(), n(),
        i == 2 ? "white" : "black");
  }
  return svg(body, "width=\"300\" height=\"300\" viewBox=\"0 0 300 300\"");
}

TEST(SvgDrawing, RasterAgreesWithRsvgConvert) {
  if (!has_rsvg()) GTEST_SKIP() << "rsvg-convert is missing: install librsvg2-bin";
  // 300 pixels on 6 m; the frame's stroke is 4 pixels wide, so it reaches the canvas's boundary.
  constexpr double kScale = 0.02;
  for (const std::uint64_t seed : seeds(6)) {
    SCOPED_TRACE(seed);
    const TemporaryFolder folder;
    const std::string text = varied_drawing(seed);
    write_file(folder.file("a.svg"), text);
    ASSERT_EQ(std::system(("rsvg-convert -b white " + folder.file("a.svg") + " -o " + folder.file("a.png")).c_str()),
              0);
    const GreyImage image = read_image(folder.file("a.png"));
    ASSERT_EQ(image.width, 300);
    const DrawingOptions options{6, 6, 0, 0.04, 0.16, 4 * kScale, 0.42, false};
    const Drawing d = drawing_from_svg(text, "a.svg", options).drawing;
    std::vector<Region> parts;
    for (const FilledArea& a : d.areas) parts.push_back({{a.area}});
    for (const DrawnStroke& s : d.strokes) parts.push_back(swath({s.points}, s.width / 2, 1e-3, Bound::inside));
    const EdgeIndex drawn(unite(parts));
    int both = 0, either = 0;
    for (int row = 0; row < 300; ++row)
      for (int column = 0; column < 300; ++column) {
        const bool theirs = image.grey[image.index(column, row)] < 128;
        const bool ours = drawn.contains({(column + 0.5) * kScale, (300 - row - 0.5) * kScale});
        both += theirs && ours;
        either += theirs || ours;
      }
    EXPECT_GE(both, 0.99 * either) << both << " of " << either;
    EXPECT_GT(both, 5000);
  }
}

}  // namespace
}  // namespace oxturn
