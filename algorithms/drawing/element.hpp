/// What a drawing robot drives in one go: a stroke, or the fill of an area.
///
///   std::vector<DrawingElement> elements = stroke_elements(drawing);
///   for (const Leg& leg : driven(elements[0], {.entry = 0, .backwards = true})) ...
///
/// Source: Vollprecht 2014, section 2.1: polylines, polygons and filled polygons.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "algorithms/smoothing/curve.hpp"
#include "geometry/path.hpp"
#include "geometry/region.hpp"
#include "maps/drawing.hpp"

namespace oxturn {

struct DrawingElement {
  std::string name;       // id of the element in the drawing
  std::vector<Leg> legs;  // driven forwards; each leg begins where the one before it ends
  bool closed = false;    // one leg that ends where it begins: entered at any of `entries`, and left there
  bool one_way = false;   // never driven backwards
  std::shared_ptr<const Ring> area =
      nullptr;  // of a fill: the outer boundary of what it covers; all fills of an area share it
  std::vector<std::size_t> entries = {};  // of a closed one: positions in its points, ascending
  std::vector<std::size_t> nodes = {};    // of a stroke: positions in its points of the source's nodes
  std::vector<std::size_t> corners = {};  // of a stroke: positions in its points at which it is not smooth
  bool thin = false;      // of a fill: the middle of what is narrower than the narrowest pen (thin_lines.hpp)
  bool followed = false;  // the robot can drive each leg as it is (followed_strokes.hpp)

  bool is_fill() const { return area != nullptr; }
  const Point& first() const { return legs.front().points.front(); }
  const Point& last() const { return legs.back().points.back(); }
};

/// How an element is driven.
struct ElementVisit {
  std::size_t element = 0;
  std::size_t entry = 0;  // of a closed one: position in its points
  bool backwards = false;
  friend bool operator==(const ElementVisit&, const ElementVisit&) = default;
};

/// One element for each stroke, in their order. A closed stroke may be entered at the source's nodes and at more of its
/// points, `kMostEntries` in all where there are as many. Throws std::invalid_argument, naming the stroke, for one
/// without length, width or finite points.
std::vector<DrawingElement> stroke_elements(const Drawing& drawing);
inline constexpr std::size_t kMostEntries = 32;

/// The legs in driving order.
std::vector<Leg> driven(const DrawingElement& element, const ElementVisit& visit);
/// Whether leg k of these, which drive an element, only stands for the transit between its neighbours. (Strokes may
/// have the tool off because the drawing says so; their transits are the odd ones.)
bool is_transit(const std::vector<Leg>& legs, std::size_t k);
/// Where the element is entered and left.
Point entry_of(const DrawingElement& element, const ElementVisit& visit);
Point exit_of(const DrawingElement& element, const ElementVisit& visit);
/// The same with the headings there.
Pose entry_pose(const DrawingElement& element, const ElementVisit& visit);
Pose exit_pose(const DrawingElement& element, const ElementVisit& visit);
/// At the ends of a line of at least two points.
Pose first_heading(const Polyline& line);
Pose last_heading(const Polyline& line);

/// Metres driven with the tool on and off.
double length(const DrawingElement& element);

}  // namespace oxturn
