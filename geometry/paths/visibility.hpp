// What a point sees of a region.
#pragma once

#include <memory>

#include "geometry/mesh/mesh.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// Walls block, touching a corner does not. Built once, asked often; safe from several threads.
class Visibility {
 public:
  explicit Visibility(const Region& region);
  ~Visibility();
  Visibility(Visibility&&) noexcept;

  /// The star-shaped polygon that `eye` sees, counter-clockwise; corners are the region's corners and the (rounded)
  /// places where rays past a corner end. From triangle to triangle: O(triangles seen). Exact predicates decide which
  /// corners are seen. Throws std::invalid_argument if `eye` is outside the region by more than `tolerance`.
  Ring from(const Point& eye, double tolerance = 0) const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace oxturn
