#include "algorithms/transit/connector.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace oxturn {

Connector::Connector(const Problem& problem) : problem_(problem), walls_(problem.walls()) {}

bool Connector::straight(const Point& a, const Point& b) const { return walls_.contains(a, b); }

Polyline Connector::path(const Point& a, const Point& b) const {
  if (straight(a, b)) return {a, b};
  auto found = problem_.transit().path(a, b);
  if (!found)
    throw std::runtime_error(fmt::format("no path from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) inside configuration space",
                                         a.x(), a.y(), b.x(), b.y()));
  return std::move(*found);
}

std::optional<Polyline> Connector::path_within(const Point& a, const Point& b, double longest) const {
  if (distance(a, b) > longest) return std::nullopt;
  if (straight(a, b)) return Polyline{a, b};
  return problem_.transit().path(a, b, longest);
}

double Connector::length(const Point& a, const Point& b, double longest) const {
  const auto found = path_within(a, b, longest);
  return found ? oxturn::length(*found) : std::numeric_limits<double>::infinity();
}

}  // namespace oxturn
