#include "algorithms/lanes/uncovered.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/lanes/covered_cells.hpp"
#include "algorithms/lanes/joint_cover.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {
namespace {

constexpr std::array kOff{0.02, 0.005};  // tool widths by which chords may be off their curve, roughly and finely
constexpr std::size_t kMostUnder = 32;   // segments under a chord: choosing it costs their square
constexpr double kWorthwhile = 2;        // times fewer segments

/// Lines as chords: those that are segments of the line itself, and those that are off it by up to `off`.
struct Chords {
  std::vector<Polyline> exact, off;
  std::size_t count = 0;
};

/// Are the points between the two ends within `off` of the straight line from one to the other?
bool under_chord(const Polyline& line, std::size_t from, std::size_t to, double off) {
  for (std::size_t k = from + 1; k < to; ++k)
    if (distance_to_segment(line[k], line[from], line[to]) > off) return false;
  return true;
}

void add_chords(const Polyline& line, double off, Chords& chords) {
  if (line.size() == 1) chords.exact.push_back(line);
  std::vector<Polyline>* last = nullptr;
  for (std::size_t from = 0; from + 1 < line.size();) {
    std::size_t to = from + 1;
    while (to + 1 < line.size() && to < from + kMostUnder && under_chord(line, from, to + 1, off)) ++to;
    std::vector<Polyline>* kind = to == from + 1 ? &chords.exact : &chords.off;
    if (kind != last) kind->push_back({line[from]});
    kind->back().push_back(line[to]);
    last = kind;
    ++chords.count;
    from = to;
  }
}

/// The runs of segments that may reach what is left. None lies in it, because something of each is covered.
std::vector<Polyline> near(const Region& left, const std::vector<Polyline>& lines, double reach) {
  const EdgeIndex edges(left);
  std::vector<Polyline> runs;
  for (const Polyline& line : lines) {
    bool before = false;
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      const bool is_near = edges.nearest(line[k], line[k + 1], reach).has_value();
      if (is_near && !before) runs.push_back({line[k]});
      if (is_near) runs.back().push_back(line[k + 1]);
      before = is_near;
    }
  }
  return runs;
}

/// Segments of lines, found by the boxes about what they cover; a line of one point is a segment, too.
class CoveringSegments {
 public:
  CoveringSegments(const std::vector<Polyline>& lines, double radius, double seam)
      : lines_(lines), radius_(radius), wide_(radius + kSeamShare * seam) {
    std::vector<Box> boxes;
    for (std::size_t l = 0; l < lines.size(); ++l)
      for (std::size_t k = 0; k < std::max<std::size_t>(lines[l].size(), 2) - 1; ++k) {
        segments_.push_back({l, k});
        boxes.push_back({from(segments_.back()).cwiseMin(to(segments_.back())),
                         from(segments_.back()).cwiseMax(to(segments_.back()))});
        boxes.back().grow(radius + 2 * seam);
      }
    near_.assign(segments_.size(), false);
    index_ = BoxIndex(std::move(boxes));
  }

  enum class Cover { none, some, all };
  /// How much of a piece is covered: all of it, if one segment covers it or several certainly do; perhaps some, if
  /// segments are near it, which are noted.
  Cover cover(const Polygon& piece) {
    const std::vector<std::uint32_t> found = index_.overlapping(bounding_box(piece.outer));
    if (std::ranges::any_of(found, [&](std::uint32_t s) { return covers(segments_[s], piece.outer); }))
      return Cover::all;
    if (cover_together(found, piece.outer)) return Cover::all;
    for (const std::uint32_t s : found) near_[s] = true;
    return found.empty() ? Cover::none : Cover::some;
  }

  /// Those noted, consecutive ones as one line.
  std::vector<Polyline> noted() const {
    std::vector<Polyline> runs;
    for (std::size_t s = 0; s < segments_.size(); ++s) {
      if (!near_[s]) continue;
      if (s == 0 || !near_[s - 1] || segments_[s].line != segments_[s - 1].line) runs.push_back({from(segments_[s])});
      if (lines_[segments_[s].line].size() > 1) runs.back().push_back(to(segments_[s]));
    }
    return runs;
  }

