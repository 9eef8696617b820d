/// Simple links (car_space.hpp) that were looked for lately, so that none is searched twice.
///
///   KnownLinks links(space, strokes.size());
///   links.find(from, to, 12.5);                  // the same as space.simple_link(from, to, 12.5)
///
/// A fixed number of slots, so memory is O(strokes), and what is forgotten is searched again: the results are the same.
/// Where strokes are inserted one after the other, it saves up to a fifth of all planning time.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/smoothing/car_space.hpp"

namespace oxturn {

class KnownLinks {
 public:
  /// `space` must outlive it. `strokes`: how many links there may be, roughly.
  KnownLinks(const CarSpace& space, std::size_t strokes);
  const CarSpace& space() const { return space_; }
  std::optional<Curve> find(const Pose& from, const Pose& to, double most);

 private:
  struct Slot {
    Pose from, to;
    double most = 0;  // none is free that costs less; not a number: the slot is empty
    std::optional<Curve> link;
  };
  Slot& slot(const Pose& from, const Pose& to);

  const CarSpace& space_;
  std::vector<Slot> slots_;
};

}  // namespace oxturn
