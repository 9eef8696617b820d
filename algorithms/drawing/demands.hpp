/// What a drawing and its containment demand of the tour over its elements.
///
///   TourDemands demands = demands_of(drawing, elements);
///   demands.contained = contained_elements(elements, ContainmentTest::overlay);
///
/// Source: Vollprecht 2014, section 2.3.2: enforced connections and containment.
#pragma once

#include <utility>
#include <vector>

#include "algorithms/drawing/element.hpp"
#include "algorithms/tour/tour_shapes.hpp"

namespace oxturn {

/// Where an element may be entered or left: of a closed one a position in its points; of others 0, the first point of
/// all, or 1, the last.
struct ElementPort {
  std::size_t element = 0, at = 0;
  friend auto operator<=>(const ElementPort&, const ElementPort&) = default;
};
/// The port of a visit.
ElementPort entry_port(const DrawingElement& element, const ElementVisit& visit);
ElementPort exit_port(const DrawingElement& element, const ElementVisit& visit);

struct TourDemands {
  std::vector<std::pair<ElementPort, ElementPort>> joined, deleted;  // connections
  std::vector<std::pair<ElementPort, ElementPort>> by_hand = {};     // of the drawing's curves, in their order
  std::vector<std::pair<std::size_t, std::size_t>> contained = {};   // (outer, inner)
  Containment containment = Containment::strict;
};

/// The node's port. Nodes of an element with several strokes are counted through all of them. A node of an area without
/// a stroke of that name stands for the nearer end of its fill. Adds the node to the entries of a closed stroke. Throws
/// std::invalid_argument for an element that does not exist, and a node that does not or is no end of its stroke.
ElementPort port_of(std::vector<DrawingElement>& elements, const NodeOfElement& node);

/// The connections that a person demands, those with a curve among them, and forbids: of an area without a stroke none
/// of its fills is connected with the other element directly. Where two are demanded at an area, the second takes the
/// end of the fill that the first leaves. Throws as port_of().
TourDemands demands_of(const Drawing& drawing, std::vector<DrawingElement>& elements);

}  // namespace oxturn
