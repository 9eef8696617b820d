/// Boxes, and the rings of a region, found by the box that they overlap.
///
///   const RingBoxes rings(region);
///   const Region near = intersect(rings.near(box), other);      // as with the whole region, inside the box
///
/// Build O(n), memory O(n) for n vertices. A query costs the boxes near it, and the rings that it returns.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

class BoxIndex {
 public:
  BoxIndex() = default;
  explicit BoxIndex(std::vector<Box> boxes);
  /// Ascending.
  std::vector<std::uint32_t> overlapping(const Box& box) const;

 private:
  std::vector<Box> boxes_;
  UniformGrid grid_;
};

class RingBoxes {
 public:
  /// `region` must outlive it.
  explicit RingBoxes(const Region& region);
  /// The region as it is in a box: without polygons and holes that lie elsewhere.
  Region near(const Box& box) const;

 private:
  struct Where {
    std::size_t polygon, hole;  // hole 0: the outer ring, else one more than its index
  };
  const Region& region_;
  std::vector<Where> rings_;  // polygon by polygon
  BoxIndex boxes_;
};

}  // namespace oxturn
