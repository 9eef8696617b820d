/// Filled areas as they are painted one over the other. Private to maps.
///
///   PaintedAreas areas(tolerance);
///   areas.add("leaf", leaf);
///   areas.erase(white);
///   drawing.areas = areas.take();
#pragma once

#include "maps/drawing.hpp"

namespace oxturn {

/// Throws std::length_error if the rings may cross each other so often that an overlay would take too much memory:
/// above 4500 vertices, if their length is more than 6000 times the size of their box (with the box scaled to a square
/// of side 1; random chords of total length L cross about L^2 / pi times).
void require_untangled(const std::vector<Ring>& rings);

class PaintedAreas {
 public:
  /// Overlaps up to `tolerance` wide are contact.
  explicit PaintedAreas(double tolerance) : tolerance_(tolerance) {}
  void add(const std::string& element, const Region& region);
  /// Takes the region away from all areas.
  void erase(const Region& region);
  /// Connected areas, none of which overlaps another, in the order of the first element of each. Overlapping ones are
  /// united under the first one's name. Areas whose boxes overlap are intersected in pairs, unless they are known to be
  /// of one area; throws std::length_error if that is more than some 10 seconds' work.
  std::vector<FilledArea> take();

 private:
  struct Area {
    std::string element;
    Polygon polygon;
    Box box;
    bool fresh = true;  // not yet intersected with the others
  };
  void unite_overlapping();
  bool overlap(const Polygon& a, const Polygon& b);

  double tolerance_;
  std::vector<Area> areas_;
  std::size_t work_ = 0;  // vertices of the pairs that were intersected
};

}  // namespace oxturn
