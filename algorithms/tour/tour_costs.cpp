#include "algorithms/tour/tour_costs.hpp"

#include <algorithm>

namespace oxturn {

TourCosts::TourCosts(const Point& start, const std::vector<TourElement>& elements, const Connector& connector)
    : elements_(elements), connector_(connector), start_(start) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    first_.push_back(ports_.size());
    for (const Pattern& p : elements[i]) {
      ports_.push_back(p.entry);
      owner_.push_back(i);
    }
  }
}

double TourCosts::exact(std::size_t a, std::size_t b, double longest) const {
  if (a == b) return 0;
  const auto [low, high] = std::minmax(a, b);
  Known& known = known_[static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint64_t>(high)];
  if (known.length < kFar) return known.length <= longest ? known.length : kFar;
  if (longest <= known.none_up_to || longest < bound(a, b)) return kFar;
  ++searches_;
  const double d = searched(low, high, longest);
  if (d < kFar)
    known.length = d;
  else if (longest < kFar)
    known.none_up_to = longest;
  return d;
}

}  // namespace oxturn
