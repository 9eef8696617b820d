/// Boxes, and the rings of a region, found by the box that they overlap.
///
///   const RingBoxes rings(region);
///   const Region near = intersect(rings.near(box), other);      // as with the whole region, inside the box
///
/// Build O(n), memory O(n) for n vertices. A query costs the boxes near it, and the rings that it returns.
#pragma once

#include <cstdint>
#include <span>
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
  /// The region as it is in a box, or in several: without polygons and holes that lie elsewhere.
  Region near(const Box& box) const { return near(std::span(&box, 1)); }
  Region near(std::span<const Box> boxes) const;

 private:
  struct Where {
    std::size_t polygon, hole;  // hole 0: the outer ring, else one more than its index
  };
  const Region& region_;
  std::vector<Where> rings_;  // polygon by polygon
  BoxIndex boxes_;
};

/// The region with outer rings clipped to the box, holes as they are: an operand of overlays whose other one lies
/// inside the box. Not a valid region, because outer rings run along the box where they are beyond it. O(n) for n
/// vertices, without the overlay of intersect().
Region clipped(Region region, const Box& box);

}  // namespace oxturn
