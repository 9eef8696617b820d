/// Which part of a partition is filled how: lanes in a direction of its own, or a spiral.
///
///   const std::vector<SegmentChoice> choices = read_segment_choices("planner 'zigzag'", "3 2 45; 8 1 spiral");
///   const std::vector<SegmentFill> fills = segment_fills("planner 'zigzag'", parts, {.choices = choices});
///
///     +---------+--------.
///     | ------- | .----. |       The part that holds (3, 2) is driven at 45 degrees, the one that holds (8, 1) in a
///     | ------- | | -' | |       spiral; others along the direction across which they are narrowest.
///     +---------+--------'
///
/// Source: BeachBot (Vollprecht 2014), section 2.2.4 and figure 2.7: the user chooses a direction or a spiral for each
/// segment of a partition. O(n log n) for n vertices, and O(n) for each choice.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/polygon/parts.hpp"
#include "base/parameters.hpp"

namespace oxturn {

struct SegmentFill {
  enum class Kind { lanes, spiral };
  Kind kind = Kind::lanes;
  double degrees = 0;  // of lanes
};

/// What a person wants for the part that holds `at`.
struct SegmentChoice {
  Point at{0, 0};
  SegmentFill fill = {};
};

/// "x y degrees" or "x y spiral", separated by semicolons; metres. Throws std::invalid_argument that names `owner` and
/// the entry.
std::vector<SegmentChoice> read_segment_choices(const std::string& owner, const std::string& text);

/// The parameter `segments` with such a text, read when it is set: a mistake is told before anything is planned.
template <class P>
Parameter<P> segments_parameter(const std::string& owner) {
  return {{"segments",
           std::string(),
           {},
           {},
           "directions in degrees and fills of single parts: 'x y degrees; x y spiral' for those at (x, y)"},
          [](const P& p) -> Value { return p.segments; },
          [owner](P& p, const Value& value) {
            p.segments = std::get<std::string>(value);
            read_segment_choices(owner, p.segments);
          }};
}

struct SegmentOptions {
  SegmentFill::Kind fill = SegmentFill::Kind::lanes;  // of parts that nobody chose one for
  std::optional<double> degrees = {};                 // of their lanes; none: along the part
  std::vector<SegmentChoice> choices = {};
  double reach = 0;  // metres: a position outside of all parts means the nearest one, if it is so near
};

/// One for each part. Directions along parts are whole degrees, so that few frames are needed. Throws
/// Infeasible with `owner` and the position if no part is in reach of one.
std::vector<SegmentFill> segment_fills(const std::string& owner, const std::vector<Part>& parts,
                                       const SegmentOptions& options);

}  // namespace oxturn