 private:
  /// A segment of a line.
  struct Part {
    std::size_t line, first;
  };
  const Point& from(const Part& s) const { return lines_[s.line][s.first]; }
  const Point& to(const Part& s) const {
    const Polyline& line = lines_[s.line];
    return line[std::min(s.first + 1, line.size() - 1)];
  }
  bool covers(const Part& s, const Ring& ring) const {
    return std::ranges::all_of(ring, [&](const Point& p) { return distance_to_segment(p, from(s), to(s)) <= radius_; });
  }
  bool cover_together(const std::vector<std::uint32_t>& found, const Ring& ring) {
    together_.clear();
    for (const std::uint32_t s : found) together_.push_back({from(segments_[s]), to(segments_[s])});
    return cover_inside(together_, wide_, ring);
  }

  const std::vector<Polyline>& lines_;
  double radius_, wide_;
  std::vector<Part> segments_;
  std::vector<Segment> together_;  // of the piece that is looked at
  std::vector<bool> near_;
  BoxIndex index_;
};

/// What lines leave uncovered that all work with a tool of width w.
Region left_by(std::vector<Polyline> lines, double w, double seam, Region left) {
  const auto swept = [&](const std::vector<Polyline>& parts, double off) {
    return swath_parts_with_blunt_ends(parts, w / 2 - off, seam, Bound::outside);
  };
  bool rough = false;
  for (const double share : kOff) {
    const double off = share * w;
    Chords chords;
    std::size_t segments = 0;
    for (const Polyline& line : lines) {
      add_chords(line, off, chords);
      segments += line.size();
    }
    if (static_cast<double>(segments) < kWorthwhile * static_cast<double>(chords.count)) break;
    std::vector<Region> parts = swept(chords.off, off);
    std::ranges::move(swept(chords.exact, 0), std::back_inserter(parts));
    left = subtract(left, parts);
    if (left.empty()) return left;
    lines = near(left, lines, w / 2 + 2 * seam);
    rough = true;
  }
  return rough ? left_of_pieces(left, lines, w / 2, seam)
               : subtract(left, swath_parts(lines, w / 2, seam, Bound::outside));
}

}  // namespace

Region left_of_pieces(const Region& pieces, const std::vector<Polyline>& lines, double radius, double seam) {
  CoveringSegments segments(lines, radius, seam);
  Region untouched, touched;
  for (const Polygon& piece : pieces.polygons) {
    const auto cover = segments.cover(piece);
    if (cover == CoveringSegments::Cover::none) untouched.polygons.push_back(piece);
    if (cover == CoveringSegments::Cover::some) touched.polygons.push_back(piece);
  }
  Region left = subtract(touched, swath_parts(segments.noted(), radius, seam, Bound::outside));
  std::ranges::move(untouched.polygons, std::back_inserter(left.polygons));
  return left;
}

Region uncovered(const Region& target, const Path& path, const Robot& robot) {
  std::map<double, std::vector<Polyline>> lines;  // by width
  for (const Leg& leg : path.legs)
    if (leg.tool) lines[leg.width > 0 ? leg.width : robot.tool_width].push_back(leg.points);
  std::vector<WideLines> groups;
  for (auto& [width, of_width] : lines)
    groups.push_back({std::move(of_width), width / 2, covered_seam(robot) * width / robot.tool_width});
  std::optional<OpenCells> open = in_open_cells(target, groups);
  Region left = open ? std::move(open->region) : target;
  for (std::size_t g = 0; g < groups.size() && !left.empty(); ++g)
    left = left_by(std::move(open ? open->near[g] : groups[g].lines), 2 * groups[g].radius, groups[g].seam,
                   std::move(left));
  return left;
}

}  // namespace oxturn
