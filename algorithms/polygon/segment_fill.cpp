#include "algorithms/polygon/segment_fill.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "algorithms/context.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/convex_hull.hpp"

namespace oxturn {
namespace {

/// The words of a text, which blanks or commas separate.
std::vector<std::string_view> words_of(std::string_view text) {
  constexpr std::string_view kBetween = " \t\n,";
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t begin = text.find_first_not_of(kBetween);
    if (begin == std::string_view::npos) return words;
    const std::size_t end = std::min(text.find_first_of(kBetween, begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    text.remove_prefix(end);
  }
}

SegmentChoice read_choice(const std::string& owner, std::string_view entry) {
  const std::vector<std::string_view> words = words_of(entry);
  if (words.size() == 3) {
    const auto x = parse_number(words[0]), y = parse_number(words[1]), degrees = parse_number(words[2]);
    if (x && y && words[2] == "spiral") return {{*x, *y}, {SegmentFill::Kind::spiral, 0}};
    if (x && y && degrees && std::abs(*degrees) <= 360) return {{*x, *y}, {SegmentFill::Kind::lanes, *degrees}};
  }
  throw_invalid("segment '{}' of {}: expected 'x y degrees' (-360 to 360) or 'x y spiral'", printable(entry), owner);
}

/// Metres from a point to a part: 0 inside.
double distance_to(const Part& part, const Point& p) {
  double least = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Ring& r : part.rings) {
    for (std::size_t i = 0; i < r.size(); ++i)
      least = std::min(least, distance_to_segment(p, r[i], r[(i + 1) % r.size()]));
    inside = inside != contains(Region{{{r, {}}}}, p);
  }
  return inside ? 0 : least;
}

double own_direction(const Part& part) {
  std::vector<Point> points;
  for (const Ring& r : part.rings) points.insert(points.end(), r.begin(), r.end());
  const Ring hull = convex_hull(std::move(points));
  return hull.size() < 3 ? 0 : std::fmod(std::round(narrowest_direction(hull)), 180.0);
}

}  // namespace

std::vector<SegmentChoice> read_segment_choices(const std::string& owner, const std::string& text) {
  std::vector<SegmentChoice> choices;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view entry = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (!words_of(entry).empty()) choices.push_back(read_choice(owner, entry));
  }
  return choices;
}

std::vector<SegmentFill> segment_fills(const std::string& owner, const std::vector<Part>& parts,
                                       const SegmentOptions& options) {
  std::vector<SegmentFill> fills;
  for (const Part& part : parts)
    fills.push_back({options.fill, options.degrees ? *options.degrees : own_direction(part)});
  for (const SegmentChoice& choice : options.choices) {
    std::vector<double> far;
    for (const Part& part : parts) far.push_back(distance_to(part, choice.at));
    const auto nearest = std::ranges::min_element(far);
    if (nearest == far.end() || *nearest > options.reach)
      throw Infeasible(fmt::format("segments of {}: no part holds {}", owner, to_text(choice.at)));
    fills[static_cast<std::size_t>(nearest - far.begin())] = choice.fill;
  }
  return fills;
}

}  // namespace oxturn
