#include "algorithms/transit/connector.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace oxturn {

Connector::Connector(const Problem& problem) : walls_(problem.walls()), paths_(problem.transit()) {}

bool Connector::straight(const Point& a, const Point& b) const { return walls_.contains(a, b); }

Polyline Connector::path(const Point& a, const Point& b) const {
  if (straight(a, b)) return {a, b};
  auto found = paths_.path(a, b);
  if (!found)
    throw std::runtime_error(fmt::format("no path from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) inside configuration space",
                                         a.x(), a.y(), b.x(), b.y()));
  return std::move(*found);
}

double Connector::length(const Point& a, const Point& b, double longest) const {
  const double direct = distance(a, b);
  if (direct > longest) return std::numeric_limits<double>::infinity();
  if (straight(a, b)) return direct;
  const auto found = paths_.path(a, b, longest);
  return found ? oxturn::length(*found) : std::numeric_limits<double>::infinity();
}

}  // namespace oxturn
