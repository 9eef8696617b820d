#include "algorithms/drawing/containment.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "geometry/convex_hull.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

constexpr double kSamples = 1000;   // along the inner element
constexpr double kMostOutside = 1;  // of those samples
constexpr double kTouch = 1e-9;     // of the extent: an element on the boundary is inside

/// An element that may contain others.
class Container {
 public:
  Container(const DrawingElement& element, ContainmentTest test) {
    Ring ring = element.is_fill() ? *element.area : element.legs[0].points;
    if (test == ContainmentTest::hull) ring = convex_hull(ring);
    box_ = bounding_box(ring);
    region_ = unite({Region{{Polygon{ring, {}}}}});
    area_ = area(region_);
  }
  double area_m2() const { return area_; }
  const Box& box() const { return box_; }

  bool holds(const DrawingElement& inner, const Box& inner_box, ContainmentTest test) {
    if (region_.empty()) return false;
    if (!index_) index_ = std::make_unique<EdgeIndex>(region_);
    if (test == ContainmentTest::hull)
      return index_->contains(inner.first()) || (!inner.closed && index_->contains(inner.last()));
    // Far from the boundary all of the element is on one side of it.
    if (!index_->nearest(inner_box.centre(), inner_box.size().norm())) return index_->contains(inner_box.centre());
    return samples_outside(inner) <= kMostOutside;
  }

 private:
  double samples_outside(const DrawingElement& inner) const {
    const double step = length(inner) / kSamples, near = kTouch * box_.size().norm();
    double outside = 0, along = step / 2;  // to the next sample
    for (const Leg& leg : inner.legs)
      for (std::size_t k = 1; k < leg.points.size(); ++k) {
        const Point &a = leg.points[k - 1], &b = leg.points[k];
        const double d = distance(a, b);
        for (; along < d; along += step)
          if (const Point p = lerp(a, b, along / d); !index_->contains(p) && !index_->nearest(p, near))
            if (++outside > kMostOutside) return outside;
        along -= d;
      }
    return outside;
  }

  Region region_;
  Box box_;
  double area_ = 0;
  std::unique_ptr<EdgeIndex> index_;  // built when first asked
};

Box box_of(const DrawingElement& element) {
  Box box;
  for (const Leg& leg : element.legs)
    for (const Point& p : leg.points) box.add(p);
  return box;
}

bool holds(const Box& outer, const Box& inner) {
  const double touch = kTouch * outer.size().norm();
  return (inner.low - outer.low).minCoeff() >= -touch && (outer.high - inner.high).minCoeff() >= -touch;
}

/// Fills of one area, by different parts of the tool or in different parts of it.
bool fill_the_same(const DrawingElement& a, const DrawingElement& b) { return a.is_fill() && a.area == b.area; }

double tool_width(const DrawingElement& fill) {
  const auto work = std::ranges::find_if(fill.legs, [](const Leg& leg) { return leg.tool; });
  return work == fill.legs.end() ? 0 : work->width;
}

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> narrower_fills(const std::vector<DrawingElement>& elements) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t first = 0, last; first < elements.size(); first = last) {
    for (last = first + 1; last < elements.size() && fill_the_same(elements[first], elements[last]);) ++last;
    std::vector<Box> boxes, near;
    std::vector<double> widths;
    for (std::size_t e = first; e < last; ++e) {
      boxes.push_back(box_of(elements[e]));
      widths.push_back(tool_width(elements[e]));
      near.push_back(boxes.back());
      near.back().grow(widths.back());
    }
    for (std::size_t narrow = 1; narrow < boxes.size(); ++narrow)
      for (std::size_t wide = 0; wide < narrow; ++wide)
        if (widths[narrow] < widths[wide] && near[wide].overlaps(boxes[narrow]))
          pairs.push_back({first + wide, first + narrow});
  }
  return pairs;
}

std::vector<std::pair<std::size_t, std::size_t>> contained_elements(const std::vector<DrawingElement>& elements,
                                                                    ContainmentTest test) {
  struct Candidate {
    std::size_t element;
    std::shared_ptr<Container> container;  // fills of one area share it
  };
  std::vector<Candidate> outer;
  std::vector<double> areas(elements.size(), 0);
  for (std::size_t e = 0; e < elements.size(); ++e)
    if ((elements[e].closed && elements[e].legs[0].tool) || elements[e].is_fill()) {
      const bool same = !outer.empty() && fill_the_same(elements[outer.back().element], elements[e]);
      outer.push_back({e, same ? outer.back().container : std::make_shared<Container>(elements[e], test)});
      areas[e] = outer.back().container->area_m2();
    }
  std::stable_sort(outer.begin(), outer.end(),
                   [&](const Candidate& a, const Candidate& b) { return areas[a.element] < areas[b.element]; });
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const Box box = box_of(elements[e]);
    for (Candidate& c : outer) {
      const bool larger = areas[c.element] > areas[e] || (areas[c.element] == areas[e] && c.element > e);
      if (c.element == e || !larger || fill_the_same(elements[c.element], elements[e])) continue;
      if (test == ContainmentTest::overlay && !holds(c.container->box(), box)) continue;
      if (!c.container->holds(elements[e], box, test)) continue;
      pairs.push_back({c.element, e});
      break;
    }
  }
  return pairs;
}

}  // namespace oxturn
