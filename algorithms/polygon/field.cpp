// Blocks of parallel lanes, always the one that covers most for its time, and laps of headland.
//
// Source      after Oksanen and Visala, "Coverage path planning algorithms for agricultural field machines", Journal of
//             Field Robotics 26(8), 2009, first algorithm
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   covers the whole target (along traced walls but for 0.0005 of it; pieces below 1e-6 of the square of the
//             tool width): laps cover what is less than `headland` tool widths deep, and repair their corners. What is
//             deeper is divided into blocks. A point of a block is at most half a tool width from its foot on a lane,
//             which is therefore in configuration space.
// Complexity  see field_blocks.hpp, and the order of blocks
// Decisions   1. All numbers: headings every 30 degrees, along the edges, and halved steps down to 1 degree about the
//                best one; 20 degrees between ends that run on; no block below least_block. The source knows no such
//                limit (variant = published: 4 squares of the tool width); lanes in many small blocks are up to 20 %
//                longer, with up to half as many turns more, than slabs in one direction.
//             2. The rate of a block is its area over the time for lanes, turns and the straight drive there. The best
//                block has the greatest rate times area: by the rate alone (value = rate, the source) a rectangle falls
//                into a strip along its diagonal and two triangles.
//             3. Blocks found for one heading are used until the component that they lie in has lost three tenths of
//                its area; the source divides again after each block. What is too small for blocks takes slabs in the
//                direction that is cheapest for it.
//             4. order = improved: the blocks in the order of a tour. greedy, as in the source: in the order in which
//                they were chosen.
//             5. No symmetry is declared: time does not scale with the map, because the robot's speed and acceleration
//                do not, and blocks of the same value are told apart by rounding.
#include "algorithms/lanes/headland.hpp"
#include "algorithms/polygon/field_blocks.hpp"
#include "algorithms/polygon/halves.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/raster.hpp"
#include "geometry/ring_boxes.hpp"

namespace oxturn {
namespace {

constexpr double kSimplify = 0.02;           // tool widths by which blocks may keep off the laps, for fewer vertices
constexpr double kChord = 0.02;              // tool widths: chord error of round vertices
constexpr std::size_t kMostVertices = 2000;  // of what is divided at once

enum class BlockOrder { improved, greedy };

struct Params : Headland {
  Params() { headland = 1; }
  BlockOrder order = BlockOrder::improved;
  BlockValue value = BlockValue::area_rate;
  double least_block = BlockRule{}.least;
};

/// Configuration space without most of the walls that are nowhere near a section of the field.
Region space_near(const Problem& problem, const RingBoxes& space, const Region& section) {
  Box box = bounding_box(section);
  box.grow(problem.robot().tool_width);
  Region near = space.near(box);
  if (vertex_count(near) > 2 * kMostVertices) near = intersect(near, box_region(box.low, box.high));
  return near;
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  const RingBoxes space(problem.configuration_space());
  const auto strips_deeper_than = [&](double depth) {
    // Larger by what is simplified away, so that all that is deeper stays.
    const Region field = simplify_inward(lane_region(problem, depth - kSimplify * w, kChord * w), kSimplify * w);
    std::vector<Strip> strips;
    std::vector<Polyline> outlines;
    const auto small = [](const Region& section) { return vertex_count(section) <= kMostVertices; };
    for (const Region& section : halved_until(field, small))
      for (FieldBlock& block :
           field_blocks(problem, space_near(problem, space, section), section, {p.value, p.least_block}, context)) {
        outlines.emplace_back(block.ring.begin(), block.ring.end());
        if (!block.ring.empty()) outlines.back().push_back(block.ring.front());
        for (Strip& strip : block.strips) strips.push_back(std::move(strip));
      }
    context.record("blocks", static_cast<double>(outlines.size()));
    std::erase_if(outlines, [](const Polyline& line) { return line.empty(); });
    context.trace("blocks", std::move(outlines));
    return strips;
  };
  const StripOrder order = p.order == BlockOrder::greedy ? StripOrder::given : StripOrder::improved;
  return drive_with_headland(problem, p, strips_deeper_than, order, context);
}

}  // namespace

PlannerInfo field() {
  return describe<Params, plan>(
      {.name = "field",
       .family = "polygon",
       .title = "blocks of lanes and a headland",
       .citation = "Oksanen, Visala 2009",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (along traced walls but for 0.0005 of it)",
       .promise = Promise::target,
       .parameters = with_headland<Params>(
           {{"order", &Params::order, Choices{"improved", "greedy"},
             "of the blocks; improved: a tour; greedy: as they were chosen, as in the source"},
            {"value", &Params::value, Choices{"area-rate", "rate"},
             "of a block; rate: area a second, as in the source; area-rate: that times the area"},
            {"least_block", &Params::least_block, Range{0, 1e9},
             "area of a block in squares of the tool width; what is smaller takes parallel lanes"}},
           1),
       .published = {{"order", std::string("greedy")}, {"value", std::string("rate")}, {"least_block", 4.0}},
       .promises_with = [](const Params& p) { return p.works_walls(true); }});
}

}  // namespace oxturn
