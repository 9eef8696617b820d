// Polygons as CGAL writes them: a ring a line, the number of its vertices and their coordinates. The first ring is the
// boundary, the others are holes. Instances of the lawn mowing problem are published in this form.
//
// Decisions   1. A line with nothing but a number, after the first ring, is the number of holes that follow: CGAL
//                writes it, others do not.
//             2. With `around`, the polygon is the target area, and free space a rectangle around it: the tool may
//                leave what it mows. Without it the polygon is free space.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <vector>

#include "base/files.hpp"
#include "base/text.hpp"
#include "maps/formats/readers.hpp"

namespace oxturn {
namespace {

struct PolygonOptions {
  double around = 0;
};

constexpr std::size_t kLeastVertices = 3;
constexpr std::size_t kMostShown = 40;  // bytes of a word in messages

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(kBlank); at != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = line.find_first_not_of(kBlank, end);
  }
  return words;
}

class PolygonReader {
 public:
  explicit PolygonReader(const std::string& file) : file_(file) {}

  Region read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      ++line_;
      if (const auto words = words_of(text.substr(0, end)); !words.empty()) take(words);
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    if (rings_.empty()) throw_invalid("{}: no ring, expected a line with the number of vertices and their x y", file_);
    if (holes_ && *holes_ != rings_.size() - 1)
      throw_invalid("{}: {} holes, expected {} as the file says", file_, rings_.size() - 1, *holes_);
    Polygon polygon{std::move(rings_.front()), {}};
    for (std::size_t i = 1; i < rings_.size(); ++i) polygon.holes.push_back(std::move(rings_[i]));
    return {{std::move(polygon)}};
  }

 private:
  void take(const std::vector<std::string_view>& words) {
    const std::size_t n = count(words.front());
    if (words.size() == 1 && rings_.size() == 1 && !holes_) {
      holes_ = n;
      return;
    }
    const std::size_t numbers = words.size() - 1;
    if (numbers % 2 != 0 || numbers / 2 != n)
      throw_invalid("{}:{}: {} numbers after the number of vertices, expected x and y of {} vertices", file_, line_,
                    numbers, n);
    Ring ring;
    for (std::size_t i = 0; i < n; ++i) ring.emplace_back(number(words[1 + 2 * i]), number(words[2 + 2 * i]));
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    if (ring.size() < kLeastVertices)
      throw_invalid("{}:{}: {} different vertices, expected at least {}", file_, line_, ring.size(), kLeastVertices);
    rings_.push_back(std::move(ring));
  }

  std::size_t count(std::string_view word) const {
    const auto value = parse_all<std::size_t>(word);
    if (!value) refuse(word, "the number of vertices of a ring");
    return *value;
  }
  double number(std::string_view word) const {
    const auto value = parse_number(word);
    if (!value || !std::isfinite(*value)) refuse(word, "a coordinate in metres");
    return *value;
  }
  [[noreturn]] void refuse(std::string_view word, const char* expected) const {
    throw_invalid("{}:{}: '{}', expected {}", file_, line_, word.substr(0, kMostShown), expected);
  }

  const std::string& file_;
  std::size_t line_ = 0;
  std::vector<Ring> rings_;
  std::optional<std::size_t> holes_;
};

MapFile read_polygon(const std::string& file, const PolygonOptions& options) {
  MapFile result;
  result.map = {stem_of(file), {}, "file", file};
  Region region = repaired_region(PolygonReader(file).read(read_file(file)), file, result.remarks);
  if (options.around <= 0) {
    result.map.free = std::move(region);
    return result;
  }
  const Box box = bounding_box(region);
  const Point margin(options.around, options.around);
  result.map.free = box_region(box.low - margin, box.high + margin);
  result.map.target_area = std::move(region);
  return result;
}

}  // namespace

MapFormat polygon_format() {
  return describe_format<PolygonOptions>("polygon", "polygons as CGAL writes them: a ring a line", {".poly"},
                                         {{"around", &PolygonOptions::around, Range{0, 1e6},
                                           "metres: the polygon is the target area, in a rectangle that is larger by "
                                           "this on all sides; 0: it is free space"}},
                                         read_polygon);
}

}  // namespace oxturn
